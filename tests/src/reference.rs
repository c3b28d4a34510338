//! The oracle, a twin of the commands' own on purpose: what Maxima derived, in MPFR at a precision raised until the digits
//! that count no longer change.

use std::collections::BTreeMap;

use closedform::Info;
use closedform_maxima::{Definition, EvalError, Expr, definitions, evaluate, evaluate_stable};
use rug::Float;

use crate::worksheets;

/// Bits of a value that are right: a double's, and enough to measure thousandths of an ulp.
const BITS: u32 = 80;

/// The reference definitions of a family, by worksheet name.
#[derive(Clone, Debug)]
pub struct References(Vec<Definition>);

impl References {
    /// Those of `maxima-ref/FAMILY.ref`.
    pub fn load(family: &str) -> Self {
        Self::parse(&worksheets::read(family, "ref")).unwrap_or_else(|error| panic!("{family}.ref: {error}"))
    }

    /// Those of a text of definitions.
    pub fn parse(text: &str) -> Result<Self, String> {
        definitions(text).map(References).map_err(|errors| errors.to_string())
    }

    /// The definition of a worksheet name.
    pub fn get(&self, worksheet: &str) -> Option<&Definition> {
        self.0.iter().find(|definition| definition.name == worksheet)
    }

    /// All worksheet names.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|definition| definition.name.as_str())
    }
}

/// The references of one kernel's results.
#[derive(Clone, Debug)]
pub struct Oracle {
    names: Vec<&'static str>,
    bodies: Vec<Expr>,
}

impl Oracle {
    /// The oracle of a kernel, or what its references lack.
    pub fn new(info: &Info, references: &References) -> Result<Self, String> {
        let names: Vec<&str> = info.inputs.iter().map(|input| input.maxima).collect();
        let body = |worksheet: &str| {
            let definition =
                references.get(worksheet).ok_or_else(|| format!("{}: no reference `{worksheet}`", info.name))?;
            if definition.parameters != names {
                return Err(format!("{}: `{worksheet}` takes {:?}, not {names:?}", info.name, definition.parameters));
            }
            Ok(definition.body.clone())
        };
        let bodies = info.results.iter().map(|result| body(result.worksheet)).collect::<Result<_, _>>()?;
        Ok(Oracle { names, bodies })
    }

    /// The names of the inputs.
    pub fn names(&self) -> &[&'static str] {
        &self.names
    }

    /// The reference expressions, one a result.
    pub fn bodies(&self) -> &[Expr] {
        &self.bodies
    }

    /// The value of one result at exactly these inputs.
    pub fn value(&self, result: usize, inputs: &[f64]) -> Result<Float, EvalError> {
        let names = self.names.iter().map(|name| (*name).to_owned()).zip(inputs.iter().copied()).collect();
        evaluate_stable(&self.bodies[result], &names, BITS)
    }

    /// The value of one result at inputs that need not be doubles, at a fixed precision.
    pub fn value_at(&self, result: usize, inputs: &[Float], precision: u32) -> Result<Float, EvalError> {
        let names: BTreeMap<String, Float> =
            self.names.iter().map(|name| (*name).to_owned()).zip(inputs.iter().cloned()).collect();
        evaluate(&self.bodies[result], &names, precision)
    }
}
