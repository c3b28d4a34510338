//! The builder: canonical elements to steps that keep their digits, by the rules.

use super::nest::{Mode, Nested, Nester};
use super::rules::{self, Rule};
use crate::algebra::{Polynomial, Var};
use crate::field::{Element, Radical, Sign, Tower, TowerError, parts};
use crate::program::{Condition, Graph, Node, Op, Order, Wide, beyond_literals, is_exact, leading_bits};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Builds the steps of one kernel.
pub struct Builder {
    /// The field of the kernel's closed forms.
    pub tower: Tower,
    /// The steps so far.
    pub graph: Graph,
    /// The steps that named variables stand for: radicals, results, differences.
    stand_ins: BTreeMap<Var, Node>,
    /// Differences of two inputs that have a variable of their own.
    differences: BTreeMap<(Var, Var), Var>,
    polynomials: HashMap<String, Node>,
    used: BTreeSet<&'static str>,
}

/// A factor of a quotient that is being assembled.
#[derive(Clone, Debug)]
pub enum Factor {
    /// A polynomial in the inputs.
    Polynomial(Polynomial),
    /// A finished step.
    Node(Node),
}

/// A constant times powers of factors.
#[derive(Clone, Debug)]
pub struct Quotient {
    /// The constant.
    pub constant: BigRational,
    /// The factors and their exponents, negative below the bar.
    pub powers: Vec<(Factor, i32)>,
}

impl Quotient {
    /// The constant one.
    #[must_use]
    pub fn one() -> Self {
        Self { constant: BigRational::one(), powers: Vec::new() }
    }

    /// Multiplies by a power of a polynomial, factor by factor.
    pub fn multiply(&mut self, polynomial: &Polynomial, exponent: i32) {
        let factors = polynomial.factors();
        let constant = num_traits::pow(factors.constant, exponent.unsigned_abs() as usize);
        self.constant *= if exponent < 0 { constant.recip() } else { constant };
        for (factor, power) in factors.powers {
            self.insert(factor, power as i32 * exponent);
        }
    }

    fn insert(&mut self, factor: Polynomial, exponent: i32) {
        let same = self.powers.iter_mut().find(|(f, _)| matches!(f, Factor::Polynomial(p) if *p == factor));
        match same {
            Some((_, power)) => *power += exponent,
            None => self.powers.push((Factor::Polynomial(factor), exponent)),
        }
        self.powers.retain(|(_, power)| *power != 0);
    }

    /// Multiplies by a power of a finished step.
    pub fn multiply_node(&mut self, node: Node, exponent: i32) {
        self.powers.push((Factor::Node(node), exponent));
    }
}

impl Builder {
    /// Nothing built yet.
    #[must_use]
    pub fn new(tower: Tower) -> Self {
        Self {
            tower,
            graph: Graph::default(),
            stand_ins: BTreeMap::new(),
            differences: BTreeMap::new(),
            polynomials: HashMap::new(),
            used: BTreeSet::new(),
        }
    }

    /// The names of the rules that were used so far.
    #[must_use]
    pub fn used_rules(&self) -> &BTreeSet<&'static str> {
        &self.used
    }

    /// Forgets the rules of steps that were tried and not taken.
    pub fn reset_rules(&mut self, used: BTreeSet<&'static str>) {
        self.used = used;
    }

    /// Lets polynomials be built anew, because more is known of their signs.
    pub fn forget_polynomials(&mut self) {
        self.polynomials.clear();
    }

    /// Records that a rule made a step.
    pub fn apply(&mut self, rule: &'static Rule, node: Node) {
        self.used.insert(rule.name);
        self.graph.mark(node, rule.name);
    }

    /// Lets a variable stand for a finished step.
    pub fn stand_for(&mut self, var: Var, node: Node) {
        self.stand_ins.insert(var, node);
    }

    /// Whether a variable stands for a finished step.
    #[must_use]
    pub fn has_stand_in(&self, var: Var) -> bool {
        self.stand_ins.contains_key(&var)
    }

    /// Whether a polynomial can be evaluated in plain arithmetic without cancellation.
    #[must_use]
    pub fn has_plain_form(&self, polynomial: &Polynomial) -> bool {
        Nester::new(&self.tower.facts, self.tower.inputs(), Mode::Plain).nest(polynomial).is_some()
    }

    /// The step of a variable.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn variable(&mut self, var: Var) -> Result<Node, TowerError> {
        if var.0 < self.tower.inputs() {
            return Ok(self.graph.input(var.0, self.tower.facts.variable(var)));
        }
        if let Some(&node) = self.stand_ins.get(&var) {
            return Ok(node);
        }
        if self.tower.pi() == Some(var) {
            return Ok(self.graph.pi());
        }
        let radical = self.tower.radicals().iter().find(|r| r.var == var).cloned();
        let radical = radical.ok_or(TowerError::TooManyRadicals)?;
        let node = match self.tower.magnitude_of(&radical) {
            Some(inside) => {
                let inside = self.polynomial(&inside)?;
                self.graph.abs(inside)
            }
            None => {
                let inside = self.radicand(&radical)?;
                self.graph.sqrt(inside)
            }
        };
        self.stand_ins.insert(var, node);
        Ok(node)
    }

    fn radicand(&mut self, radical: &Radical) -> Result<Node, TowerError> {
        let element = self.tower.element(&radical.radicand);
        self.element(&element)
    }

    /// The steps of an element.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn element(&mut self, element: &Element) -> Result<Node, TowerError> {
        if element.numerator.is_zero() {
            return Ok(self.graph.constant(&BigRational::zero()));
        }
        let mut quotient = Quotient::one();
        quotient.multiply(&element.denominator, -1);
        self.surd(&element.numerator, quotient)
    }

    /// The steps of a polynomial in inputs and radicals, times a quotient.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn surd(&mut self, polynomial: &Polynomial, mut quotient: Quotient) -> Result<Node, TowerError> {
        let Some(radical) = self.tower.top_radical(polynomial).cloned() else {
            quotient.multiply(polynomial, 1);
            return self.assemble(&quotient);
        };
        let (rational_content, polynomial) = polynomial.primitive();
        let content = self.tower.content(&polynomial);
        let primitive = polynomial.divided_by(&content).unwrap_or(polynomial);
        quotient.constant *= rational_content;
        quotient.multiply(&content, 1);
        let radicals = self.tower.radicals().iter().rev();
        let mut common = radicals.filter_map(|radical| {
            let (rational, surd) = parts(&primitive, radical.var);
            (rational.is_zero() && !surd.is_zero()).then(|| (radical.clone(), surd))
        });
        if let Some((radical, surd)) = common.next() {
            return rules::merge_roots::apply(self, &surd, &radical, quotient);
        }
        rules::conjugate::apply(self, &primitive, &radical, quotient)
    }

    /// The product of the factors: one division at most.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn assemble(&mut self, quotient: &Quotient) -> Result<Node, TowerError> {
        let (over, under) = split_constant(&quotient.constant);
        let above = self.product(&over, quotient, 1)?;
        let below = self.product(&under, quotient, -1)?;
        let node = self.graph.div(above, below);
        if rules::factored::holds_for(quotient) {
            self.apply(&rules::factored::RULE, node);
        }
        Ok(node)
    }

    fn product(&mut self, constant: &BigRational, quotient: &Quotient, side: i32) -> Result<Node, TowerError> {
        let mut product = self.graph.constant(constant);
        for (factor, exponent) in &quotient.powers {
            let times = exponent * side;
            if times <= 0 {
                continue;
            }
            let node = match factor {
                Factor::Node(node) => *node,
                Factor::Polynomial(polynomial) => self.polynomial(polynomial)?,
            };
            for _ in 0..times {
                product = self.graph.mul(product, node);
            }
        }
        Ok(product)
    }

    /// The steps of a polynomial in the inputs and named parts, accurate on the whole domain.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn polynomial(&mut self, polynomial: &Polynomial) -> Result<Node, TowerError> {
        let key = format!("{:?}", polynomial.terms());
        if let Some(&node) = self.polynomials.get(&key) {
            return Ok(node);
        }
        let node = match self.plain(polynomial)? {
            Some(node) => node,
            None => self.rewritten(polynomial)?,
        };
        self.graph.learn(node, self.tower.facts.sign(polynomial));
        self.polynomials.insert(key, node);
        Ok(node)
    }

    /// The steps of a polynomial that has no plain form as it stands, by the first rule that applies.
    fn rewritten(&mut self, polynomial: &Polynomial) -> Result<Node, TowerError> {
        if let Some(node) = rules::differences_first::apply(self, polynomial)? {
            return Ok(node);
        }
        if let Some(node) = rules::known_sum::apply(self, polynomial)? {
            return Ok(node);
        }
        rules::compensated::apply(self, polynomial)
    }

    /// The steps of a polynomial in plain arithmetic, if no sum of theirs can cancel.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn plain(&mut self, polynomial: &Polynomial) -> Result<Option<Node>, TowerError> {
        let inputs = self.tower.inputs();
        let nested = Nester::new(&self.tower.facts, inputs, Mode::Plain).nest(polynomial);
        nested.map(|nested| self.plain_steps(&nested)).transpose()
    }

    fn plain_steps(&mut self, nested: &Nested) -> Result<Node, TowerError> {
        Ok(match nested {
            Nested::Constant(value) => self.graph.constant(value),
            Nested::Var(var) => self.variable(*var)?,
            Nested::Sum(a, b, signs) => {
                let (a, b) = (self.plain_steps(a)?, self.plain_steps(b)?);
                self.graph.learn(a, signs[0]);
                self.graph.learn(b, signs[1]);
                let sum = self.graph.add(a, b);
                self.graph.learn(sum, signs[2]);
                sum
            }
            Nested::Product(a, b) => {
                let (a, b) = (self.plain_steps(a)?, self.plain_steps(b)?);
                self.graph.mul(a, b)
            }
        })
    }

    /// The double-double form of a polynomial in the inputs, up to a positive constant that is returned beside it.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn wide(&mut self, polynomial: &Polynomial) -> Result<(BigRational, Wide), TowerError> {
        let content = polynomial.primitive().0.abs();
        let scaled = polynomial.scaled(&content.recip());
        let inputs = self.tower.inputs();
        let nested = Nester::new(&self.tower.facts, inputs, Mode::Wide).nest(&scaled);
        let nested = nested.unwrap_or(Nested::Constant(BigRational::zero()));
        Ok((content, self.wide_steps(&nested)?))
    }

    fn wide_steps(&mut self, nested: &Nested) -> Result<Wide, TowerError> {
        Ok(match nested {
            Nested::Constant(value) => self.wide_constant(value),
            Nested::Var(var) => match self.difference_of(*var) {
                Some((a, b)) => {
                    let (a, b) = (self.variable(a)?, self.variable(b)?);
                    Wide::Sub(Box::new(Wide::Leaf(a)), Box::new(Wide::Leaf(b)))
                }
                None => Wide::Leaf(self.variable(*var)?),
            },
            Nested::Sum(a, b, _) => self.wide_sum(a, b)?,
            Nested::Product(a, b) => Wide::Mul(Box::new(self.wide_steps(a)?), Box::new(self.wide_steps(b)?)),
        })
    }

    /// `a + b`, as a difference where one of them begins with a minus.
    fn wide_sum(&mut self, a: &Nested, b: &Nested) -> Result<Wide, TowerError> {
        let (plus, minus) = match (opposite(a), opposite(b)) {
            (_, Some(minus)) => (a, minus),
            (Some(minus), None) => (b, minus),
            (None, None) => {
                let (a, b) = (self.wide_steps(a)?, self.wide_steps(b)?);
                return Ok(Wide::Add(Box::new(a), Box::new(b)));
            }
        };
        let (plus, minus) = (self.wide_steps(plus)?, self.wide_steps(&minus)?);
        Ok(Wide::Sub(Box::new(plus), Box::new(minus)))
    }

    /// An integer of any size as an unevaluated sum of numbers that `f64` holds.
    pub fn wide_constant(&mut self, value: &BigRational) -> Wide {
        if is_exact(value) {
            return Wide::Leaf(self.graph.constant(value));
        }
        let (high, rest) = match leading_bits(value) {
            Some(leading) => (Wide::Leaf(self.graph.constant(&leading)), value - leading),
            None => {
                let (step, high, rest) = beyond_literals(value);
                let step = Wide::Leaf(self.graph.constant(&step));
                (Wide::Mul(Box::new(step), Box::new(self.wide_constant(&high))), rest)
            }
        };
        if rest.is_zero() { high } else { Wide::Add(Box::new(high), Box::new(self.wide_constant(&rest))) }
    }

    /// The two inputs whose difference a variable stands for.
    #[must_use]
    pub fn difference_of(&self, var: Var) -> Option<(Var, Var)> {
        self.differences.iter().find(|(_, v)| **v == var).map(|(pair, _)| *pair)
    }

    /// The variable that stands for `a - b`.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn difference(&mut self, a: Var, b: Var) -> Result<Var, TowerError> {
        if let Some(&var) = self.differences.get(&(a, b)) {
            return Ok(var);
        }
        let ring = self.tower.ring();
        let sign = self.tower.facts.sign(&ring.variable(a).minus(&ring.variable(b)));
        let var = self.tower.allocate(sign)?;
        self.differences.insert((a, b), var);
        let (high, low) = (self.variable(a)?, self.variable(b)?);
        let difference = self.graph.sub(high, low);
        self.graph.learn(difference, sign);
        self.stand_ins.insert(var, difference);
        Ok(var)
    }

    /// The condition that a step has a sign relation to zero; constant factors of the step do not matter.
    pub fn compare_with_zero(&mut self, node: Node, order: Order) -> Condition {
        match *self.graph.op(node) {
            Op::Neg(a) => return self.compare_with_zero(a, order.mirrored()),
            Op::Mul(a, b) if self.has_one_sign(a) => {
                let order = if self.graph.sign(a).is(Sign::NEGATIVE) { order.mirrored() } else { order };
                return self.compare_with_zero(b, order);
            }
            Op::Mul(a, b) if self.has_one_sign(b) => {
                let order = if self.graph.sign(b).is(Sign::NEGATIVE) { order.mirrored() } else { order };
                return self.compare_with_zero(a, order);
            }
            _ => {}
        }
        let zero = self.graph.constant(&BigRational::zero());
        Condition::Compare(node, order, zero)
    }

    fn has_one_sign(&self, node: Node) -> bool {
        let sign = self.graph.sign(node);
        sign.is_definite() && sign.is(Sign::NONZERO)
    }
}

/// The negative of a form that begins with a negative constant.
fn opposite(nested: &Nested) -> Option<Nested> {
    match nested {
        Nested::Constant(value) if value.is_negative() => Some(Nested::Constant(-value)),
        Nested::Product(a, b) => match opposite(a)? {
            Nested::Constant(one) if one.is_one() => Some((**b).clone()),
            a => Some(Nested::Product(Box::new(a), b.clone())),
        },
        _ => None,
    }
}

/// A constant as an exact numerator over an exact denominator: dyadic ones stay above the bar.
fn split_constant(constant: &BigRational) -> (BigRational, BigRational) {
    if is_exact(constant) {
        return (constant.clone(), BigRational::one());
    }
    let below = BigRational::from_integer(constant.denom().clone());
    (BigRational::from_integer(constant.numer().clone()), below)
}

/// The sign relation that says "not of the opposite sign".
#[must_use]
pub fn not_opposite(sign: Sign) -> Option<Order> {
    if sign.is(Sign::NONNEGATIVE) {
        Some(Order::GreaterOrEqual)
    } else if sign.is(Sign::NONPOSITIVE) {
        Some(Order::LessOrEqual)
    } else {
        None
    }
}
