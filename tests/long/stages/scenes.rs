//! Scenes: one sweep a pass over the bodies, and the motion of the law that says the same.

use dmech::models::Kepler;
use dmech::models::pairs::{Gravity, LennardJones, Spring};
use dmech::prelude::*;
use dmech_tests::measured::WIND;
use dmech_tests::motion::distance;

use crate::laws::*;

/// Of a scene under a scheme, its end.
macro_rules! end {
    ($scene:expr, $scheme:expr, $dt:expr, $steps:expr) => {
        Simulation::scene($scene).scheme($scheme).dt($dt).run($steps).unwrap().last().clone()
    };
}

fn apart(x: &[[f64; 2]], y: &[[f64; 2]]) -> f64 {
    x.iter().zip(y).map(|(x, y)| distance(*x, *y)).fold(0.0, f64::max)
}

/// Three bodies as one law of six coordinates.
#[derive(Clone, Copy, Debug)]
struct Three {
    g: f64,
    eps: f64,
    m: [f64; 3],
}

#[dmech::law]
impl Three {
    fn pair(&self, x: f64, y: f64) -> f64 {
        1.0 / (x * x + y * y + self.eps * self.eps).sqrt()
    }
    #[potential]
    fn energy(&self, q: [f64; 6]) -> f64 {
        let [a, b, c, d, e, f] = q;
        let [l, m, n] = self.m;
        -self.g * (l * m * self.pair(a - c, b - d) + m * n * self.pair(c - e, d - f) + n * l * self.pair(e - a, f - b))
    }
}

#[test]
fn a_scene_is_its_law() {
    let (q, v) = ([0.7, -0.4], [0.3, 0.8]);
    let mut compared = 0;
    macro_rules! same {
        ($scheme:expr, $_:tt) => {{
            let dt = 0.1;
            let alone =
                *Simulation::new(WIND, State::new(q, v)).mass(1.3).scheme($scheme).dt(dt).run(100).unwrap().last();
            let one = end!(Scene::new().body(1.3, q, v).field(WIND), $scheme, dt, 100);
            let miss = distance(alone.q, one.q[0]).max(distance(alone.v, one.v[0]));
            assert!(miss < 1e-13 && distance(q, one.q[0]) > 0.1, "{miss:e}");

            // A pinned body is a centre that does not move.
            let sun = Simulation::new(Kepler { gm: 1.3 * 0.6 }, State::new(q, v)).mass(0.9).scheme($scheme).dt(dt);
            let sun = *sun.run(100).unwrap().last();
            let pinned = Scene::new().body(0.7, q, v).body(1.3, [0.0; 2], [0.0; 2]).pin(1);
            let pinned = end!(pinned.pairs(Gravity { g: 0.6 / 0.9 }), $scheme, dt, 100);
            assert!(
                distance(sun.q, pinned.q[0]) < 1e-12 && pinned.q[1] == [0.0; 2],
                "{:e}",
                distance(sun.q, pinned.q[0])
            );
            compared += 1;
        }};
    }
    for_each_order!(same! { 0 });
    assert_eq!(compared, 5);

    let m = [1.3, 0.7, 2.1];
    let start = State::new([0.9, 0.1, -0.8, 0.3, 0.2, -1.1], [0.1, 0.4, 0.2, -0.3, -0.3, 0.1]);
    let masses = [m[0], m[0], m[1], m[1], m[2], m[2]];
    let law = Simulation::new(Three { g: 0.3, eps: 0.7, m }, start)
        .masses(masses)
        .scheme(Gauss::order16())
        .dt(0.05)
        .run(200)
        .unwrap();
    let bodies = (0..3).fold(Scene::new(), |scene, i| {
        scene.body(m[i], [start.q[2 * i], start.q[2 * i + 1]], [start.v[2 * i], start.v[2 * i + 1]])
    });
    let run =
        Simulation::scene(bodies.pairs(Soft { g: 0.3, eps: 0.7 })).scheme(Gauss::order16()).dt(0.05).run(200).unwrap();
    let miss = apart(&run.last().q, law.last().q.as_chunks::<2>().0);
    println!("three bodies: {miss:e}");
    assert!(miss < 1e-13, "{miss:e}");
    let (a, b) = (run.drift(Invariant::Energy).unwrap(), law.drift(Invariant::Energy).unwrap());
    assert!((a.start() - b.start()).abs() < 1e-14);
}

/// Forces of velocities that answer each other and that do not, a field with a force, a law that is there or not.
#[test]
fn forces_between_bodies() {
    /// As it moves against a part of the other's motion: what the other feels is not the opposite.
    #[derive(Clone, Copy, Debug)]
    struct Drag {
        c: f64,
        part: f64,
    }
    #[dmech::law]
    impl Drag {
        #[pair_force]
        fn drag(&self, d: [f64; 2], va: [f64; 2], vb: [f64; 2]) -> [f64; 2] {
            let k = self.c / (1.0 + d[0] * d[0] + d[1] * d[1]);
            [k * (self.part * vb[0] - va[0]) - self.part * d[0], k * (self.part * vb[1] - va[1])]
        }
    }
    /// The same, and gravity, as one law of two bodies.
    #[derive(Clone, Copy, Debug)]
    struct Both {
        c: f64,
        part: f64,
        k: f64,
    }
    #[dmech::law]
    impl Both {
        #[potential]
        fn energy(&self, q: [f64; 4]) -> f64 {
            let [x, y] = [q[0] - q[2], q[1] - q[3]];
            -self.k / (x * x + y * y + 0.49).sqrt()
        }
        #[force]
        fn drag(&self, q: [f64; 4], v: [f64; 4]) -> [f64; 4] {
            let [x, y] = [q[0] - q[2], q[1] - q[3]];
            let k = self.c / (1.0 + x * x + y * y);
            [
                k * (self.part * v[2] - v[0]) - self.part * x,
                k * (self.part * v[3] - v[1]),
                k * (self.part * v[0] - v[2]) + self.part * x,
                k * (self.part * v[1] - v[3]),
            ]
        }
    }
    let (m, g) = ([1.3, 0.7], 0.9);
    let start = State::new([0.9, 0.1, -0.8, 0.3], [0.1, 0.4, 0.2, -0.7]);
    let bodies = || Scene::new().body(m[0], [0.9, 0.1], [0.1, 0.4]).body(m[1], [-0.8, 0.3], [0.2, -0.7]);
    macro_rules! same {
        ($scheme:expr, $_:tt) => {
            for part in [1.0, 0.4] {
                let law = Both { c: 0.6, part, k: g * m[0] * m[1] };
                let law = Simulation::new(law, start).masses([m[0], m[0], m[1], m[1]]).scheme($scheme).dt(0.05);
                let law = *law.run(60).unwrap().last();
                let drag = Drag { c: 0.6, part };
                let by_pairs = bodies().pairs(Soft { g, eps: 0.7 }).pairs(Some(drag)).pairs(None::<Spring>);
                let by_bonds = bodies().chain(Soft { g, eps: 0.7 }).bonds(drag, [(1, 0)]);
                let by_pairs = Simulation::scene(by_pairs).scheme($scheme).dt(0.05).run(60).unwrap();
                let work = by_pairs.drift(Invariant::WorkEnergy).unwrap();
                assert!(work.max_abs() < 1e-14 && work.max_abs() > 0.0, "{work:?}");
                for end in [by_pairs.last().clone(), end!(by_bonds, $scheme, 0.05, 60)] {
                    let miss = apart(&end.q, law.q.as_chunks::<2>().0);
                    assert!(miss < 1e-13 && apart(&end.q, &[[0.9, 0.1], [-0.8, 0.3]]) > 0.3, "{miss:e}");
                }
            }
        };
    }
    same!(Gauss::order16(), 0);
    same!(LineIntegral::order6(), 0);
}

/// Test bodies feel and are not felt; a driven one is where its path is, at every stage.
#[test]
fn bodies_that_do_not_act_and_bodies_on_a_path() {
    let scene = || Scene::new().body(1.0, [0.0; 2], [0.0, -0.1]).body(0.3, [1.1, 0.2], [-0.1, 0.9]);
    let (q, v) = ([-0.9, 0.6], [-0.5, -0.7]);
    let alone = end!(scene().pairs(Gravity { g: 0.9 }), Gauss::order16(), 0.05, 200);
    let with = end!(scene().test_body(7.0, q, v).pairs(Gravity { g: 0.9 }), Gauss::order16(), 0.05, 200);
    let light = end!(scene().body(1e-25, q, v).pairs(Gravity { g: 0.9 }), Gauss::order16(), 0.05, 200);
    assert_eq!(alone.q, with.q[..2]);
    assert!(apart(&with.q, &light.q) < 1e-12, "{:e}", apart(&with.q, &light.q));

    // A sun on a straight line is a planet seen from a frame that moves.
    let drift = |t: f64| ([0.3 * t - 1.0, 0.5 - 0.2 * t], [0.3, -0.2]);
    let planet = Kepler { gm: 1.3 }.pericentre(0.9, 0.4);
    let moved =
        Scene::new().body(1.3, [9.0; 2], [0.0; 2]).body(0.4, [planet.q[0] - 1.0, 0.5], [0.3, planet.v[1] - 0.2]);
    let moved = end!(moved.drive(0, drift).pairs(Gravity { g: 1.0 }), Gauss::order16(), 0.05, 200);
    let rests = *Simulation::new(Kepler { gm: 1.3 }, planet).scheme(Gauss::order16()).dt(0.05).run(200).unwrap().last();
    let (sun, _) = drift(10.0);
    // A hand in honey feels how fast it is moved: the law that names the time.
    #[derive(Clone, Copy, Debug)]
    struct Honey {
        c: f64,
    }
    #[dmech::law]
    impl Honey {
        #[pair_force]
        fn drag(&self, va: [f64; 2], vb: [f64; 2]) -> [f64; 2] {
            [self.c * (vb[0] - va[0]), self.c * (vb[1] - va[1])]
        }
    }
    #[derive(Clone, Copy, Debug)]
    struct Stirred {
        c: f64,
        omega: f64,
    }
    #[dmech::law]
    impl Stirred {
        #[force]
        fn drag(&self, v: [f64; 2], t: f64) -> [f64; 2] {
            [self.c * (self.omega * (self.omega * t).cos() - v[0]), self.c * (-0.7 - v[1])]
        }
    }
    let spoon = |t: f64| ([(2.3 * t).sin(), -0.7 * t], [2.3 * (2.3 * t).cos(), -0.7]);
    let stirred = Simulation::new(Stirred { c: 0.9, omega: 2.3 }, State::new([0.4, 0.3], [0.1, 0.2])).mass(1.3);
    let stirred = *stirred.scheme(Gauss::order16()).dt(0.1).run(60).unwrap().last();
    let honey = Scene::new().body(5.0, [3.0; 2], [0.0; 2]).body(1.3, [0.4, 0.3], [0.1, 0.2]).drive(0, spoon);
    let honey = end!(honey.pairs(Honey { c: 0.9 }), Gauss::order16(), 0.1, 60);
    let miss = distance(honey.q[1], stirred.q).max(distance(honey.v[1], stirred.v));
    assert!(miss < 1e-13 && distance(stirred.v, [0.1, 0.2]) > 0.3, "{miss:e}");

    let miss = distance([0, 1].map(|k| moved.q[1][k] - sun[k]), rests.q);
    println!("driven: {miss:e}");
    assert!(miss < 1e-12 && moved.q[0] == sun, "{miss:e}");
}

/// A body without an edge.
#[derive(Clone, Copy, Debug)]
struct Blob {
    k: f64,
    end: f64,
}

#[dmech::law]
impl Blob {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        self.k * (1.0 - r * r / (self.end * self.end)).powi(12)
    }
}

/// A gas in a box, cut off where its law ends smoothly and where it does not.
#[test]
fn a_gas_in_a_box() {
    let law = Spring { k: 5.0, length: 1.5 };
    let gas = |gap: f64| {
        (0..25).fold(Scene::<2>::new(), |scene, i: u32| {
            let place = [i % 5, i / 5].map(|x| gap * f64::from(x) + 0.03 * f64::from(i * i % 7));
            scene.body(1.0 + 0.1 * f64::from(i % 3), place, [0.1 * f64::from(i % 3) - 0.1, 0.05 * f64::from(i % 4)])
        })
    };
    let soft = || gas(1.3).pairs(law).cutoff(1.5).periodic([6.5, 6.5]);
    let run = Simulation::scene(soft()).scheme(Gauss::order16()).dt(0.05).run(100).unwrap();
    let fine = Simulation::scene(soft()).scheme(Nystrom::order6()).dt(0.001).record_every(5000).run(5000).unwrap();
    let (miss, energy) = (apart(&run.last().q, &fine.last().q), run.drift(Invariant::Energy).unwrap().max_relative());
    println!("gas: {miss:e}, energy {energy:e}, rough {}", run.report().rough());
    // Pairs come and go, which costs order where it happens.
    assert!(miss < 1e-5 && energy < 1e-5, "{miss:e} {energy:e}");
    let linear = run.drift(Invariant::LinearMomentum).unwrap().max_abs();
    assert!(linear < 1e-13, "{linear:e}");

    // Of a law that ends as smoothly as a step is long nothing is seen.
    let blobs = || gas(1.3).pairs(Blob { k: 2.0, end: 2.6 }).cutoff(2.6).periodic([6.5, 6.5]);
    let run = Simulation::scene(blobs()).scheme(Gauss::order16()).dt(0.05).run(100).unwrap();
    let fine = Simulation::scene(blobs()).scheme(Nystrom::order8()).dt(0.005).record_every(1000).run(1000).unwrap();
    let (miss, energy) = (apart(&run.last().q, &fine.last().q), run.drift(Invariant::Energy).unwrap().max_relative());
    println!("blobs: {miss:e}, energy {energy:e}, rough {}", run.report().rough());
    assert!(miss < 1e-12 && energy < 1e-14 && run.report().rough() == 0, "{miss:e} {energy:e}");
    // The image next but one is not looked for.
    let told = Simulation::scene(gas(1.3).pairs(law).cutoff(3.3).periodic([6.5, 6.5])).scheme(Gauss::order16());
    let told = told.dt(0.05).run(1).unwrap_err().cause().to_string();
    assert!(told.contains("cut-off") && told.contains("3.3") && told.contains("6.5"), "{told}");

    // Too near and too fast: it ends, and says how.
    let atoms = LennardJones { epsilon: 0.9, sigma: 1.1 };
    for (gap, dt) in [(1e-3, 0.005), (0.5, 5.0), (1.3, 0.5), (1.3, 1e6)] {
        let outcome =
            Simulation::scene(gas(gap).pairs(atoms).cutoff(2.5).periodic([6.5, 6.5])).scheme(Gauss::order16());
        match outcome.dt(dt).run(2) {
            Ok(run) => assert_eq!(run.report().rough(), 2, "{gap} {dt}"),
            Err(told) => assert!(
                matches!(told.cause(), Error::NotConverged { .. } | Error::Link { .. } | Error::NotFinite { .. }),
                "{told}"
            ),
        }
    }
}

/// Of a chain, of bonds and of pairs of two bodies: one link, one motion.
#[test]
fn a_link_is_a_link() {
    let law = Spring { k: 7.0, length: 0.8 };
    let two = || Scene::new().body(1.3, [0.4, -0.1], [-0.3, 0.2]).body(0.6, [-0.5, 0.3], [0.1, 0.4]);
    macro_rules! same {
        ($scheme:expr, $_:tt) => {{
            let pairs = end!(two().pairs(law), $scheme, 0.05, 200);
            assert_eq!(pairs, end!(two().chain(law), $scheme, 0.05, 200));
            assert_eq!(pairs, end!(two().bonds(law, [(0, 1)]), $scheme, 0.05, 200));
            assert!(apart(&pairs.q, &end!(two().bonds(law, [(1, 0)]), $scheme, 0.05, 200).q) < 1e-13);
            assert_ne!(pairs, end!(two().bonds(law, [(0, 1)]).pairs(law), $scheme, 0.05, 200));
        }};
    }
    same!(Gauss::order16(), 0);
    same!(LineIntegral::order6(), 0);
}
