//! How a case is drawn: a panel for each scheme, so that no line lies under another, with what happened to it above.

use std::path::PathBuf;

use dmech::plot::plotters::element::Cross;
use dmech::plot::plotters::style::{Color, IntoFont, RGBColor, TextStyle};

use crate::cases::{Kind, Line, Picture, Scale};
use crate::picture::{self, Area, Axis, BLUE, Chart, Drawn, GREEN, INK, OCHRE, PALE, PURPLE, RED};

const WIDTH: u32 = 1000;
/// Height of the title and of each line of words below it.
const HEAD: [u32; 2] = [44, 24];
const PANEL: u32 = 230;
const STROKE: f64 = 1.5;
/// A picture is drawn in quarters of a pixel.
const FINE: f64 = 4.0;
/// A character of the font is hardly ever wider than this part of its height on the average of a line.
const WIDE: f64 = 0.56;

/// The colour of a line by its name, the same in all pictures.
fn colour(name: &str) -> RGBColor {
    match name {
        "Leapfrog" => BLUE,
        "Implicit" => GREEN,
        "DiscreteGradient" => RED,
        "Kanatani" => OCHRE,
        "Explicit" => INK,
        _ => PURPLE,
    }
}

/// Draws a picture and tells where it is.
pub(crate) fn draw(picture: &Picture) -> Drawn<PathBuf> {
    let Picture { name, title, words, x, y, lines, behind } = picture;
    let equal = x.kind == Kind::Equal;
    let together = picture.together();
    let columns = if equal { 2 } else { 1 };
    let rows = if together { 1 } else { lines.len().div_ceil(columns) };
    let high = match (together, equal) {
        (true, _) => 460,
        // Beside the panel's axes, its heading and its margins.
        (_, true) => (100.0 + (f64::from(WIDTH / 2) - 100.0) * (y.to - y.from) / (x.to - x.from)) as u32,
        _ => PANEL,
    };
    let key = "Dot: the start. Cross: the run stops, or leaves the picture. All quantities are dimensionless.";
    let most = (f64::from(WIDTH) / (WIDE * 14.0)) as usize;
    let mut words = lines_of(&words.join(" "), most);
    words.push(key.to_owned());
    let head = HEAD[0] + HEAD[1] * words.len() as u32;
    picture::save(&format!("{name}.svg"), [WIDTH, head + high * rows as u32], |area| {
        let mut area = area.titled(fits(title, 19.0, WIDTH)?, text(19.0))?;
        for line in &words {
            area = area.titled(fits(line, 14.0, WIDTH)?, text(14.0))?;
        }
        if together {
            return all(&area, picture);
        }
        for (panel, line) in area.split_evenly((rows, columns)).iter().zip(lines) {
            let heading = match &line.note {
                Some(note) => format!("{}: {note}", line.name),
                None => line.name.clone(),
            };
            fits(&heading, 17.0, WIDTH / columns as u32)?;
            let mut chart = if equal {
                picture::equal_axes(panel, &heading, axis(x), axis(y), 10)?
            } else {
                picture::chart(panel, &heading, axis(x), axis(y), 20)?
            };
            if let Some(points) = behind {
                follow(&mut chart, points, PALE, 4.0)?;
            }
            trace(&mut chart, line)?;
        }
        Ok(())
    })
}

/// All lines on one chart, where they lie far from each other, with a key in the order in which they end.
fn all(area: &Area<'_>, Picture { x, y, lines, .. }: &Picture) -> Drawn {
    let mut chart = picture::chart(area, "", axis(x), axis(y), 210)?;
    let mut ends = Vec::new();
    for line in lines {
        trace(&mut chart, line)?;
        let last = line.points.last().map_or(f64::NAN, |point| point.1);
        ends.push((last, line));
    }
    ends.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut names = Vec::new();
    for (_, line) in &ends {
        names.push((line.name.as_str(), colour(&line.name)));
        names.extend(line.note.iter().flat_map(|note| note.split(", ")).map(|note| (note, INK)));
    }
    names.iter().try_for_each(|(name, _)| fits(name, 14.0, 210).map(drop))?;
    picture::name_column(&chart, (x.to, y.to), &names)
}

/// A line with its start, and with its end where that is not the end of the picture.
fn trace(chart: &mut Chart<'_>, line: &Line) -> Drawn {
    let colour = colour(&line.name);
    let left = follow(chart, &line.points, colour, STROKE)?;
    picture::dots(chart, &line.points[..line.points.len().min(1)], INK, 4.0)?;
    let end = left.or(line.points.last().copied().filter(|_| line.stopped));
    let cross = |at| Cross::new(at, 5 * FINE as i32, INK.stroke_width(2 * FINE as u32));
    chart.draw_series(end.map(cross))?;
    Ok(())
}

/// Draws a line until it leaves the picture, and tells where it does.
fn follow(chart: &mut Chart<'_>, points: &[(f64, f64)], colour: RGBColor, width: f64) -> Drawn<Option<(f64, f64)>> {
    let (across, up) = (chart.plotting_area().get_x_range(), chart.plotting_area().get_y_range());
    let inside = |(x, y): (f64, f64)| x >= across.start && x <= across.end && y >= up.start && y <= up.end;
    let count = points.iter().take_while(|&&point| inside(point)).count();
    let mut shown = points[..count].to_vec();
    let mut left = None;
    if let (Some(&from), Some(&to)) = (shown.last(), points.get(count)) {
        let at = |part: f64| (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1));
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if inside(at(middle)) { low = middle } else { high = middle }
        }
        left = Some(at(low));
        shown.extend(left);
    }
    picture::line(chart, shown, colour, width)?;
    Ok(left)
}

/// The words, or an error where they would be cut off at the side of the picture.
fn fits(words: &str, size: f64, width: u32) -> Drawn<&str> {
    let length = WIDE * size * words.chars().count() as f64;
    if length > f64::from(width) {
        return Err(format!("{length:.0} pixels of words in {width}: {words}").into());
    }
    Ok(words)
}

/// Lines of at most so many characters.
fn lines_of(words: &str, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in words.split_whitespace() {
        let full = lines.last().is_some_and(|line| line.chars().count() + 1 + word.chars().count() > most);
        if full {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines
}

fn text(size: f64) -> TextStyle<'static> {
    // The backend divides font sizes by 1.24.
    ("sans-serif", 1.24 * size * FINE).into_font().color(&INK)
}

fn axis(scale: &Scale) -> Axis<'static> {
    match scale.kind {
        Kind::Powers => Axis::powers_of_ten(scale.name, scale.from..scale.to),
        _ => Axis::linear(scale.name, scale.from..scale.to),
    }
}
