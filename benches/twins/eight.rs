//! Leap-frog of three bodies on the figure eight, by hand: q += h v, v += h a(q), unit masses, G = 1.
//!
//! Initial data: A. Chenciner, R. Montgomery, Ann. Math. 152 (2000) 881–901 (digits by C. Simó).

use std::hint::black_box;

use super::Loop;

const Q1: [f64; 2] = [0.97000436, -0.24308753];
const V3: [f64; 2] = [-0.93240737, -0.86473146];

/// a b + c, fused where the target has the instruction.
#[inline(always)]
fn fma(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_feature = "fma") { a.mul_add(b, c) } else { a * b + c }
}

/// x₁ y₁ x₂ y₂ x₃ y₃ and the velocities in the same order.
#[derive(Clone, Copy)]
struct Eight {
    q: [f64; 6],
    v: [f64; 6],
}

const START: Eight = Eight {
    q: [Q1[0], Q1[1], -Q1[0], -Q1[1], 0.0, 0.0],
    v: [-V3[0] / 2.0, -V3[1] / 2.0, -V3[0] / 2.0, -V3[1] / 2.0, V3[0], V3[1]],
};

/// h/r³ of one separation, by the two ways to write it.
#[inline(always)]
fn side_by_side(dt: f64, s: f64) -> f64 {
    s.sqrt() * (dt / (s * s))
}

#[inline(always)]
fn in_series(dt: f64, s: f64) -> f64 {
    dt / (s * s.sqrt())
}

#[inline(always)]
fn unrolled(state: &mut Eight, dt: f64, steps: u64, pair: impl Fn(f64, f64) -> f64) {
    let Eight {
        q: [mut x1, mut y1, mut x2, mut y2, mut x3, mut y3],
        v: [mut u1, mut v1, mut u2, mut v2, mut u3, mut v3],
    } = *state;
    for _ in 0..steps {
        x1 = fma(dt, u1, x1);
        y1 = fma(dt, v1, y1);
        x2 = fma(dt, u2, x2);
        y2 = fma(dt, v2, y2);
        x3 = fma(dt, u3, x3);
        y3 = fma(dt, v3, y3);
        let (dx12, dy12) = (x2 - x1, y2 - y1);
        let (dx13, dy13) = (x3 - x1, y3 - y1);
        let (dx23, dy23) = (x3 - x2, y3 - y2);
        let c12 = pair(dt, fma(dx12, dx12, dy12 * dy12));
        let c13 = pair(dt, fma(dx13, dx13, dy13 * dy13));
        let c23 = pair(dt, fma(dx23, dx23, dy23 * dy23));
        u1 = fma(c13, dx13, fma(c12, dx12, u1));
        v1 = fma(c13, dy13, fma(c12, dy12, v1));
        u2 = fma(c23, dx23, fma(-c12, dx12, u2));
        v2 = fma(c23, dy23, fma(-c12, dy12, v2));
        u3 = fma(-c23, dx23, fma(-c13, dx13, u3));
        v3 = fma(-c23, dy23, fma(-c13, dy13, v3));
    }
    *state = Eight { q: [x1, y1, x2, y2, x3, y3], v: [u1, v1, u2, v2, u3, v3] };
}

#[inline(never)]
fn three_roots(state: &mut Eight, dt: f64, steps: u64) {
    unrolled(state, dt, steps, side_by_side);
}

#[inline(never)]
fn three_roots_in_series(state: &mut Eight, dt: f64, steps: u64) {
    unrolled(state, dt, steps, in_series);
}

/// The loops, by name.
pub(super) fn loops(dt: f64) -> Vec<(&'static str, Loop)> {
    let run = |advance: fn(&mut Eight, f64, u64)| -> Loop {
        let (mut state, dt) = (black_box(START), black_box(dt));
        Box::new(move |steps| {
            advance(&mut state, dt, steps);
            state.q[0]
        })
    };
    vec![("twin: √s·(1/s²)", run(three_roots)), ("twin: 1/(s√s)", run(three_roots_in_series))]
}
