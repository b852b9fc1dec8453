//! How fast what acts along a link changes.

use dmech_scalar::Real;

use crate::law::Between;
use crate::look::{Course, Stiffness};
use crate::vector::{add_scaled, by_entry, dot};

/// How fast the relative acceleration of two bodies changes, times the reduced mass μ, at the separation d and s after now, of what
/// acts then: as seen from the first, and from the second.
///
/// With the shares σ_a = μ/m_a and σ_b = μ/m_b the force on d is σ_a F_a − σ_b F_b; in the motion of the one about the
/// other ∂v_a/∂w = σ_a and ∂v_b/∂w = −σ_b, w = v_a − v_b.
#[inline]
pub(in crate::scene) fn link_stiffness<const D: usize, R: Real, X: Between<D, R>>(
    [between, back]: [X; 2],
    s: R,
    [on_a, on_b]: [&Course<D, R>; 2],
    d: [R; D],
) -> Stiffness<D, R> {
    let mut by_position = [[R::ZERO; D]; D];
    let mut damping = R::ZERO;
    if X::POTENTIAL {
        by_position = between.hessian(d);
    }
    if X::FORCED {
        let per_mass = on_a.per_mass + on_b.per_mass;
        let [share_a, share_b] = [on_a, on_b].map(|body| body.per_mass / per_mass);
        let [va, vb] = [on_a, on_b].map(|body| add_scaled(body.v, s, body.fall));
        let [by_d, by_va, by_vb] = between.force_jacobians(d, va, vb);
        let (mut by_d, mut by_w) = (by_d, combine(share_a, by_va, -share_b, by_vb));
        if !X::RECIPROCAL {
            let back = back.force_jacobians(d.map(|x| -x), vb, va);
            by_d = combine(share_a, by_d, share_b, back[0]);
            by_w = combine(share_a, by_w, share_b, combine(share_b, back[1], -share_a, back[2]));
        }
        by_position = combine(R::ONE, by_position, -R::ONE, by_d);
        damping = per_mass * by_w.iter().fold(R::ZERO, |sum, row| sum + dot(*row, *row));
    }
    Stiffness { by_position, damping }
}

/// c X + d Y.
#[inline(always)]
pub(super) fn combine<const D: usize, R: Real>(c: R, x: [[R; D]; D], d: R, y: [[R; D]; D]) -> [[R; D]; D] {
    by_entry!(|k, l| c.mul_add(x[k][l], d * y[k][l]))
}
