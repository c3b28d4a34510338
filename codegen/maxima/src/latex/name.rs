//! Names as LaTeX: `delta` to `\delta`, `tOut` to `t_{\mathrm{Out}}`, `a2Max` to `a_{2,\mathrm{Max}}`.

/// Greek letters that LaTeX has a command for, small ones and capitals.
const GREEK: [&str; 35] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "zeta",
    "eta",
    "theta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "pi",
    "rho",
    "sigma",
    "tau",
    "upsilon",
    "phi",
    "chi",
    "psi",
    "omega",
    "Gamma",
    "Delta",
    "Theta",
    "Lambda",
    "Xi",
    "Pi",
    "Sigma",
    "Upsilon",
    "Phi",
    "Psi",
    "Omega",
    "varepsilon",
];

/// The name as LaTeX: its first word with the others as its index.
pub(super) fn name(symbol: &str) -> String {
    match symbol {
        "%pi" => return r"\pi".into(),
        "%e" => return "e".into(),
        "%i" => return "i".into(),
        "inf" => return r"\infty".into(),
        "minf" => return r"-\infty".into(),
        _ => {}
    }
    let mut words = words(symbol).into_iter();
    let head = words.next().map_or_else(|| text(symbol), |word| letter(&word));
    let index: Vec<String> = words.map(|word| letter(&word)).collect();
    if index.is_empty() { head } else { format!("{head}_{{{}}}", index.join(",")) }
}

/// A word as a letter where it is one, upright otherwise.
fn letter(word: &str) -> String {
    if GREEK.contains(&word) {
        format!(r"\{word}")
    } else if word.chars().count() == 1 || word.bytes().all(|byte| byte.is_ascii_digit()) {
        text(word)
    } else {
        format!(r"\mathrm{{{}}}", text(word))
    }
}

/// The name cut at underlines, before and after digits, and once before the first capital behind a small letter.
fn words(symbol: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut previous = '_';
    for character in symbol.chars() {
        let first_word = words.len() == 1;
        if character != '_' {
            match words.last_mut() {
                Some(word) if !cut_between(previous, character, first_word) => word.push(character),
                _ => words.push(character.into()),
            }
        }
        previous = character;
    }
    words
}

fn cut_between(previous: char, character: char, first_word: bool) -> bool {
    previous == '_'
        || previous.is_ascii_digit() != character.is_ascii_digit()
        || (first_word && previous.is_lowercase() && character.is_uppercase())
}

/// Text whose characters LaTeX would take for commands, escaped.
pub(super) fn text(plain: &str) -> String {
    plain.chars().map(escaped).collect()
}

fn escaped(character: char) -> String {
    match character {
        '%' | '_' | '#' | '$' | '&' | '{' | '}' => format!(r"\{character}"),
        '\\' => r"\backslash{}".into(),
        '^' | '~' => format!(r"\{character}{{}}"),
        other => other.into(),
    }
}
