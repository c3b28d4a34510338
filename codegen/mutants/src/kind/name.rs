//! Names: another input of the same unit where one belongs.

use closedform_syntax::{Expr, Kernel, Name};

use crate::mistake::Wrong;

/// The inputs of a kernel with their units.
pub struct Names {
    inputs: Vec<(Name, Option<String>)>,
}

impl Names {
    /// Those of a kernel.
    pub fn of(kernel: &Kernel) -> Self {
        let inputs = kernel.inputs.iter().enumerate();
        let inputs = inputs.map(|(slot, input)| (Name { ident: input.name.clone(), slot }, input.unit.clone()));
        Names { inputs: inputs.collect() }
    }

    /// What may stand for a name.
    pub fn mutations(&self, expr: &Expr) -> Vec<Wrong<Expr>> {
        let Expr::Name(name) = expr else { return Vec::new() };
        let Some((_, unit)) = self.inputs.get(name.slot) else { return Vec::new() };
        let others = self.inputs.iter().filter(|(other, of)| other.slot != name.slot && of == unit);
        others
            .map(|(other, _)| Wrong::new(format!("{} as {}", name.ident, other.ident), Expr::Name(other.clone())))
            .collect()
    }
}
