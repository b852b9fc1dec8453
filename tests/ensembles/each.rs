//! Simulations of any kind: kept, killed and gone on with, moved by ranks, handed over, each what it is alone.

use std::fmt::Debug;
use std::fs;
use std::ops::ControlFlow;

use dmech::extend::{
    Attend, Columns, DoubleDouble, Flat, Ranks, Reach, Saved, Scheme, Setup, Snapshot as _, StoreError,
};
use dmech::models::pairs::{Charge, Coulomb, Gravity, LennardJones, Spring};
use dmech::prelude::*;
use dmech::scene::{OnBonds, OnChain, OnNear, OnPairs, Periodic};
use dmech_tests::few::part;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::laws::{Many, Orbit, Saddle};
use crate::ranks::on_ranks;
use crate::same::{outcome, the_same};
use crate::store::{Place, goes_on_after_kills};

/// All that an ensemble of a kind can be asked for, against each simulation alone. How many failed, and what happened.
pub(crate) fn everything<L, X, S, O>(
    name: &str,
    members: usize,
    member: impl Fn(usize) -> Simulation<L, X, S, O> + Sync + Copy,
    end: f64,
) -> [usize; 2]
where
    X: Setup<L, State: Flat + Columns + PartialEq + Debug + Serialize + DeserializeOwned, System: Saved>,
    S: Scheme<X::System>,
    O: Attend<X::State>,
{
    let each = || Ensemble::each(members, member);
    let whole = each().run_until(end).unwrap();
    assert_eq!(whole.len(), members, "{name}");
    let (mut failed, mut happened) = (0, 0);
    for k in 0..members {
        let alone = member(k).run_until(end);
        failed += usize::from(alone.is_err());
        happened += alone.as_ref().map_or(0, |run| run.events().len());
        assert_eq!(outcome(whole.member(k)), outcome(alone.as_ref()), "{name}, member {k}");
    }
    for threads in [1, 2, 3] {
        the_same(&whole, &each().threads(threads).run_until(end).unwrap());
        let mut next = 0;
        each()
            .threads(threads)
            .for_each_until(end, |k, came| {
                assert_eq!((k, outcome(came.as_ref())), (next, outcome(whole.member(k))), "{name}");
                next += 1;
            })
            .unwrap();
        assert_eq!(next, members, "{name}");
    }

    let place = Place::new(&format!("each-{name}"));
    let kept = |threads| each().threads(threads).store(place.file());
    the_same(&whole, &kept(2).run_until(end).unwrap());
    assert_eq!(place.number("SELECT COUNT(*) FROM last"), members as i64, "{name}");
    let sum = format!("SELECT value = '{:016x}' FROM sweep WHERE key = 'checksum'", whole.checksum());
    assert_eq!(place.number(&sum), 1, "{name}");
    assert_eq!(place.number("SELECT COUNT(*) FROM last WHERE failed IS NOT NULL"), failed as i64, "{name}");
    assert_eq!(place.number("SELECT COUNT(*) FROM event JOIN last USING (k) WHERE failed IS NULL"), happened as i64);
    if failed == 0 {
        // Whoever moved a member again would write it.
        place.sql("CREATE TRIGGER again BEFORE INSERT ON last BEGIN SELECT RAISE(ABORT, 'moved again'); END");
    }
    the_same(&whole, &kept(1).run_until(end).unwrap());
    place.sql("DROP TRIGGER IF EXISTS again");
    // Holes, as kills leave them.
    let lose = |members: &str| {
        for table in ["last", "drift", "state", "event", "change"] {
            place.sql(&format!("DELETE FROM {table} WHERE {members}"));
        }
        if X::State::LISTED {
            place.sql(&format!("DELETE FROM body WHERE {members} AND what <> 'start'"));
        }
    };
    for rest in 0..2 {
        lose(&format!("k % 3 <> {rest}"));
        let mut next = 0;
        let see = |k: usize, came: Result<Run<X::State>, Interrupted<X::State>>| {
            assert_eq!((k, outcome(came.as_ref())), (next, outcome(whole.member(k))), "{name}");
            next += 1;
        };
        kept(3).for_each_until(end, see).unwrap();
        assert_eq!(next, members, "{name}");
    }

    for (ranks, threads) in [(1, 1), (2, 1), (3, 2)] {
        let runs = on_ranks(ranks, |rank| each().threads(threads).ranks(rank).run_until(end).unwrap());
        assert!(runs[1..].iter().all(Option::is_none));
        the_same(&whole, runs[0].as_ref().unwrap());
    }
    lose("k % 2 = 0");
    let runs = on_ranks(2, |rank| each().store(place.file()).ranks(rank).run_until(end).unwrap());
    the_same(&whole, runs[0].as_ref().unwrap());
    [failed, happened]
}

/// Bodies that pull on each other, as many as the number of the member says.
fn stars(k: usize) -> Scene<2, (), ((), OnPairs<Gravity>)> {
    let sun = Scene::<2>::new().body(1.0, [0.0, 0.0], [0.0, 0.0]);
    let planets = (0..k % 5).fold(sun, |scene, i| {
        let r = 1.0 + i as f64 + 0.2 * part(k, 0.31);
        scene.body(0.01 * (1.0 + part(k, 0.17)), [r, 0.0], [0.0, r.sqrt().recip()])
    });
    planets.pairs(Gravity { g: 1.0 + 0.1 * part(k, 0.7) })
}

/// A chain that hangs from its first body.
fn chain(k: usize) -> Scene<1, (), ((), OnChain<Spring>)> {
    let links =
        (0..3 + k % 4).fold(Scene::<1>::new(), |scene, i| scene.body(1.0 + part(k + i, 0.3), [1.1 * i as f64], [0.0]));
    links.pin(0).chain(Spring { k: 20.0 + k as f64, length: 1.0 })
}

type Atoms = Scene<2, (), ((), OnNear<LennardJones>), Periodic<2>>;

/// Atoms in a box with a cut-off.
fn atoms(k: usize) -> Atoms {
    let place = |i: usize| [1.3 * (i % 5) as f64, 1.3 * (i / 5) as f64];
    let all = (0..20 + k % 6).fold(Scene::<2>::new(), |scene, i| {
        scene.body(1.0, place(i), [0.3 * part(i, 0.41) - 0.1, 0.2 * part(k + i, 0.29)])
    });
    all.periodic([7.0, 8.0]).pairs(LennardJones { epsilon: 1.0 + 0.01 * k as f64, sigma: 1.0 }).cutoff(2.5)
}

/// A ring, and whom it links.
fn ring(k: usize) -> Scene<2, (), ((), OnBonds<Spring>)> {
    let n = 3 + k % 3;
    let angle = |i: usize| core::f64::consts::TAU * i as f64 / n as f64;
    let all = (0..n).fold(Scene::<2>::new(), |scene, i| {
        scene.body(1.0 + 0.1 * i as f64, [angle(i).cos(), angle(i).sin()], [0.1 * part(k, 0.2), 0.0])
    });
    all.bonds(Spring { k: 5.0, length: 0.8 + 0.2 * part(k, 0.9) }, (0..n).map(|i| (i, (i + 1) % n)))
}

/// Ions, with charges of their own and one that does not act on the others.
fn ions(k: usize) -> Scene<3, Charge, ((), OnPairs<Coulomb>)> {
    let ions = Scene::<3, Charge>::new()
        .body_with(1.0, [1.2, 0.0, 0.2], [0.0, 1.0, 0.0], Charge { q: 1.0 + 0.01 * k as f64 })
        .body_with(6.0, [0.0, 0.1, 0.0], [0.0, -0.15, 0.0], Charge { q: -1.5 });
    let ions = if k.is_multiple_of(2) {
        ions
    } else {
        ions.test_body_with(0.1, [3.0, 1.0, 0.0], [0.0, 0.2, 0.1], Charge { q: 0.2 })
    };
    ions.pairs(Coulomb { k: 1.1 })
}

/// A law by hand, Φ = k x⁴/4.
#[derive(Clone, Copy, Debug)]
struct ByHand {
    k: f64,
}

impl Conservative for ByHand {}

impl Potential<1> for ByHand {
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        0.25 * self.k * x.powi(4)
    }
    fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] {
        [self.k * x.powi(3)]
    }
    fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] {
        [[3.0 * self.k * x * x]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        [0.25 * self.k * (a + b) * (a * a + b * b)]
    }
    fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
        [[0.25 * self.k * (a * a + 2.0 * a * b + 3.0 * b * b)]]
    }
}

#[test]
fn pairs_with_events_that_stop_some() {
    let member = |k: usize| {
        Simulation::scene(stars(k))
            .scheme(Leapfrog)
            .dt(0.01)
            .record_every(50)
            .event(|state: &SceneState<2>| state.q[0][0], Crossing::Any)
            .stop_when(move |state: &SceneState<2>| state.q[state.q.len() - 1][1] - 0.1 * k as f64, Crossing::Rising)
    };
    let [failed, happened] = everything("pairs", 30, member, 2.0);
    assert!(failed == 0 && happened > 5, "{failed}, {happened}");
}

/// Who meets whom is kept, and sent.
#[test]
fn encounters() {
    let member = |k: usize| {
        let scene = Scene::<1>::new().body(1.0, [0.0], [0.0]).body(1.0, [3.0], [-1.0 - 0.1 * k as f64]);
        let scene = if k.is_multiple_of(2) { scene } else { scene.body(1.0, [-9.0], [2.0]) };
        Simulation::scene(scene).scheme(Leapfrog).dt(0.3).encounter(0.5)
    };
    let [failed, happened] = everything("encounters", 12, member, 6.0);
    assert!(failed == 0 && happened > 20, "{failed}, {happened}");
}

#[test]
fn chains_that_hang() {
    let member = |k: usize| Simulation::scene(chain(k)).scheme(DiscreteGradient).dt(0.02).record_every(10);
    assert_eq!(everything("chain", 21, member, 1.0), [0, 0]);
    // A hand that moves the first body.
    let member = |k: usize| {
        let by_hand = chain(k).drive(0, |t: f64| ([0.1 * t.sin()], [0.1 * t.cos()]));
        Simulation::scene(by_hand).scheme(Gauss::order16()).dt(0.1).record_dt(0.3)
    };
    assert_eq!(everything("driven", 9, member, 1.0), [0, 0]);
}

#[test]
fn atoms_in_a_box() {
    let member = |k: usize| Simulation::scene(atoms(k)).scheme(Leapfrog).dt(0.005).record_every(25);
    assert_eq!(everything("box", 9, member, 0.5), [0, 0]);
}

#[test]
fn bonds_and_times_and_quantities() {
    let member = |k: usize| {
        Simulation::scene(ring(k))
            .scheme(Implicit)
            .dt(0.05)
            .record_at([0.3, 0.31, 1.1, 7.0])
            .watch("first", |state: &SceneState<2>| state.q[0][0])
    };
    assert_eq!(everything("bonds", 14, member, 1.3), [0, 0]);
}

#[test]
fn steps_that_follow_each() {
    let member = |k: usize| Simulation::scene(ions(k)).scheme(Nystrom::order6()).adaptive(1e-6).record_every(3);
    assert_eq!(everything("adaptive", 17, member, 1.5), [0, 0]);
    // Schemes and steps of their own.
    let member = |k: usize| {
        let scheme = dmech::scheme::Adaptive::new(Composed::order4(DiscreteGradient), 1e-4 / (1.0 + k as f64));
        Simulation::scene(stars(k + 1)).scheme(scheme).dt(0.1 + 0.01 * k as f64)
    };
    assert_eq!(everything("tolerances", 6, member, 1.0), [0, 0]);
}

#[test]
fn laws_by_hand() {
    let member = |k: usize| {
        let law = ByHand { k: 1.0 + 0.01 * k as f64 };
        let start = State::new([1.0], [0.3]).at_time(0.1 * (k % 3) as f64);
        Simulation::new(law, start).mass(1.0 + part(k, 0.4)).scheme(DiscreteGradient).dt(0.02).record_every(30)
    };
    assert_eq!(everything("by-hand", 40, member, 2.0), [0, 0]);
}

/// Laws of the macro with their own invariants and masses of coordinates, and an observer.
#[test]
fn laws_with_invariants_of_their_own() {
    let member = |k: usize| {
        Simulation::new(Saddle::member(k), Saddle::start(k))
            .masses([1.0, 1.0 + 0.1 * k as f64])
            .scheme(Nystrom::order6())
            .dt(0.05)
            .observe(
                1,
                |state: &State<2>| if state.t > 1.5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) },
            )
    };
    assert_eq!(everything("saddle", 25, member, 2.0), [0, 0]);
}

/// Members that are refused, begin nowhere, fail in their first step and midway, and start after the end.
#[test]
fn members_that_fail() {
    let member = |k: usize| {
        let scene = match k {
            2 => Scene::<2>::new().pairs(Gravity { g: 1.0 }),
            3 => Scene::<2>::new()
                .body(1.0, [f64::NAN, 0.0], [0.0; 2])
                .body(1.0, [1.0, 0.0], [0.0; 2])
                .pairs(Gravity { g: 1.0 }),
            5 => Scene::<2>::new().body(-1.0, [0.0; 2], [0.0; 2]).pairs(Gravity { g: 1.0 }),
            7 => stars(2).starting_from(&SceneState { t: 0.0, q: vec![[0.0; 2]; 4], v: vec![[0.0; 2]] }),
            // Two that fall on each other.
            8 => Scene::<2>::new()
                .body(1.0, [0.5, 0.0], [0.0; 2])
                .body(1.0, [-0.5, 0.0], [0.0; 2])
                .pairs(Gravity { g: 1.0 }),
            9 => Scene::<2>::new()
                .body(1.0, [0.5, 0.0], [0.0; 2])
                .body(1.0, [0.5, 0.0], [0.0; 2])
                .pairs(Gravity { g: 1.0 }),
            11 => stars(3).at_time(9.0),
            // Numbers that SQLite does not keep.
            12 => Scene::<2>::new().body(1.0, [-0.0, 0.0], [0.0, -0.0]).pairs(Gravity { g: -0.0 }),
            _ => stars(k),
        };
        let dt = if k == 10 { -1.0 } else { 0.05 };
        Simulation::scene(scene).scheme(DiscreteGradient).dt(dt)
    };
    let [failed, _] = everything("failures", 20, member, 3.0);
    assert!((7..=8).contains(&failed), "{failed}");
    let midway = |k: usize| {
        let law = dmech::models::HenonHeiles { lambda: 1.0 + 0.001 * k as f64 };
        Simulation::new(law, State::new([0.1, 0.9 + 0.02 * k as f64], [0.0, 0.1])).scheme(Leapfrog).dt(0.05)
    };
    let [failed, _] = everything("midway", 20, midway, 40.0);
    assert!(failed > 3, "{failed}");
    let run = Ensemble::each(20, midway).run_until(40.0).unwrap();
    assert!(run.members().any(|member| member.is_err_and(|failed| failed.run().steps() > 50)));
}

#[test]
fn none_and_one_and_nowhere_to_go() {
    let member = |k: usize| Simulation::scene(stars(k + 1)).scheme(Leapfrog).dt(0.01);
    assert_eq!(everything("none", 0, member, 1.0), [0, 0]);
    assert_eq!(everything("one", 1, member, 1.0), [0, 0]);
    assert_eq!(everything("still", 5, member, 0.0), [0, 0]);
    // An end before the start, and none at all: each member says so.
    assert_eq!(everything("before", 5, member, -1.0), [5, 0]);
    assert_eq!(everything("endless", 3, member, f64::INFINITY), [3, 0]);
    assert_eq!(everything("nan", 3, member, f64::NAN), [3, 0]);
    let place = Place::new("each-steps");
    let run = || Ensemble::each(5, member).store(place.file()).run(7).unwrap();
    let first = run();
    the_same(&first, &run());
    assert!(first.members().flatten().all(|run| run.steps() == 7));
}

/// What a sweep of charged bodies in a box is made of, some of them bound.
#[derive(Clone, Copy)]
struct Made {
    members: usize,
    end: f64,
    dt: f64,
    every: u64,
    bodies: usize,
    mass: f64,
    place: f64,
    speed: f64,
    t: f64,
    pin: usize,
    charge: f64,
    k: f64,
    length: f64,
    bond: usize,
    lattice: f64,
    cutoff: f64,
}

impl Made {
    const PLAIN: Made = Made {
        members: 4,
        end: 0.1,
        dt: 0.01,
        every: 5,
        bodies: 4,
        mass: 1.5,
        place: 0.0,
        speed: 0.2,
        t: 0.0,
        pin: 1,
        charge: 0.3,
        k: 1.1,
        length: 0.9,
        bond: 2,
        lattice: 9.0,
        cutoff: 4.0,
    };

    /// Of which the third member alone is so, and the others are plain.
    fn go(self, place: &Place) -> Result<EnsembleRun<SceneState<2>>, Error> {
        let member = |k: usize| {
            let made = if k == 2 { self } else { Made::PLAIN };
            let bodies = (0..made.bodies).fold(Scene::<2, Charge>::new(), |scene, i| {
                let Made { mass, place, charge, .. } = if i == 2 { made } else { Made::PLAIN };
                let speed = if i == 3 { made.speed } else { 0.0 };
                scene.body_with(mass, [i as f64, place], [0.0, speed], Charge { q: charge })
            });
            let bodies = bodies.pin(made.pin).at_time(made.t).periodic([made.lattice; 2]);
            let charged = bodies.pairs(Coulomb { k: made.k }).cutoff(made.cutoff);
            let scene = charged.bonds(Spring { k: 3.0, length: made.length }, [(0, made.bond)]);
            Simulation::scene(scene).scheme(Leapfrog).dt(made.dt).record_every(made.every)
        };
        Ensemble::each(self.members, member).store(place.file()).run_until(self.end)
    }
}

/// What other sweeps are refused with, each of which differs in one thing.
#[test]
fn another_sweep_is_refused_with_what_differs() {
    let place = Place::new("each-another");
    let original = Made::PLAIN.go(&place).unwrap();
    let name = |text: &str| dmech::extend::Name::of(&[text]);
    let of = |column: &str, store: f64, here: f64| StoreError::Member { member: 2, column: name(column), store, here };
    let looks =
        StoreError::Words { member: 2, column: "looks", store: "after every 5 steps", here: "after every 6 steps" };
    let reach = StoreError::Reach { store: Reach::Until(0.1), here: Reach::Until(0.2) };
    let plain = Made::PLAIN;
    let others = [
        (Made { members: 5, ..plain }, StoreError::Members { store: 4, here: 5 }),
        (Made { end: 0.2, ..plain }, reach),
        (Made { dt: 0.02, ..plain }, of("dt", 0.01, 0.02)),
        (Made { every: 6, ..plain }, looks),
        (Made { bodies: 5, ..plain }, of("mass", 6.0, 7.5)),
        (Made { mass: 2.5, ..plain }, of("mass", 6.0, 7.0)),
        (Made { place: 0.25, ..plain }, of("q1 of body 2", 0.0, 0.25)),
        (Made { place: -0.0, ..plain }, of("q1 of body 2", 0.0, -0.0)),
        (Made { speed: 0.3, ..plain }, of("v1 of body 3", 0.2, 0.3)),
        (Made { t: 0.01, ..plain }, of("t", 0.0, 0.01)),
        (Made { pin: 0, ..plain }, of("pinned bodies", 1.0, 0.0)),
        (Made { charge: 0.4, ..plain }, of("data of the bodies", 0.3, 0.4)),
        (Made { k: 1.2, ..plain }, of("k", 1.1, 1.2)),
        (Made { length: 1.0, ..plain }, of("length", 0.9, 1.0)),
        (Made { bond: 3, ..plain }, of("list of bonds", 2.0, 3.0)),
        (Made { lattice: 10.0, ..plain }, of("lengths of the box", 9.0, 10.0)),
        (Made { cutoff: 3.5, ..plain }, of("cut-off", 4.0, 3.5)),
    ];
    for (other, expected) in others {
        let refused = other.go(&place).unwrap_err();
        println!("{refused}");
        // As text, where 0 is not −0.
        assert_eq!(format!("{refused:?}"), format!("{:?}", Error::Store(expected)));
    }
    // None of them has touched it.
    place.sql("CREATE TRIGGER again BEFORE INSERT ON last BEGIN SELECT RAISE(ABORT, 'moved again'); END");
    the_same(&plain.go(&place).unwrap(), &original);
}

/// Masses in another order, one pin more or a bond less, another law with the same numbers, other options of a scheme, a law by hand,
/// other company, other kinds of ensembles.
#[test]
fn sweeps_that_are_nearly_the_same_are_refused() {
    let name = |text: &str| dmech::extend::Name::of(&[text]);
    fn of<T: Clone>(refused: Result<EnsembleRun<T>, Error>) -> StoreError {
        match refused {
            Err(Error::Store(error)) => error,
            Err(error) => panic!("{error}"),
            Ok(_) => panic!("not refused"),
        }
    }
    let row = |masses: [f64; 3]| {
        (0..3).fold(Scene::<2>::new(), |scene, i| scene.body(masses[i], [1.1 * i as f64, 0.1 * i as f64], [0.0; 2]))
    };
    let spring = Spring { k: 2.0, length: 1.0 };
    macro_rules! sweep {
        ($place:expr, $scene:expr, $scheme:expr) => {
            Ensemble::each(3, |_| Simulation::scene($scene).scheme($scheme).dt(0.01)).store($place.file()).run(5)
        };
    }
    let place = Place::new("each-nearly");
    sweep!(place, row([1.0, 2.0, 3.0]).chain(spring), Leapfrog).unwrap();
    let order = of(sweep!(place, row([1.0, 3.0, 2.0]).chain(spring), Leapfrog));
    assert_eq!(order, StoreError::Member { member: 0, column: name("masses of the bodies"), store: 2.0, here: 3.0 });
    let pinned = of(sweep!(place, row([1.0, 2.0, 3.0]).chain(spring).pin(2), Leapfrog));
    assert_eq!(pinned, StoreError::Numbers { member: 0, name: "pinned bodies" });
    // The same numbers, but all pairs.
    let pairs = of(sweep!(place, row([1.0, 2.0, 3.0]).pairs(spring), Leapfrog));
    assert_eq!(pairs, StoreError::Acts { member: 0 });
    let scheme = of(sweep!(place, row([1.0, 2.0, 3.0]).chain(spring), DiscreteGradient));
    assert_eq!(scheme, StoreError::Scheme { store: name("Leapfrog"), here: "DiscreteGradient" });
    let one_more = of(sweep!(place, row([1.0, 2.0, 3.0]).chain(spring).bonds(spring, [(0, 2)]), Leapfrog));
    assert_eq!(one_more, StoreError::Numbers { member: 0, name: "k" });

    let place = Place::new("each-bonds");
    sweep!(place, row([1.0; 3]).bonds(spring, [(0, 1), (1, 2)]), Leapfrog).unwrap();
    let fewer = of(sweep!(place, row([1.0; 3]).bonds(spring, [(0, 1)]), Leapfrog));
    assert_eq!(fewer, StoreError::Numbers { member: 0, name: "list of bonds" });

    // As many bodies with the same sum of masses.
    let place = Place::new("each-bodies");
    let spread = |n: usize| (0..n).fold(Scene::<1>::new(), |scene, i| scene.body(4.0 / n as f64, [i as f64], [0.0]));
    sweep!(place, spread(4), Leapfrog).unwrap();
    assert_eq!(of(sweep!(place, spread(2), Leapfrog)), StoreError::Numbers { member: 0, name: "bodies" });

    // Options of a scheme, tolerances.
    let place = Place::new("each-options");
    let adaptive = |tolerance| dmech::scheme::Adaptive::new(DiscreteGradient, tolerance);
    sweep!(place, row([1.0; 3]).chain(spring), adaptive(1e-3)).unwrap();
    let other = of(sweep!(place, row([1.0; 3]).chain(spring), adaptive(1e-4)));
    assert!(matches!(other, StoreError::Words { member: 0, column: "options", .. }), "{other}");

    // A law by hand: no fields are known, but what acts.
    let place = Place::new("each-hand");
    // Where they start nothing acts on them.
    let by_hand = |k: f64, mass: f64| {
        let member =
            |_: usize| Simulation::new(ByHand { k }, State::new([0.0], [0.3])).mass(mass).scheme(Leapfrog).dt(0.01);
        Ensemble::each(3, member).store(place.file()).run(5)
    };
    by_hand(1.0, 2.0).unwrap();
    assert_eq!(of(by_hand(1.5, 2.0)), StoreError::Acts { member: 0 });
    let mass = StoreError::Member { member: 0, column: name("mass"), store: 2.0, here: 2.5 };
    assert_eq!(of(by_hand(1.0, 2.5)), mass);

    // When they are looked at.
    let place = Place::new("each-looks");
    type Bare = Simulation<Orbit, State<2>, Leapfrog>;
    let bare = |k: usize| Simulation::new(Orbit::member(k), Orbit::start(k)).scheme(Leapfrog).dt(0.01);
    let looks = |at: fn(Bare) -> Bare| {
        Ensemble::each(3, |k| if k == 1 { at(bare(k)) } else { bare(k) }).store(place.file()).run(5)
    };
    looks(|plain| plain.record_at([0.7, 0.8])).unwrap();
    type Other = (fn(Bare) -> Bare, &'static str);
    let others: [Other; 3] = [
        (|plain| plain.record_at([0.7, 0.9]), "at t = [0.7, 0.9]"),
        (|plain| plain.record_dt(0.7), "every 0.7 of time"),
        (|plain| plain, "after every 1 steps"),
    ];
    for (other, here) in others {
        let refused = of(looks(other));
        assert_eq!(refused, StoreError::Words { member: 1, column: "looks", store: "at t = [0.7, 0.8]", here });
    }

    // Of what is long, from a little before the difference.
    let place = Place::new("each-long");
    let long = |last: f64| {
        let times = (1..40).map(move |k| if k == 30 { last } else { 0.25 * f64::from(k) });
        let member = move |k: usize| bare(k).record_at(times.clone());
        of(Ensemble::each(3, member).store(place.file()).run(5))
    };
    let times = (1..40).map(|k| 0.25 * f64::from(k));
    Ensemble::each(3, move |k: usize| bare(k).record_at(times.clone())).store(place.file()).run(5).unwrap();
    let differs = long(7.6).to_string();
    assert!(
        differs.contains("`… 6.75, 7.0, 7.25, 7.5, 7.75") && differs.contains("`… 6.75, 7.0, 7.25, 7.6, 7.75"),
        "{differs}"
    );

    // What accompanies them; and other kinds of ensembles.
    let place = Place::new("each-company");
    let each = || Ensemble::each(3, bare).store(place.file()).run(5);
    each().unwrap();
    let stops = |k: usize| bare(k).stop_when(|state: &State<2>| state.q[0], Crossing::Any);
    let company = of(Ensemble::each(3, stops).store(place.file()).run(5));
    assert!(matches!(company, StoreError::Company { .. }), "{company}");
    let law = Ensemble::of(3).law(Orbit::member).start(Orbit::start).scheme(Leapfrog).dt(0.01);
    let refused = of(law.clone().store(place.file()).run(5));
    assert_eq!(refused, StoreError::Law { what: "fields", store: name("each its own"), here: "law_gm" });
    let scene = of(sweep!(place, row([1.0; 3]).chain(spring), Leapfrog));
    assert!(matches!(scene, StoreError::Law { what: "fields", .. }), "{scene}");
    let place = Place::new("each-of-law");
    law.store(place.file()).run(5).unwrap();
    let refused = of(Ensemble::each(3, bare).store(place.file()).run(5));
    assert_eq!(refused, StoreError::Law { what: "fields", store: name("law_gm"), here: "each its own" });
}

/// Rows that somebody has changed, added or taken away, and bytes that are others: refused, or as it was. Never anything else.
#[test]
fn damaged_stores_are_refused() {
    let place = Place::new("each-damaged");
    let member = |k: usize| {
        let scene = Scene::<1>::new().body(1.0, [0.0], [0.0]).body(1.0, [3.0], [-1.0]);
        let scene = if k.is_multiple_of(2) { scene } else { scene.body(2.0, [-9.0], [2.0]) };
        Simulation::scene(scene.chain(Spring { k: 0.01, length: 1.0 })).scheme(Leapfrog).dt(0.3).encounter(0.5)
    };
    let sweep = || Ensemble::each(20, member).threads(1).store(place.file()).run_until(6.0);
    let whole = sweep().unwrap();
    assert!(whole.members().flatten().any(|run| run.events().len() > 1));
    let bytes = fs::read(place.file()).unwrap();
    let with = |bytes: &[u8]| {
        for end in ["-wal", "-shm"] {
            let _ = fs::remove_file(place.file().with_extension(format!("sqlite{end}")));
        }
        fs::write(place.file(), bytes).unwrap();
        sweep()
    };
    let edits = [
        ("UPDATE body SET q0 = 0.5 WHERE k = 3 AND what = 'last' AND body = 1", "last", 3),
        ("UPDATE body SET q0 = 0.5 WHERE k = 3 AND what = 'start' AND body = 1", "member", 3),
        ("UPDATE body SET v0 = 0.5 WHERE k = 3 AND what = 'event' AND n = 0 AND body = 0", "last", 3),
        ("UPDATE body SET v0 = 0.5 WHERE k = 3 AND what = 'state' AND n = 2 AND body = 0", "last", 3),
        ("DELETE FROM body WHERE k = 3 AND what = 'last' AND body = 2", "body", 3),
        ("DELETE FROM body WHERE k = 3 AND what = 'start' AND body = 2", "member", 3),
        ("DELETE FROM body WHERE k = 3 AND what = 'state' AND n = 1 AND body = 0", "body", 3),
        (
            "INSERT INTO body SELECT k, what, n, body + 3, q0, v0, bits FROM body WHERE k = 3 AND what = 'last'",
            "body",
            3,
        ),
        (
            "INSERT INTO body SELECT k, what, n + 1, body, q0, v0, bits FROM body WHERE k = 3 AND what = 'start'",
            "member",
            3,
        ),
        (
            "INSERT INTO body SELECT k, what, n + 1, body, q0, v0, bits FROM body WHERE k = 19 AND what = 'start'",
            "member",
            19,
        ),
        ("UPDATE last SET bodies = 2 WHERE k = 3", "last", 3),
        ("UPDATE member SET bodies = 2 WHERE k = 3", "member", 3),
        ("UPDATE member SET dt = 0.4 WHERE k = 3", "member", 3),
        ("UPDATE member SET options = 'others' WHERE k = 3", "member", 3),
        ("UPDATE member SET acts = 0 WHERE k = 3", "member", 3),
        ("UPDATE number SET value = 9 WHERE k = 3 AND name = 'k'", "member", 3),
        ("UPDATE number SET name = 'l' WHERE k = 3 AND name = 'k'", "member", 3),
        ("DELETE FROM number WHERE k = 3 AND n = 4", "member", 3),
        ("INSERT INTO number VALUES (3, 99, 'k', 1, NULL)", "member", 3),
        ("UPDATE event SET a = a + 1 WHERE k = 3 AND n = 0", "last", 3),
        ("UPDATE event SET b = NULL WHERE k = 3 AND n = 0", "last", 3),
        ("DELETE FROM event WHERE k = 3 AND n = 0", "body", 3),
        ("UPDATE drift SET max_abs = 0 WHERE k = 3", "drift", 3),
    ];
    for (sql, table, member) in edits {
        the_same(&with(&bytes).unwrap(), &whole);
        place.sql(sql);
        assert_eq!(sweep().err(), Some(Error::Store(StoreError::Changed { table, member })), "{sql}");
    }
    for table in ["number", "body"] {
        with(&bytes).unwrap();
        place.sql(&format!("DROP TABLE {table}"));
        assert_eq!(sweep().err(), Some(Error::Store(StoreError::Missing { table })));
    }
    let places: Vec<usize> = (0..100).chain((100..bytes.len()).step_by(397)).collect();
    let found = places.iter().filter(|&&at| {
        let mut flipped = bytes.clone();
        flipped[at] ^= 0xff;
        match with(&flipped) {
            Ok(run) => {
                the_same(&run, &whole);
                false
            }
            Err(Error::Store(_)) => true,
            Err(error) => panic!("byte {at}: {error}"),
        }
    });
    let found = found.count();
    println!("{found} of {} flipped bytes refused, of {}", places.len(), bytes.len());
    assert!(found > places.len() / 3, "{found} of {}", places.len());
}

/// Killed with signal 9 and gone on with, scenes of unequal sizes are the same every time.
#[cfg(unix)]
#[test]
fn scenes_that_were_killed_go_on() {
    let sweep = |file: Option<std::path::PathBuf>| {
        let member = |k: usize| Simulation::scene(stars(k)).scheme(Leapfrog).dt(0.005).record_every(100);
        let each = Ensemble::each(600, member).threads(2);
        match file {
            Some(file) => each.store(file).run_until(2.0),
            None => each.run_until(2.0),
        }
        .unwrap()
        .checksum()
    };
    goes_on_after_kills("each::scenes_that_were_killed_go_on", 600, 4, sweep);
}

/// Tables have rows of one length: members of unequal numbers of bodies are for a store.
#[test]
fn rows_of_unequal_lengths_are_refused() {
    let table = |bodies: fn(usize) -> usize, npy: bool| {
        let member = |k: usize| Simulation::scene(stars(bodies(k))).scheme(Leapfrog).dt(0.01);
        let run = Ensemble::each(6, member).run(3).unwrap();
        let mut bytes = std::io::Cursor::new(Vec::new());
        let written = if npy { run.write(Npy::new(&mut bytes)) } else { run.write(Csv::new(&mut bytes)) };
        (written.map_err(|error| error.kind()), bytes.into_inner().len())
    };
    for npy in [false, true] {
        assert!(matches!(table(|_| 3, npy), (Ok(()), 300..)));
        assert_eq!(table(|k| 3 + k / 5, npy), (Err(std::io::ErrorKind::InvalidInput), 0));
    }
}

/// Ranks with other scenes are named.
#[test]
fn other_scenes_on_other_ranks() {
    let with = |change: fn(usize) -> f64| {
        on_ranks(3, |rank| {
            let odd = if rank.rank() == 2 { change } else { |_| 0.0 };
            let member = |k: usize| {
                let scene = stars(k + 2).body(1e-3 + odd(k), [9.0, 0.0], [0.0, 0.3]);
                Simulation::scene(scene).scheme(Leapfrog).dt(0.01)
            };
            Ensemble::each(40, member).ranks(rank).run(10).map(|run| run.map(|run| run.len()))
        })
    };
    assert_eq!(with(|_| 0.0), [Ok(Some(40)), Ok(None), Ok(None)]);
    let refused = [Err(Error::OtherEnsemble { rank: 2 }), Err(Error::FirstRank), Err(Error::FirstRank)];
    assert_eq!(with(|k| if k == 0 { 1e-4 } else { 0.0 }), refused);
    assert_eq!(with(|k| if k == 39 { 1e-4 } else { 0.0 }), refused);
}

/// Members are handed over before the last is begun: what waits needs bounded room.
#[test]
fn few_are_on_their_way() {
    use std::sync::atomic::{AtomicUsize, Ordering::SeqCst};
    for threads in [1, 2, 3] {
        let begun = AtomicUsize::new(0);
        let member = |k: usize| {
            begun.fetch_add(1, SeqCst);
            Simulation::scene(stars(k)).scheme(Leapfrog).dt(0.1)
        };
        let mut most = 0;
        let each = Ensemble::each(2000, member).threads(threads);
        each.for_each_until(0.2, |k, _| most = most.max(begun.load(SeqCst) - k)).unwrap();
        assert!(most <= 8 * 4 * (threads + 1), "{most} on {threads} threads");
    }
}

/// States are lists of numbers, of as many bodies as the longer of two lists has.
#[test]
fn states_are_lists_of_numbers() {
    let state = SceneState { t: 0.5, q: vec![[1.0, 2.0], [3.0, 4.0]], v: vec![[5.0, 6.0], [-0.0, f64::MAX]] };
    let numbers = state.flat();
    assert_eq!(numbers, [0.5, 1.0, 2.0, 5.0, 6.0, 3.0, 4.0, -0.0, f64::MAX]);
    assert_eq!(SceneState::of_flat(&numbers), state);
    let none = SceneState::<2> { t: 0.5, q: vec![], v: vec![] };
    assert_eq!(SceneState::of_flat(&none.flat()), none);
    let law = State::new([1.0, 2.0], [3.0, 4.0]).at_time(0.5);
    assert_eq!((law.flat(), State::of_flat(&law.flat())), (vec![0.5, 1.0, 2.0, 3.0, 4.0], law));
    for (q, v) in [(2, 1), (1, 2)] {
        let numbers = SceneState { t: 0.5, q: vec![[1.0]; q], v: vec![[2.0]; v] }.flat();
        let nan = if q < v { 3 } else { 4 };
        assert_eq!(numbers.len(), 5);
        assert!(numbers.iter().enumerate().all(|(i, x)| x.is_nan() == (i == nan)), "{numbers:?}");
    }
}

/// States of other scalars are moved as before.
#[test]
fn numbers_of_more_digits() {
    let start = |k: usize| State::of([1.0, 0.1].map(DoubleDouble::from), [0.1 * k as f64, 0.9].map(DoubleDouble::from));
    let member = |k: usize| Simulation::new(Orbit::member(k), start(k)).scheme(Leapfrog).dt(0.01);
    let run = Ensemble::each(20, member).threads(2).run(50).unwrap();
    for k in 0..20 {
        assert_eq!(run.last(k).unwrap(), *member(k).run(50).unwrap().last());
    }
}
