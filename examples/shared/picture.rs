//! Pictures of one style: white ground, muted colours, labels beside the lines that they name.
#![allow(dead_code, reason = "each example uses its part")]

use std::error::Error;
use std::f64::consts::PI;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Colours that stay apart for colour-blind readers and in print (P. Tol, "Colour schemes", SRON/EPS/TN/09-002, 2021).
pub(crate) const BLUE: RGBColor = RGBColor(68, 119, 170);
pub(crate) const RED: RGBColor = RGBColor(204, 102, 119);
pub(crate) const GREEN: RGBColor = RGBColor(34, 136, 51);
pub(crate) const OCHRE: RGBColor = RGBColor(190, 150, 40);
pub(crate) const PURPLE: RGBColor = RGBColor(136, 80, 150);
pub(crate) const INK: RGBColor = RGBColor(70, 70, 70);
pub(crate) const TEAL: RGBColor = RGBColor(0, 140, 150);
pub(crate) const PALE: RGBColor = RGBColor(215, 215, 215);

/// Drawn in units of a quarter pixel, since coordinates are whole numbers.
const FINE: u32 = 4;

pub(crate) type Drawn<T = ()> = Result<T, Box<dyn Error>>;
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub(crate) type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// Draws a picture of the given size in pixels into the build folder and tells where it is.
pub(crate) fn save(name: &str, [width, height]: [u32; 2], draw: impl FnOnce(&Area<'_>) -> Drawn) -> Drawn<PathBuf> {
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (FINE * width, FINE * height)).into_drawing_area();
        area.fill(&WHITE)?;
        draw(&area.margin(12 * FINE, 4 * FINE, 4 * FINE, 4 * FINE))?;
        area.present()?;
    }
    let units = format!("width=\"{}\" height=\"{}\"", FINE * width, FINE * height);
    let svg = svg.replacen(&units, &format!("width=\"{width}\" height=\"{height}\""), 1);
    let path = place(name)?;
    fs::write(&path, svg)?;
    Ok(path)
}

/// Where a file of the given name goes.
pub(crate) fn place(name: &str) -> io::Result<PathBuf> {
    Ok(folder()?.join(name))
}

/// `dmech/` in the build folder, which is the one above the program that has cargo's tag; else in the current folder.
fn folder() -> io::Result<PathBuf> {
    let program = env::current_exe()?;
    let here = env::current_dir()?;
    let target = program.ancestors().find(|folder| folder.join("CACHEDIR.TAG").is_file());
    let folder = target.unwrap_or(Path::new("")).join("dmech");
    fs::create_dir_all(&folder)?;
    Ok(folder.strip_prefix(here).map(Path::to_path_buf).unwrap_or(folder))
}

/// An axis: its name, and the range of its values, or of their decimal logarithms.
pub(crate) struct Axis<'a> {
    name: &'a str,
    range: Range<f64>,
    mark: fn(&f64) -> String,
    marks: usize,
}

impl<'a> Axis<'a> {
    pub(crate) fn linear(name: &'a str, range: Range<f64>) -> Self {
        Axis { name, range, mark: |x| format!("{}", (1e9 * x).round() / 1e9 + 0.0).replace('-', "−"), marks: 8 }
    }

    /// The points on it are decimal logarithms.
    pub(crate) fn powers_of_ten(name: &'a str, range: Range<f64>) -> Self {
        // Of more powers only every second, third … has room.
        let marks = ((range.end - range.start).ceil() as usize + 1).min(18);
        Axis { name, range, mark: power_of_ten, marks }
    }
}

fn power_of_ten(exponent: &f64) -> String {
    let superscript = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    format!("10{}", format!("{exponent:.0}").chars().map(superscript).collect::<String>())
}

/// Axes with a title; `right` pixels are left free beside them for labels.
pub(crate) fn chart<'a>(area: &Area<'a>, title: &str, x: Axis<'_>, y: Axis<'_>, right: u32) -> Drawn<Chart<'a>> {
    let area = area.titled(title, text(17.0, INK))?;
    let mut chart = builder(&area, right).build_cartesian_2d(x.range, y.range)?;
    chart
        .configure_mesh()
        .x_desc(x.name)
        .y_desc(y.name)
        .x_labels(x.marks)
        .y_labels(y.marks)
        .x_label_formatter(&x.mark)
        .y_label_formatter(&y.mark)
        .label_style(text(13.0, INK))
        .axis_desc_style(text(14.0, INK))
        .axis_style(INK.stroke_width(FINE))
        .bold_line_style(PALE.stroke_width(FINE / 2))
        .light_line_style(TRANSPARENT)
        .set_all_tick_mark_size(4 * FINE)
        .draw()?;
    Ok(chart)
}

/// Axes with one scale: the height that belongs to a width, around y = 0.
pub(crate) fn equal_chart<'a>(area: &Area<'a>, title: &str, x: Range<f64>) -> Drawn<Chart<'a>> {
    equal_chart_about(area, title, x, 0.0)
}

/// The same around another y.
pub(crate) fn equal_chart_about<'a>(area: &Area<'a>, title: &str, x: Range<f64>, middle: f64) -> Drawn<Chart<'a>> {
    equal_chart_beside(area, title, x, middle, 10)
}

/// The same with `right` pixels left free for labels.
pub(crate) fn equal_chart_beside<'a>(
    area: &Area<'a>,
    title: &str,
    x: Range<f64>,
    middle: f64,
    right: u32,
) -> Drawn<Chart<'a>> {
    let titled = area.titled("", text(17.0, INK))?;
    let empty = builder(&titled, right).build_cartesian_2d(0.0..1.0, 0.0..1.0)?;
    let (width, height) = empty.plotting_area().dim_in_pixel();
    let half = 0.5 * (x.end - x.start) * f64::from(height) / f64::from(width);
    chart(area, title, Axis::linear("x", x), Axis::linear("y", middle - half..middle + half), right)
}

fn builder<'a, 'b>(area: &'b Area<'a>, right: u32) -> ChartBuilder<'b, 'static, SVGBackend<'a>> {
    let mut builder = ChartBuilder::on(area);
    builder.margin(8 * FINE).margin_right(right * FINE).x_label_area_size(44 * FINE).y_label_area_size(66 * FINE);
    builder
}

/// A line through points.
pub(crate) fn line(chart: &mut Chart<'_>, points: Vec<(f64, f64)>, colour: RGBColor, width: f64) -> Drawn {
    chart.draw_series(LineSeries::new(points, colour.stroke_width((width * f64::from(FINE)) as u32)))?;
    Ok(())
}

/// A dot at each point.
pub(crate) fn dots(chart: &mut Chart<'_>, points: &[(f64, f64)], colour: RGBColor, radius: f64) -> Drawn {
    let radius = (radius * f64::from(FINE)) as i32;
    chart.draw_series(points.iter().map(|&at| Circle::new(at, radius, colour.filled())))?;
    Ok(())
}

/// Words at a point, moved by whole pixels to the right and down; they begin there, or end there if moved to the left.
pub(crate) fn label(chart: &Chart<'_>, at: (f64, f64), moved: (i32, i32), words: &str, colour: RGBColor) -> Drawn {
    let side = match moved.0 {
        0 => HPos::Center,
        1.. => HPos::Left,
        _ => HPos::Right,
    };
    let style = text(14.0, colour).pos(Pos::new(side, VPos::Center));
    let fine = FINE as i32;
    let words = Text::new(words.to_owned(), (moved.0 * fine, moved.1 * fine), style);
    chart.plotting_area().draw(&(EmptyElement::at(at) + words))?;
    Ok(())
}

/// Names at the right ends of lines, pushed apart where they would overlap.
pub(crate) fn name_ends(chart: &Chart<'_>, mut ends: Vec<((f64, f64), &str, RGBColor)>) -> Drawn {
    ends.sort_by(|a, b| b.0.1.total_cmp(&a.0.1));
    let mut lowest = i32::MIN;
    for (at, name, colour) in ends {
        let height = chart.backend_coord(&at).1 / FINE as i32;
        lowest = height.max(lowest.saturating_add(18));
        label(chart, at, (8, lowest - height), name, colour)?;
    }
    Ok(())
}

/// Names of lines in a column to the right of the corner of a chart, for lines that end anywhere.
pub(crate) fn name_column(chart: &Chart<'_>, corner: (f64, f64), names: &[(&str, RGBColor)]) -> Drawn {
    for (row, (name, colour)) in (0..).zip(names) {
        label(chart, corner, (10, 14 + 20 * row), name, *colour)?;
    }
    Ok(())
}

/// Words beside points, each at the nearest place around its point where no line and no other words are.
///
/// `lines` are the points of the lines, close together.
pub(crate) fn label_clear(chart: &Chart<'_>, lines: &[(f64, f64)], labels: &[((f64, f64), String, RGBColor)]) -> Drawn {
    let pixels = |at: &(f64, f64)| {
        let (x, y) = chart.backend_coord(at);
        (f64::from(x) / f64::from(FINE), f64::from(y) / f64::from(FINE))
    };
    let lines: Vec<_> = lines.iter().map(pixels).collect();
    let mut placed: Vec<((f64, f64), f64)> = Vec::new();
    for (at, words, colour) in labels {
        let (x, y) = pixels(at);
        let half = 4.0 * words.chars().count() as f64 + 2.0;
        let clutter = |(dx, dy): &(i32, i32)| {
            let centre = (x + f64::from(*dx), y + f64::from(*dy));
            let away = |other: (f64, f64), half: f64, high: f64| {
                (other.0 - centre.0).abs() > half || (other.1 - centre.1).abs() > high
            };
            let on_lines = lines.iter().filter(|&&point| !away(point, half, 9.0)).count();
            let on_words = placed.iter().filter(|(point, other)| !away(*point, half + other, 16.0)).count();
            on_lines + 1000 * on_words
        };
        let around = (12..48).step_by(4).flat_map(|radius| (0..16).map(move |turn| (radius, turn)));
        let places = around.map(|(radius, turn)| {
            let (sin, cos) = (0.125 * PI * f64::from(turn)).sin_cos();
            let radius = f64::from(radius);
            (((radius + half - 8.0) * cos).round() as i32, (-radius * sin).round() as i32)
        });
        let moved = places.min_by_key(clutter).unwrap_or_default();
        placed.push(((x + f64::from(moved.0), y + f64::from(moved.1)), half));
        centred(chart, *at, moved, words, *colour)?;
    }
    Ok(())
}

fn centred(chart: &Chart<'_>, at: (f64, f64), (dx, dy): (i32, i32), words: &str, colour: RGBColor) -> Drawn {
    let style = text(14.0, colour).pos(Pos::new(HPos::Center, VPos::Center));
    let fine = FINE as i32;
    chart.plotting_area().draw(&(EmptyElement::at(at) + Text::new(words.to_owned(), (dx * fine, dy * fine), style)))?;
    Ok(())
}

fn text(size: f64, colour: RGBColor) -> TextStyle<'static> {
    // The backend divides font sizes by 1.24.
    ("sans-serif", 1.24 * size * f64::from(FINE)).into_font().color(&colour)
}
