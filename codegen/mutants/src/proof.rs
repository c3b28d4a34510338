//! The judge by proof: a mutant whose text no longer proves the bounds that the kernel states.

use closedform_syntax::{Kernel, Output};

use super::place::Part;
use closedform_bounds::bound_proof;

/// Whether the mutant's statements in the whole kernel prove other bounds than stated. `base`, of which the mutant was
/// made, may lack branches of the kernel that are never taken, for a reason that no proof knows: it is asked only what
/// the base proves in the same statement.
pub fn refuses(kernel: &Kernel, base: &Kernel, mutant: &Kernel) -> bool {
    let changed: Vec<Part> = Part::all(base).into_iter().filter(|part| part.text(base) != part.text(mutant)).collect();
    let with = |from: &Kernel| {
        let mut whole = kernel.clone();
        changed.iter().for_each(|part| part.copy(from, &mut whole));
        whole.meta.results.clone_from(&from.meta.results);
        whole
    };
    bound_proof(&with(base)).is_ok() && bound_proof(&with(mutant)).is_err()
}

impl Part {
    /// Copies the statement from a kernel of the same statements.
    fn copy(self, from: &Kernel, to: &mut Kernel) {
        match self {
            Part::Require(at) => to.requires[at] = from.requires[at].clone(),
            Part::Let(at) => to.lets[at] = from.lets[at].clone(),
            Part::Result(at) => match (&from.output, &mut to.output) {
                (Output::Value(value), Output::Value(copied)) => copied.clone_from(value),
                (Output::Struct { fields, .. }, Output::Struct { fields: copied, .. }) => {
                    copied[at].clone_from(&fields[at]);
                }
                _ => {}
            },
        }
    }
}
