//! Laws that each body has of its own.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use dmech::SceneError;
use dmech::extend::{Adaptive, Difference, VelocityIndependent};
use dmech::models::pairs::{Charge, Coulomb, Spring};
use dmech::prelude::*;
use dmech::scene::{OnChain, OnEach, OnEachOwn, SceneStepper, SceneSystem, Term};
use dmech_tests::few::plasma;
use dmech_tests::restricted::sprays;

use crate::few::{alike, derivatives, in_double_double, paced, verified};

/// A well k (x² + 1.7 y²)/2 + 0.11 k x⁴, about a point.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Well {
    k: f64,
    x: f64,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let (x, y) = (q[0] - self.x, q[1]);
        0.5 * self.k * (x * x + 1.7 * y * y) + 0.11 * self.k * x.powi(4)
    }
}

/// The same, of a body whose mass is its stiffness.
#[derive(Clone, Copy, Debug)]
struct WellByMass {
    x: f64,
}

#[dmech::law]
impl WellByMass {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64) -> f64 {
        let (x, y) = (q[0] - self.x, q[1]);
        0.5 * m * (x * x + 1.7 * y * y) + 0.11 * m * x.powi(4)
    }
}

/// A swelling well, a magnetic field, and a drag, each of the strength c.
#[derive(Clone, Copy, Debug)]
struct Storm {
    c: f64,
}

#[dmech::law]
impl Storm {
    #[potential]
    fn energy(&self, q: [f64; 2], t: f64) -> f64 {
        let r2 = q[0] * q[0] + q[1] * q[1];
        0.5 * self.c * (1.2 + (1.9 * t).sin()) * r2 * (1.0 + 0.1 * r2)
    }
    #[force]
    fn push(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let b = 0.7 * self.c * (1.0 + 0.3 * q[0]);
        let drag = 0.05 * self.c;
        [b * v[1] - drag * v[0], -b * v[0] - drag * v[1]]
    }
}

/// The same, of a body whose mass is that strength.
#[derive(Clone, Copy, Debug)]
struct StormByMass;

#[dmech::law]
impl StormByMass {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64, t: f64) -> f64 {
        let r2 = q[0] * q[0] + q[1] * q[1];
        0.5 * m * (1.2 + (1.9 * t).sin()) * r2 * (1.0 + 0.1 * r2)
    }
    #[force]
    fn push(&self, q: [f64; 2], v: [f64; 2], m: f64) -> [f64; 2] {
        let b = 0.7 * m * (1.0 + 0.3 * q[0]);
        let drag = 0.05 * m;
        [b * v[1] - drag * v[0], -b * v[0] - drag * v[1]]
    }
}

/// Powers of two: products with them are not rounded, in whatever order they are formed.
const MASSES: [f64; 5] = [2.0, 0.5, 4.0, 1.0, 0.25];

/// Who of the five is pinned, driven, a test body.
#[derive(Clone, Copy, Debug, Default)]
struct Roles {
    pinned: Option<usize>,
    driven: Option<usize>,
    test: Option<usize>,
}

const ROLES: [Roles; 4] = [
    Roles { pinned: None, driven: None, test: None },
    Roles { pinned: Some(0), driven: None, test: None },
    Roles { pinned: Some(3), driven: Some(1), test: Some(0) },
    Roles { pinned: None, driven: Some(4), test: Some(2) },
];

fn place(i: usize) -> ([f64; 2], [f64; 2]) {
    let x = i as f64;
    ([1.3 * x - 2.4, 0.7 * (2.3 * x).cos()], [0.3 * (1.7 * x).sin(), 0.4 * (1.1 * x).cos()])
}

/// Five bodies, each with a charge that is its mass.
fn bodies(roles: Roles) -> Scene<2, Charge> {
    let scene = (0..5).fold(Scene::new(), |scene, i| {
        let (q, v) = place(i);
        let v = if roles.pinned == Some(i) { [0.0; 2] } else { v };
        let charge = Charge { q: MASSES[i] };
        if roles.test == Some(i) {
            scene.test_body_with(MASSES[i], q, v, charge)
        } else {
            scene.body_with(MASSES[i], q, v, charge)
        }
    });
    let scene = roles.pinned.into_iter().fold(scene, |scene, i| scene.pin(i));
    roles.driven.into_iter().fold(scene, |scene, i| {
        let ([x, y], _) = place(i);
        scene.drive(i, move |t: f64| ([x + 0.2 * (1.3 * t).sin(), y], [0.26 * (1.3 * t).cos(), 0.0]))
    })
}

/// Strengths are known by the number of the body, and by what it carries.
fn well(i: usize, charge: &Charge) -> Well {
    assert_eq!(charge.q, MASSES[i]);
    Well { k: if i.is_multiple_of(2) { MASSES[i] } else { charge.q }, x: 0.2 }
}

fn storm(i: usize, charge: &Charge) -> Storm {
    Storm { c: well(i, charge).k }
}

/// The same motion to the bit, with the same work for it, and of the same invariants.
fn same<A, B, S>(own: Scene<2, Charge, A>, one: Scene<2, Charge, B>, scheme: S, what: &str)
where
    A: Term<2, Charge>,
    B: Term<2, Charge>,
    S: Scheme<SceneSystem<2, A::Ready>> + Scheme<SceneSystem<2, B::Ready>>,
{
    let own = Simulation::scene(own).scheme(scheme).dt(0.02).run(40).unwrap();
    let one = Simulation::scene(one).scheme(scheme).dt(0.02).run(40).unwrap();
    let name = own.report().scheme();
    assert_eq!(own.states(), one.states(), "{name}, {what}");
    assert_eq!(own.report().evaluations(), one.report().evaluations(), "{name}, {what}");
    assert_eq!(own.report().iterations(), one.report().iterations(), "{name}, {what}");
    for invariant in Invariant::ALL {
        assert_eq!(own.drift(invariant), one.drift(invariant), "{name}, {what}: {invariant}");
    }
}

/// One law that tells the bodies by their masses is a law of its own on each, under every scheme, alone and beside links of each kind,
/// whoever is pinned, driven or a test body.
#[test]
fn own_laws_are_one_law_that_tells_bodies_apart() {
    macro_rules! wells {
        ($($scheme:expr),* $(,)?) => {$(for roles in ROLES {
            let one = WellByMass { x: 0.2 };
            let (ties, spring) = ([(0, 2), (4, 1)], Spring { k: 0.7, length: 1.1 });
            same(bodies(roles).field_of(well), bodies(roles).field(one), $scheme, "alone");
            same(bodies(roles).field_of(well).chain(spring), bodies(roles).field(one).chain(spring), $scheme, "chain");
            same(
                bodies(roles).bonds(spring, ties).field_of(well).pairs(Coulomb { k: 0.3 }),
                bodies(roles).bonds(spring, ties).field(one).pairs(Coulomb { k: 0.3 }),
                $scheme,
                "pairs",
            );
        })*};
    }
    macro_rules! storms {
        ($($scheme:expr),* $(,)?) => {$(for roles in ROLES {
            let spring = Spring { k: 0.7, length: 1.1 };
            same(bodies(roles).field_of(storm), bodies(roles).field(StormByMass), $scheme, "alone");
            same(
                bodies(roles).field_of(storm).chain(spring),
                bodies(roles).field(StormByMass).chain(spring),
                $scheme,
                "chain",
            );
        })*};
    }
    wells!(
        Leapfrog,
        CompensatedLeapfrog,
        Nystrom::order6(),
        RungeKuttaNystrom::order12(),
        Relaxed::order6(),
        ForceGradient::order4(),
        Kanatani,
        Implicit,
        DiscreteGradient,
        Composed::order4(DiscreteGradient),
        Gauss::order16(),
        LineIntegral::order4(),
    );
    storms!(
        Explicit,
        Boris,
        Composed::order4(Boris),
        Implicit,
        DiscreteGradient,
        Gauss::order16(),
        LineIntegral::order6(),
    );
}

/// Steps that follow the motion see how fast each body moves under its own law.
#[test]
fn the_time_scale_is_that_of_all_laws() {
    macro_rules! paced {
        ($($scheme:expr, $tolerance:expr);* $(;)?) => {$(for roles in ROLES {
            let one = bodies(roles).field(WellByMass { x: 0.2 }).pairs(Coulomb { k: 0.3 });
            let own = bodies(roles).field_of(well).pairs(Coulomb { k: 0.3 });
            let run = Simulation::scene(own).scheme($scheme).adaptive($tolerance).dt(0.3).run_until(2.0).unwrap();
            let other = Simulation::scene(one).scheme($scheme).adaptive($tolerance).dt(0.3).run_until(2.0).unwrap();
            assert_eq!(run.states(), other.states(), "{roles:?}");
        })*};
    }
    paced! {
        Nystrom::order6(), 1e-6;
        DiscreteGradient, 1e-3;
        Gauss::order16(), 1e-8;
    }
    // One stiff law among slack ones shortens the steps, whichever body has it.
    let steps = |stiff: Option<usize>| {
        let law = move |i, _: &()| Well { k: if Some(i) == stiff { 2500.0 } else { 1.0 }, x: 0.0 };
        let scene = (0..3).fold(Scene::new(), |scene, i| scene.body(1.0, place(i).0, place(i).1)).field_of(law);
        Simulation::scene(scene).scheme(Nystrom::order6()).adaptive(1e-6).dt(1.0).run_until(3.0).unwrap().steps()
    };
    for stiff in 0..3 {
        assert!(steps(Some(stiff)) > 8 * steps(None), "{stiff}: {} and {}", steps(Some(stiff)), steps(None));
    }
}

/// Without links each body moves as it would alone under its law: to the bit, where no equation is solved for all together.
#[test]
fn each_body_moves_as_alone() {
    fn end<L: Term<2, Charge>, S: Scheme<SceneSystem<2, L::Ready>>>(
        scene: Scene<2, Charge, L>,
        scheme: S,
    ) -> SceneState<2> {
        Simulation::scene(scene).scheme(scheme).dt(0.03).run(80).unwrap().last().clone()
    }
    macro_rules! alone {
        ($bound:expr, $own:expr, $alone:expr; $($scheme:expr),*) => {$({
            let scene = (0..3).fold(Scene::new(), |scene, i| {
                let (q, v) = place(i);
                scene.body_with(0.7 + 0.3 * i as f64, q, v, Charge { q: 1.3 - 0.9 * i as f64 })
            });
            let together = end(scene.field_of($own), $scheme);
            for i in 0..3 {
                let (charge, (q, v)) = (Charge { q: 1.3 - 0.9 * i as f64 }, place(i));
                let one = Scene::new().body_with(0.7 + 0.3 * i as f64, q, v, charge);
                let alone = end(one.field($alone(i, &charge)), $scheme);
                let (q, v) = (together.q[i], together.v[i]);
                let pairs = q.iter().chain(&v).zip(alone.q[0].iter().chain(&alone.v[0]));
                let apart = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
                assert!(apart <= $bound, "{}, body {i}: {apart:e}", stringify!($scheme));
            }
        })*};
    }
    let own_well = |i: usize, charge: &Charge| Well { k: 1.1 + charge.q.powi(2), x: 0.3 * i as f64 };
    let own_storm = |i: usize, charge: &Charge| Storm { c: charge.q * charge.q + 0.2 * i as f64 };
    alone!(0.0, own_well, own_well; Leapfrog, CompensatedLeapfrog, Nystrom::order6(), ForceGradient::order4(),
        RungeKuttaNystrom::order12(), Composed::order4(Leapfrog));
    alone!(0.0, own_storm, own_storm; Explicit, Boris);
    alone!(2e-14, own_well, own_well; Kanatani, Implicit, DiscreteGradient, Gauss::order16(), LineIntegral::order4());
    alone!(2e-14, own_storm, own_storm; Implicit, DiscreteGradient, Gauss::order16());
}

/// Charges of two species in a magnetic field turn with q B/m either way, and by Boris's scheme at the speed that they have.
#[test]
fn charges_turn_by_their_own_rates() {
    #[derive(Clone, Copy, Debug)]
    struct Lorentz {
        charge: f64,
        b: f64,
    }
    #[dmech::law]
    impl Lorentz {
        #[force]
        fn force(&self, v: [f64; 2]) -> [f64; 2] {
            [self.charge * self.b * v[1], -self.charge * self.b * v[0]]
        }
    }
    let kinds = [(1.0, 1.0), (4.0, -2.0), (2.5, 0.0), (0.5, 3.0)];
    let bodies = || kinds.iter().fold(Scene::new(), |scene, &(m, q)| scene.body_with(m, [0.0; 2], [1.0, 0.0], q));
    let scene = bodies().field_of(|_, &charge| Lorentz { charge, b: 1.3 });
    let (dt, steps) = (0.05, 4000);
    let run = Simulation::scene(scene).scheme(Boris).dt(dt).run(steps).unwrap();
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
    for (i, (mass, charge)) in kinds.into_iter().enumerate() {
        // tan(α/2) = q B h/2m of each step.
        let angle = steps as f64 * 2.0 * f64::atan(0.5 * charge * 1.3 * dt / mass);
        let [x, y] = run.last().v[i];
        assert!((x - angle.cos()).abs() < 1e-11 && (y + angle.sin()).abs() < 1e-11, "{i}: {x} {y}");
    }
}

/// Orders and energies are those of the schemes.
#[test]
fn orders_and_energies_are_kept() {
    /// Where all were, at so many times.
    fn path<L: Term<2, Charge>, S: Scheme<SceneSystem<2, L::Ready>>>(
        scene: Scene<2, Charge, L>,
        scheme: S,
        [looks, every]: [u32; 2],
    ) -> Vec<[f64; 2]> {
        let simulation = Simulation::scene(scene).scheme(scheme).dt(1.5 / f64::from(looks * every));
        let run = simulation.record_every(every.into()).run((looks * every).into()).unwrap();
        run.states().iter().flat_map(|state| [&state.q, &state.v]).flatten().copied().collect()
    }
    macro_rules! orders {
        ($law:expr; $($scheme:expr, $order:expr, $steps:expr);* $(;)?) => {$(for roles in ROLES {
            let scene = || bodies(roles).field_of($law).pairs(Spring { k: 0.2, length: 0.0 });
            let [coarse, middle, fine] = [1, 2, 4].map(|every| path(scene(), $scheme, [$steps, every]));
            let apart = |x: &[[f64; 2]], y: &[[f64; 2]]| {
                x.iter().flatten().zip(y.iter().flatten()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
            };
            let order = (apart(&coarse, &middle) / apart(&middle, &fine)).log2();
            println!("{} {roles:?}: {order:.3}, {:.1e}", stringify!($scheme), apart(&middle, &fine));
            assert!((order - f64::from($order)).abs() < 0.15, "{} {roles:?}: {order}", stringify!($scheme));
        })*};
    }
    orders! { well;
        Leapfrog, 2, 200;
        Kanatani, 2, 200;
        DiscreteGradient, 2, 200;
        Composed::order4(DiscreteGradient), 4, 100;
        ForceGradient::order4(), 4, 100;
        Nystrom::order6(), 6, 20;
    }
    orders! { storm;
        Explicit, 1, 800;
        Boris, 2, 400;
        Implicit, 2, 200;
        DiscreteGradient, 2, 200;
    }
    for roles in &ROLES[..2] {
        let scene = || bodies(*roles).field_of(well).pairs(Coulomb { k: 0.3 });
        for run in [
            Simulation::scene(scene()).scheme(DiscreteGradient).dt(0.05).run(500).unwrap(),
            Simulation::scene(scene()).scheme(Relaxed::order6()).dt(0.05).run(500).unwrap(),
        ] {
            assert_eq!(run.kept(Invariant::Energy), Kept::Exact);
            assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
        }
        let stormy = bodies(*roles).field_of(storm).pairs(Coulomb { k: 0.3 });
        let run = Simulation::scene(stormy).scheme(DiscreteGradient).dt(0.05).run(500).unwrap();
        assert!(run.drift(Invariant::Energy).is_none());
        assert!(run.drift(Invariant::WorkEnergy).unwrap().max_relative() < 1e-12);
    }
}

/// As one law of few bodies it is the motion of the scene, also with test bodies.
#[test]
fn few_bodies_have_their_own_laws() {
    alike! { as_law:
        "plasma": plasma, 0..4, 3, 6, [Explicit, Boris, Composed::order4(Boris), Implicit, DiscreteGradient, Gauss::order16()],
            0.02, within 1e-12;
    }
    alike! { as_restricted_law:
        "sprays": sprays, 0..7, 3, 6, [Boris, Implicit, DiscreteGradient, Gauss::order16()], 0.02, within 1e-11;
    }
    paced! { as_law:
        plasma, 0..4, 3, 6, DiscreteGradient, 1e-3;
        plasma, 0..4, 3, 6, Gauss::order16(), 1e-9;
    }
    let mut measured = 0;
    verified! { measured, as_law:
        plasma, 0..4, 3, 6;
    }
    assert!(measured > 20, "{measured}");
    for k in 0..4 {
        let law = plasma(k).as_law::<3, 6>();
        assert!(derivatives(&law) > 50);
        in_double_double!(k, law, 0.002, 200, every 50);
    }
}

/// Side by side each member has its own list, and moves as alone.
#[test]
fn members_with_their_own_lists_ride_in_lanes() {
    macro_rules! ride {
        ($($scheme:expr, $dt:expr;)*) => {$({
            let law = |k: usize| plasma(k).as_law::<3, 6>();
            let run = Ensemble::of(21).scene(law).scheme($scheme).dt($dt).run_until(1.5).unwrap();
            for k in 0..21 {
                let alone = Simulation::new(law(k), law(k).start()).scheme($scheme).dt($dt).run_until(1.5).unwrap();
                assert_eq!(run.last(k).unwrap(), *alone.last(), "{k}, {}", stringify!($scheme));
            }
        })*};
    }
    ride! {
        Boris, 0.02;
        Implicit, 0.02;
        DiscreteGradient, 0.02;
        Gauss::order16(), 0.1;
        Adaptive::new(DiscreteGradient, 1e-3), 0.1;
    }
}

/// A law that one body has and another has not, also where the first has none.
#[test]
fn some_bodies_have_none() {
    let has = |k: usize, i: usize| (k >> i) & 1 == 1;
    let bodies = || (0..3).fold(Scene::new(), |scene, i| scene.body(MASSES[i], place(i).0, place(i).1));
    let law = move |k: usize| move |i: usize, _: &()| has(k, i).then_some(Well { k: 1.0 + i as f64, x: 0.2 });
    macro_rules! check {
        ($($scheme:expr),*) => {$(
            let members = Ensemble::of(8).scene(|k| bodies().field_of(law(k)).as_law::<3, 6>());
            let members = members.scheme($scheme).dt(0.02).run(50).unwrap();
            for k in 0..8 {
                let run = Simulation::scene(bodies().field_of(law(k))).scheme($scheme).dt(0.02).run(50).unwrap();
                let few = members.last(k).unwrap().bodies::<2>();
                for i in 0..3 {
                    let (q, v) = place(i);
                    let one = Scene::new().body(MASSES[i], q, v).field(Well { k: 1.0 + i as f64, x: 0.2 });
                    let alone = Simulation::scene(one).scheme($scheme).dt(0.02).run(50).unwrap().last().q[0];
                    let flown = [q[0] + v[0], q[1] + v[1]];
                    let expected = if has(k, i) { alone } else { flown };
                    for [there, few, here] in [0, 1].map(|c| [run.last().q[i][c], few.q[i][c], expected[c]]) {
                        assert!((there - here).abs() < 1e-13 && (few - here).abs() < 1e-13, "{k} {i}: {there} {few} {here}");
                    }
                }
            }
        )*};
    }
    check!(Leapfrog, Implicit, DiscreteGradient);
}

/// A checkpoint is resumed with the list that it was made of, to the bit, and with no other.
#[test]
fn a_checkpoint_is_that_of_a_list() {
    type Wells<X> = Scene<2, Charge, ((), OnEachOwn<X, Charge>)>;
    fn with<X: Law<2> + VelocityIndependent>(
        law: impl Fn(usize, &Charge) -> X + Send + Sync + 'static,
    ) -> Simulation<(), Wells<X>, Leapfrog> {
        Simulation::scene(bodies(ROLES[1]).field_of(law)).scheme(Leapfrog).dt(0.02)
    }
    let mut stepper = with(well).stepper().unwrap();
    stepper.advance(30).unwrap();
    let saved = stepper.checkpoint();
    stepper.advance(20).unwrap();
    let mut other = with(well).resume(&saved).unwrap();
    other.advance(20).unwrap();
    assert_eq!(stepper.state(), other.state());
    let refused = |difference| Some(Error::Checkpoint(difference));
    for body in 0..5 {
        let next = move |i: usize, charge: &Charge| {
            let law = well(i, charge);
            if i == body { Well { k: law.k.next_up(), ..law } } else { law }
        };
        assert_eq!(with(next).resume(&saved).err(), refused(Difference::Field { name: "k" }), "{body}");
    }
    // The same laws, of other bodies.
    let turned = |i: usize, _: &Charge| well((i + 1) % 5, &Charge { q: MASSES[(i + 1) % 5] });
    assert_eq!(with(turned).resume(&saved).err(), refused(Difference::Field { name: "k" }));
    let one = Simulation::scene(bodies(ROLES[1]).field(well(0, &Charge { q: MASSES[0] }))).scheme(Leapfrog).dt(0.02);
    assert_eq!(one.resume(&saved).err(), refused(Difference::Laws));

    // Laws that are not there tell nothing, and are missed all the same, also where they do nothing.
    let idle = |body| move |i: usize, _: &Charge| (i == body).then_some(Well { k: 0.0, x: 0.0 });
    let saved = with(idle(1)).stepper().unwrap().checkpoint();
    assert!(with(idle(1)).resume(&saved).is_ok());
    assert_eq!(with(idle(2)).resume(&saved).err(), refused(Difference::Field { name: "bodies with a law" }));
    assert_eq!(with(idle(9)).resume(&saved).err(), refused(Difference::Laws));

    // So it is of the scene as one law.
    let law = |last: f64| {
        let scene = (0..3).fold(Scene::new(), |scene, i| scene.body(MASSES[i], place(i).0, place(i).1));
        scene.field_of(move |i, ()| Storm { c: if i == 2 { last } else { 0.5 } }).as_law::<3, 6>()
    };
    let simulation = |last| Simulation::new(law(last), law(last).start()).scheme(Boris).dt(0.02);
    let saved = simulation(0.7).stepper().unwrap().checkpoint();
    assert!(simulation(0.7).resume(&saved).is_ok());
    assert_eq!(simulation(0.8).resume(&saved).err(), refused(Difference::Field { name: "c" }));
}

/// The law of one body is changed on the way: from then on it is the motion of a new simulation with the other list.
#[test]
fn laws_change_on_the_way() {
    macro_rules! change {
        ($($scheme:expr),*) => {$(for body in 0..5 {
            let scene = || bodies(ROLES[1]).pairs(Coulomb { k: 0.3 });
            let mut stepper = Simulation::scene(scene().field_of(well)).scheme($scheme).dt(0.02).stepper().unwrap();
            stepper.advance(20).unwrap();
            stepper.law_of_mut::<Well>(body).unwrap().k = 7.0;
            assert_eq!(*stepper.law_of_mut::<Well>(body).unwrap(), Well { k: 7.0, x: 0.2 });
            let changed = move |i: usize, charge: &Charge| {
                if i == body { Well { k: 7.0, x: 0.2 } } else { well(i, charge) }
            };
            let now = stepper.state();
            let new = Simulation::scene(scene().field_of(changed).starting_from(&now)).scheme($scheme).dt(0.02);
            let mut new = new.stepper().unwrap();
            stepper.advance(30).unwrap();
            new.advance(30).unwrap();
            assert_eq!(stepper.state(), new.state(), "{}, body {body}", stringify!($scheme));
            assert_eq!(stepper.energy(), new.energy());
        })*};
    }
    change!(Leapfrog, Nystrom::order6(), Implicit, DiscreteGradient, Kanatani, Gauss::order16());

    // What is one for all is reached as such, and what each has of its own body by body; to look changes nothing.
    type Laws = ((((), OnEachOwn<Well, Charge>), OnEach<WellByMass>), OnChain<Spring>);
    let chain = Spring { k: 0.1, length: 0.0 };
    let scene: Scene<2, Charge, Laws> = bodies(ROLES[0]).field_of(well).field(WellByMass { x: 0.1 }).chain(chain);
    let simulation = Simulation::scene(scene).scheme(Leapfrog).dt(0.02);
    let mut stepper: SceneStepper<2, Laws, Leapfrog, Charge> = simulation.stepper().unwrap();
    assert!(stepper.law_of_mut::<Well>(5).is_none() && stepper.law_of_mut::<Well>(usize::MAX).is_none());
    assert!(stepper.law_mut::<Well>().is_none() && stepper.law_of_mut::<WellByMass>(0).is_none());
    assert!(stepper.law_mut::<WellByMass>().is_some() && stepper.law_of_mut::<Storm>(0).is_none());
    assert!(stepper.law_mut::<Spring>().is_some() && stepper.law_of_mut::<Spring>(0).is_none());
    let mut same = stepper.clone();
    assert_eq!(stepper.law_of_mut::<Well>(3).unwrap().k, MASSES[3]);
    stepper.advance(10).unwrap();
    same.advance(10).unwrap();
    assert_eq!(stepper.state(), same.state());

    // A law without a value stands in the way, and says of whom; a better one lets it go on.
    stepper.law_of_mut::<Well>(2).unwrap().k = f64::NAN;
    let told = stepper.step().unwrap_err();
    assert!(matches!(told, Error::Body { body: 2, step: 10, .. }), "{told:?}");
    stepper.law_of_mut::<Well>(2).unwrap().k = MASSES[2];
    same.set_state(same.state()).unwrap();
    stepper.advance(10).unwrap();
    same.advance(10).unwrap();
    assert_eq!(stepper.state(), same.state());
}

/// The function is asked once for each body, in their order, when the scene is set up: for bodies that are added later, too.
#[test]
fn the_function_is_asked_once_for_each_body() {
    let asked = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&asked);
    let law = move |i: usize, &(): &()| {
        assert_eq!(count.fetch_add(1, Ordering::Relaxed), i);
        Well { k: 1.0, x: i as f64 }
    };
    let empty = Scene::<2>::new().field_of(law);
    let refused = Simulation::scene(empty.clone()).scheme(Leapfrog).dt(0.1).run(1).unwrap_err().cause();
    assert_eq!(refused, SceneError::Empty.into());
    let refused = Simulation::scene(empty.clone().body(-1.0, [0.0; 2], [0.0; 2])).scheme(Leapfrog).dt(0.1).run(1);
    assert!(matches!(refused.unwrap_err().cause(), Error::Scene(SceneError::Mass { body: 0, .. })));
    assert_eq!(asked.load(Ordering::Relaxed), 0);

    // One body.
    let run = Simulation::scene(empty.clone().body(1.0, [0.3, 0.0], [0.0; 2])).scheme(Leapfrog).dt(0.1).run(9).unwrap();
    let alone = Scene::new().body(1.0, [0.3, 0.0], [0.0; 2]).field(Well { k: 1.0, x: 0.0 });
    let alone = Simulation::scene(alone).scheme(Leapfrog).dt(0.1).run(9).unwrap();
    assert_eq!((run.states(), asked.swap(0, Ordering::Relaxed)), (alone.states(), 1));

    let three = (0..3).fold(empty, |scene, i| scene.body(1.0, [i as f64, 0.0], [0.0; 2]));
    let run = Simulation::scene(three.clone().pin(1)).scheme(DiscreteGradient).dt(0.1).run(5).unwrap();
    assert_eq!(asked.swap(0, Ordering::Relaxed), 3);
    // Each lies at the bottom of its own.
    assert_eq!(run.last().q, run.states()[0].q);
    let _ = three.as_law::<3, 6>();
    assert_eq!(asked.load(Ordering::Relaxed), 3);
}

/// Of many bodies one has a law that is not finite where it is: it is named, at the start, by every scheme, and as one law.
#[test]
fn the_body_is_named_whose_law_is_not_finite() {
    let scene = |body: usize, k: f64| {
        bodies(ROLES[0]).field_of(move |i, charge| if i == body { Well { k, x: 0.2 } } else { well(i, charge) })
    };
    macro_rules! named {
        ($($scheme:expr),*) => {$(for body in 0..5 {
            for k in [f64::NAN, f64::INFINITY] {
                let told = Simulation::scene(scene(body, k)).scheme($scheme).dt(0.1).run(5).unwrap_err().cause();
                let at = place(body).0;
                let named = matches!(told, Error::Body { body: b, step: 0, place, .. } if b == body && place.first() == at);
                assert!(named, "{k}, {}: {told:?}", stringify!($scheme));
            }
        })*};
    }
    named!(Leapfrog, Boris, DiscreteGradient, Gauss::order16());
    // On the way: an ever steeper wall throws body 3 out of all numbers.
    let thrown = |i: usize, charge: &Charge| if i == 3 { Well { k: -1e6, x: 0.2 } } else { well(i, charge) };
    let told = Simulation::scene(bodies(ROLES[0]).field_of(thrown)).scheme(Leapfrog).dt(0.1).run(100).unwrap_err();
    assert!(matches!(told.cause(), Error::Body { body: 3, .. } | Error::NotFinite { .. }), "{:?}", told.cause());
}

mod consts {
    pub(super) const PI: f64 = 3.0;
}

/// Not stepped as it is written beyond an edge, where the macro takes `consts::PI` for π; and without a value where its ends are in
/// the wrong order.
#[derive(Clone, Copy, Debug)]
struct Beyond {
    edge: f64,
    low: f64,
}

#[dmech::law]
impl Beyond {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let beyond = if q[0] > self.edge { (consts::PI * q[0]).sin() } else { q[0] * q[0] };
        beyond + q[1].clamp(self.low, 9.0).powi(2)
    }
}

/// Every law is compared with its method, where its body is and around it; the body is named whose law is another.
#[test]
fn each_law_is_compared_with_its_method() {
    let good = Beyond { edge: 100.0, low: -9.0 };
    for body in 0..5 {
        let x = place(body).0[0];
        // Panics; beyond the edge; near it.
        let wrong = [Beyond { low: 10.0, ..good }, Beyond { edge: x - 9.0, ..good }, Beyond { edge: x + 0.01, ..good }];
        for bad in wrong {
            let laws = move |i: usize, _: &Charge| if i == body { bad } else { good };
            let scene = || bodies(ROLES[0]).field_of(laws);
            let told = Simulation::scene(scene()).scheme(Leapfrog).dt(0.1).run(5).unwrap_err().cause();
            assert!(matches!(told, Error::NotAsWritten(_)), "{body}: {told:?}");
            assert!(told.to_string().contains(&format!("on body {body} at q")), "{body}: {told}");
            let law = scene().as_law::<5, 10>();
            let few = Simulation::new(law, law.start()).scheme(Leapfrog).dt(0.1).run(5).unwrap_err().cause();
            assert_eq!(few.to_string(), told.to_string());
            // On the way, too.
            let simulation = Simulation::scene(bodies(ROLES[0]).field_of(move |_, _| good)).scheme(Leapfrog).dt(0.01);
            let mut stepper = simulation.stepper().unwrap();
            *stepper.law_of_mut::<Beyond>(body).unwrap() = bad;
            assert!(matches!(stepper.step(), Err(Error::NotAsWritten(_))));
            *stepper.law_of_mut::<Beyond>(body).unwrap() = good;
            stepper.step().unwrap();
        }
    }
}
