//! What a velocity and a position round off.

use dmech::extend::Real;
use dmech::models::Kepler;
use dmech::models::pairs::FermiPastaUlamTsingou;
use dmech::prelude::*;

/// A force that is the same everywhere.
#[derive(Clone, Copy, Debug)]
struct Uniform {
    g: f64,
}

#[dmech::law]
impl Uniform {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        -self.g * q
    }
}

/// A force so weak that over the whole run it changes the velocity by less than its rounding: the position goes on by what the
/// velocity has not, all the same.
#[test]
fn what_a_velocity_rounds_off_moves_too() {
    const STEPS: u64 = 2000;
    // The product is a number: of dt v nothing is rounded off, fused or not.
    let (v, dt) = (65.0 / 64.0, 31.0 / 32.0);
    let law = Uniform { g: 0.49 * f64::EPSILON / (STEPS as f64 * dt) };
    // It comes to the origin, where a position shows all of its digits.
    let time = DoubleDouble::from(STEPS as f64) * DoubleDouble::from(dt);
    let way = time * DoubleDouble::from(v) + DoubleDouble::from(0.5 * law.g) * time * time;
    let start = -way.to_f64();
    let exact = (DoubleDouble::from(start) + way).to_f64();
    // Of a move of dt v, which lies between 1/2 and 1, the rounding.
    let rounding = 0.5 * f64::EPSILON * STEPS as f64;
    macro_rules! goes_on {
        ($scheme:expr) => {{
            let alone = Simulation::new(law, State::new([start], [v])).mass(1.0).scheme($scheme).dt(dt);
            let alone = *alone.run(STEPS).unwrap().last();
            let body = Simulation::scene(Scene::new().body(1.0, [start], [v]).field(law)).scheme($scheme).dt(dt);
            let body = body.run(STEPS).unwrap().last().clone();
            for [q, at] in [[alone.q[0], alone.v[0]], [body.q[0][0], body.v[0][0]]] {
                println!("{:.4}", (q - exact) / rounding);
                assert!(at == v && (q - exact).abs() < 0.1 * rounding, "{q:e} for {exact:e}");
            }
        }};
    }
    goes_on!(Gauss::order16());
    goes_on!(LineIntegral::order6());
}

/// Where roundings make pushes go to and fro, further sweeps would bring them no nearer, and there are none.
#[test]
fn sweeps_do_not_follow_roundings() {
    let mut scene = Scene::new();
    for i in 0..66_u32 {
        let q = 10.0 * (core::f64::consts::PI * f64::from(i) / 65.0).sin();
        scene = scene.body(1.0, [q], [0.0]);
    }
    let scene = scene.pin(0).pin(65).chain(FermiPastaUlamTsingou { k: 1.0, alpha: 0.0, beta: 0.3 });
    let mut stepper = Simulation::scene(scene).scheme(Gauss::order16()).dt(1.4).stepper().unwrap();
    let (mut most, mut all) = (0, 0);
    for _ in 0..300 {
        stepper.step().unwrap();
        let sweeps = (stepper.evaluations() - all) / 8;
        (most, all) = (most.max(sweeps), stepper.evaluations());
    }
    println!("{most} sweeps in a step, {:.1} in the mean", all as f64 / 2400.0);
    assert!(most < 30, "{most}");
}

/// Steps close to short fractions, by which products and quotients round to one side in the mean: angular momentum walks all the
/// same, from eight orientations to a tenth of what it would drift.
#[test]
fn roundings_have_no_preferred_sign() {
    const STEPS: u64 = 100_000;
    let law = Kepler { gm: 1.0 };
    let starts: Vec<State<2>> = (0..8_u32)
        .map(|k| {
            let (s, c) = (0.1 + 0.77 * f64::from(k)).sin_cos();
            State::new([0.5 * c, 0.5 * s], [-1.63 * s, 1.63 * c])
        })
        .collect();
    let spin = |q: [f64; 2], v: [f64; 2]| {
        let [[x, y], [u, w]] = [q, v].map(|at| at.map(DoubleDouble::from));
        x * w - y * u
    };
    for dt in [0.15, 0.2, 0.3] {
        let (mut alone, mut body) = (0.0, 0.0);
        for start in &starts {
            let before = spin(start.q, start.v);
            let run = Simulation::new(law, *start).mass(1.0).scheme(Gauss::order16()).dt(dt).record_every(STEPS);
            let end = *run.run(STEPS).unwrap().last();
            alone += (spin(end.q, end.v) - before).to_f64() / 8.0;
            let run = Simulation::scene(Scene::new().body(1.0, start.q, start.v).field(law));
            let run = run.scheme(Gauss::order16()).dt(dt).record_every(STEPS).run(STEPS).unwrap();
            body += (spin(run.last().q[0], run.last().v[0]) - before).to_f64() / 8.0;
        }
        println!("{dt}: {alone:.1e} alone, {body:.1e} in a scene");
        // 4e-14, 2e-14 and 1.2e-13 without the second parts.
        assert!(alone.abs() < 1e-14 && body.abs() < 1e-14, "{dt}: {alone:e}, {body:e}");
    }
}
