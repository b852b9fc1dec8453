//! Solving the implicit steps of a scene.

mod cancelling;
mod chain;
mod equations;
mod follow;
mod progress;
mod root;
#[cfg(test)]
mod tests;

use dmech_scalar::{Lanes, Real, two_sum};

use self::chain::ChainElimination;
use self::equations::Part;
pub(super) use self::equations::{Equations, Unknown};
use self::progress::{Progress, Verdict};
use super::matrix::{Kind, Matrix};
use super::terms::stencil::{block, store};
use super::topology::Topology;
use super::vectors::Vectors;
use crate::newton::NotConverged;
use crate::newton::path::SWIFT;
use crate::system::{Effort, Newton};

/// How long a starting point is tried.
#[derive(Clone, Copy, Debug)]
struct Trial {
    /// Corrections with one factorisation before the Jacobian is taken anew.
    chord: u32,
    /// Corrections before it is given up.
    patience: u32,
}

impl Trial {
    const OF_GUESS: Trial = Trial { chord: 6, patience: PATIENCE };
    /// Where the root of a shorter step is followed the Jacobian varies fastest.
    const FOLLOWED: Trial = Trial { chord: 1, patience: PATIENCE };
    /// The whole step from where it starts.
    const AT_REST: Trial = Trial { chord: 1, patience: SWIFT };

    /// Corrections that it has.
    fn limit(self, newton: &Newton) -> u32 {
        self.patience.min(newton.limit())
    }
}

/// Corrections before a starting point is given up.
const PATIENCE: u32 = 30;
/// Progress in θ that does not go over to another root, as that of two bodies on a spring which have changed places.
const SHORT: f64 = 1.0 / 64.0;

/// |g G|, which counts for no more than some times what is wanted of it, drift − g known − Δ: at one end of a correction that leads out
/// of a wall it may be 10²⁰ times that.
#[inline(always)]
fn counted<R: Real>(pull: R, residual: R) -> R {
    pull.abs().min(R::from_f64(4.0) * (pull + residual).abs())
}

/// What 1 + g J must be. Of a linear force one correction leads to the root wherever it is, so that the matrix has to tell
/// whether it continues that of a shorter step.
const fn kind<U: Unknown<D>, const D: usize>() -> Kind {
    if U::LINEAR { Kind::Definite } else { Kind::Regular }
}

/// The matrix is not as it must be.
fn unfit<U: Unknown<D>, const D: usize>(iteration: u32) -> NotConverged {
    if U::LINEAR {
        NotConverged::NOT_CONTINUED
    } else {
        NotConverged { iterations: iteration.into(), residual: f64::NAN }
    }
}

/// The Newton matrix and the vectors of an iteration, allocated once.
#[derive(Clone, Debug)]
pub(super) struct Solver<const D: usize> {
    matrix: Matrix<D>,
    /// In place of the matrix, where consecutive bodies are linked and forces do not depend on velocities.
    chain: Option<ChainElimination<D>>,
    /// Δ.
    pub(super) delta: Vectors<D>,
    /// G at the solution, G + J δ of the last correction.
    pub(super) gradient: Vectors<D>,
    /// What the rounding of that sum left out, where the step conserves the energy.
    pub(super) rest: Vectors<D>,
    /// The position at the end of the step, and then the residual and the correction, which do not need it any more: a
    /// long chain is as fast as little memory is touched.
    place: Vectors<D>,
    /// The velocity with which a force is taken, and the mean position where it is taken there.
    velocity: Vectors<D>,
    pub(super) middle: Vectors<D>,
    first: Vectors<D>,
    slope: Vectors<D>,
    /// θ² g.
    scaled: Vectors<D>,
}

impl<const D: usize> Solver<D> {
    pub(super) fn for_links(bodies: usize, topology: &Topology) -> Self {
        let zeros = Vectors::zeros(bodies);
        Solver {
            matrix: Matrix::new(bodies, topology),
            chain: (*topology == Topology::Chain).then(|| ChainElimination::new(bodies)),
            delta: zeros.clone(),
            gradient: zeros.clone(),
            rest: zeros.clone(),
            place: zeros.clone(),
            velocity: zeros.clone(),
            middle: Vectors::zeros(0),
            first: zeros.clone(),
            slope: zeros.clone(),
            scaled: zeros,
        }
    }

    /// The gradient at the solution is then in `gradient`.
    pub(super) fn solve<U: Unknown<D>>(
        &mut self,
        equation: &Equations<'_, D>,
        unknown: &U,
    ) -> Result<Effort, NotConverged> {
        let step = Part::whole(equation, unknown);
        let settled = match self.chain.take() {
            Some(mut chain) if U::CHAIN && !U::FORCED => {
                let settled = self.settle_chain(&mut chain, step);
                if U::EXACT {
                    core::mem::swap(&mut self.rest, chain.rest());
                }
                self.chain = Some(chain);
                settled.or_else(|astray| self.finish(step, astray))
            }
            chain => {
                self.chain = chain;
                self.guess::<U>(equation);
                self.settle(step, Trial::OF_GUESS)
            }
        };
        match settled {
            Ok(iterations) => Ok(Effort { evaluations: iterations, iterations }),
            // Of a linear force there is no other root.
            Err(astray) if U::LINEAR && astray == NotConverged::NOT_CONTINUED => Err(astray),
            Err(astray) => {
                let ended = match self.lengthen(step, astray, 1.0) {
                    Err(lost) if lost == NotConverged::NOT_CONTINUED => self.lengthen(step, lost, SHORT),
                    found => found,
                };
                ended.or_else(|lost| self.cancels(step, astray, lost).ok_or(lost))
            }
        }
    }

    /// Newton for a part of the step.
    fn settle<U: Unknown<D>>(&mut self, part: Part<'_, U, D>, trial: Trial) -> Result<u32, NotConverged> {
        self.approach(part, trial).or_else(|astray| self.finish(part, astray))
    }

    /// Corrections until one is so small that the force is known to rounding, or until they no longer shrink.
    fn approach<U: Unknown<D>>(&mut self, part: Part<'_, U, D>, trial: Trial) -> Result<u32, NotConverged> {
        let mut progress = Progress::default();
        let mut since_factors = 0;
        let limit = trial.limit(part.equation.newton);
        for iteration in 1..=limit {
            self.take_gradient(part);
            if iteration == 1 || since_factors == trial.chord {
                if !self.take_jacobian(part) {
                    return Err(unfit::<U, D>(iteration));
                }
                since_factors = 0;
            }
            since_factors += 1;
            let force = self.residual(part);
            self.solve_linear(part);
            self.turn::<U>();
            let [size, step] = self.correct();
            match progress.judge::<U, D>(part.equation, iteration, [size, step, force])? {
                Verdict::Settled => return self.continued(part, iteration),
                Verdict::GoesOn => {}
                Verdict::Slow if since_factors > 1 => since_factors = trial.chord,
                Verdict::Slow => return Err(NotConverged { iterations: iteration.into(), residual: size }),
            }
        }
        Err(progress.exhausted(limit))
    }

    /// b = q + Δ, and G there.
    fn take_gradient<U: Unknown<D>>(&mut self, Part { equation, unknown, theta }: Part<'_, U, D>) {
        self.place::<U>(equation);
        let x = if U::MIDDLE { &self.middle } else { &self.place };
        unknown.gradient(theta, &self.place, [x, &self.velocity], &mut self.gradient);
    }

    /// The Jacobian at the place of the position, and the factors of its matrix; `false` if that is not as it must be.
    fn take_jacobian<U: Unknown<D>>(&mut self, part: Part<'_, U, D>) -> bool {
        let Part { equation, unknown, theta } = part;
        self.matrix.clear();
        let x = if U::MIDDLE { &self.middle } else { &self.place };
        unknown.jacobian(theta, &self.place, [x, &self.velocity], equation.rate, &mut self.matrix);
        if theta == 1.0 {
            return self.matrix.factorise(equation.g, kind::<U, D>());
        }
        self.scaled.clone_from(equation.g);
        self.scaled.flat_mut().iter_mut().for_each(|g| *g *= theta * theta);
        self.matrix.factorise(&self.scaled, kind::<U, D>())
    }

    /// The first Δ.
    fn guess<U: Unknown<D>>(&mut self, equation: &Equations<'_, D>) {
        for first in (0..self.delta.flat().len()).step_by(Lanes::COUNT) {
            let range = block(first, self.delta.flat().len());
            store(equation.guess::<U>(range.clone()), self.delta.flat_mut(), range);
        }
    }

    /// b = q + Δ and, where they are needed, the velocity and the place of the force. By way of the velocity at the end the rounding
    /// of 2/h would make the mean one that works.
    fn place<U: Unknown<D>>(&mut self, equation: &Equations<'_, D>) {
        let Equations { q, q_low, v, rate, .. } = *equation;
        let (delta, place) = (self.delta.flat(), self.place.flat_mut());
        for (((place, q), low), delta) in place.iter_mut().zip(q.flat()).zip(q_low.flat()).zip(delta) {
            *place = q + (low + delta);
        }
        if U::MIDDLE {
            let ends = q.flat().iter().zip(&*place).zip(delta);
            let means = self.middle.flat_mut().iter_mut().zip(self.velocity.flat_mut());
            for ((middle, mean), ((q, b), delta)) in means.zip(ends) {
                (*middle, *mean) = (0.5 * (q + b), 0.5 * rate * delta);
            }
        } else if U::FORCED {
            let known = v.flat().iter().zip(delta).enumerate();
            for (end, (i, (v, delta))) in self.velocity.flat_mut().iter_mut().zip(known) {
                *end = rate * (delta - equation.drift(i)) + v;
            }
        }
    }

    /// drift − g (G + known) − Δ, in the place of the position; the largest |g G| comes back, [as it counts](counted).
    fn residual<U>(&mut self, Part { equation, theta, .. }: Part<'_, U, D>) -> f64 {
        let square = theta * theta;
        let mut force = 0.0_f64;
        let out = self.place.flat_mut().iter_mut().zip(self.delta.flat());
        let forces = equation.g.flat().iter().zip(self.gradient.flat()).enumerate();
        for ((residual, delta), (i, (g, gradient))) in out.zip(forces) {
            let g = square * g;
            let pull = g * gradient;
            let known = equation.known.map_or(0.0, |known| g * known.flat()[i]);
            *residual = theta * equation.drift(i) - (pull + known) - delta;
            force = force.max(counted(pull, *residual));
        }
        force
    }

    /// Δ += δ; max |δ| and max |Δ| come back, not finite if a component is not.
    fn correct(&mut self) -> [f64; 2] {
        let (mut size, mut step, mut odd) = (0.0_f64, 0.0_f64, 0.0);
        for (delta, change) in self.delta.flat_mut().iter_mut().zip(self.place.flat()) {
            *delta += change;
            size = size.max(change.abs());
            step = step.max(delta.abs());
            // max() drops a NaN, and 0·x is 0 for a finite x only.
            odd += 0.0 * *delta;
        }
        [size + odd, step + odd]
    }

    /// G += J δ.
    fn turn<U: Unknown<D>>(&mut self) {
        if !U::EXACT {
            self.matrix.multiply_add(&self.place, &mut self.gradient);
            return;
        }
        self.rest.clear();
        self.matrix.multiply_add(&self.place, &mut self.rest);
        for (gradient, rest) in self.gradient.flat_mut().iter_mut().zip(self.rest.flat_mut()) {
            (*gradient, *rest) = two_sum(*gradient, *rest);
        }
    }

    fn solve_linear<U>(&mut self, Part { equation, theta, .. }: Part<'_, U, D>) {
        let g = if theta == 1.0 { equation.g } else { &self.scaled };
        self.matrix.solve(g, &mut self.place);
    }
}
