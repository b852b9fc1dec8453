//! A charge in a magnetic bottle by hand, as plasma codes have it.

use std::hint::black_box;

use dmech::prelude::*;

use super::{Loop, fma};

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [fma(a[1], b[2], -(a[2] * b[1])), fma(a[2], b[0], -(a[0] * b[2])), fma(a[0], b[1], -(a[1] * b[0]))]
}

/// q½ = q + (h/2) v; u = v + v × t, v′ = v + u × s with t = (h/2) B, s = 2t/(1 + t²); q′ = q½ + (h/2) v′.
#[inline(never)]
fn rotate([b0, length]: [f64; 2], dt: f64, q: &mut [f64; 3], v: &mut [f64; 3], steps: u64) {
    let (mut place, mut speed, half) = (*q, *v, 0.5 * dt);
    let c = b0 / (length * length);
    for _ in 0..steps {
        for i in 0..3 {
            place[i] = fma(half, speed[i], place[i]);
        }
        let [x, y, z] = place;
        let bend = -c * z;
        let t = [half * bend * x, half * bend * y, half * fma(c * z, z, b0)];
        let factor = 2.0 / (1.0 + fma(t[0], t[0], fma(t[1], t[1], t[2] * t[2])));
        let turned = cross(speed, t);
        let between = [speed[0] + turned[0], speed[1] + turned[1], speed[2] + turned[2]];
        let turned = cross(between, t.map(|t| factor * t));
        for i in 0..3 {
            speed[i] += turned[i];
            place[i] = fma(half, speed[i], place[i]);
        }
    }
    (*q, *v) = (place, speed);
}

pub(crate) fn boris(field: [f64; 2], start: State<3>, dt: f64) -> Loop {
    let (mut q, mut v) = (start.q, start.v);
    Box::new(move |steps| {
        rotate(black_box(field), black_box(dt), &mut q, &mut v, steps);
        q[0]
    })
}
