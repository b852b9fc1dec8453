//! Pictures of one style for [dmech](https://docs.rs/dmech): white ground, muted colours, labels beside the lines that they name.
//!
//! A picture is text (SVG), drawn by [plotters], whose own elements may be drawn on a [`Chart`] as well:
//!
//! ```
//! use dmech_plot::{Axis, BLUE, chart, draw, label, line};
//!
//! let svg = draw([600, 400], |area| {
//!     let mut chart = chart(area, "A wave", Axis::linear("t", 0.0..6.3), Axis::linear("x", -1.2..1.2), 60)?;
//!     let wave = (0..=63).map(|k| 0.1 * f64::from(k)).map(|t| (t, t.sin()));
//!     line(&mut chart, wave.collect(), BLUE, 1.5)?;
//!     label(&chart, (6.3, 0.0), (8, 0), "sin t", BLUE)
//! })?;
//! assert!(svg.starts_with("<svg") && svg.contains("A wave"));
//! # Ok::<(), std::io::Error>(())
//! ```
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

mod axis;
mod chart;
mod colour;
mod fit;
mod labels;
mod marks;
mod number;
mod thin;
mod window;

pub use axis::Axis;
pub use chart::{chart, equal_axes, headed};
pub use colour::{BLUE, GREEN, INK, OCHRE, PALE, PURPLE, RED, TEAL};
pub use fit::Fit;
pub use labels::{label, label_beside, label_clear, name_column, name_ends};
pub use marks::{apart, dashed, dots, line, lines, rings, squares};
pub use number::{count, number, power, rough, span};
pub use plotters;

use std::error::Error;
use std::io;
use std::path::Path;

use plotters::chart::ChartContext;
use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{Cartesian2d, DrawingArea, IntoDrawingArea, IntoFont, RGBColor, SVGBackend, TextStyle, WHITE};

/// Drawn in units of a quarter pixel, since coordinates are whole numbers.
pub(crate) const FINE: u32 = 4;

/// What drawing gives.
pub type Drawn<T = ()> = Result<T, Box<dyn Error>>;
/// The ground of a picture, or a part of it.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// Axes, and what is drawn between them.
pub type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// A picture of the given size in pixels, as SVG.
///
/// # Errors
/// What `onto` could not draw.
pub fn draw([width, height]: [u32; 2], onto: impl FnOnce(&Area<'_>) -> Drawn) -> io::Result<String> {
    let mut svg = String::new();
    let fine = [FINE * width, FINE * height];
    drawn(&mut svg, fine, onto).map_err(|error| io::Error::other(error.to_string()))?;
    let units = format!("width=\"{}\" height=\"{}\"", fine[0], fine[1]);
    Ok(svg.replacen(&units, &format!("width=\"{width}\" height=\"{height}\""), 1))
}

/// Writes a picture into a file.
///
/// # Errors
/// [`InvalidInput`](io::ErrorKind::InvalidInput) where the name of the file promises a picture of another kind; those of the file.
pub fn save(path: impl AsRef<Path>, svg: &str) -> io::Result<()> {
    let path = path.as_ref();
    let kind = path.extension().and_then(|kind| kind.to_str()).map(str::to_lowercase);
    if let Some(kind @ ("png" | "jpg" | "jpeg" | "gif" | "webp" | "bmp" | "pdf" | "ps" | "eps")) = kind.as_deref() {
        let name = path.with_extension("svg");
        let says = format!("pictures are written as SVG, not as {}: name it {}", kind.to_uppercase(), name.display());
        return Err(io::Error::new(io::ErrorKind::InvalidInput, says));
    }
    fs_err::write(path, svg)
}

fn drawn(svg: &mut String, [width, height]: [u32; 2], onto: impl FnOnce(&Area<'_>) -> Drawn) -> Drawn {
    let area = SVGBackend::with_string(svg, (width, height)).into_drawing_area();
    area.fill(&WHITE)?;
    onto(&area.margin(12 * FINE, 4 * FINE, 4 * FINE, 4 * FINE))?;
    area.present()?;
    Ok(())
}

pub(crate) fn text(size: f64, colour: RGBColor) -> TextStyle<'static> {
    // The backend divides font sizes by 1.24.
    ("sans-serif", 1.24 * size * f64::from(FINE)).into_font().color(&colour)
}
