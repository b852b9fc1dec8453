//! Laws of what is rounded: nearest images, periodic kinks, across the jumps.

use dmech::extend::Real;
use dmech::prelude::*;

use super::oracle::{Dice, slope};

/// A spring to the nearest image of the centre, k |d|²/2: the force jumps half way between two images.
#[derive(Clone, Copy, Debug)]
struct Images {
    k: f64,
    l: f64,
}

#[dmech::law]
impl Images {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q.map(|x| x - self.l * (x / self.l).round());
        0.5 * self.k * (x * x + y * y)
    }
}

/// A soft core 1/(1 + r²)² of the nearest image, in which the coordinates interact.
#[derive(Clone, Copy, Debug)]
struct Core {
    l: f64,
}

#[dmech::law]
impl Core {
    fn image(&self, x: f64) -> f64 {
        (x + 0.5 * self.l).rem_euclid(self.l) - 0.5 * self.l
    }
    #[potential]
    fn energy(&self, q: [f64; 3]) -> f64 {
        let r2 = self.image(q[0]).powi(2) + self.image(q[1]).powi(2) + self.image(q[2]).powi(2);
        1.3 / (1.0 + r2).powi(2)
    }
}

/// Smooth where it jumps: a periodic function of a fraction, another of a ceiling.
#[derive(Clone, Copy, Debug)]
struct Periodic {
    k: f64,
}

#[dmech::law]
impl Periodic {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let wave = (std::f64::consts::TAU * (self.k * q[0]).fract()).cos();
        let up = q[1] - q[1].ceil();
        wave * (1.0 + 16.0 * (up * (1.0 + up)).powi(2)) + 0.3 * q[0] * q[1]
    }
}

/// A broken line through n²/2, and a sawtooth: what jumps in one term does in the other.
#[derive(Clone, Copy, Debug)]
struct Line {
    k: f64,
}

#[dmech::law]
impl Line {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        let n = q.floor();
        let inner = q - q.trunc();
        self.k * (q * n - 0.5 * n * (n + 1.0)) + inner * (inner.abs() - 1.0) + 0.1 * q
    }
}

/// Potential, gradient and Hessian are those of the method off the jumps, and between any two points, across as many jumps
/// as may be, the discrete gradient takes exactly the difference of energy; it is symmetric, and the gradient where they meet.
fn across<const D: usize>(name: &str, law: &impl Potential<D>, declared: impl Fn([f64; D]) -> f64) {
    let mut dice = Dice::default();
    let mut beside = 0;
    for round in 0..400 {
        let a: [f64; D] = core::array::from_fn(|_| 3.0 * dice.throw());
        let reach = 3.0 * 0.25_f64.powi(round % 14);
        let b = a.map(|x| x + reach * dice.throw());
        let close = |found: f64, expected: f64, tolerance: f64, what: &str| {
            let scale = 1.0 + expected.abs();
            assert!((found - expected).abs() <= tolerance * scale, "{name}: {what} at {a:?}: {found:e}, {expected:e}");
        };
        close(law.potential(a), declared(a), 1e-14, "the potential");
        let (gradient, hessian) = (law.gradient(a), law.hessian(a));
        for i in 0..D {
            // Differences across a jump of the force are not slopes.
            let felt = (slope(&declared, a, i) - gradient[i]).abs() < 1e-7 * (1.0 + gradient[i].abs());
            let bent = (0..D).all(|j| (slope(|x| law.gradient(x)[i], a, j) - hessian[i][j]).abs() < 1e-6);
            beside += u32::from(!felt || !bent);
        }
        let (there, back) = (law.discrete_gradient(a, b), law.discrete_gradient(b, a));
        let secant: f64 = (0..D).map(|i| there[i] * (b[i] - a[i])).sum();
        close(secant, declared(b) - declared(a), 4e-14, "the secant identity");
        let size = there.iter().map(|x| x.abs()).sum::<f64>();
        for i in 0..D {
            close(there[i], back[i], 1e-13 * (1.0 + size) / reach.min(1.0), "the way back");
            close(law.discrete_gradient(a, a)[i], gradient[i], 1e-14, "the limit");
        }
    }
    assert!(beside < 20 * D as u32, "{name}: {beside} of {} slopes", 400 * D);
}

#[test]
fn secants_across_jumps() {
    let (images, core, periodic, line) =
        (Images { k: 1.7, l: 0.8 }, Core { l: 1.1 }, Periodic { k: 1.0 }, Line { k: 0.6 });
    across("images", &images, |q| images.energy(q));
    across("core", &core, |q| core.energy(q));
    across("line", &line, |[x]| line.energy(x));
    let mut dice = Dice::default();
    for _ in 0..400 {
        let [a, b] = [(); 2].map(|()| [3.0 * dice.throw(), 3.0 * dice.throw()]);
        let there = periodic.discrete_gradient(a, b);
        let secant = there[0] * (b[0] - a[0]) + there[1] * (b[1] - a[1]);
        assert!((secant - (periodic.energy(b) - periodic.energy(a))).abs() < 1e-13);
        assert!((periodic.gradient(a)[0] - slope(|q| periodic.energy(q), a, 0)).abs() < 1e-5);
    }
}

/// The quadratic potential of an image has a constant Hessian almost everywhere, and is no quadratic potential.
#[test]
fn energy_is_exact_through_the_box() -> Result<(), Box<dyn std::error::Error>> {
    let law = Images { k: 1.7, l: 0.8 };
    let start = State::new([0.1, -0.2], [0.9, 0.63]);
    let run = Simulation::new(law, start).scheme(DiscreteGradient).dt(0.01).run(4000)?;
    let drift = run.drift(Invariant::Energy).unwrap();
    assert!(drift.max_relative() < 1e-13, "{drift:?}");
    assert!(run.last().q[0].abs() > 10.0 * law.l, "{:?}", run.last());
    assert!(run.report().iterations() > 4000);

    let core = Core { l: 1.1 };
    let start = State::new([0.1, -0.2, 0.3], [0.9, 0.63, -1.2]);
    for drift in [
        Simulation::new(core, start).scheme(DiscreteGradient).dt(0.01).run(4000)?.drift(Invariant::Energy),
        Simulation::new(core, start)
            .scheme(Composed::order4(DiscreteGradient))
            .dt(0.02)
            .run(2000)?
            .drift(Invariant::Energy),
    ] {
        assert!(drift.unwrap().max_relative() < 1e-13, "{drift:?}");
    }
    assert!(law.derivation().contains("round("), "{}", law.derivation());
    Ok(())
}

/// All scalars round alike.
#[test]
fn every_scalar_rounds() {
    let law = Images { k: 1.7, l: 0.8 };
    let q = [1.9, -3.3];
    let wide = Potential::<2, f32>::gradient(&law, q.map(|x| x as f32));
    let precise = law.gradient(q.map(DoubleDouble::from));
    for i in 0..2 {
        let wanted = law.gradient(q)[i];
        assert!((f64::from(wide[i]) - wanted).abs() < 1e-6 && (precise[i].to_f64() - wanted).abs() < 1e-15);
    }
}

/// A separation in a box.
#[derive(Clone, Copy, Debug)]
struct Pull {
    l: f64,
}

#[dmech::law]
impl Pull {
    #[pair]
    fn energy(&self, d: [f64; 2]) -> f64 {
        let [x, y] = d.map(|x| x - self.l * (x / self.l).round());
        let r2 = x * x + y * y;
        -1.0 / (1.0 + r2) + 0.3 * r2
    }
}

/// Bodies that feel the nearest images of each other keep energy and momentum while they leave the box.
#[test]
fn images_in_a_scene() -> Result<(), Box<dyn std::error::Error>> {
    let mut dice = Dice::default();
    let mut scene = Scene::new().pairs(Pull { l: 2.0 });
    for _ in 0..6 {
        let [x, y, vx, vy] = [(); 4].map(|()| dice.throw());
        scene = scene.body(1.3, [x, y], [vx, vy]);
    }
    let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.01).run(500)?;
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
    assert!(run.drift(Invariant::LinearMomentum).unwrap().max_abs() < 1e-12);
    Ok(())
}
