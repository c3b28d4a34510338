//! Counts roundings; the count of a sum holds because its terms have one sign on the domain.

use crate::case::{CASES, Case, alternatives};
use crate::correction;
use crate::equal;
use crate::forms::{Forms, Meaning};
use crate::polynomial::{Atom, Polynomial};
use crate::refusal::{Reason, Refusal};
use crate::sign::Sign;
use crate::text::text;
use crate::trusted;
use closedform_syntax::{BinaryOp, Condition, Expr, Function, Kernel, Precision, condition_text};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// A count of roundings, or why there is none.
pub type Count = Result<BigRational, Refusal>;

/// How long a sign is searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effort {
    /// Not long: there are other ways to it.
    Brief,
    /// As long as it may help.
    Full,
}

/// Counts in one kernel.
pub struct Counter<'k> {
    pub(crate) kernel: &'k Kernel,
    pub(crate) forms: Forms<'k>,
}

impl<'k> Counter<'k> {
    /// Nothing counted yet.
    pub fn new(kernel: &'k Kernel) -> Self {
        Self { kernel, forms: Forms::new(kernel) }
    }

    /// The count of a step whose operands are exact.
    pub(crate) fn rounding(&self) -> BigRational {
        match self.kernel.meta.precision {
            Precision::Double => trusted::rounding(),
            Precision::DoubleDouble | Precision::Certified => trusted::double_double_step(),
        }
    }

    /// The count of a function of an exact argument.
    fn call(&self, function: Function) -> BigRational {
        match self.kernel.meta.precision {
            Precision::Double => trusted::call(function),
            Precision::DoubleDouble | Precision::Certified if function.is_exact() => BigRational::zero(),
            Precision::DoubleDouble | Precision::Certified => trusted::double_double_step(),
        }
    }

    /// The count of the last step: a value in double-double is rounded to `f64`.
    pub(crate) fn last_rounding(&self) -> BigRational {
        match self.kernel.meta.precision {
            Precision::Double => BigRational::zero(),
            Precision::DoubleDouble | Precision::Certified => trusted::rounding(),
        }
    }

    fn compensated_expression(&self) -> BigRational {
        match self.kernel.meta.precision {
            Precision::Double => trusted::compensated(),
            Precision::DoubleDouble | Precision::Certified => trusted::compensated_in_double_double(),
        }
    }

    pub(crate) fn refuse<T>(&self, step: &str, reason: Reason) -> Result<T, Refusal> {
        Err(Refusal { kernel: self.kernel.name.to_string(), step: step.to_owned(), reason })
    }

    /// The cases of the whole domain, and the comparisons in it that rounding may decide wrongly.
    pub fn domain(&self) -> (Vec<Case>, Vec<Refusal>) {
        let mut cases = vec![Case::default()];
        let mut refusals = Vec::new();
        for require in &self.kernel.requires {
            let decided = |comparison: &'k Condition| cases.iter().all(|case| self.decided(comparison, case).is_some());
            let open = require.condition.comparisons().into_iter().filter(|comparison| !decided(comparison));
            refusals.extend(open.map(|comparison| Refusal {
                kernel: self.kernel.name.to_string(),
                step: "require!".to_owned(),
                reason: self.why_open(comparison, &cases),
            }));
            let split: Vec<Case> = cases.iter().flat_map(|case| self.cases(&require.condition, true, case)).collect();
            cases = if split.len() > CASES { cases } else { split };
        }
        cases.iter().for_each(|case| case.facts.borrow_mut().settle_atoms());
        (cases, refusals)
    }

    /// The cases of one where a condition holds, or where it does not.
    pub(crate) fn cases(&self, condition: &'k Condition, holds: bool, case: &Case) -> Vec<Case> {
        let compare = |condition: &'k Condition| self.decided(condition, case);
        case.split(&alternatives(condition, holds, &compare))
    }

    /// The difference whose sign decides a comparison, if rounding cannot change that sign. It cannot if both sides are
    /// exact, or if one side is zero and some digits of the other one are right.
    fn decided(&self, condition: &'k Condition, case: &Case) -> Option<Polynomial> {
        let Condition::Compare { left, right, .. } = condition else { return None };
        let (a, b) = (self.count(left, case, "require").ok()?, self.count(right, case, "require").ok()?);
        let (left, right) = (self.forms.of(left), self.forms.of(right));
        let decided = a.is_zero() && b.is_zero() || left.is_zero() || right.is_zero();
        let difference = left.minus(&right);
        self.learn_atoms(&difference, case);
        decided.then_some(difference)
    }

    /// The count of an expression, met in this step.
    pub fn count(&self, expr: &'k Expr, case: &Case, step: &str) -> Count {
        match expr {
            Expr::Literal { .. } => Ok(BigRational::zero()),
            Expr::Name(name) => self.count_name(name.slot, case),
            Expr::Pi(_) => Ok(self.rounding()),
            Expr::Neg(inner) => self.count(inner, case, step),
            Expr::Call(function, inner) => {
                let count = self.count(inner, case, step)?;
                self.has_value(*function, inner, case, step)?;
                if function.has_steps() {
                    return if count.is_zero() { Ok(count) } else { self.refuse(step, Reason::Stepped(text(expr))) };
                }
                let Some((p, q)) = function.properties().exponent else {
                    return self.refuse(step, Reason::Elementary(text(expr)));
                };
                Ok(count * integer(p.into()) / integer(q.into()) + self.call(*function))
            }
            Expr::Binary { op: BinaryOp::Add | BinaryOp::Sub, left, right } => {
                match correction::of(self, expr, case, step) {
                    Some(count) => count,
                    None => self.count_sum(expr, (left, right), case, step),
                }
            }
            Expr::Binary { op, left, right } => self.count_product(*op, (left, right), case, step),
            Expr::If { condition, then, otherwise } => self.count_choice(condition, [then, otherwise], case, step),
            Expr::Extreme { items, .. } => self.count_worst(items, case, step),
            Expr::Compensated(expression) => self.count_compensated(expr, &expression.operands, case, step),
            Expr::Residual(_) => self.refuse(step, Reason::Residual(text(expr))),
            Expr::PositiveRoot(coefficients) => {
                let worst = self.count_worst(coefficients, case, step)?;
                self.has_positive_root(expr, coefficients, case, step)?;
                Ok(worst * integer(2) + trusted::positive_root())
            }
        }
    }

    fn count_name(&self, slot: usize, case: &Case) -> Count {
        let Some(value) = self.forms.step(slot) else { return Ok(BigRational::zero()) };
        if let Some(known) = case.counts.borrow().get(&slot) {
            return known.clone();
        }
        let name = self.kernel.lets[slot - self.kernel.inputs.len()].name.to_string();
        let count = self.count(value, case, &name);
        case.counts.borrow_mut().insert(slot, count.clone());
        count
    }

    /// The worst count of some expressions.
    pub(crate) fn count_worst(&self, values: &'k [Expr], case: &Case, step: &str) -> Count {
        values.iter().try_fold(BigRational::zero(), |worst, value| Ok(worst.max(self.count(value, case, step)?)))
    }

    /// The larger count of the two sides. It holds if rounding cannot change what the condition says, or if both sides are
    /// the same function, so that either may be taken.
    fn count_choice(&self, condition: &'k Condition, sides: [&'k Expr; 2], case: &Case, step: &str) -> Count {
        let [then, otherwise] = sides;
        let then_count = self.count_branch(self.cases(condition, true, case), then, step)?;
        let otherwise_count = self.count_branch(self.cases(condition, false, case), otherwise, step)?;
        let open = condition.comparisons().into_iter().find(|comparison| self.decided(comparison, case).is_none());
        match open {
            Some(comparison) if !equal::same_function(self, then, otherwise, case) => {
                self.refuse(step, Reason::Turned(condition_text(comparison)))
            }
            _ => Ok(then_count.max(otherwise_count)),
        }
    }

    fn count_branch(&self, cases: Vec<Case>, value: &'k Expr, step: &str) -> Count {
        cases.iter().try_fold(BigRational::zero(), |worst, case| Ok(worst.max(self.count(value, case, step)?)))
    }

    fn count_sum(&self, sum: &'k Expr, (left, right): (&'k Expr, &'k Expr), case: &Case, step: &str) -> Count {
        let worst = self.count(left, case, step)?.max(self.count(right, case, step)?);
        if worst.is_zero() {
            return Ok(self.rounding());
        }
        let (a, b) = (self.sign(left, case), self.sign(right, case));
        let b_as_added = if matches!(sum, Expr::Binary { op: BinaryOp::Sub, .. }) { b.negated() } else { b };
        if a.plus(b_as_added).is_definite() || case.facts.borrow().are_contradictory() {
            return Ok(worst + self.rounding());
        }
        self.refuse(step, Reason::may_cancel(text(sum), a, b_as_added))
    }

    fn count_product(&self, op: BinaryOp, (left, right): (&'k Expr, &'k Expr), case: &Case, step: &str) -> Count {
        let sum = self.count(left, case, step)? + self.count(right, case, step)?;
        if op == BinaryOp::Div {
            self.divides(right, case, step)?;
        }
        let scales = |factor| self.is_power_of_two(factor);
        let exact = scales(right) || op == BinaryOp::Mul && scales(left);
        Ok(if exact { sum } else { sum + self.rounding() })
    }

    fn is_power_of_two(&self, factor: &'k Expr) -> bool {
        match self.forms.resolved(factor) {
            Expr::Neg(inner) => self.is_power_of_two(inner),
            Expr::Literal { value, .. } => {
                let value = crate::forms::number(*value);
                let one_bit = |n: &num_bigint::BigInt| n.magnitude().count_ones() == 1;
                one_bit(value.numer()) && one_bit(value.denom())
            }
            _ => false,
        }
    }

    fn count_compensated(&self, expression: &'k Expr, operands: &'k [Expr], case: &Case, step: &str) -> Count {
        for operand in operands {
            if !self.count(operand, case, step)?.is_zero() {
                return self.refuse(step, Reason::Rounded { expression: text(expression), operand: text(operand) });
            }
        }
        Ok(self.compensated_expression())
    }

    /// The sign of an expression: from the signs of its parts as they are written, or from its form.
    pub(crate) fn sign(&self, expr: &'k Expr, case: &Case) -> Sign {
        let brief = self.sign_with(expr, case, Effort::Brief);
        if brief.is_definite() { brief } else { brief.and(self.sign_with(expr, case, Effort::Full)) }
    }

    fn sign_with(&self, expr: &'k Expr, case: &Case, effort: Effort) -> Sign {
        let form = self.forms.of(expr);
        self.learn_atoms(&form, case);
        let direct = case.facts.borrow().direct(&form);
        let sign = direct.and(self.sign_as_written(expr, case, effort));
        if sign.is_definite() { sign } else { sign.and(self.search(&form, case, effort)) }
    }

    fn sign_as_written(&self, expr: &'k Expr, case: &Case, effort: Effort) -> Sign {
        let part = |inner| self.sign_with(inner, case, effort);
        let term = |inner| self.sign_with(inner, case, Effort::Brief);
        match expr {
            Expr::Neg(inner) => part(inner).negated(),
            Expr::Binary { op: BinaryOp::Add, left, right } => term(left).plus(term(right)),
            Expr::Binary { op: BinaryOp::Sub, left, right } => term(left).plus(term(right).negated()),
            Expr::Binary { op: BinaryOp::Mul, .. } => self.sign_of_product(expr, &part),
            // a quotient has the sign of the product, wherever it is defined
            Expr::Binary { left, right, .. } => {
                let product = self.forms.of(left).times(&self.forms.of(right));
                self.learn_atoms(&product, case);
                part(left).times(part(right)).and(self.search(&product, case, effort))
            }
            Expr::Compensated(expression) => part(&expression.value),
            Expr::Name(name) => self.forms.step(name.slot).map_or(Sign::ANY, part),
            _ => Sign::ANY,
        }
    }

    /// The sign of a product: of equal factors, that of a power.
    fn sign_of_product(&self, product: &'k Expr, part: &dyn Fn(&'k Expr) -> Sign) -> Sign {
        let mut powers: Vec<(&'k Expr, u32)> = Vec::new();
        for factor in factors(product) {
            match powers.iter_mut().find(|(known, _)| self.forms.of(known) == self.forms.of(factor)) {
                Some((_, power)) => *power += 1,
                None => powers.push((factor, 1)),
            }
        }
        let signs = powers.into_iter().map(|(factor, power)| part(factor).power(power));
        signs.reduce(Sign::times).unwrap_or(Sign::ANY)
    }

    /// The sign of a polynomial.
    pub(crate) fn sign_of_form(&self, form: &Polynomial, case: &Case) -> Sign {
        self.learn_atoms(form, case);
        let brief = self.search(form, case, Effort::Brief);
        if brief.is_definite() { brief } else { brief.and(self.search(form, case, Effort::Full)) }
    }

    fn search(&self, form: &Polynomial, case: &Case, effort: Effort) -> Sign {
        if let Some((known, spent)) = case.signs.borrow().get(form)
            && (known.is_definite() || *spent >= effort)
        {
            return *known;
        }
        let sign = match effort {
            Effort::Brief => case.facts.borrow().brief_sign(form),
            Effort::Full => case.facts.borrow().sign(form),
        };
        case.signs.borrow_mut().insert(form.clone(), (sign, effort));
        sign
    }

    fn learn_atoms(&self, form: &Polynomial, case: &Case) {
        form.atoms().into_iter().for_each(|atom| self.learn_atom(atom, case));
    }

    /// Tells a case the sign of an atom, which follows from the expression that the atom stands for.
    fn learn_atom(&self, atom: Atom, case: &Case) {
        if !case.learnt.borrow_mut().insert(atom) {
            return;
        }
        let sign = self.sign_of_meaning(&self.forms.meaning(atom), case);
        case.facts.borrow_mut().set_atom(atom, sign);
    }

    fn sign_of_meaning(&self, meaning: &Meaning<'k>, case: &Case) -> Sign {
        match meaning {
            Meaning::Input => Sign::ANY,
            Meaning::Pi => Sign::POSITIVE,
            Meaning::Call(function, inner) => self.sign_of_form(inner, case).called(*function),
            Meaning::Quotient(a, b) => self.sign_of_form(a, case).times(self.sign_of_form(b, case)),
            Meaning::Opaque(Expr::PositiveRoot(_)) => Sign::POSITIVE,
            Meaning::Opaque(Expr::If { condition, then, otherwise }) => {
                let then = self.cases(condition, true, case).into_iter().map(|case| self.sign(then, &case));
                let otherwise = self.cases(condition, false, case).into_iter().map(|case| self.sign(otherwise, &case));
                then.chain(otherwise).reduce(Sign::or).unwrap_or(Sign::ANY)
            }
            Meaning::Opaque(Expr::Extreme { items, .. }) => {
                items.iter().map(|item| self.sign(item, case)).reduce(Sign::or).unwrap_or(Sign::ANY)
            }
            Meaning::Opaque(_) => Sign::ANY,
        }
    }
}

/// The factors of a product, as they are written.
fn factors(expr: &Expr) -> Vec<&Expr> {
    match expr {
        Expr::Binary { op: BinaryOp::Mul, left, right } => [factors(left), factors(right)].concat(),
        factor => vec![factor],
    }
}

/// An integer.
pub(crate) fn integer(value: i64) -> BigRational {
    BigRational::from_integer(value.into())
}

/// Whether a count is within a limit.
pub(crate) fn within(count: &BigRational, limit: i64) -> bool {
    !count.is_negative() && *count <= integer(limit)
}
