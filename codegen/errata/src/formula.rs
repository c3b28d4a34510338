//! Maxima texts of a row, read before Maxima sees them: what does not parse never reaches it.

use std::ops::Range;

use closedform_maxima::ast::BinaryOperator;
use closedform_maxima::{Expr, ExprKind, Relation, UnaryOperator, parse_expression, print};
use thiserror::Error;

/// A Maxima expression and its place in the TOML file.
#[derive(Debug, Clone, PartialEq)]
pub struct Formula {
    /// What it says.
    pub expression: Expr,
    /// Where its text stands.
    pub place: Range<usize>,
}

impl Formula {
    /// As Maxima text on one line.
    pub fn text(&self) -> String {
        print(&self.expression)
    }
}

/// Why a text is no formula.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FormulaError {
    /// Maxima cannot read it.
    #[error(transparent)]
    Syntax(#[from] closedform_maxima::Error),
    /// It has options, as only a statement has.
    #[error("a formula has no options after a comma")]
    Options(Range<usize>),
    /// It would change what later rows see.
    #[error("a formula defines nothing, and assigns to the variables of a block only")]
    Effect(Range<usize>),
    /// Not a list of numbers for symbols.
    #[error("an example is a list of equations `symbol = number`, its numbers of integers, `+`, `-`, `*`, `/` and `^`")]
    Example(Range<usize>),
    /// Not the call of a function.
    #[error("the formula of a kernel is called as `function(argument, ..)`")]
    Call(Range<usize>),
}

impl FormulaError {
    /// Where in the text.
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::Syntax(error) => error.span(),
            Self::Options(span) | Self::Effect(span) | Self::Example(span) | Self::Call(span) => span.clone(),
        }
    }

    /// What to do about it.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Syntax(_) => "write one Maxima expression, without `;` or `$`",
            Self::Options(_) => "write ev(expression, option) or subst(..) instead",
            Self::Effect(_) => "write what stands right of `:=` or `:`",
            Self::Example(_) => "write e.g. [tIn = 1/50, delta = 1/1250]",
            Self::Call(_) => "write e.g. call = \"tInFn(tOut,tEdgeTotal,a2Max,d2Step)\"",
        }
    }
}

/// The expression that a text is.
pub fn expression(text: &str) -> Result<Expr, FormulaError> {
    let expression = parse_expression(text)?;
    match expression.kind {
        ExprKind::Ev { .. } => Err(FormulaError::Options(expression.span)),
        _ => Ok(expression),
    }
}

/// The expression that a text is, if evaluating it leaves nothing behind.
pub fn form(text: &str) -> Result<Expr, FormulaError> {
    let expression = expression(text)?;
    let effect = effect(&expression, &[]);
    effect.map_or(Ok(expression), |span| Err(FormulaError::Effect(span)))
}

/// The symbols of an example with their numbers.
pub fn example(text: &str) -> Result<Vec<(String, Expr)>, FormulaError> {
    let expression = expression(text)?;
    let ExprKind::List(equations) = &expression.kind else { return Err(FormulaError::Example(expression.span)) };
    let number = |equation: &Expr| match &equation.kind {
        ExprKind::Binary { operator: BinaryOperator::Compare(Relation::Equal), left, right } if is_number(right) => {
            Some((left.as_symbol()?.to_owned(), (**right).clone()))
        }
        _ => None,
    };
    equations.iter().map(|equation| number(equation).ok_or(FormulaError::Example(equation.span.clone()))).collect()
}

/// The function and the arguments of a call.
pub fn call(text: &str) -> Result<(String, Vec<Expr>), FormulaError> {
    let expression = form(text)?;
    match expression.as_call() {
        Some((function, arguments)) => Ok((function.to_owned(), arguments.to_vec())),
        None => Err(FormulaError::Call(expression.span)),
    }
}

/// The symbols of an expression, called functions among them.
pub fn names(expression: &Expr) -> Vec<String> {
    let mut names = Vec::new();
    walk(expression, &mut |part| names.extend(part.as_symbol().map(str::to_owned)));
    names.sort();
    names.dedup();
    names
}

/// Where the expression defines a function or assigns to what is no variable of a block around it.
fn effect(expression: &Expr, variables: &[String]) -> Option<Range<usize>> {
    use BinaryOperator::{Assign, AssignValue, Define, DefineMacro};
    let mut variables = variables.to_vec();
    match &expression.kind {
        ExprKind::Binary { operator: Assign, left, .. }
            if left.as_symbol().is_some_and(|name| is_in(name, &variables)) => {}
        ExprKind::Binary { operator: Assign | AssignValue | Define | DefineMacro, .. } | ExprKind::Loop { .. } => {
            return Some(expression.span.clone());
        }
        _ => variables.extend(block_variables(expression)),
    }
    parts(expression).into_iter().find_map(|part| effect(part, &variables))
}

fn is_in(name: &str, names: &[String]) -> bool {
    names.iter().any(|known| known == name)
}

/// The variables `x`, `y` of `block([x, y: 1], ..)`.
fn block_variables(expression: &Expr) -> Vec<String> {
    let Some(("block", [first, ..])) = expression.as_call() else { return Vec::new() };
    let ExprKind::List(variables) = &first.kind else { return Vec::new() };
    let name = |variable: &Expr| match &variable.kind {
        ExprKind::Binary { operator: BinaryOperator::Assign, left, .. } => left.as_symbol().map(str::to_owned),
        _ => variable.as_symbol().map(str::to_owned),
    };
    variables.iter().filter_map(name).collect()
}

fn is_number(expression: &Expr) -> bool {
    use BinaryOperator::{Add, Divide, Multiply, Power, Subtract};
    match &expression.kind {
        ExprKind::Integer(_) => true,
        ExprKind::Unary { operator: UnaryOperator::Plus | UnaryOperator::Minus, operand } => is_number(operand),
        ExprKind::Binary { operator: Add | Subtract | Multiply | Divide | Power, left, right } => {
            is_number(left) && is_number(right)
        }
        _ => false,
    }
}

/// Visits the expression and all its parts.
fn walk(expression: &Expr, visit: &mut impl FnMut(&Expr)) {
    visit(expression);
    parts(expression).into_iter().for_each(|part| walk(part, visit));
}

fn parts(expression: &Expr) -> Vec<&Expr> {
    match &expression.kind {
        ExprKind::Integer(_) | ExprKind::Float(_) | ExprKind::BigFloat(_) => Vec::new(),
        ExprKind::String(_) | ExprKind::Symbol(_) => Vec::new(),
        ExprKind::Quote { expression, .. } => vec![expression],
        ExprKind::Call { function: head, arguments: rest }
        | ExprKind::Subscript { array: head, indices: rest }
        | ExprKind::Ev { expression: head, options: rest } => std::iter::once(&**head).chain(rest).collect(),
        ExprKind::List(elements) | ExprKind::Set(elements) | ExprKind::Sequence(elements) => elements.iter().collect(),
        ExprKind::Unary { operand, .. } => vec![operand],
        ExprKind::Binary { left, right, .. } => vec![left, right],
        ExprKind::If { branches, otherwise } => {
            let branches = branches.iter().flat_map(|branch| [&branch.condition, &branch.value]);
            branches.chain(otherwise.as_deref()).collect()
        }
        ExprKind::Loop { clauses, body } => {
            clauses.iter().map(|clause| &clause.value).chain(std::iter::once(&**body)).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms_of_a_scan_are_read() {
        for text in ["[a = b, [c < d]]", "'diff(t,v) = x^2", "1/(3*t)", "a # b", "[]", "-f[1](x)"] {
            assert!(form(text).is_ok(), "{text}");
        }
        assert!(matches!(form("(a+b"), Err(FormulaError::Syntax(_))));
        assert!(matches!(form("a, b"), Err(FormulaError::Options(_))));
        assert_eq!(form("[a, f(x) := x]"), Err(FormulaError::Effect(4..13)));
        assert!(matches!(form("[a: 1]"), Err(FormulaError::Effect(_))));
        assert!(form("block([a, b: 2], a: 1, a+b)").is_ok());
        assert!(matches!(form("block([a], b: 1, a+b)"), Err(FormulaError::Effect(_))));
        assert!(matches!(form("a; b"), Err(FormulaError::Syntax(_))));
    }

    #[test]
    fn examples_are_exact() {
        let names: Vec<String> = example("[a = 1/50, b = -2^3]").unwrap().into_iter().map(|(name, _)| name).collect();
        assert_eq!(names, ["a", "b"]);
        for text in ["a = 1", "[a = 0.5]", "[a = b]", "[1 = 1]", "[a]"] {
            assert!(matches!(example(text), Err(FormulaError::Example(_))), "{text}");
        }
    }

    #[test]
    fn names_come_once() {
        assert_eq!(names(&expression("rhs(out1[2])+x*rhs(y)").unwrap()), ["out1", "rhs", "x", "y"]);
    }
}
