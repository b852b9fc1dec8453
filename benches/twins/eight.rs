//! Leap-frog of three bodies on the figure eight, by hand: q += h v, v += h a(q), unit masses, G = 1.
//!
//! Initial data: A. Chenciner, R. Montgomery, Ann. Math. 152 (2000) 881–901 (digits by C. Simó).

use std::hint::black_box;

use wide::f64x4;

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

/// x₁ x₂ x₃ and the same for y and the velocities: the three separations are one register, 1 → 2, 2 → 3, 3 → 1. The fourth
/// lane is a second copy of body 2, so that no lane divides by zero.
#[inline(never)]
fn one_register(state: &mut Eight, dt: f64, steps: u64) {
    let pack = |a: &[f64; 6], i: usize| f64x4::new([a[i], a[2 + i], a[4 + i], a[2 + i]]);
    let [mut x, mut y] = [0, 1].map(|i| pack(&state.q, i));
    let [mut u, mut v] = [0, 1].map(|i| pack(&state.v, i));
    let dt = f64x4::splat(dt);
    for _ in 0..steps {
        x = dt.mul_add(u, x);
        y = dt.mul_add(v, y);
        let (dx, dy) = (onward(x) - x, onward(y) - y);
        let s = dx.mul_add(dx, dy * dy);
        let c = s.sqrt() * (dt / (s * s));
        let (fx, fy) = (c * dx, c * dy);
        u = (u + fx) - back(fx);
        v = (v + fy) - back(fy);
    }
    let [x, y, u, v] = [x, y, u, v].map(f64x4::to_array);
    *state = Eight { q: [x[0], y[0], x[1], y[1], x[2], y[2]], v: [u[0], v[0], u[1], v[1], u[2], v[2]] };
}

/// The body at the other end of each separation.
#[inline(always)]
fn onward(a: f64x4) -> f64x4 {
    let a = a.to_array();
    f64x4::new([a[1], a[2], a[0], a[2]])
}

/// The force of the separation that ends at each body.
#[inline(always)]
fn back(a: f64x4) -> f64x4 {
    let a = a.to_array();
    f64x4::new([a[2], a[0], a[1], a[0]])
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
    let [unrolled, scene] = super::own::eight(START.q, START.v, dt);
    vec![
        ("law of six coordinates", unrolled),
        ("scene", scene),
        ("twin: √s·(1/s²)", run(three_roots)),
        ("twin: 1/(s√s)", run(three_roots_in_series)),
        ("twin: one register of three pairs", run(one_register)),
    ]
}
