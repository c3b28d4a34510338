//! Which registers are taken.

use closedform_arith::limits::MAX_REGISTERS;

/// The registers, by position, and whether each is taken.
#[derive(Default)]
pub struct Registers(Vec<bool>);

impl Registers {
    /// Takes the first that is free; `None` where all are taken.
    pub fn take(&mut self) -> Option<u8> {
        self.take_row(1)
    }

    /// Takes as many one after another; the first of them.
    pub fn take_row(&mut self, count: usize) -> Option<u8> {
        let free = |first: &usize| self.0.iter().skip(*first).take(count).all(|taken| !taken);
        let first = (0..=self.0.len()).find(free)?;
        let end = first.checked_add(count).filter(|end| *end <= MAX_REGISTERS)?;
        self.0.resize(end.max(self.0.len()), false);
        self.0.iter_mut().skip(first).take(count).for_each(|taken| *taken = true);
        u8::try_from(first).ok()
    }

    /// Gives one back.
    pub fn release(&mut self, register: u8) {
        if let Some(taken) = self.0.get_mut(usize::from(register)) {
            *taken = false;
        }
    }

    /// How many were taken at once, at most.
    pub fn most(&self) -> usize {
        self.0.len()
    }
}
