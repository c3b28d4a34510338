//! A panel: its frame with grid, ticks and numbers, and what is drawn in it.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Font, clean, rgb};
use super::scale::Scale;
use super::theme::Theme;
use plotters::prelude::DrawingAreaErrorKind as AreaError;

/// Of all pictures, in pixels of the SVG: on a phone of 360 pixels the smallest letters are then 9 pixels high.
pub(super) const WIDTH: f64 = 480.0;
/// Left of a frame, for its numbers.
pub(super) const LEFT: f64 = 62.0;
/// Right of a frame, for half of the last number below it.
pub(super) const RIGHT: f64 = 28.0;
/// How wide a frame is.
pub(super) const INSIDE: f64 = WIDTH - LEFT - RIGHT;
/// Above a frame, for its title.
pub(super) const HEAD: f64 = 32.0;
/// Below a frame that has numbers and their title there.
pub(super) const FOOT: f64 = 44.0;

/// Sizes of fonts.
pub(super) const LABEL: f64 = 15.0;
pub(super) const NUMBER: f64 = 13.5;
pub(super) const NOTE: f64 = 12.5;

/// Length of a dash and of the gap behind it.
const DASHES: (f64, f64) = (10.0, 7.0);

/// Length of the ticks in a frame where segments meet.
const MEETING: f64 = 4.0;

/// A panel and what is in it, in the units of its scales.
#[derive(Clone)]
pub(super) struct Frame {
    pub title: String,
    /// On the right above it.
    pub note: String,
    pub height: f64,
    pub x: Scale,
    pub y: Scale,
    /// What the numbers below it say, which are there if this is.
    pub below: Option<String>,
    /// Where segments meet.
    pub meetings: Vec<f64>,
    pub lines: Vec<Line>,
    pub dots: Vec<Dot>,
    pub arrows: Vec<Arrow>,
    pub labels: Vec<Label>,
}

/// A curve, or a limit.
#[derive(Debug, Clone)]
pub(super) struct Line {
    pub points: Vec<(f64, f64)>,
    pub colour: &'static str,
    pub width: f64,
    pub is_dashed: bool,
}

/// The head of an arrow on a curve: the middle of it, and where it points, as a step of pixels to the right and down.
#[derive(Debug, Clone)]
pub(super) struct Arrow {
    pub at: (f64, f64),
    pub step: (f64, f64),
    pub colour: &'static str,
}

/// A ring, filled.
#[derive(Debug, Clone)]
pub(super) struct Dot {
    pub at: (f64, f64),
    pub radius: f64,
    pub ring: (&'static str, f64),
    pub fill: &'static str,
}

/// A text beside a point.
#[derive(Clone)]
pub(super) struct Label {
    pub at: (f64, f64),
    /// From the point to the base line, in pixels of the SVG.
    pub offset: (f64, f64),
    pub side: HPos,
    pub font: Font,
    pub text: String,
}

type Area<DB> = DrawingArea<DB, Shift>;
type Chart<'a, DB> = ChartContext<'a, DB, Cartesian2d<Scale, Scale>>;
type Outcome<DB> = Result<(), AreaError<<DB as DrawingBackend>::ErrorType>>;

impl Frame {
    /// How high it is with its title and what is below it.
    pub(super) fn room(&self) -> f64 {
        HEAD + self.height + if self.below.is_some() { FOOT } else { 0.0 }
    }

    /// Draws it into its part of the picture.
    pub(super) fn draw<DB: DrawingBackend>(&self, area: &Area<DB>, canvas: &Canvas, theme: &Theme) -> Outcome<DB> {
        let mut builder = ChartBuilder::on(area);
        builder.margin_top(canvas.length(HEAD)).margin_right(canvas.length(RIGHT));
        builder.y_label_area_size(canvas.length(LEFT));
        if self.below.is_some() {
            builder.x_label_area_size(canvas.length(FOOT));
        }
        let mut chart = builder.build_cartesian_2d(self.x.clone(), self.y.clone())?;
        self.grid(&mut chart, canvas, theme)?;
        self.lines(&mut chart, canvas)?;
        self.points(&mut chart, canvas)?;
        self.titles(area, canvas, theme)
    }

    /// Grid, numbers and the frame itself.
    fn grid<DB: DrawingBackend>(&self, chart: &mut Chart<DB>, canvas: &Canvas, theme: &Theme) -> Outcome<DB> {
        let numbers = Font { size: NUMBER, bold: false, colour: theme.muted };
        let title = Font { size: LABEL, bold: true, colour: theme.text };
        let (thin, thick) = (canvas.line(theme.grid, 1.0), canvas.line(theme.frame, 1.0));
        let mut mesh = chart.configure_mesh();
        mesh.bold_line_style(thin).max_light_lines(0).axis_style(TRANSPARENT);
        mesh.x_labels(self.x.ticks().max(1)).y_labels(self.y.ticks().max(1));
        mesh.label_style(canvas.text(numbers, HPos::Center)).axis_desc_style(canvas.text(title, HPos::Center));
        mesh.y_label_offset(canvas.sunk(numbers));
        mesh.set_tick_mark_size(LabelAreaPosition::Left, canvas.length(4.0));
        mesh.set_tick_mark_size(LabelAreaPosition::Bottom, (canvas.length(18.0) - canvas.top(numbers)) / 2);
        if let Some(below) = &self.below {
            mesh.x_desc(clean(below));
        }
        mesh.draw()?;
        let (x, y) = (self.x.range(), self.y.range());
        let ends = |at: &f64| [(*at, y.start, -1.0), (*at, y.end, 1.0)];
        let tick = |(at, edge, down): (f64, f64, f64)| {
            EmptyElement::at((at, edge)) + PathElement::new([(0, 0), (0, canvas.length(down * MEETING))], thick)
        };
        chart.draw_series(self.meetings.iter().flat_map(ends).map(tick))?;
        let zero = self.y.has_zero().then(|| PathElement::new([(x.start, 0.0), (x.end, 0.0)], thick));
        chart.draw_series(zero)?;
        let corners = [(x.start, y.start), (x.start, y.end), (x.end, y.end), (x.end, y.start), (x.start, y.start)];
        chart.draw_series([PathElement::new(corners, thick)])?;
        Ok(())
    }

    fn lines<DB: DrawingBackend>(&self, chart: &mut Chart<DB>, canvas: &Canvas) -> Outcome<DB> {
        for line in &self.lines {
            let (points, style) = (line.points.iter().copied(), canvas.line(line.colour, line.width));
            if line.is_dashed {
                let (dash, gap) = (canvas.length(DASHES.0), canvas.length(DASHES.1));
                chart.draw_series(DashedLineSeries::new(points, dash, gap, style))?;
            } else {
                chart.draw_series(LineSeries::new(points, style))?;
            }
        }
        Ok(())
    }

    fn points<DB: DrawingBackend>(&self, chart: &mut Chart<DB>, canvas: &Canvas) -> Outcome<DB> {
        for arrow in &self.arrows {
            let (x, y) = arrow.step;
            let corner =
                |along: f64, aside: f64| (canvas.length(along * x - aside * y), canvas.length(along * y + aside * x));
            let corners = vec![corner(6.0, 0.0), corner(-5.0, 4.5), corner(-5.0, -4.5)];
            let style = rgb(arrow.colour).filled();
            chart.draw_series([EmptyElement::at(arrow.at) + Polygon::new(corners, style)])?;
        }
        for Dot { at, radius, ring: (colour, width), fill } in &self.dots {
            let disc = |radius: f64, colour| Circle::new(*at, canvas.length(radius), rgb(colour).filled());
            chart.draw_series([disc(radius + width / 2.0, colour), disc(radius - width / 2.0, fill)])?;
        }
        for label in &self.labels {
            let place = (canvas.length(label.offset.0), canvas.length(label.offset.1) - canvas.top(label.font));
            let text = Text::new(clean(&label.text), place, canvas.text(label.font, label.side));
            chart.draw_series([EmptyElement::at(label.at) + text])?;
        }
        Ok(())
    }

    /// Its title on the left and its note on the right.
    fn titles<DB: DrawingBackend>(&self, area: &Area<DB>, canvas: &Canvas, theme: &Theme) -> Outcome<DB> {
        let title = Font { size: LABEL, bold: true, colour: theme.text };
        let note = Font { size: NOTE, bold: false, colour: theme.muted };
        for (text, font, side, x) in
            [(&self.title, title, HPos::Left, LEFT), (&self.note, note, HPos::Right, LEFT + INSIDE)]
        {
            if !text.is_empty() {
                let place = (canvas.length(x), canvas.length(HEAD - 9.0) - canvas.top(font));
                area.draw_text(&clean(text), &canvas.text(font, side), place)?;
            }
        }
        Ok(())
    }
}
