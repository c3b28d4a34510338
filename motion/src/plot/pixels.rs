//! The backend for pixels: that of the plotting library, with texts and lines as an SVG has them.
//!
//! The library leaves out the room that letters have on their left, and sets them higher than in an SVG; and where a line
//! crosses itself, it leaves a hole.

use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, Glyph, OutlinedGlyph, PxScaleFont, ScaleFont, point};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::rasterizer::polygonize;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind};

use super::canvas::{BASE_BELOW_MIDDLE, BASE_BELOW_TOP, EM};

/// DejaVu Sans, regular and bold.
static FACES: LazyLock<[Option<FontRef<'static>>; 2]> =
    LazyLock::new(|| [dejavu::sans::regular(), dejavu::sans::bold()].map(|bytes| FontRef::try_from_slice(bytes).ok()));

/// The pixels.
pub(super) struct Pixels<'a>(pub BitMapBackend<'a>);

type Outcome<'a> = Result<(), DrawingErrorKind<<BitMapBackend<'a> as DrawingBackend>::ErrorType>>;

impl<'a> DrawingBackend for Pixels<'a> {
    type ErrorType = <BitMapBackend<'a> as DrawingBackend>::ErrorType;

    fn get_size(&self) -> (u32, u32) {
        self.0.get_size()
    }

    fn ensure_prepared(&mut self) -> Outcome<'a> {
        self.0.ensure_prepared()
    }

    fn present(&mut self) -> Outcome<'a> {
        self.0.present()
    }

    fn draw_pixel(&mut self, at: BackendCoord, colour: BackendColor) -> Outcome<'a> {
        self.0.draw_pixel(at, colour)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Outcome<'a> {
        self.0.draw_line(from, to, style)
    }

    fn draw_rect<S: BackendStyle>(&mut self, a: BackendCoord, b: BackendCoord, style: &S, fill: bool) -> Outcome<'a> {
        self.0.draw_rect(a, b, style, fill)
    }

    /// Each stretch by itself, round where they meet.
    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Outcome<'a> {
        let (colour, width) = (style.color(), style.stroke_width());
        if colour.alpha == 0.0 {
            return Ok(());
        }
        let mut points: Vec<BackendCoord> = path.into_iter().collect();
        points.dedup();
        points.windows(2).try_for_each(|pair| self.fill_polygon(polygonize(pair, width), &colour))?;
        points.windows(3).try_for_each(|three| self.draw_circle(three[1], width / 2, &colour, true))
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Outcome<'a> {
        let is_bold = matches!(style.style(), FontStyle::Bold);
        let Some(face) = &FACES[usize::from(is_bold)] else { return Ok(()) };
        let em = (style.size() / EM) as f32;
        let face = face.as_scaled(em * face.height_unscaled() / face.units_per_em().unwrap_or(1.0));
        let base = match style.anchor().v_pos {
            VPos::Top => BASE_BELOW_TOP,
            VPos::Center => BASE_BELOW_MIDDLE,
            VPos::Bottom => -BASE_BELOW_MIDDLE,
        };
        let place = (at.0 as f32, at.1 as f32 + em * base as f32);
        set(&face, text, place, style.anchor().h_pos).try_for_each(|letter| self.letter(&letter, style.color()))
    }
}

impl<'a> Pixels<'a> {
    fn letter(&mut self, letter: &OutlinedGlyph, colour: BackendColor) -> Outcome<'a> {
        let corner = letter.px_bounds().min;
        let mut covered = Vec::new();
        letter.draw(|x, y, share| covered.push((corner.x as i32 + x as i32, corner.y as i32 + y as i32, share)));
        covered.into_iter().try_for_each(|(x, y, share)| self.draw_pixel((x, y), colour.mix(f64::from(share))))
    }
}

/// The letters of a text at their places.
fn set(
    face: &PxScaleFont<&FontRef<'static>>,
    text: &str,
    (x, y): (f32, f32),
    side: HPos,
) -> impl Iterator<Item = OutlinedGlyph> {
    let mut letters: Vec<Glyph> = Vec::new();
    let mut width = 0.0;
    for character in text.chars() {
        let mut letter = face.scaled_glyph(character);
        width += letters.last().map_or(0.0, |before| face.kern(before.id, letter.id));
        letter.position = point(width, y);
        width += face.h_advance(letter.id);
        letters.push(letter);
    }
    let left = match side {
        HPos::Left => x,
        HPos::Center => x - width / 2.0,
        HPos::Right => x - width,
    };
    letters.into_iter().filter_map(move |mut letter| {
        letter.position.x += left;
        face.outline_glyph(letter)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::canvas::{Canvas, Font};

    const SIDE: u32 = 60;

    /// Which pixels are black when this is drawn on white.
    fn black(draw: impl FnOnce(&mut Pixels)) -> Vec<(u32, u32)> {
        let mut buffer = vec![255; (3 * SIDE * SIDE) as usize];
        draw(&mut Pixels(BitMapBackend::with_buffer(&mut buffer, (SIDE, SIDE))));
        let places = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
        places.filter(|(x, y)| buffer[(3 * (y * SIDE + x)) as usize] < 64).collect()
    }

    #[test]
    fn a_line_that_crosses_itself_has_no_hole() {
        let path = [(5, 5), (55, 55), (55, 5), (5, 55)];
        let pixels = black(|pixels| pixels.draw_path(path, &ShapeStyle::from(BLACK).stroke_width(8)).expect("drawn"));
        assert!((28..33).all(|x| (28..33).all(|y| pixels.contains(&(x, y)))), "a hole");
    }

    #[test]
    fn letters_keep_the_room_on_their_left_and_stand_on_the_base_line() {
        let font = Font { size: 40.0, bold: false, colour: "#000000" };
        let canvas = Canvas::pixels(1.0);
        let pixels = black(|pixels| {
            let style = canvas.text(font, HPos::Left);
            pixels.draw_text("H", &style, (10, 50 - canvas.top(font))).expect("drawn");
        });
        // Of DejaVu Sans: 201/2048 of 40 on the left, and 1493/2048 high.
        let left = pixels.iter().map(|(x, _)| *x).min().expect("letters");
        let (top, bottom) = (pixels.iter().map(|(_, y)| *y).min(), pixels.iter().map(|(_, y)| *y).max());
        assert!((13..=15).contains(&left), "{left}");
        assert!((20..=22).contains(&top.expect("a top")) && (48..=50).contains(&bottom.expect("a base")));
    }
}
