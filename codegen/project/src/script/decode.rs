//! Bytes to text: UTF-8 and UTF-16 with their marks, UTF-8 without, and otherwise what Western machines wrote before it.

/// The text, its lines ended by line feeds; none of what holds zero bytes, which no text does.
pub(super) fn text(bytes: &[u8]) -> Option<String> {
    let text = match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => eight_bits(rest),
        [0xff, 0xfe, rest @ ..] => sixteen_bits(rest, u16::from_le_bytes)?,
        [0xfe, 0xff, rest @ ..] => sixteen_bits(rest, u16::from_be_bytes)?,
        _ => eight_bits(bytes),
    };
    (!text.contains('\0')).then(|| with_line_feeds(text))
}

fn eight_bits(bytes: &[u8]) -> String {
    let western = || bytes.iter().map(|byte| windows_1252(*byte)).collect();
    std::str::from_utf8(bytes).map_or_else(|_| western(), str::to_owned)
}

fn sixteen_bits(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Option<String> {
    let (units, rest) = bytes.as_chunks();
    let units: Vec<u16> = units.iter().map(|pair| unit(*pair)).collect();
    String::from_utf16(&units).ok().filter(|_| rest.is_empty())
}

/// Latin-1, with the letters that Windows put where it has none; as the Encoding Standard of the WHATWG has them.
fn windows_1252(byte: u8) -> char {
    const WINDOWS: [char; 32] = [
        '\u{20ac}', '\u{81}', '\u{201a}', '\u{192}', '\u{201e}', '\u{2026}', '\u{2020}', '\u{2021}', '\u{2c6}',
        '\u{2030}', '\u{160}', '\u{2039}', '\u{152}', '\u{8d}', '\u{17d}', '\u{8f}', '\u{90}', '\u{2018}', '\u{2019}',
        '\u{201c}', '\u{201d}', '\u{2022}', '\u{2013}', '\u{2014}', '\u{2dc}', '\u{2122}', '\u{161}', '\u{203a}',
        '\u{153}', '\u{9d}', '\u{17e}', '\u{178}',
    ];
    byte.checked_sub(0x80).and_then(|at| WINDOWS.get(usize::from(at)).copied()).unwrap_or(char::from(byte))
}

/// A carriage return alone ends a line, as on old Macintoshes; one before a line feed is blank space to everybody.
fn with_line_feeds(text: String) -> String {
    if !text.contains('\r') {
        return text;
    }
    let next = text.chars().skip(1).map(Some).chain([None]);
    let alone = |letter, next| if letter == '\r' && next != Some('\n') { '\n' } else { letter };
    text.chars().zip(next).map(|(letter, next)| alone(letter, next)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_encoding_gives_the_same_text() {
        let umlauts = "/* \u{e4}\u{f6}\u{fc} */ f(x):=x$\n";
        let utf_8 = umlauts.as_bytes().to_vec();
        let marked = [&[0xef, 0xbb, 0xbf], &utf_8[..]].concat();
        let latin: Vec<u8> = umlauts.chars().map(|letter| letter as u8).collect();
        let units: Vec<u16> = umlauts.encode_utf16().collect();
        let little = [vec![0xff, 0xfe], units.iter().flat_map(|unit| unit.to_le_bytes()).collect()].concat();
        let big = [vec![0xfe, 0xff], units.iter().flat_map(|unit| unit.to_be_bytes()).collect()].concat();
        for bytes in [utf_8, marked, latin, little, big] {
            assert_eq!(text(&bytes).as_deref(), Some(umlauts), "{bytes:x?}");
        }
        assert_eq!(text(b"\x93a\x94 \x96 \xb2").as_deref(), Some("\u{201c}a\u{201d} \u{2013} \u{b2}"));
    }

    #[test]
    fn lines_end_on_every_machine() {
        assert_eq!(text(b"a\rb\r\nc\nd\r").as_deref(), Some("a\nb\r\nc\nd\n"));
    }

    #[test]
    fn what_is_no_text_is_refused() {
        for bytes in [&b"a\0b"[..], &[0xff, 0xfe, 0x41], &[0xff, 0xfe, 0x00, 0xd8]] {
            assert_eq!(text(bytes), None, "{bytes:x?}");
        }
        assert_eq!(text(b"").as_deref(), Some(""));
    }
}
