//! Stepping without recording.

use dmech_scalar::{Mask, Real};

use crate::error::Error;
use crate::fault::Attempt;
use crate::law::{Field, Law, Potential};
use crate::motion::{Motion, moves_on, steps_from};
use crate::newton::NotConverged;
use crate::range::lost_force;
use crate::scheme::{Scheme, Stride};
use crate::state::State;
use crate::watch::{Drifts, Watch};
use crate::written::{Place, agree};

/// A simulation advanced by hand: it records nothing and allocates nothing.
///
/// Time is t₀ + k h after k equal steps, never a running sum.
#[derive(Clone, Debug)]
pub struct Stepper<L, S: Scheme<L, D, R>, const D: usize, R: Real = f64> {
    law: L,
    scheme: S,
    stride: Stride<R>,
    dt: f64,
    start: State<D, R>,
    memory: S::Memory,
    steps: u64,
    evaluations: u64,
    iterations: u64,
}

impl<L: Law<D, R>, S: Scheme<L, D, R>, const D: usize, R: Real> Stepper<L, S, D, R> {
    pub(crate) fn new(law: L, scheme: S, start: State<D, R>, dt: f64, mass: f64) -> Result<Self, Error> {
        check(scheme.tolerance(), dt, mass, law.mass_ratios(), &start)?;
        moves_on(start.t, dt)?;
        let stride = Stride::new(R::from_f64(dt), R::from_f64(mass));
        let field = law.field(stride.mass, R::from_f64(start.t));
        let potential = field.potential(start.q);
        if !potential.finite().all() {
            return Err(Error::Law { quantity: "potential", value: potential.to_f64(), time: start.t });
        }
        if let Some(value) = field.slope(start.q, start.v).into_iter().find(|x| !x.finite().all()) {
            return Err(Error::Law { quantity: "force", value: value.to_f64(), time: start.t });
        }
        if let Some((coordinate, slope)) = lost_force(&field, start.q) {
            return Err(Error::Underflow { coordinate, slope, time: start.t });
        }
        drop(field);
        if let Some(written) = law.written() {
            let [q, v] = [start.q, start.v].map(|x| x.map(R::to_f64));
            let place = Place { q, v: [v; 2], m: [mass; 2], t: start.t };
            agree(written, &place, true).map_err(Error::NotAsWritten)?;
        }
        let memory = match scheme.begin(&law, &stride, &start) {
            Ok(memory) => memory,
            // A start that solves an equation makes a step backward.
            Err(cause) => {
                let State { t, q, v } = start;
                return Err(Attempt { step: 0, t, dt: -dt, mass: stride.mass, q, v }.unsolved(&law, cause));
            }
        };
        scheme.ready(1, &memory)?;
        Ok(Stepper { law, scheme, stride, dt, start, memory, steps: 0, evaluations: 0, iterations: 0 })
    }

    /// Advances by one time step.
    ///
    /// # Errors
    /// [`Error::NotConverged`], [`Error::LawInStep`] or [`Error::NotFinite`]; the stepper then stays where it was.
    #[inline(always)]
    pub fn step(&mut self) -> Result<(), Error> {
        self.scheme.ready(self.steps + 1, &self.memory)?;
        let t = R::from_f64(self.t());
        let mut memory = self.memory.clone();
        match self.scheme.step(&self.law, &self.stride, t, &mut memory) {
            Ok(effort) => {
                self.evaluations += u64::from(effort.evaluations);
                self.iterations += u64::from(effort.iterations);
            }
            Err(cause) => return Err(self.not_converged(cause)),
        }
        if !self.scheme.finite(&memory) {
            return Err(self.not_finite());
        }
        self.memory = memory;
        self.steps += 1;
        Ok(())
    }

    /// Advances by several steps, with nothing in the loop but the scheme: whether the motion is finite is looked at
    /// once, at the end. The states are those of as many calls of [`step`](Stepper::step).
    ///
    /// # Errors
    /// [`Error::NotConverged`] or [`Error::NotFinite`]; the stepper then stands before the step that failed. It does not
    /// begin where so many steps would lead to [`Error::TimeStandsStill`].
    #[inline]
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        let end = self.steps.saturating_add(self.possible(steps)?);
        let mut memory = self.memory.clone();
        let (mut evaluations, mut iterations) = (self.evaluations, self.iterations);
        for step in self.steps..end {
            if self.scheme.ready(step + 1, &memory).is_err() {
                return self.one_by_one(steps);
            }
            let t = R::from_f64(self.scheme.time(self.start.t, step, self.dt, &memory));
            match self.scheme.step(&self.law, &self.stride, t, &mut memory) {
                Ok(effort) => {
                    evaluations += u64::from(effort.evaluations);
                    iterations += u64::from(effort.iterations);
                }
                Err(_) => return self.one_by_one(steps),
            }
        }
        if !self.scheme.finite(&memory) {
            return self.one_by_one(steps);
        }
        (self.memory, self.evaluations, self.iterations) = (memory, evaluations, iterations);
        self.steps = end;
        Ok(())
    }

    /// So many steps from here, if the time can tell them apart.
    pub(crate) fn possible(&self, steps: u64) -> Result<u64, Error> {
        // Steps that follow the motion look at the time themselves.
        if self.scheme.tolerance().is_some() { Ok(steps) } else { steps_from(self.t(), steps, self.dt) }
    }

    /// Finds the step that fails.
    #[cold]
    fn one_by_one(&mut self, steps: u64) -> Result<(), Error> {
        (0..steps).try_for_each(|_| self.step())
    }

    /// Position and velocity now.
    pub fn state(&self) -> State<D, R> {
        if self.steps == 0 {
            return self.start;
        }
        let t = self.t();
        let v = self.scheme.velocity(&self.law, &self.stride, R::from_f64(t), &self.memory);
        State { t, q: self.q(), v }
    }

    /// Time now: t₀ + k h, or the compensated sum of the steps where those follow the motion.
    #[inline]
    pub fn t(&self) -> f64 {
        self.scheme.time(self.start.t, self.steps, self.dt, &self.memory)
    }

    /// Position now.
    #[inline]
    pub fn q(&self) -> [R; D] {
        self.scheme.position(&self.memory)
    }

    /// Steps made.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Evaluations of the force so far, the start not counted.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// Newton corrections so far.
    pub fn iterations(&self) -> u64 {
        self.iterations
    }

    /// What the scheme carries: half-step velocities, z, compensated sums.
    pub fn memory(&self) -> &S::Memory {
        &self.memory
    }

    /// The law.
    pub fn law(&self) -> &L {
        &self.law
    }

    #[cfg(feature = "serde")]
    pub(crate) fn start(&self) -> State<D, R> {
        self.start
    }

    pub(crate) fn dt(&self) -> f64 {
        self.dt
    }

    /// Goes to where a checkpoint stands.
    #[cfg(feature = "serde")]
    pub(crate) fn put(&mut self, start: State<D, R>, mut memory: S::Memory, counts: [u64; 3]) {
        self.scheme.restore(&self.stride, &mut memory);
        (self.start, self.memory) = (start, memory);
        [self.steps, self.evaluations, self.iterations] = counts;
    }

    pub(crate) fn parts(&self) -> (&L, &S, &Stride<R>) {
        (&self.law, &self.scheme, &self.stride)
    }

    #[cold]
    fn not_converged(&self, cause: NotConverged) -> Error {
        let State { t, q, v } = self.state();
        let dt = self.scheme.next_dt(self.dt, &self.memory);
        Attempt { step: self.steps + 1, t, dt, mass: self.stride.mass, q, v }.unsolved(&self.law, cause)
    }

    #[cold]
    fn not_finite(&self) -> Error {
        Error::NotFinite { step: self.steps + 1, time: self.t(), dt: self.scheme.next_dt(self.dt, &self.memory) }
    }
}

impl<L: Law<D, R>, S: Scheme<L, D, R>, const D: usize, R: Real> Motion for Stepper<L, S, D, R> {
    type State = State<D, R>;
    type Watch = Watch<D, R>;

    fn state(&self) -> State<D, R> {
        Stepper::state(self)
    }

    fn watch(&self) -> Watch<D, R> {
        Watch::begin(self.parts(), self.start, &self.memory)
    }

    #[inline(always)]
    fn step_watched(&mut self, watch: &mut Watch<D, R>) -> Result<(), Error> {
        let before = self.memory.clone();
        self.step()?;
        watch.add_work(self.parts(), &before, &self.memory);
        Ok(())
    }

    fn observe(&self, watch: &mut Watch<D, R>, state: &State<D, R>) {
        watch.observe(self.parts(), state, &self.memory);
    }

    fn drifts(watch: &Watch<D, R>) -> Drifts {
        watch.drifts()
    }

    fn effort(&self) -> [u64; 3] {
        [self.steps, self.evaluations, self.iterations]
    }

    #[inline(always)]
    fn arrived(&self) -> bool {
        self.scheme.arrived(&self.memory)
    }

    fn range(&self) -> Option<[f64; 2]> {
        self.scheme.range(&self.memory)
    }
}

fn check<const D: usize, R: Real>(
    tolerance: Option<f64>,
    dt: f64,
    mass: f64,
    mass_ratios: [f64; D],
    start: &State<D, R>,
) -> Result<(), Error> {
    let positive = |x: f64| x > 0.0 && x.is_finite();
    if let Some(tolerance) = tolerance.filter(|&x| !positive(x)) {
        return Err(Error::Tolerance { tolerance });
    }
    let unlimited = tolerance.is_some() && dt == f64::INFINITY;
    // The scalar in use may be narrower than f64: 1e-60 is no time step in f32.
    if !unlimited && (!positive(dt) || !positive(R::from_f64(dt).to_f64())) {
        return Err(Error::TimeStep { dt });
    }
    if !positive(mass) || !positive(R::from_f64(mass).to_f64()) {
        return Err(Error::Mass { mass });
    }
    for ratio in mass_ratios {
        if !positive(ratio) || !positive(R::from_f64(ratio).to_f64()) || !positive(R::from_f64(ratio * mass).to_f64()) {
            return Err(Error::Mass { mass: ratio });
        }
    }
    if !start.t.is_finite() {
        return Err(Error::State { quantity: "t", value: start.t });
    }
    for (quantity, components) in [("q", &start.q), ("v", &start.v)] {
        if let Some(value) = components.iter().find(|x| !x.finite().all()) {
            return Err(Error::State { quantity, value: value.to_f64() });
        }
    }
    Ok(())
}
