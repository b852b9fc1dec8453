//! Greenspan's Table 1: the figures as printed, and how they are read off a computed orbit.

use dmech::prelude::*;

/// (5.6): the planet at its pericentre, in units where G m₁ = 1.
pub(crate) const PLANET: State<2> = State::new([0.5, 0.0], [0.0, 1.63]);
/// The time up to which the paper follows it.
pub(crate) const END: f64 = 350.0;

/// One line of the table, with the digits of the print.
pub(crate) struct Printed {
    pub(crate) dt: f64,
    pub(crate) scheme: &'static str,
    /// Time for first orbit, semi-major axis of first orbit, x-intercept at end of first orbit.
    pub(crate) first_orbit: [&'static str; 3],
    /// Number of orbits up to t = 350.
    pub(crate) orbits: &'static str,
}

impl Printed {
    /// The line for a run, if the paper has it.
    pub(crate) fn of(run: &Run<State<2>>) -> Option<&'static Printed> {
        PRINTED.iter().find(|line| (line.dt, line.scheme) == (run.report().dt(), run.report().scheme()))
    }
}

/// D. Greenspan, "New Forms of Discrete Mechanics", Univ. of Wisconsin, Computer Sciences TR 122 (1971), Table 1.
pub(crate) const PRINTED: [Printed; 9] = [
    Printed { dt: 0.1, scheme: "Explicit", first_orbit: ["16.4", "1.6", "0.82"], orbits: "2+" },
    Printed { dt: 0.1, scheme: "Implicit", first_orbit: ["4.3", "0.772", "0.501"], orbits: "81+" },
    Printed { dt: 0.1, scheme: "Leapfrog", first_orbit: ["4.1", "0.776", "0.493"], orbits: "83+" },
    Printed { dt: 0.01, scheme: "Explicit", first_orbit: ["4.48", "0.87", "0.55"], orbits: "19+" },
    Printed { dt: 0.01, scheme: "Implicit", first_orbit: ["4.03", "0.745", "0.4998"], orbits: "86+" },
    Printed { dt: 0.01, scheme: "Leapfrog", first_orbit: ["4.03", "0.745", "0.4999"], orbits: "86+" },
    Printed { dt: 0.001, scheme: "Explicit", first_orbit: ["4.08", "0.75", "0.505"], orbits: "85+" },
    Printed { dt: 0.001, scheme: "Implicit", first_orbit: ["4.035", "0.7445", "0.4996"], orbits: "86+" },
    Printed { dt: 0.001, scheme: "Leapfrog", first_orbit: ["4.036", "0.745", "0.500"], orbits: "86+" },
];

/// Where an orbit meets the x-axis, when only points on both sides of it are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rule {
    /// At the last point before y changes its sign: how the paper read its times and most of its intercepts.
    LastSample,
    /// Where the chord between the points on both sides crosses y = 0.
    Linear,
}

/// The point before y changes its sign, and the point after.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    index: usize,
    before: State<2>,
    after: State<2>,
}

impl Crossing {
    fn upward(&self) -> bool {
        self.after.q[1] >= 0.0 && self.before.q[1] < 0.0
    }

    /// Time and x.
    fn at(&self, rule: Rule) -> (f64, f64) {
        let (before, after) = (self.before, self.after);
        let part = match rule {
            Rule::LastSample => 0.0,
            Rule::Linear => before.q[1] / (before.q[1] - after.q[1]),
        };
        (before.t + part * (after.t - before.t), before.q[0] + part * (after.q[0] - before.q[0]))
    }
}

fn crossings(states: &[State<2>]) -> impl Iterator<Item = Crossing> {
    let crosses = |before: f64, after: f64| (before < 0.0 && after >= 0.0) || (before > 0.0 && after <= 0.0);
    let pairs = states.windows(2).enumerate();
    pairs.filter(move |(_, pair)| crosses(pair[0].q[1], pair[1].q[1])).map(|(index, pair)| Crossing {
        index,
        before: pair[0],
        after: pair[1],
    })
}

/// Time for the first orbit, its semi-major axis and the x-intercept at its end; `None` if it is not completed.
///
/// The planet starts on the positive x-axis and moves upward. It crosses the axis downward on the far side of the sun,
/// then upward where the orbit ends; the semi-major axis is half the distance between the two ("consecutive
/// x-intercepts after the planet has left its initial position").
pub(crate) fn first_orbit(states: &[State<2>], rule: Rule) -> Option<[f64; 3]> {
    let mut crossings = crossings(states);
    let (_, far) = crossings.find(|crossing| !crossing.upward())?.at(rule);
    let (time, near) = crossings.find(Crossing::upward)?.at(rule);
    Some([time, 0.5 * (near - far), near])
}

/// The number of completed orbits: upward crossings of the x-axis.
pub(crate) fn orbits(states: &[State<2>]) -> usize {
    crossings(states).filter(Crossing::upward).count()
}

/// The states of the n-th orbit, counted from 1, from the last point before its start to the first after its end.
pub(crate) fn nth_orbit(states: &[State<2>], n: usize) -> Option<&[State<2>]> {
    let mut ends = crossings(states).filter(Crossing::upward).map(|crossing| crossing.index);
    let start = if n == 1 { 0 } else { ends.nth(n.checked_sub(2)?)? };
    Some(&states[start..=ends.next()? + 1])
}

/// Whether a value, rounded or cut to the digits of the print, is the printed one.
pub(crate) fn agrees(value: f64, printed: &str) -> bool {
    let Ok(number) = printed.parse::<f64>() else { return false };
    let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let unit = 0.1_f64.powi(decimals as i32);
    (-0.5 * unit..unit).contains(&(value - number))
}

/// The motion by all five schemes, in the order of the table with the two energy-exact ones after it.
///
/// # Errors
/// Those of the runs.
pub(crate) fn five_schemes<L: Law<2> + VelocityIndependent + Copy>(
    law: L,
    dt: f64,
) -> Result<[Run<State<2>>; 5], Interrupted<State<2>>> {
    let planet = Simulation::new(law, PLANET).dt(dt);
    Ok([
        planet.clone().scheme(Explicit).run_until(END)?,
        planet.clone().scheme(Implicit).run_until(END)?,
        planet.clone().scheme(Leapfrog).run_until(END)?,
        planet.clone().scheme(DiscreteGradient).run_until(END)?,
        planet.scheme(Kanatani).run_until(END)?,
    ])
}
