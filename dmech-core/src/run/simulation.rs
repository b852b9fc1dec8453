//! Setting up and running.

use dmech_scalar::Real;

use super::attend::Attend;
use super::due::Due;
use super::log::record;
use super::progress::Shown;
use super::{Interrupted, Report, Run};
use crate::error::Error;
use crate::law::Masses;
use crate::law::{Law, MassIndependent};
use crate::method::Method;
use crate::scheme::{Adaptable, Adaptive, NoScheme, Scheme};
use crate::setup::Setup;
use crate::span::{Span, check_step};
use crate::state::State;
use crate::stepper::{Departure, Opening, Stepper};
use crate::system::System;

/// A simulation to be set up and run.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/spring.md")]
/// let run = Simulation::new(Spring { k: 4.0 }, State::new([1.0], [0.0]))
///     .mass(2.0)
///     .scheme(DiscreteGradient)
///     .dt(0.01)
///     .record_every(10)
///     .run_until(20.0)?;
/// assert_eq!(run.states().len(), 201);
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[must_use = "a simulation does nothing until it is run"]
pub struct Simulation<L, X, S = NoScheme, O = ()> {
    pub(crate) law: L,
    pub(crate) start: X,
    pub(crate) scheme: S,
    pub(crate) settings: Settings,
    /// Events, observers and streams, in a list.
    pub(crate) attend: O,
}

/// What is said of a simulation in numbers.
#[derive(Clone, Debug)]
pub(crate) struct Settings {
    pub(crate) mass: f64,
    pub(crate) dt: Option<f64>,
    pub(crate) due: Due,
    pub(crate) shown: Shown,
}

impl Settings {
    /// The length of the steps, with a tolerance the longest.
    fn step_length<R: Real>(&self, scheme: &impl Method) -> Result<f64, Error> {
        let unlimited = scheme.tolerance().map(|_| f64::INFINITY);
        let dt = self.dt.or(unlimited).ok_or(Error::MissingTimeStep)?;
        check_step::<R>(scheme, dt)?;
        Ok(dt)
    }

    /// The system where it starts, for steps of a length.
    fn open<L, X: Setup<L>>(&self, dt: Result<f64, Error>, law: L, start: X) -> Result<Opening<X::System>, Error> {
        let (dt, first) = (dt?, start.start());
        let system = start.system(law, self.mass, dt)?;
        let departure = Departure::prepared(&system, &first)?;
        Ok(Opening { system, start: first, departure, dt })
    }

    /// What a scheme says of the steps.
    fn pace<R: Real>(&self, scheme: &impl Method, mass: f64) -> Stepping {
        let equal = scheme.tolerance().is_none();
        Stepping { dt: self.step_length::<R>(scheme), equal, report: Report::new(scheme, self.dt, mass) }
    }

    /// The system where it starts, a run without a state, and how far it goes.
    fn set_out<L, X: Setup<L>>(
        self,
        pace: Stepping,
        law: L,
        start: X,
        span: Span,
    ) -> SetOut<Opening<X::System>, X::State> {
        let Stepping { dt, equal, report } = pace;
        let run = Run::empty(start.start(), report);
        let opened = self.due.check(X::System::time(&run.last)).and_then(|()| {
            let opening = self.open(dt, law, start)?;
            opening.system.check_potential(&opening.start)?;
            let (t, dt, resolution) = (X::System::time(&opening.start), opening.dt, opening.system.resolution());
            let steps = span.steps(t, dt, equal.then_some(resolution))?;
            let states = self.due.states(steps, span.time(t, steps, dt));
            let until = if let (Span::Until(end), true) = (span, equal) { Some(end) } else { None };
            Ok((opening, Extent { steps, until, states, settings: self }))
        });
        match opened {
            Ok((opening, plan)) => Ok((opening, run, plan)),
            Err(cause) => Err(Interrupted::new(run, cause)),
        }
    }

    /// Refuses what would be refused of every member of an ensemble.
    pub(crate) fn check_for_all(&self, scheme: &impl Method, span: Span) -> Result<(), Error> {
        let dt = self.step_length::<f64>(scheme)?;
        self.due.check_for_any()?;
        span.check(dt)
    }
}

impl<L, const D: usize, R: Real> Simulation<L, State<D, R>> {
    /// A particle of mass 1 under a law, from a state.
    pub fn new(law: L, start: State<D, R>) -> Self
    where
        L: Law<D, R>,
    {
        Simulation::of(law, start)
    }
}

impl<L, X> Simulation<L, X> {
    pub(crate) fn of(law: L, start: X) -> Self {
        let settings = Settings { mass: 1.0, dt: None, due: Due::Every(1), shown: Shown::default() };
        Simulation { law, start, scheme: NoScheme, settings, attend: () }
    }
}

impl<L, X, S, O> Simulation<L, X, S, O> {
    /// Where it starts.
    pub fn start(&self) -> X::State
    where
        X: Setup<L>,
    {
        self.start.start()
    }

    /// The same from another state, as the last one of a run: the law or the bodies stay.
    pub fn starting_from(self, state: &X::State) -> Self
    where
        X: Setup<L>,
    {
        Simulation { start: self.start.starting_from(state), ..self }
    }

    /// Law, start and mass alone, for another scheme.
    pub fn without_scheme(self) -> Simulation<L, X> {
        Simulation::of(self.law, self.start).with(|settings| settings.mass = self.settings.mass)
    }

    /// The same of a law, from a start.
    pub(crate) fn moving<N, Y>(self, law: N, start: Y) -> Simulation<N, Y, S, O> {
        let Simulation { scheme, settings, attend, .. } = self;
        Simulation { law, start, scheme, settings, attend }
    }

    /// The same accompanied by something else.
    pub(crate) fn accompanied<A>(self, attend: A) -> Simulation<L, X, S, A> {
        let Simulation { law, start, scheme, settings, .. } = self;
        Simulation { law, start, scheme, settings, attend }
    }

    /// The same alone, and what accompanies it.
    pub(crate) fn apart(self) -> (Simulation<L, X, S>, O) {
        let Simulation { law, start, scheme, settings, attend } = self;
        (Simulation { law, start, scheme, settings, attend: () }, attend)
    }

    /// The same accompanied by one thing more.
    pub(crate) fn attended<A>(self, also: A) -> Attended<L, X, S, O, A> {
        let Simulation { law, start, scheme, settings, attend } = self;
        Simulation { law, start, scheme, settings, attend: (attend, also) }
    }

    /// The length of the steps, if it is one.
    pub(crate) fn step_length<R: Real>(&self) -> Result<f64, Error>
    where
        S: Method,
    {
        self.settings.step_length::<R>(&self.scheme)
    }

    pub(crate) fn with(mut self, set: impl FnOnce(&mut Settings)) -> Self {
        set(&mut self.settings);
        self
    }

    /// The scheme: [`Leapfrog`](crate::Leapfrog), [`Nystrom`](crate::Nystrom), [`DiscreteGradient`](struct@crate::DiscreteGradient) or any
    /// other of [`scheme`](crate::scheme).
    pub fn scheme<T>(self, scheme: T) -> Simulation<L, X, T, O> {
        let Simulation { law, start, settings, attend, .. } = self;
        Simulation { law, start, scheme, settings, attend }
    }

    /// The time step; with [`adaptive`](Simulation::adaptive) the longest.
    pub fn dt(self, dt: f64) -> Self {
        self.with(|settings| settings.dt = Some(dt))
    }

    /// Steps that follow the time scale of the motion, in place of [`dt`](Simulation::dt): a planet on a long ellipse takes
    /// short ones at the pericentre and long ones at the apocentre.
    ///
    /// The scheme comes first. `DiscreteGradient` and its compositions keep the energy exactly for any sequence of steps;
    /// `Gauss` is the fastest where many digits are wanted; `Nystrom`, `ForceGradient` and compositions of `Leapfrog` are explicit
    /// and fast where few are. As the rule for the steps is reversible where they see the motion change, their energy error goes to and
    /// fro and does not drift: at e = 0.9 it is the same in 300 revolutions as in 3. A step too long for that is made again, half as
    /// long, and so are those that follow.
    /// `Implicit` and its compositions take it too. The rule is found with [`Adaptive`].
    ///
    /// **The tolerance** is the error of the position that one revolution of a Kepler orbit of eccentricity 0.9 adds, over
    /// its half-axis; at every order, a tenth of it means a tenth of the error. Measured per revolution, in tolerances:
    ///
    /// | scheme | e = 0.7 | 0.9 | 0.97 |
    /// |---|---|---|---|
    /// | `DiscreteGradient` | 0.60 | 0.80 | 0.89 |
    /// | `Composed::order4(DiscreteGradient)` | 0.19 | 0.39 | 0.52 |
    /// | `Composed::order6(DiscreteGradient)` | 0.16 | 0.54 | 0.88 |
    /// | `Composed::order8(DiscreteGradient)` | 0.24 | 1.2 | 2.3 |
    /// | `Nystrom::order4()` | 0.74 | 0.91 | 0.81 |
    /// | `Nystrom::order6()` | 0.35 | 1.0 | 1.7 |
    /// | `Nystrom::order8()` | 0.28 | 0.98 | 3.4 |
    /// | `ForceGradient::order4()` | 0.62 | 1.1 | 1.3 |
    /// | `ForceGradient::order6()` | 0.93 | 1.0 | 0.37 |
    /// | `ForceGradient::order8()` | 0.20 | 0.99 | 2.2 |
    /// | `RungeKuttaNystrom::order12()`, at 10⁻⁷ to 10⁻¹¹, mean of ten | 0.1 | 0.5 to 1.8 | 50 to 90 |
    /// | `LineIntegral::order4()` | 1.2 | 1.4 | 1.5 |
    /// | `LineIntegral::order6()` | 0.92 | 1.4 | 1.7 |
    /// | `LineIntegral::order8()` | 0.66 | 1.4 | 2.0 |
    /// | `LineIntegral::order10()` | 0.56 | 1.7 | 2.6 |
    /// | `Gauss::order16()`, at 10⁻⁹ to 10⁻¹² | 0.01 | 0.9 | 3 |
    ///
    /// In close encounters explicit schemes need a finer tolerance: at e = 0.9999 they need 10⁻⁸ or less for what the energy-exact ones
    /// give at any tolerance.
    ///
    /// Other sets of its stages are within 0.07 to 1.5 at e = 0.9, but for `SuzukiUmeno8` (3) and `Yoshida8` (10). Steps are made for
    /// a radian of the local motion at most, of `Gauss`, `LineIntegral` and `RungeKuttaNystrom` for 1.25 radians, so that very large
    /// tolerances give smaller errors than that. On other laws the errors relate to one another as the tolerances do, once the steps see
    /// the motion change; how large they are depends on the motion. Of a Morse bond swinging with half its depth the energy is off by
    /// 2·10⁻¹¹ with `Gauss` at 10⁻⁸, by 4·10⁻⁹ at 10⁻¹⁰ and by 5·10⁻¹³ at 10⁻¹²: the first tolerance asked for steps that do not see its
    /// wall, and were shortened to a quarter.
    ///
    /// It is for motions in `f64`: those in other scalars take equal steps.
    ///
    /// **`dt` beside it is the longest step.** A law that names the time, a scene with a driven body, and a law whose force does not vary
    /// where the motion is (free flight before a wall), need one; without it the run ends with
    /// [`Error::NoTimeScale`](crate::Error::NoTimeScale). Times are a compensated sum of the steps, and the last step of
    /// [`run_until`](Simulation::run_until) is shortened to land on the end exactly; [`run`](Simulation::run) and
    /// [`record_every`](Simulation::record_every) count steps. To find the next step the
    /// rule looks at ∂a/∂q five times, which the report counts as five evaluations. Steps that turn the motion by less than 1/16 radian
    /// are made in rows of equal steps. The rule looks once per row, or before a longest step has passed, and ends a row early if the
    /// motion has become fast.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/quartic.md")]
    /// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
    /// let run = quartic.scheme(Composed::order6(DiscreteGradient)).adaptive(1e-6).run_until(100.0)?;
    /// assert_eq!(run.last().t, 100.0);
    /// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
    /// println!("{run}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When run: [`Error::Tolerance`](crate::Error::Tolerance), and [`Error::TurnVanished`](crate::Error::TurnVanished) for one so small
    /// that a step would turn the motion by less than 2⁻⁵², as 4·10⁻³² does of `DiscreteGradient` and 10⁻²⁶⁰ of `Gauss`;
    /// [`Error::NoTimeScale`](crate::Error::NoTimeScale), and [`Error::StepVanished`](crate::Error::StepVanished) in a collision, or
    /// where 4096 rows had no step longer than 2⁻⁵³ of the time that is left.
    pub fn adaptive(self, tolerance: f64) -> Simulation<L, X, Adaptive<S>, O>
    where
        S: Adaptable,
    {
        let scheme = Adaptive::new(self.scheme, tolerance);
        self.scheme(scheme)
    }
}

impl<L, S, O, const D: usize, R: Real> Simulation<L, State<D, R>, S, O> {
    /// The mass of the particle (default 1); with [`masses`](Simulation::masses) the unit that they are in.
    pub fn mass(self, mass: f64) -> Self {
        self.with(|settings| settings.mass = mass)
    }

    /// A mass for each coordinate, mᵢ qᵢ″ = −∂Φ/∂qᵢ + Fᵢ, in units of [`mass`](Simulation::mass): for several bodies in
    /// one law.
    ///
    /// Every scheme keeps its order and what it promises, K = Σ mᵢ vᵢ²/2 being the kinetic energy; the angular momentum is
    /// not watched. See [`Masses`] for what happens; a simulation with one mass has none of it. A mass that is not positive
    /// and finite is refused with [`Error::Mass`] when the simulation is run.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    /// /// Two bodies on a line, Φ = k (x − y)²/2: the heavy one hardly moves.
    /// struct Bond { k: f64 }
    /// # impl Conservative for Bond {}
    /// # impl Potential<2> for Bond {
    /// #     fn potential(&self, [x, y]: [f64; 2]) -> f64 { 0.5 * self.k * (x - y) * (x - y) }
    /// #     fn gradient(&self, [x, y]: [f64; 2]) -> [f64; 2] { [self.k * (x - y), self.k * (y - x)] }
    /// #     fn hessian(&self, _: [f64; 2]) -> [[f64; 2]; 2] { [[self.k, -self.k], [-self.k, self.k]] }
    /// #     fn discrete_gradient(&self, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    /// #         self.gradient([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])])
    /// #     }
    /// #     fn discrete_gradient_jacobian(&self, a: [f64; 2], _: [f64; 2]) -> [[f64; 2]; 2] {
    /// #         self.hessian(a).map(|row| row.map(|x| 0.5 * x))
    /// #     }
    /// # }
    /// let run = Simulation::new(Bond { k: 4.0 }, State::new([1.0, 0.0], [0.0, 0.0]))
    ///     .masses([1.0, 1836.0])
    ///     .scheme(DiscreteGradient)
    ///     .dt(0.01)
    ///     .run(10_000)?;
    /// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
    /// assert!(run.states().iter().all(|state| state.q[1].abs() < 2.0 / 1837.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn masses(self, masses: [f64; D]) -> Simulation<Masses<L, D>, State<D, R>, S, O>
    where
        L: MassIndependent,
    {
        let Simulation { law, start, scheme, settings, attend } = self;
        Simulation { law: Masses::new(law, masses), start, scheme, settings, attend }
    }
}

// The bounds stand on the methods and not on the block: a scheme that does not fit the law is then told in words.
impl<L, X, S, O> Simulation<L, X, S, O> {
    /// A stepper, which neither records nor allocates; events, observers and streams belong to runs.
    ///
    /// # Errors
    /// [`Error`] for input that is refused.
    pub fn stepper(self) -> Result<Stepper<X::System, S>, Error>
    where
        X: Setup<L>,
        S: Scheme<X::System>,
    {
        let dt = self.settings.step_length::<<X::System as System>::Scalar>(&self.scheme);
        Stepper::new(self.settings.open(dt, self.law, self.start)?, self.scheme)
    }

    /// Makes a number of steps, or fewer where an event or an observer stops the run.
    ///
    /// # Errors
    /// [`Interrupted`] with everything recorded so far: input that is refused, a step that does not converge, a state
    /// that is not finite, bodies that meet where their law is singular.
    pub fn run(self, steps: u64) -> Result<Run<X::State>, Interrupted<X::State>>
    where
        X: Setup<L>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
    {
        self.record(Span::Steps(steps), true)
    }

    /// Makes as many steps as it takes to reach the time `end`: ⌈n⌉ with n = (end − t₀)/dt, where an n that is a whole
    /// number but for rounding, or for 10⁻⁹ of it and a thousandth of a step at most, is that number. The last state may lie
    /// beyond `end` by less than dt, also after an event that [changes](Simulation::change_when) the motion, where the steps begin anew;
    /// `.stop_when(|s| s.t - end, Crossing::Rising)` ends the run at `end` itself. Steps that are [`adaptive`](Simulation::adaptive) end
    /// there exactly.
    ///
    /// # Errors
    /// As [`run`](Simulation::run); an `end` before the start is refused.
    pub fn run_until(self, end: f64) -> Result<Run<X::State>, Interrupted<X::State>>
    where
        X: Setup<L>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
    {
        self.record(Span::Until(end), true)
    }

    /// Runs it, and keeps the histories of its invariants or not.
    pub(crate) fn record(self, span: Span, histories: bool) -> Result<Run<X::State>, Interrupted<X::State>>
    where
        X: Setup<L>,
        S: Scheme<X::System>,
        O: Attend<X::State>,
    {
        let (bare, attend) = self.apart();
        let (mut stepper, run, plan) = bare.set_out(span)?;
        stepper.scheme.watch(true, &mut stepper.workspace);
        record(&mut stepper, run, plan, (attend, histories))
    }
}

impl<L, X: Setup<L>, S: Scheme<X::System>> Simulation<L, X, S> {
    /// Everything that a run begins with, whatever accompanies it.
    pub(crate) fn set_out(self, span: Span) -> SetOut<Stepper<X::System, S>, X::State> {
        let Simulation { law, start, scheme, settings, attend: () } = self;
        let scheme = if let Span::Until(end) = span { scheme.until(end) } else { scheme };
        let pace = settings.pace::<<X::System as System>::Scalar>(&scheme, start.whole_mass(settings.mass));
        let (opening, run, plan) = settings.set_out(pace, law, start, span)?;
        match Stepper::new(opening, scheme) {
            Ok(stepper) => Ok((stepper, run, plan)),
            Err(cause) => Err(Interrupted::new(run, cause)),
        }
    }
}

/// What moves, a run without a state, and how far it goes.
type SetOut<Y, X> = Result<(Y, Run<X>, Extent), Interrupted<X>>;

/// What a scheme says of the steps of a run, whatever moves.
struct Stepping {
    dt: Result<f64, Error>,
    /// Whether they are of equal length.
    equal: bool,
    report: Report,
}

/// How far a run goes, and what it records.
pub(crate) struct Extent {
    /// Steps that it makes, or fewer if the motion arrives or is stopped before.
    pub(crate) steps: u64,
    /// The time to which they were counted, if they were.
    pub(crate) until: Option<f64>,
    /// States that it will record, as far as their number is known.
    pub(crate) states: u64,
    pub(crate) settings: Settings,
}

/// A simulation that is accompanied by one thing more.
pub type Attended<L, X, S, O, A> = Simulation<L, X, S, (O, A)>;
