//! The builder: what forms share while they make steps, and the order in which they are tried, which is given from above.

use super::quotient::Quotient;
use super::rule::Rule;
use super::surd::Surd;
use crate::algebra::{Polynomial, Var};
use crate::field::{Element, Tower, TowerError};
use crate::program::{Graph, Node};
use closedform_syntax::Function;
use num_rational::BigRational;
use num_traits::Zero;
use std::collections::{BTreeMap, HashMap};

/// Makes the steps of a subject; `None` where the form does not apply.
pub type Form<S> = fn(&mut Builder, &S) -> Result<Option<Node>, TowerError>;

/// Makes the steps of any subject.
pub type LastForm<S> = fn(&mut Builder, &S) -> Result<Node, TowerError>;

/// The forms of a kind of subject, in the order in which they are tried.
pub struct Forms<S: 'static> {
    /// The first that applies is taken.
    pub tried: &'static [Form<S>],
    /// What is taken where none does.
    pub last: LastForm<S>,
}

/// The forms of every kind of subject.
pub struct AllForms {
    /// Of polynomials in the inputs and named parts, accurate on the whole domain.
    pub polynomials: Forms<Polynomial>,
    /// Of sums with a square root, times a quotient.
    pub surds: Forms<Surd>,
    /// Of sums with a cube root, times a quotient.
    pub cubics: Forms<Surd>,
    /// Of quotients.
    pub quotients: Forms<Quotient>,
}

/// Builds the steps of one kernel.
pub struct Builder {
    /// The field of the kernel's closed forms.
    pub tower: Tower,
    /// The steps so far.
    pub graph: Graph,
    forms: &'static AllForms,
    /// The steps that named variables stand for: radicals, results, differences.
    stand_ins: BTreeMap<Var, Node>,
    /// Differences of two inputs that have a variable of their own.
    differences: BTreeMap<(Var, Var), Var>,
    polynomials: HashMap<String, Node>,
}

impl<S> Forms<S> {
    fn steps(&self, builder: &mut Builder, subject: &S) -> Result<Node, TowerError> {
        for form in self.tried {
            if let Some(node) = form(builder, subject)? {
                return Ok(node);
            }
        }
        (self.last)(builder, subject)
    }
}

impl Builder {
    /// Nothing built yet.
    #[must_use]
    pub fn new(tower: Tower, forms: &'static AllForms) -> Self {
        Self {
            tower,
            graph: Graph::default(),
            forms,
            stand_ins: BTreeMap::new(),
            differences: BTreeMap::new(),
            polynomials: HashMap::new(),
        }
    }

    /// Lets polynomials be built anew, because more is known of their signs.
    pub fn forget_polynomials(&mut self) {
        self.polynomials.clear();
    }

    /// Records that a rule made a step.
    pub fn mark(&mut self, rule: &'static Rule, node: Node) {
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
                let inside = self.value(&inside)?;
                self.graph.call(Function::Abs, inside)
            }
            None => {
                let radicand = self.tower.element(&radical.radicand);
                let inside = self.element(&radicand)?;
                self.root(radical.degree, inside)
            }
        };
        self.stand_ins.insert(var, node);
        Ok(node)
    }

    /// The root of a step.
    pub fn root(&mut self, degree: u32, inside: Node) -> Node {
        let function = Function::root(degree).expect("the degree of a radical is that of a function");
        self.graph.call(function, inside)
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
        self.product(&element.numerator, quotient)
    }

    /// The steps of a polynomial in inputs and radicals.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn value(&mut self, polynomial: &Polynomial) -> Result<Node, TowerError> {
        self.product(polynomial, Quotient::one())
    }

    /// The steps of a polynomial in inputs and radicals, times a quotient.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn product(&mut self, polynomial: &Polynomial, mut quotient: Quotient) -> Result<Node, TowerError> {
        let Some(radical) = self.tower.top_radical(polynomial).cloned() else {
            quotient.multiply(polynomial, 1);
            return self.quotient(&quotient);
        };
        let (rational_content, polynomial) = polynomial.primitive();
        let content = self.tower.content(&polynomial);
        let primitive = polynomial.divided_by(&content).unwrap_or(polynomial);
        quotient.constant *= rational_content;
        quotient.multiply(&content, 1);
        self.surd(&Surd::new(primitive, radical, quotient))
    }

    /// The steps of a sum with a root, times a quotient.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn surd(&mut self, surd: &Surd) -> Result<Node, TowerError> {
        let forms = if surd.radical.degree == 3 { &self.forms.cubics } else { &self.forms.surds };
        forms.steps(self, surd)
    }

    /// The steps of a quotient.
    ///
    /// # Errors
    /// When the tower has no room left.
    pub fn quotient(&mut self, quotient: &Quotient) -> Result<Node, TowerError> {
        self.forms.quotients.steps(self, quotient)
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
        let node = self.forms.polynomials.steps(self, polynomial)?;
        self.graph.learn(node, self.tower.facts.sign(polynomial));
        self.polynomials.insert(key, node);
        Ok(node)
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
}
