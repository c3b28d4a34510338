//! Files as people keep them, and what Maxima reads of them.

use super::*;
use crate::drawn::{drawn, has};

const SHEET: &str = "/* [wxMaxima batch file version 1] [ DO NOT EDIT BY HAND! ]*/\n\
/* [ Created with wxMaxima version 21.02.0 ] */\n\
/* [wxMaxima: title   start ]\n\
A \u{e4} title: x; /* and a comment\n\
   [wxMaxima: title   end   ] */\n\n\
/* [wxMaxima: input   start ] */\n\
f(x) := x^2\n\
/* [wxMaxima: input   end   ] */\n\
/* [wxMaxima: question  start ] */\n\
Is a positive?\n\
/* [wxMaxima: question  end   ] */\n\
/* [wxMaxima: answer  start ] */\n\
positive;\n\
/* [wxMaxima: answer  end   ] */\n\
/* [wxMaxima: fold    start ] */\n\
/* [wxMaxima: image   start ]\n\
jpg\n\
/9j/4AAQSk*/ZJ\n\
   [wxMaxima: image   end   ] */\n\
/* [wxMaxima: hide output   ] *//* [wxMaxima: input   start ] */\n\
g(x) := 2*f(x)$ /* ends */\n\
/* [wxMaxima: input   end   ] */\n\
/* [wxMaxima: fold    end   ] */\n\
h(y) := y$\n\n\
/* Maxima can't load/batch files which end with a comment! */\n\
\"Created with wxMaxima 21.02.0\"$\n";

fn statements_of(script: &Script) -> Vec<&str> {
    let found = crate::statements::statements(script.text());
    found.into_iter().map(|statement| &script.text()[statement.place]).collect()
}

fn script(name: &str, bytes: &[u8]) -> Result<Script, ScriptError> {
    Script::of(Path::new(name), bytes)
}

#[test]
fn the_input_cells_of_a_text_are_code() {
    let read = script("a.wxm", SHEET.as_bytes()).unwrap();
    assert_eq!(read.text().len(), SHEET.len());
    assert_eq!(statements_of(&read), ["f(x) := x^2\n;", "g(x) := 2*f(x)$", "h(y) := y$"]);
    for name in ["f(x)", "g(x)", "h(y)"] {
        assert_eq!(read.text().find(name), SHEET.find(name));
    }
    let place = SHEET.find("f(x)").unwrap();
    assert_eq!(read.places([place].into_iter()), ["a.wxm:8:1"]);
    let returns = script("a.wxm", SHEET.replace('\n', "\r\n").as_bytes()).unwrap();
    assert_eq!(statements_of(&returns).len(), 3);
}

#[test]
fn what_is_cut_is_read_as_far_as_it_goes() {
    for end in 0..SHEET.len() {
        if SHEET.is_char_boundary(end) {
            let read = script("a.wxm", &SHEET.as_bytes()[..end]).unwrap();
            assert_eq!(read.text().len(), end);
            assert!(!read.text().contains("title: x") && !read.text().contains("/9j/"), "{end}: {}", read.text());
        }
    }
}

#[test]
fn a_text_without_marks_is_code() {
    let text = "f(x) := x$\n\"a string\"$\n";
    assert_eq!(script("a.mac", text.as_bytes()).unwrap().text(), text);
    assert_eq!(script("a.dem", text.as_bytes()).unwrap().text(), text);
}

/// A document with this content.
fn document(content: &str, compressed: bool) -> Vec<u8> {
    use flate2::{Compression, write::DeflateEncoder};
    use std::io::Write;
    let mut bytes = Vec::new();
    let mut archive = rawzip::ZipArchiveWriter::new(&mut bytes);
    for (name, data) in [("mimetype", "text/x-wxmathml"), ("content.xml", content)] {
        let method = if compressed { rawzip::CompressionMethod::DEFLATE } else { rawzip::CompressionMethod::STORE };
        let (mut entry, config) = archive.new_file(name).compression_method(method).start().unwrap();
        let descriptor = if compressed {
            let mut writer = config.wrap(DeflateEncoder::new(&mut entry, Compression::best()));
            writer.write_all(data.as_bytes()).unwrap();
            let (encoder, descriptor) = writer.finish().unwrap();
            encoder.finish().unwrap();
            descriptor
        } else {
            let mut writer = config.wrap(&mut entry);
            writer.write_all(data.as_bytes()).unwrap();
            writer.finish().unwrap().1
        };
        entry.finish(descriptor).unwrap();
    }
    archive.finish().unwrap();
    bytes
}

const CONTENT: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
<!--   Created using wxMaxima 21.02.0   -->\n\
<wxMaximaDocument version=\"1.5\" zoom=\"100\" activecell=\"4\">\n\
<cell type=\"title\">\n<editor type=\"title\" sectioning_level=\"1\">\n<line>not; code</line>\n</editor>\n<fold>\n\
<cell type=\"code\">\n<input>\n<editor type=\"input\">\n<line>kill(all)$</line>\n<line></line>\n\
<line>f(x) := if x &lt; 1 then &quot;a&amp;b&quot; else x&#94;2</line>\n</editor>\n</input>\n\
<output>\n<mth><lbl>(%o1) </lbl><v>x</v><h>*</h><line>no</line></mth>\n</output>\n</cell>\n</fold>\n</cell>\n\
<cell type=\"image\">\n<img>image1.png</img>\n</cell>\n\
<cell type=\"code\" hide=\"true\"><input><editor type=\"input\"><line/><line> g(x):=x+oops;</line></editor></input></cell>\n\
</wxMaximaDocument>";

#[test]
fn cells_end_with_lines_that_end_by_themselves() {
    for last in [":lisp (setq x 1)", "? sqrt", "?? ab"] {
        let cell = |text: &str| format!("/* [wxMaxima: input   start ] */\n{text}\n/* [wxMaxima: input   end   ] */\n");
        let read = script("a.wxm", (cell(last) + &cell("f(x) := x")).as_bytes()).unwrap();
        let (statements, errors) = closedform_maxima::parse_what_can_be(read.text());
        assert!(errors.is_empty() && statements.len() == 2, "{last}: {errors:?}");
    }
}

#[test]
fn the_input_cells_of_a_document_are_code() {
    for compressed in [false, true] {
        let read = script("a.wxmx", &document(CONTENT, compressed)).unwrap();
        let statements = ["kill(all)$", "f(x) := if x < 1 then \"a&b\" else x^2;", "g(x):=x+oops;"];
        assert_eq!(statements_of(&read), statements);
        let place = read.text().find("oops").unwrap();
        assert_eq!(read.places([place].into_iter()), ["a.wxmx, input cell 2:2:10"]);
    }
    // a document is one whatever it is called
    assert!(script("a.wxm", &document(CONTENT, false)).is_ok());
}

#[test]
fn what_is_no_document_says_why() {
    let said = |name: &str, bytes: &[u8]| drawn(&script(name, bytes).unwrap_err());
    has(
        &said("a.wxmx", b"f(x) := x$"),
        &["a.wxmx cannot be read as a document of wxMaxima", "the zip archive is damaged"],
    );
    has(&said("a.wxmx", b""), &["the zip archive is damaged"]);
    has(&said("a.wxmx", &document("<a/>", true)), &["content.xml holds no wxMaximaDocument"]);
    has(&said("a.wxmx", &document("<wxMaximaDocument><cell></input>", true)), &["is no XML", "at byte 2"]);
    has(&said("a.wxmx", &document("<wxMaximaDocument><cell>&bomb;", true)), &["`&bomb;` means nothing"]);
    let mut damaged = document(CONTENT, false);
    let at = damaged.windows(4).position(|letters| letters == b"kill").unwrap();
    damaged[at] = b'm';
    has(&said("a.wxmx", &damaged), &["content.xml does not unpack"]);
    has(&said("a.mac", b"MZ\0\x01"), &["a.mac is no text"]);
    let open = CONTENT.replace("x+oops;", "x; /* never closed");
    has(&said("a.wxmx", &document(&open, true)), &["does not end in its cell", "a.wxmx, input cell 2:2:11"]);
}

#[test]
fn a_bomb_does_not_go_off() {
    let bomb = format!("<wxMaximaDocument>{}", " ".repeat(65 << 20));
    let bytes = document(&bomb, true);
    assert!(bytes.len() < 1 << 20);
    has(&drawn(&script("a.wxmx", &bytes).unwrap_err()), &["content.xml has more than 64 MiB"]);
}
