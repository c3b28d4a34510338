//! Formulas of the worksheet in lines that fit a page: they are broken at their operators, and stay formulas.

/// What all lines but the first begin with.
const INDENT: &str = "    ";

/// A formula in lines of at most `width` letters, where operators allow it.
#[must_use]
pub fn broken(formula: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut rest = formula.to_owned();
    while rest.chars().count() > width {
        let Some(end) = best_break(&rest, width) else { break };
        let after = rest.split_off(end);
        lines.push(std::mem::replace(&mut rest, format!("{INDENT}{}", after.trim_start())));
    }
    lines.push(rest);
    lines
}

/// Where to break: before an operator, outside of as many parentheses as can be, and late.
fn best_break(line: &str, width: usize) -> Option<usize> {
    let (mut depth, mut before, mut earlier) = (0_usize, ' ', ' ');
    let mut best: Option<(usize, usize)> = None;
    for (position, (at, letter)) in line.char_indices().enumerate() {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        // a product is broken as if it were a parenthesis deeper than its sum
        let cost = match letter {
            '+' | '-' if is_operand_end(earlier, before) => Some(2 * depth),
            '*' | '/' => Some(2 * depth + 1),
            _ => None,
        };
        let far_enough = 3 * position >= width && position <= width;
        if let Some(cost) = cost.filter(|_| far_enough)
            && best.is_none_or(|(least, _)| cost <= least)
        {
            best = Some((cost, at));
        }
        (earlier, before) = (before, letter);
    }
    best.map(|(_, at)| at)
}

/// Whether an operator after these letters has a left operand; a sign, and the exponent of a number, have none.
fn is_operand_end(earlier: char, before: char) -> bool {
    let in_number = matches!(before, 'e' | 'E' | 'b' | 'B') && (earlier.is_ascii_digit() || earlier == '.');
    !in_number && (before.is_alphanumeric() || matches!(before, ')' | ']' | '_'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_is_broken_at_its_outermost_operators() {
        assert_eq!(broken("f(a,b):=a+b", 20), ["f(a,b):=a+b"]);
        assert_eq!(broken("f(a,b):=(a+b+a+b)*c+(a-b-a)*d", 20), ["f(a,b):=(a+b+a+b)*c", "    +(a-b-a)*d"]);
        assert_eq!(broken(&"x".repeat(40), 20), ["x".repeat(40)]);
        assert_eq!(broken("f(a,b):=a*1.0e-5*b", 14), ["f(a,b):=a", "    *1.0e-5*b"]);
        let long = format!("f(a,b):={}", ["a^2*(b+1)"; 40].join("-"));
        let lines = broken(&long, 60);
        assert!(lines.iter().all(|line| line.chars().count() <= 60), "{lines:?}");
        assert_eq!(lines.iter().map(|line| line.trim()).collect::<String>(), long);
    }
}
