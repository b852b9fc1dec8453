//! Lines and dots.

use plotters::prelude::{Circle, Color, LineSeries, RGBColor};

use crate::{Chart, Drawn, FINE};

/// A line through points.
pub fn line(chart: &mut Chart<'_>, points: Vec<(f64, f64)>, colour: RGBColor, width: f64) -> Drawn {
    chart.draw_series(LineSeries::new(points, colour.stroke_width((width * f64::from(FINE)) as u32)))?;
    Ok(())
}

/// A dot at each point.
pub fn dots(chart: &mut Chart<'_>, points: &[(f64, f64)], colour: RGBColor, radius: f64) -> Drawn {
    let radius = (radius * f64::from(FINE)) as i32;
    chart.draw_series(points.iter().map(|&at| Circle::new(at, radius, colour.filled())))?;
    Ok(())
}
