//! How many digits a formula keeps: the derived one as it stands and the kernel, against double the precision.

use closedform::DoubleDouble;
use closedform_kernels::turnaround::t_in;
use closedform_motion::plot::Series;

/// Turn-arounds at each place.
pub const SAMPLES: u32 = 200;

/// Places in a decade.
const PLACES: [f64; 4] = [1.0, 1.8, 3.2, 5.6];

/// The decades of the share by which the step is larger than that of the ramps out.
const DECADES: std::ops::Range<i32> = -15..4;

/// A turn-around.
#[derive(Clone, Copy)]
struct Case {
    t_out: f64,
    t_edge: f64,
    a2_max: f64,
    d2_step: f64,
}

/// The worst error over the share of the step that is left for the ramps in.
pub fn series() -> Vec<Series> {
    let mut random = Random(1);
    let mut formula = Series { name: "formula as derived".to_owned(), points: Vec::new() };
    let mut kernel = Series { name: "kernel".to_owned(), points: Vec::new() };
    for share in DECADES.flat_map(|decade| PLACES.map(|place| place * ten_to(decade))) {
        let cases: Vec<Case> = (0..SAMPLES).map(|_| random.case(share)).collect();
        let worst = |f: fn(Case) -> f64| cases.iter().map(|case| ulps(f(*case), exact(*case))).fold(0.0, f64::max);
        formula.points.push((share, worst(as_derived)));
        kernel.points.push((share, worst(by_kernel)));
    }
    vec![formula, kernel]
}

/// The number nearest to a power of ten, the same everywhere.
fn ten_to(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}

fn as_derived(Case { t_out, t_edge, a2_max, d2_step }: Case) -> f64 {
    let radicand =
        t_out * t_out / 4.0 + 3.0 * t_edge * t_out / 4.0 + 9.0 * t_edge * t_edge / 16.0 + 3.0 * d2_step / a2_max;
    radicand.sqrt() - 3.0 * t_out / 2.0 - 3.0 * t_edge / 4.0
}

fn by_kernel(case: Case) -> f64 {
    t_in(case.t_out, case.t_edge, case.a2_max, case.d2_step)
}

/// The value in double-double arithmetic: 2*(6*d - a*t*(4*t+3*e)) / (sqrt(a*(a*(2*t+3*e)^2 + 48*d)) + 3*a*(2*t+e)). Times and
/// acceleration have 14 digits of 2 at most, so that all products of them are exact.
fn exact(Case { t_out: t, t_edge: e, a2_max: a, d2_step: d }: Case) -> (f64, f64) {
    let ramps = a * t * (4.0 * t + 3.0 * e);
    let numerator = add(pair(DoubleDouble::two_product(6.0, d)), (-ramps, 0.0));
    let sum = 2.0 * t + 3.0 * e;
    let radicand = add(pair(DoubleDouble::two_product(a, a * sum * sum)), scale(48.0 * a, (d, 0.0)));
    let denominator = add(root(radicand), (3.0 * a * (2.0 * t + e), 0.0));
    divide(scale(2.0, numerator), denominator)
}

fn pair(wide: DoubleDouble) -> (f64, f64) {
    (wide.round(), wide.low())
}

fn add(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let (high, low) = pair(DoubleDouble::two_sum(a.0, b.0));
    pair(DoubleDouble::two_sum(high, low + (a.1 + b.1)))
}

fn scale(factor: f64, a: (f64, f64)) -> (f64, f64) {
    let (high, low) = pair(DoubleDouble::two_product(factor, a.0));
    pair(DoubleDouble::two_sum(high, low + factor * a.1))
}

/// One step of Newton from the quotient of the high parts.
fn divide(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let first = a.0 / b.0;
    let left = add(a, scale(-first, b));
    pair(DoubleDouble::two_sum(first, left.0 / b.0))
}

/// One step of Newton from the root of the high part.
fn root(a: (f64, f64)) -> (f64, f64) {
    let first = a.0.sqrt();
    let left = add(a, scale(-first, (first, 0.0)));
    pair(DoubleDouble::two_sum(first, left.0 / (2.0 * first)))
}

/// How far a value is from the exact one, in units of the last place of that; all digits are wrong beyond 2^53.
fn ulps(value: f64, exact: (f64, f64)) -> f64 {
    let unit = exact.0.next_up() - exact.0;
    let error = ((value - exact.0) - exact.1).abs() / unit;
    if error.is_nan() { 2_f64.powi(53) } else { error }
}

/// Numbers that look random and are the same everywhere (a linear congruential generator of Knuth).
struct Random(u64);

impl Random {
    /// From 1 to 2, with 14 digits of 2.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        1.0 + f64::from((self.0 >> 51) as u16) / f64::from(1_u16 << 13)
    }

    /// A turn-around whose step is larger by a share than that of the ramps out alone.
    fn case(&mut self, share: f64) -> Case {
        let (t_out, t_edge, a2_max) = (self.next() / 512.0, self.next() / 64.0, self.next());
        let ramps = a2_max * t_out * (4.0 * t_out + 3.0 * t_edge) / 6.0;
        let d2_step = ramps + ramps * share * self.next();
        Case { t_out, t_edge, a2_max, d2_step: d2_step.max(ramps.next_up()) }
    }
}
