//! Lines and dots.

use plotters::prelude::{Circle, Color, DashedLineSeries, LineSeries, RGBColor, Rectangle, ShapeStyle};

use crate::thin::{Seen, thin};
use crate::window::Window;
use crate::{Chart, Drawn, FINE};

/// The points that a line keeps: in a file less than a megabyte.
const MOST: usize = 60_000;

/// A line through points.
///
/// Points that are no finite numbers interrupt it, and what lies outside the axes is not drawn. Of very many points those are left out
/// that leave no mark, so that a picture of a million states is no larger than a megabyte; where lines stand close, they are then as wide
/// as what is left out.
pub fn line(chart: &mut Chart<'_>, points: Vec<(f64, f64)>, colour: RGBColor, width: f64) -> Drawn {
    lines(chart, &[points], colour, width, MOST)
}

/// Several of one colour, which together keep at most about so many points.
pub fn lines(chart: &mut Chart<'_>, lines: &[Vec<(f64, f64)>], colour: RGBColor, width: f64, most: usize) -> Drawn {
    let within = Window::of(chart);
    let lines: Vec<_> = lines.iter().flat_map(|line| within.pieces(line)).collect();
    let (size, at) = pixels(chart);
    let fine: Vec<Vec<_>> = lines.iter().map(|line| line.iter().map(&at).collect()).collect();
    let (parts, covering) = thin(&fine, size, most);
    let style = colour.stroke_width((width.max(covering) * f64::from(FINE)) as u32);
    for (which, part) in parts {
        chart.draw_series(LineSeries::new(part.into_iter().map(|i| lines[which][i]), style))?;
    }
    Ok(())
}

/// A dashed line through points, over another that runs the same way and is to be seen.
pub fn dashed(chart: &mut Chart<'_>, points: Vec<(f64, f64)>, colour: RGBColor, width: f64) -> Drawn {
    let style = colour.stroke_width((width * f64::from(FINE)) as u32);
    for piece in Window::of(chart).pieces(&points) {
        chart.draw_series(DashedLineSeries::new(piece, 7 * FINE, 7 * FINE, style))?;
    }
    Ok(())
}

/// A dot at each point that lies between the axes.
pub fn dots(chart: &mut Chart<'_>, points: &[(f64, f64)], colour: RGBColor, radius: f64) -> Drawn {
    circles(chart, points, radius, colour.filled())
}

/// An open circle at each point.
pub fn rings(chart: &mut Chart<'_>, points: &[(f64, f64)], colour: RGBColor, radius: f64) -> Drawn {
    circles(chart, points, radius, colour.stroke_width(3 * FINE / 2))
}

fn circles(chart: &mut Chart<'_>, points: &[(f64, f64)], radius: f64, style: ShapeStyle) -> Drawn {
    let radius = (radius * f64::from(FINE)) as i32;
    chart.draw_series(Window::of(chart).points(points).map(|at| Circle::new(at, radius, style)))?;
    Ok(())
}

/// A square at each point, with sides of twice the radius.
pub fn squares(chart: &mut Chart<'_>, points: &[(f64, f64)], colour: RGBColor, radius: f64) -> Drawn {
    let radius = (radius * f64::from(FINE)) as i32;
    let square = [(-radius, -radius), (radius, radius)];
    let within = Window::of(chart);
    chart.draw_series(
        within
            .points(points)
            .map(|at| plotters::element::EmptyElement::at(at) + Rectangle::new(square, colour.filled())),
    )?;
    Ok(())
}

/// Of points that are to be drawn as dots, at most so many: those that hide each other first.
pub fn apart(chart: &Chart<'_>, points: &[(f64, f64)], most: usize) -> Vec<(f64, f64)> {
    let (size, at) = pixels(chart);
    let mut pixel = 1.0;
    loop {
        let mut seen = Seen::new(size, pixel);
        let apart: Vec<_> = finite(points).filter(|point| seen.mark(at(point))).collect();
        if apart.len() <= most || pixel > 64.0 {
            return apart;
        }
        pixel *= 1.3;
    }
}

fn finite(points: &[(f64, f64)]) -> impl Iterator<Item = (f64, f64)> + '_ {
    points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite())
}

/// The size of a chart in pixels, and where its points are in it.
pub(crate) fn pixels<'a>(chart: &Chart<'a>) -> ([f64; 2], impl Fn(&(f64, f64)) -> [f64; 2] + use<'a>) {
    let area = chart.plotting_area();
    let (width, height) = area.dim_in_pixel();
    let (x, y) = (area.get_x_range(), area.get_y_range());
    let size = [width, height].map(|length| f64::from(length) / f64::from(FINE));
    let at = move |point: &(f64, f64)| {
        let part = [(point.0 - x.start) / (x.end - x.start), (y.end - point.1) / (y.end - y.start)];
        [part[0] * size[0], part[1] * size[1]]
    };
    (size, at)
}
