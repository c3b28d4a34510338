//! What is known of kernels, as C structs.

use core::ffi::{c_char, c_uint};

/// A pointer to what never changes.
#[repr(transparent)]
pub struct Constant<T>(pub *const T);

// SAFETY: it is made of statics without inner mutability only, in this crate alone, so that all threads may read what it
// points to at any time.
unsafe impl<T: Sync> Sync for Constant<T> {}

/// A text of C: letters in UTF-8 and a zero.
pub type Words = Constant<c_char>;

/// An input.
#[repr(C)]
pub struct Input {
    pub name: Words,
    pub worksheet: Words,
    pub unit: Words,
    pub typical_least: f64,
    pub typical_most: f64,
}

/// A result.
#[repr(C)]
pub struct ResultInfo {
    pub name: Words,
    pub worksheet: Words,
    pub unit: Words,
    /// NaN where none is proved.
    pub bound_ulp: f64,
}

/// A kernel.
#[repr(C)]
pub struct Info {
    pub name: Words,
    pub summary: Words,
    pub maxima: Words,
    pub latex: Words,
    pub source: Words,
    pub precision: Words,
    pub inputs: Constant<Input>,
    pub input_count: usize,
    pub domain: Constant<Words>,
    pub domain_count: usize,
    pub results: Constant<ResultInfo>,
    pub result_count: usize,
    pub ordinary: c_uint,
}
