//! The same function, exactly: conditions and results of a mutant have the canonical forms that the kernel's have.

use std::collections::BTreeMap;

use closedform_syntax::{BinaryOp, Condition, Expr, Kernel, Relation};
use rug::Rational;

/// More terms than a canonical form is worth.
const MAX_TERMS: usize = 4096;

/// Whether kernel and mutant promise the same and compute the same function: equal as polynomials in inputs, and in
/// roots, compensated expressions and reciprocals of what is equal as such.
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
        let mut slots = Slots((0..kernel.inputs.len()).map(|slot| Sum::atom(format!("#{slot}"))).collect());
        let conditions = kernel.requires.iter().map(|require| slots.condition(&require.condition));
        let conditions = conditions.collect::<Option<_>>()?;
        for step in &kernel.lets {
            let value = slots.canonical(&step.value)?;
            slots.0.push(value);
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
struct Slots(Vec<Sum>);

impl Slots {
    fn text(&self, expr: &Expr) -> Option<String> {
        self.canonical(expr).map(|sum| sum.to_text())
    }

    fn canonical(&self, expr: &Expr) -> Option<Sum> {
        match expr {
            Expr::Literal { value, .. } => Rational::from_f64(*value).map(Sum::number),
            Expr::Name(name) => self.0.get(name.slot).cloned(),
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
            Expr::Call(function, inner) => match **inner {
                Expr::Literal { value, .. } if function.is_power() && (value == 0.0 || value == 1.0) => {
                    self.canonical(inner)
                }
                _ => self.called(function.name(), inner, function.is_odd(), function.is_even()),
            },
            Expr::Compensated(expression) => self.called("compensated", &expression.value, true, false),
            Expr::Residual(inner) => self.called("residual", inner, true, false),
            Expr::If { condition, then, otherwise } => {
                let parts = [self.condition(condition)?, self.text(then)?, self.text(otherwise)?];
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

    /// A function, which may be odd or even.
    fn called(&self, name: &str, inner: &Expr, odd: bool, even: bool) -> Option<Sum> {
        let inner = self.canonical(inner)?;
        let turned = (odd || even) && inner.0.values().next().is_some_and(|first| *first < 0);
        let inner = if turned { inner.negated() } else { inner };
        let value = Sum::atom(format!("{name}{}", inner.to_text()));
        Some(if turned && odd { value.negated() } else { value })
    }

    fn condition(&self, condition: &Condition) -> Option<String> {
        let joined = |name: &str, left: &Condition, right: &Condition| {
            let mut parts = [self.condition(left)?, self.condition(right)?];
            parts.sort();
            Some(format!("{name}{parts:?}"))
        };
        match condition {
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
