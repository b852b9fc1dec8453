//! Speed against error: schemes on one law over a ladder of steps.

mod case;
mod csv;
mod entrant;
mod extrapolation;
mod interpolate;
mod ladder;
mod precise;
mod reference;
mod report;
mod row;
mod table;
mod truth;

#[cfg(test)]
mod tests;

pub use interpolate::{Cost, cost_at};
pub use reference::Reference;
pub use report::StudyReport;
pub use row::{Figures, StudyRow};

use core::fmt;

use dmech_scalar::DoubleDouble;

use crate::error::Error;
use crate::law::Law;
use crate::scheme::{Adaptable, Scheme};
use crate::state::State;
use crate::system::Particle;

use case::{Case, rounding};
use entrant::{Adapting, Entrant, Runner};
use truth::Truth;

/// How much time, and how many forces, does each scheme need for a given error under this law?
///
/// Every scheme runs from the start to the end with every step of a ladder. Measured are
///
/// ```text
/// error  e = |q(t_end) − q*(t_end)|                  the Euclidean distance, in the unit of q
/// time   the shortest of the repetitions, the start included; nothing in the loop but the scheme
/// drift  max |I(t) − I(t₀)| for each invariant I     in a run of its own, at up to 4096 states and the last
/// ```
///
/// and the evaluations of the force. q* is the [`exact`](Study::exact) solution; where none is given, it is a
/// [`Reference`] that the study computes, whose own error is shown: in `f64`, good to 10⁻¹³ or so, or where the law is generic
/// over its scalar, as every declared law is, [to all digits](Study::precise). Repetitions go round: each run once, then each run
/// again, so that other load on the machine hits all alike. A step is shortened so that a whole number of them ends at
/// t_end. A run that fails is a row with its cause.
///
/// ```
/// use dmech_core::prelude::*;
/// #[derive(Clone, Copy)]
/// struct Spring { k: f64 }
/// # impl Conservative for Spring {}
/// # impl Potential<1> for Spring {
/// #     fn potential(&self, [x]: [f64; 1]) -> f64 { 0.5 * self.k * x * x }
/// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [self.k * x] }
/// #     fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] { [[self.k]] }
/// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [0.5 * self.k * (a + b)] }
/// #     fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] { [[0.5 * self.k]] }
/// # }
/// let report = Study::new(Spring { k: 4.0 }, State::new([0.7], [0.0]), 20.0)
///     .scheme(Leapfrog)
///     .scheme(DiscreteGradient)
///     .scheme(Composed::order4(Leapfrog))
///     .ladder([0.1, 0.05, 0.025])
///     .exact(|t| [0.7 * (2.0 * t).cos()])
///     .run()?;
/// println!("{report}");
/// assert_eq!(report.rows().len(), 9);
/// let (fastest, _time) = report.fastest_at(1e-4).unwrap();
/// assert!(fastest.starts_with("Composed"));
/// # Ok::<(), dmech_core::Error>(())
/// ```
#[must_use = "a study measures nothing until it is run"]
pub struct Study<'a, L, const D: usize> {
    case: Case<L, D>,
    runners: Vec<Box<dyn Runner<L, D> + 'a>>,
    ladder: Option<Vec<f64>>,
    against: Against<'a, L, D>,
    repetitions: u32,
}

/// A position, and how it was computed.
type Computed<const D: usize> = Result<(Truth<D>, Reference), Error>;

/// What positions are compared with.
enum Against<'a, L, const D: usize> {
    /// A reference in `f64`.
    Computed,
    /// A reference in double-double numbers, by a function that asks more of the law than a study does.
    Precise(fn(&Case<L, D>) -> Computed<D>),
    /// The position at a time.
    Exact(Box<dyn Fn(f64) -> [f64; D] + 'a>),
}

impl<'a, L: Law<D> + Clone + 'a, const D: usize> Study<'a, L, D> {
    /// A particle of mass 1 under a law, from a state until a time.
    pub fn new(law: L, start: State<D>, t_end: f64) -> Self {
        let case = Case { law, start, end: t_end, mass: 1.0 };
        Study { case, runners: Vec::new(), ladder: None, against: Against::Computed, repetitions: 5 }
    }

    /// Adds a scheme, with whatever options it has.
    pub fn scheme<S: Scheme<Particle<L, D>> + 'a>(mut self, scheme: S) -> Self {
        self.runners.push(Box::new(Entrant(scheme)));
        self
    }

    /// Adds a scheme whose steps follow the motion, [`Simulation::adaptive`](crate::Simulation::adaptive), with tolerances
    /// in place of the ladder.
    pub fn adaptive<S: Adaptable + Scheme<Particle<L, D>> + 'a>(
        mut self,
        scheme: S,
        tolerances: impl IntoIterator<Item = f64>,
    ) -> Self {
        self.runners.push(Box::new(Adapting { scheme, tolerances: tolerances.into_iter().collect() }));
        self
    }

    /// The mass of the particle (default 1).
    pub fn mass(mut self, mass: f64) -> Self {
        self.case.mass = mass;
        self
    }

    /// The time steps, in any order.
    ///
    /// Without a ladder each scheme has its own. From the shortest of the times |q|/|v|, √(|q|/|a|) and 1/√‖∂a/∂q‖ of
    /// the start the step is doubled while the error is below |q|/100, and halved until the error does not fall any
    /// more, or 2²¹ forces were evaluated.
    pub fn ladder(mut self, steps: impl IntoIterator<Item = f64>) -> Self {
        self.ladder = Some(steps.into_iter().collect());
        self
    }

    /// The exact position at time t. It takes the place of [`precise`](Study::precise), and the other way round.
    pub fn exact(mut self, position: impl Fn(f64) -> [f64; D] + 'a) -> Self {
        self.against = Against::Exact(Box::new(position));
        self
    }

    /// Measures errors against a [`Reference`] in [`DoubleDouble`] numbers, to the last digit of `f64`: for laws declared with
    /// `#[dmech::law]`, and others that are laws for that scalar too.
    ///
    /// Extrapolated leap-frog of order 28, or the midpoint rule where a `#[force]` acts, runs twice with local tolerances of
    /// 10⁻²² and 10⁻²⁵, and again with 10⁻²⁸ unless the two agree to a sixteenth of the last place; what they differ by
    /// is shown. 87 orbits of eccentricity 0.33 take 0.07 s so. Errors count from where a run really ends: t₀ + n h, as h is
    /// rounded, may miss t_end by 10⁻¹⁶ of the span, and the motion between is not the scheme's error.
    ///
    /// # Errors
    /// When run: [`Error::StepVanished`] where the motion ends in a collision, [`Error::EndTime`] where it would take more
    /// than 2²⁴ forces to follow it.
    pub fn precise(mut self) -> Self
    where
        L: Law<D, DoubleDouble>,
    {
        self.against = Against::Precise(precise::compute);
        self
    }

    /// How often each run is timed (default 5); at least once.
    pub fn repetitions(mut self, n: u32) -> Self {
        self.repetitions = n.max(1);
        self
    }

    /// Runs everything.
    ///
    /// # Errors
    /// [`Error`] for what no run could do anything with: no scheme, an end that does not lie after the start, a step,
    /// mass or state that is refused, an exact solution that is not finite, a reference that cannot be computed.
    pub fn run(self) -> Result<StudyReport, Error> {
        let Study { case, runners, ladder, against, repetitions } = self;
        case.check()?;
        if runners.is_empty() {
            return Err(Error::NoSchemes);
        }
        let ladder = ladder.map(ladder::checked).transpose()?;
        let (truth, reference) = match against {
            Against::Exact(exact) => (Truth::new(case.finite(exact(case.end))?), None),
            Against::Computed => reference::compute(&case).map(|(q, reference)| (Truth::new(q), Some(reference)))?,
            Against::Precise(compute) => compute(&case).map(|(truth, reference)| (truth, Some(reference)))?,
        };
        // Positions in `f64` are themselves no better than their rounding.
        let resolution = reference.map_or(0.0, |reference| reference.error()).max(rounding(&truth.position()));
        let mut rows = Vec::new();
        for (entrant, runner) in runners.iter().enumerate() {
            let measure = |dt| row::measure(&case, entrant, runner.as_ref(), dt, &truth);
            match (runner.tolerances(), &ladder) {
                (Some(tolerances), _) => rows.extend(tolerances.iter().copied().map(measure)),
                (None, Some(steps)) => rows.extend(steps.iter().copied().map(measure)),
                (None, None) => rows.extend(ladder::default(&case.scales(), resolution, measure)),
            }
        }
        for _ in 0..repetitions {
            for row in &mut rows {
                row.time_once(&case, runners[row.entrant()].as_ref());
            }
        }
        let schemes = runners.iter().map(|runner| (runner.name(), runner.order())).collect();
        Ok(StudyReport::new(schemes, rows, [case.start.t, case.end], resolution, reference))
    }
}

impl<L, const D: usize> fmt::Debug for Study<'_, L, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let schemes: Vec<_> = self.runners.iter().map(|runner| runner.name()).collect();
        f.debug_struct("Study")
            .field("start", &self.case.start)
            .field("end", &self.case.end)
            .field("mass", &self.case.mass)
            .field("schemes", &schemes)
            .field("ladder", &self.ladder)
            .field("repetitions", &self.repetitions)
            .finish_non_exhaustive()
    }
}
