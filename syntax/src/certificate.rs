//! Certificates: the hash by which a stated bound shows that it was proved of this kernel, by today's rules.
//!
//! `closedform-bounds` proves a bound; too heavy for a macro, which therefore compares a hash of what was proved. It is
//! no secret and no signature: it guards against bounds that are made up or left behind by a change, not against who
//! computes it without a proof.

use std::fmt::Write as _;
use syn::{Error, Result};

use crate::error;
use crate::kernel::{Certificate, Kernel, Output};
use crate::print::{condition_text, expression_text};

/// The version of the rules by which `closedform-bounds` proves. Raise it when a rule changes so that a bound which was
/// proved before may not be any more: every certificate then asks for a new proof.
pub const RULES: u32 = 1;

/// The certificate of a kernel's stated bounds, to be handed out to proved ones only.
pub fn certificate(kernel: &Kernel) -> String {
    format!("{RULES}-{:016x}", fnv_1a(&canonical(kernel)))
}

/// That a kernel which states bounds carries their certificate.
///
/// # Errors
///
/// At the bound or at the certificate, with what to do.
pub fn certified(kernel: &Kernel) -> Result<()> {
    match (kernel.meta.bound_place, &kernel.meta.certificate) {
        (None, None) => Ok(()),
        (Some(place), None) => Err(Error::new(place, error::UNCERTIFIED)),
        (None, Some(alone)) => Err(Error::new(alone.place, error::CERTIFICATE_ALONE)),
        (Some(_), Some(written)) => compare(written, &certificate(kernel)),
    }
}

fn compare(written: &Certificate, right: &str) -> Result<()> {
    let message = match rules_of(&written.text) {
        None => error::CERTIFICATE,
        Some(RULES) if written.text == right => return Ok(()),
        Some(RULES) => error::CERTIFICATE_STALE,
        Some(_) => error::CERTIFICATE_RULES,
    };
    Err(Error::new(written.place, message))
}

/// The version of the rules that issued a certificate.
fn rules_of(certificate: &str) -> Option<u32> {
    let (rules, hash) = certificate.split_once('-')?;
    let is_hash = hash.len() == 16 && hash.bytes().all(|digit| digit.is_ascii_hexdigit());
    rules.parse().ok().filter(|_| is_hash)
}

/// Everything that a proof reads and what it proves: no comments, no formatting, no documentation.
fn canonical(kernel: &Kernel) -> String {
    let mut text = format!("precision {}\n", kernel.meta.precision.name());
    for input in &kernel.inputs {
        let _ = writeln!(text, "input {}", input.name);
    }
    for require in &kernel.requires {
        let _ = writeln!(text, "require {}", condition_text(&require.condition));
    }
    for step in &kernel.lets {
        let _ = writeln!(text, "let {} = {}", step.name, expression_text(&step.value));
    }
    for (value, meta) in kernel.output.values().zip(&kernel.meta.results) {
        // the name of a kernel that returns a number is no part of what is proved
        let field = if matches!(kernel.output, Output::Value(_)) { String::new() } else { meta.name.to_string() };
        let _ = writeln!(text, "result {field} = {} within {:?}", expression_text(value), meta.bound);
    }
    text
}

/// FNV-1a in 64 bits.
#[must_use]
pub fn fnv_1a(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The published values of the hash.
    #[test]
    fn the_hash_is_fnv_1a() {
        assert_eq!(fnv_1a(""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv_1a("a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv_1a("foobar"), 0x8594_4171_f739_67e8);
    }
}
