//! Passes over all coordinates, line by line. What fills up the last line is computed too, and not looked at: no loop has a
//! remainder, which for few bodies would be most of it. They are functions because their arguments are then known not to overlap.

use dmech_scalar::Lanes;

use crate::scene::vectors::Line;

/// x += c y.
#[inline]
pub(super) fn add_scaled(x: &mut [Line], c: f64, y: &[Line]) {
    let c = Lanes::splat(c);
    for (x, &y) in x.iter_mut().zip(y) {
        *x = (Lanes::from(*x) + c * Lanes::from(y)).into();
    }
}

/// x += c (y + z).
#[inline]
pub(super) fn add_sum(x: &mut [Line], c: f64, y: &[Line], z: &[Line]) {
    let c = Lanes::splat(c);
    for (x, (&y, &z)) in x.iter_mut().zip(y.iter().zip(z)) {
        *x = (Lanes::from(*x) + c * (Lanes::from(y) + Lanes::from(z))).into();
    }
}

/// to ← v − b (h/m) S.
#[inline]
pub(super) fn kick(b: f64, kick: &[Line], slope: &[Line], v: &[Line], to: &mut [Line]) {
    let n = to.len();
    let (kick, slope, v, b) = (&kick[..n], &slope[..n], &v[..n], Lanes::splat(b));
    for i in 0..n {
        let [kick, slope, v] = [kick[i], slope[i], v[i]].map(Lanes::from);
        to[i] = (v - b * kick * slope).into();
    }
}

/// The same, then q += a v′. `lengths` are b and a.
#[inline]
pub(super) fn kick_and_drift(
    lengths: [f64; 2],
    kick: &[Line],
    slope: &[Line],
    q: &mut [Line],
    v: &[Line],
    to: &mut [Line],
) {
    let ([b, a], n) = (lengths.map(Lanes::splat), q.len());
    let (kick, slope, v, to) = (&kick[..n], &slope[..n], &v[..n], &mut to[..n]);
    for i in 0..n {
        let [kick, slope, v] = [kick[i], slope[i], v[i]].map(Lanes::from);
        let next = v - b * kick * slope;
        to[i] = next.into();
        q[i] = (Lanes::from(q[i]) + a * next).into();
    }
}

/// The same, and the work of the kick, F·(mean velocity) in its time, is added. `lengths` are b, that time, and a.
#[inline]
pub(super) fn kick_and_drift_watched(
    lengths: [f64; 3],
    kick: &[Line],
    slope: &[Line],
    q: &mut [Line],
    v: &[Line],
    to: &mut [Line],
    work: &mut [Line],
) {
    let ([b, time, a], half) = (lengths.map(Lanes::splat), Lanes::splat(0.5));
    let n = q.len();
    let (kick, slope, v, to, work) = (&kick[..n], &slope[..n], &v[..n], &mut to[..n], &mut work[..n]);
    for i in 0..n {
        let [kick, slope, v] = [kick[i], slope[i], v[i]].map(Lanes::from);
        let change = b * kick * slope;
        work[i] = (Lanes::from(work[i]) - time * slope * (v - half * change)).into();
        let next = v - change;
        to[i] = next.into();
        q[i] = (Lanes::from(q[i]) + a * next).into();
    }
}
