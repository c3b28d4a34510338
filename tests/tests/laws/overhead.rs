//! Laws of the overhead of both axes together.
//!
//! The step axis closes on its step: (2*tau+tIn)*(4*tau+tIn) = 3*delta with tau = tOut/2+tEdge/4. The fly axis comes to
//! rest: (2*v1Diff/tIn+a1Max)*tOut = 2*(v1Scan-v1Diff). Its ramp adds tIn*v1Diff/(3*v1Scan).

use closedform_tests::laws::motion::Motion;

use crate::turnaround::turn as step_turn;
use crate::{Laws, fly_axis, kernel};

laws![
    the_step_axis_closes_on_its_step,
    the_rest_at_the_edge_closes_both_axes,
    without_rest_the_ramp_and_its_loss_undo_each_other,
    the_scan_axis_comes_to_rest,
    the_gradient_is_that_of_the_distance_of_the_turn,
    the_turn_of_the_step_axis_closes,
    the_turn_of_the_scan_axis_closes,
    both_turns_close_in_one_time,
];

fn the_step_axis_closes_on_its_step(laws: &mut Laws) {
    // By 2*tau = tOvrHd-tAdd; its derivative by tIn differentiates the condition as it stands.
    laws.demand(
        "overhead::step_limited",
        &["tOvrHd", "slope"],
        &[
            "(tOvrHd-tIn*v1Diff/(3*v1Scan)+tIn)*(2*(tOvrHd-tIn*v1Diff/(3*v1Scan))+tIn) = 3*delta",
            "(slope-v1Diff/(3*v1Scan)+1)*(2*(tOvrHd-tIn*v1Diff/(3*v1Scan))+tIn) \
         +(tOvrHd-tIn*v1Diff/(3*v1Scan)+tIn)*(2*(slope-v1Diff/(3*v1Scan))+1) = 0",
            "tOvrHd >= 0 and slope < 0",
            "3*slope < -1",
        ],
    );
}

fn the_rest_at_the_edge_closes_both_axes(laws: &mut Laws) {
    laws.demand(
        "overhead::t_edge",
        &["tEdge"],
        &[
            "(2*tIn*(v1Scan-v1Diff)/(2*v1Diff+a1Max*tIn)+tEdge/2+tIn) \
         *(4*tIn*(v1Scan-v1Diff)/(2*v1Diff+a1Max*tIn)+tEdge+tIn) = 3*delta",
            "tEdge >= 0",
        ],
    );
    laws.demand(
        "overhead::v1_diff",
        &["v1Diff"],
        &[
            "(2*tIn*(v1Scan-v1Diff)/(2*v1Diff+a1Max*tIn)+tIn)*(4*tIn*(v1Scan-v1Diff)/(2*v1Diff+a1Max*tIn)+tIn) = 3*delta",
            "v1Diff >= 0",
            // No deceleration beyond a1Max, and no more lost than there is.
            "2*v1Diff <= a1Max*tIn",
            "v1Diff <= v1Scan",
        ],
    );
}

fn without_rest_the_ramp_and_its_loss_undo_each_other(laws: &mut Laws) {
    laws.demand_inverse(("overhead::v1_diff", "v1Diff"), ("optimum::t_in", "tIn"), &[]);
    laws.demand_inverse(("optimum::t_in", "tIn"), ("overhead::v1_diff", "v1Diff"), &[]);
}

fn the_scan_axis_comes_to_rest(laws: &mut Laws) {
    // By tOut = tOvrHd-tAdd; its derivative by tIn differentiates the condition times tIn.
    laws.demand(
        "overhead::scan_limited",
        &["tOvrHd", "slope"],
        &[
            "(2*v1Diff/tIn+a1Max)*(tOvrHd-tIn*v1Diff/(3*v1Scan)) = 2*(v1Scan-v1Diff)",
            "a1Max*(tOvrHd-tIn*v1Diff/(3*v1Scan))+(2*v1Diff+a1Max*tIn)*(slope-v1Diff/(3*v1Scan)) = 2*(v1Scan-v1Diff)",
            "tOvrHd > 0 and slope >= 0",
            "v1Diff = 0 or slope > 0",
        ],
    );
}

fn the_gradient_is_that_of_the_distance_of_the_turn(laws: &mut Laws) {
    // 6*d1Out = 2*(v1Scan-v1Diff)*tOut+a1Max*tOut^2, the end of the turn at -a1Max, differentiated with tOut, and
    // (2*v1Diff+a1Max*tIn)*tOut = 2*tIn*(v1Scan-v1Diff), the rest at its end, for the derivatives of tOut.
    laws.demand(
        "overhead::d1_out_gradient",
        &["byDiff", "byIn"],
        &[
            "6*byDiff+2*(2*tIn*(v1Scan-v1Diff)/(2*v1Diff+a1Max*tIn)) \
         = (2*(v1Scan-v1Diff)+2*a1Max*(2*tIn*(v1Scan-v1Diff)/(2*v1Diff+a1Max*tIn))) \
         *(-2*tIn-2*(2*tIn*(v1Scan-v1Diff)/(2*v1Diff+a1Max*tIn)))/(2*v1Diff+a1Max*tIn)",
            "6*byIn = (2*(v1Scan-v1Diff)+2*a1Max*(2*tIn*(v1Scan-v1Diff)/(2*v1Diff+a1Max*tIn))) \
         *(2*(v1Scan-v1Diff)-a1Max*(2*tIn*(v1Scan-v1Diff)/(2*v1Diff+a1Max*tIn)))/(2*v1Diff+a1Max*tIn)",
            "byDiff < 0 and byIn >= 0",
            "v1Diff = 0 or byIn > 0",
        ],
    );
}

fn the_turn_of_the_step_axis_closes(laws: &mut Laws) {
    // With its largest acceleration 1 the step is delta; each ramp out takes 2*tau = tOvrHd-tAdd.
    let chain = kernel("overhead::step_limited", &["tOvrHd"]).define("twoTau", "tOvrHd-tIn*v1Diff/(3*v1Scan)");
    laws.demand_motion(&chain, &step_turn("1", "twoTau", "0", "delta"));
}

fn the_turn_of_the_scan_axis_closes(laws: &mut Laws) {
    let chain = kernel("overhead::scan_limited", &["tOvrHd"]).define("tOut", "tOvrHd-tIn*v1Diff/(3*v1Scan)");
    let motion = Motion::from(["0", "v1Scan", "0"])
        .jerk("tIn", "-2*v1Diff/tIn^2", ["(3*v1Scan-v1Diff)*tIn/3", "v1Scan-v1Diff", "-2*v1Diff/tIn"])
        .ramp("tOut", ["(3*v1Scan-v1Diff)*tIn/3+(2*(v1Scan-v1Diff)+a1Max*tOut)*tOut/6", "0", "-a1Max"]);
    laws.demand_motion(&chain, &motion);
}

fn both_turns_close_in_one_time(laws: &mut Laws) {
    // The step axis ramps out while the fly axis turns and rests: tOut+tEdge/2 to either side of the edge.
    let rest = fly_axis::with_segments(kernel("overhead::t_edge", &["tEdge"]));
    laws.demand_motions(&rest, &fly_axis::turn(), &step_turn("1", "(tOut+tEdge/2)", "0", "delta"));
    let none = fly_axis::with_segments(kernel("overhead::v1_diff", &["v1Diff"]));
    laws.demand_motions(&none, &fly_axis::turn(), &step_turn("1", "tOut", "0", "delta"));
}
