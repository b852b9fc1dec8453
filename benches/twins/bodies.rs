//! Leap-frog of gravitating bodies in space, direct sum, by hand: −g mₐ m_b / r between every two.
//!
//! The step is q += h v, v += h a(q) (half a step of either at the ends of a run is left out). All loops keep
//! x, y, z, the masses and the accelerations in arrays of their own and form 1/r³ as √s·(1/s²), s = r².

use std::hint::black_box;
use std::ops::Range;

use wide::f64x8;

use super::Loop;
use super::parallel::Chunks;

/// Lanes per register; the number of bodies is a multiple of it, so that no loop needs a remainder.
const W: usize = 8;

/// a b + c, fused where the target has the instruction.
#[inline(always)]
fn fma(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_feature = "fma") { a.mul_add(b, c) } else { a * b + c }
}

/// Bodies in a unit cube, one in each cell of a lattice and off its centre, of different masses, at rest.
struct Bodies {
    gm: Vec<f64>,
    q: [Vec<f64>; 3],
    v: [Vec<f64>; 3],
    a: [Vec<f64>; 3],
}

impl Bodies {
    fn cube(n: usize) -> Self {
        let side = (n as f64).cbrt().ceil() as usize;
        let mut seed = 1u64;
        let mut uniform = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        let zeros = || [vec![0.0; n], vec![0.0; n], vec![0.0; n]];
        let mut bodies = Self { gm: vec![0.0; n], q: zeros(), v: zeros(), a: zeros() };
        for i in 0..n {
            bodies.gm[i] = (0.5 + uniform()) / n as f64;
            let cell = [i % side, i / side % side, i / (side * side)];
            for (q, k) in bodies.q.iter_mut().zip(cell) {
                q[i] = (k as f64 + 0.2 + 0.6 * uniform()) / side as f64;
            }
        }
        bodies
    }
}

/// Every pair once, one at a time.
#[inline(never)]
fn scalar(bodies: &mut Bodies) {
    let Bodies { gm, q: [x, y, z], a: [ax, ay, az], .. } = bodies;
    let n = gm.len();
    let (x, y, z, ax, ay, az) = (&x[..n], &y[..n], &z[..n], &mut ax[..n], &mut ay[..n], &mut az[..n]);
    for a in [&mut *ax, &mut *ay, &mut *az] {
        a.fill(0.0);
    }
    for i in 0..n {
        let (xi, yi, zi, gmi) = (x[i], y[i], z[i], gm[i]);
        let (mut sx, mut sy, mut sz) = (0.0, 0.0, 0.0);
        for j in i + 1..n {
            let (dx, dy, dz) = (x[j] - xi, y[j] - yi, z[j] - zi);
            let s = fma(dz, dz, fma(dy, dy, dx * dx));
            let c = s.sqrt() * (1.0 / (s * s));
            let (ci, cj) = (c * gm[j], -c * gmi);
            sx = fma(ci, dx, sx);
            sy = fma(ci, dy, sy);
            sz = fma(ci, dz, sz);
            ax[j] = fma(cj, dx, ax[j]);
            ay[j] = fma(cj, dy, ay[j]);
            az[j] = fma(cj, dz, az[j]);
        }
        ax[i] += sx;
        ay[i] += sy;
        az[i] += sz;
    }
}

/// q += h v, a(q), v += h a.
#[inline(always)]
fn leapfrog(bodies: &mut Bodies, dt: f64, steps: u64, accelerate: impl Fn(&mut Bodies)) {
    for _ in 0..steps {
        for (q, v) in bodies.q.iter_mut().zip(&bodies.v) {
            for (q, v) in q.iter_mut().zip(v) {
                *q = fma(dt, *v, *q);
            }
        }
        accelerate(bodies);
        for (v, a) in bodies.v.iter_mut().zip(&bodies.a) {
            for (v, a) in v.iter_mut().zip(a) {
                *v = fma(dt, *a, *v);
            }
        }
    }
}

/// The same bodies, eight to a register: aligned, unlike the memory of a `Vec<f64>`.
pub(super) struct Registers {
    pub(super) gm: Vec<f64x8>,
    pub(super) q: [Vec<f64x8>; 3],
    v: [Vec<f64x8>; 3],
    pub(super) a: [Vec<f64x8>; 3],
}

impl Registers {
    fn new(bodies: &Bodies) -> Self {
        let pack = |x: &Vec<f64>| x.as_chunks::<W>().0.iter().map(|x| f64x8::new(*x)).collect::<Vec<_>>();
        let pack3 = |x: &[Vec<f64>; 3]| [pack(&x[0]), pack(&x[1]), pack(&x[2])];
        Self { gm: pack(&bodies.gm), q: pack3(&bodies.q), v: pack3(&bodies.v), a: pack3(&bodies.a) }
    }
}

const ZERO: f64x8 = f64x8::splat(0.0);
const ONE: f64x8 = f64x8::splat(1.0);

/// x in every lane.
#[inline(always)]
fn all(x: f64) -> f64x8 {
    f64x8::splat(x)
}

/// r² of eight separations.
#[inline(always)]
fn square([dx, dy, dz]: [f64x8; 3]) -> f64x8 {
    dz.mul_add(dz, dy.mul_add(dy, dx * dx))
}

/// 1/r³, where s = r².
#[inline(always)]
fn inverse_cube(s: f64x8) -> f64x8 {
    s.sqrt() * (ONE / (s * s))
}

/// The lanes above k.
fn above(k: usize) -> f64x8 {
    f64x8::new(std::array::from_fn(|lane| lane as f64)).simd_gt(all(k as f64))
}

/// Every pair of a body i in the given blocks with a later j, once: one i against eight j; what j feels is added to its
/// array. Arrays of accelerations begin with the first of the blocks.
///
/// The root and the division fill the time: two or four bodies i against eight j, which load and store j less often, are no
/// faster (0.47 ms with AVX-512, all three; 1.42 and 1.43 ms instead of 1.32 with SSE2).
#[inline(never)]
pub(super) fn rows(gm: &[f64x8], q: &[Vec<f64x8>; 3], own: Range<usize>, a: &mut [Vec<f64x8>; 3]) {
    let n = gm.len() - own.start;
    let [gm, x, y, z] = [gm, &q[0], &q[1], &q[2]].map(|of| &of[own.start..][..n]);
    let [ax, ay, az] = a.each_mut().map(|a| &mut a[..n]);
    for a in [&mut *ax, &mut *ay, &mut *az] {
        a.fill(ZERO);
    }
    for block in 0..own.len() {
        for k in 0..W {
            let [xi, yi, zi, gmi] = [x, y, z, gm].map(|of| all(of[block].as_array()[k]));
            // The block of i itself: only the lanes after it.
            let later = above(k);
            let [dx, dy, dz] = [x[block] - xi, y[block] - yi, z[block] - zi];
            let s = later.select(square([dx, dy, dz]), ONE);
            let c = later.select(inverse_cube(s), ZERO);
            let (ci, cj) = (c * gm[block], c * gmi);
            let (mut sx, mut sy, mut sz) = (ci * dx, ci * dy, ci * dz);
            ax[block] = cj.mul_neg_add(dx, ax[block]);
            ay[block] = cj.mul_neg_add(dy, ay[block]);
            az[block] = cj.mul_neg_add(dz, az[block]);
            for j in block + 1..n {
                let [dx, dy, dz] = [x[j] - xi, y[j] - yi, z[j] - zi];
                let c = inverse_cube(square([dx, dy, dz]));
                let (ci, cj) = (c * gm[j], c * gmi);
                sx = ci.mul_add(dx, sx);
                sy = ci.mul_add(dy, sy);
                sz = ci.mul_add(dz, sz);
                ax[j] = cj.mul_neg_add(dx, ax[j]);
                ay[j] = cj.mul_neg_add(dy, ay[j]);
                az[j] = cj.mul_neg_add(dz, az[j]);
            }
            ax[block].as_mut_array()[k] += sx.reduce_add();
            ay[block].as_mut_array()[k] += sy.reduce_add();
            az[block].as_mut_array()[k] += sz.reduce_add();
        }
    }
}

fn third_law(bodies: &mut Registers) {
    let Registers { gm, q, a, .. } = bodies;
    rows(gm, q, 0..gm.len(), a);
}

/// Every pair twice: eight bodies i against one j; nothing is stored but the result.
#[inline(never)]
fn columns(bodies: &mut Registers) {
    let Registers { gm, q: [x, y, z], a: [ax, ay, az], .. } = bodies;
    let blocks = gm.len();
    let (x, y, z) = (&x[..blocks], &y[..blocks], &z[..blocks]);
    let (ax, ay, az) = (&mut ax[..blocks], &mut ay[..blocks], &mut az[..blocks]);
    for block in 0..blocks {
        let (xi, yi, zi) = (x[block], y[block], z[block]);
        let mut sum = [ZERO; 3];
        for j in 0..blocks {
            let (xj, yj, zj, gmj) = (x[j].as_array(), y[j].as_array(), z[j].as_array(), gm[j].as_array());
            if j == block {
                for k in 0..W {
                    let d = [all(xj[k]) - xi, all(yj[k]) - yi, all(zj[k]) - zi];
                    let s = square(d);
                    let itself = s.simd_eq(ZERO);
                    let c = itself.select(ZERO, inverse_cube(itself.select(ONE, s))) * all(gmj[k]);
                    for i in 0..3 {
                        sum[i] = c.mul_add(d[i], sum[i]);
                    }
                }
            } else {
                for k in 0..W {
                    let d = [all(xj[k]) - xi, all(yj[k]) - yi, all(zj[k]) - zi];
                    let c = inverse_cube(square(d)) * all(gmj[k]);
                    for i in 0..3 {
                        sum[i] = c.mul_add(d[i], sum[i]);
                    }
                }
            }
        }
        [ax[block], ay[block], az[block]] = sum;
    }
}

fn in_registers(n: usize, dt: f64, mut accelerate: impl FnMut(&mut Registers) + 'static) -> Loop {
    let mut bodies = black_box(Registers::new(&Bodies::cube(n)));
    let dt = all(black_box(dt));
    Box::new(move |steps| {
        for _ in 0..steps {
            for (q, v) in bodies.q.iter_mut().zip(&bodies.v) {
                for (q, v) in q.iter_mut().zip(v) {
                    *q = dt.mul_add(*v, *q);
                }
            }
            accelerate(&mut bodies);
            for (v, a) in bodies.v.iter_mut().zip(&bodies.a) {
                for (v, a) in v.iter_mut().zip(a) {
                    *v = dt.mul_add(*a, *v);
                }
            }
        }
        bodies.v[0].iter().map(|v| v.as_array()[3]).sum()
    })
}

/// The loops for n bodies, by name.
pub(super) fn loops(n: usize, dt: f64) -> Vec<(&'static str, Loop)> {
    let mut bodies = black_box(Bodies::cube(n));
    let plain: Loop = Box::new(move |steps| {
        leapfrog(&mut bodies, dt, steps, scalar);
        bodies.v[0].iter().skip(3).step_by(W).sum()
    });
    let mut chunks = Chunks::new(n / W);
    let start = Bodies::cube(n);
    let start: Vec<_> = (0..n).map(|i| (start.gm[i], core::array::from_fn(|k| start.q[k][i]))).collect();
    vec![
        ("twin: lanes, third law", in_registers(n, dt, third_law)),
        ("scene", super::own::gravity(&start, dt)),
        ("twin: lanes, every pair twice", in_registers(n, dt, columns)),
        ("twin: lanes, third law, all cores", in_registers(n, dt, move |bodies| chunks.accelerate(bodies))),
        ("twin: scalar, third law", plain),
    ]
}
