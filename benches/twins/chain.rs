//! Leap-frog of a Fermi–Pasta–Ulam–Tsingou chain, by hand: bonds with V(d) = k d²/2 + β d⁴/4, d = qᵢ₊₁ − qᵢ, unit masses,
//! both ends fixed at 0.
//!
//! With F(d) = k d + β d³ the step is q += h v, vᵢ += h (F(qᵢ₊₁ − qᵢ) − F(qᵢ − qᵢ₋₁)).

use std::hint::black_box;

use wide::f64x8;

use super::Loop;

/// Lanes per register; the number of moving bodies is a multiple of it.
const W: usize = 8;

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

/// Positions with the two fixed ends, velocities, and the impulse of each bond.
struct Chain {
    q: Vec<f64>,
    v: Vec<f64>,
    impulse: Vec<f64>,
}

impl Chain {
    fn new(n: usize) -> Self {
        let mut q = start(n);
        q.insert(0, 0.0);
        q.push(0.0);
        Self { q, v: vec![0.0; n], impulse: vec![0.0; n + 1] }
    }
}

/// One loop over the bodies that carries the last bond's impulse along.
#[inline(never)]
fn carried(chain: &mut Chain, bond: Bond, dt: f64, steps: u64) {
    let Chain { q, v, .. } = chain;
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
    let Chain { q, v, .. } = chain;
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

/// The impulses are stored in an array of their own; kick and drift are one loop.
#[inline(never)]
fn stored(chain: &mut Chain, bond: Bond, dt: f64, steps: u64) {
    let Chain { q, v, impulse } = chain;
    let n = v.len();
    let (q, impulse) = (&mut q[..n + 2], &mut impulse[..n + 1]);
    for step in 0..=steps {
        if step > 0 {
            for i in 0..=n {
                impulse[i] = bond.impulse(q[i + 1] - q[i]);
            }
        }
        // The first drift and the last kick have a loop of their own.
        if step == 0 {
            for i in 0..n {
                q[i + 1] = fma(dt, v[i], q[i + 1]);
            }
        } else if step < steps {
            for i in 0..n {
                v[i] += impulse[i + 1] - impulse[i];
                q[i + 1] = fma(dt, v[i], q[i + 1]);
            }
        } else {
            for i in 0..n {
                v[i] += impulse[i + 1] - impulse[i];
            }
        }
    }
}

/// Eight bodies to a register; the neighbour's lanes come by a shift of registers, not by a load that straddles two
/// cache lines. One pass does the drift of a block and the kick of the block before it.
struct Registers {
    q: Vec<f64x8>,
    v: Vec<f64x8>,
}

/// Lanes 1–7 of the first and lane 0 of the second.
#[inline(always)]
fn next(a: f64x8, b: f64x8) -> f64x8 {
    let ([_, a1, a2, a3, a4, a5, a6, a7], b) = (a.to_array(), b.to_array());
    f64x8::new([a1, a2, a3, a4, a5, a6, a7, b[0]])
}

/// Lane 7 of the first and lanes 0–6 of the second.
#[inline(always)]
fn previous(a: f64x8, b: f64x8) -> f64x8 {
    let (a, [b0, b1, b2, b3, b4, b5, b6, _]) = (a.to_array(), b.to_array());
    f64x8::new([a[7], b0, b1, b2, b3, b4, b5, b6])
}

#[inline(never)]
fn shifted(chain: &mut Registers, bond: Bond, dt: f64, steps: u64) {
    let Registers { q, v } = chain;
    let blocks = q.len();
    let v = &mut v[..blocks];
    let [k, beta, dt] = [bond.k, bond.beta, dt].map(f64x8::splat);
    // Impulse of the bonds to the right of eight bodies.
    let impulse = |here: f64x8, beyond: f64x8| {
        let d = next(here, beyond) - here;
        d * beta.mul_add(d * d, k)
    };
    for _ in 0..steps {
        let mut here = dt.mul_add(v[0], q[0]);
        q[0] = here;
        let mut left = {
            let d = here.as_array()[0];
            f64x8::splat(bond.impulse(d))
        };
        for b in 1..blocks {
            let beyond = dt.mul_add(v[b], q[b]);
            q[b] = beyond;
            let right = impulse(here, beyond);
            v[b - 1] += right - previous(left, right);
            (here, left) = (beyond, right);
        }
        let right = impulse(here, f64x8::splat(0.0));
        v[blocks - 1] += right - previous(left, right);
    }
}

/// The loops for n moving bodies, by name.
pub(super) fn loops(n: usize, k: f64, beta: f64, dt: f64) -> Vec<(&'static str, Loop)> {
    let dt = black_box(dt);
    let bond = black_box(Bond { k: dt * k, beta: dt * beta });
    let plain = |advance: fn(&mut Chain, Bond, f64, u64)| -> Loop {
        let mut chain = black_box(Chain::new(n));
        Box::new(move |steps| {
            advance(&mut chain, bond, dt, steps);
            chain.v[n / 2]
        })
    };
    let pack = |x: &[f64]| x.as_chunks::<W>().0.iter().map(|x| f64x8::new(*x)).collect::<Vec<_>>();
    let mut registers = black_box(Registers { q: pack(&start(n)), v: pack(&vec![0.0; n]) });
    let by_hand: Loop = Box::new(move |steps| {
        shifted(&mut registers, bond, dt, steps);
        registers.v[n / 2 / W].as_array()[n / 2 % W]
    });
    vec![
        ("twin: lanes, shifted registers", by_hand),
        ("twin: plain, impulses stored", plain(stored)),
        ("twin: plain, impulses twice", plain(twice)),
        ("twin: plain, impulse carried", plain(carried)),
    ]
}
