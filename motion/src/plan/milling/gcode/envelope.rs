//! Lines in the form in which Universal G-Code Sender saves a program that it has made ready to send.

/// The first line begins so.
const HEADER: &[u8] = b"gsw_meta:";

/// Between the fields of a line: as it was, as it is sent, its number, its comment.
const SEPARATOR: &[u8] = "\u{b6}\u{b6}".as_bytes();

/// Whether the file is of this form.
pub(super) fn is_header(line: &[u8]) -> bool {
    line.starts_with(HEADER)
}

/// What of a line is sent.
pub(super) fn sent(line: &[u8]) -> &[u8] {
    let end = |text: &[u8]| text.windows(SEPARATOR.len()).position(|part| part == SEPARATOR);
    let Some(first) = end(line) else { return line };
    let rest = &line[first + SEPARATOR.len()..];
    &rest[..end(rest).unwrap_or(rest.len())]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_field_is_sent() {
        assert!(is_header(b"gsw_meta:12  \n"));
        assert_eq!(sent("G2 X1 I1\u{b6}\u{b6}G1X1\u{b6}\u{b6}3\u{b6}\u{b6}".as_bytes()), b"G1X1");
        assert_eq!(sent(b"G1 X1"), b"G1 X1");
    }
}
