//! Examples of every command, which stand at the end of its help.

use clap::Command;

/// A command, and what one types; a test reads each.
const EXAMPLES: [(&str, &[&str]); 14] = [
    ("new", &["closedform new braking", "closedform new crates/braking --runtime version"]),
    (
        "generate",
        &["closedform generate", "closedform generate --watch", "closedform generate --input my.mac --out my-kernels"],
    ),
    ("check", &["closedform check", "closedform check --maxima", "closedform check --prove"]),
    ("derive", &["closedform derive", "closedform derive braking --limit 600"]),
    ("list", &["closedform list", "closedform list turnaround", "closedform list --json"]),
    ("show", &["closedform show turnaround::t_in", "closedform show t_in --json"]),
    (
        "eval",
        &[
            "closedform eval pvt::turn_out v0=0.1 a1=-2",
            "closedform eval pvt::turn_out v0=0x1.8p-3 a1=-2 --digits 40",
            "closedform eval pvt::turn_out --batch points.csv",
        ],
    ),
    (
        "verify",
        &["closedform verify", "closedform verify t_in --points 100000", "closedform verify t_in --search 60s --keep"],
    ),
    ("ledger", &["closedform ledger", "closedform ledger --json"]),
    ("mutants", &["closedform mutants", "closedform mutants turnaround::t_in"]),
    ("bound", &["closedform bound src/kernels.rs", "closedform bound src/kernels.rs --write"]),
    ("schema", &["closedform schema contract", "closedform schema list"]),
    ("completions", &["closedform completions bash", "closedform completions fish"]),
    ("man", &["closedform man share/man/man1"]),
];

/// The command with its examples.
pub fn with_examples(mut command: Command) -> Command {
    for (name, examples) in EXAMPLES {
        let lines: String = examples.iter().map(|example| format!("\n  {example}")).collect();
        command = command.mut_subcommand(name, |command| command.after_help(format!("Examples:{lines}")));
    }
    command
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command;

    #[test]
    fn every_example_is_read() {
        for (name, examples) in EXAMPLES {
            assert!(!examples.is_empty());
            for example in examples {
                let matches = command().try_get_matches_from(example.split_whitespace());
                assert_eq!(matches.unwrap().subcommand_name(), Some(name), "{example}");
            }
        }
    }

    #[test]
    fn every_command_of_ours_has_examples() {
        // those of `plan` and `plot` are the other program's
        let handed_on = ["plan", "plot", "help"];
        for command in command().get_subcommands().filter(|command| !handed_on.contains(&command.get_name())) {
            let help = command.clone().render_help().to_string();
            assert!(help.contains("Examples:\n  closedform "), "{help}");
        }
    }
}
