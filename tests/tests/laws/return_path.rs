//! Laws of the asymmetric way back of the fly axis.

use closedform_tests::laws::motion::Motion;

use crate::{Laws, kernel};

laws![
    the_way_back_closes_its_three_segments,
    the_accelerations_alone_make_the_whole_way,
    the_first_segment_takes_a_part_of_the_time,
    the_way_back_closes,
];

const RESULTS: [&str; 5] = ["a2", "tEdge1", "d1Edge1", "d1Edge2", "v1Edge2"];

fn the_way_back_closes_its_three_segments(laws: &mut Laws) {
    // Two equations a segment: where it ends, and how fast. The first ends with 0+(a1Max-a1Max)*tEdge1/2 = 0.
    laws.demand(
        "return_path::asymmetric_return",
        &RESULTS,
        &[
            "d1Edge1 = 0*tEdge1+(2*a1Max-a1Max)*tEdge1^2/6",
            "d1Edge2 = 0*(tEdge-tEdge1)+(2*(-a1Max)+a2)*(tEdge-tEdge1)^2/6",
            "v1Edge2 = 0+(-a1Max+a2)*(tEdge-tEdge1)/2",
            "d1Out-d1Edge1-d1Edge2 = v1Edge2*tOut+(2*a2+a3)*tOut^2/6",
            "v3 = v1Edge2+(a2+a3)*tOut/2",
        ],
    );
}

fn the_accelerations_alone_make_the_whole_way(laws: &mut Laws) {
    // The accelerations of the three segments, integrated once and twice over all the time, tEdge+tOut.
    laws.demand(
        "return_path::asymmetric_return",
        &RESULTS,
        &[
            "v3 = (a1Max-a1Max)*tEdge1/2+(-a1Max+a2)*(tEdge-tEdge1)/2+(a2+a3)*tOut/2",
            "d1Out = a1Max*tEdge1^2/6+(-2*a1Max+a2)*(tEdge-tEdge1)^2/6 \
         +(-a1Max+a2)*(tEdge-tEdge1)/2*tOut+(2*a2+a3)*tOut^2/6",
        ],
    );
}

fn the_first_segment_takes_a_part_of_the_time(laws: &mut Laws) {
    laws.demand("return_path::asymmetric_return", &RESULTS, &["tEdge1 > 0 and d1Edge1 > 0", "tEdge1 <= tEdge"]);
}

fn the_way_back_closes(laws: &mut Laws) {
    let motion = Motion::from(["0", "0", "a1Max"])
        .jerk("tEdge1", "-2*a1Max/tEdge1", ["d1Edge1", "0", "-a1Max"])
        .ramp("tEdge-tEdge1", ["d1Edge1+d1Edge2", "v1Edge2", "a2"])
        .jerk("tOut", "(a3-a2)/tOut", ["d1Out", "v3", "a3"]);
    laws.demand_motion(&kernel("return_path::asymmetric_return", &RESULTS), &motion);
}
