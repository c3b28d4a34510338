//! A drawing as text of SVG.

use std::fmt::Write;

use super::drawing::{Anchor, Drawing, Font, Shape, Stroke, coordinate};

fn escape(text: &str) -> String {
    let allowed = |c: &char| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}');
    text.chars().filter(allowed).fold(String::with_capacity(text.len()), |mut escaped, c| {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            _ => escaped.push(c),
        }
        escaped
    })
}

impl Drawing {
    /// As text of SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        let ([w, h], title, background) =
            ([self.size.0, self.size.1].map(coordinate), escape(&self.title), self.background);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" role=\"img\">\n\
             <title>{title}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"{background}\"/>\n\
             <g fill=\"none\" stroke-linejoin=\"round\" font-family=\"'DejaVu Sans', Verdana, Arial, sans-serif\">\n"
        );
        for shape in &self.shapes {
            // Writing to a string does not fail.
            let _ = writeln!(text, "{}", element(shape));
        }
        text + "</g>\n</svg>\n"
    }
}

fn element(shape: &Shape) -> String {
    match shape {
        Shape::Path { data, fill, stroke } => {
            let Stroke { colour, width, dashes } = *stroke;
            let fill = fill.map_or_else(String::new, |fill| format!(" fill=\"{fill}\""));
            let dashes = if dashes.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dashes}\"") };
            format!("<path d=\"{data}\"{fill} stroke=\"{colour}\" stroke-width=\"{}\"{dashes}/>", coordinate(width))
        }
        Shape::Text { at, anchor, font, text } => {
            let [x, y, size] = [at.0, at.1, font.size].map(coordinate);
            let anchor = match anchor {
                Anchor::Start => "",
                Anchor::Middle => " text-anchor=\"middle\"",
                Anchor::End => " text-anchor=\"end\"",
            };
            let weight = if font.bold { " font-weight=\"bold\"" } else { "" };
            let (Font { colour, .. }, text) = (font, escape(text));
            format!("<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{colour}\"{anchor}{weight}>{text}</text>")
        }
    }
}
