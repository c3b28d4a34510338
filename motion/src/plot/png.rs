//! A drawing as PNG, with a font of our own, so that it needs none of the machine's.

use ttf_parser::{Face, GlyphId, OutlineBuilder};
use zeno::{Join, Mask, Placement, Stroke as Pen, Style, Transform};

use super::drawing::{Anchor, Drawing, Font, Shape, Stroke, coordinate};
use super::error::PlotError;

/// Pixels of the PNG a pixel of the SVG: sharp in print and on dense screens.
const SCALE: f32 = 2.0;

/// A PNG of more pixels would not fit into memory.
const MOST: f64 = 1e8;

impl Drawing {
    /// As the bytes of a PNG, two pixels a pixel of the SVG.
    ///
    /// # Errors
    ///
    /// The picture is too large.
    pub fn png(&self) -> Result<Vec<u8>, PlotError> {
        let size = [self.size.0, self.size.1].map(|size| (size * f64::from(SCALE)).ceil());
        if size[0] * size[1] > MOST {
            return Err(PlotError::Png { why: "it is too large".to_owned() });
        }
        let mut canvas = Canvas::new(size.map(|size| size as usize), colour(self.background));
        let fonts = Fonts::new()?;
        for shape in &self.shapes {
            match shape {
                Shape::Path { data, fill, stroke } => {
                    if let Some(fill) = fill {
                        canvas.paint(data, Style::default(), colour(fill));
                    }
                    canvas.stroke(data, *stroke);
                }
                Shape::Text { at, anchor, font, text } => {
                    canvas.paint(&fonts.outline(*at, *anchor, *font, text), Style::default(), colour(font.colour));
                }
            }
        }
        canvas.encode()
    }
}

/// Red, green and blue of `#rrggbb`.
fn colour(text: &str) -> [u8; 3] {
    let part = |at: usize| text.get(at..at + 2).and_then(|hex| u8::from_str_radix(hex, 16).ok()).unwrap_or(0);
    [part(1), part(3), part(5)]
}

/// A path in parts of so many commands, because a mask takes much longer for one long path than for its parts; each begins
/// with the last command of the one before, whose join it draws.
fn parts(data: &str) -> Vec<String> {
    const MOST: usize = 256;
    let starts = data.char_indices().filter(|(_, letter)| letter.is_ascii_alphabetic()).map(|(at, _)| at);
    let ends: Vec<usize> = starts.chain([data.len()]).collect();
    let commands: Vec<&str> = ends.windows(2).map(|pair| &data[pair[0]..pair[1]]).collect();
    if commands.len() <= MOST {
        return vec![data.to_owned()];
    }
    let point = |command: &str| {
        let numbers: Vec<&str> = command[1..].split_whitespace().collect();
        numbers[numbers.len().saturating_sub(2)..].join(" ")
    };
    let part = |start: usize| {
        let end = (start + MOST).min(commands.len());
        format!("M{}{}", point(commands[start - 1]), commands[start..end].concat())
    };
    (1..commands.len()).step_by(MOST - 1).map(part).collect()
}

/// The pixels.
struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
}

impl Canvas {
    fn new([width, height]: [usize; 2], background: [u8; 3]) -> Self {
        Self { width, height, pixels: background.repeat(width * height) }
    }

    fn stroke(&mut self, data: &str, Stroke { colour: name, width, dashes }: Stroke) {
        let dashes: Vec<f32> = dashes.split(' ').filter_map(|dash| dash.parse().ok()).collect();
        let mut pen = Pen::new(width as f32);
        pen.join(Join::Round).dash(&dashes, 0.0);
        for part in parts(data) {
            self.paint(&part, Style::Stroke(pen), colour(name));
        }
    }

    /// Paints the inside or the outline of a path, as much as it covers of each pixel.
    fn paint<'a>(&mut self, data: &'a str, style: impl Into<Style<'a>>, colour: [u8; 3]) {
        let (coverage, place) = Mask::new(data).transform(Some(Transform::scale(SCALE, SCALE))).style(style).render();
        let Placement { left, top, width, .. } = place;
        for (row, line) in (i64::from(top)..).zip(coverage.chunks_exact((width as usize).max(1))) {
            for (column, covered) in (i64::from(left)..).zip(line) {
                self.blend(column, row, *covered, colour);
            }
        }
    }

    fn blend(&mut self, column: i64, row: i64, covered: u8, colour: [u8; 3]) {
        let place = |at: i64, most: usize| usize::try_from(at).ok().filter(|at| *at < most);
        let (Some(column), Some(row)) = (place(column, self.width), place(row, self.height)) else { return };
        let start = 3 * (row * self.width + column);
        for (pixel, new) in self.pixels[start..start + 3].iter_mut().zip(colour) {
            let mixed = u32::from(*pixel) * u32::from(255 - covered) + u32::from(new) * u32::from(covered);
            *pixel = ((mixed + 127) / 255) as u8;
        }
    }

    fn encode(&self) -> Result<Vec<u8>, PlotError> {
        let error = |error: png::EncodingError| PlotError::Png { why: error.to_string() };
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header().map_err(error)?;
        writer.write_image_data(&self.pixels).map_err(error)?;
        writer.finish().map_err(error)?;
        Ok(bytes)
    }
}

/// DejaVu Sans, regular and bold.
struct Fonts {
    regular: Face<'static>,
    bold: Face<'static>,
}

impl Fonts {
    fn new() -> Result<Self, PlotError> {
        let parse = |bytes| Face::parse(bytes, 0).map_err(|error| PlotError::Png { why: error.to_string() });
        Ok(Self { regular: parse(dejavu::sans::regular())?, bold: parse(dejavu::sans::bold())? })
    }

    /// The outlines of a text, as path data.
    fn outline(&self, at: (f64, f64), anchor: Anchor, font: Font, text: &str) -> String {
        let face = if font.bold { &self.bold } else { &self.regular };
        let scale = font.size / f64::from(face.units_per_em());
        let glyphs: Vec<GlyphId> =
            text.chars().map(|character| face.glyph_index(character).unwrap_or_default()).collect();
        let advance = |glyph: &GlyphId| scale * f64::from(face.glyph_hor_advance(*glyph).unwrap_or(0));
        let width: f64 = glyphs.iter().map(advance).sum();
        let left = match anchor {
            Anchor::Start => at.0,
            Anchor::Middle => at.0 - width / 2.0,
            Anchor::End => at.0 - width,
        };
        let mut outline = Outline { data: String::new(), scale, at: (left, at.1) };
        for glyph in glyphs {
            face.outline_glyph(glyph, &mut outline);
            outline.at.0 += advance(&glyph);
        }
        outline.data
    }
}

/// Collects the outline of glyph after glyph.
struct Outline {
    data: String,
    scale: f64,
    /// Where the glyph stands.
    at: (f64, f64),
}

impl Outline {
    fn command(&mut self, letter: char, points: &[(f32, f32)]) {
        self.data.push(letter);
        for (x, y) in points {
            let place = (self.at.0 + self.scale * f64::from(*x), self.at.1 - self.scale * f64::from(*y));
            self.data.push_str(&format!("{} {} ", coordinate(place.0), coordinate(place.1)));
        }
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.command('M', &[(x, y)]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.command('L', &[(x, y)]);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.command('Q', &[(x1, y1), (x, y)]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.command('C', &[(x1, y1), (x2, y2), (x, y)]);
    }

    fn close(&mut self) {
        self.data.push('Z');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_overlap_by_a_command_and_lose_none() {
        let points: Vec<String> = (1..1000).map(|x| format!("L{x} 1")).collect();
        let parts = parts(&format!("M0 1{}", points.concat()));
        let commands: Vec<usize> = parts.iter().map(|part| part.matches('L').count()).collect();
        assert_eq!(commands, [256, 256, 256, 234]);
        assert!(parts[0].starts_with("M0 1L1 1L2 1") && parts[0].ends_with("L256 1"));
        assert!(parts[1].starts_with("M255 1L256 1L257 1"));
        assert!(parts[3].ends_with("L999 1"));
    }
}
