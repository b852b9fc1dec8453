//! The loops over links that add up gradients: in lanes where bodies are consecutive.

use core::ops::Range;

use dmech_scalar::Lanes;

use super::numbers::NumberColumns;
use super::packed::Packed;
use super::separation::separations;
use super::stencil::Stencil;
use crate::law::Numbers;
use crate::scene::acting::Group;
use crate::scene::vectors::Vectors;
use crate::vector::scaled;

/// The gradient along a link at S moments: one for ∇Φ(d), two for ∇̄Φ(d, d′).
pub trait Kernel<const D: usize, const S: usize, N: Numbers, R: Packed>: Copy + Sync {
    /// How many of the moments are separations of bodies; the others are vectors beside them.
    const PLACES: usize = S;

    /// With respect to d = q_a − q_b, for the numbers of a and b.
    fn gradient(&self, a: N::Of<R>, b: N::Of<R>, d: [[R; D]; S]) -> [R; D];
    /// Its derivative with respect to the last d.
    fn jacobian(&self, a: N::Of<R>, b: N::Of<R>, d: [[R; D]; S]) -> [[R; D]; D];
}

/// One at a time and eight at a time.
pub trait Kernels<const D: usize, const S: usize, N: Numbers>: Kernel<D, S, N, f64> + Kernel<D, S, N, Lanes> {}

impl<K: Kernel<D, S, N, f64> + Kernel<D, S, N, Lanes>, const D: usize, const S: usize, N: Numbers> Kernels<D, S, N>
    for K
{
}

/// The columns of the positions at S moments.
pub(super) type Positions<'a, const D: usize, const S: usize> = [[&'a [f64]; D]; S];

/// q_a − q_b at each moment, for each b of the lanes.
#[inline(always)]
fn from_one<const D: usize, const S: usize, R: Packed>(q: &Positions<'_, D, S>, a: usize, b: usize) -> [[R; D]; S] {
    each(|moment, k| R::from_f64(q[moment][k][a]) - R::load(q[moment][k], b))
}

/// A component of each separation at each moment. Loops, as nested `map`s of arrays are not inlined.
#[inline(always)]
fn each<const D: usize, const S: usize, R: Packed>(component: impl Fn(usize, usize) -> R) -> [[R; D]; S] {
    let mut d = [[R::ZERO; D]; S];
    for moment in 0..S {
        for k in 0..D {
            d[moment][k] = component(moment, k);
        }
    }
    d
}

/// One link.
#[inline(always)]
pub(super) fn link<const D: usize, const S: usize, N: Numbers>(
    kernel: &impl Kernels<D, S, N>,
    q: [&Vectors<D>; S],
    numbers: &NumberColumns<N>,
    a: usize,
    b: usize,
    out: &mut Vectors<D>,
) {
    let gradient: [f64; D] = kernel.gradient(numbers.at(a), numbers.at(b), separations(q, a, b));
    out.add(a, gradient);
    out.add(b, scaled(-1.0, gradient));
}

/// The rows a ∈ `rows` of the triangle a < b, each pair once: one a against eight b, from the block after that of a on.
///
/// Column k of `out` begins with body `rows.start`.
pub(super) fn triangle<const D: usize, const S: usize, N: Numbers>(
    kernel: &impl Kernels<D, S, N>,
    q: &Positions<'_, D, S>,
    numbers: &NumberColumns<N>,
    rows: Range<usize>,
    mut out: [&mut [f64]; D],
) {
    let (start, bodies) = (rows.start, numbers.bodies());
    for a in rows {
        let on_a = row(kernel, q, numbers, a, a + 1..bodies, start, &mut out);
        for k in 0..D {
            out[k][a - start] += on_a[k];
        }
    }
}

/// The same where some bodies act and the others only feel: `groups` of consecutive bodies of one kind are together all.
pub(super) fn one_sided<const D: usize, const S: usize, N: Numbers>(
    kernel: &impl Kernels<D, S, N>,
    q: &Positions<'_, D, S>,
    numbers: &NumberColumns<N>,
    groups: &[Group],
    mut out: [&mut [f64]; D],
) {
    for a in groups.iter().filter(|group| group.acts).flat_map(|group| group.bodies.clone()) {
        for Group { bodies, acts } in groups {
            let others = if *acts { bodies.start.max(a + 1)..bodies.end } else { bodies.clone() };
            if others.is_empty() {
                continue;
            }
            let on_a = row(kernel, q, numbers, a, others, 0, &mut out);
            if *acts {
                for k in 0..D {
                    out[k][a] += on_a[k];
                }
            }
        }
    }
}

/// Body a against a range of others: what they feel goes to `out`, whose columns begin with body `start`; what a feels comes
/// back.
#[inline(always)]
fn row<const D: usize, const S: usize, N: Numbers>(
    kernel: &impl Kernels<D, S, N>,
    q: &Positions<'_, D, S>,
    numbers: &NumberColumns<N>,
    a: usize,
    others: Range<usize>,
    start: usize,
    out: &mut [&mut [f64]; D],
) -> [f64; D] {
    // Blocks begin at multiples of the number of lanes; what is before the first and after the last goes singly.
    let first = others.start.next_multiple_of(Lanes::COUNT).min(others.end);
    let last = first + (others.end - first) / Lanes::COUNT * Lanes::COUNT;
    let mut on_a = [0.0; D];
    for b in (others.start..first).chain(last..others.end) {
        let gradient: [f64; D] = kernel.gradient(numbers.at(a), numbers.at(b), from_one(q, a, b));
        for k in 0..D {
            on_a[k] += gradient[k];
            out[k][b - start] -= gradient[k];
        }
    }
    let numbers_of_a = numbers.at::<Lanes>(a);
    let mut sums = [Lanes::splat(0.0); D];
    for b in (first..last).step_by(Lanes::COUNT) {
        let gradient: [Lanes; D] = kernel.gradient(numbers_of_a, numbers.load(b), from_one(q, a, b));
        for k in 0..D {
            sums[k] += gradient[k];
            (-gradient[k]).add_to(out[k], b - start);
        }
    }
    for k in 0..D {
        on_a[k] += sums[k].sum();
    }
    on_a
}

/// Consecutive bodies: G_j = g_j − g_{j−1}, with g_j of the link between j and j + 1, goes where `sink` puts it.
///
/// The kernel comes by value: of a reference in an argument it is known that nothing written here changes what it refers to, so
/// that numbers of the law stay in registers.
pub(super) fn chain<const D: usize, const S: usize, N: Numbers>(
    kernel: impl Kernels<D, S, N>,
    numbers: &NumberColumns<N>,
    mut sink: impl Sink<D, S>,
) {
    let bodies = numbers.bodies();
    let links = bodies.saturating_sub(1);
    let blocks = links - links % Lanes::COUNT;
    // The register before: its last number is the gradient of the link before.
    let mut before = [Lanes::splat(0.0); D];
    for j in (0..blocks).step_by(Lanes::COUNT) {
        let gradient: [Lanes; D] = neighbours(&kernel, &sink.q(), numbers, j);
        for k in 0..D {
            sink.put(k, j, gradient[k] - gradient[k].following(before[k]));
        }
        before = gradient;
    }
    let mut last = before.map(Lanes::last);
    for j in blocks..links {
        let gradient: [f64; D] = neighbours(&kernel, &sink.q(), numbers, j);
        for k in 0..D {
            sink.put(k, j, gradient[k] - last[k]);
        }
        last = gradient;
    }
    for k in 0..if bodies > 0 { D } else { 0 } {
        sink.put(k, links, 0.0 - last[k]);
    }
}

/// Where a chain is, and where its gradient goes.
pub trait Sink<const D: usize, const S: usize> {
    /// The columns of the positions.
    fn q(&self) -> Positions<'_, D, S>;
    /// Component k of the gradient at body j, or at so many from j on. Where the bodies before those are is not asked for again.
    fn put<R: Packed>(&mut self, k: usize, j: usize, gradient: R);
}

/// Into columns, in place of what is there or to be added to it.
pub(super) struct Gradient<'a, const D: usize, const S: usize, const SET: bool> {
    pub(super) q: Positions<'a, D, S>,
    pub(super) out: [&'a mut [f64]; D],
}

impl<const D: usize, const S: usize, const SET: bool> Sink<D, S> for Gradient<'_, D, S, SET> {
    #[inline(always)]
    fn q(&self) -> Positions<'_, D, S> {
        self.q
    }

    #[inline(always)]
    fn put<R: Packed>(&mut self, k: usize, j: usize, gradient: R) {
        if SET { gradient.store(self.out[k], j) } else { gradient.add_to(self.out[k], j) }
    }
}

/// At once into velocities: `to` ← v − b (h/m) G.
#[derive(Debug)]
pub struct Kicked<'a, const D: usize> {
    /// b.
    pub b: f64,
    /// h/m for each coordinate.
    pub kick: [&'a [f64]; D],
    /// v.
    pub v: [&'a [f64]; D],
    /// Where it goes.
    pub to: [&'a mut [f64]; D],
}

impl<const D: usize> Kicked<'_, D> {
    #[inline(always)]
    fn by<R: Packed>(&mut self, k: usize, j: usize, gradient: R) -> R {
        let next = R::load(self.v[k], j) - R::from_f64(self.b) * R::load(self.kick[k], j) * gradient;
        next.store(self.to[k], j);
        next
    }
}

/// Velocities of bodies that stay where they are.
pub(super) struct Staying<'a, const D: usize> {
    pub(super) q: [&'a [f64]; D],
    pub(super) kicked: Kicked<'a, D>,
}

impl<const D: usize> Sink<D, 1> for Staying<'_, D> {
    #[inline(always)]
    fn q(&self) -> Positions<'_, D, 1> {
        [self.q]
    }

    #[inline(always)]
    fn put<R: Packed>(&mut self, k: usize, j: usize, gradient: R) {
        self.kicked.by(k, j, gradient);
    }
}

/// Velocities, and at once positions: q += a v′.
pub(super) struct Drifting<'a, const D: usize> {
    pub(super) a: f64,
    pub(super) q: [&'a mut [f64]; D],
    pub(super) kicked: Kicked<'a, D>,
}

impl<const D: usize> Sink<D, 1> for Drifting<'_, D> {
    #[inline(always)]
    fn q(&self) -> Positions<'_, D, 1> {
        [self.q.each_ref().map(|q| &**q)]
    }

    #[inline(always)]
    fn put<R: Packed>(&mut self, k: usize, j: usize, gradient: R) {
        let next = self.kicked.by(k, j, gradient);
        (R::load(self.q[k], j) + R::from_f64(self.a) * next).store(self.q[k], j);
    }
}

/// The gradients and Jacobians of the links of a chain from body `first` on.
#[inline(always)]
pub(super) fn stencil<const D: usize, const S: usize, N: Numbers>(
    kernel: &impl Kernels<D, S, N>,
    q: [&Vectors<D>; S],
    numbers: &NumberColumns<N>,
    first: usize,
    out: &mut Stencil<D>,
) {
    let links = numbers.bodies().saturating_sub(1);
    let q = q.map(|q| q.columns());
    if first + Lanes::COUNT <= links {
        let (a, b, d) = along::<D, S, N, Lanes>(&q, numbers, first);
        out.add_links(kernel.gradient(a, b, d), kernel.jacobian(a, b, d));
    } else {
        for j in first..links {
            let (a, b, d) = along::<D, S, N, f64>(&q, numbers, j);
            out.add_link(j - first, kernel.gradient(a, b, d), kernel.jacobian(a, b, d));
        }
    }
}

/// The links from body j to j + 1, and the following ones in further lanes.
#[inline(always)]
fn neighbours<const D: usize, const S: usize, N: Numbers, R: Packed>(
    kernel: &impl Kernel<D, S, N, R>,
    q: &Positions<'_, D, S>,
    numbers: &NumberColumns<N>,
    j: usize,
) -> [R; D] {
    let (a, b, d) = along(q, numbers, j);
    kernel.gradient(a, b, d)
}

/// The numbers of both bodies and q_j − q_{j+1} at each moment.
#[expect(clippy::type_complexity, reason = "what a kernel takes, in its order")]
#[inline(always)]
fn along<const D: usize, const S: usize, N: Numbers, R: Packed>(
    q: &Positions<'_, D, S>,
    numbers: &NumberColumns<N>,
    j: usize,
) -> (N::Of<R>, N::Of<R>, [[R; D]; S]) {
    let d = each(|moment, k| R::load(q[moment][k], j) - R::load(q[moment][k], j + 1));
    (numbers.load(j), numbers.load(j + 1), d)
}
