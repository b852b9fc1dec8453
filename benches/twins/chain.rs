//! Leap-frog of a Fermi–Pasta–Ulam–Tsingou chain, by hand: bonds with V(d) = k d²/2 + β d⁴/4, d = qᵢ₊₁ − qᵢ, unit masses,
//! both ends fixed at 0.
//!
//! The compiler makes registers of these loops, and splices the carried impulse of one into the next. Shifting registers
//! by hand took 0.27 ns a body with AVX-512, where `kick_and_drift` takes 0.20, and three times as long with SSE2.
//! Arrays begin at a multiple of 64 bytes: 16 bytes further on, where a `Vec` may begin, the loop takes 0.26 ns.
//!
//! With F(d) = k d + β d³ the step is q += h v, vᵢ += h (F(qᵢ₊₁ − qᵢ) − F(qᵢ − qᵢ₋₁)).

use std::hint::black_box;

use dmech::prelude::*;

use super::Loop;

/// a b + c, fused where the target has the instruction.
#[inline(always)]
fn fma(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_feature = "fma") { a.mul_add(b, c) } else { a * b + c }
}

/// h k and h β: the impulse of a bond in one step is F(d) with these.
#[derive(Clone, Copy)]
struct Bond {
    k: f64,
    beta: f64,
}

impl Bond {
    #[inline(always)]
    fn impulse(self, d: f64) -> f64 {
        d * fma(self.beta, d * d, self.k)
    }
}

/// The start: the first three modes of n moving bodies.
fn start(n: usize) -> Vec<f64> {
    let mode = |i: usize, k: f64| (std::f64::consts::PI * k * (i + 1) as f64 / (n + 1) as f64).sin();
    (0..n).map(|i| 0.7 * mode(i, 1.0) + 0.3 * mode(i, 2.0) - 0.2 * mode(i, 3.0)).collect()
}

/// Room after each array. Two arrays of 8 kB one behind the other would be a few numbers apart modulo 4 kB, and a load seems
/// to depend on every recent store with the same address modulo 4 kB: 0.25 ns a body, not 0.20, and up to 0.41 when carried.
const APART: usize = 64;

/// Numbers of which the one at `first` lies at a multiple of 64 bytes.
struct Aligned {
    memory: Vec<f64>,
    offset: usize,
    length: usize,
}

impl Aligned {
    fn new(numbers: &[f64], first: usize) -> Self {
        let mut memory = vec![0.0; numbers.len() + 16 + APART];
        let offset = memory.as_ptr().align_offset(64).min(8) + 8 - first;
        memory[offset..offset + numbers.len()].copy_from_slice(numbers);
        Self { memory, offset, length: numbers.len() }
    }

    #[inline(always)]
    fn slice(&mut self) -> &mut [f64] {
        &mut self.memory[self.offset..self.offset + self.length]
    }
}

/// Positions with the two fixed ends, and velocities.
struct Chain {
    q: Aligned,
    v: Aligned,
}

impl Chain {
    fn new(n: usize) -> Self {
        let mut q = start(n);
        q.insert(0, 0.0);
        q.push(0.0);
        Self { q: Aligned::new(&q, 1), v: Aligned::new(&vec![0.0; n], 0) }
    }
}

/// One loop over the bodies that carries the last bond's impulse along.
#[inline(never)]
fn carried(chain: &mut Chain, bond: Bond, dt: f64, steps: u64) {
    let (q, v) = (chain.q.slice(), chain.v.slice());
    let n = v.len();
    let q = &mut q[..n + 2];
    for _ in 0..steps {
        for (q, v) in q[1..=n].iter_mut().zip(&*v) {
            *q = fma(dt, *v, *q);
        }
        let mut left = bond.impulse(q[1] - q[0]);
        for i in 0..n {
            let right = bond.impulse(q[i + 2] - q[i + 1]);
            v[i] += right - left;
            left = right;
        }
    }
}

/// Each bond's impulse is computed twice; the loop over the bodies has no chain.
#[inline(never)]
fn twice(chain: &mut Chain, bond: Bond, dt: f64, steps: u64) {
    let (q, v) = (chain.q.slice(), chain.v.slice());
    let n = v.len();
    let q = &mut q[..n + 2];
    for _ in 0..steps {
        for (q, v) in q[1..=n].iter_mut().zip(&*v) {
            *q = fma(dt, *v, *q);
        }
        for i in 0..n {
            v[i] += bond.impulse(q[i + 2] - q[i + 1]) - bond.impulse(q[i + 1] - q[i]);
        }
    }
}

/// As `carried`, and the drift of the next step in the same loop: body i is not read again once it is kicked. Two passes
/// over memory become one; the first drift and the last kick stand outside.
#[inline(never)]
fn kick_and_drift(chain: &mut Chain, bond: Bond, dt: f64, steps: u64) {
    let (q, v) = (chain.q.slice(), chain.v.slice());
    let n = v.len();
    let q = &mut q[..n + 2];
    if steps == 0 {
        return;
    }
    for (q, v) in q[1..=n].iter_mut().zip(&*v) {
        *q = fma(dt, *v, *q);
    }
    for _ in 1..steps {
        let mut left = bond.impulse(q[1] - q[0]);
        for i in 0..n {
            let right = bond.impulse(q[i + 2] - q[i + 1]);
            v[i] += right - left;
            q[i + 1] = fma(dt, v[i], q[i + 1]);
            left = right;
        }
    }
    let mut left = bond.impulse(q[1] - q[0]);
    for i in 0..n {
        let right = bond.impulse(q[i + 2] - q[i + 1]);
        v[i] += right - left;
        left = right;
    }
}

/// The implicit schemes on a chain of n moving bodies: what a body costs must not depend on n.
pub(super) fn implicit(n: usize, k: f64, beta: f64, dt: f64) -> Vec<(&'static str, Loop)> {
    vec![
        ("scene, Implicit", super::own::chain(Implicit, &start(n), k, beta, dt)),
        ("scene, DiscreteGradient", super::own::chain(DiscreteGradient, &start(n), k, beta, dt)),
        ("scene, Kanatani", super::own::chain(Kanatani, &start(n), k, beta, dt)),
    ]
}

/// The loops for n moving bodies, by name.
pub(super) fn loops(n: usize, k: f64, beta: f64, dt: f64) -> Vec<(&'static str, Loop)> {
    let step = dt;
    let dt = black_box(dt);
    let bond = black_box(Bond { k: dt * k, beta: dt * beta });
    let plain = |advance: fn(&mut Chain, Bond, f64, u64)| -> Loop {
        let mut chain = black_box(Chain::new(n));
        Box::new(move |steps| {
            advance(&mut chain, bond, dt, steps);
            chain.v.slice()[n / 2]
        })
    };
    vec![
        ("twin: kick and drift at once", plain(kick_and_drift)),
        ("twin: impulse carried", plain(carried)),
        ("twin: impulses twice", plain(twice)),
        ("scene", super::own::chain(Leapfrog, &start(n), k, beta, step)),
    ]
}
