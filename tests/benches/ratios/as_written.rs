//! The formulas of the references as they are written, in Rust: what kernels are timed against.
//!
//! Printed by `closedform_tests::bench::text`; a test of the documents tells when it is stale.

formulas! {
    "five_segment::by_accelerations" [delta_x, ki, a0, a1, t1] => [
        ((3.0_f64.sqrt() * ((delta_x * ki) * a0).sqrt()) / a0),
        (((((a1 + (2.0_f64 * a0)) * { let a = t1; let p = a; let p = p * p; p }) + (({ let a = 3.0_f64.sqrt(); let p = a; let p = p * p * a; p } * ((delta_x * ki) * a0).sqrt()) * t1)) / (3.0_f64 * delta_x)) + ki),
        (((12.0_f64 * delta_x) * ((((-(((a1 + (2.0_f64 * a0)) * { let a = t1; let p = a; let p = p * p; p }) + (({ let a = 3.0_f64.sqrt(); let p = a; let p = p * p * a; p } * ((delta_x * ki) * a0).sqrt()) * t1))) / (3.0_f64 * delta_x)) - ki) + 1.0_f64)) / (((9.0_f64 * { let a = (((a1 + a0) * t1) + (3.0_f64.sqrt() * ((delta_x * ki) * a0).sqrt())); let p = a; let p = p * p; p }) + (((24.0_f64 * delta_x) * a1) * ((((-(((a1 + (2.0_f64 * a0)) * { let a = t1; let p = a; let p = p * p; p }) + (({ let a = 3.0_f64.sqrt(); let p = a; let p = p * p * a; p } * ((delta_x * ki) * a0).sqrt()) * t1))) / (3.0_f64 * delta_x)) - ki) + 1.0_f64))).sqrt() + (3.0_f64 * (((a1 + a0) * t1) + (3.0_f64.sqrt() * ((delta_x * ki) * a0).sqrt()))))),
        ((3.0_f64.sqrt() * ((delta_x * ki) * a0).sqrt()) / 2.0_f64),
        ((((a1 + a0) * t1) + (3.0_f64.sqrt() * ((delta_x * ki) * a0).sqrt())) / 2.0_f64),
    ];
    "five_segment::ki_without_middle" [delta_x, a0, a1, t1] => [
        ({ let a = ((a0.sqrt() * (((a0 - (4.0_f64 * a1)) * { let a = t1; let p = a; let p = p * p; p }) + (12.0_f64 * delta_x)).sqrt()) - ((3.0_f64 * a0) * t1)); let p = a; let p = p * p; p } / ((12.0_f64 * delta_x) * a0)),
    ];
    "five_segment::by_times" [delta_x, ki, t0, t1, t2] => [
        (((3.0_f64 * delta_x) * ki) / { let a = t0; let p = a; let p = p * p; p }),
        ((-((((delta_x * ki) * (((9.0_f64 * t1) * t2) + (12.0_f64 * { let a = t1; let p = a; let p = p * p; p }))) + (((delta_x * ki) * t0) * ((9.0_f64 * t2) + (18.0_f64 * t1)))) + ((((6.0_f64 * delta_x) * ki) - (6.0_f64 * delta_x)) * { let a = t0; let p = a; let p = p * p; p }))) / ({ let a = t0; let p = a; let p = p * p; p } * (({ let a = t2; let p = a; let p = p * p; p } + ((3.0_f64 * t1) * t2)) + (2.0_f64 * { let a = t1; let p = a; let p = p * p; p })))),
        (((3.0_f64 * delta_x) * ki) / (2.0_f64 * t0)),
        ((-((((delta_x * ki) * ((6.0_f64 * { let a = t1; let p = a; let p = p * p * a; p }) - ((3.0_f64 * t1) * { let a = t2; let p = a; let p = p * p; p }))) + (((delta_x * ki) * t0) * ((12.0_f64 * { let a = t1; let p = a; let p = p * p; p }) - (3.0_f64 * { let a = t2; let p = a; let p = p * p; p })))) + ({ let a = t0; let p = a; let p = p * p; p } * ((((6.0_f64 * delta_x) * ki) * t1) - ((6.0_f64 * delta_x) * t1))))) / ({ let a = t0; let p = a; let p = p * p; p } * (((2.0_f64 * { let a = t2; let p = a; let p = p * p; p }) + ((6.0_f64 * t1) * t2)) + (4.0_f64 * { let a = t1; let p = a; let p = p * p; p })))),
        (((({ let a = t0; let p = a; let p = p * p; p } * ((ki * ({ let a = t2; let p = a; let p = p * p; p } + ((3.0_f64 * t1) * t2))) + (2.0_f64 * { let a = t1; let p = a; let p = p * p; p }))) + (ki * (((2.0_f64 * { let a = t1; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) + ((3.0_f64 * { let a = t1; let p = a; let p = p * p * a; p }) * t2)))) + ((ki * t0) * (((3.0_f64 * t1) * { let a = t2; let p = a; let p = p * p; p }) + ((6.0_f64 * { let a = t1; let p = a; let p = p * p; p }) * t2)))) / ({ let a = t0; let p = a; let p = p * p; p } * (({ let a = t2; let p = a; let p = p * p; p } + ((3.0_f64 * t1) * t2)) + (2.0_f64 * { let a = t1; let p = a; let p = p * p; p })))),
    ];
    "fly_axis::turn_out" [t_in, v1_scan, v1_diff, a1_max] => [
        (((2.0_f64 * t_in) * (v1_scan - v1_diff)) / ((2.0_f64 * v1_diff) + (a1_max * t_in))),
        ((((4.0_f64 * t_in) * (v1_diff + (a1_max * t_in))) * { let a = (v1_scan - v1_diff); let p = a; let p = p * p; p }) / (3.0_f64 * { let a = ((2.0_f64 * v1_diff) + (a1_max * t_in)); let p = a; let p = p * p; p })),
    ];
    "fly_axis::d1_in" [t_in, v1_scan, v1_diff] => [
        ((t_in * ((3.0_f64 * v1_scan) - v1_diff)) / 3.0_f64),
    ];
    "fly_axis::a1_in" [v1_diff, t_in] => [
        ((-(2.0_f64 * v1_diff)) / t_in),
    ];
    "fly_axis::t_in_of_t_out" [t_out, v1_scan, v1_diff, a1_max] => [
        (((2.0_f64 * t_out) * v1_diff) / (((2.0_f64 * v1_scan) - (2.0_f64 * v1_diff)) - (a1_max * t_out))),
    ];
    "fly_axis::v1_diff" [t_in, t_out, v1_scan, a1_max] => [
        ((t_in * ((2.0_f64 * v1_scan) - (a1_max * t_out))) / (2.0_f64 * (t_out + t_in))),
    ];
    "fly_axis::t_add" [t_in, v1_diff, v1_scan] => [
        ((t_in * v1_diff) / (3.0_f64 * v1_scan)),
    ];
    "fly_axis::overhead" [t_out, t_edge, t_in, v1_diff, v1_scan] => [
        (((((6.0_f64 * t_out) * v1_scan) + ((3.0_f64 * t_edge) * v1_scan)) + ((2.0_f64 * t_in) * v1_diff)) / (6.0_f64 * v1_scan)),
    ];
    "fly_axis::overhead_of_t_out" [t_out, v1_scan, v1_diff, a1_max] => [
        ((((2.0_f64 * t_out) * { let a = v1_diff; let p = a; let p = p * p; p }) / (((6.0_f64 * { let a = v1_scan; let p = a; let p = p * p; p }) - ((6.0_f64 * v1_diff) * v1_scan)) - (((3.0_f64 * a1_max) * t_out) * v1_scan))) + t_out),
        ((((4.0_f64 * t_out) * v1_diff) * (((2.0_f64 * v1_scan) - v1_diff) - (a1_max * t_out))) / ((3.0_f64 * v1_scan) * { let a = (((2.0_f64 * v1_scan) - (2.0_f64 * v1_diff)) - (a1_max * t_out)); let p = a; let p = p * p; p })),
    ];
    "look_ahead::half_turn" [u_x, u_y, u_z, w_x, w_y, w_z] => [
        ((({ let a = (w_z + u_z); let p = a; let p = p * p; p } + { let a = (w_y + u_y); let p = a; let p = p * p; p }) + { let a = (w_x + u_x); let p = a; let p = p * p; p }).sqrt() / 2.0_f64),
        ((({ let a = (u_z - w_z); let p = a; let p = p * p; p } + { let a = (u_y - w_y); let p = a; let p = p * p; p }) + { let a = (u_x - w_x); let p = a; let p = p * p; p }).sqrt() / 2.0_f64),
    ];
    "look_ahead::corner_radius" [cosine, sine, deviation] => [
        (((cosine * (cosine + 1.0_f64)) * deviation) / { let a = sine; let p = a; let p = p * p; p }),
    ];
    "look_ahead::junction_speed" [cosine, sine, acceleration, deviation] => [
        ((((acceleration.sqrt() * cosine.sqrt()) * (cosine + 1.0_f64).sqrt()) * deviation.sqrt()) / sine),
    ];
    "look_ahead::deviation" [v, acceleration] => [
        (((2.0_f64.sqrt() - 1.0_f64) * { let a = v; let p = a; let p = p * p; p }) / acceleration),
    ];
    "look_ahead::centripetal_speed" [acceleration, radius] => [
        (acceleration.sqrt() * radius.sqrt()),
    ];
    "look_ahead::chord" [radius, tolerance] => [
        ((2.0_f64 * tolerance.sqrt()) * ((2.0_f64 * radius) - tolerance).sqrt()),
    ];
    "look_ahead::reachable_speed" [v, acceleration, length] => [
        ({ let a = v; let p = a; let p = p * p; p } + ((2.0_f64 * acceleration) * length)).sqrt(),
    ];
    "look_ahead::ramp" [v0, v1, acceleration] => [
        ((v1 - v0).abs() / acceleration),
        (((v1 + v0) * (v1 - v0).abs()) / (2.0_f64 * acceleration)),
    ];
    "look_ahead::block_time" [v0, v1, peak, acceleration, length] => [
        ((({ let a = (peak - v1); let p = a; let p = p * p; p } + { let a = (peak - v0); let p = a; let p = p * p; p }) / ((2.0_f64 * acceleration) * peak)) + (length / peak)),
    ];
    "look_ahead::jerk_ramp_long" [v0, v1, acceleration, jerk] => [
        (((v1 - v0).abs() / acceleration) + (acceleration / jerk)),
        (((v1 + v0) * (((v1 - v0).abs() / acceleration) + (acceleration / jerk))) / 2.0_f64),
    ];
    "look_ahead::jerk_ramp_short" [v0, v1, jerk] => [
        ((2.0_f64 * (v1 - v0).abs().sqrt()) / jerk.sqrt()),
        (((v1 + v0) * (v1 - v0).abs().sqrt()) / jerk.sqrt()),
    ];
    "look_ahead::jerk_reachable_long" [v, acceleration, jerk, length] => [
        (({ let a = (v - ({ let a = acceleration; let p = a; let p = p * p; p } / (2.0_f64 * jerk))); let p = a; let p = p * p; p } + ((2.0_f64 * acceleration) * length)).sqrt() - ({ let a = acceleration; let p = a; let p = p * p; p } / (2.0_f64 * jerk))),
    ];
    "milling_time::direction" [x, y, z] => [
        (({ let a = z; let p = a; let p = p * p; p } + { let a = y; let p = a; let p = p * p; p }) + { let a = x; let p = a; let p = p * p; p }).sqrt(),
        (x / (({ let a = z; let p = a; let p = p * p; p } + { let a = y; let p = a; let p = p * p; p }) + { let a = x; let p = a; let p = p * p; p }).sqrt()),
        (y / (({ let a = z; let p = a; let p = p * p; p } + { let a = y; let p = a; let p = p * p; p }) + { let a = x; let p = a; let p = p * p; p }).sqrt()),
        (z / (({ let a = z; let p = a; let p = p * p; p } + { let a = y; let p = a; let p = p * p; p }) + { let a = x; let p = a; let p = p * p; p }).sqrt()),
    ];
    "milling_time::step_speed" [n, u, a, length] => [
        ((({ let a = u; let p = a; let p = p * p; p } / (4.0_f64 * { let a = n; let p = a; let p = p * p; p })) + ((length * a) / n)).sqrt() + (u / (2.0_f64 * n))),
    ];
    "milling_time::step_time" [length, speed] => [
        (length / speed),
    ];
    "milling_time::constant_acceleration" [n, u, a, length] => [
        (({ let a = u; let p = a; let p = p * p; p } + (((2.0_f64 * length) * a) * n)).sqrt() / n),
        ((({ let a = u; let p = a; let p = p * p; p } + (((2.0_f64 * length) * a) * n)).sqrt() - u) / a),
    ];
    "milling_time::cut_time" [n, a, s] => [
        (((2.0_f64 * n.sqrt()) * s.sqrt()) / a.sqrt()),
    ];
    "optimum::t_o" [t_i, a, v, delta_v] => [
        (((t_i * v) + (delta_v * t_i)) / ((a * t_i) + delta_v)),
    ];
    "overhead::step_limited" [t_in, delta, v1_diff, v1_scan] => [
        ((((t_in * v1_diff) / (3.0_f64 * v1_scan)) + (({ let a = t_in; let p = a; let p = p * p; p } + (24.0_f64 * delta)).sqrt() / 4.0_f64)) - ((3.0_f64 * t_in) / 4.0_f64)),
        (((v1_diff / (3.0_f64 * v1_scan)) + (t_in / (4.0_f64 * ({ let a = t_in; let p = a; let p = p * p; p } + (24.0_f64 * delta)).sqrt()))) - (3.0_f64 / 4.0_f64)),
    ];
    "overhead::t_edge" [t_in, delta, v1_scan, v1_diff, a1_max] => [
        (((({ let a = t_in; let p = a; let p = p * p; p } + (24.0_f64 * delta)).sqrt() - (3.0_f64 * t_in)) / 2.0_f64) - (((4.0_f64 * t_in) * (v1_scan - v1_diff)) / ((2.0_f64 * v1_diff) + (a1_max * t_in)))),
    ];
    "overhead::v1_diff" [t_in, delta, v1_scan, a1_max] => [
        ((t_in * (((8.0_f64 * v1_scan) - (a1_max * ({ let a = t_in; let p = a; let p = p * p; p } + (24.0_f64 * delta)).sqrt())) + ((3.0_f64 * a1_max) * t_in))) / (2.0_f64 * (({ let a = t_in; let p = a; let p = p * p; p } + (24.0_f64 * delta)).sqrt() + t_in))),
    ];
    "overhead::scan_limited" [t_in, v1_scan, v1_diff, a1_max] => [
        (((((2.0_f64 * t_in) * v1_scan) / ((2.0_f64 * v1_diff) + (a1_max * t_in))) + ((t_in * v1_diff) / (3.0_f64 * v1_scan))) - (((2.0_f64 * t_in) * v1_diff) / ((2.0_f64 * v1_diff) + (a1_max * t_in)))),
        ((((((2.0_f64 * v1_scan) / ((2.0_f64 * v1_diff) + (a1_max * t_in))) - ((((2.0_f64 * a1_max) * t_in) * v1_scan) / { let a = ((2.0_f64 * v1_diff) + (a1_max * t_in)); let p = a; let p = p * p; p })) + (v1_diff / (3.0_f64 * v1_scan))) - ((2.0_f64 * v1_diff) / ((2.0_f64 * v1_diff) + (a1_max * t_in)))) + ((((2.0_f64 * a1_max) * t_in) * v1_diff) / { let a = ((2.0_f64 * v1_diff) + (a1_max * t_in)); let p = a; let p = p * p; p })),
    ];
    "overhead::d1_out_gradient" [t_in, v1_scan, v1_diff, a1_max] => [
        ((-(((4.0_f64 * t_in) * (v1_scan - v1_diff)) * ((((((2.0_f64 * v1_diff) * v1_scan) + (((3.0_f64 * a1_max) * t_in) * v1_scan)) + (2.0_f64 * { let a = v1_diff; let p = a; let p = p * p; p })) + (((3.0_f64 * a1_max) * t_in) * v1_diff)) + ((2.0_f64 * { let a = a1_max; let p = a; let p = p * p; p }) * { let a = t_in; let p = a; let p = p * p; p })))) / (3.0_f64 * { let a = ((2.0_f64 * v1_diff) + (a1_max * t_in)); let p = a; let p = p * p * a; p })),
        ((((4.0_f64 * v1_diff) * ((2.0_f64 * v1_diff) + ((3.0_f64 * a1_max) * t_in))) * { let a = (v1_scan - v1_diff); let p = a; let p = p * p; p }) / (3.0_f64 * { let a = ((2.0_f64 * v1_diff) + (a1_max * t_in)); let p = a; let p = p * p * a; p })),
    ];
    "pvt::acceleration_at" [a0, a1, t1, t] => [
        ((((a1 - a0) * t) / t1) + a0),
    ];
    "pvt::velocity_at" [v0, a0, a1, t1, t] => [
        ((v0 + (((a1 - a0) * { let a = t; let p = a; let p = p * p; p }) / (2.0_f64 * t1))) + (a0 * t)),
    ];
    "pvt::position_at" [x0, v0, a0, a1, t1, t] => [
        (((x0 + (t * v0)) + (((a1 - a0) * { let a = t; let p = a; let p = p * p * a; p }) / (6.0_f64 * t1))) + ((a0 * { let a = t; let p = a; let p = p * p; p }) / 2.0_f64)),
    ];
    "pvt::boundary_accelerations" [x0, v0, x1, v1, t1] => [
        (((((6.0_f64 * x1) - (6.0_f64 * x0)) - ((2.0_f64 * t1) * v1)) - ((4.0_f64 * t1) * v0)) / { let a = t1; let p = a; let p = p * p; p }),
        ((-((((6.0_f64 * x1) - (6.0_f64 * x0)) - ((4.0_f64 * t1) * v1)) - ((2.0_f64 * t1) * v0))) / { let a = t1; let p = a; let p = p * p; p }),
    ];
    "pvt::arrival_first" [x0, v0, x1, v1, a0] => [
        (((6.0_f64 * x1) - (6.0_f64 * x0)) / ((((((((6.0_f64 * a0) * x1) - ((6.0_f64 * a0) * x0)) + { let a = v1; let p = a; let p = p * p; p }) + ((4.0_f64 * v0) * v1)) + (4.0_f64 * { let a = v0; let p = a; let p = p * p; p })).sqrt() + v1) + (2.0_f64 * v0))),
        ((((((((v1 - v0) * ((((((6.0_f64 * a0) * x1) - ((6.0_f64 * a0) * x0)) + { let a = v1; let p = a; let p = p * p; p }) + ((4.0_f64 * v0) * v1)) + (4.0_f64 * { let a = v0; let p = a; let p = p * p; p })).sqrt()) - ((3.0_f64 * a0) * x1)) + ((3.0_f64 * a0) * x0)) + { let a = v1; let p = a; let p = p * p; p }) + (v0 * v1)) - (2.0_f64 * { let a = v0; let p = a; let p = p * p; p })) / ((3.0_f64 * x1) - (3.0_f64 * x0))),
    ];
    "pvt::arrival_last" [x0, v0, x1, v1, a0] => [
        ((-((6.0_f64 * x1) - (6.0_f64 * x0))) / ((((((((6.0_f64 * a0) * x1) - ((6.0_f64 * a0) * x0)) + { let a = v1; let p = a; let p = p * p; p }) + ((4.0_f64 * v0) * v1)) + (4.0_f64 * { let a = v0; let p = a; let p = p * p; p })).sqrt() - v1) - (2.0_f64 * v0))),
        ((-(((((((v1 - v0) * ((((((6.0_f64 * a0) * x1) - ((6.0_f64 * a0) * x0)) + { let a = v1; let p = a; let p = p * p; p }) + ((4.0_f64 * v0) * v1)) + (4.0_f64 * { let a = v0; let p = a; let p = p * p; p })).sqrt()) + ((3.0_f64 * a0) * x1)) - ((3.0_f64 * a0) * x0)) - { let a = v1; let p = a; let p = p * p; p }) - (v0 * v1)) + (2.0_f64 * { let a = v0; let p = a; let p = p * p; p }))) / ((3.0_f64 * x1) - (3.0_f64 * x0))),
    ];
    "pvt::turn_out" [v0, a1] => [
        ((-(2.0_f64 * v0)) / a1),
        ((-(4.0_f64 * { let a = v0; let p = a; let p = p * p; p })) / (3.0_f64 * a1)),
    ];
    "pvt::min_jerk_segment" [x0, v0, x1, v1, ai, af] => [
        (((2.0_f64 * v1) - (2.0_f64 * v0)) / (ai + af)),
        (((((((((3.0_f64 * { let a = ai; let p = a; let p = p * p; p }) + ((6.0_f64 * af) * ai)) + (3.0_f64 * { let a = af; let p = a; let p = p * p; p })) * x1) + (((((-3.0_f64) * { let a = ai; let p = a; let p = p * p; p }) - ((6.0_f64 * af) * ai)) - (3.0_f64 * { let a = af; let p = a; let p = p * p; p })) * x0)) + ((((-4.0_f64) * ai) - (2.0_f64 * af)) * { let a = v1; let p = a; let p = p * p; p })) + ((((2.0_f64 * ai) - (2.0_f64 * af)) * v0) * v1)) + (((2.0_f64 * ai) + (4.0_f64 * af)) * { let a = v0; let p = a; let p = p * p; p })) / (((2.0_f64 * { let a = v1; let p = a; let p = p * p; p }) - ((4.0_f64 * v0) * v1)) + (2.0_f64 * { let a = v0; let p = a; let p = p * p; p }))),
    ];
    "pvt::constant_acceleration" [v0, d_v, t1] => [
        (d_v / t1),
        ((((2.0_f64 * t1) * v0) + (d_v * t1)) / 2.0_f64),
    ];
    "return_path::asymmetric_return" [a1_max, t_edge, t_out, a3, v3, d1_out] => [
        ((-(((((((((4.0_f64 * { let a = v3; let p = a; let p = p * p; p }) - (((4.0_f64 * a3) * t_out) * v3)) - (((6.0_f64 * a1_max) * t_out) * v3)) - (((4.0_f64 * a1_max) * t_edge) * v3)) + ({ let a = a3; let p = a; let p = p * p; p } * { let a = t_out; let p = a; let p = p * p; p })) + (((2.0_f64 * a1_max) * a3) * { let a = t_out; let p = a; let p = p * p; p })) + ((((2.0_f64 * a1_max) * a3) * t_edge) * t_out)) - ({ let a = a1_max; let p = a; let p = p * p; p } * { let a = t_edge; let p = a; let p = p * p; p })) + ((6.0_f64 * a1_max) * d1_out))) / ((((((2.0_f64 * t_out) * v3) + (a1_max * { let a = t_out; let p = a; let p = p * p; p })) + (((2.0_f64 * a1_max) * t_edge) * t_out)) + (a1_max * { let a = t_edge; let p = a; let p = p * p; p })) - (6.0_f64 * d1_out))),
        (((((((((4.0_f64 * t_out) * v3) + ((2.0_f64 * t_edge) * v3)) - (a3 * { let a = t_out; let p = a; let p = p * p; p })) - ((a3 * t_edge) * t_out)) - ((a1_max * t_edge) * t_out)) - (a1_max * { let a = t_edge; let p = a; let p = p * p; p })) - (6.0_f64 * d1_out)) / ((((2.0_f64 * v3) - (a3 * t_out)) - (a1_max * t_out)) - ((2.0_f64 * a1_max) * t_edge))),
        ((a1_max * { let a = ((((((((4.0_f64 * t_out) * v3) + ((2.0_f64 * t_edge) * v3)) - (a3 * { let a = t_out; let p = a; let p = p * p; p })) - ((a3 * t_edge) * t_out)) - ((a1_max * t_edge) * t_out)) - (a1_max * { let a = t_edge; let p = a; let p = p * p; p })) - (6.0_f64 * d1_out)); let p = a; let p = p * p; p }) / (6.0_f64 * { let a = ((((2.0_f64 * v3) - (a3 * t_out)) - (a1_max * t_out)) - ((2.0_f64 * a1_max) * t_edge)); let p = a; let p = p * p; p })),
        ((-({ let a = (((((4.0_f64 * t_out) * v3) - (a3 * { let a = t_out; let p = a; let p = p * p; p })) + (a1_max * { let a = t_edge; let p = a; let p = p * p; p })) - (6.0_f64 * d1_out)); let p = a; let p = p * p; p } * (((((((((((4.0_f64 * { let a = v3; let p = a; let p = p * p; p }) - (((4.0_f64 * a3) * t_out) * v3)) - (((2.0_f64 * a1_max) * t_out) * v3)) - (((4.0_f64 * a1_max) * t_edge) * v3)) + ({ let a = a3; let p = a; let p = p * p; p } * { let a = t_out; let p = a; let p = p * p; p })) + (((2.0_f64 * a1_max) * a3) * { let a = t_out; let p = a; let p = p * p; p })) + ((2.0_f64 * { let a = a1_max; let p = a; let p = p * p; p }) * { let a = t_out; let p = a; let p = p * p; p })) + ((((2.0_f64 * a1_max) * a3) * t_edge) * t_out)) + (((4.0_f64 * { let a = a1_max; let p = a; let p = p * p; p }) * t_edge) * t_out)) + ({ let a = a1_max; let p = a; let p = p * p; p } * { let a = t_edge; let p = a; let p = p * p; p })) - ((6.0_f64 * a1_max) * d1_out)))) / ((6.0_f64 * { let a = ((((2.0_f64 * v3) - (a3 * t_out)) - (a1_max * t_out)) - ((2.0_f64 * a1_max) * t_edge)); let p = a; let p = p * p; p }) * ((((((2.0_f64 * t_out) * v3) + (a1_max * { let a = t_out; let p = a; let p = p * p; p })) + (((2.0_f64 * a1_max) * t_edge) * t_out)) + (a1_max * { let a = t_edge; let p = a; let p = p * p; p })) - (6.0_f64 * d1_out)))),
        (((((2.0_f64 * v3) - (a3 * t_out)) - (a1_max * t_out)) * (((((4.0_f64 * t_out) * v3) - (a3 * { let a = t_out; let p = a; let p = p * p; p })) + (a1_max * { let a = t_edge; let p = a; let p = p * p; p })) - (6.0_f64 * d1_out))) / (2.0_f64 * ((((((2.0_f64 * t_out) * v3) + (a1_max * { let a = t_out; let p = a; let p = p * p; p })) + (((2.0_f64 * a1_max) * t_edge) * t_out)) + (a1_max * { let a = t_edge; let p = a; let p = p * p; p })) - (6.0_f64 * d1_out)))),
    ];
    "s_curve::ramp" [dv, a_max, j_max] => [
        (a_max / j_max),
        ((dv / a_max) - (a_max / j_max)),
    ];
    "s_curve::pointed_ramp" [dv, j_max] => [
        (dv.sqrt() / j_max.sqrt()),
    ];
    "s_curve::full_move" [d, v_max, a_max, j_max] => [
        (a_max / j_max),
        ((v_max / a_max) - (a_max / j_max)),
        ((((-v_max) / a_max) + (d / v_max)) - (a_max / j_max)),
    ];
    "s_curve::flat_move" [d, a_max, j_max] => [
        (a_max / j_max),
        (((((4.0_f64 * d) * { let a = j_max; let p = a; let p = p * p; p }) + { let a = a_max; let p = a; let p = p * p * a; p }).sqrt() / ((2.0_f64 * a_max.sqrt()) * j_max)) - ((3.0_f64 * a_max) / (2.0_f64 * j_max))),
        (((a_max.sqrt() * (((4.0_f64 * d) * { let a = j_max; let p = a; let p = p * p; p }) + { let a = a_max; let p = a; let p = p * p * a; p }).sqrt()) / (2.0_f64 * j_max)) - ({ let a = a_max; let p = a; let p = p * p; p } / (2.0_f64 * j_max))),
    ];
    "s_curve::fast_move" [d, v_max, j_max] => [
        (v_max.sqrt() / j_max.sqrt()),
        ((d / v_max) - ((2.0_f64 * v_max.sqrt()) / j_max.sqrt())),
    ];
    "s_curve::flat_rise" [v, w, d, a_max, j_max] => [
        (((((((((((2.0_f64 * { let a = j_max; let p = a; let p = p * p; p }) * { let a = w; let p = a; let p = p * p; p }) - (((4.0_f64 * { let a = j_max; let p = a; let p = p * p; p }) * v) * w)) + (((2.0_f64 * { let a = a_max; let p = a; let p = p * p; p }) * j_max) * w)) + ((4.0_f64 * { let a = j_max; let p = a; let p = p * p; p }) * { let a = v; let p = a; let p = p * p; p })) - (((4.0_f64 * { let a = a_max; let p = a; let p = p * p; p }) * j_max) * v)) + (((4.0_f64 * a_max) * d) * { let a = j_max; let p = a; let p = p * p; p })) + { let a = a_max; let p = a; let p = p * p; let p = p * p; p }).sqrt() / (2.0_f64 * j_max)) - v) - ({ let a = a_max; let p = a; let p = p * p; p } / (2.0_f64 * j_max))),
    ];
    "s_curve::trapezoid" [v0, v1, d, v_max, a_max] => [
        ((v_max - v0) / a_max),
        ((-((((2.0_f64 * { let a = v_max; let p = a; let p = p * p; p }) - { let a = v1; let p = a; let p = p * p; p }) - { let a = v0; let p = a; let p = p * p; p }) - ((2.0_f64 * a_max) * d))) / ((2.0_f64 * a_max) * v_max)),
        ((v_max - v1) / a_max),
    ];
    "s_curve::triangle_rise" [v, w, d, a_max] => [
        (((({ let a = (v - w); let p = a; let p = p * p; p } + { let a = v; let p = a; let p = p * p; p }) + ((2.0_f64 * a_max) * d)).sqrt() / 2.0_f64.sqrt()) - v),
    ];
    "s_curve::trapezoid_at_rest" [d, v_max, a_max] => [
        (v_max / a_max),
        ((d / v_max) - (v_max / a_max)),
    ];
    "s_curve::triangle_at_rest" [d, a_max] => [
        (d.sqrt() / a_max.sqrt()),
    ];
    "step_move::ramp_from_rest" [x0, v0] => [
        ((3.0_f64 * x0) / v0),
        ((2.0_f64 * { let a = v0; let p = a; let p = p * p; p }) / (3.0_f64 * x0)),
    ];
    "step_move::quarter_move" [x4, a3, t1] => [
        ((6.0_f64.sqrt() * ((-a3) * x4).sqrt()) / 4.0_f64),
        ((-(((6.0_f64.sqrt() * t1) * ((-a3) * x4).sqrt()) - (6.0_f64 * x4))) / (20.0_f64 * t1)),
        ((-(((((3.0_f64 * 6.0_f64.sqrt()) * t1) * ((-a3) * x4).sqrt()) - (3.0_f64 * x4)) - ((5.0_f64 * a3) * { let a = t1; let p = a; let p = p * p; p }))) / (5.0_f64 * { let a = t1; let p = a; let p = p * p; p })),
        ((-(((((9.0_f64 * 6.0_f64.sqrt()) * t1) * ((-a3) * x4).sqrt()) - (39.0_f64 * x4)) - ((10.0_f64 * a3) * { let a = t1; let p = a; let p = p * p; p }))) / 60.0_f64),
        ((6.0_f64.sqrt() * x4) / (2.0_f64 * ((-a3) * x4).sqrt())),
    ];
    "step_move::continuous_move" [ki, ko] => [
        ((-((((3.0_f64 * ((((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) + (2.0_f64 * ki)) * { let a = ko; let p = a; let p = p * p; p }) + (((((-6.0_f64) * { let a = ki; let p = a; let p = p * p * a; p }) + (14.0_f64 * { let a = ki; let p = a; let p = p * p; p })) - (4.0_f64 * ki)) * ko)).sqrt()) + ((6.0_f64 * ki) * ko)) + (15.0_f64 * { let a = ki; let p = a; let p = p * p; p })) - (30.0_f64 * ki))) / ((2.0_f64 * ko) + (50.0_f64 * ki))),
        ((((15.0_f64 * ((((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) + (2.0_f64 * ki)) * { let a = ko; let p = a; let p = p * p; p }) + (((((-6.0_f64) * { let a = ki; let p = a; let p = p * p * a; p }) + (14.0_f64 * { let a = ki; let p = a; let p = p * p; p })) - (4.0_f64 * ki)) * ko)).sqrt()) - (3.0_f64 * { let a = ko; let p = a; let p = p * p; p })) + ((6.0_f64 - (48.0_f64 * ki)) * ko)) / ((2.0_f64 * ko) + (50.0_f64 * ki))),
        ((-(((5.0_f64 * ((((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) + (2.0_f64 * ki)) * { let a = ko; let p = a; let p = p * p; p }) + (((((-6.0_f64) * { let a = ki; let p = a; let p = p * p * a; p }) + (14.0_f64 * { let a = ki; let p = a; let p = p * p; p })) - (4.0_f64 * ki)) * ko)).sqrt()) + { let a = ko; let p = a; let p = p * p; p }) + (((16.0_f64 * ki) - 2.0_f64) * ko))) / (((({ let a = ko; let p = a; let p = p * p; p } + (((7.0_f64 * ki) - 4.0_f64) * ko)) + (6.0_f64 * { let a = ki; let p = a; let p = p * p; p })) - (14.0_f64 * ki)) + 4.0_f64)),
        ((((((((((12.0_f64 * ko) + (30.0_f64 * ki)) - 60.0_f64) * ((((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) + (2.0_f64 * ki)) * { let a = ko; let p = a; let p = p * p; p }) + (((((-6.0_f64) * { let a = ki; let p = a; let p = p * p * a; p }) + (14.0_f64 * { let a = ki; let p = a; let p = p * p; p })) - (4.0_f64 * ki)) * ko)).sqrt()) + (((21.0_f64 * ki) + 6.0_f64) * { let a = ko; let p = a; let p = p * p; p })) + ((((42.0_f64 * { let a = ki; let p = a; let p = p * p; p }) - (78.0_f64 * ki)) - 12.0_f64) * ko)) + (75.0_f64 * { let a = ki; let p = a; let p = p * p * a; p })) - (300.0_f64 * { let a = ki; let p = a; let p = p * p; p })) + (300.0_f64 * ki)) / (({ let a = ko; let p = a; let p = p * p; p } + ((50.0_f64 * ki) * ko)) + (625.0_f64 * { let a = ki; let p = a; let p = p * p; p }))),
        ((-((((((((((30.0_f64 * ko) + (480.0_f64 * ki)) - 60.0_f64) * ((((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) + (2.0_f64 * ki)) * { let a = ko; let p = a; let p = p * p; p }) + (((((-6.0_f64) * { let a = ki; let p = a; let p = p * p * a; p }) + (14.0_f64 * { let a = ki; let p = a; let p = p * p; p })) - (4.0_f64 * ki)) * ko)).sqrt()) - (3.0_f64 * { let a = ko; let p = a; let p = p * p * a; p })) + ((12.0_f64 - (96.0_f64 * ki)) * { let a = ko; let p = a; let p = p * p; p })) + (((((-993.0_f64) * { let a = ki; let p = a; let p = p * p; p }) + (42.0_f64 * ki)) - 12.0_f64) * ko)) + (450.0_f64 * { let a = ki; let p = a; let p = p * p * a; p })) - (1050.0_f64 * { let a = ki; let p = a; let p = p * p; p })) + (300.0_f64 * ki))) / (({ let a = ko; let p = a; let p = p * p; p } + ((50.0_f64 * ki) * ko)) + (625.0_f64 * { let a = ki; let p = a; let p = p * p; p }))),
        (((((((((ko - (65.0_f64 * ki)) - 20.0_f64) * ((((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) + (2.0_f64 * ki)) * { let a = ko; let p = a; let p = p * p; p }) + (((((-6.0_f64) * { let a = ki; let p = a; let p = p * p * a; p }) + (14.0_f64 * { let a = ki; let p = a; let p = p * p; p })) - (4.0_f64 * ki)) * ko)).sqrt()) + (((2.0_f64 * ki) + 2.0_f64) * { let a = ko; let p = a; let p = p * p; p })) + (((((-101.0_f64) * { let a = ki; let p = a; let p = p * p; p }) + (4.0_f64 * ki)) - 4.0_f64) * ko)) + (275.0_f64 * { let a = ki; let p = a; let p = p * p * a; p })) + (650.0_f64 * { let a = ki; let p = a; let p = p * p; p })) + (100.0_f64 * ki)) / (((2.0_f64 * { let a = ko; let p = a; let p = p * p; p }) + ((100.0_f64 * ki) * ko)) + (1250.0_f64 * { let a = ki; let p = a; let p = p * p; p }))),
    ];
    "step_move::symmetric_frame" [ki] => [
        ((-(2.0_f64 * ki)) / (ki - 1.0_f64)),
        ((-(({ let a = ki; let p = a; let p = p * p; p } - (4.0_f64 * ki)) - 1.0_f64)) / (8.0_f64 * ki)),
        ((-((3.0_f64 * ki) - 3.0_f64)) / 4.0_f64),
        ((-(((9.0_f64 * { let a = ki; let p = a; let p = p * p; p }) - (12.0_f64 * ki)) + 3.0_f64)) / ((4.0_f64 * ki) + 4.0_f64)),
        ((((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) - (6.0_f64 * ki)) + 3.0_f64) / (4.0_f64 * ki)),
        (((((9.0_f64 * { let a = ki; let p = a; let p = p * p * a; p }) - (21.0_f64 * { let a = ki; let p = a; let p = p * p; p })) + (15.0_f64 * ki)) - 3.0_f64) / ((4.0_f64 * { let a = ki; let p = a; let p = p * p; p }) + (4.0_f64 * ki))),
        (((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) - ki) / (ki + 1.0_f64)),
    ];
    "step_move::symmetric_frame_step" [ki, t_out, d2_step] => [
        ((-((2.0_f64 * ki) * t_out)) / (ki - 1.0_f64)),
        ((ki * d2_step) / 2.0_f64),
        ((-((({ let a = ki; let p = a; let p = p * p; p } - (4.0_f64 * ki)) - 1.0_f64) * d2_step)) / (8.0_f64 * ki)),
        ((1.0_f64 - (((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) - ki) / (2.0_f64 * (ki + 1.0_f64)))) * d2_step),
        ((-(((3.0_f64 * ki) - 3.0_f64) * d2_step)) / (4.0_f64 * t_out)),
        ((-((((9.0_f64 * { let a = ki; let p = a; let p = p * p; p }) - (12.0_f64 * ki)) + 3.0_f64) * d2_step)) / (((4.0_f64 * ki) + 4.0_f64) * t_out)),
        (((((3.0_f64 * { let a = ki; let p = a; let p = p * p; p }) - (6.0_f64 * ki)) + 3.0_f64) * d2_step) / ((4.0_f64 * ki) * { let a = t_out; let p = a; let p = p * p; p })),
        ((-(((((9.0_f64 * { let a = ki; let p = a; let p = p * p * a; p }) - (21.0_f64 * { let a = ki; let p = a; let p = p * p; p })) + (15.0_f64 * ki)) - 3.0_f64) * d2_step)) / (((4.0_f64 * { let a = ki; let p = a; let p = p * p; p }) + (4.0_f64 * ki)) * { let a = t_out; let p = a; let p = p * p; p })),
    ];
    "step_move::ki_of_t_ie_skip" [t_ie_skip, t_out] => [
        (t_ie_skip / ((2.0_f64 * t_out) + t_ie_skip)),
    ];
    "step_move::ki_of_v1_diff" [v1_diff, v1_out] => [
        (v1_diff / ((2.0_f64 * v1_out) + v1_diff)),
    ];
    "turnaround::outer_ramp" [t2, t3, a0, delta_x] => [
        ((((((((4.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t3; let p = a; let p = p * p; p }) + (((12.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * t2) * t3)) + ((9.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p })) + ((48.0_f64 * delta_x) * a0)).sqrt() - ((6.0_f64 * a0) * t3)) - ((3.0_f64 * a0) * t2)) / (4.0_f64 * a0)),
        ((((((((4.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t3; let p = a; let p = p * p; p }) + (((12.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * t2) * t3)) + ((9.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p })) + ((48.0_f64 * delta_x) * a0)).sqrt() - ((6.0_f64 * a0) * t3)) - ((3.0_f64 * a0) * t2)) / 8.0_f64),
        ((((((((2.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * t2) * { let a = t3; let p = a; let p = p * p * a; p }) + ((((((4.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t3; let p = a; let p = p * p; p }) + (((12.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * t2) * t3)) + ((9.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p })) + ((48.0_f64 * delta_x) * a0)).sqrt() * (((a0 * t2) * { let a = t3; let p = a; let p = p * p; p }) - ((6.0_f64 * delta_x) * t3)))) + ((((3.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) + ((20.0_f64 * delta_x) * a0)) * { let a = t3; let p = a; let p = p * p; p })) - ((((6.0_f64 * delta_x) * a0) * t2) * t3)) + (24.0_f64 * { let a = delta_x; let p = a; let p = p * p; p })) / (((((12.0_f64 * delta_x) * a0) * t2) * t3) + (24.0_f64 * { let a = delta_x; let p = a; let p = p * p; p }))),
    ];
    "turnaround::inner_ramp" [t0, t2, a0, delta_x] => [
        ((((((((9.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) - (((12.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * t0) * t2)) + ((4.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t0; let p = a; let p = p * p; p })) + ((96.0_f64 * delta_x) * a0)).sqrt() - ((3.0_f64 * a0) * t2)) - ((6.0_f64 * a0) * t0)) / (8.0_f64 * a0)),
        ((a0 * t0) / 2.0_f64),
        ((-((((((a0 * { let a = t0; let p = a; let p = p * p; p }) * t2) * (((((9.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) - (((12.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * t0) * t2)) + ((4.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t0; let p = a; let p = p * p; p })) + ((96.0_f64 * delta_x) * a0)).sqrt()) + (((3.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t0; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p })) - (((2.0_f64 * { let a = a0; let p = a; let p = p * p; p }) * { let a = t0; let p = a; let p = p * p * a; p }) * t2)) + (((16.0_f64 * delta_x) * a0) * { let a = t0; let p = a; let p = p * p; p }))) / (((((12.0_f64 * delta_x) * a0) * t0) * t2) - (48.0_f64 * { let a = delta_x; let p = a; let p = p * p; p }))),
    ];
    "turnaround::t_in" [t_out, t_edge_total, a2_max, d2_step] => [
        (((((({ let a = t_out; let p = a; let p = p * p; p } / 4.0_f64) + (((3.0_f64 * t_edge_total) * t_out) / 4.0_f64)) + ((9.0_f64 * { let a = t_edge_total; let p = a; let p = p * p; p }) / 16.0_f64)) + ((3.0_f64 * d2_step) / a2_max)).sqrt() - ((3.0_f64 * t_out) / 2.0_f64)) - ((3.0_f64 * t_edge_total) / 4.0_f64)),
    ];
    "turnaround::ramp_in" [a2_max, t_in] => [
        ((a2_max * { let a = t_in; let p = a; let p = p * p; p }) / 6.0_f64),
        ((a2_max * t_in) / 2.0_f64),
    ];
    "turnaround::ramp_out" [a2_max, t_in, t_out] => [
        (((a2_max * t_out) * ((2.0_f64 * t_out) + (3.0_f64 * t_in))) / 6.0_f64),
        ((a2_max * (t_out + t_in)) / 2.0_f64),
    ];
    "turnaround::t_in_of_d2_in" [d2_in, a2_max] => [
        ((6.0_f64.sqrt() * d2_in.sqrt()) / a2_max.sqrt()),
    ];
    "turnaround::a2_max_of_d2_in" [d2_in, t_in] => [
        ((6.0_f64 * d2_in) / { let a = t_in; let p = a; let p = p * p; p }),
    ];
    "turnaround::t_in_of_tau" [tau, delta, t_ef_skip] => [
        ((({ let a = tau; let p = a; let p = p * p; p } + (3.0_f64 * delta)).sqrt() - (3.0_f64 * tau)) + ((3.0_f64 * t_ef_skip) / 2.0_f64)),
    ];
    "turnaround::tau_of_t_in" [t_in, t_ef_skip, delta] => [
        (((((((4.0_f64 * { let a = t_in; let p = a; let p = p * p; p }) - ((12.0_f64 * t_ef_skip) * t_in)) + (9.0_f64 * { let a = t_ef_skip; let p = a; let p = p * p; p })) + (96.0_f64 * delta)).sqrt() - (6.0_f64 * t_in)) + (9.0_f64 * t_ef_skip)) / 16.0_f64),
    ];
    "turnaround::tau_without_skip" [t_in, delta] => [
        ((({ let a = t_in; let p = a; let p = p * p; p } + (24.0_f64 * delta)).sqrt() - (3.0_f64 * t_in)) / 8.0_f64),
    ];
    "turnaround::delta_of_tau" [tau, t_in, t_ef_skip] => [
        (((((4.0_f64 * tau) + (2.0_f64 * t_in)) - (3.0_f64 * t_ef_skip)) * (((8.0_f64 * tau) + (2.0_f64 * t_in)) - (3.0_f64 * t_ef_skip))) / 12.0_f64),
    ];
    "turnaround::delta_of_t_edge" [t_out, t_in, t_edge, t_ef_skip] => [
        (((((2.0_f64 * t_out) + (2.0_f64 * t_in)) + t_edge) * ((((4.0_f64 * t_out) + (2.0_f64 * t_in)) + (2.0_f64 * t_edge)) + (3.0_f64 * t_ef_skip))) / 12.0_f64),
    ];
    "turnaround::t_edge_of_t_in" [t_in, t_out, delta] => [
        (((({ let a = t_in; let p = a; let p = p * p; p } + (24.0_f64 * delta)).sqrt() - (3.0_f64 * t_in)) / 2.0_f64) - (2.0_f64 * t_out)),
    ];
    "turnaround::a2_max_of_tau" [d2_step, tau, t_in] => [
        ((3.0_f64 * d2_step) / (((2.0_f64 * tau) + t_in) * ((4.0_f64 * tau) + t_in))),
    ];
    "turnaround::da2_max_dtau" [d2_step, tau, t_in] => [
        ((-((6.0_f64 * d2_step) * ((8.0_f64 * tau) + (3.0_f64 * t_in)))) / ({ let a = ((2.0_f64 * tau) + t_in); let p = a; let p = p * p; p } * { let a = ((4.0_f64 * tau) + t_in); let p = a; let p = p * p; p })),
    ];
    "turnaround::dtau_da2_max" [d2_step, t_out, t_edge, t_in] => [
        ((-({ let a = (((2.0_f64 * t_out) + t_in) + t_edge); let p = a; let p = p * p; p } * { let a = (((2.0_f64 * t_out) + (2.0_f64 * t_in)) + t_edge); let p = a; let p = p * p; p })) / ((24.0_f64 * d2_step) * (((4.0_f64 * t_out) + (3.0_f64 * t_in)) + (2.0_f64 * t_edge)))),
    ];
    "turnaround::k_of_t_in" [t_in, t_ef_skip, delta] => [
        ((-(((((t_ef_skip * { let a = t_in; let p = a; let p = p * p; p }) * ((((4.0_f64 * { let a = t_in; let p = a; let p = p * p; p }) - ((12.0_f64 * t_ef_skip) * t_in)) + (9.0_f64 * { let a = t_ef_skip; let p = a; let p = p * p; p })) + (96.0_f64 * delta)).sqrt()) - ((2.0_f64 * t_ef_skip) * { let a = t_in; let p = a; let p = p * p * a; p })) + ((3.0_f64 * { let a = t_ef_skip; let p = a; let p = p * p; p }) * { let a = t_in; let p = a; let p = p * p; p })) + ((16.0_f64 * delta) * { let a = t_in; let p = a; let p = p * p; p }))) / ((((12.0_f64 * delta) * t_ef_skip) * t_in) - (48.0_f64 * { let a = delta; let p = a; let p = p * p; p }))),
    ];
    "waypoints::segment_2d" [x0, y0, x1, y1, v] => [
        ({ let a = (y1 - y0); let p = a; let p = p * p; p } + { let a = (x1 - x0); let p = a; let p = p * p; p }).sqrt(),
        (({ let a = (y1 - y0); let p = a; let p = p * p; p } + { let a = (x1 - x0); let p = a; let p = p * p; p }).sqrt() / v),
    ];
    "waypoints::segment_3d" [x0, y0, z0, x1, y1, z1, v] => [
        (({ let a = (z1 - z0); let p = a; let p = p * p; p } + { let a = (y1 - y0); let p = a; let p = p * p; p }) + { let a = (x1 - x0); let p = a; let p = p * p; p }).sqrt(),
        ((({ let a = (z1 - z0); let p = a; let p = p * p; p } + { let a = (y1 - y0); let p = a; let p = p * p; p }) + { let a = (x1 - x0); let p = a; let p = p * p; p }).sqrt() / v),
    ];
    "waypoints::linear" [p0, p1, p2, p3, t0, t1, t2] => [
        p0,
        p1,
        p2,
        ((p1 - p0) / t0),
        ((p2 - p1) / t1),
        ((p3 - p2) / t2),
    ];
    "waypoints::quadratic_linear_quadratic" [p0, p1, p2, p3, t0, t1, t2] => [
        p0,
        p1,
        p2,
        ((p2 - p1) / t1),
        ((p2 - p1) / t1),
        ((((2.0_f64 * (p1 - p0)) * t1) - ((p2 - p1) * t0)) / (t0 * t1)),
        ((((p2 - p1) * t0) - ((p1 - p0) * t1)) / ({ let a = t0; let p = a; let p = p * p; p } * t1)),
        ((((p3 - p2) * t1) - ((p2 - p1) * t2)) / (t1 * { let a = t2; let p = a; let p = p * p; p })),
    ];
    "waypoints::quadratic_cubic_quadratic_at_rest" [p0, p1, p2, p3, t0, t1, t2] => [
        p0,
        p1,
        p2,
        0.0_f64,
        ((p1 - p0) / { let a = t0; let p = a; let p = p * p; p }),
        ((2.0_f64 * (p1 - p0)) / t0),
        ((2.0_f64 * (p3 - p2)) / t2),
        ((p2 - p3) / { let a = t2; let p = a; let p = p * p; p }),
        (((((((-4.0_f64) * (p1 - p0)) * t1) * t2) + (((3.0_f64 * (p2 - p1)) * t0) * t2)) - (((2.0_f64 * (p3 - p2)) * t0) * t1)) / ((t0 * { let a = t1; let p = a; let p = p * p; p }) * t2)),
        ((((((2.0_f64 * (p1 - p0)) * t1) * t2) - (((2.0_f64 * (p2 - p1)) * t0) * t2)) + (((2.0_f64 * (p3 - p2)) * t0) * t1)) / ((t0 * { let a = t1; let p = a; let p = p * p * a; p }) * t2)),
    ];
    "waypoints::quadratic_cubic_quadratic" [p0, p1, p2, p3, t0, t1, t2] => [
        p0,
        p1,
        p2,
        (((((((-(p1 - p0)) * t1) * t2) * ((3.0_f64 * t2) + (2.0_f64 * t1))) + ((((3.0_f64 * (p2 - p1)) * t0) * t2) * (t2 + t1))) - (((p3 - p2) * t0) * { let a = t1; let p = a; let p = p * p; p })) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + ((2.0_f64 * t0) * t1)))),
        (((((((-(p1 - p0)) * t1) * t2) * ((3.0_f64 * t2) + (2.0_f64 * t1))) + ((((3.0_f64 * (p2 - p1)) * t0) * t2) * (t2 + t1))) - (((p3 - p2) * t0) * { let a = t1; let p = a; let p = p * p; p })) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + ((2.0_f64 * t0) * t1)))),
        ((((((p1 - p0) * { let a = t1; let p = a; let p = p * p; p }) * t2) - ((((3.0_f64 * (p2 - p1)) * t0) * (t1 + t0)) * t2)) + ((((p3 - p2) * t0) * t1) * ((2.0_f64 * t1) + (3.0_f64 * t0)))) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + ((2.0_f64 * t0) * t1)))),
        (((((((p1 - p0) * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((6.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + ((4.0_f64 * t0) * t1))) - ((((3.0_f64 * (p2 - p1)) * { let a = t0; let p = a; let p = p * p; p }) * t2) * (t2 + t1))) + (((p3 - p2) * { let a = t0; let p = a; let p = p * p; p }) * { let a = t1; let p = a; let p = p * p; p })) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + ((2.0_f64 * t0) * t1)))),
        (((((((p1 - p0) * { let a = t1; let p = a; let p = p * p; p }) * t2) * ((2.0_f64 * t2) + t1)) + ((((3.0_f64 * (p2 - p1)) * { let a = t0; let p = a; let p = p * p; p }) * t2) * (t2 + t1))) - (((p3 - p2) * { let a = t0; let p = a; let p = p * p; p }) * { let a = t1; let p = a; let p = p * p; p })) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + ((2.0_f64 * t0) * t1)))),
        ((((((-(p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) + ((((3.0_f64 * (p2 - p1)) * t0) * (t1 + t0)) * { let a = t2; let p = a; let p = p * p; p })) + ((((p3 - p2) * t0) * { let a = t1; let p = a; let p = p * p; p }) * (t1 + (2.0_f64 * t0)))) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + ((2.0_f64 * t0) * t1)))),
        (((((((-(p2 - p1)) * t0) * t2) * ((t2 + (2.0_f64 * t1)) + t0)) + ((((p1 - p0) * t1) * t2) * (t2 + t1))) + ((((p3 - p2) * t0) * t1) * (t1 + t0))) / (((t0 * { let a = t1; let p = a; let p = p * p; p }) * t2) * (((((2.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + ((2.0_f64 * t0) * t1)))),
    ];
    "waypoints::cubics_at_rest" [p0, p1, p2, p3, t0, t1, t2] => [
        p0,
        p1,
        p2,
        0.0_f64,
        (((((((3.0_f64 * (p2 - p1)) * { let a = t0; let p = a; let p = p * p; p }) * t2) * (t2 + (2.0_f64 * t1))) + ((((6.0_f64 * (p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * t2) * (t2 + t1))) - (((3.0_f64 * (p3 - p2)) * { let a = t0; let p = a; let p = p * p; p }) * { let a = t1; let p = a; let p = p * p; p })) / (((t0 * t1) * t2) * (((((4.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (4.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1)))),
        (((((((-3.0_f64) * (p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) + ((((3.0_f64 * (p2 - p1)) * t0) * ((2.0_f64 * t1) + t0)) * { let a = t2; let p = a; let p = p * p; p })) + ((((6.0_f64 * (p3 - p2)) * t0) * { let a = t1; let p = a; let p = p * p; p }) * (t1 + t0))) / (((t0 * t1) * t2) * (((((4.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (4.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1)))),
        (((((((3.0_f64 * (p1 - p0)) * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (2.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1))) - ((((3.0_f64 * (p2 - p1)) * { let a = t0; let p = a; let p = p * p; p }) * t2) * (t2 + (2.0_f64 * t1)))) + (((3.0_f64 * (p3 - p2)) * { let a = t0; let p = a; let p = p * p; p }) * { let a = t1; let p = a; let p = p * p; p })) / ((({ let a = t0; let p = a; let p = p * p; p } * t1) * t2) * (((((4.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (4.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1)))),
        ((((((((-3.0_f64) * (p1 - p0)) * t1) * t2) * ((3.0_f64 * t2) + (4.0_f64 * t1))) + ((((6.0_f64 * (p2 - p1)) * t0) * t2) * (t2 + (2.0_f64 * t1)))) - (((6.0_f64 * (p3 - p2)) * t0) * { let a = t1; let p = a; let p = p * p; p })) / (((t0 * t1) * t2) * (((((4.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (4.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1)))),
        ((((((6.0_f64 * (p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * t2) - ((((6.0_f64 * (p2 - p1)) * t0) * ((2.0_f64 * t1) + t0)) * t2)) + ((((3.0_f64 * (p3 - p2)) * t0) * t1) * ((4.0_f64 * t1) + (3.0_f64 * t0)))) / (((t0 * t1) * t2) * (((((4.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (4.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1)))),
        ((((((((-2.0_f64) * (p1 - p0)) * t1) * t2) * ((((t1 * t2) + ((3.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + ((4.0_f64 * t0) * t1))) + ((((3.0_f64 * (p2 - p1)) * { let a = t0; let p = a; let p = p * p; p }) * t2) * (t2 + (2.0_f64 * t1)))) - (((3.0_f64 * (p3 - p2)) * { let a = t0; let p = a; let p = p * p; p }) * { let a = t1; let p = a; let p = p * p; p })) / ((({ let a = t0; let p = a; let p = p * p * a; p } * t1) * t2) * (((((4.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (4.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1)))),
        ((((((((-2.0_f64) * (p2 - p1)) * t0) * t2) * ((t2 + (4.0_f64 * t1)) + t0)) + ((((3.0_f64 * (p1 - p0)) * t1) * t2) * (t2 + (2.0_f64 * t1)))) + ((((3.0_f64 * (p3 - p2)) * t0) * t1) * ((2.0_f64 * t1) + t0))) / (((t0 * { let a = t1; let p = a; let p = p * p; p }) * t2) * (((((4.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (4.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1)))),
        (((((((-3.0_f64) * (p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) + ((((3.0_f64 * (p2 - p1)) * t0) * ((2.0_f64 * t1) + t0)) * { let a = t2; let p = a; let p = p * p; p })) - ((((2.0_f64 * (p3 - p2)) * t0) * t1) * (((((4.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + { let a = t1; let p = a; let p = p * p; p }) + (t0 * t1)))) / (((t0 * t1) * { let a = t2; let p = a; let p = p * p * a; p }) * (((((4.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (4.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1)))),
    ];
    "waypoints::quartic_cubic_quartic_at_rest" [p0, p1, p2, p3, t0, t1, t2] => [
        p0,
        p1,
        p2,
        0.0_f64,
        0.0_f64,
        (((((((2.0_f64 * (p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * t2) * ((2.0_f64 * t2) + (3.0_f64 * t1))) + ((((p2 - p1) * { let a = t0; let p = a; let p = p * p; p }) * t2) * (t2 + (3.0_f64 * t1)))) - (((2.0_f64 * (p3 - p2)) * { let a = t0; let p = a; let p = p * p; p }) * { let a = t1; let p = a; let p = p * p; p })) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + (t0 * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))),
        (((((((-2.0_f64) * (p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) + ((((p2 - p1) * t0) * ((3.0_f64 * t1) + t0)) * { let a = t2; let p = a; let p = p * p; p })) + ((((2.0_f64 * (p3 - p2)) * t0) * { let a = t1; let p = a; let p = p * p; p }) * ((3.0_f64 * t1) + (2.0_f64 * t0)))) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + (t0 * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))),
        (((((((3.0_f64 * (p2 - p1)) * t0) * t2) * (t2 + (3.0_f64 * t1))) - ((((6.0_f64 * (p1 - p0)) * t1) * t2) * (t2 + (2.0_f64 * t1)))) - (((6.0_f64 * (p3 - p2)) * t0) * { let a = t1; let p = a; let p = p * p; p })) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + (t0 * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))),
        ((((((6.0_f64 * (p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * t2) - ((((3.0_f64 * (p2 - p1)) * t0) * ((3.0_f64 * t1) + t0)) * t2)) + ((((6.0_f64 * (p3 - p2)) * t0) * t1) * ((2.0_f64 * t1) + t0))) / (((t0 * t1) * t2) * (((((2.0_f64 * t1) * t2) + (t0 * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))),
        (((((((2.0_f64 * (p1 - p0)) * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((2.0_f64 * t0) * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((4.0_f64 * t0) * t1))) - ((((p2 - p1) * { let a = t0; let p = a; let p = p * p; p }) * t2) * (t2 + (3.0_f64 * t1)))) + (((2.0_f64 * (p3 - p2)) * { let a = t0; let p = a; let p = p * p; p }) * { let a = t1; let p = a; let p = p * p; p })) / ((({ let a = t0; let p = a; let p = p * p * a; p } * t1) * t2) * (((((2.0_f64 * t1) * t2) + (t0 * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))),
        (((((((-(p2 - p1)) * t0) * t2) * ((t2 + (6.0_f64 * t1)) + t0)) + ((((2.0_f64 * (p1 - p0)) * t1) * t2) * (t2 + (3.0_f64 * t1)))) + ((((2.0_f64 * (p3 - p2)) * t0) * t1) * ((3.0_f64 * t1) + t0))) / (((t0 * { let a = t1; let p = a; let p = p * p; p }) * t2) * (((((2.0_f64 * t1) * t2) + (t0 * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))),
        (((((((-6.0_f64) * (p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) + ((((3.0_f64 * (p2 - p1)) * t0) * ((3.0_f64 * t1) + t0)) * { let a = t2; let p = a; let p = p * p; p })) - ((((2.0_f64 * (p3 - p2)) * t0) * t1) * (((((8.0_f64 * t1) * t2) + ((4.0_f64 * t0) * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))) / (((t0 * t1) * { let a = t2; let p = a; let p = p * p * a; p }) * (((((2.0_f64 * t1) * t2) + (t0 * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))),
        (((((((-(p1 - p0)) * t1) * t2) * (((((2.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((6.0_f64 * t0) * t1))) + ((((p2 - p1) * { let a = t0; let p = a; let p = p * p; p }) * t2) * (t2 + (3.0_f64 * t1)))) - (((2.0_f64 * (p3 - p2)) * { let a = t0; let p = a; let p = p * p; p }) * { let a = t1; let p = a; let p = p * p; p })) / ((({ let a = t0; let p = a; let p = p * p; let p = p * p; p } * t1) * t2) * (((((2.0_f64 * t1) * t2) + (t0 * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))),
        ((((((2.0_f64 * (p1 - p0)) * { let a = t1; let p = a; let p = p * p; p }) * { let a = t2; let p = a; let p = p * p; p }) - ((((p2 - p1) * t0) * ((3.0_f64 * t1) + t0)) * { let a = t2; let p = a; let p = p * p; p })) + ((((p3 - p2) * t0) * t1) * (((((6.0_f64 * t1) * t2) + ((3.0_f64 * t0) * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))) / (((t0 * t1) * { let a = t2; let p = a; let p = p * p; let p = p * p; p }) * (((((2.0_f64 * t1) * t2) + (t0 * t2)) + (3.0_f64 * { let a = t1; let p = a; let p = p * p; p })) + ((2.0_f64 * t0) * t1)))),
    ];
}
