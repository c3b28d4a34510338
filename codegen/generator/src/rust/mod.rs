//! Rust source: prints programs as kernels; decides nothing.

mod expression;
mod module;

pub use expression::Printer;
pub use module::{InputDoc, KernelText, ModuleText, RequireText, ResultText, RuleText, print_module};
