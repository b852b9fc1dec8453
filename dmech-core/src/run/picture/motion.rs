//! Where bodies went.

use std::io;

use dmech_plot::plotters::style::RGBColor;
use dmech_plot::{
    Area, Axis, BLUE, Chart, Drawn, Fit, GREEN, INK, OCHRE, PURPLE, RED, TEAL, apart, chart, count, dots, draw,
    equal_axes, headed, label_beside, lines, rings, squares,
};

use super::Run;
use crate::snapshot::Snapshot;
use dmech_scalar::Real as _;

/// Bodies that have a colour each.
const COLOURS: [RGBColor; 6] = [BLUE, RED, GREEN, OCHRE, PURPLE, TEAL];

/// Points of lines, and dots of a kind, in the whole picture.
const POINTS: usize = 50_000;
const DOTS: usize = 2000;

/// Bodies of which some hide others.
const CROWD: usize = 1000;

/// Axes of different scales where one scale would make a line of the path.
const FLAT: f64 = 15.0;

/// A path as it stands on the axes.
type Line = Vec<(f64, f64)>;

#[derive(Clone, Copy, PartialEq)]
enum Quantity {
    Time,
    Position(usize),
    Velocity(usize),
}

use Quantity::{Position, Time, Velocity};

impl Quantity {
    fn of<X: Snapshot>(self, state: &X, body: usize) -> f64 {
        match self {
            Time => state.time(),
            Position(k) => state.number(0, body * X::DIMENSION + k).to_f64(),
            Velocity(k) => state.number(1, body * X::DIMENSION + k).to_f64(),
        }
    }

    fn name(self, d: usize) -> String {
        match self {
            Time => "t".to_owned(),
            Velocity(_) => "v".to_owned(),
            Position(_) if d == 1 => "q".to_owned(),
            Position(k) if d <= 3 => ["x", "y", "z"][k].to_owned(),
            Position(k) => format!("q{}", ["₁", "₂", "₃", "₄", "₅", "₆"][k.min(5)]),
        }
    }
}

/// What stands over what.
fn panels(d: usize) -> Vec<[Quantity; 2]> {
    match d {
        0 => Vec::new(),
        1 => vec![[Time, Position(0)], [Position(0), Velocity(0)]],
        2 => vec![[Position(0), Position(1)]],
        3 => vec![[Position(0), Position(1)], [Position(0), Position(2)]],
        d => (0..(d / 2).min(3)).map(|k| [Position(2 * k), Position(2 * k + 1)]).collect(),
    }
}

/// The recorded states, and the last where it comes after them; those that are not finite are counted.
struct Paths<'a, X> {
    states: Vec<&'a X>,
    bodies: usize,
    lost: usize,
}

impl<'a, X: Snapshot> Paths<'a, X> {
    fn of(run: &'a Run<X>) -> Self {
        let last = run.last();
        let beyond = run.states().last().is_none_or(|recorded| recorded.time() != last.time());
        let all: Vec<_> = run.states().iter().chain(beyond.then_some(last)).collect();
        let bodies = last.bodies();
        let sound = |body: usize, state: &X| (0..X::DIMENSION).all(|k| Position(k).of(state, body).is_finite());
        let finite = |state: &&X| state.time().is_finite() && (0..bodies).any(|body| sound(body, state));
        let whole = |state: &&X| state.time().is_finite() && (0..bodies).all(|body| sound(body, state));
        let lost = all.iter().filter(|state| !whole(state)).count();
        Paths { states: all.into_iter().filter(finite).collect(), bodies, lost }
    }

    fn line(&self, body: usize, [x, y]: [(Quantity, Fit); 2]) -> Line {
        let on = |(quantity, fit): (Quantity, Fit), state: &X| fit.at(quantity.of(state, body));
        self.states.iter().map(|state| (on(x, state), on(y, state))).collect()
    }

    fn fit(&self, quantity: Quantity) -> Fit {
        Fit::of(self.states.iter().flat_map(|state| (0..self.bodies).map(move |body| quantity.of(*state, body))))
    }

    /// Whether a body never left its place, of a motion that others make.
    fn stays(&self, body: usize) -> bool {
        let place = |state: &X| (0..X::DIMENSION).map(move |k| Position(k).of(state, body)).collect::<Vec<_>>();
        let first = self.states.first().map(|state| place(state));
        self.bodies > 1 && self.states.len() > 1 && self.states.iter().all(|state| Some(place(state)) == first)
    }

    fn words(&self) -> String {
        let states = self.states.len();
        let mut words = format!("{} state{} drawn", count(states as u64), if states == 1 { "" } else { "s" });
        if self.bodies != 1 {
            words += &format!(" of {} bodies", count(self.bodies as u64));
        }
        if self.lost > 0 {
            words += &format!(", {} with numbers that are not finite", count(self.lost as u64));
        }
        words + "; units of the law"
    }
}

pub(super) fn svg<X: Snapshot>(run: &Run<X>) -> io::Result<String> {
    if run.states().is_empty() {
        let says = "the run recorded no state that could be drawn; a stream hands its states on";
        return Err(io::Error::new(io::ErrorKind::Unsupported, says));
    }
    let motion = Paths::of(run);
    let all = || run.states().iter().chain([run.last()]).map(Snapshot::time).filter(|t| t.is_finite());
    let times = [all().next().unwrap_or(f64::NAN), all().last().unwrap_or(f64::NAN)];
    let panels = if motion.bodies == 0 { Vec::new() } else { panels(X::DIMENSION) };
    let width = match panels.len() {
        0 | 1 => 820,
        n => 560 * n as u32,
    };
    let kind = match X::DIMENSION {
        1 => "Paths by ",
        2 => "Path by ",
        _ => "Path, projected, by ",
    };
    let height = if X::DIMENSION == 1 { 480 } else { 640 };
    draw([width, height], |area| {
        let key = key(&motion, X::DIMENSION);
        let title = format!("{kind}{}", run.made(times));
        let area = headed(area, &title, &(motion.words() + &key))?;
        let parts = area.split_evenly((1, panels.len().max(1)));
        for (part, panel) in parts.iter().zip(&panels) {
            self::panel(part, &motion, *panel, panels.len())?;
        }
        Ok(())
    })
}

/// What the marks mean.
fn key<X: Snapshot>(motion: &Paths<'_, X>, d: usize) -> String {
    match (motion.bodies, d) {
        (0, _) | (_, 0) => "; nothing to draw".to_owned(),
        (1, _) => String::new(),
        (n, _) => {
            let square = if (0..n).any(|body| motion.stays(body)) { ", ■ stays where it is" } else { "" };
            let crowd = if n > CROWD { "; where bodies crowd, some of them" } else { "" };
            format!("; ○ start, ● end{square}{crowd}")
        }
    }
}

fn panel<X: Snapshot>(area: &Area<'_>, motion: &Paths<'_, X>, [x, y]: [Quantity; 2], panels: usize) -> Drawn {
    let [mut across, mut up] = [x, y].map(|quantity| motion.fit(quantity));
    let places = matches!((x, y), (Position(_), Position(_)));
    let flat = places && across.width().max(up.width()) > FLAT * across.width().min(up.width());
    // A straight path has one scale as well: what it does not do has no scale of its own.
    let equal = places && (!flat || across.width().min(up.width()) == 0.0);
    if equal {
        [across, up] = across.alike(&up);
    }
    let [x_name, y_name] = [(x, across), (y, up)].map(|(quantity, fit)| fit.name(&quantity.name(X::DIMENSION)));
    let title = match (panels, flat && !equal) {
        (1, false) => String::new(),
        (_, false) => format!("{} over {}", y.name(X::DIMENSION), x.name(X::DIMENSION)),
        (_, true) => format!("{} over {}, on different scales", y.name(X::DIMENSION), x.name(X::DIMENSION)),
    };
    // A little more than the motion, so that marks at its ends are whole.
    let beside = if x == Time { 0.03 } else { 0.08 };
    let (horizontal, vertical) =
        (Axis::linear(&x_name, across.range(beside)), Axis::linear(&y_name, up.range(0.1)).marks(7));
    let mut chart = match equal {
        true => equal_axes(area, &title, horizontal, vertical, 12)?,
        false => chart(area, &title, horizontal, vertical, 12)?,
    };
    bodies(&mut chart, motion, [(x, across), (y, up)], panels)
}

fn bodies<X: Snapshot>(
    chart: &mut Chart<'_>,
    motion: &Paths<'_, X>,
    axes: [(Quantity, Fit); 2],
    panels: usize,
) -> Drawn {
    let few = motion.bodies <= COLOURS.len();
    let paths: Vec<_> = (0..motion.bodies).map(|body| motion.line(body, axes)).collect();
    let groups: Vec<(RGBColor, &[Line])> = match few {
        true => COLOURS.into_iter().zip(paths.chunks(1)).collect(),
        false => vec![(BLUE, &paths)],
    };
    let width = if few { 1.5 } else { 1.0 };
    for (colour, group) in &groups {
        lines(chart, group, *colour, width, POINTS / (panels * groups.len()))?;
    }
    let radius = if motion.bodies > 200 { 1.5 } else { 3.5 };
    let (mut labels, mut first) = (Vec::new(), 0);
    for (colour, group) in groups {
        let (still, moving): (Vec<_>, Vec<_>) = (0..group.len()).partition(|body| motion.stays(first + body));
        let starts = |of: &[usize]| of.iter().filter_map(|&body| finite(&group[body]).next()).collect::<Vec<_>>();
        let ends = |of: &[usize]| of.iter().filter_map(|&body| finite(&group[body]).next_back()).collect::<Vec<_>>();
        rings(chart, &apart(chart, &starts(&moving), DOTS / panels), colour, radius + 1.0)?;
        dots(chart, &apart(chart, &ends(&moving), DOTS / panels), colour, radius)?;
        squares(chart, &apart(chart, &ends(&still), DOTS / panels), INK, radius)?;
        if motion.bodies == 1 {
            labels.extend(starts(&[0]).into_iter().map(|at| (at, "start".to_owned(), INK)));
            labels.extend(ends(&[0]).into_iter().map(|at| (at, "end".to_owned(), INK)));
        } else if few {
            labels.extend(ends(&[0]).into_iter().map(|at| (at, format!("body {first}"), colour)));
        }
        first += group.len();
    }
    label_beside(chart, &paths, &labels)
}

fn finite(path: &[(f64, f64)]) -> impl DoubleEndedIterator<Item = (f64, f64)> + '_ {
    path.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite())
}
