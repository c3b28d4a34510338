//! What must hold of any bytes that are read as G-code.

use closedform_motion::plan::milling::gcode::{Dialect, Reading, Unknown};
use closedform_motion::plan::milling::{Machine, Milling, Model};

/// The program is timed or refused with a reason, whatever becomes of lines that are not understood.
pub fn gcode(bytes: &[u8]) {
    let milling = Milling::new(Machine::default(), Model::default()).expect("the default machine is one");
    let dialects = [None, Some(Dialect::LinuxCnc), Some(Dialect::Marlin), Some(Dialect::Klipper), Some(Dialect::Fanuc)];
    let unknowns = [Unknown::Refuse, Unknown::Skip];
    for (unknown, dialect) in unknowns.into_iter().flat_map(|unknown| dialects.map(|dialect| (unknown, dialect))) {
        // Few lines that repeat: a loop without end is to be found soon.
        let reading =
            Reading { unknown, dialect, default_feed: Some(10.0), most_repeated: 2_000, ..Reading::default() };
        match milling.gcode(bytes, &reading, |_| ()) {
            Ok(summary) => assert!(summary.time >= 0.0 && summary.time.is_finite(), "{} s", summary.time),
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
}
