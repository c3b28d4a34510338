//! Reference expressions against their contract.

use std::collections::BTreeSet;
use std::path::Path;

use closedform_maxima::ast::Branch;
use closedform_maxima::{BinaryOperator, Definition, Expr, ExprKind, Relation, UnaryOperator, definitions};
use miette::{Diagnostic, SourceSpan};
use thiserror::Error;

use super::super::contract::Contract;
use super::super::source::{self, Text};
use crate::expression::{
    LowerError, is_function_of_one, is_known_constant, known_functions, lower_errors, remedy_of_constant,
    remedy_of_function,
};

/// Why a text does not hold the reference expressions of a contract.
#[derive(Debug, Error, Diagnostic)]
#[error("the reference expressions do not fit the contract: {count}")]
pub struct ReferenceError {
    /// How much is wrong.
    count: String,
    /// The text.
    #[source_code]
    pub text: Text,
    /// What is wrong, the first of it.
    #[related]
    pub mistakes: Vec<ReferenceMistake>,
}

/// One mistake in reference expressions, with its place.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum ReferenceMistake {
    /// The text is not Maxima.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Text(#[from] closedform_maxima::Error),
    /// A result without its expression.
    #[error("there is no reference expression `{worksheet}` for the kernel `{kernel}`")]
    #[diagnostic(help("run `closedform derive` after changing a contract"))]
    Missing {
        /// The function.
        worksheet: String,
        /// The kernel.
        kernel: String,
    },
    /// An expression that no result asks for.
    #[error("no kernel has a result `{worksheet}`")]
    #[diagnostic(help("run `closedform derive` after changing a contract"))]
    Extra {
        /// The function.
        worksheet: String,
        /// Where.
        #[label("the contract does not name this function")]
        span: SourceSpan,
    },
    /// Other parameters than the kernel has inputs.
    #[error("the parameters of `{worksheet}` are ({found}), but the inputs of its kernel are ({expected})")]
    #[diagnostic(help("give worksheet and contract the same inputs in the same order, then run `closedform derive`"))]
    Parameters {
        /// The function.
        worksheet: String,
        /// What it takes.
        found: String,
        /// What the kernel takes.
        expected: String,
        /// Where.
        #[label("takes ({found})")]
        span: SourceSpan,
    },
    /// A variable from nowhere.
    #[error("`{worksheet}` contains `{name}`, which is not one of its parameters")]
    #[diagnostic(help("let the worksheet eliminate it, or make it an input of the kernel"))]
    UnknownVariable {
        /// The function.
        worksheet: String,
        /// The variable.
        name: String,
        /// Where.
        #[label("not a parameter")]
        span: SourceSpan,
    },
    /// A function that no kernel can compute.
    #[error("`{worksheet}` calls `{name}`, which kernels cannot compute")]
    #[diagnostic(help(
        "kernels know + - * / ^, {} and positive_root(polynomial, x){}",
        known_functions(),
        remedy_of_function(name).map(|remedy| format!("; {remedy}")).unwrap_or_default()
    ))]
    UnknownFunction {
        /// The function.
        worksheet: String,
        /// What it calls.
        name: String,
        /// Where.
        #[label("not known to kernels")]
        span: SourceSpan,
    },
    /// Arithmetic that no kernel can be made of.
    #[error("`{worksheet}`: {what}")]
    #[diagnostic(help("{remedy}"))]
    Unsupported {
        /// The function.
        worksheet: String,
        /// What is wrong.
        what: String,
        /// What to write instead.
        remedy: String,
        /// Where.
        #[label("here")]
        span: SourceSpan,
    },
    /// Not arithmetic at all.
    #[error("`{worksheet}` is not a closed form: {what}")]
    #[diagnostic(help("kernels know + - * / ^, {} and positive_root(polynomial, x)", known_functions()))]
    NotArithmetic {
        /// The function.
        worksheet: String,
        /// Why not.
        what: &'static str,
        /// Where.
        #[label("here")]
        span: SourceSpan,
    },
}

impl ReferenceMistake {
    /// The result that it is about.
    pub(super) fn worksheet(&self) -> Option<&str> {
        match self {
            Self::Text(_) => None,
            Self::Missing { worksheet, .. }
            | Self::Extra { worksheet, .. }
            | Self::Parameters { worksheet, .. }
            | Self::UnknownVariable { worksheet, .. }
            | Self::UnknownFunction { worksheet, .. }
            | Self::Unsupported { worksheet, .. }
            | Self::NotArithmetic { worksheet, .. } => Some(worksheet),
        }
    }

    /// Where it is, if it has a place.
    pub(super) fn span(&self) -> Option<SourceSpan> {
        match self {
            Self::Text(error) => Some(error.span().into()),
            Self::Missing { .. } => None,
            Self::Extra { span, .. }
            | Self::Parameters { span, .. }
            | Self::UnknownVariable { span, .. }
            | Self::UnknownFunction { span, .. }
            | Self::Unsupported { span, .. }
            | Self::NotArithmetic { span, .. } => Some(*span),
        }
    }
}

/// The definitions of the text in contract order, or all that is wrong with them.
pub(super) fn check(path: &Path, text: &str, contract: &Contract) -> Result<Vec<Definition>, ReferenceError> {
    let fail = |mistakes: Vec<ReferenceMistake>| ReferenceError {
        count: source::count(mistakes.len()),
        text: source::named(path, text),
        mistakes: mistakes.into_iter().take(source::SHOWN).collect(),
    };
    let found = definitions(text).map_err(|errors| fail(errors.errors.into_iter().map(Into::into).collect()))?;
    in_order(found, contract).map_err(fail)
}

/// The definitions in contract order, or all that is wrong with them.
pub(super) fn in_order(found: Vec<Definition>, contract: &Contract) -> Result<Vec<Definition>, Vec<ReferenceMistake>> {
    let mut mistakes = Vec::new();
    let mut ordered = Vec::new();
    for (kernel, result) in contract.results() {
        match found.iter().find(|definition| definition.name == result.worksheet) {
            Some(definition) => {
                mistakes.extend(mistakes_of(definition, &kernel.inputs));
                ordered.push(definition.clone());
            }
            None => {
                let (worksheet, kernel) = (result.worksheet.clone(), kernel.name.clone());
                mistakes.push(ReferenceMistake::Missing { worksheet, kernel });
            }
        }
    }
    for extra in found.iter().filter(|d| contract.results().all(|(_, result)| result.worksheet != d.name)) {
        mistakes.push(ReferenceMistake::Extra { worksheet: extra.name.clone(), span: extra.span.clone().into() });
    }
    let mistakes = first_of_each(mistakes);
    if mistakes.is_empty() { Ok(ordered) } else { Err(mistakes) }
}

/// Everything about a definition that does not fit a kernel of these inputs.
pub(super) fn mistakes_of(definition: &Definition, inputs: &[String]) -> Vec<ReferenceMistake> {
    wrong_parameters(definition, inputs).into_iter().chain(body_mistakes(definition)).collect()
}

/// Without what was said before: an unknown function is told where it stands first.
pub(super) fn first_of_each(mut mistakes: Vec<ReferenceMistake>) -> Vec<ReferenceMistake> {
    let mut functions = BTreeSet::new();
    let mut variables = BTreeSet::new();
    mistakes.retain(|mistake| match mistake {
        ReferenceMistake::UnknownFunction { name, .. } => functions.insert(name.clone()),
        ReferenceMistake::UnknownVariable { worksheet, name, .. } => {
            variables.insert((worksheet.clone(), name.clone()))
        }
        _ => true,
    });
    mistakes
}

fn wrong_parameters(definition: &Definition, inputs: &[String]) -> Option<ReferenceMistake> {
    (definition.parameters != inputs).then(|| ReferenceMistake::Parameters {
        worksheet: definition.name.clone(),
        found: definition.parameters.join(","),
        expected: inputs.join(","),
        span: definition.span.clone().into(),
    })
}

/// Everything in the body of a definition that a kernel cannot compute.
fn body_mistakes(definition: &Definition) -> Vec<ReferenceMistake> {
    let mut body = Body { definition, bound: Vec::new(), mistakes: Vec::new() };
    body.expression(&definition.body);
    lower_errors(&definition.body).into_iter().for_each(|error| body.unsupported(error));
    body.mistakes
}

struct Body<'a> {
    definition: &'a Definition,
    /// Variables of the roots around the current place.
    bound: Vec<&'a str>,
    mistakes: Vec<ReferenceMistake>,
}

impl<'a> Body<'a> {
    fn expression(&mut self, expression: &'a Expr) {
        match &expression.kind {
            ExprKind::Integer(_) | ExprKind::Float(_) | ExprKind::BigFloat(_) => (),
            ExprKind::Symbol(name) => self.variable(name, expression),
            ExprKind::Unary { operator: UnaryOperator::Plus | UnaryOperator::Minus, operand } => {
                self.expression(operand)
            }
            ExprKind::Unary { operator: UnaryOperator::Factorial, .. } => self.unknown("factorial", expression),
            ExprKind::Unary { operator: UnaryOperator::DoubleFactorial, .. } => {
                self.unknown("double_factorial", expression);
            }
            ExprKind::Binary { operator, left, right } if is_arithmetic(*operator) => {
                self.expression(left);
                self.expression(right);
            }
            ExprKind::Call { .. } => self.call(expression),
            ExprKind::If { branches, otherwise } => {
                for Branch { condition, value } in branches {
                    self.condition(condition);
                    self.expression(value);
                }
                otherwise.iter().for_each(|value| self.expression(value));
            }
            _ => self.not_arithmetic(expression),
        }
    }

    /// A condition of an `if`.
    fn condition(&mut self, condition: &'a Expr) {
        match &condition.kind {
            ExprKind::Unary { operator: UnaryOperator::Not, operand } => self.condition(operand),
            ExprKind::Binary { operator: BinaryOperator::And | BinaryOperator::Or, left, right } => {
                self.condition(left);
                self.condition(right);
            }
            ExprKind::Binary { operator: BinaryOperator::Compare(_), left, right } => {
                self.expression(left);
                self.expression(right);
            }
            // what is no comparison is refused with the whole
            _ => {}
        }
    }

    fn variable(&mut self, name: &'a str, place: &Expr) {
        let known = is_known_constant(name)
            || self.bound.contains(&name)
            || self.definition.parameters.iter().any(|p| p == name);
        // the constants of Maxima that kernels do not know have a word of their own
        if !known && remedy_of_constant(name).is_none() {
            let (worksheet, name) = (self.definition.name.clone(), name.to_owned());
            let span = place.span.clone().into();
            self.mistakes.push(ReferenceMistake::UnknownVariable { worksheet, name, span });
        }
    }

    fn call(&mut self, expression: &'a Expr) {
        match expression.as_call() {
            Some((name, [argument])) if is_function_of_one(name) => self.expression(argument),
            Some(("max" | "min", items @ [_, _, ..]) | ("atan2" | "mod", items @ [_, _])) => {
                items.iter().for_each(|item| self.expression(item))
            }
            Some(("positive_root", [polynomial, variable])) => self.root(polynomial, variable),
            Some((name, _)) => self.unknown(name, expression),
            None => self.not_arithmetic(expression),
        }
    }

    fn unknown(&mut self, function: &str, place: &Expr) {
        let (worksheet, name, span) = (self.definition.name.clone(), function.to_owned(), place.span.clone().into());
        self.mistakes.push(ReferenceMistake::UnknownFunction { worksheet, name, span });
    }

    /// The variable of a root means something inside the polynomial only, so it cannot be a parameter too.
    fn root(&mut self, polynomial: &'a Expr, variable: &'a Expr) {
        match variable.as_symbol() {
            Some(name) if !self.definition.parameters.iter().any(|parameter| parameter == name) => {
                self.bound.push(name);
                self.expression(polynomial);
                self.bound.pop();
            }
            _ => self.not_arithmetic(variable),
        }
    }

    /// Says why the generator does not take a part, unless something has been said of that part.
    fn unsupported(&mut self, error: LowerError) {
        let span = SourceSpan::from(error.span);
        if self.mistakes.iter().all(|mistake| mistake.span() != Some(span)) {
            let worksheet = self.definition.name.clone();
            self.mistakes.push(ReferenceMistake::Unsupported {
                worksheet,
                what: error.what,
                remedy: error.remedy,
                span,
            });
        }
    }

    fn not_arithmetic(&mut self, place: &Expr) {
        let (worksheet, span) = (self.definition.name.clone(), place.span.clone().into());
        self.mistakes.push(ReferenceMistake::NotArithmetic { worksheet, what: no_number(place), span });
    }
}

/// Why something is no number, in words.
fn no_number(place: &Expr) -> &'static str {
    match &place.kind {
        ExprKind::Binary { operator: BinaryOperator::Compare(Relation::Equal), .. } => "an equation is no number",
        ExprKind::Binary {
            operator: BinaryOperator::Compare(_) | BinaryOperator::And | BinaryOperator::Or, ..
        }
        | ExprKind::Unary { operator: UnaryOperator::Not, .. } => "a condition is no number",
        ExprKind::List(_) => "a list is no number",
        ExprKind::Set(_) => "a set is no number",
        ExprKind::String(_) => "a text is no number",
        ExprKind::Quote { .. } => "what is quoted is no number",
        ExprKind::Symbol(_) => "the unknown of a root is a parameter too",
        _ => "this is no arithmetic",
    }
}

fn is_arithmetic(operator: BinaryOperator) -> bool {
    use BinaryOperator::{Add, Divide, Multiply, Power, Subtract};
    matches!(operator, Add | Subtract | Multiply | Divide | Power)
}
