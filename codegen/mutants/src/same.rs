//! The same function, exactly: conditions and results of a mutant have the canonical forms that the kernel's have.

use std::collections::BTreeMap;

use closedform_syntax::{BinaryOp, Condition, Expr, Kernel, Relation};
use rug::Rational;

/// More terms than a canonical form is worth.
const MAX_TERMS: usize = 4096;

/// Whether kernel and mutant promise the same and compute the same function: equal as polynomials in inputs, and in
/// roots, compensated expressions and reciprocals of what is equal as such; a branch that only an input of zero takes, at
/// zero.
pub fn same_function(kernel: &Kernel, mutant: &Kernel) -> bool {
    let forms = Forms::of(kernel);
    forms.is_some() && forms == Forms::of(mutant)
}

/// What a kernel promises, in canonical form.
#[derive(PartialEq)]
struct Forms {
    bounds: Vec<Option<f64>>,
    conditions: Vec<String>,
    results: Vec<Sum>,
}

impl Forms {
    /// `None` where a form is not worth its size.
    fn of(kernel: &Kernel) -> Option<Self> {
        let mut slots = Slots::of(kernel);
        let conditions = kernel.requires.iter().map(|require| slots.condition(&require.condition));
        let conditions = conditions.collect::<Option<_>>()?;
        for step in &kernel.lets {
            let value = slots.canonical(&step.value)?;
            slots.values.push(Some(value));
        }
        let results = kernel.output.values().map(|value| slots.canonical(value)).collect::<Option<_>>()?;
        Some(Forms { bounds: kernel.meta.results.iter().map(|result| result.bound).collect(), conditions, results })
    }
}

/// A product: powers of what is not expanded.
type Product = BTreeMap<String, i32>;

/// A sum of products with coefficients.
#[derive(Clone, Default, PartialEq)]
struct Sum(BTreeMap<Product, Rational>);

impl Sum {
    fn number(value: Rational) -> Self {
        Sum::term(Product::new(), value)
    }

    fn atom(name: String) -> Self {
        Sum::term(Product::from([(name, 1)]), Rational::from(1))
    }

    fn term(product: Product, coefficient: Rational) -> Self {
        let mut sum = Sum::default();
        sum.add(product, coefficient);
        sum
    }

    fn add(&mut self, product: Product, coefficient: Rational) {
        let slot = self.0.entry(product.clone()).or_default();
        *slot += coefficient;
        if slot.is_zero() {
            self.0.remove(&product);
        }
    }

    fn plus(mut self, other: Sum) -> Self {
        other.0.into_iter().for_each(|(product, coefficient)| self.add(product, coefficient));
        self
    }

    fn negated(mut self) -> Self {
        self.0.values_mut().for_each(|coefficient| *coefficient *= -1);
        self
    }

    fn times(&self, other: &Sum) -> Option<Self> {
        if self.0.len() * other.0.len() > MAX_TERMS {
            return None;
        }
        let mut sum = Sum::default();
        for (left, one) in &self.0 {
            for (right, two) in &other.0 {
                let mut product = left.clone();
                right.iter().for_each(|(atom, power)| *product.entry(atom.clone()).or_default() += power);
                product.retain(|_, power| *power != 0);
                sum.add(product, Rational::from(one * two));
            }
        }
        Some(sum)
    }

    /// `None` for zero, which has none.
    fn reciprocal(&self) -> Option<Self> {
        match self.0.iter().next()? {
            (product, coefficient) if self.0.len() == 1 => {
                let product = product.iter().map(|(atom, power)| (atom.clone(), -power)).collect();
                Some(Sum::term(product, coefficient.clone().recip()))
            }
            _ => Some(Sum::term(Product::from([(self.to_text(), -1)]), Rational::from(1))),
        }
    }

    fn to_text(&self) -> String {
        format!("({:?})", self.0)
    }
}

/// The canonical forms of inputs and steps.
struct Slots<'a> {
    kernel: &'a Kernel,
    /// `None` where a form is not worth its size, or divides by zero.
    values: Vec<Option<Sum>>,
    /// How an input stands to zero on the whole domain, where the domain says it.
    signs: Vec<Option<Relation>>,
}

impl<'a> Slots<'a> {
    /// Those of the inputs.
    fn of(kernel: &'a Kernel) -> Self {
        let count = kernel.inputs.len();
        let mut signs = vec![None; count];
        for require in &kernel.requires {
            if let Some((slot, op)) = against_zero(&require.condition).filter(|(slot, _)| *slot < count) {
                signs[slot] = Some(op);
            }
        }
        let values = (0..count).map(|slot| Some(Sum::atom(format!("#{slot}")))).collect();
        Self { kernel, values, signs }
    }

    /// These where an input is zero.
    fn at_zero(&self, input: usize) -> Self {
        let mut zero = Self { signs: self.signs.clone(), ..Self::of(self.kernel) };
        zero.values = self.values[..self.kernel.inputs.len()].to_vec();
        zero.values[input] = Some(Sum::default());
        for step in &self.kernel.lets[..self.values.len() - self.kernel.inputs.len()] {
            let value = zero.canonical(&step.value);
            zero.values.push(value);
        }
        zero
    }

    /// The input that is zero on the domain where a condition holds.
    fn zero_where(&self, condition: &Condition) -> Option<usize> {
        let (slot, op) = against_zero(condition)?;
        let sign = *self.signs.get(slot)?;
        let is_opposite = sign.is_some_and(|sign| match op {
            Relation::LessOrEqual => sign.is_above(),
            Relation::GreaterOrEqual => sign.is_below(),
            _ => false,
        });
        (op == Relation::Equal || is_opposite).then_some(slot)
    }

    /// A branch under its condition, whose canonical form is given: at zero where only zero takes it.
    fn branch(&self, condition: &Condition, value: &Expr) -> Option<String> {
        let at_zero = self.zero_where(condition).and_then(|input| self.at_zero(input).text(value));
        at_zero.map(|text| format!("at zero {text}")).or_else(|| self.text(value))
    }

    fn text(&self, expr: &Expr) -> Option<String> {
        self.canonical(expr).map(|sum| sum.to_text())
    }

    fn canonical(&self, expr: &Expr) -> Option<Sum> {
        match expr {
            Expr::Literal { value, .. } => Rational::from_f64(*value).map(Sum::number),
            Expr::Name(name) => self.values.get(name.slot).cloned().flatten(),
            Expr::Pi(_) => Some(Sum::atom("pi".to_owned())),
            Expr::Neg(inner) => self.canonical(inner).map(Sum::negated),
            Expr::Binary { op, left, right } => {
                let (left, right) = (self.canonical(left)?, self.canonical(right)?);
                match op {
                    BinaryOp::Add => Some(left.plus(right)),
                    BinaryOp::Sub => Some(left.plus(right.negated())),
                    BinaryOp::Mul => left.times(&right),
                    BinaryOp::Div => left.times(&right.reciprocal()?),
                }
            }
            Expr::Call(function, inner) => {
                let value = self.canonical(inner)?;
                let is_fixed = value == Sum::default() || value == Sum::number(Rational::from(1));
                let is_fixed = function.is_power() && is_fixed;
                if is_fixed {
                    Some(value)
                } else {
                    Some(called(function.name(), value, function.is_odd(), function.is_even()))
                }
            }
            Expr::Compensated(expression) => {
                Some(called("compensated", self.canonical(&expression.value)?, true, false))
            }
            Expr::Residual(inner) => Some(called("residual", self.canonical(inner)?, true, false)),
            Expr::If { condition, then, otherwise } => {
                let parts = [self.condition(condition)?, self.branch(condition, then)?, self.text(otherwise)?];
                Some(Sum::atom(format!("if{parts:?}")))
            }
            Expr::Extreme { largest, items } => {
                let mut items = items.iter().map(|item| self.text(item)).collect::<Option<Vec<_>>>()?;
                items.sort();
                Some(Sum::atom(format!("{}{items:?}", if *largest { "max" } else { "min" })))
            }
            Expr::PositiveRoot(coefficients) => {
                let coefficients: Option<Vec<String>> = coefficients.iter().map(|c| self.text(c)).collect();
                Some(Sum::atom(format!("root{:?}", coefficients?)))
            }
        }
    }

    fn condition(&self, condition: &Condition) -> Option<String> {
        let joined = |name: &str, left: &Condition, right: &Condition| {
            let mut parts = [self.condition(left)?, self.condition(right)?];
            parts.sort();
            Some(format!("{name}{parts:?}"))
        };
        match condition {
            Condition::Compare { left, right, .. } if self.zero_where(condition).is_some() => {
                self.compared(Relation::Equal, left, right)
            }
            Condition::Compare { op, left, right } => self.compared(*op, left, right),
            Condition::And(left, right) => joined("and", left, right),
            Condition::Or(left, right) => joined("or", left, right),
            Condition::Not(inner) => self.condition(inner).map(|inner| format!("not{inner}")),
        }
    }

    /// A comparison of sides, the greater one second.
    fn compared(&self, op: Relation, left: &Expr, right: &Expr) -> Option<String> {
        let (left, right) = (self.text(left)?, self.text(right)?);
        let turned = op.is_above() || op == op.mirrored() && left > right;
        let (left, op, right) = if turned { (right, op.mirrored(), left) } else { (left, op, right) };
        Some(format!("{left}{}{right}", op.rust()))
    }
}

/// A function, which may be odd or even.
fn called(name: &str, inner: Sum, odd: bool, even: bool) -> Sum {
    let turned = (odd || even) && inner.0.values().next().is_some_and(|first| *first < 0);
    let inner = if turned { inner.negated() } else { inner };
    let value = Sum::atom(format!("{name}{}", inner.to_text()));
    if turned && odd { value.negated() } else { value }
}

/// The slot that a condition compares with zero, and how.
fn against_zero(condition: &Condition) -> Option<(usize, Relation)> {
    let Condition::Compare { op, left, right } = condition else { return None };
    match (left, right) {
        (Expr::Name(name), Expr::Literal { value: 0.0, .. }) => Some((name.slot, *op)),
        (Expr::Literal { value: 0.0, .. }, Expr::Name(name)) => Some((name.slot, op.mirrored())),
        _ => None,
    }
}
