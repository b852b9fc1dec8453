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
