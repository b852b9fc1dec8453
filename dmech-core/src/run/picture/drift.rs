//! How an invariant moved.

use std::io;

use dmech_plot::{Area, Axis, BLUE, Drawn, Fit, INK, chart, dots, draw, headed, label_beside, line, rough};

use super::super::history::History;
use super::Run;
use crate::drift::Drift;

/// By how much the largest deviation exceeds the usual one where the axis is logarithmic.
const PEAKS: f64 = 100.0;

pub(super) fn svg<X>(
    run: &Run<X>,
    name: &str,
    drift: Result<Drift, String>,
    history: Option<&History>,
    kept: &str,
) -> io::Result<String> {
    let none = |words: String| io::Error::new(io::ErrorKind::Unsupported, words);
    if run.steps() == 0 && run.states().is_empty() && drift.is_err() {
        return Err(none(format!("this run has ended before its first state: there is no \"{name}\" to draw")));
    }
    let drift = drift.map_err(none)?;
    let history = history.ok_or_else(|| none(format!("this run did not keep the history of \"{name}\"")))?;
    let start = drift.start();
    let relative = start != 0.0 && start.is_finite();
    let unit = if relative { start.abs() } else { 1.0 };
    let parts: Vec<_> = history
        .parts()
        .iter()
        .map(|part| Part { times: part.times(), least: part.least() / unit, most: part.most() / unit })
        .collect();
    let [first, last] = [history.points().next(), history.points().last()];
    let ends = [first, last].map(|end| end.map_or((f64::NAN, f64::NAN), |(t, x)| (t, x / unit)));
    let times =
        [parts.first().map_or(f64::NAN, |part| part.times[0]), parts.last().map_or(f64::NAN, |part| part.times[1])];
    let grows = grows(&parts, parts.iter().map(size).fold(0.0, f64::max));
    let what = match (relative, grows) {
        (true, false) => "(I − I₀) / |I₀|",
        (true, true) => "|I − I₀| / |I₀|",
        (false, false) => "I − I₀",
        (false, true) => "|I − I₀|",
    };
    let title = format!("{name} by {}", run.made(times));
    let largest = parts.iter().map(size).fold(0.0, f64::max);
    let mut words =
        format!("I: {name}, {} at the start; largest change drawn {}{kept}", rough(start, 8), rough(largest, 3));
    if history.parts().iter().any(|part| !part.is_finite()) {
        words += "; not finite in places, which are left out";
    }
    draw([900, 480], |area| {
        let area = headed(area, &capital(&title), &words)?;
        if grows { powers(&area, &parts, ends, what) } else { plain(&area, &parts, ends, what) }
    })
}

/// A part of the history, in the unit of the picture.
struct Part {
    times: [f64; 2],
    least: f64,
    most: f64,
}

fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect()
}

/// The largest distance from the start.
fn size(part: &Part) -> f64 {
    part.least.abs().max(part.most.abs())
}

/// Whether most of the history could not be seen beside its largest values.
fn grows(parts: &[Part], largest: f64) -> bool {
    let mut sizes: Vec<_> = parts.iter().map(size).filter(|&x| x > 0.0).collect();
    sizes.sort_by(f64::total_cmp);
    // Of a few states it is said by a line.
    sizes.len() > 16 && largest > PEAKS * sizes[sizes.len() / 2]
}

/// Time and deviation at both ends of a history.
type Ends = [(f64, f64); 2];

fn plain(area: &Area<'_>, parts: &[Part], ends: Ends, what: &str) -> Drawn {
    let time = times(parts);
    let values = Fit::of(parts.iter().flat_map(|part| [part.least, part.most]).chain([0.0]));
    let turns = parts.iter().enumerate().flat_map(|(k, part)| {
        let [a, b] = [part.least, part.most].map(|x| (middle(&time, part), values.at(x)));
        // To and fro, as the next part begins where this one ends.
        let both = if k % 2 == 0 { [a, b] } else { [b, a] };
        both.into_iter().take(if a == b { 1 } else { 2 })
    });
    let ends = ends.map(|(t, x)| (time.at(t), values.at(x)));
    let points = [ends[0]].into_iter().chain(turns).chain([ends[1]]).collect();
    drawn(area, &time, Axis::linear(&values.name(what), values.range(0.12)), points, ends)
}

fn powers(area: &Area<'_>, parts: &[Part], ends: Ends, what: &str) -> Drawn {
    let time = times(parts);
    // What is zero has no logarithm.
    let moved = parts.iter().filter(|part| size(part) > 0.0);
    let line: Vec<_> = moved.map(|part| (middle(&time, part), size(part).log10())).collect();
    let powers = Fit::of(line.iter().map(|point| point.1)).range(0.0);
    let ends = ends.map(|(t, x)| (time.at(t), x.abs().log10()));
    drawn(area, &time, Axis::powers_of_ten(what, powers.start.floor()..powers.end.ceil() + 0.2), line, ends)
}

fn times(parts: &[Part]) -> Fit {
    Fit::of(parts.iter().flat_map(|part| part.times))
}

fn middle(time: &Fit, part: &Part) -> f64 {
    time.at(0.5 * part.times[0] + 0.5 * part.times[1])
}

fn drawn(area: &Area<'_>, time: &Fit, y: Axis<'_>, points: Vec<(f64, f64)>, ends: Ends) -> Drawn {
    let name = time.name("t") + ", units of the law";
    let mut chart = chart(area, "", Axis::linear(&name, time.range(0.02)), y, 16)?;
    let sound = ends.into_iter().zip(["start", "end"]).filter(|((t, x), _)| t.is_finite() && x.is_finite());
    let labels: Vec<_> = sound.map(|(at, word)| (at, word.to_owned(), INK)).collect();
    dots(&mut chart, &labels.iter().map(|label| label.0).collect::<Vec<_>>(), INK, 3.0)?;
    line(&mut chart, points.clone(), BLUE, 1.5)?;
    label_beside(&chart, &[points], &labels)
}
