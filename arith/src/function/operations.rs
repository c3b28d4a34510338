//! How many operations a program takes, functions of the table among them.

/// Declares the counts of operations, with a field for each function that counts.
macro_rules! operations {
    ($($field:ident: $function:ident,)*) => {
        /// How many operations one evaluation takes; signs, magnitudes, steps to integers, comparisons and choices are free, and both branches
        /// of an `if` count.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct Operations {
            /// Additions and subtractions.
            pub add: u32,
            /// Multiplications.
            pub mul: u32,
            /// Divisions.
            pub div: u32,
            $(#[doc = concat!("Calls of `", stringify!($field), "`.")] pub $field: u32,)*
            /// Additions and multiplications of pairs, inside `compensated!` and `residual!`.
            pub compensated: u32,
            /// Compensated expressions, each rounded once at its end.
            pub compensated_expressions: u32,
            /// Roots of polynomials, found by iteration.
            pub root: u32,
        }

        impl Operations {
            /// Counts a call.
            pub fn count(&mut self, function: Function) {
                match function {
                    $(Function::$function => self.$field += 1,)*
                    _ => {}
                }
            }

            /// The functions that count, and how often each is called.
            pub fn calls(&self) -> impl Iterator<Item = (Function, u32)> {
                [$((Function::$function, self.$field)),*].into_iter()
            }

            /// All counts but that of compensated expressions, whose operations count: the key, what one is called, and
            /// the number.
            pub fn named(&self) -> impl Iterator<Item = (&'static str, &'static str, u32)> {
                let Self { add, mul, div, compensated, root, .. } = *self;
                let calls = self.calls().map(|(function, count)| (function.name(), function.properties().noun, count));
                [("add", "addition", add), ("mul", "multiplication", mul), ("div", "division", div)]
                    .into_iter()
                    .chain(calls)
                    .chain([("compensated", "operation on pairs", compensated), ("root", "polynomial root", root)])
            }
        }
    };
}

pub(super) use operations;
