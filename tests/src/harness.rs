//! The harness of what is asked of all kernels: one test a kernel and judge, `family::kernel/judge`, to be chosen by name.

use std::process::ExitCode;
use std::sync::{Arc, OnceLock};

use closedform::{Info, Kernel};
use libtest_mimic::{Arguments, Failed, Trial};

use crate::check::Judge;
use crate::kernels;

/// What is said of a kernel: what came out, nothing where that is no news; or what is broken and how to replay it.
pub type Said = Result<String, String>;

/// Something that is asked of kernels.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    /// By which its tests are called.
    pub name: &'static str,
    /// Whether it is asked of a kernel.
    pub concerns: fn(&Info) -> bool,
    /// What is said of it.
    pub answer: fn(&Judge) -> Said,
}

impl Question {
    /// A question to every kernel.
    pub const fn to_all(name: &'static str, answer: fn(&Judge) -> Said) -> Self {
        Question { name, concerns: |_| true, answer }
    }
}

/// A question to one kernel.
#[derive(Clone, Debug)]
struct Asked {
    name: String,
    kernel: &'static Kernel,
    /// The judge of the kernel, made by the first of its tests that runs.
    judge: Arc<OnceLock<Judge>>,
    answer: fn(&Judge) -> Said,
}

impl Asked {
    fn said(&self) -> Said {
        (self.answer)(self.judge.get_or_init(|| kernels::judge(self.kernel)))
    }

    /// The test. What came out is printed where the user wants to see it.
    fn trial(self, shows: bool) -> Trial {
        Trial::test(self.name.clone(), move || {
            let said = self.said().map_err(|broken| Failed::from(format!("\n{broken}")))?;
            if shows && !said.is_empty() {
                println!("{:<48} {said}", self.name);
            }
            Ok(())
        })
    }
}

/// Every question to every kernel that it concerns.
fn asked(kernels: impl Iterator<Item = &'static Kernel>, questions: &[Question]) -> Vec<Asked> {
    let of_kernel = |kernel: &'static Kernel| {
        let judge = Arc::new(OnceLock::new());
        let concerning = questions.iter().filter(|question| (question.concerns)(kernel.info));
        let ask = |question: &Question| Asked {
            name: format!("{}/{}", kernel.info.name, question.name),
            kernel,
            judge: judge.clone(),
            answer: question.answer,
        };
        concerning.map(ask).collect::<Vec<_>>()
    };
    kernels.flat_map(of_kernel).collect()
}

/// Runs the tests that the command line chooses.
pub fn main(questions: &[Question]) -> ExitCode {
    let arguments = Arguments::from_args();
    let shows = arguments.nocapture || arguments.show_output;
    let trials = asked(kernels::all(), questions).into_iter().map(|asked| asked.trial(shows));
    libtest_mimic::run(&arguments, trials.collect()).exit_code()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_first(info: &Info) -> bool {
        kernels::all().next().is_some_and(|first| first.info == info)
    }

    fn answer(judge: &Judge) -> Said {
        if is_first(judge.kernel.info) { Err("broken".to_owned()) } else { Ok(String::new()) }
    }

    const QUESTIONS: [Question; 2] =
        [Question::to_all("common", answer), Question { name: "rare", concerns: is_first, answer }];

    #[test]
    fn every_kernel_is_asked_every_question_that_concerns_it() {
        let names: Vec<String> = asked(kernels::all(), &QUESTIONS).into_iter().map(|asked| asked.name).collect();
        let every: Vec<String> = kernels::all().map(|kernel| format!("{}/common", kernel.info.name)).collect();
        let rare: Vec<&String> = names.iter().filter(|name| name.ends_with("/rare")).collect();
        assert!(every.len() > 1 && every.iter().all(|name| names.contains(name)));
        assert_eq!((names.len(), rare), (every.len() + 1, vec![&every[0].replace("/common", "/rare")]));
    }

    #[test]
    fn a_broken_kernel_fails_in_its_own_tests_alone() {
        let two = asked(kernels::all().take(2), &QUESTIONS);
        let broken: Vec<&str> =
            two.iter().filter(|asked| asked.said().is_err()).map(|asked| asked.name.as_str()).collect();
        assert_eq!(broken, [two[0].name.as_str(), two[1].name.as_str()]);
        assert_eq!(two.len(), 3);
    }
}
