// Draws the panels of a page, all those over time on one time axis, and lets them be zoomed, moved and read.
const page = JSON.parse(document.getElementById("data").textContent);
const NS = "http://www.w3.org/2000/svg";
const LEFT = 58, RIGHT = 12, TOP = 6, FOOT = 34, HINT = document.getElementById("says").textContent;
const colour = index => `var(--c${index % 4})`;
const number = value => String(Number(value.toPrecision(6))).replace("-", "\u2212");

function add(parent, name, attributes, text) {
  const element = document.createElementNS(NS, name);
  for (const key in attributes) element.setAttribute(key, attributes[key]);
  if (text !== undefined) element.textContent = text;
  return parent.appendChild(element);
}

// Ticks at 1, 2 or 5 times a power of ten, at most so many.
function ticks(low, high, most) {
  const rough = (high - low) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(times => times * power).find(step => step >= rough);
  const found = [];
  for (let at = Math.ceil(low / step); at * step <= high; at++) found.push(at * step);
  return { found, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}

function extent(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values) { if (value < low) low = value; if (value > high) high = value; }
  const room = high > low ? 0.06 * (high - low) : Math.abs(high) * 0.1 || 1;
  return [low - room, high + room];
}

class Panel {
  constructor(panel, place) {
    Object.assign(this, panel);
    const figure = place.appendChild(document.createElement("figure"));
    const caption = figure.appendChild(document.createElement("figcaption"));
    caption.textContent = this.title;
    if (this.note) caption.appendChild(document.createElement("span")).textContent = this.note;
    this.svg = add(figure, "svg", { role: "img", "aria-label": this.title });
    const all = axis => this.curves.flatMap(curve => curve[axis]);
    const limits = this.limits.map(limit => limit.value);
    this.whole = { x: this.linked ? [0, page.end] : extent(all("x")), y: extent(all("y").concat(limits)) };
    this.view = { x: [...this.whole.x], y: [...this.whole.y] };
    this.listen();
  }

  // Pixels of a place, and back.
  px(x) { return LEFT + (x - this.view.x[0]) / (this.view.x[1] - this.view.x[0]) * this.inside; }
  py(y) { return TOP + (this.view.y[1] - y) / (this.view.y[1] - this.view.y[0]) * this.high; }
  x(px) { return this.view.x[0] + (px - LEFT) / this.inside * (this.view.x[1] - this.view.x[0]); }
  y(py) { return this.view.y[1] - (py - TOP) / this.high * (this.view.y[1] - this.view.y[0]); }

  draw() {
    const wide = this.svg.parentNode.clientWidth || 600;
    this.inside = wide - LEFT - RIGHT;
    this.high = this.linked ? 130 : Math.min(420, 0.75 * this.inside);
    this.svg.setAttribute("viewBox", `0 0 ${wide} ${this.high + TOP + FOOT}`);
    this.svg.replaceChildren();
    const view = this.shown();
    this.view = view;
    this.grid();
    const clip = `clip${panels.indexOf(this)}`;
    const frame = { x: LEFT, y: TOP, width: this.inside, height: this.high };
    add(add(this.svg, "clipPath", { id: clip }), "rect", frame);
    const inner = add(this.svg, "g", { "clip-path": `url(#${clip})`, fill: "none" });
    for (const limit of this.limits) {
      const y = this.py(limit.value);
      add(inner, "line", { x1: LEFT, x2: wide - RIGHT, y1: y, y2: y, stroke: limit.colour < 0 ? "var(--muted)"
        : colour(limit.colour), "stroke-dasharray": "8 6" });
    }
    for (const curve of this.curves) {
      add(inner, "path", { d: this.path(curve), stroke: curve.colour < 0 ? "var(--text)" : colour(curve.colour),
        "stroke-width": curve.thin || curve.x.length > 5000 && !this.linked ? 0.8 : 1.8, "stroke-linejoin": "round" });
      if (this.arrows) this.arrow(inner, curve);
    }
    if (now < page.end) this.moment(inner);
    for (const mark of this.marks) {
      add(inner, "circle", { cx: this.px(mark.x), cy: this.py(mark.y), r: 4, stroke: "var(--c1)", fill: "var(--back)" });
      add(inner, "text", { x: this.px(mark.x) + 7, y: this.py(mark.y) - 6 }, mark.name);
    }
    add(this.svg, "rect", { ...frame, fill: "none", stroke: "var(--frame)" });
    this.cursor = add(this.svg, "line", { y1: TOP, y2: TOP + this.high, stroke: "var(--muted)", visibility: "hidden" });
    this.dots = this.curves.map(curve => add(this.svg, "circle", { r: 4, visibility: "hidden",
      fill: curve.colour < 0 ? "var(--text)" : colour(curve.colour) }));
  }

  // Where the tool is at the time of the slider, or that time itself.
  moment(inner) {
    if (this.linked) {
      const x = this.px(now);
      return add(inner, "line", { x1: x, x2: x, y1: TOP, y2: TOP + this.high, stroke: "var(--muted)", "stroke-width": 1.5 });
    }
    const tool = this.curves.map(curve => reached(curve, now)).filter(Boolean).sort((a, b) => b.when - a.when)[0];
    if (tool) add(inner, "circle", { cx: this.px(tool.x), cy: this.py(tool.y), r: 5, fill: "var(--text)" });
  }

  // What is seen: to one scale, where the panel is.
  shown() {
    if (!this.equal) return this.view;
    const grow = ([low, high], by) => [low - (high - low) * (by - 1) / 2, high + (high - low) * (by - 1) / 2];
    const { x, y } = this.view;
    const share = (x[1] - x[0]) / this.inside / ((y[1] - y[0]) / this.high);
    return { x: grow(x, Math.max(1, 1 / share)), y: grow(y, Math.max(1, share)) };
  }

  grid() {
    const across = ticks(...this.view.x, Math.max(3, this.inside / 90)), up = ticks(...this.view.y, Math.max(3, this.high / 34));
    const bottom = TOP + this.high;
    for (const x of across.found) {
      add(this.svg, "line", { x1: this.px(x), x2: this.px(x), y1: TOP, y2: bottom, stroke: "var(--grid)" });
      add(this.svg, "text", { x: this.px(x), y: bottom + 14, "text-anchor": "middle" }, number(Number(x.toFixed(across.digits))));
    }
    for (const y of up.found) {
      add(this.svg, "line", { x1: LEFT, x2: LEFT + this.inside, y1: this.py(y), y2: this.py(y), stroke: "var(--grid)" });
      add(this.svg, "text", { x: LEFT - 5, y: this.py(y) + 4, "text-anchor": "end" }, number(Number(y.toFixed(up.digits))));
    }
    add(this.svg, "text", { x: LEFT + this.inside / 2, y: bottom + 29, "text-anchor": "middle" }, this.x_title);
  }

  // A curve over x by the first, least, greatest and last point of each pixel; another one by all that move.
  path(curve) {
    const parts = [], { x, y } = curve;
    let last;
    const go = (index, command) => parts.push(`${command}${this.px(x[index]).toFixed(1)} ${this.py(y[index]).toFixed(1)}`);
    if (!this.linked) {
      const starts = new Set(curve.starts);
      for (let index = 0; index < x.length && !(curve.when[index] > now); index++) {
        const at = [this.px(x[index]), this.py(y[index])], starting = !last || starts.has(index);
        const ending = index + 1 === x.length || starts.has(index + 1);
        if (!starting && !ending && Math.hypot(at[0] - last[0], at[1] - last[1]) < 0.3) continue;
        go(index, starting ? "M" : "L");
        last = at;
      }
      const tool = now < page.end && reached(curve, now);
      if (tool && tool.going) parts.push(`L${this.px(tool.x).toFixed(1)} ${this.py(tool.y).toFixed(1)}`);
      return parts.join("");
    }
    const [low, high] = this.view.x;
    let from = Math.max(0, lower(x, low) - 1), to = Math.min(x.length, lower(x, high) + 2);
    for (let index = from; index < to;) {
      const column = Math.floor(this.px(x[index]));
      let end = index, least = index, most = index;
      while (end < to && Math.floor(this.px(x[end])) === column) {
        if (y[end] < y[least]) least = end;
        if (y[end] > y[most]) most = end;
        end++;
      }
      for (const point of [...new Set([index, Math.min(least, most), Math.max(least, most), end - 1])]) {
        go(point, parts.length ? "L" : "M");
      }
      index = end;
    }
    return parts.join("");
  }

  // Where a path goes: arrows in the middle of long ways, not too many.
  arrow(inner, curve) {
    const { x, y } = curve;
    let run = 0;
    for (let index = 1; index < x.length; index++) {
      const [dx, dy] = [this.px(x[index]) - this.px(x[index - 1]), this.py(y[index]) - this.py(y[index - 1])];
      const length = Math.hypot(dx, dy);
      run += length;
      if (run < 140 || length < 1e-6) continue;
      run = 0;
      const [cx, cy] = [this.px(x[index]) - dx / 2, this.py(y[index]) - dy / 2];
      const turn = Math.atan2(dy, dx) * 180 / Math.PI;
      add(inner, "path", { d: "M-6 -4.5L5 0L-6 4.5Z", fill: curve.colour < 0 ? "var(--text)" : colour(curve.colour),
        transform: `translate(${cx} ${cy}) rotate(${turn})` });
    }
  }

  hover(px, py) {
    const said = [], near = this.linked ? [] : this.curves.map(curve => this.nearest(curve, px, py));
    const closest = near.reduce((best, one, place) => one.off < near[best].off ? place : best, 0);
    this.curves.forEach((curve, place) => {
      if (!this.linked && place !== closest) return this.dots[place].setAttribute("visibility", "hidden");
      const index = this.linked ? at(curve.x, this.x(px)) : near[place].index;
      if (index >= curve.x.length) return;
      const value = this.linked ? between(curve, this.x(px), index) : curve.y[index];
      const x = this.linked ? Math.min(Math.max(this.x(px), curve.x[0]), curve.x[curve.x.length - 1]) : curve.x[index];
      const dot = this.dots[place];
      dot.setAttribute("cx", this.px(x));
      dot.setAttribute("cy", this.py(value));
      dot.setAttribute("visibility", "visible");
      if (!said.length) said.push(`${this.x_name} ${number(x)} ${this.x_unit}`);
      said.push(`${curve.name} ${number(value)} ${this.y_unit}`);
      if (curve.kind) said.push(curve.kind);
      if (!this.linked && curve.when.length) said.push(`at ${number(curve.when[index])} ${page.unit}`);
    });
    return said;
  }

  nearest(curve, px, py) {
    let best = 0, least = Infinity;
    for (let index = 0; index < curve.x.length; index++) {
      const off = Math.hypot(this.px(curve.x[index]) - px, this.py(curve.y[index]) - py);
      if (off < least) [best, least] = [index, off];
    }
    return { index: best, off: least };
  }

  zoom(by, px, py) {
    const scale = ([low, high], at) => [at - (at - low) * by, at + (high - at) * by];
    this.move({ x: scale(this.view.x, this.x(px)), y: this.linked ? this.view.y : scale(this.view.y, this.y(py)) });
  }

  // Shows another part; those over time move together.
  move(view) {
    const extent = view.x[1] - view.x[0];
    if (!(extent > 1e-12 * (this.whole.x[1] - this.whole.x[0]) && extent <= 4 * (this.whole.x[1] - this.whole.x[0]))) return;
    for (const panel of this.linked ? panels.filter(panel => panel.linked) : [this]) {
      panel.view = { x: [...view.x], y: this.linked ? panel.view.y : [...view.y] };
      panel.draw();
    }
  }

  listen() {
    const place = event => {
      const box = this.svg.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const held = new Map();
    this.svg.addEventListener("wheel", event => {
      event.preventDefault();
      this.zoom(Math.exp(Math.sign(event.deltaY) * 0.2), ...place(event));
    }, { passive: false });
    this.svg.addEventListener("dblclick", () => this.move(this.whole));
    this.svg.addEventListener("pointerdown", event => {
      held.set(event.pointerId, place(event));
      this.svg.setPointerCapture(event.pointerId);
    });
    for (const end of ["pointerup", "pointercancel"]) this.svg.addEventListener(end, event => held.delete(event.pointerId));
    this.svg.addEventListener("pointermove", event => {
      const [px, py] = place(event);
      if (!held.has(event.pointerId)) return this.read(px, py);
      const before = held.get(event.pointerId);
      held.set(event.pointerId, [px, py]);
      if (held.size === 2) {
        const [[ax, ay], [bx, by]] = held.values(), other = [...held].find(([id]) => id !== event.pointerId)[1];
        const was = Math.hypot(before[0] - other[0], before[1] - other[1]);
        return this.zoom(was / Math.max(1, Math.hypot(ax - bx, ay - by)), (ax + bx) / 2, (ay + by) / 2);
      }
      const dx = this.x(before[0]) - this.x(px), dy = this.linked ? 0 : this.y(before[1]) - this.y(py);
      this.move({ x: this.view.x.map(x => x + dx), y: this.view.y.map(y => y + dy) });
    });
    this.svg.addEventListener("pointerleave", () => panels.forEach(panel => panel.quiet()));
  }

  read(px, py) {
    const shown = this.linked ? panels.filter(panel => panel.linked) : [this];
    const said = [];
    for (const panel of shown) {
      const words = panel.hover(panel.linked ? panel.px(this.x(px)) : px, py);
      said.push(...(said.length ? words.slice(1) : words));
      panel.cursor.setAttribute("visibility", panel.linked ? "visible" : "hidden");
      panel.cursor.setAttribute("x1", panel.px(this.x(px)));
      panel.cursor.setAttribute("x2", panel.px(this.x(px)));
    }
    document.getElementById("says").textContent = said.join("  \u00b7  ");
  }

  quiet() {
    document.getElementById("says").textContent = HINT;
    for (const shape of [this.cursor, ...this.dots]) shape.setAttribute("visibility", "hidden");
  }
}

// The first index whose value is not below.
function lower(values, value) {
  let low = 0, high = values.length;
  while (low < high) { const middle = (low + high) >> 1; if (values[middle] < value) low = middle + 1; else high = middle; }
  return low;
}
const at = (values, value) => Math.min(values.length - 1, Math.max(1, lower(values, value)));
function between(curve, x, index) {
  const [a, b] = [Math.max(0, index - 1), index], run = curve.x[b] - curve.x[a];
  const share = run > 0 ? Math.min(1, Math.max(0, (x - curve.x[a]) / run)) : 1;
  return curve.y[a] + share * (curve.y[b] - curve.y[a]);
}

// Where a path is at a time: on its last line that has begun, or at the end of that.
function reached(curve, time) {
  const { x, y, when } = curve;
  if (!when.length || time < when[0]) return undefined;
  const index = lower(when, time);
  if (index > 0 && index < when.length && !curve.starts.includes(index)) {
    const run = when[index] - when[index - 1], share = run > 0 ? (time - when[index - 1]) / run : 1;
    const on = values => values[index - 1] + share * (values[index] - values[index - 1]);
    return { x: on(x), y: on(y), when: time, going: true };
  }
  const last = index < when.length && when[index] === time ? index : Math.max(0, index - 1);
  return { x: x[last], y: y[last], when: when[last], going: false };
}

// The time of the slider; at its end all is shown.
let now = page.end;
const panels = [];
for (const panel of page.panels) panels.push(new Panel(panel, document.getElementById("panels")));
page.names.forEach((name, index) => {
  const entry = document.getElementById("legend").appendChild(document.createElement("span"));
  const line = entry.appendChild(document.createElement("i"));
  line.style.borderColor = colour(index);
  entry.append(name);
});
const redraw = () => panels.forEach(panel => panel.draw());
addEventListener("resize", redraw);
const slider = document.getElementById("time"), told = document.getElementById("now");
document.getElementById("clock").hidden = !page.panels.some(panel => panel.curves.some(curve => curve.when.length));
function tell() { told.textContent = `${number(now)} ${page.unit}`; }
let waiting = false;
slider.addEventListener("input", () => {
  now = page.end * slider.value / slider.max;
  tell();
  if (!waiting) requestAnimationFrame(() => { waiting = false; redraw(); });
  waiting = true;
});
tell();
redraw();
