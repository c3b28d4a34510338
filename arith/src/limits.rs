//! Limits: how large a kernel may be.

/// The largest number of inputs: errors at run time carry the values of all of them in a fixed array.
pub const MAX_INPUTS: usize = 64;

/// The largest degree of a polynomial whose positive root is taken: its coefficients are kept in a fixed array.
pub const MAX_DEGREE: usize = 32;

/// How many brackets, prefix operators and keywords may stand inside each other.
pub const MAX_NESTING: usize = 256;

/// How high the tree of an expression may be: mostly, how many terms a sum may have.
pub const MAX_HEIGHT: usize = 1024;

/// How many steps a kernel may have: the compiler recurses into them.
pub const MAX_STEPS: usize = 1024;

/// The most factors of a term of a compensated expression: exact products are kept in a fixed array.
pub const MAX_FACTORS: usize = 16;

/// The most terms of a compensated expression: exact sums leave room for so many carries.
pub const MAX_TERMS: usize = 1 << 14;

/// The most operands of a compensated expression: terms number them by bytes.
pub const MAX_OPERANDS: usize = 255;

/// How many numbers the [factored form](crate::factored) of a compensated expression may keep at once: they stand in a fixed
/// array.
pub const MAX_STACK: usize = 8;

/// How many registers a [table](crate::table) may have: they stand in a fixed array.
pub const MAX_REGISTERS: usize = 64;

/// How many conditions a [table](crate::table) may hold at once: they stand in a fixed array.
pub const MAX_HELD: usize = 16;
