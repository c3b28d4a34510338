//! Laws of the scan axis that slows down and comes to rest.
//!
//! Its two segments: from no acceleration at v1Scan to -2*v1Diff/tIn at v1Scan-v1Diff, and from there to -a1Max at rest.

use crate::{demand, demand_inverse};

#[test]
fn the_ramp_closes_its_segment() {
    demand("fly_axis::a1_in", &["a1In"], &["-v1Diff = (0+a1In)*tIn/2", "a1In <= 0", "v1Diff = 0 or a1In < 0"]);
    demand(
        "fly_axis::d1_in",
        &["d1In"],
        &["d1In = v1Scan*tIn+(2*0-2*v1Diff/tIn)*tIn^2/6", "6*d1In = (4*v1Scan+2*(v1Scan-v1Diff))*tIn", "d1In > 0"],
    );
}

#[test]
fn the_turn_closes_its_segment() {
    demand(
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

#[test]
fn the_ramp_that_a_turn_needs_brings_it_to_rest() {
    demand(
        "fly_axis::t_in_of_t_out",
        &["tIn"],
        &[
            "0 = v1Scan-v1Diff+(-2*v1Diff/tIn-a1Max)*tOut/2",
            "tIn > 0",
            // To rounding: no deceleration beyond a1Max.
            "1000000001*a1Max*tIn >= 2000000000*v1Diff",
        ],
    );
    demand(
        "fly_axis::v1_diff",
        &["v1Diff"],
        &["0 = v1Scan-v1Diff+(-2*v1Diff/tIn-a1Max)*tOut/2", "v1Diff >= 0", "2000000000*v1Diff <= 1000000001*a1Max*tIn"],
    );
}

#[test]
fn ramp_and_turn_undo_each_other() {
    demand_inverse(("fly_axis::turn_out", "tOut"), ("fly_axis::t_in_of_t_out", "tIn"), &[]);
    demand_inverse(("fly_axis::turn_out", "tOut"), ("fly_axis::v1_diff", "v1Diff"), &[]);
    demand_inverse(("fly_axis::t_in_of_t_out", "tIn"), ("fly_axis::turn_out", "tOut"), &[]);
    demand_inverse(("fly_axis::t_in_of_t_out", "tIn"), ("fly_axis::v1_diff", "v1Diff"), &[]);
    demand_inverse(("fly_axis::v1_diff", "v1Diff"), ("fly_axis::turn_out", "tOut"), &[]);
    demand_inverse(("fly_axis::v1_diff", "v1Diff"), ("fly_axis::t_in_of_t_out", "tIn"), &[]);
}

#[test]
fn the_overhead_is_the_time_beyond_the_line() {
    demand("fly_axis::t_add", &["tAdd"], &["v1Scan*(tIn-tAdd) = v1Scan*tIn+(2*0-2*v1Diff/tIn)*tIn^2/6", "tAdd >= 0"]);
    demand(
        "fly_axis::overhead",
        &["tOvrHd"],
        &["v1Scan*(tIn+tOut+tEdge/2-tOvrHd) = v1Scan*tIn+(2*0-2*v1Diff/tIn)*tIn^2/6", "tOvrHd >= 0"],
    );
}

#[test]
fn the_overhead_by_the_turn_alone_brings_it_to_rest() {
    // With tIn = 3*v1Scan*(tOvrHd-tOut)/v1Diff, that of t_add, the turn ends at rest; so does its derivative by v1Diff.
    demand(
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
