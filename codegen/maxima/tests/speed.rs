//! Texts of 100,000 equal pieces are read in time that grows as they do.

use std::time::{Duration, Instant};

use closedform_maxima::{parse_statements, worksheet};

/// Pieces of the long text; the short one has a sixteenth of them.
const PIECES: usize = 100_000;

/// What stands once before, again and again in the middle, and once behind.
const REPEATED: [(&str, &str, &str); 22] = [
    ("", "while x ", "do y$"),
    ("for i thru 9 ", "unless x ", "do y$"),
    ("if a then b ", "elseif c then d ", "else e$"),
    ("[", "x,", "x]$"),
    ("f(", "x,", "x)$"),
    ("(", "x:1,", "x)$"),
    ("x", ",y=1", "$"),
    ("", "f(x):=x$\n", ""),
    ("", "(%i1) x;", ""),
    ("", "/* c */ ", "x$"),
    ("/*", "/* c */", "*/ x$"),
    ("\"", "a\\\"", "\"$"),
    ("a", "\\ b", "$"),
    ("1", "\\\n", "$"),
    // what is wrong is told as fast
    ("x", "+x", "$"),
    ("", "(", "x$"),
    ("", "-", "x$"),
    ("x", "!", "$"),
    ("x", "^x", "$"),
    ("", "? ", "$"),
    ("", "1e$", ""),
    ("x", "(y)[z]", "$"),
];

fn time(text: &str) -> Duration {
    let start = Instant::now();
    let _ = parse_statements(text);
    let _ = worksheet(text);
    start.elapsed()
}

#[test]
fn every_construct_is_read_in_linear_time() {
    for (before, piece, behind) in REPEATED {
        let text = |pieces: usize| format!("{before}{}{behind}", piece.repeat(pieces));
        let (short, long) = (text(PIECES / 16), text(PIECES));
        // A square would take 256 times as long. The shortest of a few times, because others use the machine too.
        let short = (0..3).map(|_| time(&short)).min().unwrap_or_default();
        let long = (0..2).map(|_| time(&long)).min().unwrap_or_default();
        assert!(long < 64 * short + Duration::from_millis(50), "`{piece}`: {short:?}, then {long:?}");
    }
}
