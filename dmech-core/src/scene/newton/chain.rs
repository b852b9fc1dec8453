//! Newton's method on a chain, in one sweep along it and one back.

use dmech_scalar::{Lanes, Real, two_sum};

use super::{Equations, Part, Progress, Solver, Trial, Unknown, Verdict, counted, unfit};
use crate::newton::NotConverged;
use crate::scene::matrix::block::{Block, invert, least_pivot, product, times};
use crate::scene::terms::stencil::{Stencil, block, load, store};
use crate::scene::vectors::Vectors;

/// Beyond it a link is a wall, and what is known of Δ is what is known of b.
const STIFFEST: f64 = 1024.0;

/// What the sweep back needs of the sweep along the chain.
///
/// A long chain does not fit into the nearest memory, and a step costs what is read and written: everything that a body
/// needs is done while it is at hand, eight bodies at a time, and the Jacobian is never stored.
#[derive(Clone, Debug)]
pub(super) struct ChainElimination<const D: usize> {
    /// Pᵢ⁻¹ Uᵢ, with Pᵢ the eliminated diagonal and −Uᵢ what is right of it.
    following: Vec<Block<D>>,
    /// drift − g (G + known) − Δ; after a step that conserves the energy, in its place what the rounding of G left out.
    residual: Vectors<D>,
    /// Each Pᵢ is positive definite, as far as it is symmetric.
    positive: bool,
}

impl<const D: usize> ChainElimination<D> {
    pub(super) fn new(bodies: usize) -> Self {
        ChainElimination { following: vec![[[0.0; D]; D]; bodies], residual: Vectors::zeros(bodies), positive: true }
    }

    /// What the rounding of the last G + J δ left out.
    pub(super) fn rest(&mut self) -> &mut Vectors<D> {
        &mut self.residual
    }
}

/// What a body takes from the one before it.
struct Before<const D: usize> {
    /// ∇Φ of the link between them and its Jacobian.
    link: [f64; D],
    jacobian: Block<D>,
    /// P⁻¹ U and P⁻¹ of the eliminated right side.
    following: Block<D>,
    solved: [f64; D],
}

impl<const D: usize> Solver<D> {
    /// As [`Solver::settle`] for the whole step, with a Jacobian for each correction: here it costs no more than to keep one.
    pub(super) fn settle_chain<U: Unknown<D>>(
        &mut self,
        chain: &mut ChainElimination<D>,
        step: Part<'_, U, D>,
    ) -> Result<u32, NotConverged> {
        let Part { equation, unknown, .. } = step;
        let mut progress = Progress::default();
        let limit = Trial::OF_GUESS.limit(equation.newton);
        for iteration in 1..=limit {
            let Some(force) = self.along(chain, equation, unknown, iteration == 1) else {
                return Err(unfit::<U, D>(iteration));
            };
            let [size, reach] = self.back::<U>(chain, equation);
            match progress.judge::<U, D>(equation, iteration, [size, reach, force])? {
                Verdict::Settled if U::LINEAR || chain.positive => return Ok(iteration),
                Verdict::Settled if self.continued_from_here(step) => return Ok(iteration),
                Verdict::Settled => return Err(NotConverged::NOT_CONTINUED),
                Verdict::GoesOn => {}
                Verdict::Slow => return Err(NotConverged { iterations: iteration.into(), residual: size }),
            }
        }
        Err(progress.exhausted(limit))
    }

    /// Guess, force, Jacobian and elimination from the first body to the last:
    ///
    /// ```text
    /// Pᵢ = 1 + g (own′ + L + L₋) − g L₋ (P⁻¹U)₋,   Uᵢ = g L,   yᵢ = Pᵢ⁻¹ (rᵢ + g L₋ y₋)
    /// ```
    ///
    /// with L the Jacobian of the link to the next body and L₋ that of the one before.
    ///
    /// max |g G| + max |g J| max |b| comes back: as positions are rounded, G is not known better than to a rounding error of this. In a
    /// long smooth chain forces nearly cancel, and the second term is much the larger. |g G| is [as it counts](counted), and |g J| for no
    /// more than [`STIFFEST`], as Δ is off by g J/(1 + g J) of what b is. Nothing comes back where a linear force has a matrix that is
    /// not positive definite.
    fn along<U: Unknown<D>>(
        &mut self,
        chain: &mut ChainElimination<D>,
        equation: &Equations<'_, D>,
        unknown: &U,
        guess: bool,
    ) -> Option<f64> {
        let bodies = self.delta.bodies();
        let (mut force, mut stiffness, mut place) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
        let mut least = f64::INFINITY;
        let mut before = Before { link: [0.0; D], jacobian: [[0.0; D]; D], following: [[0.0; D]; D], solved: [0.0; D] };
        self.place_block::<U>(equation, 0, guess);
        for first in (0..bodies).step_by(Lanes::COUNT) {
            // A link needs the body after it.
            self.place_block::<U>(equation, first + Lanes::COUNT, guess);
            let mut stencil = Stencil::NOTHING;
            unknown.stencil(&self.place, first, &mut stencil);
            let range = block(first, bodies);
            let (mut g, mut residual) = ([Lanes::ZERO; D], [Lanes::ZERO; D]);
            for k in 0..D {
                let column = || k * bodies + range.start..k * bodies + range.end;
                let of = |x: &Vectors<D>| load(x.flat(), column());
                let link = stencil.link[k];
                let gradient = stencil.own[k] + (link - link.after(before.link[k]));
                before.link[k] = link.last();
                g[k] = of(equation.g);
                let known = equation.known.map_or(Lanes::ZERO, of);
                let pull = g[k] * gradient;
                place = place.max(of(&self.place).abs());
                residual[k] = equation.drifts(column()) - (pull + g[k] * known) - of(&self.delta);
                force = force.max(counted(pull, residual[k]));
                store(gradient, self.gradient.flat_mut(), column());
                store(residual[k], chain.residual.flat_mut(), column());
            }
            let stiff = eliminate(
                &stencil,
                &g,
                &residual,
                &mut before,
                &mut chain.following[range.clone()],
                |lane, pivot, y| {
                    let pivot = least_pivot(pivot);
                    least = if pivot < least { pivot } else { least };
                    self.place.set(first + lane, y);
                },
            );
            stiffness = stiffness.max(stiff);
        }
        chain.positive = least > 0.0;
        (chain.positive || !U::LINEAR).then(|| largest(force) + f64::min(largest(stiffness), STIFFEST) * largest(place))
    }

    /// δᵢ = yᵢ + (P⁻¹U)ᵢ δᵢ₊₁ from the last body to the first; Δ += δ, and G += J δ with J δ = (r − δ)/g.
    /// max |δ| and max |Δ| come back, not finite if a component is not.
    fn back<U: Unknown<D>>(&mut self, chain: &mut ChainElimination<D>, equation: &Equations<'_, D>) -> [f64; 2] {
        let bodies = self.delta.bodies();
        let (mut size, mut step, mut odd) = (Lanes::ZERO, Lanes::ZERO, Lanes::ZERO);
        let mut after = [0.0; D];
        for first in (0..bodies).step_by(Lanes::COUNT).rev() {
            let range = block(first, bodies);
            let mut change = [Lanes::ZERO; D];
            for i in range.clone().rev() {
                let (own, next) = (self.place.get(i), times(&chain.following[i], after));
                for k in 0..D {
                    after[k] = own[k] + next[k];
                    change[k][i - first] = after[k];
                }
            }
            for k in 0..D {
                let column = || k * bodies + range.start..k * bodies + range.end;
                let of = |x: &Vectors<D>| load(x.flat(), column());
                let delta = of(&self.delta) + change[k];
                let (g, left) = (of(equation.g), of(&chain.residual) - change[k]);
                // A pinned body has g = 0.
                let pinned = g.abs().less_or_equal(Lanes::ZERO);
                let turned = Lanes::select(pinned, || Lanes::ZERO, || left / g);
                let (gradient, rest) = two_sum(of(&self.gradient), turned);
                store(delta, self.delta.flat_mut(), column());
                store(gradient, self.gradient.flat_mut(), column());
                if U::EXACT {
                    store(rest, chain.residual.flat_mut(), column());
                }
                size = size.max(change[k].abs());
                step = step.max(delta.abs());
                // max() drops a NaN, and 0·x is 0 for a finite x only.
                odd += delta * Lanes::ZERO;
            }
        }
        let odd = odd.sum();
        [largest(size) + odd, largest(step) + odd]
    }

    /// The guess, if it is to be made, and b = q + Δ for the bodies from `first` on.
    #[inline(always)]
    fn place_block<U: Unknown<D>>(&mut self, equation: &Equations<'_, D>, first: usize, guess: bool) {
        let bodies = self.delta.bodies();
        let range = block(first.min(bodies), bodies);
        for k in 0..D {
            let column = || k * bodies + range.start..k * bodies + range.end;
            let of = |x: &Vectors<D>| load(x.flat(), column());
            if guess {
                store(equation.guess::<U>(column()), self.delta.flat_mut(), column());
            }
            let place = of(equation.q) + (of(equation.q_low) + of(&self.delta));
            store(place, self.place.flat_mut(), column());
        }
    }
}

fn largest(x: Lanes) -> f64 {
    x.to_array().into_iter().fold(0.0, f64::max)
}

/// Eliminates some bodies, one after the other; `solved` is given each P and y. The largest |g J| on the diagonal comes back.
#[inline(always)]
fn eliminate<const D: usize>(
    stencil: &Stencil<D>,
    g: &[Lanes; D],
    residual: &[Lanes; D],
    before: &mut Before<D>,
    following: &mut [Block<D>],
    mut solved: impl FnMut(usize, &Block<D>, [f64; D]),
) -> Lanes {
    // All that does not wait for the body before, in lanes.
    let (mut own, mut left, mut right) = ([[Lanes::ZERO; D]; D], [[Lanes::ZERO; D]; D], [[Lanes::ZERO; D]; D]);
    let mut stiffness = Lanes::ZERO;
    for k in 0..D {
        for l in 0..D {
            let link = stencil.link_jacobian[k][l];
            let link_before = link.after(before.jacobian[k][l]);
            before.jacobian[k][l] = link.last();
            own[k][l] = g[k] * (stencil.own_jacobian[k][l] + link + link_before);
            left[k][l] = g[k] * link_before;
            right[k][l] = g[k] * link;
        }
        stiffness = stiffness.max(own[k][k].abs());
        own[k][k] += Lanes::ONE;
    }
    let at = |x: &[[Lanes; D]; D], lane: usize| -> Block<D> { x.map(|row| row.map(|x| x[lane])) };
    for (lane, following) in following.iter_mut().enumerate() {
        let (left, right) = (at(&left, lane), at(&right, lane));
        let (pulled, moved) = (product(&left, &before.following), times(&left, before.solved));
        let mut pivot = at(&own, lane);
        let mut side = residual.map(|residual| residual[lane]);
        for k in 0..D {
            side[k] += moved[k];
            for l in 0..D {
                pivot[k][l] -= pulled[k][l];
            }
        }
        if D == 1 {
            // A quotient ends sooner than a reciprocal and a product, and the next body waits for it.
            before.following[0][0] = right[0][0] / pivot[0][0];
            before.solved[0] = side[0] / pivot[0][0];
        } else {
            let inverse = invert(&pivot);
            before.following = product(&inverse, &right);
            before.solved = times(&inverse, side);
        }
        *following = before.following;
        solved(lane, &pivot, before.solved);
    }
    stiffness
}
