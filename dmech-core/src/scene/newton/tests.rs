//! What a correction changes of a force is known to more digits than the force.

use dmech_scalar::Lanes;

use super::progress::{Progress, Verdict};
use super::{Equations, Solver, Unknown};
use crate::scene::matrix::Matrix;
use crate::scene::terms::stencil::{Stencil, block, load};
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;
use crate::scheme::Newton;

/// G = b − 1/16.
struct Spring;

impl Unknown<1> for Spring {
    const CHAIN: bool = true;
    const LINEAR: bool = false;
    const PIECEWISE: bool = false;
    const FORCED: bool = false;
    const EXACT: bool = true;

    fn gradient(&self, _: f64, b: &Vectors<1>, _: [&Vectors<1>; 2], out: &mut Vectors<1>) {
        out.flat_mut().iter_mut().zip(b.flat()).for_each(|(out, b)| *out = b - 0.0625);
    }

    fn jacobian(&self, _: f64, b: &Vectors<1>, _: [&Vectors<1>; 2], _: f64, out: &mut Matrix<1>) {
        (0..b.bodies()).for_each(|i| out.add_block(i, i, [[1.0]]));
    }

    fn stencil(&self, b: &Vectors<1>, first: usize, out: &mut Stencil<1>) {
        out.own = [load(b.flat(), block(first, b.bodies())) - Lanes::splat(0.0625)];
        out.own_jacobian = [[Lanes::splat(1.0)]];
    }
}

/// All numbers are such that only G + J δ is rounded: G = 1, and J δ = −2⁻⁵⁵/(1 + g) does not change it.
#[test]
fn a_correction_too_small_to_change_the_force_is_left_beside_it() {
    let two = |n: i32| f64::from(n).exp2();
    let bodies = 11;
    let all = |x: f64| {
        let mut vectors = Vectors::<1>::zeros(bodies);
        vectors.flat_mut().fill(x);
        vectors
    };
    let (q, zero, g) = (all(1.0), all(0.0), all(two(-10)));
    let (v, last) = (all(two(-4) + two(-10) + two(-56)), all(1.0 - two(-45)));
    let newton = Newton::predicted();
    let equation = Equations {
        q: &q,
        q_low: &zero,
        h: 1.0,
        known: None,
        g: &g,
        v: &v,
        v_low: &zero,
        rate: 0.0,
        last: [&last; 3],
        last_are_whole: true,
        newton: &newton,
    };
    for topology in [Topology::Chain, Topology::Dense] {
        let mut solver = Solver::for_links(bodies, &topology);
        solver.solve(&equation, &Spring).unwrap();
        let turned = -two(-55) / (1.0 + two(-10));
        for (gradient, rest) in solver.gradient.flat().iter().zip(solver.rest.flat()) {
            assert_eq!(*gradient, 1.0, "{topology:?}");
            assert!((rest / turned - 1.0).abs() < 1e-10, "{topology:?}: {rest:e} for {turned:e}");
        }
    }
}

/// The same in a single correction: what it neglects, |δ|²/|Δ|, is below ε/64 of the force.
#[test]
fn a_single_correction_is_trusted_up_to_a_sixty_fourth_of_rounding() {
    let (zero, newton) = (Vectors::<1>::zeros(1), Newton::predicted());
    let equation = Equations {
        q: &zero,
        q_low: &zero,
        h: 1.0,
        known: None,
        g: &zero,
        v: &zero,
        v_low: &zero,
        rate: 0.0,
        last: [&zero; 3],
        last_are_whole: true,
        newton: &newton,
    };
    let single = (f64::EPSILON / 64.0).sqrt();
    for (size, verdict) in [(0.9 * single, Verdict::Settled), (1.1 * single, Verdict::GoesOn)] {
        for step in [1.0, 1e-3, 1e5] {
            let judged = Progress::default().judge::<Spring, 1>(&equation, 1, [size * step, step, step]).unwrap();
            assert_eq!(judged, verdict, "{:.1} of the limit", size / single);
        }
    }
}
