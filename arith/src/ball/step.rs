//! Functions whose values are integers, in balls: decided where no step lies in the ball, or where the number is shown to be one.

use core::cmp::Ordering;

use super::limbs::Limbs;
use super::{Ball, Kind};
use crate::step::{Fraction, Step};

impl<const L: usize> Ball<'_, L> {
    /// The integer that a number becomes; unknown where the ball is too large to tell.
    pub(crate) fn stepped(&self, step: Step) -> Self {
        if self.kind != Kind::Number {
            return Self::without_value(self.kind, self.decisions);
        }
        if self.radius.is_zero() {
            return self.integer(self.middle.stepped(step));
        }
        let (least, most) = self.enclosure().ends();
        let (below, above) = (least.stepped(step), most.stepped(step));
        let unknown = || Self::without_value(Kind::Unknown, self.decisions);
        match below.distance(&above) {
            // they are no farther apart than the numbers between them
            Some(0) => self.integer(below),
            Some(1) => match self.side_of(step.place(&below, &above)) {
                Some(Ordering::Less) => self.integer(below),
                Some(Ordering::Equal) => self.integer(step.place(&below, &above).stepped(step)),
                Some(Ordering::Greater) => self.integer(above),
                None => unknown(),
            },
            _ => unknown(),
        }
    }

    /// How the number compares with a multiple of 1/2, if that is decided.
    fn side_of(&self, place: Limbs<L>) -> Option<Ordering> {
        let half_integer = self.integer(place.scaled(1)).times(&Ball::new(0.5, self.decisions));
        self.order(&half_integer).flatten()
    }
}

impl Step {
    /// Where the step between two integers is, of which one follows the other.
    fn place<const L: usize>(self, below: &Limbs<L>, above: &Limbs<L>) -> Limbs<L> {
        match self {
            Self::Floor => *above,
            Self::Ceiling => *below,
            Self::Round => below.plus(*above).0.scaled(-1),
            // the one that is farther from zero
            Self::Truncate if above.order_of_magnitudes(below) == Ordering::Greater => *above,
            Self::Truncate => *below,
        }
    }
}

impl<const L: usize> Limbs<L> {
    /// The integer that it becomes, exactly.
    fn stepped(self, step: Step) -> Self {
        // what has no fraction among its words is an integer
        let Some((whole, last)) = self.whole() else { return self };
        let fraction = self.plus(whole.negated()).0.magnitude();
        let half = Self::from_integer(false, 1, -1);
        let fraction: Fraction = (!fraction.is_zero()).then(|| fraction.order_of_magnitudes(&half));
        if step.leaves_zero(self.is_negative(), last % 2 == 1, fraction) {
            whole.plus(Self::from_integer(self.is_negative(), 1, 0)).0
        } else {
            whole
        }
    }

    /// How far apart two integers are; `None` of more than one.
    fn distance(&self, other: &Self) -> Option<u8> {
        let (difference, cut) = self.plus(other.negated());
        match cut {
            None if difference.is_zero() => Some(0),
            None if difference.is_exactly(1.0) || difference.is_exactly(-1.0) => Some(1),
            _ => None,
        }
    }
}
