//! Replays a corpus and random changes of it, in seconds and without a fuzzer: the same inputs at every run.

use std::path::Path;
use std::{fs, panic};

/// How many changed inputs are tried.
const CHANGED: usize = 4_000;

/// How many changes an input takes at most.
const CHANGES: usize = 6;

/// No input grows beyond this, so that a run takes seconds.
const LONGEST: usize = 4_000;

/// Pieces that many grammars take for more than bytes.
const PIECES: [&[u8]; 16] = [
    b"(",
    b")",
    b"[",
    b"]",
    b"{",
    b"}",
    b"\"",
    b"/*",
    b"*/",
    b"$",
    b"\n",
    b"0",
    b"1e999",
    b"-",
    b"\xff",
    "\u{2028}".as_bytes(),
];

/// Runs `entry` on every file of `fuzz/corpus/NAME` and on changed ones.
///
/// # Panics
///
/// There is no corpus, or the entry panics: then the input is shown.
pub fn replay(name: &str, entry: impl Fn(&[u8]) + panic::RefUnwindSafe) {
    let mut folders =
        Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().map(|above| above.join("fuzz/corpus").join(name));
    let folder = folders.find(|folder| folder.is_dir()).expect("the corpus is above the crate");
    let mut paths: Vec<_> = fs::read_dir(folder).expect("a folder").map(|file| file.expect("a file").path()).collect();
    paths.sort();
    let corpus: Vec<Vec<u8>> = paths.iter().map(|path| fs::read(path).expect("a file")).collect();
    assert!(!corpus.is_empty(), "no corpus `{name}`");
    let mut random = Random(1);
    let changed = (0..CHANGED).map(|_| changed(&corpus, &mut random));
    for input in corpus.iter().cloned().chain(changed) {
        let outcome = panic::catch_unwind(|| entry(&input));
        assert!(outcome.is_ok(), "the input was {:?}", String::from_utf8_lossy(&input));
    }
}

/// One of the corpus, changed at some places.
fn changed(corpus: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut input = corpus[random.below(corpus.len())].clone();
    for _ in 0..=random.below(CHANGES) {
        let at = random.below(input.len() + 1);
        let end = at + random.below(input.len() - at + 1).min(20);
        match random.below(5) {
            0 => _ = input.drain(at..end),
            1 => _ = input.splice(at..at, input[at..end].to_vec()),
            2 => _ = input.splice(at..end, PIECES[random.below(PIECES.len())].iter().copied()),
            3 => input[at..end].reverse(),
            _ => {
                let other = &corpus[random.below(corpus.len())];
                let from = random.below(other.len() + 1);
                let to = from + random.below(other.len() - from + 1).min(60);
                _ = input.splice(at..end, other[from..to].iter().copied());
            }
        }
        input.truncate(LONGEST);
    }
    input
}

/// SplitMix64 (Steele, Lea, Flood 2014).
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((mixed ^ mixed >> 31) % end as u64).expect("below a usize")
    }
}
