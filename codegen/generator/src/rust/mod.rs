//! Rust source: prints programs as kernels; decides nothing.

mod docs;
mod expression;
mod formula;
mod kernel_text;
mod module;

pub use expression::Printer;
pub use kernel_text::{ExampleText, InputDoc, KernelText, RequireText, ResultText, RuleText};
pub use module::{ModuleText, print_module};
