//! The program: steps, results and domain as Rust, generic in the arithmetic `R: Real`.
//!
//! In the emitted code every name is a `&R`. All shapes run this one program, so they cannot disagree.

use closedform_syntax::{
    BinaryOp, Comparison, Condition, Expr, Kernel, Let, Slice, SliceArithmetic, fold_compensated, fold_residual,
};
use proc_macro2::{Ident, Literal, Span, TokenStream};
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
        Expr::Compensated(slice) => fold_compensated(&Emitted, slice, &borrowed),
        Expr::Residual(slice) => fold_residual(&Emitted, slice, &borrowed),
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
        Expr::Sqrt(inner) => real("sqrt", &[borrowed(inner)]),
        Expr::Abs(inner) => real("abs", &[borrowed(inner)]),
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
            let (left, op, right) = (borrowed(left), comparison(*op), borrowed(right));
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

fn comparison(op: Comparison) -> TokenStream {
    match op {
        Comparison::Less => quote!(<),
        Comparison::LessEqual => quote!(<=),
        Comparison::Greater => quote!(>),
        Comparison::GreaterEqual => quote!(>=),
        Comparison::Equal => quote!(==),
        Comparison::NotEqual => quote!(!=),
    }
}

/// Slices as emitted code: values are expressions of type `&R`, wide ones of type `R::Wide`.
struct Emitted;

impl SliceArithmetic for Emitted {
    type Value = TokenStream;
    type Wide = TokenStream;

    fn neg(&self, a: &TokenStream) -> TokenStream {
        let value = real("neg", &[quote!(#a)]);
        quote!(&#value)
    }

    fn two_sum(&self, a: &TokenStream, b: &TokenStream) -> TokenStream {
        real("two_sum", &[quote!(#a), quote!(#b)])
    }

    fn two_product(&self, a: &TokenStream, b: &TokenStream) -> TokenStream {
        real("two_product", &[quote!(#a), quote!(#b)])
    }

    fn wide_neg(&self, a: &TokenStream) -> TokenStream {
        real("wide_neg", &[quote!(&#a)])
    }

    fn wide_add_exact(&self, a: &TokenStream, b: &TokenStream) -> TokenStream {
        real("wide_add_exact", &[quote!(&#a), quote!(#b)])
    }

    fn wide_add(&self, a: &TokenStream, b: &TokenStream) -> TokenStream {
        real("wide_add", &[quote!(&#a), quote!(&#b)])
    }

    fn wide_mul_exact(&self, a: &TokenStream, b: &TokenStream) -> TokenStream {
        real("wide_mul_exact", &[quote!(&#a), quote!(#b)])
    }

    fn wide_mul(&self, a: &TokenStream, b: &TokenStream) -> TokenStream {
        real("wide_mul", &[quote!(&#a), quote!(&#b)])
    }

    fn compensated(&self, a: &TokenStream, slice: &Slice, operands: &[TokenStream]) -> TokenStream {
        let (threshold, terms) = (slice.threshold, Literal::byte_string(&slice.terms));
        let value = real("compensated", &[quote!(&#a), quote!(#threshold), quote!(&[#(#operands),*]), quote!(#terms)]);
        quote!(&#value)
    }

    fn residual(&self, a: &TokenStream) -> TokenStream {
        let value = real("residual", &[quote!(&#a)]);
        quote!(&#value)
    }
}
