//! Schemes of one's own: in runs, compositions, compositions of compositions, and where a stage fails.

use approx::assert_abs_diff_eq;
use dmech::coefficients::TripleJump4;
use dmech::extend::{
    Beginning, Effort, Fields, Kept, Kick, Method, NotConverged, OneStep, Real, Rides, Scheme, Steps, System,
    VelocityIndependent, WithoutVelocities,
};
use dmech::models::{Pendulum, pairs::Spring};
use dmech::prelude::*;
use dmech::verify_scheme;

use super::wrapped::{own, until};

/// One kick, after so many halves of the drift: after one it is the scheme of the page for schemes of one's own, after none or both it
/// is of order 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct KickAfter<const HALVES: u32>;

impl<const HALVES: u32> OneStep for KickAfter<HALVES> {}

impl<const HALVES: u32> Method for KickAfter<HALVES> {
    const NAME: &'static str = ["KickDrift", "DriftKickDrift", "DriftKick"][HALVES as usize];
    const ORDER: u32 = 1 + HALVES % 2;
    const SYMMETRIC: bool = HALVES == 1;

    fn keeps(invariant: Invariant) -> Kept {
        Leapfrog::keeps(invariant)
    }
}

impl<Y: System + WithoutVelocities, const HALVES: u32> Scheme<Y> for KickAfter<HALVES> {
    type Memory = [Y::Vector; 3];
    type Workspace = Y::Room;

    fn workspace(&self, system: &Y, _: &Y::Stride) -> Y::Room {
        system.room()
    }
    fn begin(
        &self,
        _: &Y,
        _: &Y::Stride,
        start: &Beginning<'_, Y>,
        _: &mut Y::Room,
    ) -> Result<Self::Memory, NotConverged> {
        Ok([start.q, start.v, start.v].map(Clone::clone))
    }
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        [q, v, before]: &mut Self::Memory,
        room: &mut Y::Room,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let half = Y::Scalar::from_f64(0.5) * Y::dt(stride);
        let [first, second] = [HALVES, 2 - HALVES].map(|halves| Y::Scalar::from_f64(f64::from(halves)) * half);
        core::mem::swap(v, before);
        Y::drift(q, first, before);
        system.kick(room, stride, Kick { t: t + first, b: Y::Scalar::ONE, e: 0.0 }, q, before, v);
        Y::drift(q, second, v);
        Ok(Effort::of(1))
    }
    fn position<'m>(&self, [q, _, _]: &'m Self::Memory) -> &'m Y::Vector {
        q
    }
    fn velocity(&self, _: &Y, _: &Y::Stride, _: Y::Scalar, [_, v, _]: &Self::Memory) -> Y::Vector {
        v.clone()
    }
    fn finite(&self, [q, v, _]: &Self::Memory) -> bool {
        Y::is_finite(q) && Y::is_finite(v)
    }
    fn kinetic_energy(&self, system: &Y, [_, v, _]: &Self::Memory) -> Y::Scalar {
        system.kinetic_energy(v)
    }
    fn work(&self, system: &Y, _: &Y::Stride, _: &Self::Memory, [_, v, before]: &Self::Memory) -> Y::Scalar {
        let mut work = system.no_work();
        system.add_work(&mut work, before, v);
        system.total(&work)
    }
}

impl<L: Fields<D> + VelocityIndependent, const D: usize, const HALVES: u32> Rides<L, D> for KickAfter<HALVES> {}

fn name<S: Method>(_: &S) -> &'static str {
    S::NAME
}

/// One's own scheme alone and in compositions: order, invariants and the way back on laws and on a scene.
#[test]
fn a_scheme_of_ones_own_composes() {
    verify_scheme(KickAfter::<1>).assert();
    let fourth = verify_scheme(Composed::order4(Steps(KickAfter::<1>)));
    fourth.assert();
    let orders = fourth.checks().iter().filter(|check| check.name().ends_with("order") && check.measured().is_some());
    assert_eq!(orders.count(), 3);
    verify_scheme(Composed::order6(Steps(KickAfter::<1>))).assert();
    assert_eq!(name(&Composed::order4(Steps(KickAfter::<1>))), "Composed(DriftKickDrift, Suzuki4S7)");
    // Steps in a row, of which nobody asks the work, are those of a run.
    let law = Spring { k: 1.3, length: 0.9 };
    let scene = Scene::new().body(1.0, [0.4, 0.0], [0.0, 0.3]).body(0.6, [-0.9, 0.1], [0.2, 0.0]).pairs(law);
    let motion = Simulation::scene(scene).scheme(Composed::order4(Steps(KickAfter::<1>))).dt(0.05);
    let run = motion.clone().run(200).unwrap();
    let mut stepper = motion.stepper().unwrap();
    stepper.advance(200).unwrap();
    assert_eq!(stepper.state(), *run.last());
    assert!(run.drift(Invariant::WorkEnergy).unwrap().max_abs() < 1e-13);
}

/// Members of an ensemble are moved by it one by one.
#[test]
fn a_scheme_of_ones_own_moves_an_ensemble() {
    let (law, start) = (Pendulum { k: 1.3 }, |k: usize| State::new([0.1 + 0.2 * k as f64], [0.0]));
    let run = Ensemble::of(11).law(|_| law).start(start).scheme(KickAfter::<1>).dt(0.05).run(200).unwrap();
    for k in 0..11 {
        let alone = Simulation::new(law, start(k)).scheme(KickAfter::<1>).dt(0.05).run(200).unwrap();
        assert_eq!(run.last(k).unwrap(), *alone.last());
    }
}

/// Schemes that carry a kick over the end of a step, or prepare their workspace for a length, in compositions: orders, invariants,
/// work and the way back.
#[test]
fn what_a_scheme_carries_is_stretched_between_stages() {
    verify_scheme(Composed::order4(Steps(own(Leapfrog)))).assert();
    verify_scheme(Composed::order4(Steps(own(Nystrom::order4())))).assert();
    verify_scheme(Composed::order4(Steps(own(DiscreteGradient)))).assert();
}

#[test]
fn so_it_is_in_compositions_of_compositions() {
    verify_scheme(Composed::order6(Steps(own(Composed::order4(DiscreteGradient))))).assert();
    verify_scheme(Composed::order6(Steps(own(Composed::order4(Steps(own(Leapfrog))))))).assert();
}

#[test]
fn and_in_compositions_of_those() {
    // Three stages within three: seven within seven take five times as long to say the same.
    let third = Composed::new(Steps(own(Composed::new(DiscreteGradient, TripleJump4))), TripleJump4);
    verify_scheme(Composed::order6(Steps(own(third)))).assert();
}

/// Steps in a row that fail leave the motion where single steps do, whatever stage it was that failed.
#[test]
fn a_stage_that_fails_leaves_nothing_behind() {
    #[derive(Clone, Copy, Debug, dmech::Law)]
    #[potential(|q: [f64; 2]| 0.3 * q[1].powi(4) - q[0].cos() + 0.2 * q[0] * q[1])]
    struct Well;
    let mut failed = 0;
    for end in [1.005, 1.01, 1.03, 1.05, 1.07, 1.09] {
        let scheme = until(Composed::order4(DiscreteGradient), end);
        let motion = || {
            let start = State::new([0.9, 0.4], [0.3, -0.7]);
            Simulation::new(Well, start).scheme(Composed::order8(Steps(scheme))).dt(0.1).stepper().unwrap()
        };
        let (mut single, mut row) = (motion(), motion());
        let error = loop {
            if let Err(error) = single.step() {
                break error;
            }
        };
        assert_eq!(row.advance(100), Err(error));
        assert_eq!(row.state(), single.state(), "{end}");
        assert_eq!(row.steps(), single.steps());
        failed += single.steps();
    }
    assert!(failed >= 60);
    // The same motion by single steps and in a row to there.
    let simulation = Simulation::new(Well, State::new([0.9, 0.4], [0.3, -0.7])).scheme(Composed::order8(Leapfrog));
    let whole = simulation.dt(0.1).run(10).unwrap();
    let own = Simulation::new(Well, State::new([0.9, 0.4], [0.3, -0.7])).scheme(Composed::order8(Steps(own(Leapfrog))));
    assert_abs_diff_eq!(*own.dt(0.1).run(10).unwrap().last(), *whole.last(), epsilon = 1e-14);
}
