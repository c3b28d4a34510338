//! What Maxima asks, and the statements that would have answered it beforehand.

/// Statements one of which answers the question; none if it is not understood.
pub(super) fn answers(question: &str) -> Vec<String> {
    let question = question.split_whitespace().collect::<Vec<_>>().join(" ");
    let Some(asked) = question.strip_prefix("Is ").and_then(|rest| rest.strip_suffix('?')) else { return Vec::new() };
    let told = |of: &str, forms: &[&str]| forms.iter().map(|form| form.replace('@', of.trim())).collect();
    let signs: [(&str, &[&str]); 5] = [
        ("positive, negative or zero", &["assume(@>0)$", "assume(@<0)$", "assume(equal(@,0))$"]),
        ("positive, negative, or zero", &["assume(@>0)$", "assume(@<0)$", "assume(equal(@,0))$"]),
        ("positive or negative", &["assume(@>0)$", "assume(@<0)$"]),
        ("positive or zero", &["assume(@>0)$", "assume(equal(@,0))$"]),
        ("zero or nonzero", &["assume(notequal(@,0))$", "assume(equal(@,0))$"]),
    ];
    for (end, forms) in signs {
        if let Some(of) = asked.strip_suffix(end) {
            return told(of, forms);
        }
    }
    for (end, word) in [("an integer", "integer"), ("an even number", "even"), ("an odd number", "odd")] {
        if let Some(of) = asked.strip_suffix(end) {
            let not = if word == "integer" { "noninteger" } else { "integer" };
            return told(of, &[&format!("declare(@, {word})$"), &format!("declare(@, {not})$")]);
        }
    }
    if let Some((left, right)) = asked.split_once(" equal to ") {
        let (left, right) = (left.trim(), right.trim());
        return vec![format!("assume(equal({left},{right}))$"), format!("assume(notequal({left},{right}))$")];
    }
    // a comparison: it holds or does not
    for (relation, other) in [(" > ", "<="), (" < ", ">="), (" >= ", "<"), (" <= ", ">")] {
        if let Some((left, right)) = asked.split_once(relation) {
            return vec![format!("assume({asked})$"), format!("assume({left} {other} {right})$")];
        }
    }
    Vec::new()
}

/// What to do about a question that a statement at this place asks.
pub(super) fn remedy(question: &str, place: Option<&str>) -> String {
    let answers = answers(question);
    let place = place.map_or_else(|| "into the worksheet".to_owned(), |place| format!("before {place}"));
    match answers.as_slice() {
        [] => format!("answer it beforehand: put an assume(..) {place}"),
        [one] => format!("answer it beforehand: put {one} {place}"),
        [first @ .., last] => format!("answer it beforehand: put {} or {last} {place}", first.join(" or ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn questions_are_answered_by_statements() {
        let all = |question: &str| answers(question).join(" ");
        assert_eq!(
            all("Is b^2-4*c positive, negative or zero?"),
            "assume(b^2-4*c>0)$ assume(b^2-4*c<0)$ assume(equal(b^2-4*c,0))$"
        );
        assert_eq!(all("Is a positive or negative?"), "assume(a>0)$ assume(a<0)$");
        assert_eq!(all("Is a zero or nonzero?"), "assume(notequal(a,0))$ assume(equal(a,0))$");
        assert_eq!(all("Is  n an integer?"), "declare(n, integer)$ declare(n, noninteger)$");
        assert_eq!(all("Is n equal to - 1?"), "assume(equal(n,- 1))$ assume(notequal(n,- 1))$");
        assert!(answers("What?").is_empty());
    }

    #[test]
    fn the_remedy_says_what_to_put_where() {
        let said = remedy("Is a zero or nonzero?", Some("my.mac:3:1"));
        assert!(said.contains("put assume(notequal(a,0))$ or assume(equal(a,0))$ before my.mac:3:1"), "{said}");
        assert!(remedy("Well?", None).contains("put an assume(..) into the worksheet"));
    }
}
