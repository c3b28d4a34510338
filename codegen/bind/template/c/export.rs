//! The macros that make C functions of kernels: all that is exported stands here once.
//!
//! Every `no_mangle` below needs `unsafe` because two functions of one name in a program would be taken for each other. The
//! generator refuses names that occur twice, and each begins with the name of the crate of the kernels.

/// The struct that a kernel of several results returns in C.
#[allow(unused_macros, reason = "every kernel may return a number")]
macro_rules! returned {
    ($name:ident from $rust:path { $($field:ident),* }) => {
        #[repr(C)]
        pub struct $name {
            $($field: f64),*
        }

        impl From<$rust> for $name {
            fn from(value: $rust) -> Self {
                $name { $($field: value.$field),* }
            }
        }
    };
}

/// The C functions of a kernel: default call, faithful call, checked call, batch, and what is known of it.
macro_rules! export {
    (
        $name:literal at $position:literal is $path:path;
        ($($input:ident),*) -> $returned:ty, [$($result:ident),*];
        $call:ident $faithful:ident $checked:ident $batch:ident $info:ident
    ) => {
        const _: () = {
            use $path as kernel;

            #[unsafe(no_mangle)]
            extern "C" fn $call($($input: f64),*) -> $returned {
                kernel($($input),*).into()
            }

            #[unsafe(no_mangle)]
            extern "C" fn $faithful($($input: f64),*) -> $returned {
                kernel::faithful($($input),*).into()
            }

            #[unsafe(no_mangle)]
            unsafe extern "C" fn $checked(
                $($input: f64,)*
                result: *mut $returned,
                text: *mut c_char,
                size: usize,
            ) -> Status {
                let call = || kernel::checked($($input),*).map(<$returned>::from);
                // SAFETY: the header asks the caller for room of `size` bytes at `text`, if that is not null.
                let text = unsafe { Text::new(text, size) };
                // SAFETY: the header asks the caller for a result that can be written, if the pointer is not null.
                unsafe { boundary::checked($name, result, text, call, |error| error.condition().is_some()) }
            }

            #[unsafe(no_mangle)]
            unsafe extern "C" fn $batch(
                $($input: View,)*
                $($result: Span,)*
                text: *mut c_char,
                size: usize,
            ) -> Status {
                let names = [$(stringify!($input),)* $(stringify!($result)),*];
                let call = |[$($input),*]: [&[f64]; _], [$($result),*]: [&mut [f64]; _]| {
                    kernel::batch($($input,)* $($result),*)
                };
                // SAFETY: the header asks the caller for room of `size` bytes at `text`, if that is not null.
                let text = unsafe { Text::new(text, size) };
                // SAFETY: the header asks the caller for arrays of these lengths that nobody else writes to.
                unsafe { boundary::batch($name, &names, [$($input),*], [$($result),*], text, call) }
            }

            #[unsafe(no_mangle)]
            extern "C" fn $info() -> &'static Info {
                &ABOUT[$position]
            }
        };
    };
}
