//! Inputs as people write them: names of Rust or the worksheet, decimal or hexadecimal numbers.

use miette::Diagnostic;
use thiserror::Error;

use closedform_measure::catalogue::{Entry, maxima_name, nearest, unit_of};
use closedform_project::hexfloat;

/// Why inputs do not fit a kernel: every reason.
#[derive(Debug, Error, Diagnostic)]
#[error("these are not the inputs of `{kernel}`")]
#[diagnostic(help("it takes {expected}"))]
pub struct InputsError {
    /// The kernel.
    pub kernel: String,
    /// Its inputs.
    pub expected: String,
    /// The reasons.
    #[related]
    pub mistakes: Vec<InputMistake>,
}

/// What is wrong with an input.
#[derive(Debug, PartialEq, Eq, Error, Diagnostic)]
pub enum InputMistake {
    /// No value.
    #[error("`{0}` gives no input a value")]
    #[diagnostic(help("write name=value"))]
    Form(String),
    /// No such input.
    #[error("no input is called `{name}`")]
    #[diagnostic(help("{}", nearest.as_ref().map_or("leave it out".to_owned(), |name| format!("did you mean `{name}`?"))))]
    Unknown {
        /// The name.
        name: String,
        /// An input of nearly this name.
        nearest: Option<String>,
    },
    /// Two values.
    #[error("the input `{0}` is given twice")]
    #[diagnostic(help("give it once, by its Rust or its Maxima name"))]
    Twice(String),
    /// No value.
    #[error("the input `{0}` is missing")]
    #[diagnostic(help("add it"))]
    Missing(String),
    /// No number.
    #[error("the input `{name}`: {cause}")]
    #[diagnostic(help("write a decimal number such as -1.5e-3, or an exact one such as -0x1.8p-3"))]
    Value {
        /// The name.
        name: String,
        /// Why.
        cause: ValueError,
    },
}

/// Why a text is no number.
#[derive(Debug, PartialEq, Eq, Error)]
pub enum ValueError {
    /// Neither decimal nor hexadecimal.
    #[error("`{0}` is not a number")]
    Decimal(String),
    /// Hexadecimal, but not a double.
    #[error(transparent)]
    Hexadecimal(#[from] hexfloat::HexFloatError),
}

/// The point that `name=value` arguments describe.
///
/// # Errors
///
/// Everything that keeps them from being the inputs of the kernel.
pub fn point(entry: &Entry, arguments: &[String]) -> Result<Vec<f64>, InputsError> {
    let mut mistakes = Vec::new();
    let (mut names, mut values) = (Vec::new(), Vec::new());
    for argument in arguments {
        match argument.split_once('=') {
            Some((name, value)) => {
                names.push(name.trim());
                values.push(value);
            }
            None => mistakes.push(InputMistake::Form(argument.clone())),
        }
    }
    let places = places(entry, &names, &mut mistakes);
    let point: Vec<Option<f64>> =
        places.iter().map(|place| number(names[*place], values[*place], &mut mistakes)).collect();
    complete(entry, point.into_iter().flatten().collect(), mistakes)
}

/// For every input of the kernel the column of a table that holds it.
///
/// # Errors
///
/// Everything that keeps the names from being those of the kernel's inputs.
pub fn columns(entry: &Entry, names: &[&str]) -> Result<Vec<usize>, InputsError> {
    let mut mistakes = Vec::new();
    let places = places(entry, names, &mut mistakes);
    complete(entry, places, mistakes)
}

/// A number, decimal or hexadecimal.
///
/// # Errors
///
/// When the text is neither.
pub fn value(text: &str) -> Result<f64, ValueError> {
    let text = text.trim();
    let digits = text.trim_start_matches(['+', '-']);
    if digits.starts_with("0x") || digits.starts_with("0X") {
        return Ok(hexfloat::parse(text)?);
    }
    text.parse().map_err(|_| ValueError::Decimal(text.to_owned()))
}

fn number(name: &str, text: &str, mistakes: &mut Vec<InputMistake>) -> Option<f64> {
    let value = value(text);
    value.map_err(|cause| mistakes.push(InputMistake::Value { name: name.to_owned(), cause })).ok()
}

/// Where in `names` each input stands; those that are missing are mistakes.
fn places(entry: &Entry, names: &[&str], mistakes: &mut Vec<InputMistake>) -> Vec<usize> {
    let mut places = vec![None; entry.kernel.inputs.len()];
    for (place, name) in names.iter().enumerate() {
        match entry.input_called(name) {
            Some(input) if places[input].is_none() => places[input] = Some(place),
            Some(input) => mistakes.push(InputMistake::Twice(entry.kernel.inputs[input].name.to_string())),
            None => mistakes.push(unknown(entry, name)),
        }
    }
    for (input, place) in entry.kernel.inputs.iter().zip(&places) {
        if place.is_none() {
            mistakes.push(InputMistake::Missing(input.name.to_string()));
        }
    }
    places.into_iter().flatten().collect()
}

fn unknown(entry: &Entry, name: &str) -> InputMistake {
    let spellings = entry.kernel.inputs.iter().flat_map(|input| {
        [input.name.to_string(), maxima_name(input)].map(|spelling| (spelling, input.name.to_string()))
    });
    let nearest = nearest(name, spellings).into_iter().next();
    InputMistake::Unknown { name: name.to_owned(), nearest }
}

fn complete<T>(entry: &Entry, found: Vec<T>, mistakes: Vec<InputMistake>) -> Result<Vec<T>, InputsError> {
    if mistakes.is_empty() {
        return Ok(found);
    }
    Err(InputsError { kernel: entry.full_name(), expected: expected(entry), mistakes })
}

/// The inputs of a kernel in words.
fn expected(entry: &Entry) -> String {
    let inputs = entry.kernel.inputs.iter().map(|input| {
        let (name, maxima) = (input.name.to_string(), maxima_name(input));
        let name = if name == maxima { name } else { format!("{name} (or {maxima})") };
        match unit_of(&input.unit) {
            "1" => name,
            unit => format!("{name} in {unit}"),
        }
    });
    inputs.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use closedform_measure::catalogue::fixture;

    fn given(arguments: &[&str]) -> Result<Vec<f64>, InputsError> {
        let (_folder, catalogue) = fixture::catalogue();
        let arguments: Vec<String> = arguments.iter().map(|argument| argument.to_string()).collect();
        point(catalogue.find("line::root").unwrap(), &arguments)
    }

    #[test]
    fn inputs_come_in_any_order_under_both_names() {
        assert_eq!(given(&["b=-2", "a_max=0x1.8p-3"]).unwrap(), [0.1875, -2.0]);
        assert_eq!(given(&["aMax=1e3", "b=-0x1p0"]).unwrap(), [1000.0, -1.0]);
    }

    #[test]
    fn every_mistake_is_named() {
        let error = given(&["c=1", "a_max=1", "aMax=2", "nothing", "b=1,5"]).unwrap_err();
        let messages: Vec<String> = error.mistakes.iter().map(ToString::to_string).collect();
        assert_eq!(
            messages,
            [
                "`nothing` gives no input a value",
                "no input is called `c`",
                "the input `a_max` is given twice",
                "the input `b`: `1,5` is not a number",
            ]
        );
        assert_eq!(error.expected, "a_max (or aMax) in s, b in s^2");
        let error = given(&[]).unwrap_err();
        assert_eq!(error.mistakes.len(), 2);
    }

    #[test]
    fn numbers_are_decimal_or_hexadecimal() {
        assert_eq!(value(" 1.5e-3 "), Ok(1.5e-3));
        assert_eq!(value("-0X1p-1"), Ok(-0.5));
        for text in ["", "one", "0x", "1.5.2", "0x1.00000000000001p0"] {
            assert!(value(text).is_err(), "{text}");
        }
    }
}
