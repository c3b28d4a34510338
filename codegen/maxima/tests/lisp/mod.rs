//! Expressions as the Lisp trees of Maxima's parser, spelled out so that precedence has no say.

use closedform_maxima::ast::{Branch, LoopClause, LoopWord, Quoting};
use closedform_maxima::{BinaryOperator, Expr, ExprKind, Relation, UnaryOperator, exact};

/// A Lisp string.
pub fn string(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

fn node(head: &str, parts: &[String]) -> String {
    format!("({} {})", string(head), parts.join(" "))
}

/// The name as Maxima's reader stores it: names of one case are inverted.
fn symbol(prefix: char, name: &str) -> String {
    let (upper, lower) = (name.contains(char::is_uppercase), name.contains(char::is_lowercase));
    let stored = match (upper, lower) {
        (false, true) => name.to_uppercase(),
        (true, false) => name.to_lowercase(),
        _ => name.to_owned(),
    };
    node("SYMBOL", &[string(&format!("{prefix}{stored}"))])
}

fn trees(elements: &[Expr]) -> Vec<String> {
    elements.iter().map(tree).collect()
}

/// The tree that Maxima should make of the expression.
pub fn tree(expression: &Expr) -> String {
    match &expression.kind {
        ExprKind::Integer(value) => value.to_string(),
        ExprKind::Float(text) => format!("{:e}", exact::double(text).expect("finite")).replace('e', "d"),
        ExprKind::BigFloat(text) => node("BIGFLOAT-TEXT", &[string(text)]),
        ExprKind::String(text) => node("STRING", &[string(text)]),
        ExprKind::Symbol(name) => symbol('$', name),
        ExprKind::Quote { quoting: Quoting::Noun, expression } => noun(expression),
        ExprKind::Quote { quoting: Quoting::Expression, expression } => node("MQUOTE", &[tree(expression)]),
        ExprKind::Quote { expression, .. } => tree(expression),
        ExprKind::Call { function, arguments } => applied("CALL", verb(function), arguments),
        ExprKind::Subscript { array, indices } => applied("SUBSCRIPT", tree(array), indices),
        ExprKind::List(elements) => node("MLIST", &trees(elements)),
        ExprKind::Set(elements) => applied("CALL", symbol('$', "set"), elements),
        ExprKind::Sequence(elements) => node("MPROGN", &trees(elements)),
        ExprKind::Unary { operator, operand } => unary(*operator, operand),
        ExprKind::Binary { operator, left, right } => binary(*operator, left, right),
        ExprKind::If { branches, otherwise } => condition(branches, otherwise.as_deref()),
        ExprKind::Loop { clauses, body } => repetition(clauses, body),
        ExprKind::Ev { expression, options } => {
            let parts: Vec<Expr> = std::iter::once(&**expression).chain(options).cloned().collect();
            applied("CALL", symbol('$', "ev"), &parts)
        }
    }
}

fn applied(head: &str, function: String, arguments: &[Expr]) -> String {
    node(head, &[vec![function], trees(arguments)].concat())
}

/// A called function: for Maxima `sqrt` is a noun already.
fn verb(function: &Expr) -> String {
    let noun = function.as_symbol() == Some("sqrt");
    if noun { symbol('%', "sqrt") } else { tree(function) }
}

/// `'f(x)` calls the noun `%f`; other expressions are quoted.
fn noun(expression: &Expr) -> String {
    match &expression.kind {
        ExprKind::Call { function, arguments } => applied("CALL", noun_name(function), arguments),
        ExprKind::Subscript { array, indices } => applied("SUBSCRIPT", noun_name(array), indices),
        _ => node("MQUOTE", &[tree(expression)]),
    }
}

fn noun_name(function: &Expr) -> String {
    function.as_symbol().map_or_else(|| noun(function), |name| symbol('%', name))
}

fn unary(operator: UnaryOperator, operand: &Expr) -> String {
    let operand = tree(operand);
    match operator {
        UnaryOperator::Plus => node("PLUS", &[operand]),
        UnaryOperator::Minus => node("MMINUS", &[operand]),
        UnaryOperator::Not => node("MNOT", &[operand]),
        UnaryOperator::Factorial => node("MFACTORIAL", &[operand]),
        UnaryOperator::DoubleFactorial => {
            let half = node("MQUOTIENT", &[operand.clone(), "2".into()]);
            node("CALL", &[symbol('$', "genfact"), operand, half, "2".into()])
        }
    }
}

fn binary(operator: BinaryOperator, left: &Expr, right: &Expr) -> String {
    let (left, right) = (tree(left), tree(right));
    if operator == BinaryOperator::Field {
        return node("CALL", &[symbol('$', "@"), left, right]);
    }
    node(head(operator), &[left, right])
}

fn head(operator: BinaryOperator) -> &'static str {
    use BinaryOperator as B;
    match operator {
        B::Add => "ADD",
        B::Subtract => "SUB",
        B::Multiply => "MTIMES",
        B::Divide => "MQUOTIENT",
        B::Power => "MEXPT",
        B::Dot => "MNCTIMES",
        B::DotPower => "MNCEXPT",
        B::Compare(Relation::Equal) => "MEQUAL",
        B::Compare(Relation::NotEqual) => "MNOTEQUAL",
        B::Compare(Relation::Less) => "MLESSP",
        B::Compare(Relation::LessOrEqual) => "MLEQP",
        B::Compare(Relation::Greater) => "MGREATERP",
        B::Compare(Relation::GreaterOrEqual) => "MGEQP",
        B::And => "MAND",
        B::Or => "MOR",
        B::Assign => "MSETQ",
        B::AssignValue => "MSET",
        B::Define => "MDEFINE",
        B::DefineMacro => "MDEFMACRO",
        B::Field => "@",
    }
}

fn condition(branches: &[Branch], otherwise: Option<&Expr>) -> String {
    let mut parts: Vec<String> =
        branches.iter().flat_map(|branch| [tree(&branch.condition), tree(&branch.value)]).collect();
    parts.push(node("SYMBOL", &[string("T")]));
    parts.push(otherwise.map_or_else(|| symbol('$', "false"), tree));
    node("MCOND", &parts)
}

fn repetition(clauses: &[LoopClause], body: &Expr) -> String {
    let slot = |word| {
        let clause = clauses.iter().find(|clause| clause.word == word);
        clause.map_or_else(|| "(\"NIL\")".to_owned(), |clause| tree(&clause.value))
    };
    let end = clauses.iter().fold(None, |end, clause| stop(clause).map(|stop| join(stop, end.as_deref())).or(end));
    let end = end.unwrap_or_else(|| "(\"NIL\")".to_owned());
    use LoopWord as W;
    let listed = clauses.iter().any(|clause| clause.word == W::In);
    let (head, second) = if listed { ("MDOIN", W::In) } else { ("MDO", W::From) };
    node(head, &[slot(W::For), slot(second), slot(W::Step), slot(W::Next), slot(W::Thru), end, tree(body)])
}

/// The condition that ends the loop.
fn stop(clause: &LoopClause) -> Option<String> {
    match clause.word {
        LoopWord::While => Some(node("MNOT", &[tree(&clause.value)])),
        LoopWord::Unless => Some(tree(&clause.value)),
        _ => None,
    }
}

fn join(later: String, earlier: Option<&str>) -> String {
    match earlier {
        Some(earlier) => node("MOR", &[later, earlier.to_owned()]),
        None => later,
    }
}
