//! Compensated expressions, what `compensated!` and `residual!` take: which operation on pairs each step is, and its exact terms.
//!
//! Interpreter and macro both read compensated expressions by these functions, so they cannot disagree.

use closedform_arith::error_model::compensated;
use closedform_arith::factored::Step;
use closedform_arith::limits::{MAX_FACTORS, MAX_OPERANDS, MAX_STACK, MAX_TERMS};
use closedform_arith::range::is_power_of_two;
use closedform_arith::{Term, Terms};

use crate::error;
use crate::kernel::{BinaryOp, CompensatedExpr, Expr};

/// A part of a compensated expression, or all of it.
#[derive(Clone, Copy, Debug)]
pub enum Part<'e> {
    /// A literal or a name, or the negative of one: it counts as exact.
    Operand(Operand<'e>),
    /// A pair.
    Extended(Extended<'e>),
}

/// A literal or a name.
#[derive(Clone, Copy, Debug)]
pub struct Operand<'e> {
    /// The literal or the name.
    pub leaf: &'e Expr,
    /// Whether its negative is meant.
    pub negative: bool,
}

/// A pair: a sum or a product.
#[derive(Clone, Copy, Debug)]
pub struct Extended<'e> {
    op: BinaryOp,
    left: &'e Expr,
    right: &'e Expr,
    /// Whether the negative of what the operation makes is meant.
    pub negative: bool,
}

/// The operation that makes a pair: the cheapest one that the kinds of its operands allow.
#[derive(Clone, Copy, Debug)]
pub enum Operation<'e> {
    /// The sum of two operands, error-free.
    TwoSum(Operand<'e>, Operand<'e>),
    /// The product of two operands, error-free.
    TwoProduct(Operand<'e>, Operand<'e>),
    /// The sum of a pair and an operand.
    AddExact(Extended<'e>, Operand<'e>),
    /// The sum of two pairs.
    Add(Extended<'e>, Extended<'e>),
    /// The product of a pair and an operand.
    MulExact(Extended<'e>, Operand<'e>),
    /// The product of two pairs.
    Mul(Extended<'e>, Extended<'e>),
    /// The product of two operands of which the second is a power of two, exact.
    ScaleOperand(Operand<'e>, Operand<'e>),
    /// The product of a pair and a power of two, which rounds nothing.
    Scale(Extended<'e>, Operand<'e>),
}

impl<'e> Part<'e> {
    /// What an expression is as a part of a compensated expression, or as all of it.
    pub fn of(mut expr: &'e Expr) -> Self {
        let mut negative = false;
        while let Expr::Neg(inner) = expr {
            (expr, negative) = (inner, !negative);
        }
        match expr {
            Expr::Binary { op, left, right } => Part::Extended(Extended { op: *op, left, right, negative }),
            leaf => Part::Operand(Operand { leaf, negative }),
        }
    }

    fn negated(self) -> Self {
        match self {
            Part::Operand(operand) => Part::Operand(Operand { negative: !operand.negative, ..operand }),
            Part::Extended(extended) => Part::Extended(Extended { negative: !extended.negative, ..extended }),
        }
    }
}

impl Operand<'_> {
    /// The power of two that it is in the text of the program, if any, but for its sign.
    fn power_of_two(self) -> Option<f64> {
        match self.leaf {
            Expr::Literal { value, .. } if is_power_of_two(*value) => Some(*value),
            _ => None,
        }
    }

    /// Whether a product with it only scales.
    fn is_power_of_two(self) -> bool {
        self.power_of_two().is_some()
    }
}

impl<'e> Extended<'e> {
    /// What makes the number, but for its sign.
    pub fn operation(self) -> Operation<'e> {
        let (left, right) = (Part::of(self.left), Part::of(self.right));
        match self.op {
            BinaryOp::Mul => Operation::product(left, right),
            BinaryOp::Sub => Operation::sum(left, right.negated()),
            BinaryOp::Add | BinaryOp::Div => Operation::sum(left, right),
        }
    }
}

impl<'e> Operation<'e> {
    fn sum(left: Part<'e>, right: Part<'e>) -> Self {
        match (left, right) {
            (Part::Operand(a), Part::Operand(b)) => Self::TwoSum(a, b),
            (Part::Extended(extended), Part::Operand(exact)) | (Part::Operand(exact), Part::Extended(extended)) => {
                Self::AddExact(extended, exact)
            }
            (Part::Extended(a), Part::Extended(b)) => Self::Add(a, b),
        }
    }

    fn product(left: Part<'e>, right: Part<'e>) -> Self {
        match (left, right) {
            (Part::Operand(a), Part::Operand(b)) if b.is_power_of_two() => Self::ScaleOperand(a, b),
            (Part::Operand(a), Part::Operand(b)) if a.is_power_of_two() => Self::ScaleOperand(b, a),
            (Part::Operand(a), Part::Operand(b)) => Self::TwoProduct(a, b),
            (Part::Extended(extended), Part::Operand(exact)) | (Part::Operand(exact), Part::Extended(extended)) => {
                if exact.is_power_of_two() {
                    Self::Scale(extended, exact)
                } else {
                    Self::MulExact(extended, exact)
                }
            }
            (Part::Extended(a), Part::Extended(b)) => Self::Mul(a, b),
        }
    }
}

impl CompensatedExpr {
    /// A compensated expression, and what its exact evaluation needs; its product of sums is expanded.
    ///
    /// # Errors
    ///
    /// When it has too many terms, factors or operands.
    pub fn new(value: Expr) -> Result<Self, &'static str> {
        let mut operands = Vec::new();
        let terms: Vec<u8> = expand(&value, &mut operands)?.iter().flat_map(Product::compact).collect();
        let threshold = compensated::threshold(count(&value).error());
        let worth = |form: &Form| form.height <= MAX_STACK && terms.len() > WORTH * form.steps.len();
        let factored = factored(&value, &operands).filter(worth);
        let factored = factored.map_or_else(Vec::new, |form| form.steps);
        Ok(CompensatedExpr { value: value.into(), operands, terms, factored, threshold })
    }

    /// Its terms, as products of its operands.
    pub fn terms(&self) -> Terms<'_> {
        Terms::of(&self.terms).written_as(&self.factored)
    }

    /// The compact form of its terms, for code that is to hold them.
    pub fn compact_terms(&self) -> &[u8] {
        &self.terms
    }

    /// The [factored form](Step), for code that is to hold it; empty where it is too large, or hardly
    /// shorter than the terms.
    pub fn factored(&self) -> &[u8] {
        &self.factored
    }
}

/// How much longer the terms must be than the factored form, in bytes, for it to be worth a try before them. (A byte of
/// terms takes some 13 ns, a step of the factored form some 40 ns.)
const WORTH: usize = 3;

/// A factored form, and how many numbers it keeps at once.
struct Form {
    steps: Vec<u8>,
    height: usize,
}

/// The factored form; `None` where operands are too many. What keeps more numbers comes first.
fn factored(expr: &Expr, operands: &[Expr]) -> Option<Form> {
    match expr {
        Expr::Neg(inner) => {
            let mut form = factored(inner, operands)?;
            form.steps.push(Step::Negative.byte()?);
            Some(form)
        }
        Expr::Binary { op, left, right } => {
            let (left, right) = (factored(left, operands)?, factored(right, operands)?);
            let exchanged = right.height > left.height;
            let (mut first, second) = if exchanged { (right, left) } else { (left, right) };
            let step = match op {
                BinaryOp::Mul => Step::Product,
                BinaryOp::Sub if exchanged => Step::Reversed,
                BinaryOp::Sub => Step::Difference,
                BinaryOp::Add | BinaryOp::Div => Step::Sum,
            };
            first.steps.extend(second.steps);
            first.steps.push(step.byte()?);
            Some(Form { height: first.height.max(second.height + 1), ..first })
        }
        leaf => {
            let position = operands.iter().position(|operand| same_leaf(operand, leaf))?;
            let step = Step::Operand(u8::try_from(position).ok()?).byte()?;
            Some(Form { steps: vec![step], height: 1 })
        }
    }
}

/// A product of operands, by position.
#[derive(Clone)]
struct Product {
    negative: bool,
    factors: Vec<u8>,
}

impl Product {
    fn compact(&self) -> Vec<u8> {
        Term { negative: self.negative, factors: &self.factors }.compact().collect()
    }
}

fn expand(expr: &Expr, operands: &mut Vec<Expr>) -> Result<Vec<Product>, &'static str> {
    match expr {
        Expr::Neg(inner) => Ok(turned(expand(inner, operands)?)),
        Expr::Binary { op, left, right } => {
            let (left, right) = (expand(left, operands)?, expand(right, operands)?);
            match op {
                BinaryOp::Mul => multiplied(&left, &right),
                BinaryOp::Sub => Ok([left, turned(right)].concat()),
                BinaryOp::Add | BinaryOp::Div => Ok([left, right].concat()),
            }
        }
        leaf => {
            let known = operands.iter().position(|operand| same_leaf(operand, leaf));
            let position = known.unwrap_or(operands.len());
            if known.is_none() {
                operands.push(leaf.clone());
            }
            let position = u8::try_from(position).ok().filter(|position| usize::from(*position) < MAX_OPERANDS);
            Ok(vec![Product { negative: false, factors: vec![position.ok_or(error::COMPENSATED_SIZE)?] }])
        }
    }
}

fn turned(mut sum: Vec<Product>) -> Vec<Product> {
    sum.iter_mut().for_each(|product| product.negative = !product.negative);
    sum
}

fn multiplied(left: &[Product], right: &[Product]) -> Result<Vec<Product>, &'static str> {
    let pairs = left.iter().flat_map(|a| right.iter().map(move |b| (a, b)));
    let products: Vec<Product> = pairs
        .take(MAX_TERMS + 1)
        .map(|(a, b)| Product { negative: a.negative != b.negative, factors: [&a.factors[..], &b.factors].concat() })
        .collect();
    let fits = products.len() <= MAX_TERMS && products.iter().all(|product| product.factors.len() <= MAX_FACTORS);
    if fits { Ok(products) } else { Err(error::COMPENSATED_SIZE) }
}

fn same_leaf(a: &Expr, b: &Expr) -> bool {
    match (a, b) {
        (Expr::Name(a), Expr::Name(b)) => a.slot == b.slot,
        (Expr::Literal { value: a, .. }, Expr::Literal { value: b, .. }) => a.to_bits() == b.to_bits(),
        _ => false,
    }
}

/// Counts what the operations of a compensated expression add, by the error model.
fn count(expr: &Expr) -> compensated::Part {
    match expr {
        Expr::Neg(inner) => count(inner),
        Expr::Binary { op, left, right } => {
            let (first, second) = (count(left), count(right));
            match (op, scale(left), scale(right)) {
                (BinaryOp::Mul, _, Some(power)) => first.scaled(power),
                (BinaryOp::Mul, Some(power), None) => second.scaled(power),
                (BinaryOp::Mul, None, None) => first.product(second),
                (BinaryOp::Add | BinaryOp::Sub | BinaryOp::Div, _, _) => first.sum(second),
            }
        }
        Expr::Literal { .. } | Expr::Name(_) => compensated::Part::OPERAND,
        // no part of a compensated expression
        _ => compensated::Part::UNKNOWN,
    }
}

/// The power of two by which a factor only scales.
fn scale(expr: &Expr) -> Option<f64> {
    match Part::of(expr) {
        Part::Operand(operand) => operand.power_of_two(),
        Part::Extended(_) => None,
    }
}
