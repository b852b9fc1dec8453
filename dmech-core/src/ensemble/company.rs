//! What accompanies each member.

use crate::run::{After, Attend, Bounce, Changed, Crossing, Observer, Passage, Quantity, Sink, Stream};

use core::marker::PhantomData;
use core::ops::ControlFlow;

/// What accompanies a member beside its record, from nothing on: events, observers, streams, watched quantities, each as a
/// [`Simulation`](crate::Simulation) has it.
pub struct Company<X, O = ()> {
    attend: O,
    state: PhantomData<fn(X)>,
}

/// A company and one thing more.
pub type Joined<X, O, A> = Company<X, (O, A)>;

impl<X> Company<X> {
    pub(super) const NONE: Self = Company { attend: (), state: PhantomData };
}

impl<X, O> Company<X, O> {
    pub(super) fn attend(self) -> O {
        self.attend
    }

    fn and<A>(self, also: A) -> Joined<X, O, A> {
        Company { attend: (self.attend, also), state: PhantomData }
    }

    /// Passages of a function of the state through zero: [`Simulation::event`](crate::Simulation::event).
    pub fn event<F: FnMut(&X) -> f64>(self, function: F, crossing: Crossing) -> Joined<X, O, Passage<F>> {
        self.and(Passage::new(function, crossing, After::Nothing))
    }

    /// The same, and the member ends there: [`Simulation::stop_when`](crate::Simulation::stop_when).
    pub fn stop_when<F: FnMut(&X) -> f64>(self, function: F, crossing: Crossing) -> Joined<X, O, Passage<F>> {
        self.and(Passage::new(function, crossing, After::Stop))
    }

    /// The same, and the member goes on from another state: [`Simulation::change_when`](crate::Simulation::change_when).
    pub fn change_when<F: FnMut(&X) -> f64, C: FnMut(&mut X)>(
        self,
        function: F,
        crossing: Crossing,
        change: C,
    ) -> Joined<X, O, Passage<F, Changed<C>>> {
        self.and(Passage::changing(function, crossing, change))
    }

    /// A wall: [`Simulation::bounce_off`](crate::Simulation::bounce_off).
    pub fn bounce_off<F: FnMut(&X) -> f64, C: FnMut(&mut X)>(
        self,
        function: F,
        change: C,
    ) -> Joined<X, O, Bounce<F, C>> {
        self.and(Bounce::new(function, change))
    }

    /// A quantity whose drift is looked at: [`Simulation::watch`](crate::Simulation::watch).
    pub fn watch<F: FnMut(&X) -> f64>(self, name: &'static str, function: F) -> Joined<X, O, Quantity<F>> {
        self.and(Quantity::new(name, function))
    }

    /// The state after every n-th step, to a function that may stop the member:
    /// [`Simulation::observe`](crate::Simulation::observe).
    pub fn observe<F: FnMut(&X) -> ControlFlow<()>>(self, n: u64, function: F) -> Joined<X, O, Observer<F>> {
        self.and(Observer::new(n, function))
    }

    /// A file of its own for the states that are due: [`Simulation::stream`](crate::Simulation::stream).
    pub fn stream<W: Sink<X>>(self, sink: W) -> Joined<X, O, Stream<W>> {
        self.and(Stream::new(sink))
    }
}

impl<X, O> core::fmt::Debug for Company<X, O> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Company").finish_non_exhaustive()
    }
}

/// In the type of an ensemble whose members nothing accompanies.
#[derive(Clone, Copy, Debug)]
pub struct NoCompany;

/// In the type of an ensemble whose members have [company](crate::Ensemble::with).
#[derive(Clone, Copy)]
pub struct With<F>(pub(super) F);

impl<F> core::fmt::Debug for With<F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("With")
    }
}

/// What makes the company of each member.
pub trait Companies<X>: Sync {
    /// What accompanies one.
    type Attend: Attend<X>;

    /// That of one, by its number.
    #[doc(hidden)]
    fn of(&self, k: usize) -> Self::Attend;
}

impl<X> Companies<X> for NoCompany {
    type Attend = ();

    fn of(&self, _: usize) {}
}

impl<X, F, O> Companies<X> for With<F>
where
    F: Fn(usize, Company<X>) -> Company<X, O> + Sync,
    O: Attend<X>,
{
    type Attend = O;

    fn of(&self, k: usize) -> O {
        (self.0)(k, Company::NONE).attend()
    }
}
