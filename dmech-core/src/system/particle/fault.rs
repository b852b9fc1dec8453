//! Why an implicit step has no solution: the law may not be finite on the way.

use core::array::from_fn;

use dmech_scalar::{Mask, Real};

use crate::error::{Error, Place};
use crate::law::{Field, Law, Potential};
use crate::newton::NotConverged;

/// The parts of a step at which the law is looked at: Newton comes from the start, where a step has no length.
pub(crate) const PARTS: [f64; 9] = [0.0, 1.0 / 16384.0, 1.0 / 1024.0, 1.0 / 64.0, 0.125, 0.25, 0.5, 0.75, 1.0];

/// Corrections of a law that is finite led nowhere; what is no number any more is beyond all bounds.
pub(crate) fn not_converged(step: u64, time: f64, dt: f64, cause: NotConverged) -> Error {
    let NotConverged { iterations, residual } = cause;
    let residual = if residual.is_nan() { f64::INFINITY } else { residual };
    Error::NotConverged { step, time, dt: dt.abs(), iterations: iterations as u32, residual }
}

/// A step that begins at time t in q with the velocity v.
pub(crate) struct Attempt<const D: usize, R: Real> {
    pub(crate) step: u64,
    pub(crate) t: f64,
    /// The length of the step; negative if it goes backward.
    pub(crate) dt: f64,
    pub(crate) mass: R,
    pub(crate) q: [R; D],
    pub(crate) v: [R; D],
}

impl<const D: usize, R: Real> Attempt<D, R> {
    /// The error to tell: where the law is not finite on the way, that; or else that corrections did not converge.
    ///
    /// Newton itself comes back from a place where the law is not finite by way of a shorter step. What is told is the first
    /// such place on the way of a freely falling particle, q + θ h v − θ² h² M⁻¹(∇Φ − F)/2.
    #[cold]
    pub(crate) fn unsolved<L: Law<D, R>>(&self, law: &L, cause: NotConverged) -> Error {
        let Attempt { step, t: time, dt, .. } = *self;
        match PARTS.iter().find_map(|&part| self.fault(law, part)) {
            Some((quantity, value, q)) => {
                let place = Place::new(&q.map(|x| x.to_f64()));
                Error::LawInStep { quantity, value, place, step, time, dt: dt.abs() }
            }
            None => not_converged(step, time, dt, cause),
        }
    }

    /// What is not finite after a part of the step, its value, and the place.
    fn fault<L: Law<D, R>>(&self, law: &L, part: f64) -> Option<(&'static str, f64, [R; D])> {
        let Attempt { q: a, v, mass, .. } = *self;
        let passed = part * self.dt;
        let slope = law.field(mass, R::from_f64(self.t)).slope(a, v);
        let (time, fall) = (R::from_f64(passed), R::from_f64(-0.5 * passed * passed) / mass);
        let b: [R; D] = from_fn(|i| fall.mul_add(slope[i], time.mul_add(v[i], a[i])));
        if !b.iter().all(|x| x.finite().all()) {
            return None;
        }
        let field = law.field(mass, R::from_f64(self.t + passed));
        let odd = |values: &[R]| values.iter().find(|x| !x.finite().all()).map(|x| x.to_f64());
        let told = |quantity, value: Option<f64>| value.map(|value| (quantity, value, b));
        told("force", odd(&field.slope(b, v)))
            .or_else(|| told("potential", odd(&[field.potential(b)])))
            .or_else(|| told("second derivative", odd(field.hessian(b).as_flattened())))
            .or_else(|| told("discrete gradient", odd(&field.discrete_gradient(a, b))))
            .or_else(|| {
                told("Jacobian of the discrete gradient", odd(field.discrete_gradient_jacobian(a, b).as_flattened()))
            })
    }
}
