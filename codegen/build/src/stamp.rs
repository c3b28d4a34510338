//! Stamps: the second line of a generated file, which says by what version, from what, and as what text it was made.

/// The version whose files are fresh.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What a file says of its making.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stamp {
    /// The version of closedform.
    pub version: String,
    /// The hash of what it was made from.
    pub inputs: u64,
    /// The hash of its text without the stamp.
    pub text: u64,
}

impl Stamp {
    /// The stamp that a text carries, if it does.
    #[must_use]
    pub fn read(text: &str) -> Option<Self> {
        let (_, line) = split(text)?;
        let mut parts = line.trim_matches(SIGNS).split("; ");
        let version = parts.next()?.strip_prefix("closedform ")?.to_owned();
        let mut number = |key| u64::from_str_radix(parts.next()?.strip_prefix(key)?, 16).ok();
        Some(Self { version, inputs: number("inputs ")?, text: number("text ")? })
    }

    /// Whether a text is the one that was stamped.
    #[must_use]
    pub fn is_of(&self, text: &str) -> bool {
        split(text).is_some_and(|(rest, _)| hash([rest.as_bytes()]) == self.text)
    }
}

/// What comments begin and end with in the files that are stamped: Rust, tables, Maxima.
const SIGNS: [char; 5] = ['/', '*', '#', ' ', '\r'];

/// A text with its stamp as second line, in a comment like its first line.
#[must_use]
pub fn stamped(text: &str, version: &str, inputs: u64) -> String {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    let sign = &first[..first.find(|letter| !SIGNS.contains(&letter)).unwrap_or(first.len())];
    let end = if sign.starts_with("/*") { " */" } else { "" };
    let whole = hash([format!("{first}\n{rest}").as_bytes()]);
    format!("{first}\n{sign}closedform {version}; inputs {inputs:016x}; text {whole:016x}{end}\n{rest}")
}

/// A text without its second line, and that line.
fn split(text: &str) -> Option<(String, &str)> {
    let (first, rest) = text.split_once('\n')?;
    let (line, rest) = rest.split_once('\n')?;
    Some((format!("{first}\n{rest}"), line))
}

/// FNV-1a in 64 bits of texts in order, each with its end; the ends of lines do not matter. It is written out here, as build
/// scripts build this crate and no other.
#[must_use]
pub fn hash<'a>(texts: impl IntoIterator<Item = &'a [u8]>) -> u64 {
    let add = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    texts.into_iter().fold(0xcbf2_9ce4_8422_2325, |hash, text| {
        // no text of a file holds the byte 0xff, which stands for its end
        let bytes = text.iter().filter(|byte| **byte != b'\r').chain([&0xff]);
        bytes.fold(hash, |hash, byte| add(hash, *byte))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stamp_reads_back_in_every_comment() {
        for text in ["// Made.\n//! Reads.\nfn f() {}\n", "# Made.\n1\t2\n", "/* Made. */\nf(x):=x$\n", "// Made."] {
            let made = stamped(text, "1.2.3", 0x1f);
            let stamp = Stamp::read(&made).unwrap_or_else(|| panic!("{made}"));
            assert_eq!((stamp.version.as_str(), stamp.inputs), ("1.2.3", 0x1f));
            assert!(stamp.is_of(&made) && stamp.is_of(&made.replace('\n', "\r\n")), "{made}");
            assert_eq!(Stamp::read(&made.replace('\n', "\r\n")), Some(stamp));
            assert_eq!(Stamp::read(text), None);
        }
        assert!(stamped("/* Made. */\nf(x):=x$\n", "1", 0).lines().nth(1).unwrap().ends_with(" */"));
    }

    #[test]
    fn one_other_letter_is_noticed() {
        let made = stamped("// Made.\nlet a = b + c;\n", "1.2.3", 0);
        let stamp = Stamp::read(&made).unwrap();
        assert!(!stamp.is_of(&made.replace('+', "-")) && !stamp.is_of(&made.replace("Made", "Mad")));
    }

    #[test]
    fn files_do_not_flow_into_each_other() {
        assert_eq!(hash([&b"a\r\nb"[..]]), hash([&b"a\nb"[..]]));
        assert_ne!(hash([&b"ab"[..], b"c"]), hash([&b"a"[..], b"bc"]));
        assert_ne!(hash([&b"a"[..]]), hash([&b"a"[..], b""]));
    }
}
