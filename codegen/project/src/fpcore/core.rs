//! One core: its name, arguments, properties and body.

use std::ops::Range;

use closedform_maxima::{Definition, Expr, ExprKind};

use super::condition::conditions;
use super::expression::expression;
use super::mistake::CoreMistake;
use super::name::{format, formats, maxima_name};
use super::read::{Node, NodeKind};
use super::scope::{Callable, Scope, Value};

/// A core as a definition, and what its author says of it.
#[derive(Debug)]
pub struct Core {
    /// The name by which others may call it.
    pub identifier: Option<String>,
    /// What `:name` says.
    pub title: Option<String>,
    /// What `:cite` says.
    pub cited: Option<String>,
    /// The other properties, as written.
    pub properties: Vec<String>,
    /// Each part of `:pre` as people read it, all of which hold.
    pub conditions: Vec<Expr>,
    /// The function; of a core without a name its name is empty.
    pub definition: Definition,
}

/// How many letters of a property are worth keeping.
const LONGEST: usize = 200;

/// Reads a core.
pub(super) fn core<'a>(
    node: &'a Node,
    text: &str,
    earlier: &[Callable],
) -> Result<(Core, Option<Callable<'a>>), CoreMistake> {
    let mut parts = node.list().unwrap_or_default().iter().peekable();
    if parts.next().and_then(Node::atom) != Some("FPCore") {
        let remedy = "write (FPCore name (x y) :pre (< 0 x) (/ x y)); there is nothing else at the top of a file";
        return Err(CoreMistake::new("not an FPCore", remedy, node.span.clone()));
    }
    let identifier = parts.next_if(|part| part.atom().is_some()).and_then(Node::atom).map(str::to_owned);
    let whole =
        || CoreMistake::new("a core without arguments or body", "write (FPCore name (x y) body)", node.span.clone());
    let arguments = parts.next().and_then(Node::list).ok_or_else(whole)?;
    let (mut scope, mut parameters) = (Scope::new(earlier), Vec::new());
    let mut names = Vec::new();
    for argument in arguments {
        let (name, maxima) = parameter(argument)?;
        if parameters.contains(&maxima) {
            let what = format!("the argument `{name}` occurs twice");
            return Err(CoreMistake::new(what, "give each argument a name of its own", argument.span.clone()));
        }
        let symbol = Value::made(&argument.span, Vec::new(), |_| ExprKind::Symbol(maxima.clone()).into())?;
        scope.set(name.clone(), symbol);
        names.push(name);
        parameters.push(maxima);
    }
    let mut said = Properties::default();
    while let Some(key) = parts.next_if(|part| part.atom().is_some_and(|key| key.starts_with(':'))) {
        let value = parts.next().ok_or_else(whole)?;
        said.property(key, value, text, &mut scope)?;
    }
    let body = match (parts.next(), parts.next()) {
        (Some(body), None) => body,
        (_, Some(more)) => {
            return Err(CoreMistake::new("a core has one body", "remove what follows it", more.span.clone()));
        }
        (None, _) => return Err(whole()),
    };
    let formula = expression(body, &mut scope)?.expr;
    let callable = identifier.clone().map(|name| Callable { name, parameters: names, body });
    let name = identifier.clone().unwrap_or_default();
    let definition = Definition { name, parameters, body: formula, span: node.span.clone() };
    let Properties { title, cited, others, conditions } = said;
    Ok((Core { identifier, title, cited, properties: others, conditions, definition }, callable))
}

/// The name of an argument, in FPCore and in Maxima.
fn parameter(argument: &Node) -> Result<(String, String), CoreMistake> {
    let name = match &argument.kind {
        NodeKind::Atom(name) => Some(name),
        NodeKind::List(parts) => match parts.as_slice() {
            [mark, properties @ .., Node { kind: NodeKind::Atom(name), .. }] if mark.atom() == Some("!") => {
                formats(properties)?;
                Some(name)
            }
            _ => None,
        },
        NodeKind::Text(_) => None,
    };
    let no_number = || {
        let remedy = "kernels take numbers: write a core for each element";
        CoreMistake::new("an argument that is no number", remedy, argument.span.clone())
    };
    let name = name.ok_or_else(no_number)?;
    Ok((name.clone(), maxima_name(name)))
}

/// What is said of a core.
#[derive(Default)]
struct Properties {
    title: Option<String>,
    cited: Option<String>,
    others: Vec<String>,
    conditions: Vec<Expr>,
}

impl Properties {
    fn property(&mut self, key: &Node, value: &Node, text: &str, scope: &mut Scope<'_>) -> Result<(), CoreMistake> {
        let name = key.atom().unwrap_or_default();
        match (name, &value.kind) {
            (":pre", _) => self.conditions.extend(conditions(value, scope)?),
            (":name", NodeKind::Text(title)) => self.title = Some(words(title)),
            (":cite", NodeKind::List(works)) => {
                self.cited = Some(works.iter().map(|work| written(text, &work.span)).collect::<Vec<_>>().join(", "));
            }
            (":description", NodeKind::Text(said)) => self.others.push(words(said)),
            _ => {
                format(key, value)?;
                let short = Some(written(text, &value.span)).filter(|value| value.len() <= LONGEST);
                self.others.extend(short.map(|value| format!("{name} {value}")));
            }
        }
        Ok(())
    }
}

fn written(text: &str, place: &Range<usize>) -> String {
    words(&text[place.clone()])
}

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
