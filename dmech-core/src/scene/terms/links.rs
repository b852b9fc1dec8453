//! Which bodies a law links: any two, neighbours, or those of a list.

use std::collections::HashSet;

use super::numbers::NumberColumns;
use super::sweep::{self, Kernels, Sink};
use crate::error::{Error, SceneError};
use crate::law::Numbers;
use crate::scene::acting::Acting;
use crate::scene::space::Space;
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;

/// A set of links between bodies.
pub trait Links {
    /// No others than consecutive bodies are linked: the gradient at a body is known in one pass over them.
    const CHAIN: bool = false;
    /// Links of test bodies are taken in lanes too.
    const ONE_SIDED: bool = false;
    /// Which bodies are linked depends on their distance, and so must the law.
    const OF_DISTANCE: bool = false;

    /// Visits every link (a, b) in a fixed order: where distances decide, those of any of the moments.
    fn each<const D: usize, const S: usize>(
        &self,
        space: &impl Space<D>,
        q: [&Vectors<D>; S],
        visit: impl FnMut(usize, usize),
    );

    /// Visits every link of which at least one body acts.
    fn each_acting<const D: usize, const S: usize>(
        &self,
        space: &impl Space<D>,
        q: [&Vectors<D>; S],
        acts: impl Fn(usize) -> bool,
        mut visit: impl FnMut(usize, usize),
    ) {
        self.each(space, q, |a, b| {
            if acts(a) || acts(b) {
                visit(a, b);
            }
        });
    }

    /// The first link that `find` accepts.
    fn find<const D: usize, X>(
        &self,
        space: &impl Space<D>,
        q: &Vectors<D>,
        mut find: impl FnMut(usize, usize) -> Option<X>,
    ) -> Option<X> {
        let mut found = None;
        self.each(space, [q], |a, b| {
            if found.is_none() {
                found = find(a, b);
            }
        });
        found
    }

    /// At most as many links as there are bodies or as are listed, in which every linked body takes part: of all pairs, those
    /// of neighbours.
    fn sample(&self, bodies: usize) -> impl Iterator<Item = (usize, usize)> {
        (1..bodies).map(|b| (b - 1, b))
    }

    /// The links of a list.
    fn listed(&self) -> &[(usize, usize)] {
        &[]
    }

    /// The distance at which links end.
    fn cutoff(&self) -> Option<f64> {
        None
    }

    /// Adds the gradient of every link to its two bodies; if `SET`, in place of what is there.
    fn sweep<const SET: bool, const D: usize, const S: usize, N: Numbers>(
        &self,
        space: &impl Space<D>,
        kernel: &impl Kernels<D, S, N>,
        q: [&Vectors<D>; S],
        numbers: &NumberColumns<N>,
        out: &mut Vectors<D>,
    );

    /// The same in lanes where some bodies are test bodies, if [`ONE_SIDED`](Links::ONE_SIDED) says so.
    fn sweep_one_sided<const D: usize, const S: usize, N: Numbers>(
        &self,
        _kernel: &impl Kernels<D, S, N>,
        _q: [&Vectors<D>; S],
        _numbers: &NumberColumns<N>,
        _acting: &Acting,
        _out: &mut Vectors<D>,
    ) {
    }

    /// Puts the gradient where it goes as it is computed, in one pass, where [`CHAIN`](Links::CHAIN) says so.
    fn pass<const D: usize, N: Numbers>(
        &self,
        _kernel: &impl Kernels<D, 1, N>,
        _numbers: &NumberColumns<N>,
        _sink: impl Sink<D, 1>,
    ) {
    }

    /// What it means for the Jacobian.
    fn topology(&self) -> Topology;

    /// Whether every link is between two bodies of the scene, and a cut-off fits its space.
    ///
    /// # Errors
    /// [`SceneError::Bond`], [`SceneError::SelfBond`], [`SceneError::DuplicateBond`]; [`SceneError::Cutoff`],
    /// [`SceneError::CutoffInBox`].
    fn check<const D: usize>(&self, _bodies: usize, _space: &impl Space<D>) -> Result<(), Error> {
        Ok(())
    }
}

/// The number of bodies.
#[inline]
pub(super) fn bodies<const D: usize, const S: usize>(q: [&Vectors<D>; S]) -> usize {
    q.first().map_or(0, |q| q.bodies())
}

/// Links that follow from the number of bodies.
pub trait KnownLinks: Links {
    /// Visits every link (a, b) in a fixed order.
    fn visit(bodies: usize, visit: impl FnMut(usize, usize));
}

/// Consecutive bodies.
#[derive(Clone, Copy, Debug)]
pub struct Chain;

impl KnownLinks for Chain {
    #[inline(always)]
    fn visit(bodies: usize, mut visit: impl FnMut(usize, usize)) {
        for b in 1..bodies {
            visit(b - 1, b);
        }
    }
}

impl Links for Chain {
    const CHAIN: bool = true;

    #[inline]
    fn each<const D: usize, const S: usize>(
        &self,
        _: &impl Space<D>,
        q: [&Vectors<D>; S],
        visit: impl FnMut(usize, usize),
    ) {
        Self::visit(bodies(q), visit);
    }

    fn sweep<const SET: bool, const D: usize, const S: usize, N: Numbers>(
        &self,
        _: &impl Space<D>,
        kernel: &impl Kernels<D, S, N>,
        q: [&Vectors<D>; S],
        numbers: &NumberColumns<N>,
        out: &mut Vectors<D>,
    ) {
        let q = q.map(|q| q.columns());
        sweep::chain(*kernel, numbers, sweep::Gradient::<D, S, SET> { q, out: out.columns_mut() });
    }

    fn pass<const D: usize, N: Numbers>(
        &self,
        kernel: &impl Kernels<D, 1, N>,
        numbers: &NumberColumns<N>,
        sink: impl Sink<D, 1>,
    ) {
        sweep::chain(*kernel, numbers, sink);
    }

    fn topology(&self) -> Topology {
        Topology::Chain
    }
}

/// The bodies of a list.
#[derive(Clone, Debug)]
pub struct Bonds {
    list: Vec<(usize, usize)>,
}

impl Bonds {
    pub(crate) fn new(list: impl IntoIterator<Item = (usize, usize)>) -> Self {
        Bonds { list: list.into_iter().collect() }
    }
}

impl Links for Bonds {
    #[inline]
    fn each<const D: usize, const S: usize>(
        &self,
        _: &impl Space<D>,
        _: [&Vectors<D>; S],
        mut visit: impl FnMut(usize, usize),
    ) {
        for &(a, b) in &self.list {
            visit(a, b);
        }
    }

    fn sweep<const SET: bool, const D: usize, const S: usize, N: Numbers>(
        &self,
        _: &impl Space<D>,
        kernel: &impl Kernels<D, S, N>,
        q: [&Vectors<D>; S],
        numbers: &NumberColumns<N>,
        out: &mut Vectors<D>,
    ) {
        if SET {
            out.clear();
        }
        for &(a, b) in &self.list {
            sweep::link(kernel, q, numbers, a, b, out);
        }
    }

    fn sample(&self, _: usize) -> impl Iterator<Item = (usize, usize)> {
        self.list.iter().copied()
    }

    fn listed(&self) -> &[(usize, usize)] {
        &self.list
    }

    fn topology(&self) -> Topology {
        Topology::Sparse { bonds: self.list.clone(), chain: false }
    }

    fn check<const D: usize>(&self, bodies: usize, _: &impl Space<D>) -> Result<(), Error> {
        let mut seen = HashSet::with_capacity(self.list.len());
        for &(a, b) in &self.list {
            if a >= bodies || b >= bodies {
                return Err(SceneError::Bond { a, b, bodies }.into());
            }
            if a == b {
                return Err(SceneError::SelfBond { body: a }.into());
            }
            if !seen.insert((a.min(b), a.max(b))) {
                return Err(SceneError::DuplicateBond { a, b }.into());
            }
        }
        Ok(())
    }
}
