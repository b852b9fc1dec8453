//! How accelerations change with place and velocity.

use dmech_scalar::{Mask, Real};

use crate::law::Field;
use crate::vector::{by_entry, dot};

/// How fast accelerations change, times the mass: m ∂a/∂q and m ‖∂a/∂v‖².
#[derive(Clone, Copy, Debug)]
pub struct Stiffness<const D: usize, R = f64> {
    /// m ∂a/∂q, or its negative.
    pub by_position: [[R; D]; D],
    /// m ‖∂a/∂v‖².
    pub damping: R,
}

impl<const D: usize, R: Real> Stiffness<D, R> {
    /// Nothing acts.
    pub const NONE: Self = Stiffness { by_position: [[R::ZERO; D]; D], damping: R::ZERO };

    /// Of what acts on one body at a time.
    #[inline(always)]
    pub fn of<F: Field<D, R>>(field: &F, mass: R, t: R, q: [R; D], v: [R; D]) -> Self {
        let mut by_position = field.hessian(q);
        let mut damping = R::ZERO;
        if F::FORCED {
            let (by_q, by_v) = (field.force_dq(q, v, t), field.force_dv(q, v, t));
            by_position = by_entry!(|i, j| by_position[i][j] - by_q[i][j]);
            damping = by_v.iter().fold(R::ZERO, |sum, row| sum + dot(*row, *row)) / mass;
        }
        Stiffness { by_position, damping }
    }

    #[inline(always)]
    pub(crate) fn map(&self, f: impl Fn(R) -> R) -> Self {
        Stiffness { by_position: by_entry!(|i, j| f(self.by_position[i][j])), damping: f(self.damping) }
    }

    #[inline(always)]
    pub(super) fn map2(&self, other: &Self, f: impl Fn(R, R) -> R) -> Self {
        let by_position = by_entry!(|i, j| f(self.by_position[i][j], other.by_position[i][j]));
        Stiffness { by_position, damping: f(self.damping, other.damping) }
    }

    #[inline(always)]
    pub(super) fn norm(&self) -> R {
        let square = self.dot(self);
        let in_range = R::from_f64(1e-200).less_or_equal(square).and(square.less(R::from_f64(1e200)));
        if in_range.all() {
            return square.sqrt();
        }
        // Squares may have left the range of numbers.
        let largest = self.by_position.iter().flatten().fold(self.damping, |most, x| most.max(x.abs()));
        let lost = largest.equal(R::ZERO).or(square.finite().or(largest.finite()).not());
        let unit = self.map(|x| x / largest);
        let careful = R::either(lost, square, largest * unit.dot(&unit).sqrt());
        R::either(in_range, square.sqrt(), careful)
    }

    #[inline(always)]
    pub(super) fn dot(&self, other: &Self) -> R {
        let rows = self.by_position.iter().zip(&other.by_position);
        rows.fold(R::ZERO, |sum, (x, y)| sum + dot(*x, *y)) + self.damping * other.damping
    }
}
