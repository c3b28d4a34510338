//! What holds of every kernel: one test a kernel and judge, `family::kernel/judge`.

mod accuracy;
mod calls;
mod named;
mod printed;
mod sources;

use std::process::ExitCode;

use closedform_tests::harness::{self, Question};
use closedform_tests::magnitudes;

const QUESTIONS: [Question; 22] = [
    Question::to_all("bound", accuracy::bound),
    Question::to_all("kept", accuracy::kept),
    Question::to_all("formula", accuracy::formula),
    Question::to_all("climb", accuracy::climb),
    Question::to_all("shrunk", accuracy::shrunk),
    Question::to_all("faithful", accuracy::faithful),
    Question::to_all("sweep", accuracy::sweep),
    Question::to_all("domain", calls::domain),
    Question::to_all("range", calls::range),
    Question::to_all("finite", calls::finite),
    Question::to_all("batch", calls::batch),
    Question::to_all("fast", calls::fast),
    Question::to_all("named", named::named),
    Question::to_all("single", calls::single),
    Question::to_all("units", calls::units),
    Question::to_all("table", calls::table),
    Question { name: "magnitudes", concerns: magnitudes::concerns, answer: magnitudes::answer },
    Question::to_all("golden", sources::golden),
    Question::to_all("proof", sources::proof),
    Question::to_all("reference", sources::reference),
    Question::to_all("complete", sources::complete),
    Question { name: "printed", concerns: printed::concerns, answer: printed::answer },
];

fn main() -> ExitCode {
    harness::main(&QUESTIONS)
}
