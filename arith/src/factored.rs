//! The factored form of a compensated expression: its sums and products as they are written, for a machine with a stack.

/// A step of the machine, a byte in its compact form: what takes two numbers takes the topmost, of which the second was
/// put there last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Puts an operand, by position, on top; there are [`Step::MAX_OPERANDS`] at most.
    Operand(u8),
    /// The first plus the second.
    Sum,
    /// The first minus the second.
    Difference,
    /// The second minus the first.
    Reversed,
    /// The first times the second.
    Product,
    /// The negative of the topmost.
    Negative,
}

impl Step {
    /// How many operands positions tell apart.
    pub const MAX_OPERANDS: u8 = u8::MAX - 4;

    /// The compact form; `None` for an operand that it does not tell from the operations.
    #[must_use]
    pub const fn byte(self) -> Option<u8> {
        match self {
            Self::Operand(position) if position >= Self::MAX_OPERANDS => None,
            Self::Operand(position) => Some(position),
            Self::Sum => Some(Self::MAX_OPERANDS),
            Self::Difference => Some(Self::MAX_OPERANDS + 1),
            Self::Reversed => Some(Self::MAX_OPERANDS + 2),
            Self::Product => Some(Self::MAX_OPERANDS + 3),
            Self::Negative => Some(Self::MAX_OPERANDS + 4),
        }
    }

    /// The step of this compact form.
    #[must_use]
    pub const fn of(byte: u8) -> Self {
        match byte.checked_sub(Self::MAX_OPERANDS) {
            None => Self::Operand(byte),
            Some(0) => Self::Sum,
            Some(1) => Self::Difference,
            Some(2) => Self::Reversed,
            Some(3) => Self::Product,
            Some(_) => Self::Negative,
        }
    }
}

/// Numbers on top of each other.
pub(crate) struct Stack<T, const HEIGHT: usize> {
    places: [Option<T>; HEIGHT],
    height: usize,
}

impl<T: Copy, const HEIGHT: usize> Stack<T, HEIGHT> {
    pub(crate) fn new() -> Self {
        Stack { places: [None; HEIGHT], height: 0 }
    }

    /// `None` where there is no room.
    pub(crate) fn push(&mut self, value: T) -> Option<()> {
        *self.places.get_mut(self.height)? = Some(value);
        self.height += 1;
        Some(())
    }

    pub(crate) fn pop(&mut self) -> Option<T> {
        self.height = self.height.checked_sub(1)?;
        self.places.get_mut(self.height)?.take()
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;

    #[test]
    fn steps_are_read_as_they_were_written() {
        for byte in 0..=u8::MAX {
            assert_eq!(Step::of(byte).byte(), Some(byte));
        }
        assert_eq!(Step::Operand(Step::MAX_OPERANDS).byte(), None);
    }

    #[test]
    fn what_comes_last_goes_first() {
        let mut stack = Stack::<usize, 8>::new();
        assert!((0..8).all(|number| stack.push(number).is_some()) && stack.push(0).is_none());
        assert!((0..8).rev().all(|number| stack.pop() == Some(number)) && stack.pop().is_none());
    }
}
