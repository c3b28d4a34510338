//! Names that generated Rust can carry.

use closedform_syntax::Function;
use thiserror::Error;

/// Every keyword of edition 2024, strict and reserved.
const KEYWORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod",
    "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static", "struct", "super", "trait", "true",
    "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Names that mean something in the kernel language, besides functions of the table, in what `#[kernel]` makes of it, or to every Rust program.
const TAKEN: &[&str] = &[
    "alloc",
    "batch",
    "bool",
    "char",
    "checked",
    "closedform",
    "compensated",
    "core",
    "evaluate",
    "f128",
    "f16",
    "f32",
    "f64",
    "faithful",
    "fast",
    "fast_batch",
    "i128",
    "i16",
    "i32",
    "i64",
    "i8",
    "isize",
    "kernel",
    "max",
    "min",
    "positive_root",
    "require",
    "residual",
    "std",
    "str",
    "u128",
    "u16",
    "u32",
    "u64",
    "u8",
    "usize",
    "with_bound",
];

/// Type names that generated code or its users already have.
const TAKEN_TYPES: &[&str] = &[
    "Clone",
    "Copy",
    "Debug",
    "DomainError",
    "Err",
    "Info",
    "Kernel",
    "None",
    "Ok",
    "Option",
    "Real",
    "Result",
    "Self",
    "Some",
];

/// Modules that a crate, cargo or the generator has already.
const TAKEN_MODULES: &[&str] = &["generated", "judges", "lib", "main", "proc_macro", "test"];

/// The longest name of a module.
const LONGEST_MODULE: usize = 64;

/// Why a name cannot be used in generated Rust.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RustNameError {
    /// Not `snake_case`.
    #[error("is not a snake_case name")]
    NotSnakeCase,
    /// A keyword.
    #[error("is a Rust keyword")]
    Keyword,
    /// Would clash with what is generated beside it.
    #[error("clashes with a name that the generated code uses")]
    Taken,
    /// Not `UpperCamelCase`.
    #[error("is not an UpperCamelCase name")]
    NotCamelCase,
}

/// Checks the name of a family, kernel, input or field.
pub fn rust_name(name: &str) -> Result<(), RustNameError> {
    if !is_snake_case(name) {
        Err(RustNameError::NotSnakeCase)
    } else if KEYWORDS.contains(&name) {
        Err(RustNameError::Keyword)
    } else if TAKEN.contains(&name) || Function::named(name).is_some() {
        Err(RustNameError::Taken)
    } else {
        Ok(())
    }
}

/// Checks the name of a family, which becomes a module and a file.
pub fn module_name(name: &str) -> Result<(), RustNameError> {
    rust_name(name)?;
    if TAKEN_MODULES.contains(&name) || is_device(name) || name.len() > LONGEST_MODULE {
        return Err(RustNameError::Taken);
    }
    Ok(())
}

/// Whether Rust takes the word for itself.
#[must_use]
pub fn is_keyword(word: &str) -> bool {
    KEYWORDS.contains(&word)
}

/// Whether Windows takes a file of this name, in any letters, for a device.
#[must_use]
pub fn is_device(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    let port = |kind: &str| matches!(name.strip_prefix(kind).map(str::as_bytes), Some([b'0'..=b'9']));
    ["con", "prn", "aux", "nul"].contains(&name.as_str()) || port("com") || port("lpt")
}

/// A module's name for the stem of a worksheet.
#[must_use]
pub fn free_module_name(stem: &str) -> String {
    let short: String = snake_case(stem).chars().take(LONGEST_MODULE - "_value".len()).collect();
    free_name(&short, |name| module_name(name).is_ok())
}

/// A module's name for the stem of a worksheet where others are taken.
#[must_use]
pub fn free_module_name_beside(stem: &str, is_taken: impl Fn(&str) -> bool) -> String {
    let name = free_module_name(stem);
    let others = (2_u64..).map(|number| format!("{name}_{number}"));
    std::iter::once(name.clone()).chain(others).find(|name| !is_taken(name)).unwrap_or(name)
}

/// A Rust name for a Maxima name: the snake_case one, or one made of it that is free.
#[must_use]
pub fn free_name(maxima: &str, is_free: impl Fn(&str) -> bool) -> String {
    let ascii: String = snake_case(maxima).chars().filter(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
    let words: Vec<&str> = ascii.split('_').filter(|word| !word.is_empty()).collect();
    let letters = words.join("_");
    let plain = if letters.starts_with(|c: char| c.is_ascii_lowercase()) { letters } else { format!("x{letters}") };
    let others = std::iter::once(format!("{plain}_value")).chain((2_u64..).map(|number| format!("{plain}_{number}")));
    std::iter::once(plain.clone()).chain(others).find(|name| is_free(name)).unwrap_or(plain)
}

/// The name of a struct for the results of a kernel, which is taken from then on.
#[must_use]
pub fn free_type_name(kernel: &str, taken: &mut std::collections::BTreeSet<String>) -> String {
    let plain = camel_case(kernel);
    let others = (2_u64..).map(|number| format!("{plain}{number}"));
    let name = std::iter::once(plain.clone()).chain([format!("{plain}Values")]).chain(others);
    let mut free = name.filter(|name| type_name(name).is_ok() && !taken.contains(name));
    let name = free.next().unwrap_or(plain);
    taken.insert(name.clone());
    name
}

/// Checks the name of a struct.
pub(super) fn type_name(name: &str) -> Result<(), RustNameError> {
    if !is_camel_case(name) {
        Err(RustNameError::NotCamelCase)
    } else if TAKEN_TYPES.contains(&name) {
        Err(RustNameError::Taken)
    } else {
        Ok(())
    }
}

/// The snake_case name of a Maxima name: `tOut` is `t_out`, `a2Max` is `a2_max`, `T2` is `t2`.
pub fn snake_case(maxima: &str) -> String {
    let mut name = String::new();
    let mut previous = '_';
    for c in maxima.chars() {
        let starts_word = c.is_uppercase() && (previous.is_lowercase() || previous.is_numeric());
        if (starts_word || !c.is_alphanumeric()) && previous != '_' {
            name.push('_');
        }
        if c.is_alphanumeric() {
            name.extend(c.to_lowercase());
        }
        previous = if c.is_alphanumeric() { c } else { '_' };
    }
    name.trim_matches('_').to_owned()
}

fn is_snake_case(name: &str) -> bool {
    let words_filled = name.split('_').all(|word| !word.is_empty());
    let starts_with_letter = name.starts_with(|c: char| c.is_ascii_lowercase());
    words_filled && starts_with_letter && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
}

/// `TIn` for `t_in`.
pub(super) fn camel_case(name: &str) -> String {
    let capital = |word: &str| word[..1].to_uppercase() + &word[1..];
    name.split('_').filter(|word| !word.is_empty() && word.is_ascii()).map(capital).collect()
}

fn is_camel_case(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_uppercase()) && name.chars().all(|c| c.is_ascii_alphanumeric())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_and_generated_names_are_refused() {
        assert_eq!(rust_name("gen"), Err(RustNameError::Keyword));
        assert_eq!(rust_name("batch"), Err(RustNameError::Taken));
        assert_eq!(rust_name("f64"), Err(RustNameError::Taken));
        for name in ["", "_", "_a", "a_", "a__b", "2a", "tOut", "é"] {
            assert_eq!(rust_name(name), Err(RustNameError::NotSnakeCase), "{name}");
        }
        for name in ["t_out", "a2_max", "v0", "x"] {
            assert_eq!(rust_name(name), Ok(()), "{name}");
        }
        assert_eq!(type_name("ramp"), Err(RustNameError::NotCamelCase));
        assert_eq!(type_name("Self"), Err(RustNameError::Taken));
        assert_eq!(type_name("Ramp2"), Ok(()));
    }

    #[test]
    fn worksheets_of_any_name_have_a_module() {
        let pairs = [
            ("my", "my"),
            ("lib", "lib_value"),
            ("main", "main_value"),
            ("judges", "judges_value"),
            ("core", "core_value"),
            ("fn", "fn_value"),
            ("self", "self_value"),
            ("con", "con_value"),
            ("LPT1", "lpt1_value"),
            ("my sheet", "my_sheet"),
            ("a-b.c", "a_b_c"),
            ("1digit", "x1digit"),
            ("\u{dc}n\u{ef}", "n"),
            ("\u{65e5}\u{672c}", "x"),
            ("closedform", "closedform_value"),
        ];
        for (stem, module) in pairs {
            assert_eq!(free_module_name(stem), module, "{stem}");
        }
        let beside = |stem: &str, taken: &[&str]| free_module_name_beside(stem, |name| taken.contains(&name));
        assert_eq!(beside("a b", &["a_b", "a_b_2"]), "a_b_3");
        assert_eq!(beside("fn", &["fn"]), "fn_value");
        for stem in ["a".repeat(250), "aB".repeat(120), "1_".repeat(100), "\u{e9}_".repeat(60)] {
            assert_eq!(module_name(&beside(&stem, &[&free_module_name(&stem)])), Ok(()), "{stem}");
            assert_eq!(module_name(&free_module_name(&stem)), Ok(()), "{stem}");
        }
    }

    #[test]
    fn maxima_names_become_snake_case() {
        let pairs = [
            ("tOut", "t_out"),
            ("a2Max", "a2_max"),
            ("T2", "t2"),
            ("s_t1_1", "s_t1_1"),
            ("T_", "t"),
            ("aMAX", "a_max"),
            ("%pi2", "pi2"),
        ];
        for (maxima, rust) in pairs {
            assert_eq!(snake_case(maxima), rust);
        }
    }
}
