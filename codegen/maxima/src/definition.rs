//! Function definitions among the statements of a worksheet.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::ast::{BinaryOperator, Expr, ExprKind, Statement};
use crate::error::{Error, Errors};
use crate::parse::parse_what_can_be;

/// `f(x,y):=body`, or `define(f(x,y),body)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Definition {
    /// The function.
    pub name: String,
    /// Its parameters.
    pub parameters: Vec<String>,
    /// What it is worth.
    pub body: Expr,
    /// Where the definition stands.
    pub span: Range<usize>,
}

/// A text sorted into definitions and the rest.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Worksheet {
    /// The definitions, in order; a later one of the same name replaces an earlier one in Maxima.
    pub definitions: Vec<Definition>,
    /// Every other statement, in order.
    pub others: Vec<Statement>,
}

/// What a statement defines, if it defines a function whose parameters are names.
#[must_use]
pub fn definition(statement: &Statement) -> Option<Definition> {
    let expression = &statement.expression;
    let (head, body) = match &expression.kind {
        ExprKind::Binary { operator: BinaryOperator::Define, left, right } => (&**left, &**right),
        _ => match expression.as_call()? {
            ("define", [head, body]) => (head, body),
            _ => return None,
        },
    };
    let (name, parameters) = head.as_call()?;
    let parameters = parameters.iter().map(|parameter| parameter.as_symbol().map(str::to_owned));
    Some(Definition {
        name: name.to_owned(),
        parameters: parameters.collect::<Option<_>>()?,
        body: body.clone(),
        span: expression.span.clone(),
    })
}

/// The definitions and the other statements of `text`.
///
/// # Errors
///
/// Everything that is wrong with the text.
pub fn worksheet(text: &str) -> Result<Worksheet, Errors> {
    let (sheet, errors) = readable_worksheet(text);
    if errors.is_empty() { Ok(sheet) } else { Err(Errors { errors }) }
}

/// What of `text` can be read, and everything that is wrong with the rest.
#[must_use]
pub fn readable_worksheet(text: &str) -> (Worksheet, Vec<Error>) {
    let (statements, errors) = parse_what_can_be(text);
    let mut sheet = Worksheet { definitions: Vec::new(), others: Vec::new() };
    for statement in statements {
        match definition(&statement) {
            Some(definition) => sheet.definitions.push(definition),
            None => sheet.others.push(statement),
        }
    }
    (sheet, errors)
}

/// The definitions that `text` consists of, each function once.
///
/// # Errors
///
/// Everything that is wrong with the text, every other statement, every function defined twice.
pub fn definitions(text: &str) -> Result<Vec<Definition>, Errors> {
    let Worksheet { definitions, others } = worksheet(text)?;
    let strangers = others.into_iter().map(|statement| Error::NotADefinition { span: statement.expression.span });
    let mut errors: Vec<Error> = strangers.chain(defined_twice(&definitions)).collect();
    errors.sort_by_key(|error| error.span().start);
    if errors.is_empty() { Ok(definitions) } else { Err(Errors { errors }) }
}

/// Every definition of a function that another one has defined before.
#[must_use]
pub fn defined_twice(definitions: &[Definition]) -> Vec<Error> {
    let mut first: BTreeMap<&str, &Definition> = BTreeMap::new();
    let mut errors = Vec::new();
    for definition in definitions {
        if let Some(earlier) = first.get(definition.name.as_str()) {
            let (name, span) = (definition.name.clone(), definition.span.clone());
            errors.push(Error::DefinedTwice { name, first: earlier.span.clone(), span });
        } else {
            first.insert(&definition.name, definition);
        }
    }
    errors
}
