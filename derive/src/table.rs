//! The constant `TABLE`: the program as data, which one interpreter runs for all kernels.
//!
//! It is emitted as `arith/src/table/mod.rs` declares it, an instruction an entry, so that expansions can be read:
//! `Add(2, 0, 1)` puts the sum of the registers 0 and 1 into register 2.

use closedform_syntax::{Kernel, LoweredSum, lowered};
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

/// `TABLE` of a kernel, as an expression.
pub fn table(kernel: &Kernel) -> TokenStream {
    let Some(table) = lowered(kernel) else { return quote!(::core::option::Option::None) };
    let instructions = table.instructions.iter().map(variant);
    let (numbers, sums) = (&table.numbers, table.sums.iter().map(sum));
    let (conditions, registers) = (table.conditions, table.registers);
    quote! {{
        use ::closedform::__private::{Function::*, Instruction::*, Relation::*, Source::*};
        ::core::option::Option::Some(&::closedform::__private::Table {
            instructions: &[#(#instructions),*],
            numbers: &[#(#numbers),*],
            sums: &[#(#sums),*],
            conditions: #conditions,
            registers: #registers,
        })
    }}
}

fn sum(LoweredSum { operands, terms }: &LoweredSum) -> TokenStream {
    let (operands, terms) = (operands.iter().map(variant), Literal::byte_string(terms));
    quote!(::closedform::__private::Sum { operands: &[#(#operands),*], terms: #terms })
}

/// A variant as it prints itself: its name, and its numbers and the names of other variants in parentheses.
fn variant(variant: &impl core::fmt::Debug) -> TokenStream {
    let text = format!("{variant:?}");
    text.parse().unwrap_or_else(|_| text.to_token_stream())
}
