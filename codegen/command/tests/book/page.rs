//! Pages of Markdown whose blocks ```` ```console ```` are run: commands after `$ `, and what they print.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

/// A command of a page with the output that the page shows.
#[derive(Debug)]
pub struct Example {
    /// The line of the page, from 0.
    line: usize,
    /// The command, without `$ `; lines that end in `\` go on, and so does what is given in the command until `END`.
    pub command: String,
    /// How many lines it takes.
    lines: usize,
    /// The lines of output.
    shown: Vec<String>,
}

/// The examples of a page, in order.
pub fn examples(page: &str) -> Vec<Example> {
    let mut examples: Vec<Example> = Vec::new();
    let (mut inside, mut goes_on) = (false, false);
    for (number, line) in page.lines().enumerate() {
        match (inside, line) {
            (false, "```console") => (inside, goes_on) = (true, false),
            (false, _) => {}
            (true, "```") => inside = false,
            (true, line) => {
                if let Some(command) = line.strip_prefix("$ ") {
                    let command = command.to_owned();
                    examples.push(Example { line: number, command, lines: 1, shown: Vec::new() });
                    goes_on = is_open(line);
                    continue;
                }
                let example = examples.last_mut().unwrap_or_else(|| panic!("line {number}: no `$` before it"));
                if goes_on {
                    let _ = write!(example.command, "\n{line}");
                    example.lines += 1;
                    goes_on = is_open(&example.command);
                } else {
                    example.shown.push(line.to_owned());
                }
            }
        }
    }
    examples
}

fn is_open(command: &str) -> bool {
    command.ends_with('\\') || command.contains("<<'END'") && !command.ends_with("\nEND")
}

/// Ends what a command prints, with its status.
const MARK: &str = "<the command ended with ";

/// Runs all commands in one shell, which begins in a folder; what each printed, with its status where that is not 0.
pub fn run(examples: &[Example], shell: &mut Command, folder: &Path) -> Vec<Vec<String>> {
    let mut script = String::from("exec 2>&1 </dev/null\n");
    for example in examples {
        let _ = writeln!(script, "{}\nprintf '\\n{MARK}%s>\\n' $?", example.command);
    }
    let output = shell.arg("-c").arg(script).current_dir(folder).output().expect("the shell starts");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut outputs = Vec::new();
    let mut lines = Vec::new();
    for line in text.lines() {
        match line.strip_prefix(MARK) {
            // in a checkout another program may have to be built first
            None if line.starts_with("building closedform-") => {}
            None => lines.push(line.trim_end().to_owned()),
            Some(status) => {
                while lines.last().is_some_and(String::is_empty) {
                    lines.pop();
                }
                let status = status.trim_end_matches('>');
                if status != "0" {
                    lines.push(format!("? {status}"));
                }
                outputs.push(std::mem::take(&mut lines));
            }
        }
    }
    assert_eq!(outputs.len(), examples.len(), "the shell ended early:\n{text}");
    outputs
}

/// Whether lines are those that are shown, where `..` stands for any part of a line in `[..]`, and `...` for any lines.
pub fn fits(shown: &[String], lines: &[String]) -> bool {
    match (shown.split_first(), lines.split_first()) {
        (None, None) => true,
        (Some((first, rest)), _) if first == "..." => (0..=lines.len()).any(|skipped| fits(rest, &lines[skipped..])),
        (Some((first, rest)), Some((line, lines))) => line_fits(first, line) && fits(rest, lines),
        _ => false,
    }
}

fn line_fits(shown: &str, line: &str) -> bool {
    let Some((start, rest)) = shown.split_once("[..]") else { return shown == line };
    let Some(line) = line.strip_prefix(start) else { return false };
    line.char_indices().map(|(at, _)| at).chain([line.len()]).any(|at| line_fits(rest, &line[at..]))
}

/// What is wrong with the page; nothing if every output is the one that it shows.
pub fn complaints(examples: &[Example], outputs: &[Vec<String>]) -> String {
    let mut text = String::new();
    for (example, lines) in examples.iter().zip(outputs).filter(|(example, lines)| !fits(&example.shown, lines)) {
        let (shown, lines) = (example.shown.join("\n"), lines.join("\n"));
        let _ = writeln!(
            text,
            "line {}: $ {}\n--- shown\n{shown}\n--- printed\n{lines}\n",
            example.line + 1,
            example.command
        );
    }
    text
}

/// The page with what the commands print now, where that is not what it shows.
pub fn updated(page: &str, examples: &[Example], outputs: &[Vec<String>]) -> String {
    let mut lines: Vec<String> = page.lines().map(str::to_owned).collect();
    for (example, output) in examples.iter().zip(outputs).rev() {
        if !fits(&example.shown, output) {
            let start = example.line + example.lines;
            lines.splice(start..start + example.shown.len(), output.iter().cloned());
        }
    }
    lines.join("\n") + "\n"
}
