//! Nearest names: what a mistyped one was meant to be.

/// How many names are worth suggesting.
const COUNT: usize = 3;

/// The names nearest to `wanted`, nearest first; each comes with a spelling that is compared. What shares less than half of
/// its letters is not near.
pub fn nearest(wanted: &str, spellings: impl IntoIterator<Item = (String, String)>) -> Vec<String> {
    let ranked = spellings.into_iter().filter_map(|(spelling, name)| {
        let (distance, longest) = (distance(wanted, &spelling), wanted.chars().count().max(spelling.chars().count()));
        (2 * distance <= longest).then_some((distance, name))
    });
    let mut ranked: Vec<(usize, String)> = ranked.collect();
    ranked.sort();
    let mut names: Vec<String> = Vec::new();
    for (_, name) in ranked {
        if names.len() < COUNT && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// How many letters must be put in, taken out or replaced to turn one name into the other, capitals aside.
fn distance(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.to_lowercase().chars().collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (line, letter) in from.to_lowercase().chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = line + 1;
        for (column, other) in to.iter().enumerate() {
            let replaced = diagonal + usize::from(letter != *other);
            diagonal = row[column + 1];
            row[column + 1] = replaced.min(diagonal + 1).min(row[column] + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distance_counts_letters() {
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("T_IN", "t_in"), 0);
    }

    #[test]
    fn names_come_once_and_nearest_first() {
        let spellings =
            [("t_in", "a::t_in"), ("a::t_in", "a::t_in"), ("t_out", "a::t_out"), ("x", "b::x"), ("y", "b::y")];
        let spellings = spellings.map(|(spelling, name)| (spelling.to_owned(), name.to_owned()));
        assert_eq!(nearest("t_ou", spellings.clone()), ["a::t_out", "a::t_in"]);
        assert_eq!(nearest("quartic_root", spellings), [""; 0]);
    }
}
