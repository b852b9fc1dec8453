//! Stiff directions beside soft ones, none along an axis, in steps of up to 10⁵ radians: no step is refused, and a few corrections
//! solve each.

use dmech::extend::Real;
use dmech::prelude::*;

law!(Sheet, 3, |self, q| {
    let across = q[0] + 0.5 * q[1] - 0.3 * q[2];
    0.5 * self.k * across * across + 0.25 * (q[0].powi(4) + q[1].powi(4) + q[2].powi(4)) + q[0] * q[1] * q[2]
});
law!(
    DampedSheet,
    3,
    |self, q| {
        let across = q[0] + 0.5 * q[1] - 0.3 * q[2];
        0.5 * self.k * across * across + 0.25 * (q[0].powi(4) + q[1].powi(4) + q[2].powi(4)) + q[0] * q[1] * q[2]
    },
    |v| {
        let speed = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
        [-1e-3 * speed * v[0], -1e-3 * speed * v[1], -1e-3 * speed * v[2]]
    }
);
law!(Band, 2, |self, q| {
    let across = 0.8 * q[0] - 0.6 * q[1];
    0.5 * self.k * across * across + 0.7 * q[0] * q[0] + 0.25 * q[1].powi(4)
});

const STEPS: u64 = 2000;

/// How far from the soft surface it starts: on it, near it, and so far that it is thrown through the stiff direction at 10⁵.
const OFF: [f64; 3] = [0.0, 1e-3, 0.155];

fn sheet<R: Real>(off: f64) -> State<3, R> {
    State::of([0.1, 0.2, (0.2 - off) / 0.3].map(R::from_f64), [0.3, -0.1, 0.25 / 0.3].map(R::from_f64))
}

fn band<R: Real>(off: f64) -> State<2, R> {
    State::of([0.3, 0.4 - off].map(R::from_f64), [0.6, 0.8].map(R::from_f64))
}

#[test]
fn a_stiff_direction_costs_few_corrections() {
    let mut worst: f64 = 0.0;
    let mut tried = 0;
    macro_rules! swift {
        ($place:expr, $run:expr) => {{
            let run = $run.run(STEPS).unwrap_or_else(|lost| panic!("{}: {lost}", $place));
            let each = run.report().iterations() as f64 / STEPS as f64;
            assert!(each <= 8.0, "{}: {each} corrections a step", $place);
            worst = worst.max(each);
            tried += 1;
            run
        }};
    }
    macro_rules! all {
        ($k:expr, $off:expr, $R:ty, $($law:ident from $start:ident),*) => {$({
            let (law, start) = ($law { k: $k }, $start::<$R>($off));
            let place = |scheme: &str| format!("{} {:e} {} {} {scheme}", stringify!($law), $k, $off, stringify!($R));
            swift!(place("Implicit"), Simulation::new(law, start).scheme(Implicit).dt(0.1));
            swift!(place("DiscreteGradient"), Simulation::new(law, start).scheme(DiscreteGradient).dt(0.1));
        })*};
    }
    for off in OFF {
        for k in [1e2, 1e4, 1e6, 1e8, 1e10, 1e12] {
            all!(k, off, f64, Sheet from sheet, DampedSheet from sheet, Band from band);
            let energy = |run: &Run<State<3>>| run.drift(Invariant::Energy).unwrap().max_relative();
            let run = Simulation::new(Sheet { k }, sheet(off)).scheme(DiscreteGradient).dt(0.1).run(STEPS).unwrap();
            // Positions are known to rounding, and forces to k times that.
            let bound = 1e-13 + 0.1 * f64::EPSILON * k;
            assert!(energy(&run) < bound, "{k:e} {off}: energy off by {:e}", energy(&run));
            let State { q, v, .. } = sheet(off);
            let scene = || Simulation::scene(Scene::new().body(1.0, q, v).field(Sheet { k })).dt(0.1);
            swift!(format!("scene {k:e} {off} Implicit"), scene().scheme(Implicit));
            swift!(format!("scene {k:e} {off} DiscreteGradient"), scene().scheme(DiscreteGradient));
        }
        for k in [1e2, 1e4, 1e6] {
            all!(k, off, f32, Sheet from sheet, DampedSheet from sheet, Band from band);
        }
    }
    println!("at most {worst} corrections a step over {tried} runs");
    assert_eq!(tried, 3 * (6 * 8 + 3 * 6));
}

/// So stiff that the rounding of the force is more than all that moves: such a step is refused, not taken with what rounding left.
#[test]
fn what_rounding_leaves_of_a_stiff_force_is_no_step() {
    law!(Corner, 2, |self, q| {
        let [one, other] = [q[0] - q[1], q[0] + 0.5 * q[1]];
        0.5 * self.k * (one * one + other * other) + 0.25 * (q[0].powi(4) + q[1].powi(4))
    });
    let mut counts = [0; 2];
    for power in 4..=30 {
        let start = State::new([1e-3, 1e-3], [0.3, 0.4]);
        let run = Simulation::new(Corner { k: 10f64.powi(power) }, start).scheme(Implicit).dt(1.0).run(1);
        counts[usize::from(run.is_ok())] += 1;
        if let Ok(run) = run {
            let off = run.drift(Invariant::Energy).unwrap().max_relative();
            assert!(off < 1.0, "k = 1e{power}: energy off by {off:e}");
        }
    }
    println!("{counts:?} refused and taken");
    assert!(counts[0] > 10 && counts[1] > 10);
}

/// A force that is linear in v and speeds up: `Boris` asks nobody whether a pivot of its matrix is near 0, and needs not.
#[test]
fn a_kick_at_the_mean_velocity_has_no_pivots() {
    law!(Driven, 2, |self, q| 0.0 * self.k * q[0], |v| [2.0 * self.k * v[0] + v[1], v[0] - 0.5 * v[1]]);
    for d in [0.0, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4] {
        let (k, v) = (1.0 + d, [0.3, 0.7]);
        let run = Simulation::new(Driven { k }, State::new([0.0, 0.0], v)).scheme(Boris).dt(1.0).run(1).unwrap();
        // (1 − S/2) v′ = (1 + S/2) v.
        let [a, b, c] = [1.0 - k, -0.5, 1.25];
        let r = [(1.0 + k) * v[0] + 0.5 * v[1], 0.5 * v[0] + 0.75 * v[1]];
        let determinant = a * c - b * b;
        let exact = [(c * r[0] - b * r[1]) / determinant, (a * r[1] - b * r[0]) / determinant];
        for (found, exact) in run.last().v.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-14 * exact.abs(), "{d:e}: {found} for {exact}");
        }
    }
}

/// Two bodies on a stiff spring that are let go: of the first step nothing is known but what the force drives, which is (ωh)²/2 times as far
/// as they get. Alone and in a scene, stretched by so little or so much.
#[test]
fn a_stiff_spring_may_be_let_go() {
    law!(Bond, 2, |self, q| 0.5 * self.k * (q[0] - q[1]).powi(2) + 0.25 * q[1].powi(4));
    law!(Floor, 1, |self, q| 0.25 * self.k * q[0].powi(4));
    let (dt, mut tried) = (0.05, 0);
    for stretch in [0.5, 0.02, 1e-3, 1e-4, 1e-6] {
        for angle in [1e2, 1e3, 1e4, 3e4, 1e5_f64] {
            let k = (angle / dt).powi(2) / 2.0;
            for creeps in [0.0, 1e-9] {
                let law = Simulation::new(Bond { k }, State::new([0.5 + stretch, 0.5], [creeps, 0.0]));
                let run = law.scheme(DiscreteGradient).dt(dt).run(200);
                let run = run.unwrap_or_else(|lost| panic!("{stretch:e} at {angle:e}: {lost}"));
                let scene = Scene::new().body(1.0, [0.5 + stretch], [creeps]).body(1.0, [0.5], [0.0]);
                let scene = Simulation::scene(scene.chain(Rope { k }).field(Floor { k: 1.0 }));
                let beside = scene.scheme(DiscreteGradient).dt(dt).run(200).unwrap();
                for (off, each) in [
                    (run.drift(Invariant::Energy).unwrap().max_relative(), run.report().iterations()),
                    (beside.drift(Invariant::Energy).unwrap().max_relative(), beside.report().iterations()),
                ] {
                    // The stretch is known to the rounding of positions.
                    let bound = 1e-11 + 1e-14 * angle + 100.0 * f64::EPSILON / stretch;
                    assert!(off < bound, "{stretch:e} at {angle:e}: energy off by {off:e}");
                    assert!(each <= 200 * 8, "{stretch:e} at {angle:e}: {each} corrections");
                }
                tried += 1;
            }
        }
    }
    assert_eq!(tried, 50);
}

/// Of a pendulum that is thrown far by the force at the start of a step, the matrix is definite there and at a root two wells on; the root
/// of a shorter step lies before that.
#[test]
fn what_the_force_throws_far_stays_in_its_well() {
    law!(Swing, 1, |self, q| -self.k * q[0].cos());
    let ([q, v], law, dt) =
        ([4.933402859414629, 3.213160476444008], Swing { k: 43.753666224659156 }, 1.4864327607027454);
    let alone = Simulation::new(law, State::new([q], [v])).scheme(DiscreteGradient).dt(dt).run(1).unwrap();
    let scene = Simulation::scene(Scene::new().body(1.3, [q], [v]).field(Swing { k: 1.3 * law.k }));
    let scene = scene.scheme(DiscreteGradient).dt(dt).run(1).unwrap();
    let ends = [alone.last().q[0], scene.last().q[0][0]];
    assert!(ends.iter().all(|q| (q - core::f64::consts::TAU).abs() < core::f64::consts::PI), "they are at {ends:?}");
}

/// And where it is let go on a hill, at which the matrix is not definite, the end of a step moves on with its length.
#[test]
fn a_step_that_begins_on_a_hill_ends_where_shorter_ones_lead() {
    law!(Hill, 2, |self, q| self.k * (0.5 * (q[1] * q[1] - q[0] * q[0]) + 0.177 * q[0].powi(4))
        + 0.1 * q[0] * q[1] * q[1]);
    let (q, v) = ([0.3593253371378011, 0.46797580648077775], [-0.18629052980405048, 0.06988547309368653]);
    let law = Hill { k: 3.556214477472012 };
    let (mut last, lengths) = ([q[0]; 2], 400);
    for i in 1..=lengths {
        let dt = 1.7814498954898563 * f64::from(i) / f64::from(lengths);
        let alone = Simulation::new(law, State::new(q, v)).scheme(DiscreteGradient).dt(dt).run(1).unwrap();
        let scene = Simulation::scene(Scene::new().body(1.0, q, v).field(law));
        let scene = scene.scheme(DiscreteGradient).dt(dt).run(1).unwrap();
        let ends = [alone.last().q[0], scene.last().q[0][0]];
        for (end, before) in ends.iter().zip(last) {
            assert!((end - before).abs() < 0.02, "from {before} to {end} at {dt}");
        }
        last = ends;
    }
    assert!(last.iter().all(|q| *q > 1.0), "it has been driven down: {last:?}");
}

#[derive(Clone, Copy, Debug)]
struct Rope {
    k: f64,
}

#[dmech::law]
impl Rope {
    #[pair]
    fn energy(&self, d: [f64; 1]) -> f64 {
        0.5 * self.k * d[0] * d[0]
    }
}

/// One correction solves a linear force, and what it rounds is of the size of what moves, and not of the path h v of a body that turns
/// round many times in a step: the energy of the trapezoid moves by (ωh)² roundings, for a law as for any scene with it.
#[test]
fn a_linear_force_is_known_at_once_however_stiff() {
    law!(Spring, 1, |self, q| 0.5 * self.k * q[0] * q[0]);
    let mut worst: f64 = 0.0;
    for angle in [1e1, 1e2, 1e3, 1e4, 1e5_f64] {
        let (dt, k) = (0.01, (angle / 0.01).powi(2));
        let one = || Scene::new().body(1.0, [1.0], [0.0]);
        let three = || one().body(2.0, [0.0], [0.3]).body(1.5, [0.5], [0.0]);
        macro_rules! check {
            ($scheme:expr; $($motion:expr),*) => {$({
                let run = $motion.scheme($scheme).dt(dt).run(500).unwrap();
                let off = run.drift(Invariant::Energy).unwrap().max_relative();
                assert!(off < 1e-12 + 2e-15 * angle * angle, "{} {angle:e}: {off:e}", stringify!($motion));
                let work = run.drift(Invariant::WorkEnergy).unwrap().max_abs() / k;
                assert!(work < 1e-12 + 1e-13 * angle, "{} {angle:e}: work {work:e}", stringify!($motion));
                worst = worst.max(off / (angle * angle));
            })*};
        }
        macro_rules! all {
            ($scheme:expr) => {
                check! {
                    $scheme;
                    Simulation::new(Spring { k }, State::new([1.0], [0.0])),
                    Simulation::scene(one().field(Spring { k })),
                    Simulation::scene(three().chain(Rope { k })),
                    Simulation::scene(three().pairs(Rope { k }))
                }
            };
        }
        all!(Implicit);
        all!(Composed::order4(Implicit));
    }
    println!("the energy moved by {worst:e} (ωh)² at most");
}
