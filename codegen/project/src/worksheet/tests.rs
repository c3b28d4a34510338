//! What worksheets come to, by Maxima's rules of scopes, evaluation and assignment.

use super::*;
use closedform_maxima::print;

fn reading(text: &str) -> Reading {
    read(text, BTreeMap::new())
}

/// The formulas of a worksheet as `name(inputs) = value`, several results in brackets.
fn formulas(text: &str) -> Vec<String> {
    let spelt = |formula: &Formula| {
        let results: Vec<String> = formula
            .results
            .iter()
            .map(|(name, body)| match name.as_str() {
                "" => print(body),
                name => format!("{name}: {}", print(body)),
            })
            .collect();
        format!("{}({}) = {}", formula.name, formula.inputs.join(","), results.join(", "))
    };
    reading(text).formulas.iter().map(spelt).collect()
}

/// Why names have no formula.
fn refused(text: &str) -> Vec<String> {
    reading(text).refused.into_iter().map(|(name, because)| format!("{name}: {}", because.what)).collect()
}

fn last(text: &str) -> String {
    formulas(text).pop().unwrap_or_else(|| panic!("{:?}", refused(text)))
}

#[test]
fn a_name_with_a_formula_takes_its_free_names() {
    assert_eq!(formulas("E: m*c^2+p/m$"), ["E(m,c,p) = m*c^2+p/m"]);
    assert_eq!(formulas("c: 3$ E: m*c^2$ c: 4$"), ["E(m) = m*3^2"]);
    assert_eq!(formulas("p: x^2$ x: 3$ q: p+x$"), ["p(x) = x^2", "q(x) = x^2+3"]);
    assert_eq!(formulas("a: x+1$ a: a^2$"), ["a(x) = (x+1)^2"]);
    assert_eq!(formulas("[a,b]: [x,y+1]$ [a,b]: [b,2*a]$"), ["a(y) = y+1", "b(x) = 2*x"]);
    assert_eq!(formulas("u: v: x+1$"), ["u(x) = x+1", "v(x) = x+1"]);
    assert_eq!(formulas("x+1$ y: %^2$"), ["y(x) = (x+1)^2"]);
}

#[test]
fn a_function_sees_what_is_said_after_it() {
    assert_eq!(formulas("f(x) := a*x$ a: 5$"), ["f(x) = 5*x"]);
    assert_eq!(formulas("f(x) := a*x$"), ["f(x,a) = a*x"]);
    assert_eq!(formulas("f(x) := g(x)+1$ g(y) := y^2$ g(y) := y^3$"), ["f(x) = x^3+1", "g(y) = y^3"]);
    assert_eq!(formulas("w: v+1$ v: 4$ f(x) := ''w*x$"), ["w(v) = v+1", "f(x) = (4+1)*x"]);
    assert_eq!(last("a: 2$ define(f(x), a*x)$ a: 3$"), "f(x) = 2*x");
    assert_eq!(last("h(u) := g(1)+u$ g(y) := y*u$"), "g(y,u) = y*u");
    assert_eq!(formulas("h(u) := g(1)+u$ g(y) := y*u$")[0], "h(u) = 1*u+u", "scopes are dynamic");
    assert_eq!(last("f(a,b) := a-b$ g(a,b) := f(b,a)$"), "g(a,b) = b-a");
    assert_eq!(last("f: lambda([x], x^2+c)$ g(y) := f(y+1)$"), "g(y,c) = (y+1)^2+c");
}

#[test]
fn a_free_name_is_no_parameter() {
    assert_eq!(formulas("p: x^2$ g(x) := p*x$"), ["p(x) = x^2"]);
    assert!(refused("p: x^2$ g(x) := p*x$")[0].contains("is not this parameter in Maxima"));
    assert_eq!(last("p: x^2$ define(g(x), p*x)$"), "g(x) = x^2*x");
    assert_eq!(last("p: x^2$ g(x) := ''p*x$"), "g(x) = x^2*x");
    assert_eq!(last("x: 7$ g(x) := x+1$"), "g(x) = x+1");
}

#[test]
fn blocks_have_names_of_their_own() {
    assert_eq!(last("f(x) := block([t: x+1, s], s: t^2, s/t)$"), "f(x) = (x+1)^2/(x+1)");
    assert_eq!(last("t: 9$ f(x) := block([t], t: x, t+1)$ g(x) := t*x$"), "g(x) = 9*x");
    assert_eq!(last("f(x) := block([t: x+1], return(t^2), 99)$"), "f(x) = (x+1)^2");
    assert_eq!(last("g(x) := x$ f(x) := block(local(g), g(y) := y^2, g(x))$ h(x) := f(x)+g(x)$"), "h(x) = x^2+x");
    assert_eq!(last("f(x) := (s: x+1, s^2)$"), "f(x) = (x+1)^2");
}

#[test]
fn values_for_names_are_put_in() {
    assert_eq!(last("y: x^2$ z: subst(x=a+1, y)$"), "z(a) = (a+1)^2");
    assert_eq!(last("z: subst([a=b,b=c], a*d)$"), "z(c,d) = c*d");
    assert_eq!(last("z: at(a*d, [a=b,b=c])$"), "z(b,d) = b*d");
    assert_eq!(last("z: subst(2, q, q+x)$"), "z(x) = 2+x");
    assert_eq!(last("y: x^2$ z: ev(y, x=a)$"), "z(a) = a^2");
    assert_eq!(last("y: x^2$ z: w*y$ v: z, x=3, w=b$"), "v(b) = b*3^2");
    assert_eq!(last("y: x^2$ x: 7$ z: ev(y*b, c=1)$"), "z(b) = 7^2*b");
    assert_eq!(last("e: F = m*a$ y: rhs(e)+1$"), "y(m,a) = m*a+1");
    assert_eq!(last("y: sum(a^i, i, 0, 2)$"), "y(a) = a^0+a^1+a^2");
}

#[test]
fn lists_and_matrices_are_several_results() {
    assert_eq!(last("p: [x+1, x*y]$"), "p(x,y) = p_1: x+1, p_2: x*y");
    assert_eq!(last("p: [u = x+1, v = x*y]$"), "p(x,y) = u: x+1, v: x*y");
    assert_eq!(last("p: [x = a+1, x = a*y]$"), "p(a,y) = p_1: a+1, p_2: a*y", "two solutions");
    assert_eq!(formulas("p_2: z^2$ p: [x, y]$"), ["p_2(z) = z^2"]);
    assert!(refused("p_2: z^2$ p: [x, y]$")[0].contains("would be called `p_2`"));
    assert_eq!(formulas("p: z^2$ p(x) := x$").len(), 1, "a function and a variable of one name");
    assert_eq!(last("r(a) := matrix([a,1],[2*a,b])$"), "r(a,b) = r_1_1: a, r_1_2: 1, r_2_1: 2*a, r_2_2: b");
    assert_eq!(last("m: matrix([1,x],[x,2])$ y: m . [3,z]$ d: determinant(m)$"), "d(x) = 1*2-x*x");
    assert_eq!(last("l: [x, y^2]$ z: l[2]+l[1]$"), "z(y,x) = y^2+x");
    assert_eq!(last("l: [x, y]$ k: 2*l+[1,2]$"), "k(x,y) = k_1: 2*x+1, k_2: 2*y+2");
}

#[test]
fn subscripts_become_names() {
    assert_eq!(last("y: x[1]^2+x[2]$"), "y(x_1,x_2) = x_1^2+x_2");
    assert_eq!(last("x_1: 3$ y: x[1]+x_1$"), "y(x_1_) = x_1_+3");
    assert_eq!(last("a: b$ y: a[1]^2$"), "y(b_1) = b_1^2");
    assert_eq!(last("a[0]: 5$ y: a[0]*x$"), "y(x) = 5*x");
    assert_eq!(last("l: [1,2]$ l[1]: b$ y: l[1]+x$"), "y(b,x) = b+x");
    assert_eq!(formulas("l: [1,2]$ k: l$ k[1]: b$ y: l[1]+x$"), [""; 0], "both names stand for one list");
}

#[test]
fn items_of_parameters_are_parameters() {
    assert_eq!(last("f(v,t) := v[2]*t+v[1]$"), "f(v_1,v_2,t) = v_2*t+v_1");
    assert_eq!(last("g(m) := m[1,1]*m[2,2]$"), "g(m_1_1,m_2_2) = m_1_1*m_2_2");
    assert_eq!(last("f(v) := v[1]-v[2]$ g(a,b) := f([b,a])$"), "g(a,b) = b-a");
    assert_eq!(last("f(v) := v[1]-v[2]$ g(w) := 2*f(w)$"), "g(w_1,w_2) = 2*(w_1-w_2)");
    assert_eq!(last("v_1: 3$ f(v) := v[1]+v_1$"), "f(v_1_) = v_1_+3");
    assert_eq!(last("f: lambda([v], v[1]^2)$"), "f(v_1) = v_1^2");
    assert_eq!(last("f(v) := v[1][2]$"), "f(v_1_2) = v_1_2");
    assert!(refused("f(v) := v[1]+v$")[0].contains("a list in one place and a number in another"));
    assert!(refused("f(v) := (v[1]: 3, v[1]+v[2])$")[0].contains("a list that the function changes"));
    assert!(refused("f(v,i) := v[i]$")[0].contains("whose place is not known"));
    assert!(refused("f(v) := v[1]*v[1][2]$")[0].contains("a list in one place"));
}

#[test]
fn loops_are_run_through_where_numbers_say_how_often() {
    assert_eq!(last("s: 0$ for i:1 thru 3 do s: s+i*x$ y: s$"), "y(x) = 0+1*x+2*x+3*x");
    assert_eq!(last("s: 1$ for k in [a,b] do s: s*k$ y: s$"), "y(a,b) = 1*a*b");
    assert_eq!(last("s: 0$ for i:5 step -2 thru 1 do s: s+x^i$ y: s$"), "y(x) = 0+x^5+x^3+x^1");
    assert_eq!(last("s: 0$ for i:1 next 2*i while i < 5 do s: s+x^i$ y: s$"), "y(x) = 0+x^1+x^2+x^4");
    assert_eq!(last("s: x$ thru 2 do s: s^2$ y: s$"), "y(x) = (x^2)^2");
    assert_eq!(last("i: 9$ for i:1 unless i > 1 do z: x*i$ y: z*i$"), "y(x) = x*1*9");
    assert_eq!(last("f(x) := block([p: 1], for i:1 thru 2 do p: p*(x-i), p)$"), "f(x) = 1*(x-1)*(x-2)");
    assert_eq!(last("for i:1 thru 2 do a[i]: x+i$ y: a[1]*a[2]$"), "y(x) = (x+1)*(x+2)");
    assert_eq!(last("f(x) := block([r], for i:1 thru 3 do (r: x+i, if i = 2 then return(r)), r)$"), "f(x) = x+2");
    assert_eq!(last("for row in matrix([a,b],[c,d]) do z: row[1]$ y: z^2$"), "y(c) = c^2");
    for program in [
        "s: 0$ for i:1 thru n do s: s+x$ y: s$",
        "s: x$ for i:1 do s: s^2$ y: s$",
        "s: x$ while s > 1 do s: s/2$ y: s$",
        "s: x$ for k in l do s: s*k$ y: s$",
        "s: x$ for i:0.5 thru 2 do s: s*i$ y: s$",
    ] {
        assert!(
            refused(program).iter().any(|said| said.contains("changed in a loop")),
            "{program}: {:?}",
            refused(program)
        );
    }
    assert!(reading("for i:1 thru 2 do x[i]: i$ y: z$").passed.is_empty(), "what is obeyed is not passed over");
    assert_eq!(reading("for i:1 thru n do x[i]: i$ y: z$").passed[0].0, "a loop");
}

#[test]
fn what_is_refused_leaves_nothing_half_known() {
    assert_eq!(last("c: 1$ (b: makelist(i,i,1,n), c: 2)$ y: c*x$"), "y(x) = 2*x");
    assert!(
        refused("c: 1$ f(x) := (u: sum(x,i,1,n), c: 2, x)$ z: f(3)$ y: c*x$").iter().any(|said| said.contains("y:"))
    );
    assert!(refused("y: 2*x, foo(u)=3$").iter().any(|said| said.contains("y: an option of `ev`")));
    assert!(refused("c: 1$ if is(%i1 > 2) then c: 2 else c: 3$ y: c*x$").iter().any(|said| said.contains("y:")));
    assert_eq!(last("y: x^2, ratsimplify$"), "y(x) = x^2", "a word that means nothing to Maxima");
    assert!(refused("y: block(if x > 0 then return(1), 2*x)$")[0].contains("`return` under a condition"));
}

#[test]
fn what_follows_the_end_is_not_read() {
    let read = reading("y: x+1$ quit()$ y: x+2$ z: x$");
    assert_eq!(print(&read.formulas[0].results[0].1), "x+1");
    assert_eq!((read.formulas.len(), read.passed.len()), (1, 1));
}

#[test]
fn what_needs_computing_says_so() {
    for text in [
        "y: solve(x^2=a,x)[1]$",
        "y: rhs(solve(x^2=a,x)[1])+b$",
        "z: subst(solve(x=a,x), x^2)$",
        "z: x^2, solve(x=a,x)$",
        "z: makelist(i*x, i, 1, length(solve(x^2=1,x)))$",
        "y: 'integrate(f,x)$",
        "y: ev(x, nouns)$",
        "s: solve(x^2=a,x)$ t: s[2]$",
        "s: 0$ for i:1 thru length(solve(x^2=a,x)) do s: s+i$ y: s*b$",
        "s: 0$ for r in solve(x^2=a,x) do s: s+rhs(r)$ y: s*b$",
    ] {
        let said = reading(text).refused;
        assert!(said.iter().all(|(_, because)| because.remedy == COMPUTE) && !said.is_empty(), "{text}: {said:?}");
    }
}

#[test]
fn truths_are_conditions() {
    let conditions =
        |text: &str| reading(text).formulas.pop().unwrap().conditions.iter().map(spelt).collect::<Vec<_>>();
    assert_eq!(conditions("f(x) := if maybe(x>2) = false then error(\"low\") else x$"), ["not not x>2"]);
    assert_eq!(conditions("f(x) := if is(x>2) = true then x$"), ["x > 2"]);
    assert_eq!(conditions("f(x) := if is(x>2) # false then x$"), ["x > 2"]);
    assert_eq!(conditions("g(x) := if x > 1 then x else error(\"low\")$ f(x) := sqrt(g(x))+1$"), ["x > 1"]);
    assert_eq!(last("f(x) := if maybe(1>2) = false then x else 2*x$"), "f(x) = x");
    let told = "f(x) := if x < 0 then error(\"low\") elseif x < 1 then x elseif x < 2 then 2*x else false$";
    assert_eq!(conditions(told), ["not x<0", "x<0 or x<1 or x<2"]);
    assert_eq!(last(told), "f(x) = if x<1 then x else 2*x");
    for text in ["f(x) := x > 1$", "f(x) := if x > 1 then true else x$", "f(x) := is(x > 1) or x < 0$"] {
        assert!(refused(text)[0].contains("true or false"), "{text}: {:?}", refused(text));
    }
}

#[test]
fn lists_are_taken_apart_and_put_together() {
    assert_eq!(last("l: [a,b,c]$ y: rest(l)$"), "y(b,c) = y_1: b, y_2: c");
    assert_eq!(last("l: [a,b,c]$ y: rest(l,-1) . rest(l)$"), "y(a,b,c) = a*b+b*c");
    assert_eq!(last("y: endcons(c, cons(a, [b]))$"), "y(a,b,c) = y_1: a, y_2: b, y_3: c");
    assert_eq!(last("y: flatten([[a],[b,[c*d]]])[3]$"), "y(c,d) = c*d");
    assert_eq!(last("m: matrix([a,b],[c,d])$ y: row(m,2) . col(m,1)$"), "y(c,a,d) = c*a+d*c");
    assert_eq!(last("v: transpose([a,b])$ y: sqrt(transpose(v) . v)$"), "y(a,b) = sqrt(a*a+b*b)");
    assert_eq!(last("y: transpose([a,b]) . [c,d]$"), "y(a,c,d,b) = y_1_1: a*c, y_1_2: a*d, y_2_1: b*c, y_2_2: b*d");
    assert_eq!(last("y: transpose([a,b])$"), "y(a,b) = y_1_1: a, y_2_1: b");
    assert_eq!(last("y: unit_step(x-1)*fix(x)$"), "y(x) = (if x-1>0 then 1 else 0)*floor(x)");
    assert_eq!(last("f: 3$ y: float(g: x+1)$ z: g*f$"), "z(x) = (x+1)*3");
}

#[test]
fn numbers_decide_conditions_and_ends() {
    assert_eq!(last("p(n,x) := if n = 0 then 1 else x*p(n-1,x)$ y: p(2,z)$"), "y(z) = z*(z*1)");
    assert!(refused("p(n,x) := if n = 0 then 1 else x*p(n-1,x)$")[0].contains("p -> p"));
    assert_eq!(last("f(x) := if x > 0 then sqrt(x) else error(\"negative\")$"), "f(x) = sqrt(x)");
    let conditions =
        |text: &str| reading(text).formulas.pop().unwrap().conditions.iter().map(spelt).collect::<Vec<_>>();
    assert_eq!(last("f(x) := if not (x > 9) then x else 1$"), "f(x) = if not x>9 then x else 1");
    assert_eq!(conditions("f(x) := if x > 0 then sqrt(x) else error(\"negative\")$"), ["x > 0"]);
    assert_eq!(conditions("f(x,y) := if x < y then false elseif equal(y,0) then und else x/y$").len(), 2);
    assert_eq!(conditions("g(x) := if x >= 1 then x else error()$ h(z) := g(z-1)$"), ["z-1 >= 1"]);
}

#[test]
fn what_only_maxima_knows_is_refused_with_all_that_depends_on_it() {
    let because = refused("y: integrate(x^2, x)$ z: y+1$");
    assert!(because.iter().all(|because| because.contains("it calls `integrate`")), "{because:?}");
    assert_eq!(because.len(), 2);
    assert!(refused("s: 0$ for i thru n do s: s+x^i$ y: s+1$").iter().all(|because| because.contains("a loop")));
    assert_eq!(formulas("[a, b]: solve(p, q)$ y: a*x$ z: x+1$"), ["z(x) = x+1"]);
    assert_eq!(formulas("f(x) := x$ load(draw)$ y: a*f(x)$").len(), 2);
    assert!(refused("simp: false$ y: x/x$").iter().any(|because| because.contains("arithmetic")));
    assert!(refused("set() := a: 4$ a: 3$ if q then set()$ y: a*x$").iter().any(|because| because.contains("`if`")));
    assert!(refused("z: ratsimp(0.1*x)$")[0].contains("decimal point"));
    assert_eq!(last("z: ratsimp(x/10)+float(1/3)$"), "z(x) = x/10+1/3");
    assert_eq!(refused("declare(z, complex)$ y: 2*z$").len(), 1);
}

#[test]
fn what_is_not_at_hand_leaves_names_open() {
    let absent = |text: &str| reading(text).passed.into_iter().map(|(what, _)| what).collect::<Vec<_>>();
    assert_eq!(last("a: 3$ load(\"nowhere.mac\")$ y: a*x*c$"), "y(x,c) = 3*x*c");
    assert!(absent("load(\"nowhere.mac\")$ y: x+1$")[0].contains("`nowhere.mac` is not at hand"));
    assert_eq!(formulas("f(x) := g(x)$ load(nowhere)$ g(y) := y^2$")[0], "f(x) = x^2");
    assert!(absent("load(concat(a, b))$ y: x+1$")[0].contains("whose name is computed"));
    assert!(absent(":lisp (setq x 1)\ny: x+1$")[0].contains("a line of Lisp"));
    assert_eq!(absent("load(\"draw\")$ reset()$ infix(\"~\")$ y: x+1$"), [""; 0], "what is known needs no word");
}

#[test]
fn derivatives_are_put_in() {
    assert_eq!(last("y: diff(a*x^3+sqrt(x), x)$"), "y(a,x) = a*(3*x^2)+1/(2*sqrt(x))");
    assert_eq!(last("f(x,t) := x^2*t$ define(g(x,t), diff(f(x,t), x, 2))$"), "g(x,t) = 2*t");
    assert_eq!(last("y: diff(x/(x+b), x)$"), "y(x,b) = 1/(x+b)-x/(x+b)^2");
    assert_eq!(last("y: diff(x^2*z^3, x, 1, z, 2)$"), "y(x,z) = 2*x*(3*(2*z))");
    assert_eq!(last("y: diff([x^2, -x, 7], x)$"), "y(x) = y_1: 2*x, y_2: -1, y_3: 0");
    assert!(refused("y: diff(g(x), x)+1$")[0].contains("whose derivative is not known"));
    assert!(refused("depends(u, t)$ y: diff(u^2, t)+u$")[0].contains("`u`, which depends on others"));
    assert!(refused("y: diff(x^x, x)$")[0].contains("variable base"));
    assert_eq!(formulas("y: 'diff(x^2, x)+x$"), [""; 0], "a noun is left to Maxima");
}

#[test]
fn functions_of_subscripts_are_elements() {
    assert_eq!(last("h[0]: 1$ h[1]: 2*x$ h[n] := 2*x*h[n-1]-h[n-2]$ y: h[3]$"), last("y: 2*x*(2*x*(2*x)-1)-2*x$"));
    assert_eq!(last("a[i] := b*i$ y: a[2]+a[k]$"), "y(b,k) = b*2+b*k");
    assert!(!refused("a[n] := a[n-1]$ y: a[3]+x$").is_empty());
}

#[test]
fn declared_operators_are_functions() {
    assert_eq!(last("infix(\"<+>\")$ a <+> b := sqrt(a^2+b^2)$ y: u <+> 2$"), "y(u) = sqrt(u^2+2^2)");
    assert_eq!(last("prefix(\"half\")$ half x := x/2$ y: half u+1$"), "y(u) = u/2+1");
    assert_eq!(last("tellsimp(q(0), 1)$ f(x) := x+1$"), "f(x) = x+1");
    assert!(refused("tellsimp(q(0), 1)$ f(x) := q(x)+1$")[0].contains("a rule of simplification"));
}

#[test]
fn what_maxima_computed_is_taken_as_it_stands() {
    let closed =
        closed("assume(x > 0)$ f(x):=a*x$ a:3$ b:a+y$ c:'integrate(g(x),x)$ s:[u=x^2,v=1]$ l:lambda([z],z^2)$");
    let named: Vec<(&str, &[String])> =
        closed.formulas.iter().map(|formula| (formula.name.as_str(), formula.inputs.as_slice())).collect();
    let strings = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
    assert_eq!(
        named,
        [
            ("f", &*strings(&["x", "a"])),
            ("b", &*strings(&["a", "y"])),
            ("s", &*strings(&["x"])),
            ("l", &*strings(&["z"]))
        ]
    );
    assert_eq!((closed.constants, closed.formulas[0].assumed.len()), (strings(&["a"]), 1));
    assert!(closed.refused[0].1.what.contains("Maxima leaves `integrate` as it is"), "{:?}", closed.refused);
}

#[test]
fn maxima_is_asked_for_what_is_no_program() {
    let text = "f(x) := x$ a: 2$ f(x) := x+1$ g(n) := for i thru n do print(i)$ h(x) := (for i thru 3 do x: x+1, x)$\n\
                [p, q]: solve(e, x)$";
    let asked: Vec<(String, bool)> =
        wanted(text).into_iter().map(|wanted| (wanted.name, wanted.not_asked.is_none())).collect();
    let pairs = [("a", true), ("f", true), ("g", false), ("h", true), ("p", true), ("q", true)];
    assert_eq!(asked, pairs.map(|(name, is)| (name.to_owned(), is)));
}

#[test]
fn what_is_killed_had_its_formula() {
    assert_eq!(formulas("a: 2$ y: a*x$ kill(all)$ z: a*x$"), ["y(x) = 2*x", "z(a,x) = a*x"]);
    assert_eq!(formulas("a: 2$ f(x) := a*x$ kill(a)$ g(x) := a*x$"), ["f(x,a) = a*x", "g(x,a) = a*x"]);
}

#[test]
fn other_files_are_read_where_they_are_loaded() {
    let files = BTreeMap::from([("part.mac".to_owned(), "g: 10$ h(x) := g*x$".to_owned())]);
    let read = read("load(\"part.mac\")$ y: h(t)+1$", files);
    assert_eq!(print(&read.formulas[0].results[0].1), "10*t+1");
}

#[test]
fn assumptions_are_kept() {
    let assumed = |text: &str| reading(text).formulas.pop().unwrap().assumed.iter().map(spelt).collect::<Vec<_>>();
    assert_eq!(assumed("assume(x > 0, notequal(y, 0), z > 0)$ f(x,y) := x/y$"), ["x > 0", "y # 0"]);
    assert_eq!(assumed("assume(x > 0 and x < 1)$ forget(x < 1)$ f(x,y) := x/y$"), ["x > 0"]);
    assert_eq!(assumed("a: 3$ assume(x > a)$ f(x,y) := x/y$"), ["x > 3"]);
}

#[test]
fn what_grows_or_never_ends_is_refused() {
    let mut text = "f0(x):=x+1$".to_owned();
    (1..60).for_each(|level| text += &format!("f{level}(x):=f{}(x)*f{}(x)$", level - 1, level - 1));
    assert!(refused(&text)[0].contains("more than 100000 terms"));
    assert!(refused("f(x) := g(x)$ g(x) := f(x)$")[0].contains("f -> g -> f"));
    assert!(refused("f(n) := if n < 2 then n else f(n-1)+f(n-2)$ y: f(40)+x$").len() == 2);
    let chain: String = (1..5000).map(|n| format!("a{n}: a{}+x$", n - 1)).collect();
    assert!(!refused(&chain).is_empty());
}
