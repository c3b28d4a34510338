//! The format of tables: instructions over numbered registers.

use crate::function::Function;
use crate::relation::Relation;

/// The program of a kernel: its instructions, and what they need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table<'a> {
    /// What is done, one after another: the conditions of the domain, the steps, the results.
    pub instructions: &'a [Instruction],
    /// The numbers that instructions name by position.
    pub numbers: &'a [f64],
    /// The compensated expressions that instructions name by position.
    pub sums: &'a [Sum<'a>],
    /// How many conditions the domain has.
    pub conditions: usize,
    /// How many registers there are, [`MAX_REGISTERS`](crate::limits::MAX_REGISTERS) at most.
    pub registers: usize,
}

/// The exact form of a compensated expression: a sum of products.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sum<'a> {
    /// Where its operands are.
    pub operands: &'a [Source],
    /// Its [terms](crate::Terms) in their compact form.
    pub terms: &'a [u8],
}

/// Where an operand is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// In a register.
    Register(u8),
    /// Among the numbers.
    Literal(u16),
}

/// An instruction. The first register named is the one that takes the value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instruction {
    /// An input, by position.
    Input(u8, u8),
    /// A number, by position.
    Number(u8, u16),
    /// The circle constant.
    Pi(u8),
    /// What another register holds.
    Copy(u8, u8),
    /// The negative.
    Negate(u8, u8),
    /// A function's value.
    Call(u8, u8, Function),
    /// A sum.
    Add(u8, u8, u8),
    /// A difference.
    Subtract(u8, u8, u8),
    /// A product.
    Multiply(u8, u8, u8),
    /// A quotient.
    Divide(u8, u8, u8),
    /// The larger one.
    Larger(u8, u8, u8),
    /// The smaller one.
    Smaller(u8, u8, u8),
    /// The positive root of a polynomial, whose coefficients are in registers one after another: the first, and how many.
    PositiveRoot(u8, u8, u8),
    /// Where the sign of what the register holds is open: the same as an exact sum, by position.
    Exactly(u8, u16),
    /// Puts a comparison on the stack of conditions.
    Compare(Relation, u8, u8),
    /// Puts there whether both of the topmost two hold.
    And,
    /// Puts there whether one of the topmost two holds.
    Or,
    /// Puts there whether the topmost does not hold.
    Not,
    /// Takes the topmost as the next condition of the domain.
    Require,
    /// Takes the topmost, and goes on at another instruction unless it holds.
    Unless(u16),
    /// Goes on at another instruction.
    Jump(u16),
    /// Returns the next result.
    Return(u8),
}

const _: () = assert!(size_of::<Instruction>() == 4, "tables are compact");
