//! A scene of few bodies as one law: the same motion, in other roundings.

use dmech::SceneError;
use dmech::extend::{Field, Law, Potential};
use dmech::models::pairs::{Gravity, Spring};
use dmech::prelude::*;
use dmech::scene::{AmongFew, FewBodies, Sides};

use dmech_tests::few::{
    Bond, LISTS, Link, beads, clusters, creatures, fluid, hung, ions, loops, molecules, packs, rope, stars, tides, tied,
};

/// Runs both, and compares where they end, what they must keep, and how well they keep it.
macro_rules! alike {
    ($as_law:ident: $($name:literal: $scene:path, $members:expr, $n:literal, $k:literal, [$($scheme:expr),*], $dt:expr, within $bound:expr;)*) => {$($(for k in $members {
        let scene = $scene(k);
        let law = scene.clone().$as_law::<$n, $k>();
        let start = law.start();
        let scene = Simulation::scene(scene).scheme($scheme).dt($dt).run_until(start.t + 3.0).unwrap();
        let law = Simulation::new(law, start).scheme($scheme).dt($dt).run_until(start.t + 3.0).unwrap();
        let (end, of_scene) = (law.last().bodies::<{ $k / $n }>(), scene.last());
        let scheme = scene.report().scheme();
        let pairs = end.q.as_flattened().iter().zip(of_scene.q.as_flattened());
        let apart = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        println!("{} {k}, {scheme}: {apart:.1e} apart", $name);
        assert!(apart < $bound && scene.steps() == law.steps(), "{} {k}, {scheme}: {apart:e}", $name);
        for invariant in Invariant::ALL {
            let [of_scene, of_law] = [scene.report(), law.report()].map(|report| report.kept(invariant));
            assert_eq!(of_scene, of_law, "{}, {scheme}: {invariant}", $name);
            let (Some(of_scene), Some(of_law)) = (scene.drift(invariant), law.drift(invariant)) else { continue };
            let bound = 1e-12 + 2.0 * of_scene.max_abs();
            assert!(of_law.max_abs() < bound, "{}, {scheme}, {invariant}: {of_scene:?} and {of_law:?}", $name);
            assert!((of_law.start() - of_scene.start()).abs() < 1e-14 * (1.0 + of_scene.start().abs()), "{invariant}");
        }
    })*)*};
}
pub(crate) use alike;

#[test]
fn the_same_motion_as_that_of_the_scene() {
    alike! { as_law:
        "stars": stars, [1], 3, 6, [
            Leapfrog, CompensatedLeapfrog, Composed::order6(Leapfrog), Nystrom::order6(), ForceGradient::order4(),
            RungeKuttaNystrom::order12(), Relaxed::order6(), Kanatani, Implicit, DiscreteGradient,
            Composed::order6(DiscreteGradient), Gauss::order16(), LineIntegral::order6(), Explicit
        ], 0.02, within 2e-13;
        "rope": rope, [2], 4, 4, [Boris, Implicit, DiscreteGradient, Gauss::order16(), Explicit], 0.01, within 1e-12;
        "creatures": creatures, [3], 3, 6, [Implicit, DiscreteGradient, Gauss::order16(), Explicit], 0.02, within 1e-12;
        "tides": tides, [1, 3], 3, 6, [Explicit, Implicit, DiscreteGradient, Composed::order4(Implicit), Gauss::order16()], 0.02, within 1e-12;
        "ions": ions, [4], 3, 6, [Boris, Composed::order4(Boris), Implicit, DiscreteGradient, Gauss::order16()], 0.02, within 1e-12;
    }
}

#[test]
fn the_same_motion_where_bonds_are_listed() {
    alike! { as_law:
        "molecules": molecules, 0..5, 4, 8, [
            Leapfrog, Nystrom::order6(), ForceGradient::order4(), Kanatani, Implicit, DiscreteGradient, Gauss::order16()
        ], 0.01, within 1e-12;
        "clusters": clusters, [5, 20, 36], 4, 12, [RungeKuttaNystrom::order12(), Composed::order4(DiscreteGradient)], 0.02, within 1e-12;
        "beads": beads, [1, 2, 3], 4, 4, [Boris, Implicit, DiscreteGradient], 0.01, within 1e-12;
        "packs": packs, 0..4, 3, 6, [Explicit, Implicit, DiscreteGradient, Gauss::order16()], 0.02, within 1e-12;
    }
}

#[test]
fn the_same_motion_in_a_box() {
    alike! { as_law:
        "fluid": fluid, [1, 2, 7], 4, 12, [
            Leapfrog, Nystrom::order6(), ForceGradient::order4(), Implicit, DiscreteGradient, Gauss::order16()
        ], 0.005, within 1e-10;
        "loops": loops, 0..3, 3, 6, [
            Leapfrog, Nystrom::order6(), Kanatani, Implicit, DiscreteGradient, Composed::order4(DiscreteGradient)
        ], 0.01, within 1e-10;
    }
}

#[test]
fn the_same_motion_where_bodies_are_pinned() {
    alike! { as_law:
        "tied": tied, 0..5, 4, 8, [
            Leapfrog, CompensatedLeapfrog, Nystrom::order6(), ForceGradient::order4(), Kanatani, Implicit, DiscreteGradient,
            Gauss::order16()
        ], 0.01, within 1e-11;
        "hung": hung, 0..5, 4, 8, [Explicit, Implicit, DiscreteGradient, Gauss::order16()], 0.01, within 1e-11;
    }
}

/// A body that is pinned is where it was, to the bit, under every scheme, and whoever sets it moving is told.
#[test]
fn what_is_pinned_stays() {
    macro_rules! stays {
        ($($scheme:expr),*) => {$(for held in [0, 3] {
            let law = tied(held).as_law::<4, 8>();
            let run = Simulation::new(law, law.start()).mass(1.3).scheme($scheme).dt(0.01).run(300).unwrap();
            let [start, end] = [law.start(), *run.last()].map(|state| state.bodies::<2>());
            assert_eq!((end.q[held], end.v[held]), (start.q[held], [0.0; 2]), "{}", run.report().scheme());
            let moved = |i: usize| end.q[i] != start.q[i];
            assert!((0..4).filter(|&i| moved(i)).count() == 3, "{}", run.report().scheme());
            for momentum in [Invariant::LinearMomentum, Invariant::AngularMomentum] {
                assert!(run.drift(momentum).is_none());
            }
        })*};
    }
    stays!(
        Leapfrog,
        CompensatedLeapfrog,
        Composed::order6(Leapfrog),
        Nystrom::order6(),
        ForceGradient::order4(),
        RungeKuttaNystrom::order12(),
        Relaxed::order6(),
        Kanatani,
        Implicit,
        DiscreteGradient,
        Composed::order6(DiscreteGradient),
        Gauss::order16(),
        LineIntegral::order6(),
        Explicit,
        Boris
    );
    let law = tied(2).as_law::<4, 8>();
    let mut start = law.start();
    start.v[5] = 0.1;
    let refused = SceneError::PinnedMoves { body: 2, speed: 0.1 };
    let run = Simulation::new(law, start).scheme(Leapfrog).dt(0.01).run(10);
    assert_eq!(run.unwrap_err().cause(), refused.into());
    let mut stepper = Simulation::new(Some(law), law.start()).scheme(Leapfrog).dt(0.01).stepper().unwrap();
    assert_eq!(stepper.set_state(start).unwrap_err(), refused.into());
    // In more digits, where a quotient by an infinite mass is one of two parts.
    let State { q, v, .. } = law.start();
    let start = State::of(q.map(DoubleDouble::from), v.map(DoubleDouble::from));
    for run in [
        Simulation::new(law, start).scheme(Gauss::order16()).dt(0.01).run(30).unwrap(),
        Simulation::new(law, start).scheme(DiscreteGradient).dt(0.01).run(30).unwrap(),
    ] {
        assert_eq!([4, 5].map(|i| run.last().q[i].to_f64()), [q[4], q[5]]);
        assert!(run.drift(Invariant::Energy).unwrap().max_abs() < 1e-26 && run.last().q[0] != start.q[0]);
    }
}

/// Runs both with steps that follow the motion.
macro_rules! paced {
    ($as_law:ident: $($scene:path, $members:expr, $n:literal, $k:literal, $scheme:expr, $tolerance:expr;)*) => {$(for k in $members {
        let law = $scene(k).$as_law::<$n, $k>();
        let end = law.start().t + 3.0;
        let scene = Simulation::scene($scene(k)).scheme($scheme).adaptive($tolerance).dt(0.3).run_until(end).unwrap();
        let law = Simulation::new(law, law.start()).scheme($scheme).adaptive($tolerance).dt(0.3).run_until(end).unwrap();
        let (end, of_scene) = (law.last().bodies::<{ $k / $n }>(), scene.last());
        let pairs = end.q.as_flattened().iter().zip(of_scene.q.as_flattened());
        let apart = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        println!("{} {k}: {} steps, {apart:.1e} apart", stringify!($scene), law.steps());
        assert!(apart < 1e-10 && scene.steps() == law.steps(), "{k}: {apart:e}, {} steps", scene.steps());
    })*};
}
pub(crate) use paced;

/// Steps that follow the motion find the same time scale: as many of them, to the same place.
#[test]
fn the_same_time_scale_as_that_of_the_scene() {
    paced! { as_law:
        tides, 0..3, 3, 6, Gauss::order16(), 1e-9;
        rope, 0..3, 4, 4, Gauss::order16(), 1e-7;
        beads, 0..3, 4, 4, DiscreteGradient, 1e-2;
        molecules, 0..5, 4, 8, Nystrom::order6(), 1e-8;
        molecules, 0..5, 4, 8, Gauss::order16(), 1e-9;
        clusters, [5, 20], 4, 12, DiscreteGradient, 1e-2;
        packs, 0..4, 3, 6, Gauss::order16(), 1e-9;
        tied, 0..5, 4, 8, Nystrom::order6(), 1e-8;
        hung, 0..5, 4, 8, Gauss::order16(), 1e-9;
        loops, 0..3, 3, 6, Nystrom::order6(), 1e-7;
        fluid, [1, 2], 4, 12, Nystrom::order6(), 1e-7;
    }
}

/// Sums are formed in the order of the bodies: listed links are a chain, and all pairs, to the bit.
#[test]
fn bonds_of_all_neighbours_are_a_chain() {
    fn line<const N: usize>() -> Scene<1> {
        (0..N).fold(Scene::new(), |scene, i| {
            let x = i as f64;
            scene.body(0.6 + 0.01 * x, [x + 0.1 * (x * x).sin()], [0.3 * x.sin()])
        })
    }
    fn end<A: AmongFew<1, N>, const N: usize>(law: FewBodies<A, 1, N, N>) -> State<N> {
        *Simulation::new(law, law.start()).scheme(DiscreteGradient).dt(0.03).run(50).unwrap().last()
    }
    fn check<const N: usize>() {
        let (link, spring) = (Link { k: 4.0, omega: 0.9 }, Spring { k: 0.4, length: 1.0 });
        let chain = end(line::<N>().chain(link).as_law::<N, N>());
        let mut neighbours: Vec<_> = (1..N).map(|b| (b - 1, b)).collect();
        neighbours.reverse();
        assert_eq!(end(line::<N>().bonds(link, neighbours).as_law::<N, N>()), chain);
        let pairs = end(line::<N>().pairs(spring).as_law::<N, N>());
        let all = (0..N).flat_map(|b| (0..b).map(move |a| (a, b)));
        assert_eq!(end(line::<N>().bonds(spring, all).as_law::<N, N>()), pairs);
        assert!(N == 1 || pairs != chain);
    }
    check::<1>();
    check::<2>();
    check::<5>();
    check::<24>();
}

/// Energy, momentum and angular momentum of three bodies in space, by an energy-exact scheme and by a symplectic one.
#[test]
fn sums_over_the_bodies_are_kept() {
    let scene = Scene::new()
        .body(1.3, [0.4, 0.1, -0.2], [0.1, 0.5, 0.2])
        .body(0.07, [1.4, 0.3, 0.1], [-0.2, 1.4, 0.3])
        .body(0.02, [0.2, -2.1, 0.4], [0.9, 0.6, 0.1])
        .pairs(Gravity { g: 1.1 });
    let law = scene.as_law::<3, 9>();
    let simulation = Simulation::new(law, law.start()).dt(0.002).record_every(10);
    let exact = simulation.clone().scheme(DiscreteGradient).run(5000).unwrap();
    let bounded = simulation.scheme(Nystrom::order6()).run(5000).unwrap();
    for (run, energy) in [(&exact, 1e-13), (&bounded, 1e-9)] {
        for (invariant, bound) in
            [(Invariant::Energy, energy), (Invariant::LinearMomentum, 1e-13), (Invariant::AngularMomentum, 1e-13)]
        {
            let drift = run.drift(invariant).unwrap();
            assert!(drift.start() != 0.0 && drift.max_abs() < bound, "{invariant}: {drift:?}");
        }
    }
}

/// The derivatives of a law against differences in twice as many digits, and the secant identity.
pub(crate) fn derivatives<A: AmongFew<D, N, S>, S: Sides, const D: usize, const N: usize, const K: usize>(
    law: &FewBodies<A, D, N, K, S>,
) -> usize {
    type Many = DoubleDouble;
    let (State { t, q, v }, t_other) = (law.start(), 0.83);
    let moved = |i: usize| if Law::<K, f64>::pinned(law, i) { 0.0 } else { 0.1 + 0.07 * (i as f64).sin() };
    let other: [f64; K] = core::array::from_fn(|i| q[i] + moved(i));
    let field = |t: f64| Law::<K, f64>::field(law, 1.0, t);
    let many = |t: f64| Law::<K, Many>::field(law, Many::from(1.0), Many::from(t));
    let wide = |x: [f64; K]| x.map(Many::from);
    let mut compared = 0;
    let mut compare = |name: &str, jacobian: [[f64; K]; K], at: [f64; K], f: &dyn Fn([Many; K]) -> [Many; K]| {
        for j in 0..K {
            let h = 1e-9;
            let moved = |h: f64| {
                let mut x = wide(at);
                x[j] += Many::from(h);
                f(x)
            };
            let (up, down) = (moved(h), moved(-h));
            for i in 0..K {
                let slope = ((up[i] - down[i]) / Many::from(2.0 * h)).to_f64();
                assert!((jacobian[i][j] - slope).abs() < 1e-12 * (1.0 + slope.abs()), "{name} {i} {j}: {slope}");
                compared += usize::from(slope != 0.0);
            }
        }
    };
    compare("hessian", field(t).hessian(q), q, &|q| many(t).gradient(q));
    compare("secant", field(t).discrete_gradient_jacobian(q, other), other, &|b| many(t).discrete_gradient(wide(q), b));
    compare("force by q", field(t).force_dq(other, v, t_other), other, &|q| many(t).force(q, wide(v), t_other.into()));
    compare("force by v", field(t).force_dv(other, v, t_other), v, &|v| many(t).force(wide(other), v, t_other.into()));
    let masses = Law::<K, f64>::weights(law);
    let secant = many(t).discrete_gradient(wide(q), wide(other));
    let along = (0..K).map(|i| Many::from(masses[i]) * secant[i] * (Many::from(other[i]) - Many::from(q[i])));
    let rise = many(t).potential(wide(other)) - many(t).potential(wide(q));
    let missed = (along.fold(Many::from(0.0), |sum, x| sum + x) - rise).to_f64();
    assert!(missed.abs() < 1e-29, "{missed:e}");
    compared
}

#[test]
pub(crate) fn derivatives_are_those_of_the_sums() {
    let compared = [
        derivatives(&stars(1).as_law::<3, 6>()),
        derivatives(&rope(2).as_law::<4, 4>()),
        derivatives(&creatures(3).as_law::<3, 6>()),
        derivatives(&ions(4).as_law::<3, 6>()),
        derivatives(&molecules(0).as_law::<4, 8>()),
        derivatives(&molecules(1).as_law::<4, 8>()),
        derivatives(&clusters(5).as_law::<4, 12>()),
        derivatives(&beads(1).as_law::<4, 4>()),
        derivatives(&packs(1).as_law::<3, 6>()),
        derivatives(&loops(1).as_law::<3, 6>()),
        derivatives(&fluid(1).as_law::<4, 12>()),
    ];
    println!("{compared:?} derivatives that are not 0");
    assert_eq!(compared, [72, 24, 108, 78, 96, 80, 288, 24, 84, 72, 216]);
}

/// A law in twice as many digits: its energy, and how far it is from itself in `f64`.
macro_rules! in_double_double {
    ($name:expr, $law:expr, $dt:expr, $steps:expr, every $every:expr) => {{
        let law = $law;
        let State { t, q, v } = law.start();
        let start = State::of(q.map(DoubleDouble::from), v.map(DoubleDouble::from)).at_time(t);
        let run =
            Simulation::new(law, start).scheme(Gauss::order16()).dt($dt).record_every($every).run($steps).unwrap();
        let drift = run.drift(Invariant::Energy).unwrap();
        assert!(drift.max_abs() < 1e-27, "{}: {drift:?}", $name);
        let double = Simulation::new(law, law.start()).scheme(Gauss::order16()).dt($dt).run($steps).unwrap();
        let apart = run.last().q.iter().zip(double.last().q).map(|(x, y)| (x.to_f64() - y).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-13, "{}: {apart:e}", $name);
    }};
}
pub(crate) use in_double_double;

/// Twice as many digits, which a scene has not.
#[test]
fn few_bodies_in_double_double() {
    in_double_double!("stars", stars(1).as_law::<3, 6>(), 0.005, 400, every 50);
    for k in 0..LISTS.len() {
        in_double_double!(k, molecules(k).as_law::<4, 8>(), 0.002, 200, every 50);
    }
}

/// A mass beside those of the bodies is that of bodies as much heavier, in the time scale too.
#[test]
fn a_mass_multiplies_those_of_the_bodies() {
    let chain = |m: f64| {
        let bodies = Scene::new().body(1.3 * m, [0.0], [0.0]).body(0.7 * m, [1.1], [0.2]).body(2.1 * m, [1.9], [0.0]);
        bodies.chain(Spring { k: 4.0, length: 1.0 }).as_law::<3, 3>()
    };
    for m in [1e-4, 0.37, 1e4] {
        let run = |law: FewBodies<_, 1, 3, 3>, mass: f64| {
            let simulation = Simulation::new(law, law.start()).mass(mass).scheme(Nystrom::order6());
            simulation.adaptive(1e-8).record_every(1000).run_until(1.0).unwrap()
        };
        let [beside, within] = [run(chain(1.0), m), run(chain(m), 1.0)];
        assert_eq!(beside.steps(), within.steps(), "{m}");
        let apart = (0..3).map(|i| (beside.last().q[i] - within.last().q[i]).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-10, "{m}: {apart:e}");
    }
}

/// A law that may be there is stepped as it is, past encounters too; one that cannot be run says so on the way.
#[test]
fn one_that_may_be_there() {
    let scene = |bodies: usize| {
        let scene = Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.0]).body(0.01, [-3.0, 1e-3], [2.0, 0.0]);
        (2..bodies).fold(scene, |scene, _| scene.body(1e-3, [5.0, 5.0], [0.1, 0.0])).pairs(Gravity { g: 1.0 })
    };
    let law = scene(3).as_law::<3, 6>();
    let alone = Simulation::new(law, law.start()).scheme(Gauss::order16()).adaptive(1e-4).run_until(3.0).unwrap();
    let perhaps = Simulation::new(Some(law), law.start()).scheme(Gauss::order16()).adaptive(1e-4);
    let perhaps = perhaps.run_until(3.0).unwrap();
    assert_eq!((alone.last(), alone.steps()), (perhaps.last(), perhaps.steps()));
    let mut stepper = Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.01).stepper().unwrap();
    stepper.advance(3).unwrap();
    *stepper.law_mut() = scene(2).as_law::<3, 6>();
    assert_eq!(stepper.advance(1).unwrap_err(), SceneError::NotSoMany { bodies: 2, declared: 3 }.into());
}

#[test]
fn what_cannot_be_a_law_says_why() {
    let bodies = |n: usize| (0..n).fold(Scene::new(), |scene, i| scene.body(1.0, [i as f64, 0.2], [0.0, 0.1]));
    let cause = |scene: Scene<2, (), ((), dmech::scene::OnPairs<Gravity>)>| {
        let law = scene.as_law::<3, 6>();
        let refused = Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.01).run(10).unwrap_err();
        let member = Ensemble::of(2).scene(move |_| law).scheme(Leapfrog).dt(0.01).run(10).unwrap();
        assert_eq!(member.last(1).unwrap_err(), refused.cause());
        refused.cause()
    };
    let pairs = Gravity { g: 1.0 };
    assert_eq!(cause(bodies(4).pairs(pairs)), SceneError::NotSoMany { bodies: 4, declared: 3 }.into());
    assert_eq!(cause(bodies(2).pairs(pairs)), SceneError::NotSoMany { bodies: 2, declared: 3 }.into());
    assert_eq!(cause(Scene::new().pairs(pairs)), SceneError::Empty.into());
    let still = bodies(2).body(1.0, [3.0, 3.0], [0.0; 2]);
    assert_eq!(cause(still.clone().pin(3).pairs(pairs)), SceneError::Pin { body: 3, bodies: 3 }.into());
    assert_eq!(cause(still.clone().pin(1).pairs(pairs)), SceneError::PinnedMoves { body: 1, speed: 0.1 }.into());
    assert_eq!(cause(still.drive(2, |t| ([t, 0.0], [1.0, 0.0])).pairs(pairs)), SceneError::NotFree { body: 2 }.into());
    assert_eq!(
        cause(bodies(2).test_body(1.0, [3.0; 2], [0.0; 2]).pairs(pairs)),
        SceneError::NotFree { body: 2 }.into()
    );
    assert_eq!(
        cause(bodies(2).body(-1.0, [3.0; 2], [0.0; 2]).pairs(pairs)),
        SceneError::Mass { body: 2, mass: -1.0 }.into()
    );
    println!("{}", cause(bodies(4).pairs(pairs)));

    let of_bonds = |list: &[(usize, usize)]| {
        let law = bodies(3).bonds(Bond { k: 1.0, length: 1.0 }, list.iter().copied()).as_law::<3, 6>();
        let refused = Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.01).run(10).unwrap_err();
        let good = bodies(3).bonds(Bond { k: 1.0, length: 1.0 }, [(0, 1)]).as_law::<3, 6>();
        let members = Ensemble::of(3).scene(move |k| if k == 1 { law } else { good }).scheme(Leapfrog).dt(0.01);
        let members = members.run(10).unwrap();
        assert_eq!(members.failures().collect::<Vec<_>>(), [(1, refused.cause())]);
        refused.cause()
    };
    assert_eq!(of_bonds(&[(0, 1), (1, 1)]), SceneError::SelfBond { body: 1 }.into());
    assert_eq!(of_bonds(&[(0, 1), (2, 1), (1, 0)]), SceneError::DuplicateBond { a: 1, b: 0 }.into());
    assert_eq!(of_bonds(&[(0, 3)]), SceneError::Bond { a: 0, b: 3, bodies: 3 }.into());

    let in_box = |length: f64, cutoff: f64| {
        let scene = bodies(3).pairs(pairs).cutoff(cutoff).periodic([length, 9.0]);
        let law = scene.as_law::<3, 6>();
        Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.01).run(10).unwrap_err().cause()
    };
    assert_eq!(in_box(-1.0, 0.4), SceneError::Length { component: 0, length: -1.0 }.into());
    assert_eq!(in_box(9.0, 0.0), SceneError::Cutoff { cutoff: 0.0 }.into());
    assert_eq!(in_box(2.0, 1.1), SceneError::CutoffInBox { cutoff: 1.1, component: 0, length: 2.0 }.into());
}

/// Verifies the laws of scenes, and counts what was measured.
macro_rules! verified {
    ($measured:ident, $as_law:ident: $($scene:path, $members:expr, $n:literal, $k:literal;)*) => {$(for k in $members {
        let law = $scene(k).$as_law::<$n, $k>();
        let report = verify(law.clone(), law.start());
        assert!(report.passed(), "{} {k} {report}", stringify!($scene));
        $measured += report.checks().iter().filter(|check| check.measured().is_some()).count();
    })*};
}
pub(crate) use verified;

/// What is verified of a law holds for the law of a scene, whatever its masses and pins; one that cannot be run says why.
#[test]
fn scenes_as_laws_are_verified() {
    let mut measured = 0;
    verified! { measured, as_law:
        stars, [1, 2], 3, 6;
        rope, [2, 5], 4, 4;
        creatures, [3], 3, 6;
        tides, [1, 3], 3, 6;
        ions, [4], 3, 6;
        molecules, 0..5, 4, 8;
        clusters, [5, 20, 36], 4, 12;
        beads, [1, 2, 3], 4, 4;
        packs, 0..4, 3, 6;
        tied, 0..4, 4, 8;
        hung, 0..4, 4, 8;
    }
    assert!(measured > 200, "{measured}");
    let refused = stars(0).body(-1.0, [3.0, 0.0], [0.0; 2]).as_law::<4, 8>();
    let report = verify(refused, refused.start());
    let told: Vec<_> = report.checks().iter().map(|check| (check.name(), check.note().contains("mass"))).collect();
    assert!(!report.passed() && told == [("law", true)], "{report}");
}
