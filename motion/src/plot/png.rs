//! A drawing as PNG.

use plotters::prelude::BitMapBackend;

use super::canvas::Canvas;
use super::drawing::Drawing;
use super::error::PlotError;
use super::pixels::Pixels;

/// Pixels of the PNG a pixel of the SVG: sharp in print and on dense screens.
const SCALE: u32 = 2;

/// It is drawn so many times larger and then made smaller, so that lines may begin between pixels.
const FINE: u32 = 4;

/// A PNG of more pixels would not fit into memory.
const MOST: f64 = 1e7;

impl Drawing {
    /// As the bytes of a PNG, two pixels a pixel of the SVG.
    ///
    /// # Errors
    ///
    /// The picture is too large.
    pub fn png(&self) -> Result<Vec<u8>, PlotError> {
        let (width, height) = self.sheet.size();
        if width * height * f64::from(SCALE * SCALE) > MOST {
            return Err(PlotError::Png { why: "it is too large".to_owned() });
        }
        let canvas = Canvas::pixels(f64::from(SCALE * FINE));
        let (wide, high) = canvas.size((width, height));
        let mut pixels = vec![0; 3 * wide as usize * high as usize];
        self.sheet.draw(Pixels(BitMapBackend::with_buffer(&mut pixels, (wide, high))), &canvas)?;
        encode((wide / FINE, high / FINE), &smaller(&pixels, wide as usize, FINE as usize))
    }
}

/// The means of squares of so many pixels each way.
fn smaller(pixels: &[u8], width: usize, side: usize) -> Vec<u8> {
    let mut small = Vec::with_capacity(pixels.len() / (side * side));
    for rows in pixels.chunks_exact(3 * width * side) {
        for column in (0..width).step_by(side) {
            for colour in 0..3 {
                let square = (0..side * side).map(|at| 3 * (at / side * width + column + at % side) + colour);
                let sum: usize = square.map(|at| usize::from(rows[at])).sum();
                small.push(((sum + side * side / 2) / (side * side)) as u8);
            }
        }
    }
    small
}

fn encode((width, height): (u32, u32), pixels: &[u8]) -> Result<Vec<u8>, PlotError> {
    let error = |error: png::EncodingError| PlotError::Png { why: error.to_string() };
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().map_err(error)?;
    writer.write_image_data(pixels).map_err(error)?;
    writer.finish().map_err(error)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_become_their_mean() {
        // Two by two pixels beside two by two others.
        let row = [[10, 20, 30], [30, 20, 10], [0, 0, 255], [0, 0, 255]].concat();
        assert_eq!(smaller(&[row.clone(), row].concat(), 4, 2), [20, 20, 20, 0, 0, 255]);
    }
}
