//! Positions as nalgebra's vectors.

use super::oracle::agrees;
use nalgebra::{SVector, Vector2, Vector3};

struct Centre {
    gm: f64,
    at: Vector2<f64>,
}

#[dmech::law]
impl Centre {
    #[potential]
    fn energy(&self, q: Vector2<f64>) -> f64 {
        let d = q - self.at;
        -self.gm / d.norm() + 0.1 * q.x * q.y
    }
}

#[test]
fn plane() {
    let law = Centre { gm: 1.7, at: Vector2::new(-0.6, 0.3) };
    agrees("Vector2", &law, |[x, y]| law.energy(Vector2::new(x, y)), [0.9, 0.4], 0.7);
}

struct Dipole {
    k: f64,
    axis: Vector3<f64>,
}

#[dmech::law]
impl Dipole {
    fn along(&self, q: Vector3<f64>) -> f64 {
        self.axis.dot(&q)
    }

    #[potential]
    fn energy(&self, q: Vector3<f64>) -> f64 {
        let r2 = q.norm_squared() + 0.2;
        let axis: Vector3<f64> = self.axis;
        self.k * self.along(q) / (r2 * r2.sqrt()) + q.cross(&axis).norm_squared() + 0.1 * (q / 2.0 + 3.0 * q).z
    }
}

#[test]
fn space() {
    let law = Dipole { k: 1.7, axis: Vector3::new(0.3, -0.5, 0.8) };
    agrees("Vector3", &law, |q| law.energy(Vector3::from(q)), [0.9, 0.4, -0.3], 0.7);
}

struct Bowl {
    k: f64,
}

#[dmech::law]
impl Bowl {
    #[potential]
    fn energy(&self, q: SVector<f64, 5>) -> f64 {
        let shifted = q - SVector::<f64, 5>::repeat(0.2);
        let quartic = q.component_mul(&q).norm_squared();
        self.k * shifted.norm_squared() + quartic + 0.5 * q[3] * q.sum() + (-q).iter().map(|x| x.sin()).sum::<f64>()
    }
}

#[test]
fn any_dimension() {
    let law = Bowl { k: 1.7 };
    agrees("SVector", &law, |q| law.energy(SVector::from(q)), [0.9, 0.4, -0.3, 0.2, 0.6], 0.7);
}
