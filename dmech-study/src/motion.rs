//! What studies ask of a motion, whatever moves.

use dmech_core::extend::{ImplicitSteps, Setup, TimeScale};
#[cfg(feature = "scene")]
use dmech_core::scene::SceneState;
use dmech_core::{Simulation, State};

/// A state whose coordinates are known one by one.
pub trait Coordinates: Clone {
    /// The positions: `[f64; D]`, or a list of them.
    type Position: Clone;

    /// The time.
    fn time(&self) -> f64;
    /// The positions.
    fn position(&self) -> Self::Position;
    /// Their numbers, one after the other.
    fn numbers(position: &Self::Position) -> &[f64];
    /// The numbers of the velocities.
    fn velocities(&self) -> &[f64];
    /// The state at another time, with f of every position and g of every velocity.
    fn moved(&self, t: f64, f: impl Fn(f64) -> f64, g: impl Fn(f64) -> f64) -> Self;
}

impl<const D: usize> Coordinates for State<D> {
    type Position = [f64; D];

    fn time(&self) -> f64 {
        self.t
    }
    fn position(&self) -> [f64; D] {
        self.q
    }
    fn numbers(position: &[f64; D]) -> &[f64] {
        position
    }
    fn velocities(&self) -> &[f64] {
        &self.v
    }
    fn moved(&self, t: f64, f: impl Fn(f64) -> f64, g: impl Fn(f64) -> f64) -> Self {
        State { t, q: self.q.map(f), v: self.v.map(g) }
    }
}

#[cfg(feature = "scene")]
impl<const D: usize> Coordinates for SceneState<D> {
    type Position = Vec<[f64; D]>;

    fn time(&self) -> f64 {
        self.t
    }
    fn position(&self) -> Vec<[f64; D]> {
        self.q.clone()
    }
    fn numbers(position: &Vec<[f64; D]>) -> &[f64] {
        position.as_flattened()
    }
    fn velocities(&self) -> &[f64] {
        self.v.as_flattened()
    }
    fn moved(&self, t: f64, f: impl Fn(f64) -> f64, g: impl Fn(f64) -> f64) -> Self {
        let (q, v) = (self.q.iter().map(|q| q.map(&f)), self.v.iter().map(|v| v.map(&g)));
        SceneState { t, q: q.collect(), v: v.collect() }
    }
}

/// What a motion starts from, and that can be started again: a [`State`] under a law, or a scene.
pub trait Repeatable<L>: Setup<L, State: Coordinates, System: TimeScale + ImplicitSteps> + Clone {}

impl<L, X: Setup<L, State: Coordinates, System: TimeScale + ImplicitSteps> + Clone> Repeatable<L> for X {}

/// The motion from a state, of which copies are stepped.
pub(crate) type Motion<L, X> = Simulation<L, X>;

/// The state of a system.
pub(crate) type StateOf<L, X> = <X as Setup<L>>::State;

/// The positions of a system.
pub(crate) type PositionOf<L, X> = <<X as Setup<L>>::State as Coordinates>::Position;

/// A length and a time that are typical of a start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales {
    pub(crate) length: f64,
    pub(crate) time: f64,
}

impl Scales {
    /// The length is |q|∞ (1 at the origin); the time is the shortest of length/|v|, √(length/|a|) and 1/ω.
    pub(crate) fn of<Y: TimeScale>(system: &Y, start: &Y::State) -> Self
    where
        Y::State: Coordinates,
    {
        let t = Y::time(start);
        let [q, v] = system.vectors(start);
        let (speed, length) = (largest(start.velocities()), largest(Y::State::numbers(&start.position())));
        let length = if positive(length) { length } else { 1.0 };
        // A kick in a unit of time.
        let (mut room, mut kicked) = (system.room(), system.zero());
        let kick = dmech_core::extend::Kick { t, b: 1.0, e: 0.0 };
        system.kick(&mut room, &system.stride(1.0, 0.0), kick, &q, &v, &mut kicked);
        Y::add_scaled(&mut kicked, -1.0, &v);
        let acceleration = largest(system.state(t, &q, &kicked).velocities());
        let times = [length / speed, (length / acceleration).sqrt()];
        let first = times.into_iter().filter(|&x| positive(x)).fold(f64::INFINITY, f64::min);
        let least = if first.is_finite() { 1e-9 / first } else { 1e-9 };
        let rate = system.look(&mut room, t, &q, &v, least).rate();
        let swing = if rate > 2.0 * least { rate.recip() } else { f64::INFINITY };
        let time = first.min(swing);
        Scales { length, time: if time.is_finite() { time } else { 1.0 } }
    }
}

fn positive(x: f64) -> bool {
    x > 0.0 && x.is_finite()
}

/// max |xᵢ|.
pub(crate) fn largest(x: &[f64]) -> f64 {
    x.iter().map(|x| x.abs()).fold(0.0, f64::max)
}

/// max |mᵢⱼ|.
pub(crate) fn largest_entry<const D: usize>(m: &[[f64; D]; D]) -> f64 {
    largest(m.as_flattened())
}

/// |x|.
pub(crate) fn norm(x: impl IntoIterator<Item = f64>) -> f64 {
    x.into_iter().fold(0.0, f64::hypot)
}
