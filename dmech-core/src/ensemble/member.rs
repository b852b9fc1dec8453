//! A member on its way.

use std::time::Duration;

use super::block::{Block, Outcome};
use crate::error::Error;
use crate::law::Fields;
use crate::run::{Attend, Due, Extent, Follow, Interrupted, Log, Motion, Run};
use crate::scheme::Scheme;
use crate::state::State;
use crate::stepper::Stepper;
use crate::system::Particle;

/// A member on its way.
pub(super) struct Member<L: Fields<D>, S: Scheme<Particle<L, D>>, O, const D: usize> {
    pub(super) k: usize,
    pub(super) stepper: Stepper<Particle<L, D>, S>,
    pub(super) log: LogOf<O, D>,
    /// Steps that are left to make.
    pub(super) left: u64,
    /// Steps from one look at the invariants to the next; none where states are recorded by time.
    pub(super) every: Option<u64>,
    /// The state before a step that is to be looked into.
    before: Option<State<D>>,
    /// Where it was stopped, or why it failed.
    outcome: Result<Option<State<D>>, Error>,
}

impl<L: Fields<D>, S: Scheme<Particle<L, D>>, O: Attend<State<D>>, const D: usize> Member<L, S, O, D> {
    pub(super) fn begin(block: &Block<'_, L, S, O, D>, k: usize) -> Result<Self, Interrupted<State<D>>> {
        let (simulation, attend) = (block.member)(k).apart();
        let (mut stepper, run, Extent { steps, until, states, settings }) = simulation.set_out(block.span)?;
        let due = settings.due;
        let every = if let Due::Every(n) = due { Some(n) } else { None };
        stepper.scheme.watch(S::SEES_ROUGH || block.work, &mut stepper.workspace);
        let (mut log, outcome) = begin_log(&stepper, run, due, attend, (states, block.work))?;
        (log.until, log.ends_at) = (until, steps);
        // It may begin where it is to end.
        let left = if stepper.arrived() { 0 } else { steps };
        Ok(Member { k, stepper, log, left, every, before: None, outcome })
    }

    pub(super) fn has_ended(&self) -> bool {
        self.left == 0 || self.is_stopped()
    }

    /// By an event or an observer, or as it has failed.
    pub(super) fn is_stopped(&self) -> bool {
        !matches!(self.outcome, Ok(None))
    }

    /// The numbers of its law, and its mass.
    pub(super) fn numbers(&self) -> (L::Numbers, f64) {
        (self.stepper.law().numbers(), self.stepper.system.mass())
    }

    /// Whether the next step may reach a time at which a state is due.
    pub(super) fn is_due(&self) -> bool {
        self.log.is_due_before(&self.stepper)
    }

    /// Steps that do not reach such a time, but one at least.
    pub(super) fn free(&self) -> u64 {
        let Some(next) = self.log.next else { return u64::MAX };
        (((next - self.stepper.t()) / self.stepper.dt() - 1.01) as u64).max(1)
    }

    pub(super) fn remember(&mut self) {
        self.before = (O::EVENTS > 0 || self.is_due()).then(|| self.stepper.state());
    }

    /// So many steps alone, or fewer if it ends.
    pub(super) fn advance(&mut self, steps: u64) {
        if !self.has_ended() {
            self.outcome = self.log.go(&mut self.stepper, steps, &mut Follow::nobody());
        }
        self.left = self.left();
    }

    fn left(&self) -> u64 {
        if self.stepper.arrived() { 0 } else { self.log.ends_at - self.stepper.steps() }
    }

    /// Goes on from where an event has changed its motion in a lane.
    pub(super) fn change(&mut self) {
        match self.log.change(&mut self.stepper) {
            Ok(_) => self.left = self.left(),
            Err(cause) => self.outcome = Err(cause),
        }
    }

    /// All its steps alone.
    pub(super) fn alone(mut self) -> Self {
        self.advance(u64::MAX);
        self
    }

    /// Everything that follows a step that all have made.
    pub(super) fn look_back(&mut self) {
        self.outcome = what_followed(&mut self.stepper, &mut self.log, self.before.take());
        if O::CHANGES {
            self.left = self.left();
        }
    }

    /// Events of a step that was made in a lane.
    #[inline]
    pub(super) fn meet(&mut self, start: f64, before: impl Fn() -> State<D>, after: &State<D>) {
        match self.log.look_into_the_step(&self.stepper, start, &before, after) {
            Ok(None) => {}
            outcome => self.outcome = outcome,
        }
    }

    /// A look that is due, at a state in a lane, beside the invariants of all laws.
    pub(super) fn look(&mut self, now: State<D>) {
        if let Err(cause) = self.log.look_beside(&self.stepper, now) {
            self.outcome = Err(cause);
        }
    }

    /// Shows the state in a lane to those who observe it.
    pub(super) fn observe(&mut self, now: impl Fn() -> State<D>) {
        if let Some(stopped) = self.log.observe(self.stepper.steps(), &mut || now()) {
            self.outcome = Ok(Some(stopped));
        }
    }

    pub(super) fn end(self) -> Outcome<State<D>> {
        let Member { stepper, mut log, outcome, .. } = self;
        let outcome = outcome.and_then(|stopped| {
            if stopped.is_none() {
                log.record_at_the_end(&stepper)?;
            }
            Ok(stopped)
        });
        log.close(&stepper, outcome, Duration::ZERO)
    }
}

/// What is written down of a member, and whether it has begun: whatever moves it.
type Started<O, const D: usize> = (LogOf<O, D>, Result<Option<State<D>>, Error>);

type LogOf<O, const D: usize> = Log<State<D>, f64, (O, Forget)>;

fn begin_log<O: Attend<State<D>>, const D: usize>(
    motion: &dyn Motion<State<D>, f64>,
    run: Run<State<D>>,
    due: Due,
    attend: O,
    (expected, work): (u64, bool),
) -> Result<Started<O, D>, Interrupted<State<D>>> {
    let states = matches!(due, Due::Every(_));
    let mut log = Log::new(motion, run, due, (attend, Forget { states }));
    if !states && !O::STREAMS {
        log = log.with_room(motion, expected)?;
    }
    if !work {
        log.watch.forget_work();
    }
    let outcome = log.begin(motion).map(|()| None);
    Ok((log, outcome))
}

/// What followed a step, from a state into which it is to be looked if there is one: where the member was stopped.
fn what_followed<O: Attend<State<D>>, const D: usize>(
    motion: &mut dyn Motion<State<D>, f64>,
    log: &mut LogOf<O, D>,
    before: Option<State<D>>,
) -> Result<Option<State<D>>, Error> {
    if let Some(before) = before
        && let Some(stopped) = log.look_into_the_step(motion, before.t, &|| before, &motion.state())?
    {
        return Ok(Some(stopped));
    }
    if O::CHANGES {
        log.change(motion)?;
    }
    log.count(motion, 0)?;
    Ok(log.observe(motion.steps(), &mut || motion.state()))
}

/// Looks at the states that are due, and keeps none, where they are to be forgotten.
#[derive(Clone, Copy, Debug)]
pub(super) struct Forget {
    pub(super) states: bool,
}

impl<X> Attend<X> for Forget {
    const STREAMS: bool = true;

    fn take(&mut self, _: &X) -> Result<bool, Error> {
        Ok(self.states)
    }
}
