//! The bodies of a scene: the instructions over columns.

mod fault;
mod passes;
mod passing;
mod room;
#[cfg(feature = "serde")]
mod saved;
mod setup;
mod solve;
mod stages;
mod stride;

pub use room::SceneRoom;
pub use solve::SceneSolver;
pub use stride::SceneStride;

use super::bodies::check_state;
use super::compensated::CompensatedVectors;
use super::driven::Driven;
use super::drives::Seen;
use super::state::SceneState;
use super::terms::{Acts, Kicked, Moving};
use super::vectors::Vectors;
use crate::error::Error;
use crate::invariant::Invariant;
use crate::newton::NotConverged;
use crate::system::{Beginning, Kick, LinearVelocities, Look, System, TimeScale, WithoutVelocities, not_converged};

/// The bodies of a scene and the terms `A` that act on them.
#[derive(Clone, Debug)]
pub struct SceneSystem<const D: usize, A> {
    pub(super) acts: Driven<D, A>,
    pub(super) masses: Vec<f64>,
    pub(super) pins: Vec<usize>,
    /// 1/m, and 0 for pinned bodies.
    per_mass: Vec<f64>,
    /// Those that do not act on others.
    pub(super) tests: Vec<usize>,
    /// What counts in energies and momenta: masses, and 0 for test bodies.
    weights: Vec<f64>,
}

impl<const D: usize, A: WithoutVelocities> WithoutVelocities for SceneSystem<D, A> {}
impl<const D: usize, A: LinearVelocities> LinearVelocities for SceneSystem<D, A> {}

impl<const D: usize, A: Acts<D>> System for SceneSystem<D, A> {
    type Scalar = f64;
    type Vector = Vectors<D>;
    type Sum = CompensatedVectors<D>;
    type State = SceneState<D>;
    type Stride = SceneStride<D>;
    /// Of each coordinate.
    type Work = Vectors<D>;
    type Room = SceneRoom<D>;

    const IN_REGISTERS: bool = false;
    const DIMENSION: usize = D;
    const DEGREE: Option<u32> = if A::FORCED { None } else { A::DEGREE };
    const PIECEWISE: bool = A::PIECEWISE;

    fn stride(&self, dt: f64, share: f64) -> SceneStride<D> {
        let mut stride = SceneStride::new(dt, self.zero(), share);
        self.set_stride(&mut stride, dt, share);
        stride
    }

    fn set_stride(&self, stride: &mut SceneStride<D>, dt: f64, share: f64) {
        stride.dt = dt;
        for (i, &mass) in self.masses.iter().enumerate() {
            stride.kick.set(i, [dt / mass; D]);
        }
        for &i in &self.pins {
            stride.kick.set(i, [0.0; D]);
        }
        stride.couple(share);
    }

    fn stage(&self, stride: &SceneStride<D>, gamma: f64, share: f64) -> SceneStride<D> {
        let mut kick = stride.kick.clone();
        kick.flat_mut().iter_mut().for_each(|kick| *kick *= gamma);
        SceneStride::new(gamma * stride.dt, kick, share)
    }

    #[inline]
    fn dt(stride: &SceneStride<D>) -> f64 {
        stride.dt
    }

    fn vectors(&self, state: &SceneState<D>) -> [Vectors<D>; 2] {
        let (q, mut v) = (Vectors::from_list(&state.q), Vectors::from_list(&state.v));
        // No scheme moves them.
        self.acts.drives.bodies().for_each(|i| v.set(i, [0.0; D]));
        [q, v]
    }

    fn state(&self, t: f64, q: &Vectors<D>, v: &Vectors<D>) -> SceneState<D> {
        let mut state = SceneState { t, q: q.to_list(), v: v.to_list() };
        self.acts.drives.place(&mut state);
        state
    }

    fn time(state: &SceneState<D>) -> f64 {
        state.t
    }

    fn size(state: &SceneState<D>) -> usize {
        size_of_val(state) + 2 * size_of_val(state.q.as_slice())
    }

    fn zero(&self) -> Vectors<D> {
        Vectors::zeros(self.masses.len())
    }

    fn sum(x: &Vectors<D>) -> CompensatedVectors<D> {
        CompensatedVectors::new(x.clone())
    }

    #[inline]
    fn value(x: &CompensatedVectors<D>) -> &Vectors<D> {
        &x.hi
    }

    fn mean(x: &Vectors<D>, y: &Vectors<D>) -> Vectors<D> {
        let mut mean = x.clone();
        for (mean, y) in mean.flat_mut().iter_mut().zip(y.flat()) {
            *mean = 0.5 * *mean + 0.5 * y;
        }
        mean
    }

    fn scale(x: &mut Vectors<D>, c: f64) {
        x.flat_mut().iter_mut().for_each(|x| *x *= c);
    }

    #[inline]
    fn add_scaled(x: &mut Vectors<D>, c: f64, y: &Vectors<D>) {
        passes::add_scaled(x.blocks_mut(), c, y.blocks());
    }

    fn weigh(w: &[f64], x: &[Vectors<D>], out: &mut Vectors<D>) {
        out.clear();
        for (&w, x) in w.iter().zip(x) {
            if w != 0.0 {
                Self::add_scaled(out, w, x);
            }
        }
    }

    #[inline]
    fn leave_uncounted(&self, x: &mut Vectors<D>) {
        self.tests.iter().for_each(|&i| x.set(i, [0.0; D]));
    }

    #[inline]
    fn is_finite(x: &Vectors<D>) -> bool {
        x.is_finite()
    }

    fn room(&self) -> SceneRoom<D> {
        let [fall, turned, still] = [(); 3].map(|()| Vectors::zeros(0));
        SceneRoom { slope: self.zero(), watched: true, fall, turned, still, by_velocity: Vec::new() }
    }

    #[inline]
    fn watch(watched: bool, room: &mut SceneRoom<D>) {
        room.watched = watched;
    }

    fn potential(&self, t: f64, q: &Vectors<D>) -> f64 {
        self.acts.at(t, q, |terms, q| terms.potential(q, t))
    }

    fn kinetic_energy(&self, v: &Vectors<D>) -> f64 {
        let squares = v.columns().map(|column| column.iter().zip(&self.weights).map(|(v, m)| m * (v * v)).sum::<f64>());
        0.5 * squares.iter().sum::<f64>()
    }

    #[inline]
    fn slope(&self, t: f64, q: &Vectors<D>, v: &Vectors<D>, out: &mut Vectors<D>) {
        self.acts.set_gradient(q, t, out);
        self.acts.subtract_force(1.0, q, v, t, out);
    }

    #[inline]
    fn drift_by_mean(stride: &SceneStride<D>, q: &mut Vectors<D>, v: &Vectors<D>, next: &Vectors<D>) {
        passes::add_sum(q.blocks_mut(), 0.5 * stride.dt, v.blocks(), next.blocks());
    }

    #[inline]
    fn kick(
        &self,
        room: &mut SceneRoom<D>,
        stride: &SceneStride<D>,
        kick: Kick<f64>,
        q: &Vectors<D>,
        v: &Vectors<D>,
        to: &mut Vectors<D>,
    ) {
        if A::AT_ONCE && kick.e == 0.0 {
            let (columns, v, to) = (stride.kick.columns(), v.columns(), to.columns_mut());
            let kicked = Kicked { b: kick.b, kick: columns, v, to };
            return self.acts.at(kick.t, q, |terms, q| terms.kick(q, kick.t, kicked));
        }
        self.slope(kick.t, q, v, &mut room.slope);
        let b = self.length(room, stride, kick, q);
        passes::kick(b, stride.kick.blocks(), room.slope.blocks(), v.blocks(), to.blocks_mut());
    }

    #[inline]
    fn kick_and_drift<const BY_MEAN: bool>(
        &self,
        room: &mut SceneRoom<D>,
        stride: &SceneStride<D>,
        kick: Kick<f64>,
        a: f64,
        q: &mut Vectors<D>,
        v: &Vectors<D>,
        to: &mut Vectors<D>,
        work: &mut Vectors<D>,
    ) {
        if BY_MEAN && A::FORCED {
            self.kick_by_mean(room, stride, kick, q, v, to);
            if room.watched {
                self.add_work(work, v, to);
            }
            return Self::add_scaled(q, a, to);
        }
        if kick.e == 0.0 && !room.watched && self.acts.drives.is_empty() && self.acts.terms.at_once() {
            let (columns, v, to) = (stride.kick.columns(), v.columns(), to.columns_mut());
            return self.acts.terms.kick_and_drift(a, q, kick.t, Kicked { b: kick.b, kick: columns, v, to });
        }
        self.slope(kick.t, q, v, &mut room.slope);
        let b = self.length(room, stride, kick, q);
        let (kick, slope) = (stride.kick.blocks(), room.slope.blocks());
        let (q, v, to) = (q.blocks_mut(), v.blocks(), to.blocks_mut());
        if room.watched {
            passes::kick_and_drift_watched([b, b * stride.dt, a], kick, slope, q, v, to, work.blocks_mut());
        } else {
            passes::kick_and_drift([b, a], kick, slope, q, v, to);
        }
    }

    fn kick_both_ways(
        &self,
        room: &mut SceneRoom<D>,
        stride: &SceneStride<D>,
        kick: Kick<f64>,
        start: &Beginning<'_, Self>,
    ) -> [Vectors<D>; 2] {
        room.slope.clone_from(start.slope);
        let b = self.length(room, stride, kick, start.q);
        let kicked = |sign: f64| {
            let mut to = self.zero();
            passes::kick(sign * b, stride.kick.blocks(), room.slope.blocks(), start.v.blocks(), to.blocks_mut());
            to
        };
        [kicked(-1.0), kicked(1.0)]
    }

    fn add_to_sum(x: &mut CompensatedVectors<D>, c: f64, y: &Vectors<D>) {
        x.add(|i| c * y.flat()[i]);
    }

    fn drift_sum(stride: &SceneStride<D>, q: &mut CompensatedVectors<D>, v: &CompensatedVectors<D>) {
        q.add(|i| stride.dt * v.hi.flat()[i] + stride.dt * v.lo.flat()[i]);
    }

    fn kick_sum(
        &self,
        stride: &SceneStride<D>,
        b: f64,
        slope: &Vectors<D>,
        v: &mut CompensatedVectors<D>,
        change: &mut Vectors<D>,
    ) {
        let kicks = stride.kick.flat().iter().zip(slope.flat());
        for (change, (kick, slope)) in change.flat_mut().iter_mut().zip(kicks) {
            *change = -b * kick * slope;
        }
        v.add(|i| change.flat()[i]);
    }

    fn no_work(&self) -> Vectors<D> {
        self.zero()
    }

    #[inline]
    fn clear(work: &mut Vectors<D>) {
        work.clear();
    }

    fn add_work(&self, work: &mut Vectors<D>, v: &Vectors<D>, next: &Vectors<D>) {
        let (columns, speeds) = (work.columns_mut(), v.columns().into_iter().zip(next.columns()));
        for (work, (v, next)) in columns.into_iter().zip(speeds) {
            for (i, work) in work.iter_mut().enumerate() {
                *work += 0.5 * self.weights[i] * (next[i] - v[i]) * (next[i] + v[i]);
            }
        }
    }

    fn total(&self, work: &Vectors<D>) -> f64 {
        if self.tests.is_empty() {
            return work.flat().iter().sum();
        }
        work.flat().iter().enumerate().filter(|&(i, _)| self.counts(i)).map(|(_, work)| work).sum()
    }

    fn work_along(&self, slope: &Vectors<D>, moved: &Vectors<D>) -> f64 {
        self.work(slope, |i| moved.flat()[i])
    }

    fn work_between(&self, slope: &Vectors<D>, before: &Self::Sum, after: &Self::Sum) -> f64 {
        self.work(slope, |i| after.since(before, i))
    }

    fn work_at_speeds(&self, slope: &Vectors<D>, c: f64, v: &Vectors<D>, next: &Vectors<D>) -> f64 {
        self.work(slope, |i| c * (v.flat()[i] + next.flat()[i]))
    }

    fn check(&self, state: &SceneState<D>) -> Result<(), Error> {
        check_state([&state.q, &state.v], state.t, self.masses.len(), &self.pins, &self.acts.drives)
    }

    #[inline]
    fn is_placed(&self, t: f64) -> bool {
        self.acts.drives.is_empty() || self.acts.lost([t]).is_none()
    }

    /// The forces on all bodies are summed faster than those of each link are looked at.
    fn prepare(&self, start: &SceneState<D>, slope: &mut Vectors<D>) -> Result<(), Error> {
        let [q, v] = self.vectors(start);
        System::slope(self, start.t, &q, &v, slope);
        if !(slope.is_finite() && self.is_placed(start.t)) {
            return self.refuse([&q, &v], start.t);
        }
        self.acts.terms.as_written(&|i| [q.get(i), v.get(i)], start.t)
    }

    fn check_potential(&self, start: &SceneState<D>) -> Result<(), Error> {
        let [q, v] = self.vectors(start);
        if self.potential(start.t, &q).is_finite() { Ok(()) } else { self.refuse([&q, &v], start.t) }
    }

    #[cold]
    fn unsolved(&self, step: u64, from: [&Vectors<D>; 2], t: f64, dt: f64, cause: NotConverged) -> Error {
        let fault = self.fault_on_the_way(from, t, dt);
        fault.map_or_else(|| not_converged(step, t, dt, cause), |fault| fault.told(step, t))
    }

    #[cold]
    fn not_finite(&self, step: u64, to: [&Vectors<D>; 2], t: f64, dt: f64) -> Error {
        let fault = self.fault_at_the_end(to, t, dt);
        fault.map_or(Error::NotFinite { step, time: t, dt }, |fault| fault.told(step, t))
    }

    fn conserves(&self, invariant: Invariant) -> bool {
        let free = self.pins.is_empty();
        match invariant {
            Invariant::Energy | Invariant::DiscreteEnergy => A::CONSERVES_ENERGY && !self.names_the_time(),
            Invariant::WorkEnergy => true,
            Invariant::LinearMomentum => free && A::LINEAR_MOMENTUM,
            Invariant::AngularMomentum => free && A::ANGULAR_MOMENTUM && D > 1,
        }
    }

    fn momentum(&self, invariant: Invariant, state: &SceneState<D>, start: &SceneState<D>) -> (f64, f64) {
        let of = |state: &SceneState<D>| match invariant {
            Invariant::LinearMomentum => state.linear_momentum(&self.weights),
            _ => state.angular_momentum(&self.weights),
        };
        let (now, first) = (of(state), of(start));
        if let ([now], [first]) = (&*now, &*first) {
            return (*now, now - first);
        }
        let norm = |x: &mut dyn Iterator<Item = f64>| x.map(|x| x * x).sum::<f64>().sqrt();
        (norm(&mut now.iter().copied()), norm(&mut now.iter().zip(&first).map(|(x, y)| x - y)))
    }
}

impl<const D: usize, A: Acts<D>> SceneSystem<D, A> {
    /// Positions, with driven bodies where they are at t.
    pub(super) fn seen<'a>(&'a self, t: f64, q: &'a Vectors<D>) -> Seen<'a, D> {
        self.acts.drives.positions(q, t)
    }

    /// Whether coordinate i is that of a body that acts on others.
    fn counts(&self, i: usize) -> bool {
        self.weights[i % self.weights.len()] != 0.0
    }

    /// Σ F·Δq of the force −S that acts on the bodies that move: work on a pinned body is none.
    fn work(&self, slope: &Vectors<D>, moved: impl Fn(usize) -> f64) -> f64 {
        let all = slope.flat().iter().enumerate();
        if self.tests.is_empty() {
            return -all.map(|(i, s)| s * moved(i)).sum::<f64>();
        }
        -all.filter(|&(i, _)| self.counts(i)).map(|(i, s)| s * moved(i)).sum::<f64>()
    }
}

impl<const D: usize, A: Acts<D>> TimeScale for SceneSystem<D, A> {
    fn names_the_time(&self) -> bool {
        !A::AUTONOMOUS || !self.acts.drives.is_empty()
    }

    fn look(&self, room: &mut SceneRoom<D>, t: f64, q: &Vectors<D>, v: &Vectors<D>, least: f64) -> Look {
        System::slope(self, t, q, v, &mut room.slope);
        let (slope, per_mass) = (&room.slope, &self.per_mass[..]);
        self.acts.moving(t, q, v, |terms, q, v| terms.look(&Moving { t, q, v, slope, per_mass, least }))
    }
}
