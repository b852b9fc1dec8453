//! Words beside what they name.

use std::f64::consts::PI;

use plotters::prelude::{Color, EmptyElement, RGBColor, Rectangle, Text, WHITE};
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::marks::pixels;
use crate::thin::Seen;
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
    let points: Vec<_> = lines.iter().map(|&point| vec![point]).collect();
    label_beside(chart, &points, labels)
}

/// The same beside lines through points that may be far apart. No words stand outside of the chart.
pub fn label_beside(chart: &Chart<'_>, lines: &[Vec<(f64, f64)>], labels: &[((f64, f64), String, RGBColor)]) -> Drawn {
    let (size, pixel) = pixels(chart);
    let mut drawn = Seen::new(size, 2.0);
    for line in lines {
        if let Some(first) = line.first() {
            drawn.mark(pixel(first));
        }
        for ends in line.windows(2) {
            drawn.draw(pixel(&ends[0]), pixel(&ends[1]));
        }
    }
    let mut placed: Vec<([f64; 2], f64)> = Vec::new();
    for (at, words, colour) in labels {
        let [x, y] = pixel(at);
        let half = half_width(words);
        let clutter = |&(dx, dy): &(i32, i32)| {
            let [x, y] = [x + f64::from(dx), y + f64::from(dy)];
            let away = |other: &[f64; 2], with: f64| (other[0] - x).abs() > half + with || (other[1] - y).abs() > 16.0;
            let on_lines = drawn.within([x - half, x + half], [y - 9.0, y + 9.0]);
            let on_words = placed.iter().filter(|(point, other)| !away(point, *other)).count();
            let outside = x - half < 2.0 || x + half > size[0] - 2.0 || y < 9.0 || y > size[1] - 9.0;
            on_lines + 2000 * on_words + 4000 * usize::from(outside)
        };
        let around = (12..64).step_by(4).flat_map(|radius| (0..16).map(move |turn| (radius, turn)));
        let places = around.map(|(radius, turn)| {
            let (sin, cos) = (0.125 * PI * f64::from(turn)).sin_cos();
            let radius = f64::from(radius);
            (((radius + half - 8.0) * cos).round() as i32, (-radius * sin).round() as i32)
        });
        let moved = places.min_by_key(clutter).unwrap_or_default();
        if clutter(&moved) > 0 {
            // There is no clear place: the words make one.
            let fine = f64::from(FINE);
            let corner = |side: f64| {
                let [dx, dy] = [f64::from(moved.0) + side * half, f64::from(moved.1) + side * 9.0];
                ((fine * dx) as i32, (fine * dy) as i32)
            };
            let ground = Rectangle::new([corner(-1.0), corner(1.0)], WHITE.mix(0.8).filled());
            chart.plotting_area().draw(&(EmptyElement::at(*at) + ground))?;
        }
        placed.push(([x + f64::from(moved.0), y + f64::from(moved.1)], half));
        centred(chart, *at, moved, words, *colour)?;
    }
    Ok(())
}

/// Half the width of words of 14 pixels' height, and a little more.
fn half_width(words: &str) -> f64 {
    4.0 * words.chars().count() as f64 + 2.0
}

fn centred(chart: &Chart<'_>, at: (f64, f64), (dx, dy): (i32, i32), words: &str, colour: RGBColor) -> Drawn {
    let style = text(14.0, colour).pos(Pos::new(HPos::Center, VPos::Center));
    let fine = FINE as i32;
    chart.plotting_area().draw(&(EmptyElement::at(at) + Text::new(words.to_owned(), (dx * fine, dy * fine), style)))?;
    Ok(())
}
