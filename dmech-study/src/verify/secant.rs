//! The identities of the discrete gradient.

use super::Subject;
use super::derivatives::{ULPS, floor, row, worse};
use super::difference::{Worst, derivative};
use super::points::{Dice, norm, with};
use super::report::Check;
use crate::motion::{largest, largest_entry};
use dmech_core::extend::vector::{difference, dot};
use dmech_core::{Law, Potential};

/// Gaps |b − a| in units of the length: from far apart to where a quotient of differences is noise.
const GAPS: [f64; 6] = [0.25, 0.1, 1e-2, 1e-4, 1e-6, 1e-9];

pub(super) fn check<L: Law<D>, const D: usize>(subject: &Subject<L, D>, checks: &mut Vec<Check>) {
    let Subject { law, start, mass, scales } = subject;
    let field = law.field(*mass, start.t);
    let (points, moves) = (subject.points(), subject.moves());
    if points.is_empty() {
        checks.push(Check::not_applicable("secant identity", "the potential is not finite around the start"));
        return;
    }
    let (mut secant, mut symmetry, mut limit, mut jacobian) = (0.0_f64, 0.0_f64, 0.0_f64, Worst::new());
    let mut dice = Dice::new();
    for &a in &points {
        let (phi, gradient) = (field.potential(a), field.gradient(a));
        let curvature = largest_entry(&field.hessian(a));
        let size = floor(largest(&gradient), curvature * subject.reach(&a));
        let same = field.discrete_gradient(a, a);
        limit = worse(limit, largest_difference(same, gradient) / (f64::EPSILON * size));
        for gap in GAPS {
            let b = dice.near(a, moves, gap * scales.length);
            let other = field.potential(b);
            if !other.is_finite() || a == b {
                continue;
            }
            let (mean, back) = (field.discrete_gradient(a, b), field.discrete_gradient(b, a));
            // Values are uncertain by a unit of their size and of what a unit of the position changes in them.
            let [here, there] = [gradient, field.gradient(b)].map(|gradient| norm(subject.weighted(gradient)));
            let moved = here * norm(a) + there * norm(b);
            let energy = floor(phi.abs() + other.abs() + moved, 0.0);
            let miss = dot(subject.weighted(mean), difference(b, a)) - (other - phi);
            secant = worse(secant, miss.abs() / (f64::EPSILON * energy));
            // A discrete gradient that is a quotient of differences has their noise; one in closed form has not.
            let unit = f64::EPSILON * (size + energy / norm(difference(b, a)));
            symmetry = worse(symmetry, largest_difference(mean, back) / unit);
            if gap < 1e-5 {
                continue;
            }
            let exact = field.discrete_gradient_jacobian(a, b);
            let scale = floor(largest_entry(&exact), curvature);
            for j in (0..D).filter(|&j| moves[j]) {
                for i in 0..D {
                    let quotient =
                        derivative(|x| field.discrete_gradient(a, with(b, j, x))[i], b[j], 0.02 * scales.length, size);
                    jacobian.compare(exact[i][j], quotient, scale);
                }
            }
        }
    }
    checks.push(Check::at_most("secant identity", secant, ULPS, "in units of rounding of |Phi(a)| + |Phi(b)|"));
    checks.push(Check::at_most("symmetry in a, b", symmetry, ULPS, "discrete gradient, in units of rounding"));
    checks.push(Check::at_most("limit b = a", limit, ULPS, "the gradient, in units of rounding"));
    checks.push(row("its Jacobian", jacobian, "against differences of the discrete gradient, relative"));
}

/// max |xᵢ − yᵢ|, NaN if any of them is.
fn largest_difference<const D: usize>(x: [f64; D], y: [f64; D]) -> f64 {
    x.iter().zip(&y).map(|(x, y)| (x - y).abs()).fold(0.0, worse)
}
