//! The worksheet's own numbers, by kernels: its calculation case, its test case, its remark.

use closedform_kernels::step_move::{quarter_move, ramp_from_rest};
use closedform_kernels::{pvt, turnaround};

/// Demands all digits of a number as the worksheet's case prints it, up to half a unit of its last one.
fn prints(value: f64, number: &str) {
    let decimals = |text: &str| text.split_once('.').map_or(0, |(_, digits)| digits.len());
    let (mantissa, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let exponent: i32 = exponent.parse().unwrap();
    let scaled = value * 10.0_f64.powi(-exponent);
    let difference = (scaled - mantissa.parse::<f64>().unwrap()).abs();
    let unit = 10.0_f64.powi(-(decimals(mantissa) as i32));
    assert!(difference <= 0.5001 * unit, "{value} is not {number}");
}

/// 2.3.1, %o112 to %o116: v0 = 0.5 m/s, a1 = -500 m/s^2, a2Max = 2 m/s^2, a step of 2 mm, 30 ms between two ramps in.
#[test]
fn the_calculation_case() {
    let turn = pvt::turn_out(0.5, -500.0);
    prints(turn.t_out, "0.002");
    prints(turn.d1_out, "6.66666666666667e-4");
    prints(turnaround::t_in(turn.t_out, 0.028, 2.0, 0.002), "0.0350254182534948");
}

/// 4.1.2: a step of 1 mm, t1 = 10 ms, settling from -0.1 m/s^2.
#[test]
fn the_test_case_of_the_step() {
    let step = quarter_move(0.001, -0.1, 0.01);
    prints(step.x1, "6.11590987191586e-4");
    prints(step.v0, "0.0287752551286084");
    prints(step.v3, "6.12372435695795e-3");
    prints(step.a0, "4.43030615433009");
    prints(0.02 + step.t4, "0.142474487139159");
    let ramp = ramp_from_rest(0.25e-3, step.v0);
    prints(ramp.t0, "0.0260640608275389");
    prints(ramp.a00, "2.20804082057735");
}

/// 4.2: with t1 = 15 ms and a3 = -0.25 m/s^2 the acceleration is almost continuous at x0.
#[test]
fn the_remark_on_continuous_acceleration() {
    let step = quarter_move(0.001, -0.25, 0.015);
    let ramp = ramp_from_rest(0.25e-3, step.v0);
    prints(step.a0, "0.86747");
    prints(ramp.a00, "0.87011");
}
