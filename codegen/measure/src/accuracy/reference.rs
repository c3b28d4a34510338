//! The reference of a kernel: its Maxima text in MPFR, the precision raised until it no longer matters.

use std::collections::BTreeMap;

use closedform_maxima::{Definition, EvalError, Expr, definitions, evaluate_stable};
use closedform_syntax::Kernel;
use miette::{Diagnostic, NamedSource};
use rug::Float;
use thiserror::Error;

/// One definition a result, in order.
#[derive(Clone, Debug)]
pub struct Reference {
    text: String,
    definitions: Vec<Definition>,
}

/// Why a kernel has no reference.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum ReferenceError {
    /// The kernel does not say what it computes.
    #[error("the kernel `{kernel}` states no Maxima definition to compare with")]
    #[diagnostic(help("add `maxima = \"f(x):=..\"` to its attribute, one definition a result"))]
    Missing {
        /// The kernel.
        kernel: String,
    },
    /// The definitions are not Maxima.
    #[error("the Maxima definitions of the kernel `{kernel}` cannot be read")]
    #[diagnostic(help(
        "`closedform generate` makes a generated kernel anew; in one written by hand, correct `maxima`"
    ))]
    Syntax {
        /// The kernel.
        kernel: String,
        /// The definitions.
        #[source_code]
        text: NamedSource<String>,
        /// What is wrong with them.
        #[related]
        mistakes: Vec<closedform_maxima::Error>,
    },
    /// The definitions are of something else.
    #[error("the Maxima definitions of the kernel `{kernel}` are not one a result, of its {inputs} inputs")]
    #[diagnostic(help(
        "`closedform generate` makes a generated kernel anew; in one written by hand, correct `maxima`"
    ))]
    Mismatch {
        /// The kernel.
        kernel: String,
        /// How many inputs the kernel has.
        inputs: usize,
    },
}

/// A point at which a reference has no value.
#[derive(Debug, Error, Diagnostic)]
#[error("the reference `{function}` has no value for {inputs}")]
#[diagnostic(help(
    "leave this point out of the domain: by a condition in a contract NAME.toml beside the worksheet, or by `require!` in a \
     kernel written by hand"
))]
pub struct ValueError {
    /// The function of the worksheet.
    pub function: String,
    /// Names and values.
    pub inputs: String,
    /// The definitions.
    #[source_code]
    pub text: NamedSource<String>,
    /// Why not.
    #[source]
    #[diagnostic_source]
    pub cause: EvalError,
}

impl Reference {
    /// What the kernel says that it computes.
    ///
    /// # Errors
    ///
    /// When it does not say, or says what cannot be read or does not fit.
    pub fn of(kernel: &Kernel) -> Result<Self, ReferenceError> {
        let name = kernel.name.to_string();
        let Some(maxima) = &kernel.meta.maxima else { return Err(ReferenceError::Missing { kernel: name }) };
        let text = terminated(maxima);
        let definitions = definitions(&text).map_err(|errors| ReferenceError::Syntax {
            kernel: name.clone(),
            text: NamedSource::new(name.clone(), text.clone()),
            mistakes: errors.errors,
        })?;
        let inputs = kernel.inputs.len();
        let fits = definitions.iter().all(|definition| definition.parameters.len() == inputs);
        if !fits || definitions.len() != kernel.meta.results.len() {
            return Err(ReferenceError::Mismatch { kernel: name, inputs });
        }
        Ok(Self { text, definitions })
    }

    /// The values of all results at a point, in order, `bits` bits of each right.
    ///
    /// # Errors
    ///
    /// When one of them has no value there.
    pub fn values(&self, point: &[f64], bits: u32) -> Result<Vec<Float>, ValueError> {
        self.definitions.iter().map(|definition| self.value(definition, point, bits)).collect()
    }

    /// The formulas of all results, in order.
    pub fn bodies(&self) -> impl Iterator<Item = &Expr> {
        self.definitions.iter().map(|definition| &definition.body)
    }

    fn value(&self, definition: &Definition, point: &[f64], bits: u32) -> Result<Float, ValueError> {
        let inputs: BTreeMap<String, f64> = definition.parameters.iter().cloned().zip(point.iter().copied()).collect();
        evaluate_stable(&definition.body, &inputs, bits).map_err(|cause| ValueError {
            function: definition.name.clone(),
            inputs: named_values(definition, point),
            text: NamedSource::new(definition.name.clone(), self.text.clone()),
            cause,
        })
    }
}

fn named_values(definition: &Definition, point: &[f64]) -> String {
    let inputs = definition.parameters.iter().zip(point).map(|(name, value)| format!("{name} = {value:?}"));
    inputs.collect::<Vec<_>>().join(", ")
}

/// The definitions as statements.
fn terminated(maxima: &str) -> String {
    let lines = maxima.lines().map(|line| line.trim_end().trim_end_matches(['$', ';'])).filter(|line| !line.is_empty());
    lines.map(|line| format!("{line}$\n")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reference(maxima: &str) -> Result<Reference, ReferenceError> {
        let source = format!("#[kernel({maxima})]\npub fn f(x: f64) -> f64 {{ x }}");
        Reference::of(&closedform_syntax::parse_file(&source).unwrap()[0])
    }

    #[test]
    fn digits_asked_for_are_right() {
        let root = reference(r#"maxima = "f(y):=sqrt(y)""#).unwrap();
        let value = root.values(&[2.0], 200).unwrap().remove(0);
        assert_eq!(value.to_string_radix(10, Some(40)), "1.414213562373095048801688724209698078570");
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        assert!(matches!(reference(""), Err(ReferenceError::Missing { .. })));
        assert!(matches!(reference(r#"maxima = "f(y):=sqrt(y""#), Err(ReferenceError::Syntax { .. })));
        assert!(matches!(reference(r#"maxima = "f(y,z):=y""#), Err(ReferenceError::Mismatch { .. })));
        assert!(matches!(reference(r#"maxima = "f(y):=y\ng(y):=y""#), Err(ReferenceError::Mismatch { .. })));
    }

    #[test]
    fn a_point_without_value_is_named() {
        let error = reference(r#"maxima = "f(y):=1/y""#).unwrap().values(&[0.0], 100).unwrap_err();
        assert_eq!(error.to_string(), "the reference `f` has no value for y = 0.0");
    }
}
