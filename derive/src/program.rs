//! The program: steps, results and domain as Rust, generic in the arithmetic `R: Real`.
//!
//! In the emitted code every name is a `&R`. All shapes run this one program, so they cannot disagree.

use closedform_syntax::{
    BinaryOp, CompensatedExpr, Condition, Expr, Extended, Function, Kernel, Let, Operand, Operation, Part, Relation,
};
use proc_macro2::{Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::quote;

/// The body of `evaluate<R>(inputs: &[R; N]) -> [R; M]`.
pub fn evaluate(kernel: &Kernel) -> TokenStream {
    let unpacked = unpack(kernel);
    let steps = kernel.lets.iter().map(step);
    let results = kernel.output.values().map(owned);
    quote! {
        #unpacked
        #(#steps)*
        [#(#results),*]
    }
}

/// The body of `domain<R>(inputs: &[R; N]) -> [bool; K]`.
pub fn domain(kernel: &Kernel) -> TokenStream {
    let unpacked = unpack(kernel);
    let conditions = kernel.requires.iter().map(|require| condition(&require.condition));
    quote! {
        #unpacked
        [#(#conditions),*]
    }
}

/// The parameter that holds all inputs. Like `context` it is invisible to the user's names.
pub fn inputs() -> Ident {
    Ident::new("inputs", Span::mixed_site())
}

/// The number that literals take their precision from.
fn context() -> Ident {
    Ident::new("context", Span::mixed_site())
}

fn unpack(kernel: &Kernel) -> TokenStream {
    let (inputs, context) = (inputs(), context());
    let names = kernel.inputs.iter().map(|input| &input.name);
    quote! {
        let [#context, ..] = #inputs;
        let [#(#names),*] = #inputs;
    }
}

fn step(step: &Let) -> TokenStream {
    let (name, value) = (&step.name, borrowed(&step.value));
    quote!(let #name = #value;)
}

/// An expression of type `&R`.
fn borrowed(expr: &Expr) -> TokenStream {
    match expr {
        Expr::Name(name) => {
            let ident = &name.ident;
            quote!(#ident)
        }
        Expr::Compensated(expression) => compensated(expression),
        Expr::Residual(expression) => residual(expression),
        _ => {
            let value = owned(expr);
            quote!(&#value)
        }
    }
}

/// An expression of type `R`.
fn owned(expr: &Expr) -> TokenStream {
    match expr {
        Expr::Name(_) | Expr::Compensated(_) | Expr::Residual(_) => {
            let value = borrowed(expr);
            quote!(::core::clone::Clone::clone(#value))
        }
        Expr::Literal { value, .. } => literal(*value),
        Expr::Pi(_) => {
            let context = context();
            real("pi", &[quote!(#context)])
        }
        Expr::Neg(inner) => real("neg", &[borrowed(inner)]),
        Expr::Call(function, inner) => real("call", &[borrowed(inner), variant(*function)]),
        Expr::Binary { op, left, right } => real(method(*op), &[borrowed(left), borrowed(right)]),
        Expr::Extreme { largest, items } => extreme(*largest, items),
        Expr::If { condition: test, then, otherwise } => {
            let (test, then, otherwise) = (condition(test), owned(then), owned(otherwise));
            quote!(if #test { #then } else { #otherwise })
        }
        Expr::PositiveRoot(coefficients) => {
            let coefficients = coefficients.iter().map(owned);
            let context = context();
            real("positive_root", &[quote!(#context), quote!(&[#(#coefficients),*])])
        }
    }
}

/// The first of the largest, or smallest, ones: selections, which leave no branch in the way of vectorisation.
fn extreme(largest: bool, items: &[Expr]) -> TokenStream {
    let [best, next] = ["best", "next"].map(|name| Ident::new(name, Span::mixed_site()));
    let order = if largest { quote!(>) } else { quote!(<) };
    let mut values = items.iter().map(owned);
    let first = values.next();
    quote! {{
        let #best = #first;
        #(
            let #next = #values;
            let #best = if #next #order #best { #next } else { #best };
        )*
        #best
    }}
}

fn literal(value: f64) -> TokenStream {
    let context = context();
    real("literal", &[quote!(#context), quote!(#value)])
}

/// A call of a method of `Real`.
fn real(method: &str, arguments: &[TokenStream]) -> TokenStream {
    let method = Ident::new(method, Span::call_site());
    quote!(<R as ::closedform::Real>::#method(#(#arguments),*))
}

/// A function of the table, as a constant.
fn variant(function: Function) -> TokenStream {
    let name = Ident::new(&format!("{function:?}"), Span::call_site());
    quote!(::closedform::Function::#name)
}

fn method(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add => "add",
        BinaryOp::Sub => "sub",
        BinaryOp::Mul => "mul",
        BinaryOp::Div => "div",
    }
}

/// A condition. Operators that do not short-circuit leave no branch in the way of vectorisation.
fn condition(test: &Condition) -> TokenStream {
    match test {
        Condition::Compare { op, left, right } => {
            let (left, op, right) = (borrowed(left), operator(*op), borrowed(right));
            quote!((#left #op #right))
        }
        Condition::And(left, right) => {
            let (left, right) = (condition(left), condition(right));
            quote!((#left & #right))
        }
        Condition::Or(left, right) => {
            let (left, right) = (condition(left), condition(right));
            quote!((#left | #right))
        }
        Condition::Not(inner) => {
            let inner = condition(inner);
            quote!((!#inner))
        }
    }
}

/// The tokens of an operator of comparison: its letters, the last of them alone.
fn operator(relation: Relation) -> TokenStream {
    let letters = relation.rust().chars();
    let rest = letters.clone().skip(1).map(|_| Spacing::Joint).chain([Spacing::Alone]);
    letters.zip(rest).map(|(letter, spacing)| TokenTree::from(Punct::new(letter, spacing))).collect()
}

/// A `compensated!` expression, as an expression of type `&R`.
fn compensated(expression: &CompensatedExpr) -> TokenStream {
    match Part::of(&expression.value) {
        Part::Operand(operand) => exact(operand),
        Part::Extended(part) => {
            let (extended, operands) = (extended(part), expression.operands.iter().map(borrowed));
            let (threshold, terms) = (expression.threshold, Literal::byte_string(expression.compact_terms()));
            let factored = Literal::byte_string(expression.factored());
            let terms = quote!(::closedform::__private::Terms::of(#terms).written_as(#factored));
            let value =
                real("compensated", &[quote!(&#extended), quote!(#threshold), quote!(&[#(#operands),*]), terms]);
            quote!(&#value)
        }
    }
}

/// A `residual!` expression, as an expression of type `&R`.
fn residual(expression: &Expr) -> TokenStream {
    match Part::of(expression) {
        Part::Operand(operand) => exact(operand),
        Part::Extended(part) => {
            let extended = extended(part);
            let value = real("residual", &[quote!(&#extended)]);
            quote!(&#value)
        }
    }
}

/// An operand of a compensated expression, as an expression of type `&R`.
fn exact(operand: Operand) -> TokenStream {
    let value = borrowed(operand.leaf);
    if !operand.negative {
        return value;
    }
    let negative = real("neg", &[value]);
    quote!(&#negative)
}

/// A part of a compensated expression, as an expression of type `R::Extended`.
fn extended(part: Extended) -> TokenStream {
    let inner = |part: Extended| {
        let value = extended(part);
        quote!(&#value)
    };
    let value = match part.operation() {
        Operation::TwoSum(a, b) => real("two_sum", &[exact(a), exact(b)]),
        Operation::TwoProduct(a, b) => real("two_product", &[exact(a), exact(b)]),
        Operation::AddExact(a, b) => real("extended_add_exact", &[inner(a), exact(b)]),
        Operation::Add(a, b) => real("extended_add", &[inner(a), inner(b)]),
        Operation::MulExact(a, b) => real("extended_mul_exact", &[inner(a), exact(b)]),
        Operation::Mul(a, b) => real("extended_mul", &[inner(a), inner(b)]),
        Operation::ScaleOperand(a, b) => real("scaled", &[exact(a), exact(b)]),
        Operation::Scale(a, b) => real("extended_scaled", &[inner(a), exact(b)]),
    };
    if part.negative { real("extended_neg", &[quote!(&#value)]) } else { value }
}
