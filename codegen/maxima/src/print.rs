//! Expressions back to Maxima text, with no more parentheses than Maxima needs.

use std::fmt;

use num_bigint::Sign;

use crate::ast::{BinaryOperator, Branch, Expr, ExprKind, LoopClause, Quoting, Statement, Terminator, UnaryOperator};
use crate::definition::Definition;
use crate::grammar::{APPLICATION, BODY, COMMA, CONDITION, DELIMITER, Mode, POSTFIX, Power, QUOTE, SIGN, mode};
use crate::lex::{begins_symbol, continues_symbol};

/// The expression as Maxima text, on one line: parsing it gives the expression again.
#[must_use]
pub fn print(expression: &Expr) -> String {
    let mut printer = Printer::default();
    match &expression.kind {
        ExprKind::Ev { expression, options } => {
            printer.expression(expression, Place::ELEMENT);
            printer.text(",");
            printer.elements(options);
        }
        _ => printer.expression(expression, Place::ELEMENT),
    }
    printer.out
}

/// The statement with its terminator, without its label.
#[must_use]
pub fn print_statement(statement: &Statement) -> String {
    let terminator = match statement.terminator {
        Terminator::Show => ';',
        Terminator::Hide => '$',
    };
    format!("{}{terminator}", print(&statement.expression))
}

impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&print(self))
    }
}

impl fmt::Display for Definition {
    /// As `f(x,y):=body`, the names spelt so that they read back.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let symbol = |name: &String| print(&ExprKind::Symbol(name.clone()).into());
        let parameters: Vec<String> = self.parameters.iter().map(symbol).collect();
        write!(f, "{}({}):={}", symbol(&self.name), parameters.join(","), self.body)
    }
}

impl fmt::Display for Statement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&print_statement(self))
    }
}

/// What surrounds an expression.
#[derive(Clone, Copy)]
struct Place {
    /// How strongly the operator before it binds it.
    before: Power,
    /// How strongly what follows binds it.
    after: Power,
    /// What may stand here without parentheses.
    wanted: Mode,
}

impl Place {
    /// Between brackets and commas, or alone.
    const ELEMENT: Self = Self { before: COMMA, after: DELIMITER, wanted: Mode::Any };

    fn new(before: Power, after: Power, wanted: Mode) -> Self {
        Self { before, after, wanted }
    }
}

/// Whether the expression would fall apart in that place.
fn needs_parentheses(expression: &Expr, place: Place) -> bool {
    let (begins, ends) = match &expression.kind {
        ExprKind::Integer(value) if value.sign() == Sign::Minus => (Power::MAX, SIGN),
        ExprKind::Quote { .. } => (Power::MAX, QUOTE),
        ExprKind::Call { .. } | ExprKind::Subscript { .. } => (APPLICATION, Power::MAX),
        ExprKind::Unary { operator, .. } if operator.is_postfix() => (POSTFIX, Power::MAX),
        ExprKind::Unary { operator, .. } => (Power::MAX, operator.power()),
        ExprKind::Binary { operator, .. } => (operator.left_power(), operator.right_power()),
        ExprKind::If { .. } | ExprKind::Loop { .. } => (Power::MAX, BODY),
        _ => (Power::MAX, Power::MAX),
    };
    begins <= place.before || ends < place.after || !mode(expression).fits(place.wanted)
}

/// Whether an `else` behind the expression would become a part of it.
fn takes_else(expression: &Expr) -> bool {
    match &expression.kind {
        ExprKind::If { otherwise, .. } => otherwise.as_deref().is_none_or(takes_else),
        ExprKind::Loop { body, .. } => takes_else(body),
        ExprKind::Binary { right, .. } => takes_else(right),
        ExprKind::Unary { operator, operand } => !operator.is_postfix() && takes_else(operand),
        ExprKind::Quote { expression, .. } => takes_else(expression),
        _ => false,
    }
}

#[derive(Default)]
struct Printer {
    out: String,
}

impl Printer {
    fn text(&mut self, text: &str) {
        self.out.push_str(text);
    }

    fn expression(&mut self, expression: &Expr, place: Place) {
        if needs_parentheses(expression, place) {
            self.parenthesized(expression);
        } else {
            self.kind(&expression.kind, place);
        }
    }

    fn parenthesized(&mut self, expression: &Expr) {
        self.text("(");
        self.kind(&expression.kind, Place::ELEMENT);
        self.text(")");
    }

    fn kind(&mut self, kind: &ExprKind, place: Place) {
        match kind {
            ExprKind::Integer(value) => self.text(&value.to_string()),
            ExprKind::Float(text) | ExprKind::BigFloat(text) => self.text(text),
            ExprKind::String(text) => self.string(text),
            ExprKind::Symbol(name) => self.symbol(name),
            ExprKind::Quote { quoting, expression } => self.quote(*quoting, expression, place),
            ExprKind::Call { function, arguments } => self.applied(function, "(", arguments, ")", place),
            ExprKind::Subscript { array, indices } => self.applied(array, "[", indices, "]", place),
            ExprKind::List(elements) => self.bracketed("[", elements, "]"),
            ExprKind::Set(elements) => self.bracketed("{", elements, "}"),
            ExprKind::Sequence(elements) => self.bracketed("(", elements, ")"),
            ExprKind::Unary { operator, operand } => self.unary(*operator, operand, place),
            ExprKind::Binary { operator, left, right } => self.binary(*operator, left, right, place),
            ExprKind::If { branches, otherwise } => self.condition(branches, otherwise.as_deref(), place),
            ExprKind::Loop { clauses, body } => self.repetition(clauses, body, place),
            ExprKind::Ev { expression, options } => self.ev(expression, options),
        }
    }

    fn string(&mut self, text: &str) {
        self.text("\"");
        for character in text.chars() {
            if matches!(character, '"' | '\\') {
                self.out.push('\\');
            }
            self.out.push(character);
        }
        self.text("\"");
    }

    fn symbol(&mut self, name: &str) {
        let marked = name.strip_prefix('?').filter(|rest| !rest.is_empty());
        let (lisp, plain) = marked.map_or(("", name), |rest| ("?", rest));
        self.text(lisp);
        for (index, character) in plain.chars().enumerate() {
            let bare = if index == 0 { begins_symbol(character) } else { continues_symbol(character) };
            if !bare {
                self.out.push('\\');
            }
            self.out.push(character);
        }
    }

    fn elements(&mut self, elements: &[Expr]) {
        for (index, element) in elements.iter().enumerate() {
            if index > 0 {
                self.text(",");
            }
            self.expression(element, Place::ELEMENT);
        }
    }

    fn bracketed(&mut self, open: &str, elements: &[Expr], close: &str) {
        self.text(open);
        self.elements(elements);
        self.text(close);
    }

    fn applied(&mut self, function: &Expr, open: &str, elements: &[Expr], close: &str, place: Place) {
        self.expression(function, Place::new(place.before, APPLICATION, Mode::Any));
        self.bracketed(open, elements, close);
    }

    fn ev(&mut self, expression: &Expr, options: &[Expr]) {
        self.text("ev(");
        self.expression(expression, Place::ELEMENT);
        self.text(",");
        self.elements(options);
        self.text(")");
    }

    fn quote(&mut self, quoting: Quoting, expression: &Expr, place: Place) {
        let parenthesized = matches!(quoting, Quoting::Expression | Quoting::Value);
        self.text(if matches!(quoting, Quoting::Noun | Quoting::Expression) { "'" } else { "''" });
        match &expression.kind {
            ExprKind::Quote { .. } if !parenthesized => self.text(" "), // `''` is another mark
            _ => {}
        }
        if parenthesized && !matches!(expression.kind, ExprKind::Sequence(_)) {
            self.parenthesized(expression);
        } else {
            self.expression(expression, Place::new(QUOTE, place.after, Mode::Any));
        }
    }

    fn unary(&mut self, operator: UnaryOperator, operand: &Expr, place: Place) {
        if operator.is_postfix() {
            self.factorial_operand(operand, place);
            self.text(operator.symbol());
            return;
        }
        self.text(operator.symbol());
        if operator == UnaryOperator::Not {
            self.text(" ");
        }
        self.expression(operand, Place::new(operator.power(), place.after, operator.mode()));
    }

    /// `(a!)!`: `a!!` is the double factorial.
    fn factorial_operand(&mut self, operand: &Expr, place: Place) {
        match operand.kind {
            ExprKind::Unary { operator: UnaryOperator::Factorial, .. } => self.parenthesized(operand),
            _ => self.expression(operand, Place::new(place.before, POSTFIX, Mode::Algebraic)),
        }
    }

    fn binary(&mut self, operator: BinaryOperator, left: &Expr, right: &Expr, place: Place) {
        let wanted = operator.operands();
        self.expression(left, Place::new(place.before, operator.left_power(), wanted));
        match operator {
            BinaryOperator::And | BinaryOperator::Or | BinaryOperator::Dot => {
                self.text(&format!(" {} ", operator.symbol()));
            }
            _ => self.text(operator.symbol()),
        }
        self.expression(right, Place::new(operator.right_power(), place.after, wanted));
    }

    fn condition(&mut self, branches: &[Branch], otherwise: Option<&Expr>, place: Place) {
        for (index, branch) in branches.iter().enumerate() {
            self.text(if index == 0 { "if " } else { " elseif " });
            self.expression(&branch.condition, Place::new(CONDITION, DELIMITER, Mode::Logical));
            self.text(" then ");
            let last = index + 1 == branches.len() && otherwise.is_none();
            if !last && takes_else(&branch.value) {
                self.parenthesized(&branch.value);
            } else {
                let after = if last { place.after } else { DELIMITER };
                self.expression(&branch.value, Place::new(BODY, after, Mode::Any));
            }
        }
        if let Some(value) = otherwise {
            self.text(" else ");
            self.expression(value, Place::new(BODY, place.after, Mode::Any));
        }
    }

    fn repetition(&mut self, clauses: &[LoopClause], body: &Expr, place: Place) {
        for clause in clauses {
            self.text(clause.word.symbol());
            self.text(" ");
            self.expression(&clause.value, Place::new(clause.word.power(), BODY, clause.word.mode()));
            self.text(" ");
        }
        self.text("do ");
        self.expression(body, Place::new(BODY, place.after, Mode::Any));
    }
}
