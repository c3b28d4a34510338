//! Expressions and conditions in C, in the arithmetic that the kernel computes in.

use crate::c::text::number;
use closedform_syntax::{
    BinaryOp, CompensatedExpr, Condition, Expr, Extended, Function, Operand, Operation, Part, Relation,
};

/// The functions that `arithmetic.h` has.
const FUNCTIONS: [&str; 2] = ["sqrt", "abs"];

/// Whether `arithmetic.h` has a function.
pub fn has(function: Function) -> bool {
    FUNCTIONS.contains(&function.name())
}

/// What a program computes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// Doubles.
    Double,
    /// Pairs of them.
    DoubleDouble,
}

impl Arithmetic {
    /// The type of a number in C.
    pub fn number(self) -> &'static str {
        match self {
            Self::Double => "double",
            Self::DoubleDouble => "cf_dd",
        }
    }

    /// A function of `arithmetic.h`, in this arithmetic.
    fn function(self, name: &str) -> String {
        match self {
            Self::Double => format!("cf_{name}"),
            Self::DoubleDouble => format!("cf_dd_{name}"),
        }
    }
}

/// Prints expressions of one function in C.
pub struct Printer<'a> {
    /// What it computes in.
    pub arithmetic: Arithmetic,
    /// What inputs and steps are called, by their slots.
    pub names: &'a [String],
    /// The variable that is raised.
    pub escalate: &'a str,
}

impl Printer<'_> {
    /// An expression.
    pub fn expression(&self, expr: &Expr) -> String {
        match expr {
            Expr::Literal { value, .. } => self.literal(*value),
            Expr::Name(name) => self.names[name.slot].clone(),
            Expr::Pi(_) if self.arithmetic == Arithmetic::Double => number(std::f64::consts::PI),
            Expr::Pi(_) => "cf_dd_pi()".to_owned(),
            Expr::Neg(inner) => self.negative(&self.expression(inner)),
            Expr::Binary { op, left, right } => self.binary(*op, &self.expression(left), &self.expression(right)),
            Expr::Call(function, inner) => self.escalating(function.name(), &[self.expression(inner)]),
            Expr::Extreme { largest, items } => self.extreme(*largest, items),
            Expr::If { condition, then, otherwise } => {
                format!("({} ? {} : {})", self.condition(condition), self.expression(then), self.expression(otherwise))
            }
            Expr::Compensated(expression) => self.compensated(expression),
            Expr::Residual(expression) => self.residual(expression),
            // certified by other tiers alone: such a kernel has no ordinary inputs, and no function in C
            Expr::PositiveRoot(_) => self.literal(f64::NAN),
        }
    }

    fn literal(&self, value: f64) -> String {
        match self.arithmetic {
            Arithmetic::Double if value.is_sign_negative() => format!("({})", number(value)),
            Arithmetic::Double => number(value),
            Arithmetic::DoubleDouble => self.escalating("literal", &[number(value)]),
        }
    }

    fn negative(&self, value: &str) -> String {
        match self.arithmetic {
            Arithmetic::Double => format!("(-{value})"),
            Arithmetic::DoubleDouble => format!("cf_dd_negate({value})"),
        }
    }

    fn binary(&self, op: BinaryOp, left: &str, right: &str) -> String {
        let (sign, name) = match op {
            BinaryOp::Add => ("+", "add"),
            BinaryOp::Sub => ("-", "subtract"),
            BinaryOp::Mul => ("*", "multiply"),
            BinaryOp::Div => ("/", "divide"),
        };
        match (self.arithmetic, op) {
            (Arithmetic::Double, BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul) => format!("({left} {sign} {right})"),
            _ => self.escalating(name, &[left.to_owned(), right.to_owned()]),
        }
    }

    /// A call of a function that may escalate.
    fn escalating(&self, name: &str, arguments: &[String]) -> String {
        format!("{}({}, &{})", self.arithmetic.function(name), arguments.join(", "), self.escalate)
    }

    fn extreme(&self, largest: bool, items: &[Expr]) -> String {
        let name = self.arithmetic.function(if largest { "larger" } else { "smaller" });
        let values = items.iter().map(|item| self.expression(item));
        values.reduce(|best, next| format!("{name}({best}, {next})")).unwrap_or_default()
    }

    /// A condition. Both sides are always evaluated, as in Rust: what either raises is raised.
    pub fn condition(&self, condition: &Condition) -> String {
        match condition {
            Condition::Compare { op, left, right } => {
                self.comparison(*op, &self.expression(left), &self.expression(right))
            }
            Condition::And(left, right) => format!("cf_both({}, {})", self.condition(left), self.condition(right)),
            Condition::Or(left, right) => format!("cf_either({}, {})", self.condition(left), self.condition(right)),
            Condition::Not(inner) => format!("(!{})", self.condition(inner)),
        }
    }

    fn comparison(&self, op: Relation, left: &str, right: &str) -> String {
        if self.arithmetic == Arithmetic::Double {
            return format!("({left} {} {right})", op.rust());
        }
        match op {
            Relation::Less => format!("cf_dd_less({left}, {right})"),
            Relation::LessOrEqual => format!("cf_dd_less_or_equal({left}, {right})"),
            Relation::Greater => format!("cf_dd_less({right}, {left})"),
            Relation::GreaterOrEqual => format!("cf_dd_less_or_equal({right}, {left})"),
            Relation::Equal => format!("cf_dd_equal({left}, {right})"),
            Relation::NotEqual => format!("(!cf_dd_equal({left}, {right}))"),
        }
    }

    fn compensated(&self, expression: &CompensatedExpr) -> String {
        match Part::of(&expression.value) {
            Part::Operand(operand) => self.operand(operand),
            Part::Extended(part) => {
                self.escalating("compensated", &[self.extended(part), number(expression.threshold)])
            }
        }
    }

    fn residual(&self, expression: &Expr) -> String {
        match Part::of(expression) {
            Part::Operand(operand) => self.operand(operand),
            Part::Extended(part) => self.escalating("residual", &[self.extended(part)]),
        }
    }

    /// A leaf of a compensated expression, as a number of the arithmetic.
    fn operand(&self, operand: Operand) -> String {
        let value = self.expression(operand.leaf);
        if operand.negative { self.negative(&value) } else { value }
    }

    /// The same as a double, which it counts as.
    fn exact(&self, operand: Operand) -> String {
        let value = match (self.arithmetic, operand.leaf) {
            (_, Expr::Literal { value, .. }) => number(*value),
            (Arithmetic::Double, leaf) => self.expression(leaf),
            (Arithmetic::DoubleDouble, leaf) => format!("{}.high", self.expression(leaf)),
        };
        if operand.negative { format!("(-{value})") } else { value }
    }

    fn extended(&self, part: Extended) -> String {
        let value = match part.operation() {
            Operation::TwoSum(a, b) => format!("cf_sum_of({}, {})", self.exact(a), self.exact(b)),
            Operation::TwoProduct(a, b) => format!("cf_product_of({}, {})", self.exact(a), self.exact(b)),
            Operation::AddExact(a, b) => format!("cf_sum_plus_exact({}, {})", self.extended(a), self.exact(b)),
            Operation::Add(a, b) => format!("cf_sum_plus({}, {})", self.extended(a), self.extended(b)),
            Operation::MulExact(a, b) => format!("cf_sum_times_exact({}, {})", self.extended(a), self.exact(b)),
            Operation::Mul(a, b) => format!("cf_sum_times({}, {})", self.extended(a), self.extended(b)),
            Operation::ScaleOperand(a, b) => format!("cf_scaled({}, {})", self.exact(a), self.exact(b)),
            Operation::Scale(a, b) => format!("cf_sum_scaled({}, {})", self.extended(a), self.exact(b)),
        };
        if part.negative { format!("cf_sum_negate({value})") } else { value }
    }
}
