//! The input cells of a document of wxMaxima: XML in a zip archive.

use std::io::{Cursor, Read};

use flate2::read::DeflateDecoder;
use quick_xml::events::{BytesRef, BytesStart, Event};
use quick_xml::{Reader, escape};
use rawzip::{CompressionMethod, ZipArchive};
use thiserror::Error;

/// The part of the archive that holds the cells.
const CONTENT: &str = "content.xml";

/// What its XML is called.
const DOCUMENT: &str = "wxMaximaDocument";

/// How much of it is read, in bytes: a small archive may hold any amount.
const LARGEST: u64 = 64 << 20;

/// How many parts an archive has at most: a document has one for each of its images.
const MOST_PARTS: usize = 100_000;

/// Why a file is no document.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DocumentError {
    /// No archive, or a damaged one.
    #[error("the zip archive is damaged: {0}")]
    Archive(#[from] rawzip::Error),
    /// An archive of something else.
    #[error("the zip archive holds no {CONTENT}")]
    NoContent,
    /// Compressed as wxMaxima never does.
    #[error("{CONTENT} is compressed by method {0}")]
    Method(u16),
    /// Its bytes are not those that were put in.
    #[error("{CONTENT} does not unpack: {0}")]
    Damaged(std::io::Error),
    /// A bomb.
    #[error("{CONTENT} has more than {} MiB", LARGEST >> 20)]
    TooLarge,
    /// XML that is none.
    #[error("{CONTENT} is no XML: {cause} at byte {place}")]
    Xml {
        /// Why not.
        cause: String,
        /// Where.
        place: u64,
    },
    /// XML of something else.
    #[error("{CONTENT} holds no {DOCUMENT}")]
    NoDocument,
}

/// The texts of the input cells, in order.
pub(super) fn cells(bytes: &[u8]) -> Result<Vec<String>, DocumentError> {
    inputs(&content(bytes)?)
}

/// The text of `content.xml`.
fn content(bytes: &[u8]) -> Result<String, DocumentError> {
    let archive = ZipArchive::from_slice(bytes)?;
    let mut entries = archive.entries();
    for _ in 0..MOST_PARTS {
        let Some(entry) = entries.next_entry()? else { break };
        if entry.file_path().as_ref() != CONTENT.as_bytes() {
            continue;
        }
        let part = archive.get_entry(entry.wayfinder())?;
        let unpacked: Box<dyn Read> = match entry.compression_method() {
            CompressionMethod::STORE => Box::new(Cursor::new(part.data())),
            CompressionMethod::DEFLATE => Box::new(DeflateDecoder::new(part.data())),
            other => return Err(DocumentError::Method(other.as_u16())),
        };
        let mut content = Vec::new();
        let read = part.verifying_reader(unpacked).take(LARGEST + 1).read_to_end(&mut content);
        return match read {
            Err(cause) => Err(DocumentError::Damaged(cause)),
            Ok(_) if content.len() as u64 > LARGEST => Err(DocumentError::TooLarge),
            // what is no UTF-8 is no letter of a formula, but may stand in an output that nobody reads
            Ok(_) => Ok(String::from_utf8_lossy(&content).into_owned()),
        };
    }
    Err(DocumentError::NoContent)
}

/// The lines of the editors for input, joined, cell by cell.
fn inputs(xml: &str) -> Result<Vec<String>, DocumentError> {
    let mut reader = Reader::from_str(xml);
    let (mut cells, mut lines, mut is_document): (Vec<String>, Option<Vec<String>>, bool) = (Vec::new(), None, false);
    loop {
        let wrong = |cause: quick_xml::Error, place| DocumentError::Xml { cause: cause.to_string(), place };
        let event = reader.read_event().map_err(|cause| wrong(cause, reader.error_position()))?;
        match event {
            Event::Eof => break,
            Event::Start(start) => match start.name().as_ref() {
                DOCUMENT => is_document = true,
                "editor" if is_input(&start) => lines = Some(Vec::new()),
                "line" => lines.iter_mut().for_each(|lines| lines.push(String::new())),
                _ => {}
            },
            Event::Empty(line) if line.name().as_ref() == "line" => {
                lines.iter_mut().for_each(|lines| lines.push(String::new()));
            }
            Event::End(end) if end.name().as_ref() == "editor" => {
                cells.extend(lines.take().map(|lines| lines.join("\n")));
            }
            Event::Text(text) => push(&mut lines, &text.xml10_content()),
            Event::CData(text) => push(&mut lines, &text.xml10_content()),
            Event::GeneralRef(reference) => {
                let letters = letters(&reference).ok_or_else(|| DocumentError::Xml {
                    cause: format!("`&{};` means nothing", &*reference),
                    place: reader.buffer_position(),
                })?;
                push(&mut lines, &letters);
            }
            _ => {}
        }
    }
    if is_document { Ok(cells) } else { Err(DocumentError::NoDocument) }
}

/// What stands between lines is blank space of the XML.
fn push(lines: &mut Option<Vec<String>>, text: &str) {
    if let Some(line) = lines.as_mut().and_then(|lines| lines.last_mut()) {
        line.push_str(text.trim_end_matches('\n'));
    }
}

fn is_input(editor: &BytesStart) -> bool {
    editor.try_get_attribute("type").ok().flatten().is_some_and(|kind| *kind.value == *"input")
}

/// What a reference stands for: a letter by its number, or one of the five that XML names.
fn letters(reference: &BytesRef) -> Option<String> {
    match reference.resolve_char_ref().ok()? {
        Some(letter) => Some(letter.to_string()),
        None => escape::resolve_xml_entity(reference).map(str::to_owned),
    }
}
