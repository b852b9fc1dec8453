//! Passes over all coordinates, as functions: their arguments are known not to overlap, so that the compiler makes registers
//! of them.

/// to ← v − b (h/m) S.
#[inline]
pub(super) fn kick(b: f64, kick: &[f64], slope: &[f64], v: &[f64], to: &mut [f64]) {
    let n = to.len();
    let (kick, slope, v) = (&kick[..n], &slope[..n], &v[..n]);
    for i in 0..n {
        to[i] = v[i] - b * kick[i] * slope[i];
    }
}

/// The same, then q += a v′; the work of the kick, F·(mean velocity) in its time, is added. `lengths` are b, that time, and a.
#[inline]
pub(super) fn kick_and_drift(
    lengths: [f64; 3],
    kick: &[f64],
    slope: &[f64],
    q: &mut [f64],
    v: &[f64],
    to: &mut [f64],
    work: &mut [f64],
) {
    let [b, time, a] = lengths;
    let n = q.len();
    let (kick, slope, v, to, work) = (&kick[..n], &slope[..n], &v[..n], &mut to[..n], &mut work[..n]);
    for i in 0..n {
        let change = b * kick[i] * slope[i];
        work[i] -= time * slope[i] * (v[i] - 0.5 * change);
        let next = v[i] - change;
        to[i] = next;
        q[i] += a * next;
    }
}
