//! The six relations of order between two numbers, and how each language writes them.

use core::cmp::Ordering;

/// How two numbers compare, or a number with zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// The first is smaller.
    Less,
    /// The first is not larger.
    LessOrEqual,
    /// The first is larger.
    Greater,
    /// The first is not smaller.
    GreaterOrEqual,
    /// They are equal.
    Equal,
    /// They differ.
    NotEqual,
}

impl Relation {
    /// Every relation.
    pub const ALL: [Self; 6] =
        [Self::Less, Self::LessOrEqual, Self::Greater, Self::GreaterOrEqual, Self::Equal, Self::NotEqual];

    /// Whether it holds of two numbers in this order.
    #[must_use]
    pub const fn holds(self, order: Ordering) -> bool {
        match self {
            Self::Less => order.is_lt(),
            Self::LessOrEqual => order.is_le(),
            Self::Greater => order.is_gt(),
            Self::GreaterOrEqual => order.is_ge(),
            Self::Equal => order.is_eq(),
            Self::NotEqual => order.is_ne(),
        }
    }

    /// The relation that holds of the sides exchanged, or of their negatives.
    #[must_use]
    pub const fn mirrored(self) -> Self {
        match self {
            Self::Less => Self::Greater,
            Self::LessOrEqual => Self::GreaterOrEqual,
            Self::Greater => Self::Less,
            Self::GreaterOrEqual => Self::LessOrEqual,
            Self::Equal | Self::NotEqual => self,
        }
    }

    /// The relation that holds where this one fails.
    #[must_use]
    pub const fn negated(self) -> Self {
        match self {
            Self::Less => Self::GreaterOrEqual,
            Self::LessOrEqual => Self::Greater,
            Self::Greater => Self::LessOrEqual,
            Self::GreaterOrEqual => Self::Less,
            Self::Equal => Self::NotEqual,
            Self::NotEqual => Self::Equal,
        }
    }

    /// Whether it asks for the first side to be below the second, strictly or not.
    #[must_use]
    pub const fn is_below(self) -> bool {
        matches!(self, Self::Less | Self::LessOrEqual)
    }

    /// Whether it asks for the first side to be above the second, strictly or not.
    #[must_use]
    pub const fn is_above(self) -> bool {
        self.mirrored().is_below()
    }

    /// As Rust writes it.
    #[must_use]
    pub const fn rust(self) -> &'static str {
        match self {
            Self::Less => "<",
            Self::LessOrEqual => "<=",
            Self::Greater => ">",
            Self::GreaterOrEqual => ">=",
            Self::Equal => "==",
            Self::NotEqual => "!=",
        }
    }

    /// As Maxima writes it.
    #[must_use]
    pub const fn maxima(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::NotEqual => "#",
            _ => self.rust(),
        }
    }

    /// As LaTeX writes it, between two formulas.
    #[must_use]
    pub const fn latex(self) -> &'static str {
        match self {
            Self::LessOrEqual => r"\leq ",
            Self::GreaterOrEqual => r"\geq ",
            Self::NotEqual => r"\neq ",
            _ => self.maxima(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NUMBERS: [i32; 3] = [-1, 0, 1];

    /// Rust's own operators say what holds.
    fn by_operator(relation: Relation, a: i32, b: i32) -> bool {
        match relation.rust() {
            "<" => a < b,
            "<=" => a <= b,
            ">" => a > b,
            ">=" => a >= b,
            "==" => a == b,
            "!=" => a != b,
            other => panic!("`{other}` compares nothing"),
        }
    }

    #[test]
    fn relations_hold_as_their_operators_do() {
        for relation in Relation::ALL {
            for (a, b) in NUMBERS.iter().flat_map(|&a| NUMBERS.map(|b| (a, b))) {
                let holds = by_operator(relation, a, b);
                assert_eq!(relation.holds(a.cmp(&b)), holds, "{a} {} {b}", relation.rust());
                assert_eq!(relation.mirrored().holds(b.cmp(&a)), holds, "{b}, {a} exchanged: {}", relation.rust());
                assert_eq!(relation.mirrored().holds((-a).cmp(&-b)), holds, "negatives: {}", relation.rust());
                assert_ne!(relation.negated().holds(a.cmp(&b)), holds, "not {a} {} {b}", relation.rust());
            }
        }
    }

    #[test]
    fn below_and_above_are_two_each() {
        let count = |is: fn(Relation) -> bool| Relation::ALL.into_iter().filter(|relation| is(*relation)).count();
        assert_eq!((count(Relation::is_below), count(Relation::is_above)), (2, 2));
        for relation in Relation::ALL {
            let [below, above] = [Ordering::Less, Ordering::Greater].map(|order| relation.holds(order));
            assert_eq!(relation.is_below(), below && !above);
            assert_eq!(relation.is_above(), above && !below);
        }
    }

    #[test]
    fn every_language_tells_all_six() {
        for symbol in [Relation::rust, Relation::maxima, Relation::latex] {
            let differ = |a: &Relation, b: &Relation| a == b || symbol(*a) != symbol(*b);
            assert!(Relation::ALL.iter().all(|a| Relation::ALL.iter().all(|b| differ(a, b))));
        }
        assert_eq!(Relation::ALL.map(Relation::maxima), ["<", "<=", ">", ">=", "=", "#"]);
        assert_eq!(Relation::ALL.map(Relation::latex), ["<", r"\leq ", ">", r"\geq ", "=", r"\neq "]);
    }
}
