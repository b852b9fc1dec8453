//! The numbers of the papers.

use crate::common::{Kepler, SUN, SUN_BY_COMPONENTS, Spring, greenspan_orbit};
use dmech_core::prelude::*;

/// Greenspan's orbit at h = 0.1 (i, x, y, zx, zy), from an independent reproduction in extended precision.
const KANATANI: [(usize, [f64; 2], [f64; 2]); 5] = [
    (0, [0.5, 0.0], [0.2, 1.63]),
    (1, [0.4833687769190015, 0.163], [-0.16631223080998514, 1.63]),
    (2, [0.4330648713159316, 0.31464501078021145], [-0.5030390560306991, 1.5164501078021144]),
    (3, [0.3561359948594436, 0.44694554271654774], [-0.7692887645648799, 1.323005319363363]),
    (5, [0.1545846255448565, 0.6420546793707688], [-1.0626820075634342, 0.8584297687629246]),
];

/// The same for LaBudde–Greenspan (i, x, y, vx, vy).
const LABUDDE_GREENSPAN: [(usize, [f64; 2], [f64; 2]); 5] = [
    (0, [0.5, 0.0], [0.0, 1.63]),
    (1, [0.48077008744947625, 0.15986552425426462], [-0.3845982510104747, 1.5673104850852926]),
    (2, [0.4258191648251404, 0.3080844395451611], [-0.7144202014762435, 1.397067820732637]),
    (3, [0.3421683259317462, 0.4359629819445306], [-0.9585965763916405, 1.160503027254753]),
    (5, [0.12312027519534692, 0.6161068105381583], [-1.194258077167592, 0.6433502929648656]),
];

const DISCRETE_ENERGY: f64 = -0.6378967935762277;

fn close(x: [f64; 2], y: [f64; 2]) -> bool {
    (x[0] - y[0]).abs() < 1e-12 && (x[1] - y[1]).abs() < 1e-12
}

fn kanatani_rows<const ONE: bool>(law: Kepler<ONE>, scheme: Kanatani) {
    let mut stepper = Simulation::new(law, greenspan_orbit()).scheme(scheme).dt(0.1).stepper().unwrap();
    for (i, q, z) in KANATANI {
        while stepper.steps() < i as u64 {
            stepper.step().unwrap();
        }
        assert!(close(stepper.q(), q), "row {i}: {:?}", stepper.q());
        assert!(close(stepper.memory().z(), z), "row {i}: z = {:?}", stepper.memory().z());
    }
    let run = Simulation::new(law, greenspan_orbit()).scheme(scheme).dt(0.1).run(5).unwrap();
    let energy = run.drift(Invariant::DiscreteEnergy).unwrap();
    assert!((energy.start() - DISCRETE_ENERGY).abs() < 1e-14 && energy.max_abs() < 1e-15, "{energy:?}");
}

#[test]
fn kanatani_rows_are_those_of_the_reference() {
    kanatani_rows(SUN, Kanatani);
    kanatani_rows(SUN_BY_COMPONENTS, Kanatani);
    kanatani_rows(SUN, Kanatani.with(Newton::from_previous()));
    kanatani_rows(SUN_BY_COMPONENTS, Kanatani.with(Newton::from_previous()));
}

#[test]
fn labudde_greenspan_rows_are_those_of_the_reference() {
    fn check<const ONE: bool>(law: Kepler<ONE>, scheme: DiscreteGradient) {
        let run = Simulation::new(law, greenspan_orbit()).scheme(scheme).dt(0.1).run(5).unwrap();
        for (i, q, v) in LABUDDE_GREENSPAN {
            assert!(close(run.states()[i].q, q) && close(run.states()[i].v, v), "row {i}: {:?}", run.states()[i]);
        }
    }
    check(SUN, DiscreteGradient);
    check(SUN_BY_COMPONENTS, DiscreteGradient);
    check(SUN, DiscreteGradient.with(Newton::from_previous()));
    check(SUN_BY_COMPONENTS, DiscreteGradient.with(Newton::from_previous()));
}

/// For Φ = k r²/2 the general step is Kanatani's explicit form (3.20)–(3.21), and needs no iteration.
#[test]
fn a_spring_steps_by_the_explicit_form_3_20() {
    let (k, m, h) = (3.7, 1.3, 0.2);
    let start = State::new([0.8, -0.3], [0.4, 1.1]);
    let mut stepper = Simulation::new(Spring { k }, start).mass(m).scheme(Kanatani).dt(h).stepper().unwrap();
    for _ in 0..20 {
        let (q, q_before, z) = (stepper.q(), stepper.memory().q_before(), stepper.memory().z());
        stepper.step().unwrap();
        let c = k * h * h / (2.0 * m);
        for i in 0..2 {
            let q_next = (q[i] - c * q_before[i] + h * z[i]) / (1.0 + c);
            let z_next = (z[i] - c / h * (q[i] + q_before[i])) / (1.0 + c);
            assert!((stepper.q()[i] - q_next).abs() < 4e-16 * 4.0, "{} {q_next}", stepper.q()[i]);
            assert!((stepper.memory().z()[i] - z_next).abs() < 4e-16 * 8.0, "{} {z_next}", stepper.memory().z()[i]);
        }
    }
    assert_eq!((stepper.evaluations(), stepper.iterations()), (20, 0));
}

/// Greenspan's Table 1 by orbits: the number of times the planet crosses the positive x-axis upward until t = 350, and
/// the energy it has then. The explicit planet spirals out even at dt = 0.001, which the paper's 85+ denies.
#[test]
fn orbits_are_counted_as_in_greenspans_table_1() {
    fn orbits<S: Scheme<Particle<Kepler<true>, 2>>>(scheme: S, dt: f64) -> usize {
        let run = Simulation::new(SUN, greenspan_orbit()).scheme(scheme).dt(dt).run_until(350.0).unwrap();
        run.states().windows(2).filter(|w| w[0].q[1] < 0.0 && w[1].q[1] >= 0.0).count()
    }
    let counted = [
        (orbits(Explicit, 0.1), 2),
        (orbits(Implicit, 0.1), 81),
        (orbits(Leapfrog, 0.1), 83),
        (orbits(Explicit, 0.01), 19),
        (orbits(Implicit, 0.01), 86),
        (orbits(Leapfrog, 0.01), 86),
        (orbits(Explicit, 0.001), 53),
        (orbits(Implicit, 0.001), 86),
        (orbits(Leapfrog, 0.001), 86),
    ];
    for (counted, expected) in counted {
        assert_eq!(counted, expected);
    }
}
