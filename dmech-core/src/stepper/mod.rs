//! Stepping without recording.

mod departure;
mod parts;

use dmech_scalar::{Count, Real};

use crate::error::Error;
use crate::law::Law;
use crate::newton::NotConverged;
use crate::scheme::Scheme;
use crate::span::{is_possible, possible};
use crate::system::{Effort, Particle, System};
pub(crate) use departure::{Departure, Opening};
pub(crate) use parts::in_parts;

/// A simulation advanced by hand: it records nothing and, once it is made, allocates nothing.
///
/// Time is t₀ + k h after k equal steps, never a running sum. A step that fails leaves the motion where it was.
#[derive(Debug)]
#[must_use = "a stepper does nothing until it makes a step"]
pub struct Stepper<Y: System, S: Scheme<Y>> {
    pub(crate) system: Y,
    pub(crate) scheme: S,
    pub(crate) stride: Y::Stride,
    pub(crate) workspace: S::Workspace,
    pub(crate) dt: f64,
    pub(crate) start: Y::State,
    pub(crate) memory: S::Memory,
    /// Room for the next memory, where a new one is not free.
    spare: Option<S::Memory>,
    /// The time of the first start: a change on the way is a new one.
    #[cfg_attr(not(feature = "serde"), expect(dead_code, reason = "only checkpoints ask for it"))]
    pub(crate) first: f64,
    /// Steps since the start, and those before it.
    pub(crate) steps: u64,
    pub(crate) steps_before: u64,
    /// The start is still to be begun from: a law that was changed has had no value there.
    pub(crate) waits: bool,
    pub(crate) evaluations: u64,
    pub(crate) iterations: u64,
}

impl<Y: System + Clone, S: Scheme<Y>> Clone for Stepper<Y, S> {
    fn clone(&self) -> Self {
        Stepper {
            system: self.system.clone(),
            scheme: self.scheme,
            stride: self.stride.clone(),
            workspace: self.workspace.clone(),
            start: self.start.clone(),
            memory: self.memory.clone(),
            spare: self.spare.clone(),
            ..*self
        }
    }
}

/// What a scheme carries from a state on, which is that before a step.
#[inline(never)]
fn begun<Y: System, S: Scheme<Y>>(
    step: u64,
    system: &Y,
    scheme: &S,
    stride: &Y::Stride,
    departure: &Departure<Y>,
    workspace: &mut S::Workspace,
) -> Result<S::Memory, Error> {
    match scheme.begin(system, stride, &departure.beginning(), workspace) {
        Ok(memory) => scheme.ready(step, &memory).map(|()| memory),
        // A start that solves an equation makes a step backward.
        Err(cause) => Err(departure.unsolved(system, step - 1, -Y::dt(stride).to_f64(), cause)),
    }
}

impl<Y: System, S: Scheme<Y>> Stepper<Y, S> {
    /// The system must have been made for this start, and the step be checked.
    pub(crate) fn new(opening: Opening<Y>, scheme: S) -> Result<Self, Error> {
        let Opening { system, start, departure, dt } = opening;
        let stride = system.stride(Y::Scalar::from_f64(dt), S::SHARE);
        let mut workspace = scheme.workspace(&system, &stride);
        let memory = begun(1, &system, &scheme, &stride, &departure, &mut workspace)?;
        let spare = if Y::IN_REGISTERS { None } else { Some(memory.clone()) };
        let first = Y::time(&start);
        Ok(Stepper {
            system,
            scheme,
            stride,
            workspace,
            dt,
            start,
            memory,
            spare,
            first,
            steps: 0,
            steps_before: 0,
            waits: false,
            evaluations: 0,
            iterations: 0,
        })
    }

    /// Begins anew from a state; what fails leaves everything as it was.
    pub(crate) fn begin_from(&mut self, start: Y::State) -> Result<(), Error> {
        self.begin_at(Departure::after(self.steps(), &self.system, start))
    }

    /// Begins anew where it can be departed from.
    pub(crate) fn begin_at(&mut self, departure: Result<(Y::State, Departure<Y>), Error>) -> Result<(), Error> {
        let step = self.steps() + 1;
        let Stepper { system, scheme, stride, workspace, .. } = self;
        let (start, departure) = departure?;
        let mut memory = begun(step, system, scheme, stride, &departure, workspace)?;
        scheme.tell_on(&self.memory, &mut memory);
        self.steps_before += core::mem::take(&mut self.steps);
        (self.start, self.memory, self.waits) = (start, memory, false);
        Ok(())
    }

    /// Begins anew from a state, or as soon as the law has a value there: the next step begins then, or says why it cannot.
    pub(crate) fn begin_or_wait_at(&mut self, start: Y::State) {
        if self.begin_from(start.clone()).is_err() {
            self.steps_before += core::mem::take(&mut self.steps);
            (self.start, self.waits) = (start, true);
        }
    }

    #[cold]
    fn begin_at_last(&mut self) -> Result<(), Error> {
        self.begin_from(self.start.clone())
    }

    /// Advances by one time step.
    ///
    /// # Errors
    /// [`Error::NotConverged`], [`Error::LawInStep`] or [`Error::NotFinite`]; for scenes [`Error::Link`], [`Error::Body`] and
    /// [`Error::Path`] where it can be said between or on which bodies a law is not finite. The stepper then stays where it was.
    #[inline(always)]
    pub fn step(&mut self) -> Result<(), Error> {
        self.step_and(|_, _, _| ())
    }

    /// Makes a step and shows the memory before and after it.
    #[inline(always)]
    pub(crate) fn step_and(&mut self, see: impl FnOnce(&Self, &S::Memory, &S::Memory)) -> Result<(), Error> {
        self.may_step()?;
        let (mut next, mut spent, mut shorter) = (self.copy(), Effort::default(), 0);
        while let Err(cause) = self.attempt(&mut next, &mut spent) {
            // Said here, so that of schemes without shorter steps nothing is left of the loop.
            let helps = cause.is_some() || self.scheme.too_long(&next);
            let memory = if helps { self.shortened(shorter + 1) } else { None };
            let Some(memory) = memory else { return Err(self.failure(cause, next, shorter)) };
            next.clone_from(&memory);
            shorter += 1;
        }
        self.steps += 1;
        self.evaluations += spent.evaluations.to_u64();
        self.iterations += spent.iterations.to_u64();
        see(self, &self.memory, &next);
        self.go_on_from(next);
        Ok(())
    }

    /// Whether there is a next step.
    #[inline(always)]
    fn may_step(&mut self) -> Result<(), Error> {
        if self.waits {
            self.begin_at_last()?;
        }
        // Only a scalar narrower than the time may not tell this step from the next.
        if self.system.resolution() > f64::EPSILON {
            is_possible(self.t(), self.dt, self.resolution())?;
        }
        self.scheme.ready(self.steps() + 1, &self.memory)
    }

    /// Makes a step from the memory before it, which is no longer that; why it is not to stand, if it is not.
    #[inline(always)]
    fn attempt(&mut self, next: &mut S::Memory, spent: &mut Effort<Y::Scalar>) -> Result<(), Option<NotConverged>> {
        let t = Y::Scalar::from_f64(self.t());
        match self.scheme.step(&self.system, &self.stride, t, next, &mut self.workspace) {
            Err(cause) => Err(Some(cause)),
            Ok(effort) => {
                *spent += effort;
                let stands = self.scheme.finite(next) && self.is_placed(self.steps + 1, next);
                if stands && !self.scheme.too_long(next) { Ok(()) } else { Err(None) }
            }
        }
    }

    /// The memory before a step that has been shortened so often, if it can be.
    #[cold]
    fn shortened(&self, times: u32) -> Option<S::Memory> {
        let mut memory = self.memory.clone();
        (0..times).all(|_| self.scheme.shorten(&self.stride, &mut memory)).then_some(memory)
    }

    /// Why the next step failed, which has been shortened so often and left `after` behind.
    #[cold]
    fn failure(&mut self, cause: Option<NotConverged>, after: S::Memory, times: u32) -> Error {
        let (step, t) = (self.steps() + 1, self.t());
        let dt = match self.shortened(times) {
            Some(memory) => self.scheme.next_dt(self.dt, &memory),
            None => self.next_dt(),
        };
        let v = self.velocity(t);
        let error = match cause {
            Some(cause) => self.system.unsolved(step, [self.position(), &v], t, dt, cause),
            None => self.system.not_finite(step, [self.scheme.position(&after), &v], t, dt),
        };
        self.lay_aside(after);
        error
    }

    /// To what steps of equal length must change the time.
    #[inline(always)]
    pub(crate) fn resolution(&self) -> Option<f64> {
        self.scheme.tolerance().is_none().then(|| self.system.resolution())
    }

    /// Whether driven bodies are somewhere after so many steps from the start.
    #[inline(always)]
    fn is_placed(&self, steps: u64, memory: &S::Memory) -> bool {
        self.system.is_placed(self.scheme.time(Y::time(&self.start), steps, self.dt, memory))
    }

    /// The memory once more, for steps that may fail.
    #[inline(always)]
    fn copy(&mut self) -> S::Memory {
        if !Y::IN_REGISTERS
            && let Some(mut spare) = self.spare.take()
        {
            spare.clone_from(&self.memory);
            return spare;
        }
        self.memory.clone()
    }

    /// Puts a memory in the place of the one that was. No swap: of what has an address nothing stays in registers.
    #[inline(always)]
    fn go_on_from(&mut self, memory: S::Memory) {
        if Y::IN_REGISTERS {
            self.memory = memory;
        } else {
            self.spare = Some(core::mem::replace(&mut self.memory, memory));
        }
    }

    #[inline(always)]
    fn lay_aside(&mut self, spare: S::Memory) {
        if !Y::IN_REGISTERS {
            self.spare = Some(spare);
        }
    }

    /// Advances by several steps, with nothing in the loop but the scheme: whether the motion is finite is looked at
    /// once, at the end. The states are those of as many calls of [`step`](Stepper::step).
    ///
    /// # Errors
    /// As [`step`](Stepper::step); the stepper then stands before the step that failed. It does not begin where so many steps
    /// would lead to [`Error::TimeStandsStill`].
    #[inline]
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        if self.waits {
            self.begin_at_last()?;
        }
        let end = self.steps.saturating_add(possible(steps, self.t(), self.dt, self.resolution())?);
        let mut last = self.copy();
        self.scheme.watch(false, &mut self.workspace);
        let made = if let Some([evaluations, iterations]) = self.run_to(end, &mut last) {
            self.go_on_from(last);
            (self.steps, self.evaluations, self.iterations) = (end, evaluations, iterations);
            Ok(())
        } else {
            self.lay_aside(last);
            self.one_by_one(steps)
        };
        self.scheme.watch(true, &mut self.workspace);
        made
    }

    /// Steps until there are `end`; the evaluations and corrections then, or nothing if a step failed.
    #[inline(always)]
    fn run_to(&mut self, end: u64, memory: &mut S::Memory) -> Option<[u64; 2]> {
        let (mut evaluations, mut iterations) = (self.evaluations, self.iterations);
        let start = Y::time(&self.start);
        for step in self.steps..end {
            self.scheme.ready(step + 1, memory).ok()?;
            let t = Y::Scalar::from_f64(self.scheme.time(start, step, self.dt, memory));
            let effort = self.scheme.step(&self.system, &self.stride, t, memory, &mut self.workspace).ok()?;
            evaluations += effort.evaluations.to_u64();
            iterations += effort.iterations.to_u64();
            if self.scheme.too_long(memory) || !self.is_placed(step + 1, memory) {
                return None;
            }
        }
        self.scheme.finite(memory).then_some([evaluations, iterations])
    }

    /// Finds the step that fails.
    #[cold]
    fn one_by_one(&mut self, steps: u64) -> Result<(), Error> {
        (0..steps).try_for_each(|_| self.step())
    }

    /// Position and velocity now.
    pub fn state(&self) -> Y::State {
        if self.steps == 0 {
            return self.start.clone();
        }
        let t = self.t();
        self.system.state(t, self.position(), &self.velocity(t))
    }

    /// The state at a time in the next step, both ends included, by a shortened step of the same scheme: the stepper does not move, and
    /// what it returns has the order of the scheme. Where that has no solution, as on a seam at which a force jumps, it is made in parts.
    /// For pictures between the steps of a game, for output at given times.
    ///
    /// # Errors
    /// [`Error::OutsideStep`]; otherwise as [`step`](Stepper::step).
    pub fn at(&self, t: f64) -> Result<Y::State, Error> {
        let now = self.t();
        let end = now + self.next_dt();
        // The time at its end, t₀ + (k + 1) h, may be another number than this sum.
        let rounding = 4.0 * f64::EPSILON * end.abs().max(Y::time(&self.start).abs());
        if !(now..=end + rounding).contains(&t) {
            return Err(Error::OutsideStep { time: t, from: now, to: end });
        }
        if self.waits {
            Departure::after(self.steps(), &self.system, self.start.clone())?;
        }
        let single = |from: &Y::State, t| self.between(self.steps() + 1, from, t);
        in_parts(&single, Y::time, &self.state(), t).map(|(state, _)| state)
    }

    /// The state at a later time, within a step of a number, by a single one from a state; and the evaluations and corrections that it
    /// takes.
    pub(crate) fn between(&self, step: u64, from: &Y::State, t: f64) -> Result<(Y::State, [u64; 2]), Error> {
        let (system, start) = (&self.system, Y::time(from));
        if t == start {
            return Ok((from.clone(), [0; 2]));
        }
        let departure = Departure::passed(system, from);
        let reached = self.scheme.within(system, Y::Scalar::from_f64(t - start), &departure.beginning());
        departure.reached(system, step, t, reached)
    }

    /// The length of the next step, if it is not made again by a shorter one, as a step that follows the motion may be.
    pub fn next_dt(&self) -> f64 {
        self.scheme.next_dt(self.dt, &self.memory)
    }

    fn velocity(&self, t: f64) -> Y::Vector {
        self.scheme.velocity(&self.system, &self.stride, Y::Scalar::from_f64(t), &self.memory)
    }

    /// Time now: t₀ + k h, or the compensated sum of the steps where those follow the motion.
    #[inline]
    pub fn t(&self) -> f64 {
        self.scheme.time(Y::time(&self.start), self.steps, self.dt, &self.memory)
    }

    /// Position now: an array for one law, columns for many bodies.
    #[inline]
    pub fn position(&self) -> &Y::Vector {
        self.scheme.position(&self.memory)
    }

    /// Steps made.
    pub fn steps(&self) -> u64 {
        self.steps_before + self.steps
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

    /// What moves.
    pub fn system(&self) -> &Y {
        &self.system
    }

    /// The time step; infinite where steps follow the motion without a longest.
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// Whether the end is reached, where the scheme knows it: an [`Adaptive`](crate::Adaptive) one with an end.
    #[inline(always)]
    pub fn arrived(&self) -> bool {
        self.scheme.arrived(&self.memory)
    }

    /// Goes to where a checkpoint stands.
    #[cfg(feature = "serde")]
    pub(crate) fn put(&mut self, start: Y::State, memory: S::Memory, counts: [u64; 4]) {
        (self.start, self.memory) = (start, memory);
        [self.steps_before, self.steps, self.evaluations, self.iterations] = counts;
    }
}

impl<L: Law<D, R>, S: Scheme<Particle<L, D, R>>, const D: usize, R: Real> Stepper<Particle<L, D, R>, S> {
    /// Position now.
    #[inline]
    pub fn q(&self) -> [R; D] {
        *self.position()
    }

    /// The law.
    pub fn law(&self) -> &L {
        self.system.law()
    }
}
