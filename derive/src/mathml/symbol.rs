//! Commands of LaTeX that are one letter, operator or word.

/// A command as a tag; `None` if it is none of these.
pub fn symbol(command: &str) -> Option<String> {
    let found = |table: &[(&str, &'static str)]| table.iter().find(|(name, _)| *name == command).map(|(_, sign)| *sign);
    if let Some(letter) = found(&LETTERS) {
        return Some(format!("<mi>{letter}</mi>"));
    }
    if let Some(operator) = found(&OPERATORS) {
        return Some(format!("<mo>{operator}</mo>"));
    }
    if let Some(width) = found(&SPACES) {
        return Some(format!("<mspace width=\"{width}\"/>"));
    }
    FUNCTIONS.contains(&command).then(|| format!("<mi>{command}</mi>"))
}

/// A letter of a page, as its text.
pub fn escaped(letter: char) -> String {
    match letter {
        '<' => "&lt;".into(),
        '>' => "&gt;".into(),
        '&' => "&amp;".into(),
        '"' => "&quot;".into(),
        other => other.into(),
    }
}

const LETTERS: [(&str, &str); 42] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ϵ"),
    ("varepsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "ϕ"),
    ("varphi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Upsilon", "Υ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
    ("infty", "∞"),
    ("backslash", "\\"),
    ("%", "%"),
    ("_", "_"),
    ("#", "#"),
    ("$", "$"),
];

const OPERATORS: [(&str, &str); 18] = [
    ("cdot", "⋅"),
    ("times", "×"),
    ("pm", "±"),
    ("le", "≤"),
    ("leq", "≤"),
    ("ge", "≥"),
    ("geq", "≥"),
    ("ne", "≠"),
    ("neq", "≠"),
    ("land", "∧"),
    ("lor", "∨"),
    ("lnot", "¬"),
    ("langle", "⟨"),
    ("rangle", "⟩"),
    ("&", "&amp;"),
    ("{", "{"),
    ("}", "}"),
    ("|", "‖"),
];

const SPACES: [(&str, &str); 5] = [(",", "0.17em"), (":", "0.22em"), (";", "0.28em"), (" ", "0.25em"), ("quad", "1em")];

const FUNCTIONS: [&str; 13] =
    ["sin", "cos", "tan", "sinh", "cosh", "tanh", "log", "ln", "exp", "min", "max", "cot", "sec"];
