//! What acts on a few consecutive bodies of a chain.

use core::ops::Range;

use dmech_scalar::Lanes;

/// Forces and Jacobians on up to eight consecutive bodies: those of the bodies themselves, and those along the link from
/// each to the next. A chain is solved as it is read, so that nothing of this is stored for all bodies.
#[derive(Clone, Copy)]
pub struct Stencil<const D: usize> {
    /// ∇Φ of the laws on the bodies, by component.
    pub own: [Lanes; D],
    /// Their Hessians.
    pub own_jacobian: [[Lanes; D]; D],
    /// ∇Φ(d) with d = qⱼ − qⱼ₊₁: what body j feels of it; the next one feels the opposite.
    pub link: [Lanes; D],
    /// ∂/∂d of that.
    pub link_jacobian: [[Lanes; D]; D],
}

impl<const D: usize> Stencil<D> {
    /// Nothing acts.
    pub const NOTHING: Self = {
        let none = Lanes::splat(0.0);
        Stencil { own: [none; D], own_jacobian: [[none; D]; D], link: [none; D], link_jacobian: [[none; D]; D] }
    };

    /// Adds what acts on one of the bodies itself.
    #[inline(always)]
    pub(super) fn add_own(&mut self, lane: usize, gradient: [f64; D], jacobian: [[f64; D]; D]) {
        for k in 0..D {
            self.own[k][lane] += gradient[k];
            for l in 0..D {
                self.own_jacobian[k][l][lane] += jacobian[k][l];
            }
        }
    }

    /// Adds the link from one of the bodies to the next.
    #[inline(always)]
    pub(super) fn add_link(&mut self, lane: usize, gradient: [f64; D], jacobian: [[f64; D]; D]) {
        for k in 0..D {
            self.link[k][lane] += gradient[k];
            for l in 0..D {
                self.link_jacobian[k][l][lane] += jacobian[k][l];
            }
        }
    }

    /// Adds the links of eight bodies.
    #[inline(always)]
    pub(super) fn add_links(&mut self, gradient: [Lanes; D], jacobian: [[Lanes; D]; D]) {
        for k in 0..D {
            self.link[k] += gradient[k];
            for l in 0..D {
                self.link_jacobian[k][l] += jacobian[k][l];
            }
        }
    }
}

/// The bodies from `first` on, eight at most.
#[inline(always)]
pub(crate) fn block(first: usize, bodies: usize) -> Range<usize> {
    first..(first + Lanes::COUNT).min(bodies)
}

/// x[range] in the first lanes, and 0 in those that are left.
#[inline(always)]
pub(crate) fn load(x: &[f64], range: Range<usize>) -> Lanes {
    let x = &x[range];
    match x.first_chunk() {
        Some(&eight) => Lanes::from_array(eight),
        None => Lanes::from_fn(|lane| x.get(lane).copied().unwrap_or_default()),
    }
}

/// x[range] ← the first lanes.
#[inline(always)]
pub(crate) fn store(lanes: Lanes, x: &mut [f64], range: Range<usize>) {
    let x = &mut x[range];
    match x.first_chunk_mut() {
        Some(eight) => *eight = lanes.to_array(),
        None => x.iter_mut().zip(lanes.to_array()).for_each(|(x, lane)| *x = lane),
    }
}
