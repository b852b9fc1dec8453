//! Energies: exact for polynomials, of degree ν at order 2s as far as ν s ≤ 16, and not beyond.

use dmech::Kept;
use dmech::models::pairs::{FermiPastaUlamTsingou, Spring};
use dmech::models::{HenonHeiles, Kepler};
use dmech::prelude::*;

use crate::laws::*;

const START: State<2> = State { t: 0.0, q: [0.4, -0.3], v: [0.35, 0.45] };

/// The largest relative change of the energy.
fn energy<L: Law<2> + Copy + std::fmt::Debug, S: Scheme<Particle<L, 2>>>(law: L, scheme: S, dt: f64) -> (Kept, f64) {
    let run = Simulation::new(law, START).mass(1.3).scheme(scheme).dt(dt).run_until(400.0);
    let run = run.unwrap_or_else(|interrupted| panic!("{interrupted}"));
    assert_eq!(run.report().kept(Invariant::Energy), run.kept(Invariant::Energy));
    assert!(run.report().rough() == 0 || dt > 0.5, "{law:?}: too long a step");
    (run.kept(Invariant::Energy), run.drift(Invariant::Energy).expect("conservative").max_relative())
}

#[test]
fn degrees_decide() {
    let (mut exact, mut bounded) = (0, 0);
    macro_rules! one {
        ($scheme:expr, $s:literal, $degree:literal, $law:expr) => {{
            let (kept, short) = energy($law, $scheme, 0.1);
            let (_, long) = energy($law, $scheme, 0.8);
            println!("degree {}, order {}: {kept:?}, {long:.1e} and {short:.1e}", $degree, 2 * $s);
            if $degree * $s <= 16 {
                assert_eq!(kept, Kept::Exact, "degree {}, s = {}", $degree, $s);
                assert!(long < 1e-14 && short < 1e-14, "degree {}, s = {}: {long:e}, {short:e}", $degree, $s);
                exact += 1;
            } else {
                assert_eq!(kept, Kept::Bounded, "degree {}, s = {}", $degree, $s);
                // Of the order of the quadrature, whatever that of the motion.
                assert!(long > 1e-14 && short < 1e-13, "degree {}, s = {}: {long:e}, {short:e}", $degree, $s);
                bounded += 1;
            }
        }};
    }
    macro_rules! law {
        ($degree:literal, $law:expr) => {
            one!(LineIntegral::order4(), 2, $degree, $law);
            one!(LineIntegral::order6(), 3, $degree, $law);
            one!(LineIntegral::order8(), 4, $degree, $law);
            one!(LineIntegral::order10(), 5, $degree, $law);
        };
    }
    law!(3, Cubic { k: 0.4 });
    law!(4, Quartic { k: 0.9 });
    law!(5, Quintic { k: 0.8 });
    law!(6, Sextic { k: 2.3 });
    law!(8, Octic { k: 7.1 });
    law!(9, Ninth { k: 3.7 });
    assert_eq!((exact, bounded), (11, 13));
}

/// Of other laws, of a choice and of Gauss's method nothing is said but that it stays near.
#[test]
fn nothing_more_is_said() {
    let planet = State::new([0.8, 0.1], [0.2, 1.1]);
    macro_rules! one {
        ($scheme:expr, $_:tt) => {{
            let run = Simulation::new(Kepler { gm: 1.3 }, planet).scheme($scheme).dt(0.05).run(4000).unwrap();
            let energy = run.drift(Invariant::Energy).unwrap();
            assert_eq!(run.kept(Invariant::Energy), Kept::Bounded);
            dmech_tests::motion::does_not_drift(&run, Invariant::Energy, run.report().scheme());
            assert!(energy.max_relative() < 1e-9, "{:e}", energy.max_relative());
        }};
    }
    for_each_order!(one! { 0 });
    let run = Simulation::new(Cubic { k: 0.4 }, START).scheme(Gauss::order16()).dt(0.1).run(10).unwrap();
    assert_eq!(run.kept(Invariant::Energy), Kept::Bounded);
    // Adaptive steps keep it too; of a scene the terms decide together.
    let run =
        Simulation::new(Cubic { k: 0.4 }, START).scheme(LineIntegral::order10()).adaptive(1e-7).run(2000).unwrap();
    assert_eq!(run.kept(Invariant::Energy), Kept::Exact);
    let energy = run.drift(Invariant::Energy).unwrap().max_relative();
    assert!(energy < 1e-13, "{energy:e}");
    let kept = |run: Run<SceneState<2>>| {
        (run.kept(Invariant::Energy), run.drift(Invariant::Energy).map(|d| d.max_abs() < 1e-14))
    };
    let bodies = || Scene::new().body(1.3, START.q, START.v).body(0.7, [1.1, 0.4], [0.0, -0.2]);
    let rod = Spring { k: 2.0, length: 0.7 };
    let line = LineIntegral::order8();
    let polynomial = Simulation::scene(bodies().field(Quartic { k: 0.4 }).field(Cubic { k: 0.3 })).scheme(line);
    assert_eq!(kept(polynomial.dt(0.2).run(500).unwrap()), (Kept::Exact, Some(true)));
    let of_distance = Simulation::scene(bodies().field(Quartic { k: 0.4 }).pairs(rod)).scheme(line);
    // Steps that are too long for how near the bodies come, and shorter ones.
    let rough = of_distance.clone().dt(0.2).run(500).unwrap();
    assert!(rough.report().rough() > 0);
    assert_eq!(kept(rough), (Kept::BetweenSeams, Some(false)));
    let smooth = of_distance.dt(0.02).run(500).unwrap();
    assert_eq!((smooth.report().rough(), smooth.kept(Invariant::Energy)), (0, Kept::Bounded));
    // The nearest image is a choice.
    let weak = FermiPastaUlamTsingou { k: 1.1, alpha: 0.3, beta: 0.2 };
    let ring = || (0..4).fold(Scene::new(), |scene, i| scene.body(1.3, [1.3 * f64::from(i)], [0.3 * f64::from(i * i)]));
    let in_box = Simulation::scene(ring().periodic([4.9]).chain(weak)).scheme(line).dt(0.1).run(100).unwrap();
    assert_eq!(in_box.kept(Invariant::Energy), Kept::BetweenSeams);
    let open = Simulation::scene(ring().chain(weak)).scheme(line).dt(0.1).run(100).unwrap();
    assert_eq!(open.kept(Invariant::Energy), Kept::Exact);
}

/// A chain whose springs are quartic, over a million steps.
#[test]
fn a_quartic_chain_keeps_its_energy() {
    let law = FermiPastaUlamTsingou { k: 1.2, alpha: 0.4, beta: 0.7 };
    let beads = (0..9).fold(Scene::new(), |scene, i: u32| {
        let at = if i.is_multiple_of(8) { 0.0 } else { 0.8 * (0.9 * f64::from(i)).sin() };
        scene.body(0.9 + 0.1 * f64::from(i % 3), [at], [0.0])
    });
    let scene = beads.pin(0).pin(8).chain(law);
    macro_rules! kept {
        ($($scheme:expr),*) => {$({
            let simulation = Simulation::scene(scene.clone()).scheme($scheme).dt(0.1).record_every(100_000);
            let run = simulation.run(1_000_000).unwrap();
            let energy = run.drift(Invariant::Energy).unwrap();
            println!("{}: {:e}", run.report().scheme(), energy.max_relative());
            assert_eq!(run.kept(Invariant::Energy), Kept::Exact);
            assert!(energy.max_relative() < 1e-13 && energy.start() > 0.1, "{energy:?}");
        })*};
    }
    kept!(LineIntegral::order4(), LineIntegral::order6(), LineIntegral::order8());
}

/// Chaos at order ten, in steps of a twentieth of a period and of a fifth.
#[test]
fn a_cubic_law_at_order_ten() {
    for dt in [0.3, 1.2] {
        let simulation = Simulation::new(HenonHeiles { lambda: 0.9 }, State::new([0.05, 0.1], [0.48, 0.08])).mass(1.1);
        let run = simulation.scheme(LineIntegral::order10()).dt(dt).run(20_000).unwrap();
        let energy = run.drift(Invariant::Energy).unwrap().max_relative();
        println!("dt = {dt}: {energy:e}");
        assert!(energy < 3e-13 && energy > 0.0, "dt = {dt}: {energy:e}");
        assert_eq!(run.report().rough(), 0);
    }
}
