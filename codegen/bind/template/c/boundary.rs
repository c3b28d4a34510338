//! The boundary between C and the kernels: what C hands over is checked here, and nowhere else.
//!
//! What no library can check is the caller's part: that a pointer which is not null points to as many numbers, or letters,
//! as its length says, that they live as long as the call, and that no other thread writes to them meanwhile.

use core::ffi::{c_char, c_int};
use core::fmt::{self, Display, Write};
use core::slice;

/// What a call says: one of the numbers below.
pub type Status = c_int;

/// Every result is as good as its bound.
pub const OK: Status = 0;
/// The inputs lie outside the domain of the kernel.
pub const OUTSIDE_DOMAIN: Status = 1;
/// `f64` cannot hold a result.
pub const OUT_OF_RANGE: Status = 2;
/// Arrays are not of one length, or longer than memory.
pub const LENGTH: Status = 3;
/// A pointer is null.
pub const NULL: Status = 4;
/// A pointer is no multiple of the size that numbers are aligned to.
pub const MISALIGNED: Status = 5;
/// An array of results shares memory with another array.
pub const OVERLAP: Status = 6;

/// Numbers to be read.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct View {
    data: *const f64,
    length: usize,
}

/// Numbers to be written.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Span {
    data: *mut f64,
    length: usize,
}

/// Room for a text that the caller reads.
pub struct Text {
    start: *mut c_char,
    /// How many bytes are left for letters; one more is kept for the end.
    room: usize,
    used: usize,
}

impl Text {
    /// An empty text in `size` bytes at `start`; none where that is null or nothing.
    ///
    /// # Safety
    ///
    /// If `start` is not null, `size` bytes there can be written as long as the text lives.
    pub unsafe fn new(start: *mut c_char, size: usize) -> Self {
        let mut text = Text { start, room: if start.is_null() { 0 } else { size.saturating_sub(1) }, used: 0 };
        if !start.is_null() && size > 0 {
            text.put(0, 0);
        }
        text
    }

    fn put(&mut self, at: usize, byte: u8) {
        // SAFETY: `start` is not null, since `room` is 0 otherwise and `new` asks; `at` is at most `room`, which is less
        // than the size that the caller promised in `new`.
        unsafe { self.start.add(at).write(byte as c_char) }
    }

    /// Writes `said`, as much of it as there is room for, and returns the status.
    pub fn say(mut self, status: Status, said: impl Display) -> Status {
        // the only error is that the room is full
        _ = write!(self, "{said}");
        status
    }
}

impl Write for Text {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for letter in text.chars() {
            let mut bytes = [0; 4];
            let bytes = letter.encode_utf8(&mut bytes).as_bytes();
            if bytes.len() > self.room - self.used {
                self.room = self.used;
                return Err(fmt::Error);
            }
            for byte in bytes {
                self.put(self.used, *byte);
                self.used += 1;
            }
            self.put(self.used, 0);
        }
        Ok(())
    }
}

/// What is wrong with a pointer to one value.
pub fn wrong_pointer<T>(pointer: *const T) -> Option<(Status, &'static str)> {
    if pointer.is_null() {
        Some((NULL, "is a null pointer"))
    } else if !pointer.is_aligned() {
        Some((MISALIGNED, "is a pointer that is not aligned as its type demands"))
    } else {
        None
    }
}

/// What is wrong with an array by itself.
fn wrong_array(data: *const f64, length: usize) -> Option<(Status, &'static str)> {
    if length == 0 {
        return None;
    }
    let whole = length.checked_mul(size_of::<f64>()).filter(|bytes| isize::try_from(*bytes).is_ok());
    let fits = whole.is_some_and(|bytes| data.addr().checked_add(bytes).is_some());
    wrong_pointer(data).or((!fits).then_some((LENGTH, "is longer than memory")))
}

/// Whether two arrays, which are not longer than memory, share any of it.
fn share(one: (*const f64, usize), other: (*const f64, usize)) -> bool {
    let ends = |(data, length): (*const f64, usize)| (data.addr(), data.addr() + length * size_of::<f64>());
    let ((one, one_end), (other, other_end)) = (ends(one), ends(other));
    one < other_end && other < one_end
}

/// The first array with a fault, its fault, and of two that share memory the second one.
fn fault<const N: usize, const M: usize>(
    inputs: &[View; N],
    results: &[Span; M],
) -> Option<(usize, Status, &'static str, Option<usize>)> {
    let array = |at: usize| match at.checked_sub(N) {
        None => (inputs[at].data, inputs[at].length),
        Some(result) => (results[result].data.cast_const(), results[result].length),
    };
    for at in 0..N + M {
        let (data, length) = array(at);
        if let Some((status, what)) = wrong_array(data, length) {
            return Some((at, status, what, None));
        }
    }
    for at in N..N + M {
        if let Some(other) = (0..at).find(|other| share(array(*other), array(at))) {
            return Some((at, OVERLAP, "shares memory with", Some(other)));
        }
    }
    None
}

/// Calls `batch` with the arrays as slices, if they are arrays that nothing else writes to. `names` has those of the inputs,
/// then those of the results.
///
/// # Safety
///
/// Every array that is not null has as many numbers as it says; they live, and nobody else writes to them, during the call.
pub unsafe fn batch<const N: usize, const M: usize, E: Display>(
    kernel: &str,
    names: &[&str],
    inputs: [View; N],
    results: [Span; M],
    text: Text,
    batch: impl FnOnce([&[f64]; N], [&mut [f64]; M]) -> Result<(), E>,
) -> Status {
    if let Some((at, status, what, other)) = fault(&inputs, &results) {
        return match other {
            None => text.say(status, format_args!("{kernel}: `{}` {what}", names[at])),
            Some(other) => text.say(status, format_args!("{kernel}: `{}` {what} `{}`", names[at], names[other])),
        };
    }
    let inputs = inputs.map(|View { data, length }| {
        // SAFETY: not null, aligned and not longer than memory, by `fault`; the numbers are there, by the caller. A slice of
        // nothing needs no memory.
        if length == 0 { &[][..] } else { unsafe { slice::from_raw_parts(data, length) } }
    });
    let results = results.map(|Span { data, length }| {
        // SAFETY: as above; and it shares no memory with any other array, by `fault`.
        if length == 0 { &mut [][..] } else { unsafe { slice::from_raw_parts_mut(data, length) } }
    });
    match batch(inputs, results) {
        Ok(()) => OK,
        Err(error) => text.say(LENGTH, error),
    }
}

/// Writes what a checked call returned, or says why there is nothing to write; `condition` tells that the inputs lie outside
/// the domain.
///
/// # Safety
///
/// `result`, if it is not null, points to a value that can be written during the call.
pub unsafe fn checked<T, E: Display>(
    kernel: &str,
    result: *mut T,
    text: Text,
    call: impl FnOnce() -> Result<T, E>,
    is_outside: impl FnOnce(&E) -> bool,
) -> Status {
    if let Some((status, what)) = wrong_pointer(result) {
        return text.say(status, format_args!("{kernel}: `result` {what}"));
    }
    match call() {
        Ok(value) => {
            // SAFETY: not null and aligned, as was just asked; writable, by the caller.
            unsafe { result.write(value) };
            OK
        }
        Err(error) if is_outside(&error) => text.say(OUTSIDE_DOMAIN, error),
        Err(error) => text.say(OUT_OF_RANGE, error),
    }
}
