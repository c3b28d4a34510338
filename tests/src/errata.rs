//! What the verdicts on the errata claim of kernels: rows of `errata/FAMILY.toml` that name a reference function.

use std::collections::BTreeMap;

use closedform_maxima::ast::BinaryOperator;
use closedform_maxima::{Expr, ExprKind, Relation, parse_expression};
use rug::Rational;
use toml::{Table, Value};

use crate::rational::{self, Names};
use crate::worksheets;

/// A row that names kernels.
#[derive(Clone, Debug)]
pub struct Row {
    /// Section, label, name.
    pub cell: String,
    /// Whether what the cell gives is said to be wrong.
    pub is_error: bool,
    /// What is printed, as it is to be read.
    pub printed: Expr,
    /// Symbols with exact numbers; none where the row has no example.
    pub example: Vec<(String, Rational)>,
    /// What it claims.
    pub claims: Vec<Claim>,
}

/// That a true form is the value of a reference function.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The function.
    pub function: String,
    /// What it is applied to, over the variables of the row.
    pub arguments: Vec<Expr>,
    /// Which element of a list is meant, from 1, outermost first.
    pub part: Vec<usize>,
    /// The true form.
    pub truth: Expr,
}

/// The families that have errata.
pub fn families() -> Vec<String> {
    worksheets::families_in("errata", "toml")
}

/// The rows of all families that name kernels, each with its family.
pub fn rows() -> Vec<(String, Row)> {
    let rows = |family: String| load(&family).into_iter().map(move |row| (family.clone(), row));
    families().into_iter().flat_map(rows).collect()
}

/// The rows of a family that name kernels.
///
/// # Panics
///
/// The file is not what it should be.
pub fn load(family: &str) -> Vec<Row> {
    let path = format!("errata/{family}");
    parse(&worksheets::read(&path, "toml")).unwrap_or_else(|error| panic!("{path}.toml: {error}"))
}

/// The rows of a text that name kernels.
pub fn parse(text: &str) -> Result<Vec<Row>, String> {
    let table: Table = text.parse().map_err(|error: toml::de::Error| error.to_string())?;
    let outputs = table.get("output").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let rows = outputs.iter().filter(|output| output.get("kernel").is_some());
    rows.map(|output| row(output).map_err(|error| format!("{}: {error}", output["cell"]))).collect()
}

/// The element of nested lists at a path: the left side of an equation, and the right side or the whole.
pub fn part<'a>(form: &'a Expr, path: &[usize]) -> Option<(Option<&'a Expr>, &'a Expr)> {
    match (&form.kind, path) {
        (ExprKind::Binary { operator: BinaryOperator::Compare(Relation::Equal), left, right }, []) => {
            Some((Some(left), right))
        }
        (ExprKind::List(_), []) => None,
        (_, []) => Some((None, form)),
        (ExprKind::List(elements), [first, rest @ ..]) => part(elements.get(first.checked_sub(1)?)?, rest),
        _ => None,
    }
}

/// Expressions by the variables of a block that they are assigned to.
type Bound = BTreeMap<String, Expr>;

/// The expression without its blocks: what `block([x], x: a, f(x))` assigns is put into its last expression.
fn unfolded(form: &Expr, bound: &Bound) -> Expr {
    let each = |parts: &[Expr]| parts.iter().map(|part| unfolded(part, bound)).collect();
    let inside = |part: &Expr| Box::new(unfolded(part, bound));
    let kind = match &form.kind {
        ExprKind::Symbol(name) => return bound.get(name).unwrap_or(form).clone(),
        ExprKind::Call { function, arguments } => match (function.as_symbol(), arguments.as_slice()) {
            (Some("block"), [variables, steps @ .., last]) => {
                let first = if let ExprKind::List(variables) = &variables.kind { variables.as_slice() } else { &[] };
                return unfolded(last, &assigned(steps, &assigned(first, bound)));
            }
            // The bars of a vector, as the derivation of the cuts calls them.
            (Some("length_"), [vector]) => return unfolded(&length(vector), bound),
            _ => ExprKind::Call { function: function.clone(), arguments: each(arguments) },
        },
        ExprKind::List(elements) => ExprKind::List(each(elements)),
        ExprKind::Unary { operator, operand } => ExprKind::Unary { operator: *operator, operand: inside(operand) },
        ExprKind::Binary { operator, left, right } => {
            ExprKind::Binary { operator: *operator, left: inside(left), right: inside(right) }
        }
        other => other.clone(),
    };
    Expr::new(kind, form.span.clone())
}

/// The square root of the sum of the squares.
fn length(vector: &Expr) -> Expr {
    let ExprKind::List(elements) = &vector.kind else { return vector.clone() };
    let square = |element: &Expr| {
        let exponent = Box::new(Expr::from(ExprKind::Integer(2.into())));
        Expr::from(ExprKind::Binary {
            operator: BinaryOperator::Power,
            left: Box::new(element.clone()),
            right: exponent,
        })
    };
    let add = |left: Expr, right: Expr| {
        Expr::from(ExprKind::Binary { operator: BinaryOperator::Add, left: Box::new(left), right: Box::new(right) })
    };
    let sum = elements.iter().map(square).reduce(add).unwrap_or_else(|| vector.clone());
    let function = Box::new(Expr::from(ExprKind::Symbol("sqrt".to_owned())));
    ExprKind::Call { function, arguments: vec![sum] }.into()
}

fn assigned(steps: &[Expr], outer: &Bound) -> Bound {
    let mut bound = outer.clone();
    for step in steps {
        if let ExprKind::Binary { operator: BinaryOperator::Assign, left, right } = &step.kind
            && let Some(name) = left.as_symbol()
        {
            let value = unfolded(right, &bound);
            bound.insert(name.to_owned(), value);
        }
    }
    bound
}

fn row(output: &Value) -> Result<Row, String> {
    let text = |key: &str| output.get(key).and_then(Value::as_str);
    let parse = |text: &str| match parse_expression(text) {
        Ok(form) => Ok(unfolded(&form, &Bound::new())),
        Err(error) => Err(format!("`{text}`: {error}")),
    };
    let printed = text("reads").or(text("printed")).ok_or("neither `reads` nor `printed`")?;
    let truth = parse(text("right").unwrap_or(printed))?;
    let kernels = output["kernel"].as_array().ok_or("`kernel` is no array of tables")?;
    Ok(Row {
        cell: text("cell").ok_or("no `cell`")?.to_owned(),
        is_error: text("verdict") == Some("worksheet error"),
        printed: parse(printed)?,
        example: text("example").map_or(Ok(Vec::new()), |text| example(&parse(text)?))?,
        claims: kernels.iter().map(|kernel| claim(kernel, &truth)).collect::<Result<_, _>>()?,
    })
}

fn claim(kernel: &Value, truth: &Expr) -> Result<Claim, String> {
    let call = kernel.get("call").and_then(Value::as_str).ok_or("a kernel without `call`")?;
    let parsed = parse_expression(call).map_err(|error| format!("`{call}`: {error}"))?;
    let (function, arguments) = parsed.as_call().ok_or_else(|| format!("`{call}` is no call"))?;
    let steps = kernel.get("part").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let path: Vec<usize> = steps.iter().filter_map(|step| usize::try_from(step.as_integer()?).ok()).collect();
    let (_, truth) = part(truth, &path).ok_or_else(|| format!("the right form has no part {path:?} for `{call}`"))?;
    Ok(Claim { function: function.to_owned(), arguments: arguments.to_vec(), part: path, truth: truth.clone() })
}

fn example(list: &Expr) -> Result<Vec<(String, Rational)>, String> {
    let ExprKind::List(equations) = &list.kind else { return Err("an example is a list".to_owned()) };
    let number = |equation: &Expr| match &equation.kind {
        ExprKind::Binary { operator: BinaryOperator::Compare(Relation::Equal), left, right } => {
            Some((left.as_symbol()?.to_owned(), rational::value(right, &Names::new())?))
        }
        _ => None,
    };
    equations.iter().map(|equation| number(equation).ok_or_else(|| format!("`{equation}` in an example"))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROWS: &str = "[[output]]\ncell = 'a'\nprinted = 'x'\n[[output]]\ncell = 'b'\nprinted = '[x = 2, [y = 3*z]]'\n\
                        example = '[z = 1/3]'\n[[output.kernel]]\ncall = 'f(z,2*y)'\npart = [2, 1]\n";

    #[test]
    fn blocks_are_unfolded() {
        let plain = |text| unfolded(&parse_expression(text).expect("it parses"), &Bound::new()).to_string();
        assert_eq!(plain("block([c: a+b, d], d: c^2, [d = c*x])"), "[(a+b)^2=(a+b)*x]");
        assert_eq!(plain("x/length_([x,y])"), "x/sqrt(x^2+y^2)");
    }

    #[test]
    fn claims_are_found_with_their_part() {
        let rows = parse(ROWS).expect("it parses");
        assert_eq!(rows.len(), 1);
        assert_eq!(rows[0].example, [("z".to_owned(), Rational::from((1, 3)))]);
        let claim = &rows[0].claims[0];
        assert_eq!((claim.function.as_str(), claim.truth.to_string().as_str()), ("f", "3*z"));
        assert_eq!(claim.arguments.len(), 2);
        assert!(parse(&ROWS.replace("[2, 1]", "[2]")).is_err());
        assert!(parse(&ROWS.replace("[2, 1]", "[3]")).is_err());
    }
}
