//! The same loops by hand, as well as we can write them.

use std::hint::black_box;

use dmech::prelude::*;

use super::Loop;

pub(super) mod bottle;
pub(super) mod pendulum;

/// a b + c, fused where the target has the instruction.
#[inline(always)]
fn fma(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_feature = "fma") { a.mul_add(b, c) } else { a * b + c }
}

#[derive(Clone, Copy)]
struct Plane {
    q: [f64; 2],
    v: [f64; 2],
}

#[inline(never)]
fn leapfrog(gm: f64, dt: f64, state: &mut Plane, steps: u64) {
    let Plane { q: [mut x, mut y], v: [mut vx, mut vy] } = *state;
    let k = gm * dt;
    for _ in 0..steps {
        x = fma(dt, vx, x);
        y = fma(dt, vy, y);
        let s = fma(x, x, y * y);
        let c = s.sqrt() * (k / (s * s));
        vx = fma(-c, x, vx);
        vy = fma(-c, y, vy);
    }
    *state = Plane { q: [x, y], v: [vx, vy] };
}

#[inline(never)]
fn leapfrog_naive(gm: f64, dt: f64, state: &mut Plane, steps: u64) {
    let Plane { q: [mut x, mut y], v: [mut vx, mut vy] } = *state;
    let k = gm * dt;
    for _ in 0..steps {
        x = fma(dt, vx, x);
        y = fma(dt, vy, y);
        let s = fma(x, x, y * y);
        let c = k / (s * s.sqrt());
        vx = fma(-c, x, vx);
        vy = fma(-c, y, vy);
    }
    *state = Plane { q: [x, y], v: [vx, vy] };
}

/// Newton on q′ with the 2 × 2 Jacobian, from a second-order guess, until corrections are below 10⁻¹³.
#[inline(never)]
fn trapezoid(gm: f64, dt: f64, state: &mut Plane, steps: u64) {
    let Plane { mut q, mut v } = *state;
    let force = |q: [f64; 2]| {
        let s = q[0] * q[0] + q[1] * q[1];
        let inverse = 1.0 / s;
        let c = gm * s.sqrt() * (inverse * inverse);
        ([-c * q[0], -c * q[1]], c, 3.0 * c * inverse)
    };
    let quarter = 0.25 * dt * dt;
    let (mut a, ..) = force(q);
    for _ in 0..steps {
        let known = [0, 1].map(|i| q[i] + dt * v[i] + quarter * a[i]);
        let mut end = [0, 1].map(|i| known[i] + quarter * a[i]);
        let new = loop {
            let (f, c, d) = force(end);
            let r = [0, 1].map(|i| known[i] + quarter * f[i] - end[i]);
            let xx = 1.0 + quarter * (c - d * end[0] * end[0]);
            let yy = 1.0 + quarter * (c - d * end[1] * end[1]);
            let xy = -quarter * d * end[0] * end[1];
            let inverse = 1.0 / (xx * yy - xy * xy);
            let step = [(yy * r[0] - xy * r[1]) * inverse, (xx * r[1] - xy * r[0]) * inverse];
            end = [end[0] + step[0], end[1] + step[1]];
            if step[0].abs() + step[1].abs() < 1e-13 {
                break f;
            }
        };
        v = [0, 1].map(|i| v[i] + 0.5 * dt * (a[i] + new[i]));
        (q, a) = (end, new);
    }
    *state = Plane { q, v };
}

#[inline(never)]
fn pendulum(k: f64, dt: f64, x: &mut f64, v: &mut f64, steps: u64) {
    let (mut angle, mut rate) = (*x, *v);
    let k = k * dt;
    for _ in 0..steps {
        angle = fma(dt, rate, angle);
        rate = fma(-k, angle.sin(), rate);
    }
    (*x, *v) = (angle, rate);
}

fn plane(start: State<2>, step: impl Fn(&mut Plane, u64) + 'static) -> Loop {
    let mut state = black_box(Plane { q: start.q, v: start.v });
    Box::new(move |steps| {
        step(&mut state, steps);
        state.q[0]
    })
}

pub(super) fn kepler_leapfrog(gm: f64, start: State<2>, dt: f64) -> Loop {
    let (gm, dt) = (black_box(gm), black_box(dt));
    plane(start, move |state, steps| leapfrog(gm, dt, state, steps))
}

pub(super) fn kepler_leapfrog_naive(gm: f64, start: State<2>, dt: f64) -> Loop {
    let (gm, dt) = (black_box(gm), black_box(dt));
    plane(start, move |state, steps| leapfrog_naive(gm, dt, state, steps))
}

pub(super) fn kepler_trapezoid(gm: f64, start: State<2>, dt: f64) -> Loop {
    let (gm, dt) = (black_box(gm), black_box(dt));
    plane(start, move |state, steps| trapezoid(gm, dt, state, steps))
}

pub(super) fn pendulum_leapfrog(k: f64, start: State<1>, dt: f64) -> Loop {
    let (k, dt) = (black_box(k), black_box(dt));
    let (mut x, mut v) = black_box((start.q[0], start.v[0]));
    Box::new(move |steps| {
        pendulum(k, dt, &mut x, &mut v, steps);
        x
    })
}
