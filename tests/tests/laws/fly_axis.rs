//! Laws of the fly axis that slows down and comes to rest.
//!
//! Its two segments: from no acceleration at v1Scan to -2*v1Diff/tIn at v1Scan-v1Diff, and from there to -a1Max at rest.

use closedform_tests::kernels::judge_of;
use closedform_tests::laws::chain::Chain;
use closedform_tests::laws::motion::Motion;

use crate::{Laws, kernel};

laws![
    the_ramp_closes_its_segment,
    the_turn_closes_its_segment,
    the_ramp_that_a_turn_needs_brings_it_to_rest,
    ramp_and_turn_undo_each_other,
    the_overhead_is_the_time_beyond_the_line,
    the_overhead_by_the_turn_alone_brings_it_to_rest,
    the_turn_closes,
    the_turn_closes_with_the_ramp_that_it_needs,
    the_time_added_is_that_of_the_line,
];

fn the_ramp_closes_its_segment(laws: &mut Laws) {
    laws.demand("fly_axis::a1_in", &["a1In"], &["-v1Diff = (0+a1In)*tIn/2", "a1In <= 0", "v1Diff = 0 or a1In < 0"]);
    laws.demand(
        "fly_axis::d1_in",
        &["d1In"],
        &["d1In = v1Scan*tIn+(2*0-2*v1Diff/tIn)*tIn^2/6", "6*d1In = (4*v1Scan+2*(v1Scan-v1Diff))*tIn", "d1In > 0"],
    );
}

fn the_turn_closes_its_segment(laws: &mut Laws) {
    laws.demand(
        "fly_axis::turn_out",
        &["tOut", "d1Out"],
        &[
            "0 = v1Scan-v1Diff+(-2*v1Diff/tIn-a1Max)*tOut/2",
            "d1Out = (v1Scan-v1Diff)*tOut+(2*(-2*v1Diff/tIn)-a1Max)*tOut^2/6",
            "(-2*v1Diff/tIn)*tOut^2 = 6*d1Out-4*(v1Scan-v1Diff)*tOut",
            "-a1Max*tOut^2 = 2*(v1Scan-v1Diff)*tOut-6*d1Out",
            "tOut > 0 and d1Out > 0",
        ],
    );
}

fn the_ramp_that_a_turn_needs_brings_it_to_rest(laws: &mut Laws) {
    laws.demand(
        "fly_axis::t_in_of_t_out",
        &["tIn"],
        &[
            "0 = v1Scan-v1Diff+(-2*v1Diff/tIn-a1Max)*tOut/2",
            "tIn > 0",
            // No deceleration beyond a1Max.
            "a1Max*tIn >= 2*v1Diff",
        ],
    );
    laws.demand(
        "fly_axis::v1_diff",
        &["v1Diff"],
        &["0 = v1Scan-v1Diff+(-2*v1Diff/tIn-a1Max)*tOut/2", "v1Diff >= 0", "2*v1Diff <= a1Max*tIn"],
    );
}

fn ramp_and_turn_undo_each_other(laws: &mut Laws) {
    laws.demand_inverse(("fly_axis::turn_out", "tOut"), ("fly_axis::t_in_of_t_out", "tIn"), &[]);
    laws.demand_inverse(("fly_axis::turn_out", "tOut"), ("fly_axis::v1_diff", "v1Diff"), &[]);
    laws.demand_inverse(("fly_axis::t_in_of_t_out", "tIn"), ("fly_axis::turn_out", "tOut"), &[]);
    laws.demand_inverse(("fly_axis::t_in_of_t_out", "tIn"), ("fly_axis::v1_diff", "v1Diff"), &[]);
    laws.demand_inverse(("fly_axis::v1_diff", "v1Diff"), ("fly_axis::turn_out", "tOut"), &[]);
    laws.demand_inverse(("fly_axis::v1_diff", "v1Diff"), ("fly_axis::t_in_of_t_out", "tIn"), &[]);
}

fn the_overhead_is_the_time_beyond_the_line(laws: &mut Laws) {
    laws.demand(
        "fly_axis::t_add",
        &["tAdd"],
        &["v1Scan*(tIn-tAdd) = v1Scan*tIn+(2*0-2*v1Diff/tIn)*tIn^2/6", "tAdd >= 0"],
    );
    laws.demand(
        "fly_axis::overhead",
        &["tOvrHd"],
        &["v1Scan*(tIn+tOut+tEdge/2-tOvrHd) = v1Scan*tIn+(2*0-2*v1Diff/tIn)*tIn^2/6", "tOvrHd >= 0"],
    );
}

fn the_overhead_by_the_turn_alone_brings_it_to_rest(laws: &mut Laws) {
    // With tIn = 3*v1Scan*(tOvrHd-tOut)/v1Diff, that of t_add, the turn ends at rest; so does its derivative by v1Diff.
    laws.demand(
        "fly_axis::overhead_of_t_out",
        &["tOvrHd", "slope"],
        &[
            "(2*(v1Scan-v1Diff)-a1Max*tOut)*(3*v1Scan*(tOvrHd-tOut)/v1Diff) = 2*v1Diff*tOut",
            "(2*(v1Scan-v1Diff)-a1Max*tOut)*(3*v1Scan*(slope*v1Diff-(tOvrHd-tOut))/v1Diff^2) \
         = 2*(3*v1Scan*(tOvrHd-tOut)/v1Diff)+2*tOut",
            "tOvrHd >= tOut and slope > 0",
        ],
    );
}

/// With what the kernels of the two segments make of tIn, v1Scan, v1Diff and a1Max: d1In, a1In, tOut and d1Out.
pub fn with_segments(chain: Chain) -> Chain {
    chain
        .then(&judge_of("fly_axis::d1_in"), &["d1In"])
        .then(&judge_of("fly_axis::a1_in"), &["a1In"])
        .then(&judge_of("fly_axis::turn_out"), &["tOut", "d1Out"])
}

/// The fly axis from its line to rest and, mirrored in time, back to its line.
pub fn turn() -> Motion {
    Motion::from(["0", "v1Scan", "0"])
        .jerk("tIn", "-2*v1Diff/tIn^2", ["d1In", "v1Scan-v1Diff", "a1In"])
        .ramp("tOut", ["d1In+d1Out", "0", "-a1Max"])
        .ramp("tOut", ["d1In", "v1Diff-v1Scan", "a1In"])
        .jerk("tIn", "2*v1Diff/tIn^2", ["0", "-v1Scan", "0"])
}

fn the_turn_closes(laws: &mut Laws) {
    let segments = kernel("fly_axis::turn_out", &["tOut", "d1Out"])
        .then(&judge_of("fly_axis::d1_in"), &["d1In"])
        .then(&judge_of("fly_axis::a1_in"), &["a1In"]);
    laws.demand_motion(&segments, &turn());
}

fn the_turn_closes_with_the_ramp_that_it_needs(laws: &mut Laws) {
    // Here tOut is given, and what d1In and a1In say follows from the ramp.
    for (name, result) in [("fly_axis::t_in_of_t_out", "tIn"), ("fly_axis::v1_diff", "v1Diff")] {
        let chain = kernel(name, &[result])
            .then(&judge_of("fly_axis::d1_in"), &["d1In"])
            .then(&judge_of("fly_axis::a1_in"), &["a1In"])
            .define("d1Out", "(v1Scan-v1Diff)*tOut+(2*a1In-a1Max)*tOut^2/6");
        laws.demand_motion(&chain, &turn());
    }
}

fn the_time_added_is_that_of_the_line(laws: &mut Laws) {
    // The distance of the ramp, at v1Scan all the time.
    let chain = kernel("fly_axis::t_add", &["tAdd"]).then(&judge_of("fly_axis::d1_in"), &["d1In"]);
    let line = Motion::from(["0", "v1Scan", "0"]).jerk("tIn-tAdd", "0", ["d1In", "v1Scan", "0"]);
    laws.demand_motion(&chain, &line);
}
