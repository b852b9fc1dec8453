//! Axes with a title, to draw on.

use std::ops::Range;

use plotters::chart::ChartBuilder;
use plotters::prelude::{Color, SVGBackend, TRANSPARENT, TextStyle};

use crate::{Area, Axis, Chart, Drawn, FINE, INK, PALE, text};

/// Axes with a title; `right` pixels are left free beside them for labels.
pub fn chart<'a>(area: &Area<'a>, title: &str, x: Axis<'_>, y: Axis<'_>, right: u32) -> Drawn<Chart<'a>> {
    let area = area.titled(title, fitting(area, title, 17.0))?;
    let mut chart = builder(&area, right).build_cartesian_2d(x.range, y.range)?;
    chart
        .configure_mesh()
        .x_desc(x.name)
        .y_desc(y.name)
        .x_labels(x.marks)
        .y_labels(y.marks)
        .x_label_formatter(&*x.mark)
        .y_label_formatter(&*y.mark)
        .label_style(text(13.0, INK))
        .axis_desc_style(text(14.0, INK))
        .axis_style(INK.stroke_width(FINE))
        .bold_line_style(PALE.stroke_width(FINE / 2))
        .light_line_style(TRANSPARENT)
        .set_all_tick_mark_size(4 * FINE)
        .draw()?;
    Ok(chart)
}

/// A title over a line of smaller words, and what is left below them.
pub fn headed<'a>(area: &Area<'a>, title: &str, words: &str) -> Drawn<Area<'a>> {
    Ok(area.titled(title, fitting(area, title, 17.0))?.titled(words, fitting(area, words, 13.0))?)
}

/// As large as is asked for, or as there is room for.
fn fitting(area: &Area<'_>, words: &str, size: f64) -> TextStyle<'static> {
    let room = f64::from(area.dim_in_pixel().0) / f64::from(FINE);
    text(size.min(room / (0.56 * words.chars().count().max(1) as f64)), INK)
}

/// Axes with one scale, each as long as it is asked to be or longer.
pub fn equal_axes<'a>(area: &Area<'a>, title: &str, x: Axis<'_>, y: Axis<'_>, right: u32) -> Drawn<Chart<'a>> {
    let titled = area.titled("", text(17.0, INK))?;
    let empty = builder(&titled, right).build_cartesian_2d(0.0..1.0, 0.0..1.0)?;
    let (width, height) = empty.plotting_area().dim_in_pixel();
    let [width, height] = [width, height].map(f64::from);
    let scale = ((x.range.end - x.range.start) / width).max((y.range.end - y.range.start) / height);
    let about = |range: &Range<f64>, length: f64| {
        let (middle, half) = (0.5 * range.start + 0.5 * range.end, 0.5 * scale * length);
        middle - half..middle + half
    };
    let (across, up) = (about(&x.range, width), about(&y.range, height));
    chart(area, title, Axis { range: across, ..x }, Axis { range: up, ..y }, right)
}

fn builder<'a, 'b>(area: &'b Area<'a>, right: u32) -> ChartBuilder<'b, 'static, SVGBackend<'a>> {
    let mut builder = ChartBuilder::on(area);
    builder.margin(8 * FINE).margin_right(right * FINE).x_label_area_size(44 * FINE).y_label_area_size(66 * FINE);
    builder
}
