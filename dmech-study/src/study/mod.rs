//! Speed against error: schemes on one motion over a ladder of steps.

mod case;
mod csv;
mod entrant;
mod extrapolation;
mod interpolate;
mod ladder;
#[cfg(not(feature = "plot"))]
mod off;
#[cfg(feature = "plot")]
mod picture;
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

use dmech_core::extend::{DoubleDouble, Scheme};
#[cfg(feature = "scene")]
use dmech_core::scene::Scene;
use dmech_core::{Adaptable, Law, Simulation, State};

use crate::error::StudyError;
use crate::motion::{PositionOf, Repeatable};
use case::{Case, rounding};
use entrant::{Adapting, Entrant, Runner};
use truth::Truth;

/// How much time, and how many forces, does each scheme need for a given error in this motion?
///
/// Every scheme runs from the start to the end with every step of a ladder. Measured are
///
/// ```text
/// error  e = |q(t_end) − q*(t_end)|                  the Euclidean distance over all coordinates, in the unit of q
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
/// use dmech_study::Study;
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
/// # Ok::<(), dmech_study::StudyError>(())
/// ```
///
/// Motions are in `f64`; in other scalars they are run one by one. `Study::scene` takes the bodies of a scene, [`Study::of`] any
/// simulation, as one with masses.
#[must_use = "a study measures nothing until it is run"]
pub struct Study<'a, L, X: Repeatable<L>> {
    motion: Simulation<L, X>,
    end: f64,
    runners: Vec<Box<dyn Runner<L, X> + 'a>>,
    longest: f64,
    ladder: Option<Vec<f64>>,
    against: Against<'a, L, X>,
    repetitions: u32,
}

/// A position, and how it was computed.
type Computed = Result<(Truth, Reference), dmech_core::Error>;

/// What positions are compared with.
enum Against<'a, L, X: Repeatable<L>> {
    /// A reference in `f64`.
    Computed,
    /// A reference in double-double numbers, by a function that asks more of the law than a study does.
    Precise(fn(&Case<L, X>) -> Computed),
    /// The position at a time.
    Exact(Box<dyn Fn(f64) -> PositionOf<L, X> + 'a>),
}

impl<'a, L: Law<D> + Clone + 'a, const D: usize> Study<'a, L, State<D>> {
    /// A particle of mass 1 under a law, from a state until a time.
    pub fn new(law: L, start: State<D>, t_end: f64) -> Self {
        Study::of(Simulation::new(law, start), t_end)
    }

    /// The mass of the particle (default 1).
    pub fn mass(self, mass: f64) -> Self {
        Study { motion: self.motion.mass(mass), ..self }
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
    /// When run: [`Error::StepVanished`](dmech_core::Error::StepVanished) where the motion ends in a collision,
    /// [`Error::EndTime`](dmech_core::Error::EndTime) where it would take more than 2²⁴ forces to follow it.
    pub fn precise(mut self) -> Self
    where
        L: Law<D, DoubleDouble>,
    {
        self.against = Against::Precise(precise::compute);
        self
    }
}

#[cfg(feature = "scene")]
impl<'a, const D: usize, P: 'a, T: 'a, B: 'a> Study<'a, (), Scene<D, P, T, B>>
where
    Scene<D, P, T, B>: Repeatable<()>,
{
    /// The bodies of a scene, until a time; errors are distances in the space of all their coordinates.
    pub fn scene(scene: Scene<D, P, T, B>, t_end: f64) -> Self {
        Study::of(Simulation::scene(scene), t_end)
    }
}

impl<'a, L: Clone + 'a, X: Repeatable<L> + 'a> Study<'a, L, X> {
    /// The motion of any simulation until a time. A scheme that it has is not taken, nor its time step.
    pub fn of<S>(simulation: Simulation<L, X, S>, t_end: f64) -> Self {
        let motion = simulation.without_scheme();
        let (runners, longest, against) = (Vec::new(), f64::INFINITY, Against::Computed);
        Study { motion, end: t_end, runners, longest, ladder: None, against, repetitions: 5 }
    }

    /// Adds a scheme, with whatever options it has.
    pub fn scheme<S: Scheme<X::System> + 'a>(mut self, scheme: S) -> Self {
        self.runners.push(Box::new(Entrant(scheme)));
        self
    }

    /// Adds a scheme whose steps follow the motion, [`Simulation::adaptive`], with tolerances in place of the ladder.
    pub fn adaptive<S: Adaptable + Scheme<X::System> + 'a>(
        mut self,
        scheme: S,
        tolerances: impl IntoIterator<Item = f64>,
    ) -> Self {
        self.runners.push(Box::new(Adapting { scheme, tolerances: tolerances.into_iter().collect() }));
        self
    }

    /// The longest step of the schemes that follow the motion, as [`Simulation::dt`] is with a tolerance (default: none), and of the
    /// [`Reference`], which makes 64 steps at least. Laws that name the time do not tell how long a step may be, and need one; so does a
    /// reference of a motion that is simple but for what acts for a short time, which longer steps pass by.
    pub fn dt(self, longest: f64) -> Self {
        Study { longest, ..self }
    }

    /// The time steps, in any order; one that is longer than the span is the span.
    ///
    /// Without a ladder each scheme has its own. From the shortest of the times |q|/|v|, √(|q|/|a|) and 1/ω of the start, with the ω that
    /// [adaptive](Simulation::adaptive) steps follow, the step is doubled while the error is below |q|/100, and halved until the error
    /// does not fall any more, or 2²¹ forces were evaluated.
    pub fn ladder(mut self, steps: impl IntoIterator<Item = f64>) -> Self {
        self.ladder = Some(steps.into_iter().collect());
        self
    }

    /// The exact position at time t: an array, of a scene the list of those of its bodies. It takes the place of
    /// [`precise`](Study::precise), and the other way round.
    pub fn exact(mut self, position: impl Fn(f64) -> PositionOf<L, X> + 'a) -> Self {
        self.against = Against::Exact(Box::new(position));
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
    /// [`StudyError`] for what no run could do anything with: no scheme, an end that does not lie after the start, a step,
    /// tolerance, mass or state that is refused, an exact solution that is not finite, a reference that cannot be computed.
    pub fn run(self) -> Result<StudyReport, StudyError> {
        let Study { motion, end, runners, longest, ladder, against, repetitions } = self;
        let case = Case { start: motion.start(), motion, longest, end };
        case.check()?;
        if runners.is_empty() {
            return Err(StudyError::NoSchemes);
        }
        if longest.is_nan() || longest <= 0.0 {
            return Err(dmech_core::Error::TimeStep { dt: longest }.into());
        }
        // Steps that are no longer have to reach the end.
        dmech_core::extend::steps_until(case.t(), end, longest)?;
        let ladder = ladder.map(|steps| ladder::steps(steps, case.span())).transpose()?;
        let tolerances = runners.iter().map(|runner| runner.tolerances().map(ladder::tolerances).transpose());
        let tolerances = tolerances.collect::<Result<Vec<_>, _>>()?;
        let (truth, reference) = match against {
            Against::Exact(exact) => (Truth::new(&case.exact(&exact(case.end))?), None),
            Against::Computed => reference::compute(&case).map(|(q, reference)| (Truth::new(&q), Some(reference)))?,
            Against::Precise(compute) => compute(&case).map(|(truth, reference)| (truth, Some(reference)))?,
        };
        // Positions in `f64` are themselves no better than their rounding.
        let resolution = reference.map_or(0.0, |reference| reference.error()).max(rounding(&truth.position()));
        let scales = case.scales()?;
        let mut rows = Vec::new();
        for (entrant, (runner, tolerances)) in runners.iter().zip(&tolerances).enumerate() {
            let measure = |dt| row::measure(&case, entrant, runner.as_ref(), dt, &truth);
            match (tolerances, &ladder) {
                (Some(tolerances), _) => rows.extend(tolerances.iter().copied().map(measure)),
                (None, Some(steps)) => rows.extend(steps.iter().copied().map(measure)),
                (None, None) => rows.extend(ladder::default(&scales, case.span(), resolution, measure)),
            }
        }
        for _ in 0..repetitions {
            for row in &mut rows {
                row.time_once(&case, runners[row.entrant()].as_ref());
            }
        }
        let schemes = runners.iter().map(|runner| (runner.name(), runner.order())).collect();
        let report = StudyReport::new(schemes, rows, [case.t(), case.end], resolution, reference);
        #[cfg(feature = "plot")]
        let report = report.of_length(scales.length);
        Ok(report)
    }
}

impl<L, X: Repeatable<L>> fmt::Debug for Study<'_, L, X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let schemes: Vec<_> = self.runners.iter().map(|runner| runner.name()).collect();
        f.debug_struct("Study")
            .field("start", &self.motion.start())
            .field("end", &self.end)
            .field("schemes", &schemes)
            .field("ladder", &self.ladder)
            .field("repetitions", &self.repetitions)
            .finish_non_exhaustive()
    }
}
