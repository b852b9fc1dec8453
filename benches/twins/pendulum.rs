//! Pendulums by hand: each loop has what its law has, and nothing else.

use std::hint::black_box;

use dmech::prelude::*;

use super::{Loop, fma};

/// v′ = v − h k sin q, q′ = q + h (v + v′)/2.
#[inline(never)]
fn explicit(k: f64, dt: f64, x: &mut f64, v: &mut f64, steps: u64) {
    let (mut angle, mut rate) = (*x, *v);
    let (k, half) = (k * dt, 0.5 * dt);
    for _ in 0..steps {
        let next = fma(-k, angle.sin(), rate);
        angle = fma(half, rate + next, angle);
        rate = next;
    }
    (*x, *v) = (angle, rate);
}

/// The same with friction: v′ = (1 − h α) v − h k sin q.
#[inline(never)]
fn damped_explicit((k, alpha): (f64, f64), dt: f64, x: &mut f64, v: &mut f64, steps: u64) {
    let (mut angle, mut rate) = (*x, *v);
    let (k, keep, half) = (k * dt, 1.0 - alpha * dt, 0.5 * dt);
    for _ in 0..steps {
        let next = fma(-k, angle.sin(), keep * rate);
        angle = fma(half, rate + next, angle);
        rate = next;
    }
    (*x, *v) = (angle, rate);
}

/// Newton on the increment, from a second-order guess, until corrections are below 10⁻¹³.
#[inline(never)]
fn trapezoid(k: f64, dt: f64, x: &mut f64, v: &mut f64, steps: u64) {
    let (mut angle, mut rate) = (*x, *v);
    let (quarter, half) = (0.25 * dt * dt, 0.5 * dt);
    let mut a = -k * angle.sin();
    for _ in 0..steps {
        let known = fma(dt, rate, quarter * a);
        let mut delta = fma(quarter, a, known);
        let new = loop {
            let (sin, cos) = (angle + delta).sin_cos();
            let f = -k * sin;
            let step = (fma(quarter, f, known) - delta) / fma(quarter * k, cos, 1.0);
            delta += step;
            if step.abs() < 1e-13 {
                break f;
            }
        };
        rate = fma(half, a + new, rate);
        angle += delta;
        a = new;
    }
    (*x, *v) = (angle, rate);
}

/// The same with friction at the velocity that belongs to the increment, v′ = v + (2/h)(Δ − h v).
#[inline(never)]
fn damped_trapezoid((k, alpha): (f64, f64), dt: f64, x: &mut f64, v: &mut f64, steps: u64) {
    let (mut angle, mut rate) = (*x, *v);
    let (quarter, half, back) = (0.25 * dt * dt, 0.5 * dt, 2.0 / dt);
    let stiff = fma(quarter * alpha, back, 1.0);
    let mut a = fma(-k, angle.sin(), -alpha * rate);
    for _ in 0..steps {
        let known = fma(dt, rate, quarter * a);
        let mut delta = fma(quarter, a, known);
        let new = loop {
            let (sin, cos) = (angle + delta).sin_cos();
            let f = fma(-k, sin, -alpha * fma(back, delta, -rate));
            let step = (fma(quarter, f, known) - delta) / fma(quarter * k, cos, stiff);
            delta += step;
            if step.abs() < 1e-13 {
                break f;
            }
        };
        rate = fma(half, a + new, rate);
        angle += delta;
        a = new;
    }
    (*x, *v) = (angle, rate);
}

fn swing<P: Copy + 'static>(law: P, start: State<1>, dt: f64, run: fn(P, f64, &mut f64, &mut f64, u64)) -> Loop {
    let (law, dt) = (black_box(law), black_box(dt));
    let (mut x, mut v) = black_box((start.q[0], start.v[0]));
    Box::new(move |steps| {
        run(law, dt, &mut x, &mut v, steps);
        x
    })
}

pub(crate) fn pendulum_explicit(k: f64, start: State<1>, dt: f64) -> Loop {
    swing(k, start, dt, explicit)
}

pub(crate) fn pendulum_trapezoid(k: f64, start: State<1>, dt: f64) -> Loop {
    swing(k, start, dt, trapezoid)
}

pub(crate) fn damped_pendulum_explicit(law: (f64, f64), start: State<1>, dt: f64) -> Loop {
    swing(law, start, dt, damped_explicit)
}

pub(crate) fn damped_pendulum_trapezoid(law: (f64, f64), start: State<1>, dt: f64) -> Loop {
    swing(law, start, dt, damped_trapezoid)
}
