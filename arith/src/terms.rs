//! The terms of a compensated expression: products of its operands, in a compact form that an iterator reads.

/// Marks a product that is subtracted, in the byte that tells how many factors follow.
const NEGATIVE: u8 = 0x80;

/// A product of operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Term<'a> {
    /// Whether it is subtracted.
    pub negative: bool,
    /// The positions of its factors among the operands, [`MAX_FACTORS`](crate::limits::MAX_FACTORS) at most.
    pub factors: &'a [u8],
}

impl Term<'_> {
    /// The compact form, which [`Terms`] reads.
    pub fn compact(&self) -> impl Iterator<Item = u8> {
        let head = self.factors.len() as u8 | if self.negative { NEGATIVE } else { 0 };
        core::iter::once(head).chain(self.factors.iter().copied())
    }
}

/// The terms of a compensated expression, in order, and the sums and products that it was written as.
#[derive(Clone, Copy, Debug)]
pub struct Terms<'a> {
    compact: &'a [u8],
    factored: &'a [u8],
}

impl<'a> Terms<'a> {
    /// The terms whose [compact forms](Term::compact) stand one after another.
    #[must_use]
    pub const fn of(compact: &'a [u8]) -> Self {
        Terms { compact, factored: &[] }
    }

    /// The same terms, of what these [steps](crate::factored::Step) in their compact form compute too.
    #[must_use]
    pub const fn written_as(self, factored: &'a [u8]) -> Self {
        Terms { factored, ..self }
    }

    /// The steps that compute the same; none where they are not known.
    #[must_use]
    pub const fn factored(&self) -> &'a [u8] {
        self.factored
    }
}

impl<'a> Iterator for Terms<'a> {
    type Item = Term<'a>;

    fn next(&mut self) -> Option<Term<'a>> {
        let (&head, rest) = self.compact.split_first()?;
        let (factors, rest) = rest.split_at_checked(usize::from(head & !NEGATIVE))?;
        self.compact = rest;
        Some(Term { negative: head & NEGATIVE != 0, factors })
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use crate::limits::MAX_FACTORS;
    use crate::terms::*;
    use std::vec::Vec;

    #[test]
    fn terms_are_read_as_they_were_written() {
        let longest = [254; MAX_FACTORS];
        let factors: [&[u8]; 4] = [&[0], &[], &[3, 0, 128, 3], &longest];
        let signed = |factors| [true, false].map(|negative| Term { negative, factors });
        let terms: Vec<Term> = factors.into_iter().flat_map(signed).collect();
        let compact: Vec<u8> = terms.iter().flat_map(Term::compact).collect();
        assert_eq!(Terms::of(&compact).collect::<Vec<_>>(), terms);
    }
}
