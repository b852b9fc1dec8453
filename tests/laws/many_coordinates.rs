//! A law of so many coupled coordinates that what is written for it is hundreds of statements, against the same bodies as a scene.

use dmech::prelude::*;

const BODIES: usize = 6;
const D: usize = 3 * BODIES;

/// Charges that are screened and repel one another closely, all in one law.
#[derive(Clone, Copy, Debug)]
struct Cluster {
    e: f64,
    s: f64,
    k: f64,
}

#[dmech::law]
impl Cluster {
    #[potential]
    fn energy(&self, q: [f64; 18]) -> f64 {
        let mut sum = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let r2 = (0..3).map(|c| (q[3 * i + c] - q[3 * j + c]).powi(2)).sum::<f64>();
                let s6 = (self.s * self.s / r2).powi(3);
                sum += 4.0 * self.e * (s6 * s6 - s6) + self.k * (-r2.sqrt()).exp() / r2.sqrt();
            }
        }
        sum
    }
}

/// The same of two bodies.
#[derive(Clone, Copy, Debug)]
struct Two {
    e: f64,
    s: f64,
    k: f64,
}

#[dmech::law]
impl Two {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        let s6 = (self.s / r).powi(6);
        4.0 * self.e * (s6 * s6 - s6) + self.k * (-r).exp() / r
    }
}

#[test]
fn bodies_in_one_law_move_as_in_a_scene() {
    let [e, s, k] = [0.7, 1.1, 0.6];
    let q: [[f64; 3]; BODIES] = std::array::from_fn(|i| {
        [1.25 * (i % 2) as f64, 1.3 * (i / 2 % 2) as f64 + 0.07 * i as f64, 1.35 * (i / 4) as f64 - 0.03 * i as f64]
    });
    let v: [[f64; 3]; BODIES] = std::array::from_fn(|i| [0.1 * i as f64, 0.3 - 0.1 * i as f64, 0.05]);
    let flat = |x: &[[f64; 3]]| -> [f64; D] { std::array::from_fn(|i| x[i / 3][i % 3]) };
    macro_rules! alike {
        ($($scheme:expr),*) => {$({
            let law = Simulation::new(Cluster { e, s, k }, State::new(flat(&q), flat(&v)));
            let law = *law.scheme($scheme).dt(0.01).run(20).unwrap().last();
            let scene = q.iter().zip(&v).fold(Scene::new(), |scene, (q, v)| scene.body(1.0, *q, *v));
            let scene = Simulation::scene(scene.pairs(Two { e, s, k })).scheme($scheme).dt(0.01).run(20).unwrap();
            let (q, v) = (flat(&scene.last().q), flat(&scene.last().v));
            for i in 0..D {
                let off = f64::max((law.q[i] - q[i]).abs(), (law.v[i] - v[i]).abs());
                assert!(off < 1e-11, "{}, coordinate {i}: off by {off:e}", stringify!($scheme));
            }
        })*};
    }
    alike!(Leapfrog, Implicit, DiscreteGradient);
}
