//! Words beside what they name.

use std::f64::consts::PI;

use plotters::prelude::{EmptyElement, RGBColor, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::{Chart, Drawn, FINE, text};

/// Words at a point, moved by whole pixels to the right and down; they begin there, or end there if moved to the left.
pub fn label(chart: &Chart<'_>, at: (f64, f64), moved: (i32, i32), words: &str, colour: RGBColor) -> Drawn {
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
pub fn name_ends(chart: &Chart<'_>, mut ends: Vec<((f64, f64), &str, RGBColor)>) -> Drawn {
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
pub fn name_column(chart: &Chart<'_>, corner: (f64, f64), names: &[(&str, RGBColor)]) -> Drawn {
    for (row, (name, colour)) in (0..).zip(names) {
        label(chart, corner, (10, 14 + 20 * row), name, *colour)?;
    }
    Ok(())
}

/// Words beside points, each at the nearest place around its point where no line and no other words are.
///
/// `lines` are the points of the lines, close together.
pub fn label_clear(chart: &Chart<'_>, lines: &[(f64, f64)], labels: &[((f64, f64), String, RGBColor)]) -> Drawn {
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
