//! Positions as vectors of nalgebra, by every name they go under.
use dmech::prelude::*;
use nalgebra::{self as na, SVector, Vector2};

struct Kepler {
    gm: f64,
    centre: Vector2<f64>,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: Vector2<f64>) -> f64 {
        -self.gm / (q - self.centre).norm()
    }
}

struct Plummer {
    gm: f64,
}

#[dmech::law]
impl Plummer {
    #[potential]
    fn energy(&self, q: na::Vector3<f64>) -> f64 {
        -self.gm / (q.norm_squared() + 0.01).sqrt()
    }
}

struct Quartic;

#[dmech::law]
impl Quartic {
    const D: usize = 4;

    #[potential]
    fn energy(&self, q: SVector<f64, { Self::D }>) -> f64 {
        0.25 * q.dot(&q).powi(2)
    }
}

fn main() {
    let law = Kepler { gm: 2.0, centre: Vector2::new(0.5, 0.0) };
    assert_eq!(law.energy(Vector2::new(1.5, 0.0)), -2.0);
    assert_eq!(law.gradient([1.5, 0.0]), [2.0, 0.0]);
    assert_eq!(Plummer { gm: 1.0 }.gradient([0.0; 3]), [0.0; 3]);
    assert_eq!(Quartic.gradient([1.0, 0.0, 0.0, 0.0]), [1.0, 0.0, 0.0, 0.0]);
}
