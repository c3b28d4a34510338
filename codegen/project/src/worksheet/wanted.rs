//! What to ask Maxima for when it has run a worksheet: the names that its statements define.

use closedform_maxima::ast::LoopWord;
use closedform_maxima::{Expr, ExprKind, UnaryOperator, parse_what_can_be};

use super::defined::{Kind, definitions};
use super::tree::{any, names};

/// A name that a worksheet defines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Wanted {
    /// The name.
    pub(crate) name: String,
    /// The parameters, of a function.
    pub(crate) parameters: Option<Vec<String>>,
    /// Why Maxima is not asked for it, if it is not.
    pub(crate) not_asked: Option<&'static str>,
    /// Where it is defined.
    pub(crate) start: usize,
}

/// The names that statements at the top of a worksheet define, in the order in which they do so last.
pub(crate) fn wanted(text: &str) -> Vec<Wanted> {
    let (statements, _) = parse_what_can_be(text);
    let mut found: Vec<Wanted> = Vec::new();
    for statement in &statements {
        for (name, kind) in definitions(&statement.expression) {
            let start = statement.expression.span.start;
            let wanted = match kind {
                Kind::Variable => Wanted { name, parameters: None, not_asked: None, start },
                Kind::Function => of_function(name, &statement.expression, start),
            };
            found.retain(|earlier| earlier.name != wanted.name);
            found.push(wanted);
        }
    }
    found
}

fn of_function(name: String, statement: &Expr, start: usize) -> Wanted {
    let parts = match &statement.kind {
        ExprKind::Binary { left, right, .. } => Some((&**left, &**right)),
        _ => match statement.as_call() {
            Some(("define", [head, body])) => Some((head, body)),
            _ => None,
        },
    };
    let head = parts.and_then(|(head, _)| head.as_call());
    let parameters: Option<Vec<String>> = head
        .map(|(_, parameters)| parameters.iter().map(|name| name.as_symbol().map(str::to_owned)).collect())
        .unwrap_or_default();
    let not_asked = match (&parameters, parts) {
        (Some(parameters), Some((_, body))) => {
            is_program(body, parameters).then_some("a program: it prints, reads, or loops as often as its inputs say")
        }
        _ => Some("its parameters are not names"),
    };
    Wanted { name, parameters: Some(parameters.unwrap_or_default()), not_asked, start }
}

/// Functions that talk to people or files.
const TALKING: [&str; 9] = ["disp", "display", "ldisp", "ldisplay", "print", "printf", "read", "readonly", "grind"];

/// Whether a function is no formula: it talks, or loops under conditions or as often as its parameters say.
fn is_program(body: &Expr, parameters: &[String]) -> bool {
    let steers = |part: &Expr| names(part).iter().any(|name| parameters.contains(name));
    any(body, &|part| match &part.kind {
        ExprKind::Call { .. } => part.as_call().is_some_and(|(name, _)| TALKING.contains(&name)),
        ExprKind::Loop { clauses, .. } => clauses
            .iter()
            .any(|clause| matches!(clause.word, LoopWord::While | LoopWord::Unless) || steers(&clause.value)),
        _ => false,
    })
}

/// Facts of Maxima that say something about numbers, as they are written.
pub(crate) fn is_about_numbers(fact: &Expr) -> bool {
    match &fact.kind {
        ExprKind::Binary { operator, .. } => operator.is_comparison(),
        ExprKind::Unary { operator: UnaryOperator::Not, operand } => is_about_numbers(operand),
        _ => fact.as_call().is_some_and(|(name, _)| ["equal", "notequal"].contains(&name)),
    }
}
