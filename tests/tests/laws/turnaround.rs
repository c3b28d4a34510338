//! Laws of the turn-around of the step axis.

use closedform_tests::kernels::judge_of;
use closedform_tests::laws::chain::Chain;
use closedform_tests::laws::motion::Motion;

use crate::{Laws, kernel};

laws![
    outer_and_inner_ramps_close_the_move,
    ramps_close_on_the_step,
    a_ramp_in_travels_its_distance,
    tau_and_delta_solve_the_turn_around,
    largest_acceleration_makes_the_step,
    the_share_of_the_ramps_in_is_by_their_times,
    tau_and_delta_undo_each_other,
    the_move_of_outer_and_inner_ramps_closes,
    outer_and_inner_ramps_undo_each_other,
    the_move_of_ramps_in_and_out_closes,
    moves_by_tau_and_delta_close,
];

fn outer_and_inner_ramps_close_the_move(laws: &mut Laws) {
    let equations = [
        "a0*t0^2/3+2*(a0*t0/2*t3+a0*t3^2/3)+t2*a0*(t0+t3)/2 = DeltaX",
        "v0 = a0*t0/2",
        "k*(t0+t3)*(t0+2*t3) = t0^2",
        "t0 > 0 and t3 > 0 and v0 > 0 and k > 0",
        "k <= 1",
    ];
    laws.demand("turnaround::outer_ramp", &["t0", "v0", "k"], &equations);
    laws.demand("turnaround::inner_ramp", &["t3", "v0", "k"], &equations);
}

fn ramps_close_on_the_step(laws: &mut Laws) {
    laws.demand(
        "turnaround::t_in",
        &["tIn"],
        &[
            "2*a2Max*tIn^2/6+2*(a2Max*tIn/2*tOut+a2Max*tOut^2/3)+tEdgeTotal*(a2Max*tIn/2+a2Max*tOut/2) = d2Step",
            "tIn > 0",
        ],
    );
    laws.demand(
        "turnaround::ramp_in",
        &["d2_in", "v2_in"],
        &["d2_in = a2Max*tIn^2/6", "v2_in = a2Max*tIn/2", "d2_in > 0 and v2_in > 0"],
    );
    laws.demand(
        "turnaround::ramp_out",
        &["d2_out", "v2_out"],
        &[
            "d2_out = a2Max*tIn/2*tOut+a2Max*tOut^2/2-a2Max*tOut^2/6",
            "v2_out = a2Max*tIn/2+a2Max*tOut/2",
            "d2_out >= 0 and v2_out > 0",
        ],
    );
}

fn a_ramp_in_travels_its_distance(laws: &mut Laws) {
    laws.demand("turnaround::t_in_of_d2_in", &["tIn"], &["a2Max*tIn^2/6 = d2In", "tIn > 0"]);
    laws.demand("turnaround::a2_max_of_d2_in", &["a2Max"], &["a2Max*tIn^2/6 = d2In", "a2Max > 0"]);
}

fn tau_and_delta_solve_the_turn_around(laws: &mut Laws) {
    let squared = "(tIn+3*tau-3*tEFSkip/2)^2 = tau^2+3*delta";
    laws.demand(
        "turnaround::t_in_of_tau",
        &["tIn"],
        &["(tIn+3*tau-3*tEFSkip/2)^2 = tau^2+3*delta", "tIn > 0 and 2*tIn+6*tau-3*tEFSkip >= 0"],
    );
    laws.demand("turnaround::tau_of_t_in", &["tau"], &[squared, "tau > 0 and 2*tIn+6*tau-3*tEFSkip >= 0"]);
    laws.demand("turnaround::tau_without_skip", &["tau"], &["(tIn+3*tau)^2 = tau^2+3*delta", "tau > 0"]);
    laws.demand("turnaround::delta_of_tau", &["delta"], &[squared, "delta > 0"]);
    laws.demand(
        "turnaround::delta_of_t_edge",
        &["delta"],
        &["tIn^2/3+tIn*(tOut+tEdge/2)+2*(tOut+tEdge/2)^2/3+tEFSkip*(tIn+tOut+tEdge/2)/2 = delta", "delta > 0"],
    );
    laws.demand(
        "turnaround::t_edge_of_t_in",
        &["tEdge"],
        &["tIn^2/3+tIn*(tOut+tEdge/2)+2*(tOut+tEdge/2)^2/3 = delta", "tEdge >= 0"],
    );
}

fn largest_acceleration_makes_the_step(laws: &mut Laws) {
    laws.demand("turnaround::a2_max_of_tau", &["a2Max"], &["a2Max*((tIn+3*tau)^2-tau^2) = 3*d2Step", "a2Max > 0"]);
    laws.demand(
        "turnaround::da2_max_dtau",
        &["slope"],
        &["slope*((tIn+3*tau)^2-tau^2)^2 = -3*d2Step*(6*(tIn+3*tau)-2*tau)", "slope < 0"],
    );
    laws.demand(
        "turnaround::dtau_da2_max",
        &["slope"],
        &[
            "-3*slope*d2Step*(6*(tIn+3*(tOut/2+tEdge/4))-2*(tOut/2+tEdge/4)) \
         = ((tIn+3*(tOut/2+tEdge/4))^2-(tOut/2+tEdge/4)^2)^2",
            "slope < 0",
        ],
    );
}

fn the_share_of_the_ramps_in_is_by_their_times(laws: &mut Laws) {
    laws.demand(
        "turnaround::k_of_t_in",
        &["K"],
        &[
            "K*(tIn+positive_root(2*T^2/3+(tIn+tEFSkip/2)*T+tIn^2/3+tEFSkip*tIn/2-delta,T)) \
         *(tIn+2*positive_root(2*T^2/3+(tIn+tEFSkip/2)*T+tIn^2/3+tEFSkip*tIn/2-delta,T)) = tIn^2",
            "K > 0",
            "K <= 1",
        ],
    );
}

fn tau_and_delta_undo_each_other(laws: &mut Laws) {
    laws.demand_inverse(("turnaround::tau_of_t_in", "tau"), ("turnaround::delta_of_tau", "delta"), &[]);
    laws.demand_inverse(("turnaround::tau_of_t_in", "tau"), ("turnaround::t_in_of_tau", "tIn"), &[]);
    laws.demand_inverse(("turnaround::delta_of_tau", "delta"), ("turnaround::tau_of_t_in", "tau"), &[]);
    laws.demand_inverse(
        ("turnaround::tau_without_skip", "tau"),
        ("turnaround::delta_of_tau", "delta"),
        &[("tEFSkip", "0")],
    );
    laws.demand_inverse(
        ("turnaround::t_edge_of_t_in", "tEdge"),
        ("turnaround::delta_of_t_edge", "delta"),
        &[("tEFSkip", "0")],
    );
    laws.demand_inverse(("turnaround::t_in_of_d2_in", "tIn"), ("turnaround::a2_max_of_d2_in", "a2Max"), &[]);
    laws.demand_inverse(("turnaround::a2_max_of_d2_in", "a2Max"), ("turnaround::t_in_of_d2_in", "tIn"), &[]);
}

fn the_move_of_outer_and_inner_ramps_closes(laws: &mut Laws) {
    // The four ramps travel DeltaX-t2*(v0+a0*t3/2), the outer two of them the share k.
    let ramps = "(DeltaX-t2*(v0+a0*t3/2))";
    let [after_first, before_last] = [format!("{ramps}*k/2"), format!("DeltaX-{ramps}*k/2")];
    let [middle, end_of_middle] = [format!("{ramps}/2"), format!("DeltaX-{ramps}/2")];
    let motion = Motion::from(["0", "0", "0"])
        .jerk("t0", "2*v0/t0^2", [&after_first, "v0", "a0"])
        .jerk("t3", "-a0/t3", [&middle, "v0+a0*t3/2", "0"])
        .jerk("t2", "0", [&end_of_middle, "v0+a0*t3/2", "0"])
        .jerk("t3", "-a0/t3", [&before_last, "v0", "-a0"])
        .jerk("t0", "2*v0/t0^2", ["DeltaX", "0", "0"]);
    laws.demand_motion(&kernel("turnaround::outer_ramp", &["t0", "v0", "k"]), &motion);
    laws.demand_motion(&kernel("turnaround::inner_ramp", &["t3", "v0", "k"]), &motion);
}

fn outer_and_inner_ramps_undo_each_other(laws: &mut Laws) {
    let (outer, inner) = (judge_of("turnaround::outer_ramp"), judge_of("turnaround::inner_ramp"));
    let back = Chain::new(&outer, &["t0", "v0", "k"]).then(&inner, &["T3", "V0", "K"]);
    laws.demand_of(&back, &["T3 = t3", "V0 = v0", "K = k"]);
    let back = Chain::new(&inner, &["t3", "v0", "k"]).then(&outer, &["T0", "V0", "K"]);
    laws.demand_of(&back, &["T0 = t0", "V0 = v0", "K = k"]);
}

fn the_move_of_ramps_in_and_out_closes(laws: &mut Laws) {
    let chain = kernel("turnaround::t_in", &["tIn"])
        .then(&judge_of("turnaround::ramp_in"), &["d2In", "v2In"])
        .then(&judge_of("turnaround::ramp_out"), &["d2Out", "v2Out"]);
    let motion = Motion::from(["0", "0", "0"])
        .jerk("tIn", "a2Max/tIn", ["d2In", "v2In", "a2Max"])
        .ramp("tOut", ["d2In+d2Out", "v2Out", "0"])
        .ramp("tEdgeTotal", ["d2Step-d2In-d2Out", "v2Out", "0"])
        .ramp("tOut", ["d2Step-d2In", "v2In", "-a2Max"])
        .jerk("tIn", "a2Max/tIn", ["d2Step", "0", "0"]);
    laws.demand_motion(&chain, &motion);
}

/// The move with the largest acceleration `a` from rest to rest: ramps in of the time tIn, ramps out of the time `out`,
/// constant velocity for `skip` between them.
pub fn turn(a: &str, out: &str, skip: &str, travel: &str) -> Motion {
    let [after_in, after_out] = [format!("({a})*tIn^2/6"), format!("({a})*(tIn^2/6+tIn/2*({out})+({out})^2/3)")];
    let [fast, fastest] = [format!("({a})*tIn/2"), format!("({a})*(tIn+{out})/2")];
    let [skipped, slowed] = [format!("({travel})-{after_out}"), format!("({travel})-{after_in}")];
    Motion::from(["0", "0", "0"])
        .ramp("tIn", [&after_in, &fast, a])
        .ramp(out, [&after_out, &fastest, "0"])
        .ramp(skip, [&skipped, &fastest, "0"])
        .ramp(out, [&slowed, &fast, &format!("-({a})")])
        .ramp("tIn", [travel, "0", "0"])
}

fn moves_by_tau_and_delta_close(laws: &mut Laws) {
    // With the largest acceleration 1 the step is delta; the ramps out take (4*tau-3*tEFSkip)/2, or tOut+tEdge/2.
    let by_tau = |skip| turn("1", &format!("((4*tau-3*{skip})/2)"), skip, "delta");
    laws.demand_motion(&kernel("turnaround::t_in_of_tau", &["tIn"]), &by_tau("tEFSkip"));
    laws.demand_motion(&kernel("turnaround::tau_of_t_in", &["tau"]), &by_tau("tEFSkip"));
    laws.demand_motion(&kernel("turnaround::delta_of_tau", &["delta"]), &by_tau("tEFSkip"));
    laws.demand_motion(&kernel("turnaround::tau_without_skip", &["tau"]), &by_tau("0"));
    laws.demand_motion(&kernel("turnaround::a2_max_of_tau", &["a2Max"]), &turn("a2Max", "2*tau", "0", "d2Step"));
    let by_edge = |skip| turn("1", "(tOut+tEdge/2)", skip, "delta");
    laws.demand_motion(&kernel("turnaround::delta_of_t_edge", &["delta"]), &by_edge("tEFSkip"));
    laws.demand_motion(&kernel("turnaround::t_edge_of_t_in", &["tEdge"]), &by_edge("0"));
}
