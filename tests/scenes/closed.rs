//! Laws of motion of scenes: orders, reversal, work, links against each other. What closed systems keep is among the long suites.

use approx::abs_diff_eq;
use dmech::models::pairs::{FermiPastaUlamTsingou, Gravity, LennardJones};
use dmech::prelude::*;
use dmech::scene::{Acts, SceneSystem, Term};
use dmech_tests::few::planets;

/// −c (vₐ − v_b): friction between neighbours.
#[derive(Clone, Copy, Debug)]
struct Friction {
    c: f64,
}

#[dmech::law]
impl Friction {
    #[pair_force]
    fn force(&self, va: [f64; 2], vb: [f64; 2], d: [f64; 2]) -> [f64; 2] {
        let strength = self.c / (1.0 + d[0] * d[0] + d[1] * d[1]);
        [-strength * (va[0] - vb[0]), -strength * (va[1] - vb[1])]
    }
}

/// k |q|²/2 + q⁴/4: a well that is the same for all.
#[derive(Clone, Copy, Debug)]
struct Well {
    k: f64,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let s = q[0] * q[0] + q[1] * q[1];
        0.5 * self.k * s + 0.25 * s * s
    }
}

/// The largest distance between the positions of two states.
fn apart<const D: usize>(a: &SceneState<D>, b: &SceneState<D>) -> f64 {
    let distances = a.q.iter().zip(&b.q).flat_map(|(a, b)| (0..D).map(move |k| (a[k] - b[k]).abs()));
    distances.fold(0.0, f64::max)
}

/// Order, work and reversal of one scheme on a scene with a field, a chain, bonds and, where the scheme allows it, friction.
fn moves_as_it_should<L: Term<2, ()> + Clone, S: Scheme<SceneSystem<2, L::Ready>>>(scene: &Scene<2, (), L>, scheme: S) {
    let end = 1.0;
    let run = |n: u64| {
        let simulation = Simulation::scene(scene.clone()).scheme(scheme).dt(end / n as f64).record_every(16);
        simulation.run(n).unwrap()
    };
    let finest = [16384, 2048, 512][S::ORDER as usize / 2];
    let [coarse, middle, fine] = [finest / 4, finest / 2, finest].map(run);
    let order = (apart(coarse.last(), middle.last()) / apart(middle.last(), fine.last())).log2();
    println!("{:<48} order {order:.3}", S::NAME);
    assert!(abs_diff_eq!(order, f64::from(S::ORDER), epsilon = 0.06), "{}: {order}", S::NAME);
    let kinetic = |state: &SceneState<2>| {
        let bodies = scene.masses().iter().zip(&state.v);
        0.5 * bodies.map(|(m, v)| m * (v[0] * v[0] + v[1] * v[1])).sum::<f64>()
    };
    let largest = fine.states().iter().map(kinetic).fold(0.0, f64::max);
    let work = fine.drift(Invariant::WorkEnergy).unwrap();
    println!("{:<18} kinetic energy - work {:.1e} of the largest {largest:.1}", S::NAME, work.max_abs() / largest);
    assert!(work.max_abs() < 1e-12 * largest, "{}: {work:?}", S::NAME);
}

fn jolly() -> Scene<2> {
    (0..6).fold(Scene::new(), |scene, i| {
        let x = f64::from(i);
        scene.body(0.7 + 0.3 * x, [0.9 * x, 0.5 * (2.3 * x).sin()], [0.4 * (1.1 * x).cos(), 0.3 * (0.7 * x).sin()])
    })
}

#[test]
fn orders_and_work() {
    let potentials = jolly()
        .field(Well { k: 0.6 })
        .chain(LennardJones { epsilon: 0.3, sigma: 0.8 })
        .bonds(Gravity { g: 0.4 }, [(0, 2), (1, 5), (3, 5)]);
    moves_as_it_should(&potentials, Explicit);
    moves_as_it_should(&potentials, Leapfrog);
    moves_as_it_should(&potentials, Implicit);
    moves_as_it_should(&potentials, DiscreteGradient);
    moves_as_it_should(&potentials, Kanatani);
    moves_as_it_should(&potentials, Composed::order4(Leapfrog));
    moves_as_it_should(&potentials, Composed::order4(DiscreteGradient));
    moves_as_it_should(&potentials, Nystrom::order4());
    moves_as_it_should(&potentials, Nystrom::new(coefficients::McLachlan4S5));
    let rubbed = potentials.chain(Friction { c: 0.7 }).pin(0);
    let still = Scene::clone(&rubbed);
    assert!(
        matches!(
            Simulation::scene(still).scheme(Implicit).dt(0.1).run(1).unwrap_err().cause(),
            Error::Scene(dmech::SceneError::PinnedMoves { body: 0, .. })
        ),
        "a pinned body cannot start with a velocity"
    );
    let mut rubbed = Scene::new();
    for i in 0..6 {
        let x = f64::from(i);
        let v = if i == 0 { [0.0; 2] } else { [0.4 * (1.1 * x).cos(), 0.3 * (0.7 * x).sin()] };
        rubbed = rubbed.body(0.7 + 0.3 * x, [0.9 * x, 0.5 * (2.3 * x).sin()], v);
    }
    let rubbed = rubbed.pairs(LennardJones { epsilon: 0.3, sigma: 0.8 }).pairs(Friction { c: 0.7 }).pin(0);
    moves_as_it_should(&rubbed, Explicit);
    moves_as_it_should(&rubbed, Implicit);
    moves_as_it_should(&rubbed, DiscreteGradient);
    moves_as_it_should(&rubbed, Composed::order4(DiscreteGradient));
}

/// A chain as a chain, as bonds and, for three bodies with the ends unlinked, as pairs less a bond: the same motion.
#[test]
fn links_of_all_kinds_are_the_same() {
    let law = LennardJones { epsilon: 0.7, sigma: 0.9 };
    let bodies = || {
        Scene::new().body(1.0, [0.0, 0.1], [0.1, 0.0]).body(2.0, [1.1, 0.0], [0.0, 0.2]).body(
            1.5,
            [1.9, 0.7],
            [-0.3, 0.1],
        )
    };
    fn ends<L: Term<2, ()> + Clone>(scene: Scene<2, (), L>) -> [SceneState<2>; 3]
    where
        Leapfrog: Scheme<SceneSystem<2, L::Ready>>,
        Implicit: Scheme<SceneSystem<2, L::Ready>>,
        DiscreteGradient: Scheme<SceneSystem<2, L::Ready>>,
    {
        let simulation = || Simulation::scene(scene.clone()).dt(0.01);
        [
            simulation().scheme(Leapfrog).run(300).unwrap().last().clone(),
            simulation().scheme(Implicit).run(300).unwrap().last().clone(),
            simulation().scheme(DiscreteGradient).run(300).unwrap().last().clone(),
        ]
    }
    let pairs = ends(bodies().pairs(law));
    let bonds = ends(bodies().bonds(law, [(0, 1), (2, 1), (0, 2)]));
    let mixed = ends(bodies().chain(law).bonds(law, [(2, 0)]));
    let started = bodies().pairs(law);
    for i in 0..3 {
        assert!(apart(&pairs[i], &bonds[i]) < 1e-12 && apart(&pairs[i], &mixed[i]) < 1e-12);
    }
    assert!(apart(&pairs[0], &pairs[2]) > 1e-7, "different schemes differ");
    drop(started);
}

/// Forward, velocities turned round, and back.
#[test]
fn symmetric_schemes_go_back() {
    fn returns<S: Scheme<SceneSystem<2, A>>, A: Acts<2>, L: Term<2, (), Ready = A>>(
        law: impl Fn(Scene<2>) -> Scene<2, (), L>,
        scheme: S,
    ) {
        let forward = Simulation::scene(law(planets())).scheme(scheme).dt(0.01).run(400).unwrap();
        let masses = [5.0, 0.3, 0.1, 0.02];
        let back = forward.last().clone().reversed();
        let turned = (0..4).fold(Scene::new(), |scene, i| scene.body(masses[i], back.q[i], back.v[i]));
        let returned = Simulation::scene(law(turned)).scheme(scheme).dt(0.01).run(400).unwrap();
        let distance = apart(returned.last(), &forward.states()[0]);
        println!("{:<18} {distance:.1e}", S::NAME);
        assert!(apart(forward.last(), &forward.states()[0]) > 0.1 && distance < 1e-10, "{}: {distance:e}", S::NAME);
    }
    let law = |scene: Scene<2>| scene.pairs(Gravity { g: 0.9 });
    returns(law, Leapfrog);
    returns(law, Composed::order6(Leapfrog));
    returns(law, Composed::order6(DiscreteGradient));
    returns(law, Nystrom::order4());
    returns(law, Nystrom::order6());
    returns(law, Implicit);
    returns(law, DiscreteGradient);
}

/// Three bodies as one law of six coordinates move as the scene does.
#[derive(Clone, Copy, Debug)]
struct ThreeBodies {
    g: f64,
    m: [f64; 3],
}

#[dmech::law]
impl ThreeBodies {
    #[potential]
    fn energy(&self, q: [f64; 6]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let (x, y) = (q[2 * i] - q[2 * j], q[2 * i + 1] - q[2 * j + 1]);
                sum -= self.g * self.m[i] * self.m[j] / (x * x + y * y).sqrt();
            }
        }
        sum
    }
}

#[test]
fn a_small_scene_is_a_law_too() {
    let (g, m) = (1.1, [1.0, 1.4, 0.7]);
    let q = [[0.97, -0.24], [-0.97, 0.24], [0.1, 0.02]];
    let v = [[0.46, 0.43], [0.45, 0.4], [-0.9, -0.8]];
    let scene = || (0..3).fold(Scene::new(), |scene, i| scene.body(m[i], q[i], v[i])).pairs(Gravity { g });
    let state = State::new(
        [q[0][0], q[0][1], q[1][0], q[1][1], q[2][0], q[2][1]],
        [v[0][0], v[0][1], v[1][0], v[1][1], v[2][0], v[2][1]],
    );
    let masses = [m[0], m[0], m[1], m[1], m[2], m[2]];
    macro_rules! same {
        ($($scheme:expr),*) => {$(
            let law = Simulation::new(ThreeBodies { g, m }, state).masses(masses).scheme($scheme).dt(0.002).run(500).unwrap();
            let bodies = Simulation::scene(scene()).scheme($scheme).dt(0.002).run(500).unwrap();
            for i in 0..3 {
                for k in 0..2 {
                    let difference = (law.last().q[2 * i + k] - bodies.last().q[i][k]).abs();
                    assert!(difference < 1e-11, "{:?}: {difference:e}", $scheme);
                }
            }
        )*};
    }
    same!(Explicit, Leapfrog, Implicit, DiscreteGradient, Kanatani);
    // The orders of these are measured on laws.
    same!(Composed::order4(Leapfrog), Composed::order6(Leapfrog), Composed::order8(Leapfrog));
    same!(Composed::order4(DiscreteGradient), Composed::order6(DiscreteGradient), Composed::order8(DiscreteGradient));
    same!(Nystrom::order4(), Nystrom::order6(), Nystrom::new(coefficients::BlanesMoan6S11));
}

/// Everything that is refused before the first step, by its words.
#[test]
fn wrong_scenes_are_refused() {
    fn words<const D: usize, L: Term<D, ()>>(scene: Scene<D, (), L>) -> String
    where
        Leapfrog: Scheme<SceneSystem<D, L::Ready>>,
    {
        let refused = Simulation::scene(scene).scheme(Leapfrog).dt(0.1).run(3).unwrap_err();
        assert!(refused.run().states().is_empty());
        refused.to_string()
    }
    let two = || Scene::new().body(1.0, [0.0], [0.0]).body(2.0, [1.5], [0.0]);
    let spring = FermiPastaUlamTsingou { k: 1.0, alpha: 0.1, beta: 0.2 };
    assert_eq!(words(Scene::<1>::new().chain(spring)), "the scene has no bodies");
    assert_eq!(
        words(two().body(-3.0, [2.0], [0.0]).chain(spring)),
        "the mass of body 2 must be positive and finite, not -3"
    );
    assert_eq!(words(two().body(f64::NAN, [2.0], [0.0])), "the mass of body 2 must be positive and finite, not NaN");
    assert_eq!(words(two().body(1.0, [f64::NAN], [0.0])), "body 2 must have a finite state: q = NaN");
    assert_eq!(words(two().body(1.0, [0.0], [f64::INFINITY])), "body 2 must have a finite state: v = inf");
    assert_eq!(words(two().pin(2)), "body 2 cannot be pinned or driven: the bodies are 0 to 1");
    assert_eq!(
        words(two().body(1.0, [2.0], [0.25]).pin(2)),
        "body 2 is pinned and must be at rest: a component of its velocity is 0.25"
    );
    assert_eq!(words(two().bonds(spring, [(0, 7)])), "no bond between 0 and 7: the bodies are 0 to 1");
    assert_eq!(words(two().bonds(spring, [(1, 1)])), "body 1 is bonded to itself");
    assert_eq!(words(two().bonds(spring, [(0, 1), (1, 0)])), "the bond between bodies 1 and 0 is listed twice");
    assert_eq!(words(two().at_time(f64::NAN)), "the state must be finite: t = NaN");
    // Under a regular law bodies may coincide, under a singular one not.
    assert!(Simulation::scene(two().body(1.0, [1.5], [0.0]).chain(spring)).scheme(Leapfrog).dt(0.1).run(3).is_ok());
    assert_eq!(
        words(two().body(1.0, [1.5], [0.0]).pairs(Gravity { g: 1.0 })),
        "bodies 1 and 2 coincide, where their law is not finite, step 0, t = 0"
    );
    let scene = two().chain(spring);
    assert!(matches!(
        Simulation::scene(scene.clone()).scheme(Leapfrog).run(1).unwrap_err().cause(),
        Error::MissingTimeStep
    ));
    let refused = Simulation::scene(scene).scheme(Leapfrog).dt(-0.1).run(1).unwrap_err();
    assert!(matches!(refused.cause(), Error::TimeStep { .. }));
}

/// Two bodies that meet: the run ends with both named and everything up to there. Gravity with g = 0 acts on nobody and is
/// still not finite where two bodies coincide.
#[test]
fn a_collision_names_the_bodies() {
    let scene = Scene::new()
        .body(1.0, [-0.5], [1.0])
        .body(1.0, [40.0], [0.0])
        .body(1.0, [0.5], [-1.0])
        .pairs(Gravity { g: 0.0 });
    let failed = Simulation::scene(scene).scheme(Leapfrog).dt(0.125).run(100).unwrap_err();
    assert_eq!(failed.cause().to_string(), "bodies 0 and 2 coincide, where their law is not finite, step 4, t = 0.375");
    assert_eq!(failed.run().steps(), 3);
    assert_eq!(failed.run().last().q[0], [-0.125]);
}

/// A spring within a distance, and friction there.
#[derive(Clone, Copy, Debug)]
struct Grains {
    k: f64,
    c: f64,
    reach: f64,
}

#[dmech::law]
impl Grains {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        if r < self.reach { 0.4 * self.k * (self.reach - r).powf(2.5) } else { 0.0 }
    }
    #[pair_force]
    fn friction(&self, d: [f64; 2], va: [f64; 2], vb: [f64; 2]) -> [f64; 2] {
        let near = d[0] * d[0] + d[1] * d[1] < self.reach * self.reach;
        if near { [-self.c * (va[0] - vb[0]), -self.c * (va[1] - vb[1])] } else { [0.0, 0.0] }
    }
}

/// What acts within a distance is reciprocal if it is there, and may be cut off where it ends, friction and all: the same motion, of
/// which the momentum is kept and the energy falls.
#[test]
fn grains_rub_within_their_reach() {
    let law = Grains { k: 90.0, c: 0.8, reach: 0.5 };
    let scene = || {
        let scene = Scene::new().body(1.3, [0.0, 0.0], [0.9, 0.1]).body(2.1, [1.0, 0.05], [-0.5, 0.0]);
        scene.body(0.7, [1.6, 0.4], [-1.5, -0.6]).pairs(law)
    };
    let mut slowed = 0;
    macro_rules! check {
        ($($scheme:expr),*) => {$(
            let whole = Simulation::scene(scene()).scheme($scheme).dt(0.01).run(300).unwrap();
            let cut = Simulation::scene(scene().cutoff(law.reach)).scheme($scheme).dt(0.01).run(300).unwrap();
            assert!(apart(whole.last(), cut.last()) < 1e-12, "{}: {:e}", whole.report().scheme(), apart(whole.last(), cut.last()));
            for run in [&whole, &cut] {
                assert!(run.drift(Invariant::LinearMomentum).unwrap().max_abs() < 1e-14);
                assert!(run.drift(Invariant::WorkEnergy).unwrap().max_abs() < 1e-14);
                assert!(run.drift(Invariant::Energy).is_none());
            }
            let speed = |v: &[[f64; 2]]| v.iter().flatten().map(|v| v * v).sum::<f64>();
            slowed += u32::from(speed(&whole.last().v) < 0.5 * speed(&whole.states()[0].v));
        )*};
    }
    check!(Explicit, Implicit, DiscreteGradient, Composed::order4(DiscreteGradient), LineIntegral::order6());
    assert_eq!(slowed, 5);
}
