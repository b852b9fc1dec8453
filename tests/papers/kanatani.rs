//! The statements of K. Kanatani, "The Accuracy and the Preservation Property of the Discrete Mechanics", J. Comput.
//! Phys. (1983–84), measured.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use dmech::extend::{Field, Stride};
use dmech::models::Kepler;
use dmech::prelude::*;
use dmech::scheme::KanataniMemory;

/// (3.16).
#[derive(Clone, Copy, Debug)]
struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        0.5 * self.k * (x * x + y * y)
    }
}

/// (3.23); its k is called gm.
const SUN: Kepler = Kepler { gm: 1.0 };
const PLANET: State<2> = State::new([0.5, 0.0], [0.0, 1.63]);

/// Greenspan's orbit at h = 0.1: i, (x, y), (zx, zy). An independent reproduction in extended precision.
const KANATANI: [(u64, [f64; 2], [f64; 2]); 5] = [
    (0, [0.5, 0.0], [0.2, 1.63]),
    (1, [0.4833687769190015, 0.163], [-0.16631223080998514, 1.63]),
    (2, [0.4330648713159316, 0.31464501078021145], [-0.5030390560306991, 1.5164501078021144]),
    (3, [0.3561359948594436, 0.44694554271654774], [-0.7692887645648799, 1.323005319363363]),
    (5, [0.1545846255448565, 0.6420546793707688], [-1.0626820075634342, 0.8584297687629246]),
];
const DISCRETE_ENERGY: f64 = -0.6378967935762277;

/// The same for LaBudde–Greenspan: i, (x, y), (vx, vy).
const LABUDDE_GREENSPAN: [(u64, [f64; 2], [f64; 2]); 5] = [
    (0, [0.5, 0.0], [0.0, 1.63]),
    (1, [0.48077008744947625, 0.15986552425426462], [-0.3845982510104747, 1.5673104850852926]),
    (2, [0.4258191648251404, 0.3080844395451611], [-0.7144202014762435, 1.397067820732637]),
    (3, [0.3421683259317462, 0.4359629819445306], [-0.9585965763916405, 1.160503027254753]),
    (5, [0.12312027519534692, 0.6161068105381583], [-1.194258077167592, 0.6433502929648656]),
];

fn distance([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    (ax - bx).hypot(ay - by)
}

#[test]
fn both_energy_exact_schemes_give_the_rows_of_the_reproduction() {
    let mut stepper = Simulation::new(SUN, PLANET).scheme(Kanatani).dt(0.1).stepper().unwrap();
    for (i, q, z) in KANATANI {
        while stepper.steps() < i {
            stepper.step().unwrap();
        }
        let memory = stepper.memory();
        assert!(distance(memory.q(), q) < 1e-12 && distance(memory.z(), z) < 1e-12, "row {i}: {memory:?}");
        let energy = energy_3_28(memory, 2.0);
        assert!(abs_diff_eq!(energy, DISCRETE_ENERGY, epsilon = 1e-14), "row {i}: {energy}");
    }
    let run = Simulation::new(SUN, PLANET).scheme(DiscreteGradient).dt(0.1).run(5).unwrap();
    for (i, q, v) in LABUDDE_GREENSPAN {
        let state = run.states()[i as usize];
        assert!(distance(state.q, q) < 1e-12 && distance(state.v, v) < 1e-12, "row {i}: {state:?}");
    }
}

/// Where the planet is at time t: (a (cos E − e), b sin E) with E − e sin E = n t.
fn exact(t: f64) -> [f64; 2] {
    let a: f64 = 1.0 / (2.0 / 0.5 - 1.63 * 1.63);
    let e = 1.0 - 0.5 / a;
    let mean_anomaly = t / (a * a.sqrt());
    let mut anomaly = mean_anomaly;
    for _ in 0..50 {
        anomaly -= (anomaly - e * anomaly.sin() - mean_anomaly) / (1.0 - e * anomaly.cos());
    }
    [a * (anomaly.cos() - e), a * (1.0 - e * e).sqrt() * anomaly.sin()]
}

/// r̈.
fn acceleration(r: [f64; 2]) -> [f64; 2] {
    SUN.gradient(r).map(|g| -g)
}

/// The slope of log error against log h, by least squares over h = 1/50 … 1/400.
fn order(error: impl Fn(f64) -> f64) -> f64 {
    let points: Vec<(f64, f64)> =
        [50.0, 100.0, 200.0, 400.0_f64].iter().map(|n| (-n.ln(), error(1.0 / n).ln())).collect();
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / points.len() as f64;
    let (mx, my) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum();
    covariance / points.iter().map(|p| (p.0 - mx) * (p.0 - mx)).sum::<f64>()
}

/// r₊ = A r + B z h + a r̈ h², z₊ h = C r + D z h + b r̈ h² (2.3)–(2.4), with z an auxiliary variable.
#[derive(Clone, Copy, Debug)]
#[expect(non_snake_case, reason = "the letters of the paper")]
struct TwoTerm {
    A: f64,
    B: f64,
    C: f64,
    D: f64,
    a: f64,
    b: f64,
}

impl TwoTerm {
    /// The error of the third position when the first two are exact; z follows from them by (2.8).
    fn local_error(&self, h: f64) -> f64 {
        let TwoTerm { A, B, C, D, a, b } = *self;
        let [r0, r1, r2] = [1.0, 1.0 + h, 1.0 + 2.0 * h].map(exact);
        let [f0, f1] = [r0, r1].map(|r| acceleration(r).map(|x| h * h * x));
        let third = [0, 1].map(|i| {
            let z0 = (r1[i] - A * r0[i] - a * f0[i]) / B;
            let z1 = C * r0[i] + D * z0 + b * f0[i];
            A * r1[i] + B * z1 + a * f1[i]
        });
        distance(third, r2)
    }
}

/// §2: third order for LaBudde and Greenspan's (2.7), fourth exactly when A + D = 2, AD − BC = 1, a = 1, b = D/B (2.10).
/// Each of the four conditions is broken in turn, alone or with what keeps the lower orders.
#[test]
fn the_local_error_is_of_fourth_order_exactly_under_2_10() {
    #[expect(non_snake_case, reason = "the letters of the paper")]
    let scheme = |A, B, C, D, a, b| TwoTerm { A, B, C, D, a, b };
    let table = [
        // (2.10) holds.
        (4.0, scheme(1.0, 1.0, 0.0, 1.0, 1.0, 1.0)), // (2.11)–(2.12)
        (4.0, scheme(1.0, 2.0, 0.0, 1.0, 1.0, 0.5)),
        (4.0, scheme(0.5, 1.0, -0.25, 1.5, 1.0, 1.5)),
        (4.0, scheme(3.0, -2.0, 2.0, -1.0, 1.0, 0.5)),
        // a = 1 broken, the sum of the coefficients of r̈ kept: bB − aD = 1 − a.
        (3.0, scheme(1.0, 1.0, 0.0, 1.0, 0.5, 1.0)), // (2.7)
        (3.0, scheme(1.0, 1.0, 0.0, 1.0, 0.97, 1.0)),
        (3.0, scheme(0.5, 1.0, -0.25, 1.5, 1.2, 1.6)),
        // b = D/B broken; a = 1 broken alone.
        (2.0, scheme(1.0, 1.0, 0.0, 1.0, 1.0, 1.3)),
        (2.0, scheme(3.0, -2.0, 2.0, -1.0, 1.0, 0.6)),
        (2.0, scheme(0.5, 1.0, -0.25, 1.5, 1.2, 1.5)),
        // A + D = 2 broken with AD − BC = A + D − 1, and without.
        (1.0, scheme(1.0, 1.0, 0.0, 1.4, 1.0, 1.4)),
        (0.0, scheme(1.2, 1.0, 0.2, 1.0, 1.0, 1.0)),
        // AD − BC = 1 broken.
        (0.0, scheme(1.0, 1.0, 0.3, 1.0, 1.0, 1.0)),
    ];
    for (expected, scheme) in table {
        let measured = order(|h| scheme.local_error(h));
        println!("{measured:.3} {scheme:?}");
        assert!(
            abs_diff_eq!(measured, expected, epsilon = 0.05),
            "{scheme:?} has local order {measured}, not {expected}"
        );
    }
}

/// The same for the steps of the crate, each from two exact positions. The paper expects O(h³) of the conservative force
/// (3.25); it is O(h⁴), because ∇̄Φ(r₋, r₊) is symmetric and so differs from ∇Φ(r) by O(h²) only.
#[test]
fn leapfrog_and_the_conservative_force_have_local_order_four() {
    let from_two = |h: f64| (Stride::new(h, 1.0), exact(1.0 - h), exact(1.0), exact(1.0 + h));
    let conservative = order(|h| {
        let (stride, before, now, after) = from_two(h);
        let mut memory = Memory::from_positions(&stride, before, now, &SUN.gradient(now));
        Kanatani.step(&Particle::new(SUN, 1.0), &stride, 1.0, &mut memory, &mut ()).unwrap();
        distance(memory.q(), after)
    });
    let leapfrog = order(|h| {
        let (_, before, now, after) = from_two(h);
        // Half a kick before this velocity is (now − before)/h.
        let v = SUN.field(1.0, 0.0).kick(0.5 * h, now, [0, 1].map(|i| (now[i] - before[i]) / h));
        let run = Simulation::new(SUN, State::new(now, v)).scheme(Leapfrog).dt(h).run(1).unwrap();
        distance(run.last().q, after)
    });
    assert_abs_diff_eq!(conservative, 4.0, epsilon = 0.05);
    assert_abs_diff_eq!(leapfrog, 4.0, epsilon = 0.05);
}

/// z₀ = v₀ − h a₀/2 follows from (3.1); with the printed + the error at a fixed time is of first order.
#[test]
fn the_printed_sign_of_the_start_costs_an_order() {
    let error = |sign: f64, h: f64| {
        let (stride, a) = (Stride::new(h, 1.0), acceleration(PLANET.q));
        let before = [0, 1].map(|i| PLANET.q[i] - h * (PLANET.v[i] + sign * 0.5 * h * a[i]));
        let mut memory = Memory::from_positions(&stride, before, PLANET.q, &SUN.gradient(PLANET.q));
        let steps = (1.0 / h).round() as u32;
        for k in 0..steps {
            Kanatani.step(&Particle::new(SUN, 1.0), &stride, f64::from(k) * h, &mut memory, &mut ()).unwrap();
        }
        distance(memory.q(), exact(1.0))
    };
    let (printed, corrected) = (order(|h| error(1.0, h)), order(|h| error(-1.0, h)));
    assert_abs_diff_eq!(printed, 1.0, epsilon = 0.05);
    assert_abs_diff_eq!(corrected, 2.0, epsilon = 0.05);
    let run = Simulation::new(SUN, PLANET).scheme(Kanatani).dt(0.01).run(100).unwrap();
    assert_abs_diff_eq!(distance(run.last().q, exact(1.0)) / error(-1.0, 0.01), 1.0, epsilon = 1e-9);
}

/// Example 1: the generated step is (3.20)–(3.21), without iteration, and keeps (3.22); the formulas as printed let their
/// rounding add up.
#[test]
fn the_oscillator_steps_by_3_20_and_keeps_3_22() {
    let (k, m, h) = (3.7, 1.3, 0.01);
    let start = State::new([0.8, -0.3], [0.4, 1.1]);
    let spring = Spring { k };
    let kept = |[zx, zy]: [f64; 2], r, r_before| {
        0.5 * m * (zx * zx + zy * zy) + 0.5 * (spring.energy(r) + spring.energy(r_before))
    };
    let c = k * h * h / (2.0 * m);
    let next = |r_before: [f64; 2], r: [f64; 2], z: [f64; 2]| {
        let r_next = [0, 1].map(|i| (r[i] - c * r_before[i] + h * z[i]) / (1.0 + c));
        let z_next = [0, 1].map(|i| (z[i] - c / h * (r[i] + r_before[i])) / (1.0 + c));
        (r, r_next, z_next)
    };
    let mut stepper = Simulation::new(spring, start).mass(m).scheme(Kanatani).dt(h).stepper().unwrap();
    let memory = *stepper.memory();
    let mut printed = (memory.q_before(), memory.q(), memory.z());
    let start = kept(printed.2, printed.1, printed.0);
    let (mut generated_change, mut printed_change) = (0.0_f64, 0.0_f64);
    for _ in 0..1_000_000 {
        let memory = *stepper.memory();
        let (_, r, z) = next(memory.q_before(), memory.q(), memory.z());
        stepper.step().unwrap();
        let memory = *stepper.memory();
        // A few roundings of numbers near 1.
        assert!(distance(memory.q(), r) < 8.0 * f64::EPSILON && distance(memory.z(), z) < 8.0 * f64::EPSILON);
        generated_change = generated_change.max((kept(memory.z(), memory.q(), memory.q_before()) / start - 1.0).abs());
        printed = next(printed.0, printed.1, printed.2);
        printed_change = printed_change.max((kept(printed.2, printed.1, printed.0) / start - 1.0).abs());
    }
    assert!(generated_change < 1e-13, "{generated_change}");
    assert!(printed_change > 1e-12, "{printed_change}");
    assert_eq!(stepper.iterations(), 0);
}

type Memory = KanataniMemory<Particle<Kepler, 2>>;

/// Example 2, (3.28): m z²/2 − k (1/|r| + 1/|r₋|)/divisor, m = k = 1.
fn energy_3_28(memory: &Memory, divisor: f64) -> f64 {
    let [x, y] = memory.z();
    0.5 * (x * x + y * y) + (SUN.energy(memory.q()) + SUN.energy(memory.q_before())) / divisor
}

#[test]
fn the_energy_3_28_is_kept_with_a_half_and_not_with_the_printed_quarter() {
    let mut stepper = Simulation::new(SUN, PLANET).scheme(Kanatani).dt(0.02).stepper().unwrap();
    let start = [2.0, 4.0].map(|divisor| energy_3_28(stepper.memory(), divisor));
    let mut largest = [0.0_f64; 2];
    for _ in 0..100_000 {
        stepper.step().unwrap();
        let now = [2.0, 4.0].map(|divisor| energy_3_28(stepper.memory(), divisor));
        largest = [0, 1].map(|i| largest[i].max((now[i] / start[i] - 1.0).abs()));
    }
    assert!(largest[0] < 1e-13, "{largest:?}");
    assert!(largest[1] > 1.0, "{largest:?}");
}
