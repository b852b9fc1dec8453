//! Gradient, Hessian and the Jacobians of the force against differences of what they are derivatives of; what the law
//! claims of itself.

use core::array::from_fn;

use super::Subject;
use super::difference::{Worst, derivative};
use super::points::{Dice, norm, with};
use super::report::Check;
use crate::motion::{largest, largest_entry};
use dmech_core::extend::Field;
use dmech_core::extend::vector::dot;
use dmech_core::{Law, Potential};

/// Units of rounding that a formula may lose beyond its condition.
pub(super) const ULPS: f64 = 64.0;

pub(super) fn check<L: Law<D>, const D: usize>(subject: &Subject<L, D>, checks: &mut Vec<Check>) {
    let Subject { law, start, mass, scales } = subject;
    let field = law.field(*mass, start.t);
    let (points, moves) = (subject.points(), subject.moves());
    if points.is_empty() {
        checks.push(Check::failed("potential", "not finite anywhere around the start"));
        return;
    }
    let h = 0.02 * scales.length;
    let (mut gradient, mut hessian) = (Worst::new(), Worst::new());
    for &q in &points {
        let (g, whole) = (field.gradient(q), subject.weighted(field.gradient(q)));
        let second = field.hessian(q);
        let size = largest_entry(&second);
        let parts = largest(&g).max(size * subject.reach(&q));
        let stiffness = largest(&subject.weighted(second.map(|row| largest(&row))));
        for j in (0..D).filter(|&j| moves[j]) {
            let at = |x: f64| with(q, j, x);
            let scale = floor(largest(&whole), stiffness * scales.length);
            gradient.compare(whole[j], derivative(|x| field.potential(at(x)), q[j], h, 0.0), scale);
            for i in 0..D {
                let scale = floor(size, largest(&g) / scales.length);
                let quotient = derivative(|x| field.gradient(at(x))[i], q[j], h, parts);
                hessian.compare(second[i][j], quotient, scale);
            }
        }
    }
    checks.push(row("gradient", gradient, "against differences of the potential, relative"));
    checks.push(row("Hessian", hessian, "against differences of the gradient, relative"));
    slope(subject, &field, &points, checks);
    force(subject, &field, &points, checks);
    claims(subject, &field, &points, checks);
}

/// A size that is not zero.
pub(super) fn floor(size: f64, other: f64) -> f64 {
    let scale = size.max(other);
    if scale > 0.0 { scale } else { 1.0 }
}

pub(super) fn row(name: &str, worst: Worst, note: &str) -> Check {
    if worst.compared == 0 {
        return Check::not_applicable(name, "too rough around the start for differences to tell");
    }
    Check::at_most(name, worst.measured, worst.bound, note)
}

/// The kick of the explicit formulas and of leap-frog uses the same force as the implicit steps: v − c (∇Φ − F).
fn slope<L: Law<D>, F: Field<D>, const D: usize>(
    subject: &Subject<L, D>,
    field: &F,
    points: &[[f64; D]],
    checks: &mut Vec<Check>,
) {
    let start = &subject.start;
    let (mut kick, mut alone) = (0.0_f64, 0.0_f64);
    let c = 0.37;
    for &q in points {
        let (slope, gradient, force) = (field.slope(q, start.v), field.gradient(q), field.force(q, start.v, start.t));
        let kicked = field.kick(c, q, start.v);
        let curvature = largest_entry(&field.hessian(q)) * subject.reach(&q);
        let unit = f64::EPSILON * floor(largest(&gradient).max(largest(&slope)).max(curvature), largest(&start.v));
        for i in 0..D {
            kick = worse(kick, (kicked[i] - (start.v[i] - c * slope[i])).abs() / unit);
            alone = worse(alone, (slope[i] - (gradient[i] - force[i])).abs() / unit);
        }
    }
    checks.push(Check::at_most("kick and slope", kick, ULPS, "the same force, in units of rounding"));
    let note = if F::FORCED { "slope = gradient - force" } else { "no force beside the potential" };
    checks.push(Check::at_most("slope and gradient", alone, ULPS, note));
}

/// ∂F/∂q and ∂F/∂v, with which the implicit steps solve their equation, at positions and velocities around the start.
fn force<L: Law<D>, F: Field<D>, const D: usize>(
    subject: &Subject<L, D>,
    field: &F,
    points: &[[f64; D]],
    checks: &mut Vec<Check>,
) {
    let (Subject { start, scales, .. }, moves) = (subject, subject.moves());
    let names = ["force by position", "force by velocity"];
    if !F::FORCED {
        checks.extend(names.map(|name| Check::not_applicable(name, "no force beside the potential")));
        return;
    }
    let (t, speed) = (start.t, scales.length / scales.time);
    let (mut by_position, mut by_velocity) = (Worst::new(), Worst::new());
    let mut dice = Dice::new();
    for &q in points {
        let v = dice.near(start.v, moves, 0.15 * speed);
        let size = largest(&field.force(q, v, t));
        let (dq, dv) = (field.force_dq(q, v, t), field.force_dv(q, v, t));
        let size_q = floor(largest_entry(&dq), size / scales.length);
        let size_v = floor(largest_entry(&dv), size / speed);
        for j in (0..D).filter(|&j| moves[j]) {
            for i in 0..D {
                let quotient = derivative(|x| field.force(with(q, j, x), v, t)[i], q[j], 0.02 * scales.length, size);
                by_position.compare(dq[i][j], quotient, size_q);
                let quotient = derivative(|x| field.force(q, with(v, j, x), t)[i], v[j], 0.02 * speed, size);
                by_velocity.compare(dv[i][j], quotient, size_v);
            }
        }
    }
    let [position, velocity] = names;
    checks.push(row(position, by_position, "its Jacobian against differences, relative"));
    checks.push(row(velocity, by_velocity, "its Jacobian against differences, relative"));
}

/// Central, linear, without work: what the law says of itself, and what schemes rely on.
fn claims<L: Law<D>, F: Field<D>, const D: usize>(
    subject: &Subject<L, D>,
    field: &F,
    points: &[[f64; D]],
    checks: &mut Vec<Check>,
) {
    let start = &subject.start;
    let (mut turn, mut bend, mut work) = (0.0_f64, 0.0_f64, 0.0_f64);
    let first = field.hessian(points[0]);
    for &q in points {
        let (gradient, slope, hessian) = (field.gradient(q), field.slope(q, start.v), field.hessian(q));
        let size = largest_entry(&hessian);
        let torque = f64::EPSILON * floor(norm(q) * norm(gradient), 0.0);
        let acting = norm(subject.weighted(gradient)) + norm(subject.weighted(slope));
        let power = f64::EPSILON * floor(norm(start.v) * acting, 0.0);
        for i in 0..D {
            for j in 0..D {
                turn = worse(turn, (q[i] * gradient[j] - q[j] * gradient[i]).abs() / torque);
                bend = worse(bend, (hessian[i][j] - first[i][j]).abs() / (f64::EPSILON * floor(size, 0.0)));
            }
        }
        let force = subject.weighted(from_fn(|i| slope[i] - gradient[i]));
        work = worse(work, dot(start.v, force).abs() / power);
    }
    if F::CENTRAL {
        checks.push(Check::at_most("claim: central", turn, ULPS, "torque, in units of rounding"));
    }
    if F::LINEAR {
        checks.push(Check::at_most("claim: linear", bend, ULPS, "change of the Hessian, in units of rounding"));
    }
    if F::FORCED && F::CONSERVES_ENERGY {
        checks.push(Check::at_most("claim: no work", work, ULPS, "power of the force, in units of rounding"));
    }
}

/// The larger; a NaN is larger than everything.
pub(super) fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a >= b { a } else { b }
}
