//! What must hold of any bytes that are read as G-code.

use closedform_motion::plan::milling::gcode::{Reading, Unknown};
use closedform_motion::plan::milling::{Machine, Milling, Model};

/// The program is timed or refused with a reason, whatever becomes of lines that are not understood.
pub fn gcode(bytes: &[u8]) {
    let milling = Milling::new(Machine::default(), Model::Continuous).expect("the default machine is one");
    for unknown in [Unknown::Refuse, Unknown::Skip] {
        let reading = Reading { unknown, default_feed: Some(10.0), ..Reading::default() };
        match milling.gcode(bytes, &reading, |_| ()) {
            Ok(summary) => assert!(summary.time >= 0.0 && summary.time.is_finite(), "{} s", summary.time),
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
}
