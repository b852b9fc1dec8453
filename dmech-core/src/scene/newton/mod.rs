//! Solving the implicit steps of a scene.

mod chain;
mod progress;
#[cfg(test)]
mod tests;

use core::ops::Range;

use dmech_scalar::{Lanes, Real, two_sum};

use self::chain::Elimination;
use self::progress::{Progress, Verdict};
use super::matrix::{Kind, Matrix};
use super::terms::stencil::{Stencil, block, load, store};
use super::topology::Topology;
use super::vectors::Vectors;
use crate::newton::NotConverged;
use crate::newton::continuation::SWIFT;
use crate::system::{Effort, Guess, Newton};

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
/// Corrections that no longer shrink, and are less than this times the positions, may be rounding.
const NEAR: f64 = 1e-6;
/// A residual of so many units in the last place of the parts of the equation is rounding.
const ROUNDINGS: f64 = 4.0;
/// The shortest progress in θ before the path counts as ended: forces may push bodies out of one another 10⁶ times as far as they
/// are apart.
const SHORTEST: f64 = 1.0 / 16_777_216.0;
/// Progress in θ that does not go over to another root, as that of two bodies on a spring which have changed places.
const SHORT: f64 = 1.0 / 64.0;

/// Find Δ with  Δ + g (G(q + Δ) + known) = drift,  as for one body, with one g for each coordinate.
///
/// Parts shrink with the step as they do there: for a step of θh the drift is θ times as large and g θ² times.
pub(super) struct Equations<'a, const D: usize> {
    pub(super) q: &'a Vectors<D>,
    /// The low part of the position.
    pub(super) q_low: &'a Vectors<D>,
    /// h: the drift is h (v + its low part).
    pub(super) h: f64,
    /// The part of the force that is known, if there is one.
    pub(super) known: Option<&'a Vectors<D>>,
    pub(super) g: &'a Vectors<D>,
    /// The velocity at the start and its low part, and 2/h: that at the end is v + rate (Δ − drift).
    pub(super) v: &'a Vectors<D>,
    pub(super) v_low: &'a Vectors<D>,
    pub(super) rate: f64,
    /// The forces of the last three steps, the newest first, which the guess continues by a parabola.
    pub(super) last: [&'a Vectors<D>; 3],
    /// The known part is among them.
    pub(super) last_are_whole: bool,
    pub(super) newton: &'a Newton,
}

impl<const D: usize> Equations<'_, D> {
    /// h v, component i.
    #[inline(always)]
    fn drift(&self, i: usize) -> f64 {
        self.h * self.v.flat()[i] + self.h * self.v_low.flat()[i]
    }

    /// The same for some components, eight at most.
    #[inline(always)]
    fn drifts(&self, range: Range<usize>) -> Lanes {
        let h = Lanes::splat(self.h);
        h * load(self.v.flat(), range.clone()) + h * load(self.v_low.flat(), range)
    }

    /// The first Δ: h v − g (known + 3G − 3G₋ + G₋₋), for some components, eight at most.
    #[inline(always)]
    fn guess(&self, range: Range<usize>) -> Lanes {
        if self.newton.start() == Guess::Previous {
            return Lanes::ZERO;
        }
        let of = |x: &Vectors<D>| load(x.flat(), range.clone());
        let [last, before, earlier] = self.last.map(of);
        let mut force = Lanes::splat(3.0) * (last - before) + earlier;
        if let Some(known) = self.known.filter(|_| !self.last_are_whole) {
            force += of(known);
        }
        self.drifts(range.clone()) - of(self.g) * force
    }
}

/// The unknown force G and its Jacobian.
pub(super) trait Unknown<const D: usize> {
    /// G is linear in b, with a symmetric Jacobian, and does not depend on v.
    const LINEAR: bool;
    /// G may bend or jump between two iterates.
    const PIECEWISE: bool;
    /// No others than consecutive bodies are linked.
    const CHAIN: bool;
    /// G depends on the velocity at the end of the step.
    const FORCED: bool;
    /// The step conserves the energy: what rounding keeps from G, always of one sign where corrections are, is asked for.
    const EXACT: bool;

    /// out ← G(b, v), for a part θ of the step.
    fn gradient(&self, theta: f64, b: &Vectors<D>, v: &Vectors<D>, out: &mut Vectors<D>);
    /// out += ∂G/∂b + rate ∂G/∂v.
    fn jacobian(&self, theta: f64, b: &Vectors<D>, v: &Vectors<D>, rate: f64, out: &mut Matrix<D>);
    /// Both for the bodies of a chain from `first` on, for the whole step and a G that does not depend on the velocity.
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>);
}

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
    chain: Option<Elimination<D>>,
    /// Δ.
    pub(super) delta: Vectors<D>,
    /// G at the solution, G + J δ of the last correction.
    pub(super) gradient: Vectors<D>,
    /// What the rounding of that sum left out, where the step conserves the energy.
    pub(super) rest: Vectors<D>,
    /// The position at the end of the step, and then the residual and the correction, which do not need it any more: a
    /// long chain is as fast as little memory is touched.
    place: Vectors<D>,
    velocity: Vectors<D>,
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
            chain: (*topology == Topology::Chain).then(|| Elimination::new(bodies)),
            delta: zeros.clone(),
            gradient: zeros.clone(),
            rest: zeros.clone(),
            place: zeros.clone(),
            velocity: zeros.clone(),
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
        let settled = match self.chain.take() {
            Some(mut chain) if U::CHAIN && !U::FORCED => {
                let settled = self.settle_chain(&mut chain, equation, unknown);
                if U::EXACT {
                    core::mem::swap(&mut self.rest, chain.rest());
                }
                self.chain = Some(chain);
                settled.or_else(|astray| self.finish(equation, unknown, 1.0, astray))
            }
            chain => {
                self.chain = chain;
                self.guess(equation);
                self.settle(equation, unknown, 1.0, Trial::OF_GUESS)
            }
        };
        match settled {
            Ok(iterations) => Ok(Effort { evaluations: iterations, iterations }),
            // Of a linear force there is no other root.
            Err(astray) if U::LINEAR && astray == NotConverged::NOT_CONTINUED => Err(astray),
            Err(astray) => match self.lengthen(equation, unknown, astray, 1.0) {
                Err(lost) if lost == NotConverged::NOT_CONTINUED => self.lengthen(equation, unknown, lost, SHORT),
                found => found,
            },
        }
    }

    /// Newton for a part θ of the step.
    fn settle<U: Unknown<D>>(
        &mut self,
        equation: &Equations<'_, D>,
        unknown: &U,
        theta: f64,
        trial: Trial,
    ) -> Result<u32, NotConverged> {
        let settled = self.approach(equation, unknown, theta, trial);
        settled.or_else(|astray| self.finish(equation, unknown, theta, astray))
    }

    /// Corrections until one is so small that the force is known to rounding, or until they no longer shrink.
    fn approach<U: Unknown<D>>(
        &mut self,
        equation: &Equations<'_, D>,
        unknown: &U,
        theta: f64,
        trial: Trial,
    ) -> Result<u32, NotConverged> {
        let mut progress = Progress::default();
        let mut since_factors = 0;
        let limit = trial.limit(equation.newton);
        for iteration in 1..=limit {
            self.place::<U>(equation);
            unknown.gradient(theta, &self.place, &self.velocity, &mut self.gradient);
            if iteration == 1 || since_factors == trial.chord {
                if !self.take_jacobian(equation, unknown, theta) {
                    return Err(unfit::<U, D>(iteration));
                }
                since_factors = 0;
            }
            since_factors += 1;
            let force = self.residual(equation, theta);
            self.solve_linear(equation, theta);
            self.turn::<U>();
            let [size, step] = self.correct();
            match progress.judge::<U, D>(equation, iteration, [size, step, force])? {
                Verdict::Settled => return self.continued(equation, unknown, theta, iteration),
                Verdict::GoesOn => {}
                Verdict::Slow if since_factors > 1 => since_factors = trial.chord,
                Verdict::Slow => return Err(NotConverged { iterations: iteration.into(), residual: size }),
            }
        }
        Err(progress.exhausted(limit))
    }

    /// The Jacobian at the place of the position, and the factors of its matrix; `false` if that is not as it must be.
    fn take_jacobian<U: Unknown<D>>(&mut self, equation: &Equations<'_, D>, unknown: &U, theta: f64) -> bool {
        self.matrix.clear();
        unknown.jacobian(theta, &self.place, &self.velocity, equation.rate, &mut self.matrix);
        self.factorise(equation, theta, kind::<U, D>())
    }

    /// Where corrections no longer shrink: one more, with a Jacobian of its own. It is the last if what it corrects is
    /// nothing but rounding; if not, they lead nowhere, as `astray` says.
    #[cold]
    fn finish<U: Unknown<D>>(
        &mut self,
        equation: &Equations<'_, D>,
        unknown: &U,
        theta: f64,
        astray: NotConverged,
    ) -> Result<u32, NotConverged> {
        let near = astray.residual <= NEAR * (equation.q.largest() + self.delta.largest());
        if !near {
            return Err(astray);
        }
        self.place::<U>(equation);
        unknown.gradient(theta, &self.place, &self.velocity, &mut self.gradient);
        if !self.take_jacobian(equation, unknown, theta) {
            return Err(astray);
        }
        self.residual(equation, theta);
        let rounding = self.residual_is_rounding(equation, theta);
        self.solve_linear(equation, theta);
        self.turn::<U>();
        let [size, _] = self.correct();
        if rounding && size.is_finite() {
            self.continued(equation, unknown, theta, astray.iterations as u32 + 1)
        } else {
            Err(astray)
        }
    }

    /// The root found after so many corrections, if 1 + g J there may be that of a root which continues that of a shorter step.
    ///
    /// The factors in use are of a place before the last corrections. Those have shrunk, so that they are factors of a matrix with
    /// a determinant of the same sign; but J may jump in between, and before a root is refused J is taken where it is.
    fn continued<U: Unknown<D>>(
        &mut self,
        equation: &Equations<'_, D>,
        unknown: &U,
        theta: f64,
        iterations: u32,
    ) -> Result<u32, NotConverged> {
        if U::LINEAR || self.matrix.is_positive() || self.matrix_continues(equation, theta) {
            return Ok(iterations);
        }
        self.continued_from_here(equation, unknown, theta).then_some(iterations).ok_or(NotConverged::NOT_CONTINUED)
    }

    /// The same, with J at the root.
    #[cold]
    fn continued_from_here<U: Unknown<D>>(&mut self, equation: &Equations<'_, D>, unknown: &U, theta: f64) -> bool {
        self.place::<U>(equation);
        self.take_jacobian(equation, unknown, theta) && self.matrix_continues(equation, theta)
    }

    fn matrix_continues(&mut self, equation: &Equations<'_, D>, theta: f64) -> bool {
        let g = if theta == 1.0 { equation.g } else { &self.scaled };
        self.matrix.continues(g)
    }

    /// Whether the residual is what rounding makes of the equation, for every coordinate: of h v, of the forces, of Δ, and,
    /// as forces are those of rounded positions and cancel one another, of J times the positions.
    fn residual_is_rounding(&mut self, equation: &Equations<'_, D>, theta: f64) -> bool {
        let reach = equation.q.largest() + self.delta.largest() + equation.h.abs() * equation.v.largest();
        // Until the correction is made it is of no use.
        let stiffness = &mut self.rest;
        stiffness.clear();
        self.matrix.add_row_sums(stiffness);
        self.place.flat().iter().enumerate().all(|(i, residual)| {
            let known = equation.known.map_or(0.0, |known| known.flat()[i].abs());
            let force = self.gradient.flat()[i].abs() + known + stiffness.flat()[i] * reach;
            let parts = theta * equation.drift(i).abs() + self.delta.flat()[i].abs();
            residual.abs() <= ROUNDINGS * f64::EPSILON * (theta * theta * equation.g.flat()[i].abs() * force + parts)
        })
    }

    /// Follows the root from a step of length 0 to the whole step, by progress in θ of no more than `longest`. If that may be all of it,
    /// the whole step is tried from Δ = 0 first, [as for one body](SWIFT).
    #[cold]
    fn lengthen<U: Unknown<D>>(
        &mut self,
        equation: &Equations<'_, D>,
        unknown: &U,
        astray: NotConverged,
        longest: f64,
    ) -> Result<Effort, NotConverged> {
        let mut evaluations = astray.iterations as u32 + 1;
        self.delta.clear();
        self.place::<U>(equation);
        unknown.gradient(0.0, &self.place, &self.velocity, &mut self.first);
        self.slope.clear();
        let (mut theta, mut advance, mut ending) = (0.0, longest, astray);
        while evaluations < equation.newton.limit() && advance >= SHORTEST {
            let next = f64::min(theta + advance, 1.0);
            let ahead = next - theta;
            let trial = if ahead == 1.0 { Trial::AT_REST } else { Trial::FOLLOWED };
            if ahead == 1.0 {
                self.delta.clear();
            } else {
                self.predict(equation, next, ahead);
            }
            let settled = self.settle(equation, unknown, next, trial);
            // On top of a hill the step from Δ = 0 has turned round, which the determinant alone does not tell.
            let doubted = ahead == 1.0 && settled.is_ok() && !self.matrix.is_positive();
            match if doubted { Err(NotConverged::NOT_CONTINUED) } else { settled } {
                Ok(iterations) => {
                    evaluations += iterations;
                    if next >= 1.0 {
                        return Ok(Effort { evaluations, iterations: evaluations });
                    }
                    for i in 0..self.delta.flat().len() {
                        self.slope.flat_mut()[i] = (self.gradient.flat()[i] - self.first.flat()[i]) / ahead;
                    }
                    self.first.clone_from(&self.gradient);
                    theta = next;
                    advance = f64::min(2.0 * advance, longest);
                }
                Err(astray) => {
                    evaluations += u32::max(astray.iterations as u32, 1);
                    ending = astray;
                    advance *= 0.25;
                }
            }
        }
        if [astray, ending].contains(&NotConverged::NOT_CONTINUED) {
            return Err(NotConverged::NOT_CONTINUED);
        }
        Err(NotConverged { iterations: evaluations.into(), residual: ending.residual })
    }

    /// Δ for a part θ of the step, with the force continued over the last `ahead` of it by its slope.
    fn predict(&mut self, equation: &Equations<'_, D>, theta: f64, ahead: f64) {
        for i in 0..self.delta.flat().len() {
            let known = equation.known.map_or(0.0, |known| known.flat()[i]);
            let force = known + ahead * self.slope.flat()[i] + self.first.flat()[i];
            self.delta.flat_mut()[i] = theta * equation.drift(i) - theta * theta * equation.g.flat()[i] * force;
        }
    }

    /// The first Δ: h v − g (known + 3G − 3G₋ + G₋₋), with the last three forces continued by a parabola.
    fn guess(&mut self, equation: &Equations<'_, D>) {
        for first in (0..self.delta.flat().len()).step_by(Lanes::COUNT) {
            let range = block(first, self.delta.flat().len());
            store(equation.guess(range.clone()), self.delta.flat_mut(), range);
        }
    }

    /// b = q + Δ and, where it is needed, v at the end of the step.
    fn place<U: Unknown<D>>(&mut self, equation: &Equations<'_, D>) {
        let Equations { q, q_low, v, rate, .. } = *equation;
        let (delta, place) = (self.delta.flat(), self.place.flat_mut());
        for (((place, q), low), delta) in place.iter_mut().zip(q.flat()).zip(q_low.flat()).zip(delta) {
            *place = q + (low + delta);
        }
        if U::FORCED {
            let known = v.flat().iter().zip(delta).enumerate();
            for (end, (i, (v, delta))) in self.velocity.flat_mut().iter_mut().zip(known) {
                *end = rate * (delta - equation.drift(i)) + v;
            }
        }
    }

    /// drift − g (G + known) − Δ, in the place of the position; the largest |g G| comes back, [as it counts](counted).
    fn residual(&mut self, equation: &Equations<'_, D>, theta: f64) -> f64 {
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

    fn factorise(&mut self, equation: &Equations<'_, D>, theta: f64, must_be: Kind) -> bool {
        if theta == 1.0 {
            return self.matrix.factorise(equation.g, must_be);
        }
        self.scaled.clone_from(equation.g);
        self.scaled.flat_mut().iter_mut().for_each(|g| *g *= theta * theta);
        self.matrix.factorise(&self.scaled, must_be)
    }

    fn solve_linear(&mut self, equation: &Equations<'_, D>, theta: f64) {
        let g = if theta == 1.0 { equation.g } else { &self.scaled };
        self.matrix.solve(g, &mut self.place);
    }
}
