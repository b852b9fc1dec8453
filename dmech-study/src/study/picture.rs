//! The picture of a study.

use std::io;
use std::path::Path;

use dmech_plot::plotters::style::RGBColor;
use dmech_plot::{
    Area, Axis, BLUE, Drawn, GREEN, INK, OCHRE, PALE, PURPLE, RED, TEAL, chart, dots, draw, headed, label_beside, line,
    span,
};

use super::report::StudyReport;
use super::row::Figures;

/// Panels that stand side by side, and the size of each.
const ACROSS: usize = 3;
const PANEL: [u32; 2] = [330, 300];

/// Schemes that stand in one panel in any case.
const FEW: usize = 3;

const COLOURS: [RGBColor; 6] = [BLUE, RED, GREEN, OCHRE, PURPLE, TEAL];

/// Errors for which the fastest of other schemes is looked for, in a power of ten.
const LEVELS: f64 = 8.0;

/// Schemes that are compared with one another, by their places in the study, each with its name in the panel.
struct Family {
    title: String,
    lines: Vec<(usize, String)>,
}

impl StudyReport {
    /// Draws the time that each scheme needs for an error, as SVG into a file.
    ///
    /// Each family of schemes has a panel, all with the same axes: those of order 1 and 2, the orders of one method, and those
    /// whose steps follow the motion. The grey line in it is the fastest of all other schemes at each error, so that a family
    /// is the best where its lines are left of the grey one. A study of three schemes or fewer has one panel.
    ///
    /// A line goes from the step at which the error is no larger than the motion to the one at which it stops falling, or at which the
    /// reference does not tell it from none: that one is drawn at the smallest error that can be told.
    ///
    /// ```no_run
    /// # fn show(report: dmech_study::StudyReport) -> std::io::Result<()> {
    /// report.plot("study.svg")?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Of the file.
    pub fn plot(&self, path: impl AsRef<Path>) -> io::Result<()> {
        self.plot_titled(path, "Time for an error")
    }

    /// The same with a title, as the name of the motion, which the study does not know.
    ///
    /// # Errors
    /// Likewise.
    pub fn plot_titled(&self, path: impl AsRef<Path>, title: &str) -> io::Result<()> {
        dmech_plot::save(path, &self.svg(title)?)
    }

    fn svg(&self, title: &str) -> io::Result<String> {
        let lines: Vec<_> = (0..self.schemes().len()).map(|scheme| self.line(scheme)).collect();
        let families = self.families();
        let (across, down) = (families.len().clamp(1, ACROSS), families.len().div_ceil(ACROSS).max(1));
        let single = families.len() <= 1;
        let [width, height] = if single { [820, 560] } else { [PANEL[0] * across as u32, PANEL[1] * down as u32 + 60] };
        let grey = if single { "" } else { "; grey: the fastest of all other schemes" };
        let words = format!("t = {}; errors in the law's unit of length{grey}", span(self.span()));
        draw([width, height], |area| {
            let area = headed(area, title, &words)?;
            let ranges = ranges(&lines);
            for (part, family) in area.split_evenly((down, across)).iter().zip(&families) {
                self.panel(part, family, &lines, &ranges)?;
            }
            Ok(())
        })
    }

    fn panel(&self, area: &Area<'_>, family: &Family, lines: &[Vec<(f64, f64)>], ranges: &[[f64; 2]; 2]) -> Drawn {
        let [times, errors] = ranges;
        let x = Axis::powers_of_ten("time, seconds", times[0]..times[1]).marks(6);
        let y = Axis::powers_of_ten("error at the end", errors[0]..errors[1]).marks(8);
        let mut chart = chart(area, &family.title, x, y, 6)?;
        let others = self.others(family, *errors);
        line(&mut chart, others.clone(), PALE, 4.0)?;
        let (mut obstacles, mut labels) = (vec![others], Vec::new());
        for ((scheme, name), colour) in family.lines.iter().zip(COLOURS.into_iter().cycle()) {
            let points = &lines[*scheme];
            line(&mut chart, points.clone(), colour, 1.5)?;
            dots(&mut chart, points, colour, 2.0)?;
            labels.extend(points.last().map(|&end| (end, name.clone(), colour)));
            obstacles.push(points.clone());
        }
        // What has no line is named above the others.
        let missing: Vec<_> = family.lines.iter().filter(|(scheme, _)| lines[*scheme].is_empty()).collect();
        let alone = missing.len() == family.lines.len();
        let middle = |[from, to]: [f64; 2], part: f64| part.mul_add(to - from, from);
        for (k, (scheme, name)) in missing.into_iter().enumerate().take(if alone { 1 } else { FEW }) {
            let ended = self.rows_of(*scheme).any(|row| row.result().is_ok());
            let why = match (ended, family.title.is_empty() || alone) {
                (true, true) => "all errors are larger than the motion",
                (true, false) => "off the scale",
                (false, _) => "no run reached the end",
            };
            let words = if alone { why.to_owned() } else { format!("{name}: {why}") };
            let height = if alone { 0.5 } else { 0.96 - 0.05 * k as f64 };
            labels.push(((middle(*times, 0.5), middle(*errors, height)), words, INK));
        }
        label_beside(&chart, &obstacles, &labels)
    }

    /// The families, those of few schemes first together.
    fn families(&self) -> Vec<Family> {
        let adaptive = |scheme: usize| self.rows_of(scheme).any(|row| row.tolerance().is_some());
        let all = self.schemes().iter().enumerate().map(|(scheme, (name, order))| (scheme, *name, *order));
        if self.schemes().len() <= FEW {
            return vec![Family {
                title: String::new(),
                lines: all.map(|(k, name, _)| (k, name.to_owned())).collect(),
            }];
        }
        let mut families: Vec<Family> = Vec::new();
        for (scheme, name, order) in all {
            let method = name.split_once('(').map_or(name, |(method, _)| method);
            let (title, line) = match (adaptive(scheme), order, method) {
                (true, ..) => ("steps that follow the motion".to_owned(), short(inner(name), order)),
                (_, 1 | 2, _) => ("order 1 and 2".to_owned(), name.to_owned()),
                (_, _, "Gauss" | "LineIntegral") => ("Gauss, LineIntegral".to_owned(), format!("{method} {order}")),
                (_, _, "Composed") => (format!("Composed({})", inner(name)), format!("order {order}")),
                (_, _, method) => (method.to_owned(), format!("order {order}")),
            };
            match families.iter_mut().find(|family| family.title == title) {
                Some(family) => family.lines.push((scheme, line)),
                None => families.push(Family { title, lines: vec![(scheme, line)] }),
            }
        }
        families
    }

    /// At each error the least time of the schemes that are not of a family.
    fn others(&self, family: &Family, [from, to]: [f64; 2]) -> Vec<(f64, f64)> {
        let own = |scheme: usize| family.lines.iter().any(|(own, _)| *own == scheme);
        let to = to.min(self.length().log10());
        let levels = (0..=((to - from).max(0.0) * LEVELS) as usize).map(|k| from + k as f64 / LEVELS);
        let mut least = f64::INFINITY;
        let fastest = levels.map(|level| {
            let times = self.times_at(10_f64.powf(level)).enumerate();
            let others = times.filter_map(|(scheme, (_, cost))| if own(scheme) { None } else { cost });
            // What reaches a smaller error reaches this one.
            least = others.map(|cost| cost.value().log10()).fold(least, f64::min);
            (least, level)
        });
        fastest.filter(|point| point.0.is_finite()).collect()
    }

    /// Logarithms of time and error: from where the error is no larger than the motion to where it stops falling, as what
    /// follows is rounding.
    fn line(&self, scheme: usize) -> Vec<(f64, f64)> {
        // Tolerances beyond the longest step that a scheme takes are one run.
        let rows: Vec<_> = self.rows_of(scheme).collect();
        let next = |k: usize| rows.get(k + 1).map(|row| row.steps());
        let apart =
            rows.iter().enumerate().filter(|(k, row)| row.tolerance().is_none() || next(*k) != Some(row.steps()));
        let figures: Vec<_> = apart.filter_map(|(_, row)| row.result().ok()).collect();
        let point = |figures: &Figures| {
            let error = figures.error().max(self.resolution()).max(f64::MIN_POSITIVE);
            (figures.time().as_secs_f64().max(1e-9).log10(), error.log10())
        };
        // The first error that the reference does not tell from none ends the line.
        let untold = figures.iter().position(|figures| figures.error() < self.resolution());
        let told = untold.map_or(&figures[..], |first| &figures[..=first]);
        let mut points: Vec<_> = told.iter().copied().map(point).collect();
        let size = self.length().log10();
        let rounding = size - 8.0;
        let lost = points.iter().rposition(|point| point.1 > size + 0.5);
        points.drain(..lost.map_or(0, |lost| lost + 1));
        let stalls = |pair: &[(f64, f64)]| pair[1].1 < rounding && pair[1].1 > pair[0].1 - 0.3;
        let end = points.windows(2).position(stalls);
        points.truncate(end.map_or(points.len(), |end| end + 1));
        points
    }
}

/// The axes of all panels: of the times, and of the errors.
fn ranges(lines: &[Vec<(f64, f64)>]) -> [[f64; 2]; 2] {
    let of = |value: fn(&(f64, f64)) -> f64| {
        let (least, most) =
            lines.iter().flatten().map(value).fold((f64::MAX, f64::MIN), |(a, b), x| (x.min(a), x.max(b)));
        if least > most { [-1.0, 1.0] } else { [least, most] }
    };
    let [[fastest, slowest], [least, most]] = [of(|point| point.0), of(|point| point.1)];
    // Names stand below the most accurate runs and beside the slowest.
    [[fastest.floor(), slowest + 0.6], [(least - 2.0).floor(), most.ceil()]]
}

/// What stands first in the brackets of a name: `Nystrom` of `Adaptive(Nystrom(…), …)`.
fn inner(name: &str) -> &str {
    let Some((_, inside)) = name.split_once('(') else { return name };
    let mut depth = 0;
    let end = inside.char_indices().find(|(_, letter)| match letter {
        '(' => {
            depth += 1;
            false
        }
        ')' if depth > 0 => {
            depth -= 1;
            false
        }
        ')' | ',' => depth == 0,
        _ => false,
    });
    inside[..end.map_or(inside.len(), |(at, _)| at)].trim()
}

/// A name for the end of a line: the method and its order.
fn short(name: &str, order: u32) -> String {
    match name.split_once('(').map_or(name, |(method, _)| method) {
        "Composed" => format!("{} {order}", inner(name)),
        method => format!("{method} {order}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{inner, short};

    #[test]
    fn names_are_told_apart() {
        assert_eq!(inner("Composed(Leapfrog, Suzuki4)"), "Leapfrog");
        assert_eq!(inner("Adaptive(Composed(DiscreteGradient, S))"), "Composed(DiscreteGradient, S)");
        assert_eq!(short("Composed(DiscreteGradient, S)", 6), "DiscreteGradient 6");
        assert_eq!(short("Nystrom(Blanes8S19)", 8), "Nystrom 8");
        assert_eq!((inner("Leapfrog"), inner("Odd(")), ("Leapfrog", ""));
    }
}
