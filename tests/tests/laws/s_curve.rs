//! Laws of the fastest moves: ramps change the velocity as they say, and moves end where they should.

use closedform_tests::laws::motion::Motion;

use crate::{Laws, kernel};

laws![
    ramps_change_the_velocity,
    moves_from_rest_to_rest_make_their_way,
    a_full_move_closes,
    moves_between_velocities_make_their_way,
];

fn ramps_change_the_velocity(laws: &mut Laws) {
    laws.demand("s_curve::ramp", &["tj", "ta"], &["jMax*tj*(tj+ta) = dv", "jMax*tj = aMax", "tj > 0 and ta >= 0"]);
    laws.demand("s_curve::pointed_ramp", &["tj"], &["jMax*tj^2 = dv", "tj > 0"]);
}

fn moves_from_rest_to_rest_make_their_way(laws: &mut Laws) {
    let way = |v: &str| format!("({v})*(2*tj+ta+tv) = d");
    let peak = "jMax*tj*(tj+ta)";
    laws.demand(
        "s_curve::full_move",
        &["tj", "ta", "tv"],
        &[&way(peak), "jMax*tj = aMax", &format!("{peak} = vMax"), "ta >= 0 and tv >= 0"],
    );
    laws.demand(
        "s_curve::flat_move",
        &["tj", "ta", "vp"],
        &["vp*(2*tj+ta) = d", "jMax*tj = aMax", &format!("{peak} = vp"), "ta >= 0"],
    );
    laws.demand("s_curve::fast_move", &["tj", "tv"], &["vMax*(2*tj+tv) = d", "jMax*tj^2 = vMax", "tv >= 0"]);
    laws.demand("s_curve::short_move", &["tj"], &["2*jMax*tj^3 = d", "tj > 0"]);
    laws.demand("s_curve::trapezoid_at_rest", &["tr", "tv"], &["vMax*(tr+tv) = d", "aMax*tr = vMax", "tv >= 0"]);
    laws.demand("s_curve::triangle_at_rest", &["tr"], &["aMax*tr^2 = d", "tr > 0"]);
}

fn a_full_move_closes(laws: &mut Laws) {
    let (v, x) = ("vMax", "vMax*(2*tj+ta)/2");
    let motion = Motion::from(["0", "0", "0"])
        .jerk("tj", "jMax", ["jMax*tj^3/6", "jMax*tj^2/2", "aMax"])
        .jerk("ta", "0", ["jMax*tj^3/6+jMax*tj^2/2*ta+aMax*ta^2/2", "jMax*tj^2/2+aMax*ta", "aMax"])
        .jerk("tj", "-jMax", [x, v, "0"])
        .jerk("tv", "0", [&format!("d-{x}"), v, "0"]);
    laws.demand_motion(&kernel("s_curve::full_move", &["tj", "ta", "tv"]), &motion);
}

fn moves_between_velocities_make_their_way(laws: &mut Laws) {
    laws.demand(
        "s_curve::flat_rise",
        &["x"],
        &["(2*v+x)/2*(x/aMax+aMax/jMax)+(2*v-w+x)/2*((x+w)/aMax+aMax/jMax) = d", "x > 0"],
    );
    laws.demand("s_curve::pointed_move", &["tj"], &["2*tj*(2*v+jMax*tj^2) = d", "tj > 0"]);
    laws.demand(
        "s_curve::trapezoid",
        &["tu", "tv", "td"],
        &[
            "(v0+vMax)/2*tu+vMax*tv+(vMax+v1)/2*td = d",
            "aMax*tu = vMax-v0",
            "aMax*td = vMax-v1",
            "tu >= 0 and tv >= 0 and td >= 0",
        ],
    );
    laws.demand("s_curve::triangle_rise", &["x"], &["(2*v+x)*x+(2*v-w+x)*(x+w) = 2*aMax*d", "x > 0"]);
}
