//! A law along links.

use core::any::{Any, TypeId};
use core::marker::PhantomData;

use super::kernels::{Secant, Slope, Turned};
use super::links::Links;
use super::numbers::NumberColumns;
use super::separation::separation;
use super::stencil::Stencil;
use super::stiffness::{combine, link_stiffness};
use super::sweep::{self, Kernel, Kicked};
use super::{Acts, Fault, Laws, Moving, Term};
use crate::error::{Culprit, Error, SceneError};
use crate::law::written::{self, Probe, agree};
use crate::law::{Between, LinkLaw, PairLaw, Reads};
use crate::law::{LinearInVelocity, Potential, VelocityIndependent};
use crate::scene::acting::Acting;
use crate::scene::bodies::Bodies;
use crate::scene::matrix::Matrix;
use crate::scene::matrix::block::times;
use crate::scene::space::Space;
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;
use crate::system::{Course, Frequency, LinearVelocities, WithoutVelocities};
use crate::vector::scaled;

/// What acts between two bodies at one moment.
pub(super) type OnLink<'a, const D: usize, P, X, R = f64> = <X as PairLaw<D, P, R>>::Between<'a>;

/// A law that acts along links.
#[derive(Clone, Debug)]
pub struct Linked<X, T> {
    pub(crate) law: X,
    pub(crate) links: T,
}

/// A law that acts along links in the space `B`, with what it reads of the bodies.
#[derive(Clone, Debug)]
pub struct LinkedReady<X: Reads<P>, T, P, B> {
    pub(in crate::scene) law: X,
    pub(in crate::scene) links: T,
    pub(in crate::scene) space: B,
    pub(super) acting: Acting,
    pub(in crate::scene) numbers: NumberColumns<X::Numbers>,
    data: PhantomData<fn() -> P>,
}

impl<X: Reads<P> + VelocityIndependent, T, P, B> WithoutVelocities for LinkedReady<X, T, P, B> {}
impl<X: Reads<P> + LinearInVelocity, T, P, B> LinearVelocities for LinkedReady<X, T, P, B> {}

impl<const D: usize, P, X: LinkLaw<D, P>, T: Links, B: Space<D>> Term<D, P, B> for Linked<X, T> {
    type Ready = LinkedReady<X, T, P, B>;

    /// Compares the law with its author's methods on the first thousand links of a sample (`Links::sample`), and around
    /// the first of them.
    fn prepare(self, bodies: &Bodies<D, P>, space: B) -> Result<Self::Ready, Error> {
        const LINKS: usize = 1000;
        let Bodies { masses, q, v, data, t, .. } = bodies;
        self.links.check(masses.len(), &space)?;
        let central = !OnLink::<D, P, X>::POTENTIAL || OnLink::<D, P, X>::CENTRAL;
        if T::OF_DISTANCE && !central {
            return Err(SceneError::CutoffNotCentral.into());
        }
        if let Some(law) = PairLaw::<D, P, f64>::written(&self.law) {
            for (i, (a, b)) in self.links.sample(masses.len()).take(LINKS).enumerate() {
                let d = space.image(core::array::from_fn(|k| q[a][k] - q[b][k]));
                let place = Probe { q: d, v: [v[a], v[b]], m: [masses[a], masses[b]], t: *t };
                let agreed = agree(&written::Between { law, a: &data[a], b: &data[b] }, &place, i == 0);
                agreed.map_err(|difference| Error::NotAsWritten(difference.on(Culprit::Link(a, b))))?;
            }
        }
        let read = bodies.masses.iter().zip(&bodies.data).map(|(&mass, data)| X::numbers(mass, data));
        let numbers = NumberColumns::new(read);
        Ok(LinkedReady { law: self.law, links: self.links, space, acting: bodies.acting(), numbers, data: PhantomData })
    }
}

impl<X: Reads<P> + 'static, T, P, B> Laws for LinkedReady<X, T, P, B> {
    fn law(&mut self, of: TypeId, on: Option<usize>) -> Option<&mut dyn Any> {
        match on {
            Some(_) => None,
            None if TypeId::of::<X>() == of => Some(&mut self.law),
            None => self.law.inner(of),
        }
    }
}

impl<X: Reads<P>, T: Links, P, B: Copy> LinkedReady<X, T, P, B> {
    fn slope(&self, t: f64) -> Slope<'_, X, P, B> {
        Slope { law: &self.law, t, space: self.space, data: PhantomData }
    }

    /// The law between two bodies, as seen from the first.
    #[inline(always)]
    fn between<const D: usize>(&self, a: usize, b: usize, t: f64) -> OnLink<'_, D, P, X>
    where
        X: PairLaw<D, P>,
    {
        PairLaw::<D, P, f64>::between(&self.law, self.numbers.at(a), self.numbers.at(b), t)
    }

    /// q_a − q_b as the space has it.
    #[inline(always)]
    fn separation<const D: usize>(&self, q: &Vectors<D>, a: usize, b: usize) -> [f64; D]
    where
        B: Space<D>,
    {
        self.space.image(separation(q, a, b))
    }
}

impl<const D: usize, P, X: LinkLaw<D, P>, T: Links, B: Space<D>> Acts<D> for LinkedReady<X, T, P, B> {
    const FORCED: bool = OnLink::<D, P, X>::FORCED;
    const CONSERVES_ENERGY: bool = !Self::FORCED;
    const AUTONOMOUS: bool = <X as PairLaw<D, P>>::AUTONOMOUS;
    const LINEAR_MOMENTUM: bool = OnLink::<D, P, X>::RECIPROCAL;
    const ANGULAR_MOMENTUM: bool = !B::PERIODIC && OnLink::<D, P, X>::CENTRAL && !Self::FORCED;
    const LINEAR: bool = !B::PERIODIC && OnLink::<D, P, X>::LINEAR;
    const PIECEWISE: bool = B::PERIODIC || OnLink::<D, P, X>::PIECEWISE;
    const DEGREE: Option<u32> = if B::PERIODIC { None } else { OnLink::<D, P, X>::DEGREE };

    const CHAIN: bool = T::CHAIN;
    const AT_ONCE: bool = T::CHAIN && OnLink::<D, P, X>::POTENTIAL && !Self::FORCED;

    fn potential(&self, q: &Vectors<D>, t: f64) -> f64 {
        let mut sum = 0.0;
        self.each([q], |a, b| {
            // The energy is that of the bodies that act.
            if self.acting.acts(a) && self.acting.acts(b) {
                sum += self.between(a, b, t).potential(self.separation(q, a, b));
            }
        });
        sum
    }

    #[inline]
    fn add_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if OnLink::<D, P, X>::POTENTIAL {
            self.sweep::<false, _, D, 1>(&self.slope(t), [q], out);
        }
    }

    #[inline]
    fn set_gradient(&self, q: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if OnLink::<D, P, X>::POTENTIAL {
            self.sweep::<true, _, D, 1>(&self.slope(t), [q], out);
        } else {
            out.clear();
        }
    }

    #[inline]
    fn kick(&self, q: &Vectors<D>, t: f64, kick: Kicked<'_, D>) {
        if self.acting.all() {
            self.links.pass(&self.slope(t), &self.numbers, sweep::Staying { q: q.columns(), kicked: kick });
        } else {
            self.kick_felt(&self.slope(t), q, kick);
        }
    }

    #[inline]
    fn kick_and_drift(&self, a: f64, q: &mut Vectors<D>, t: f64, kick: Kicked<'_, D>) {
        self.links.pass(&self.slope(t), &self.numbers, sweep::Drifting { a, q: q.columns_mut(), kicked: kick });
    }

    fn at_once(&self) -> bool {
        Self::AT_ONCE && self.acting.all()
    }

    fn subtract_force(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if !Self::FORCED {
            return;
        }
        self.each([q], |a, b| {
            let (d, va, vb) = (self.separation(q, a, b), v.get(a), v.get(b));
            let on_a = self.between(a, b, t).force(d, va, vb);
            if self.acting.acts(b) {
                out.add(a, on_a.map(|f| -c * f));
            }
            if self.acting.acts(a) {
                if OnLink::<D, P, X>::RECIPROCAL {
                    out.add(b, on_a.map(|f| c * f));
                } else {
                    let on_b = self.between(b, a, t).force(d.map(|x| -x), vb, va);
                    out.add(b, on_b.map(|f| -c * f));
                }
            }
        });
    }

    #[inline]
    fn add_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if OnLink::<D, P, X>::POTENTIAL {
            self.sweep::<false, _, D, 2>(&Secant(self.slope(t)), [a, b], out);
        }
    }

    #[inline]
    fn set_discrete_gradient(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if OnLink::<D, P, X>::POTENTIAL {
            self.sweep::<true, _, D, 2>(&Secant(self.slope(t)), [a, b], out);
        } else {
            out.clear();
        }
    }

    fn add_hessian(&self, c: f64, q: &Vectors<D>, t: f64, out: &mut Matrix<D>) {
        if OnLink::<D, P, X>::POTENTIAL {
            self.each([q], |a, b| {
                let hessian = self.between(a, b, t).hessian(self.separation(q, a, b));
                self.add_link(a, b, hessian.map(|row| row.map(|x| c * x)), out);
            });
        }
    }

    fn add_turned(&self, c: f64, q: &Vectors<D>, w: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        if OnLink::<D, P, X>::POTENTIAL {
            self.sweep::<false, _, D, 2>(&Turned { slope: self.slope(t), c }, [q, w], out);
        }
        if !Self::FORCED {
            return;
        }
        self.each([q], |a, b| {
            let (d, w) = (self.separation(q, a, b), scaled(c, separation(w, a, b)));
            let by_d =
                |a: usize, b: usize, d: [f64; D]| self.between(a, b, t).force_jacobians(d, [0.0; D], [0.0; D])[0];
            let on_a = times(&by_d(a, b, d), w);
            if self.acting.acts(b) {
                out.add(a, on_a.map(|x| -x));
            }
            if self.acting.acts(a) {
                if OnLink::<D, P, X>::RECIPROCAL {
                    out.add(b, on_a);
                } else {
                    out.add(b, times(&by_d(b, a, d.map(|x| -x)), w));
                }
            }
        });
    }

    fn add_discrete_jacobian(&self, from: &Vectors<D>, to: &Vectors<D>, t: f64, out: &mut Matrix<D>) {
        if OnLink::<D, P, X>::POTENTIAL {
            self.each([from, to], |a, b| {
                let way = [separation(from, a, b), separation(to, a, b)];
                let kernel = Secant(self.slope(t));
                self.add_link(a, b, kernel.jacobian(self.numbers.at(a), self.numbers.at(b), way), out);
            });
        }
    }

    fn subtract_force_jacobian(&self, c: f64, q: &Vectors<D>, v: &Vectors<D>, t: f64, rate: f64, out: &mut Matrix<D>) {
        if !Self::FORCED {
            return;
        }
        // F_ab depends on d = q_a − q_b, v_a and v_b.
        let mut row = |a: usize, b: usize| {
            let (d, va, vb) = (self.separation(q, a, b), v.get(a), v.get(b));
            let [by_d, by_va, by_vb] = self.between(a, b, t).force_jacobians(d, va, vb);
            out.add_block(a, a, combine(-c, by_d, -c * rate, by_va));
            out.add_block(a, b, combine(c, by_d, -c * rate, by_vb));
        };
        self.each([q], |a, b| {
            if self.acting.acts(b) {
                row(a, b);
            }
            if self.acting.acts(a) {
                row(b, a);
            }
        });
    }

    #[inline(always)]
    fn add_stencil(&self, q: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>) {
        if OnLink::<D, P, X>::POTENTIAL {
            sweep::stencil(&self.slope(t), [q], &self.numbers, first, out);
        }
    }

    #[inline(always)]
    fn add_discrete_stencil(&self, a: &Vectors<D>, b: &Vectors<D>, t: f64, first: usize, out: &mut Stencil<D>) {
        if OnLink::<D, P, X>::POTENTIAL {
            sweep::stencil(&Secant(self.slope(t)), [a, b], &self.numbers, first, out);
        }
    }

    fn frequency(&self, at: &Moving<'_, D>) -> Frequency {
        let mut all = at.nothing();
        self.each([at.q], |a, b| {
            // Nobody is moved by a test body: its own mass does not count in how fast the two move about each other.
            let moved =
                |i, by| Course { per_mass: if self.acting.acts(by) { at.per_mass[i] } else { 0.0 }, ..at.body(i) };
            let (on_a, on_b) = (moved(a, b), moved(b, a));
            if on_a.per_mass + on_b.per_mass != 0.0 {
                let stiffness = |s, d, _| {
                    let between = |a, b| self.between(a, b, at.t + s);
                    link_stiffness([between(a, b), between(b, a)], s, [&on_a, &on_b], self.space.image(d))
                };
                let link = on_a.relative_to(&on_b);
                all = all.and(Frequency::between(Course { q: self.space.image(link.q), ..link }, stiffness));
            }
        });
        all
    }

    fn links(&self, _: usize) -> Topology {
        match self.links.topology() {
            // Bodies that feel and do not act: links are no longer alike at both ends.
            Topology::Chain if !self.acting.all() => Topology::Near,
            topology => topology,
        }
    }

    fn fields(&self, see: &mut dyn FnMut(&'static str, f64)) {
        if let Some(written) = PairLaw::<D, P, f64>::written(&self.law) {
            written.fields(see);
        }
        self.numbers.flat().iter().for_each(|&x| see("data of the bodies", x));
        for length in self.space.lengths().into_iter().flatten() {
            see("lengths of the box", length);
        }
        if let Some(cutoff) = self.links.cutoff() {
            see("cut-off", cutoff);
        }
        for &(a, b) in self.links.listed() {
            see("list of bonds", a as f64);
            see("list of bonds", b as f64);
        }
    }

    fn fault(&self, from: Option<&Vectors<D>>, q: &Vectors<D>, v: &Vectors<D>, t: f64) -> Option<Fault> {
        self.links.find(&self.space, q, |a, b| {
            if !self.acting.acts(a) && !self.acting.acts(b) {
                return None;
            }
            let (d, va, vb) = (self.separation(q, a, b), v.get(a), v.get(b));
            let between = self.between(a, b, t);
            let gradient = between.gradient(d);
            let force = between.force(d, va, vb);
            let back = self.between(b, a, t).force(d.map(|x| -x), vb, va);
            let way = |from| [separation(from, a, b), separation(q, a, b)];
            let secant = |way| Secant(self.slope(t)).gradient(self.numbers.at(a), self.numbers.at(b), way);
            let secant = from.map_or([0.0; D], |from| secant(way(from)));
            let components = [gradient, force, back, secant];
            let finite = between.potential(d).is_finite() && components.iter().flatten().all(|x| x.is_finite());
            // A square would overflow for bodies that a step too long has thrown apart.
            let distance = d.iter().fold(0.0, |r, &x| f64::hypot(r, x));
            (!finite).then_some(Fault::Link { a, b, distance })
        })
    }
}
