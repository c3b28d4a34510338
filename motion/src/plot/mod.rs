//! Pictures: position, velocity, acceleration and jerk over time with their limits, and the path in the plane.
//!
//! A [`Picture`] shows a motion, a [`Chart`] any curves; both make a [`Drawing`], which is SVG or PNG; a
//! [`Page`] is HTML that can be zoomed and read. Frames, grids,
//! ticks, lines and texts are drawn by plotters; here is what they show, and where. Jumps are drawn as steps.

mod canvas;
mod chart;
mod curve;
mod drawing;
mod error;
mod file;
mod frame;
mod html;
mod limit;
mod page;
mod path;
mod picture;
#[cfg(feature = "png")]
mod pixels;
#[cfg(feature = "png")]
mod png;
mod quantity;
mod scale;
mod sheet;
mod theme;
mod tool_path;
mod unit;

pub use chart::{Chart, Series};
pub use drawing::Drawing;
pub use error::PlotError;
pub use html::{Page, PageCurve, PageLimit, PageMark, PagePanel};
pub use picture::{Mark, Panel, Picture};
pub use theme::Theme;
pub use tool_path::{Colouring, ToolPath};
pub use unit::with_unit;
