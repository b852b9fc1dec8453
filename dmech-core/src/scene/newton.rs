//! Solving the implicit steps of a scene.

use super::matrix::Matrix;
use super::terms::Topology;
use super::vectors::Vectors;
use crate::newton::NotConverged;
use crate::scheme::Effort;

/// Corrections with one factorisation before the Jacobian is taken anew.
const CHORD: u32 = 6;
/// Corrections before a starting point is given up.
const PATIENCE: u32 = 30;
/// The shortest progress in θ before the path counts as ended.
const SHORTEST: f64 = 1.0 / 4096.0;

/// Find Δ with  Δ + g (G(q + Δ) + known) = drift,  as for one body, with one g for each coordinate.
///
/// Parts shrink with the step as they do there: for a step of θh the drift is θ times as large and g θ² times.
pub(super) struct Equation<'a, const D: usize> {
    pub(super) q: &'a Vectors<D>,
    /// The low part of the position.
    pub(super) q_low: &'a Vectors<D>,
    pub(super) drift: &'a Vectors<D>,
    /// The part of the force that is known, if there is one.
    pub(super) known: Option<&'a Vectors<D>>,
    pub(super) g: &'a Vectors<D>,
    /// The velocity at the start, and 2/h: that at the end is v + rate (Δ − drift).
    pub(super) v: &'a Vectors<D>,
    pub(super) rate: f64,
    pub(super) max_iterations: u32,
}

/// The unknown force G and its Jacobian.
pub(super) trait Unknown<const D: usize> {
    /// G is linear in b and v.
    const LINEAR: bool;
    /// G depends on the velocity at the end of the step.
    const FORCED: bool;

    /// out ← G(b, v), for a part θ of the step.
    fn gradient(&self, theta: f64, b: &Vectors<D>, v: &Vectors<D>, out: &mut Vectors<D>);
    /// out += ∂G/∂b + rate ∂G/∂v.
    fn jacobian(&self, theta: f64, b: &Vectors<D>, v: &Vectors<D>, rate: f64, out: &mut Matrix<D>);
}

/// The Newton matrix and the vectors of an iteration, allocated once.
#[derive(Clone, Debug)]
pub struct Solver<const D: usize> {
    matrix: Matrix<D>,
    /// Δ; the guess before a solution.
    pub(super) delta: Vectors<D>,
    /// G at the solution, G + J δ of the last correction.
    pub(super) gradient: Vectors<D>,
    correction: Vectors<D>,
    end: Vectors<D>,
    velocity: Vectors<D>,
    first: Vectors<D>,
    slope: Vectors<D>,
}

impl<const D: usize> Solver<D> {
    pub(super) fn new(bodies: usize, topology: &Topology) -> Self {
        let zeros = Vectors::zeros(bodies);
        Solver {
            matrix: Matrix::new(bodies, topology),
            delta: zeros.clone(),
            gradient: zeros.clone(),
            correction: zeros.clone(),
            end: zeros.clone(),
            velocity: zeros.clone(),
            first: zeros.clone(),
            slope: zeros,
        }
    }

    /// Solves from the guess in `delta`; the gradient at the solution is then in `gradient`.
    pub(super) fn solve<U: Unknown<D>>(
        &mut self,
        equation: &Equation<'_, D>,
        unknown: &U,
    ) -> Result<Effort, NotConverged> {
        match self.settle(equation, unknown, 1.0) {
            Ok(iterations) => Ok(Effort { evaluations: iterations, iterations }),
            Err(astray) => self.lengthen(equation, unknown, astray.iterations as u32),
        }
    }

    /// Newton with one factorisation for several corrections, for a part θ of the step.
    ///
    /// What must be right is the force: after the correction δₖ that of G + J δₖ is off by about r |δₖ|/g, where r is the
    /// rate at which corrections shrink. Of the first, r is |δ|/|Δ|: the force is taken to vary over lengths no shorter than
    /// the step. Below rounding by a margin, as neglected terms keep their sign and add up.
    fn settle<U: Unknown<D>>(
        &mut self,
        equation: &Equation<'_, D>,
        unknown: &U,
        theta: f64,
    ) -> Result<u32, NotConverged> {
        const MARGIN: f64 = f64::EPSILON / 64.0;
        let mut last = f64::NAN;
        let mut since_factors = 0;
        for iteration in 1..=PATIENCE.min(equation.max_iterations) {
            self.place::<U>(equation);
            unknown.gradient(theta, &self.end, &self.velocity, &mut self.gradient);
            if iteration == 1 || since_factors == CHORD {
                self.matrix.clear();
                unknown.jacobian(theta, &self.end, &self.velocity, equation.rate, &mut self.matrix);
                if !self.factorise(equation, theta) {
                    return Err(NotConverged { iterations: iteration.into(), residual: f64::NAN });
                }
                since_factors = 0;
            }
            since_factors += 1;
            let force = self.residual(equation, theta);
            self.matrix.solve(&mut self.correction);
            self.matrix.multiply_add(&self.correction, &mut self.gradient);
            let [size, step] = self.correct();
            if !(size.is_finite() && step.is_finite()) || (iteration == 1 && size > step) {
                return Err(NotConverged { iterations: iteration.into(), residual: size });
            }
            let rate = if iteration == 1 { size / step } else { size / last };
            let settled = size == 0.0 || U::LINEAR || rate * size <= MARGIN * force;
            // Corrections that no longer shrink and that a position can no longer show: forces that cancel, as in an
            // equilibrium, are not known better.
            let at_rounding =
                iteration > 2 && rate > 0.25 && size <= 4.0 * f64::EPSILON * equation.q.largest().max(step);
            if settled || at_rounding {
                return Ok(iteration);
            }
            if iteration > 1 && rate > 0.5 {
                if since_factors <= 1 {
                    return Err(NotConverged { iterations: iteration.into(), residual: size });
                }
                since_factors = CHORD;
            }
            last = size;
        }
        Err(NotConverged { iterations: PATIENCE.min(equation.max_iterations).into(), residual: last })
    }

    /// Follows the root from a step of length 0 to the whole step.
    #[cold]
    fn lengthen<U: Unknown<D>>(
        &mut self,
        equation: &Equation<'_, D>,
        unknown: &U,
        spent: u32,
    ) -> Result<Effort, NotConverged> {
        let mut evaluations = spent + 1;
        self.delta.clear();
        self.place::<U>(equation);
        unknown.gradient(0.0, &self.end, &self.velocity, &mut self.first);
        self.slope.clear();
        let (mut theta, mut advance, mut residual) = (0.0, 0.25, f64::NAN);
        while evaluations < equation.max_iterations && advance >= SHORTEST {
            let next = f64::min(theta + advance, 1.0);
            let ahead = next - theta;
            for i in 0..self.delta.flat().len() {
                let known = equation.known.map_or(0.0, |known| known.flat()[i]);
                let force = known + ahead * self.slope.flat()[i] + self.first.flat()[i];
                self.delta.flat_mut()[i] = next * equation.drift.flat()[i] - next * next * equation.g.flat()[i] * force;
            }
            match self.settle(equation, unknown, next) {
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
                    advance *= 2.0;
                }
                Err(astray) => {
                    evaluations += astray.iterations as u32;
                    residual = astray.residual;
                    advance *= 0.25;
                }
            }
        }
        Err(NotConverged { iterations: evaluations.into(), residual })
    }

    /// b = q + Δ and, where it is needed, v at the end of the step.
    fn place<U: Unknown<D>>(&mut self, equation: &Equation<'_, D>) {
        let Equation { q, q_low, drift, v, rate, .. } = *equation;
        let (delta, end) = (self.delta.flat(), self.end.flat_mut());
        for (((end, q), low), delta) in end.iter_mut().zip(q.flat()).zip(q_low.flat()).zip(delta) {
            *end = q + (low + delta);
        }
        if U::FORCED {
            let known = v.flat().iter().zip(drift.flat());
            for ((end, (v, drift)), delta) in self.velocity.flat_mut().iter_mut().zip(known).zip(delta) {
                *end = rate * (delta - drift) + v;
            }
        }
    }

    /// drift − g (G + known) − Δ; the largest |g G| comes back.
    fn residual(&mut self, equation: &Equation<'_, D>, theta: f64) -> f64 {
        let square = theta * theta;
        let mut force = 0.0_f64;
        let out = self.correction.flat_mut().iter_mut().zip(self.delta.flat());
        let coefficients = equation.g.flat().iter().zip(equation.drift.flat());
        let forces = self.gradient.flat().iter().enumerate();
        for (((residual, delta), (g, drift)), (i, gradient)) in out.zip(coefficients).zip(forces) {
            let g = square * g;
            let pull = g * gradient;
            force = force.max(pull.abs());
            let known = equation.known.map_or(0.0, |known| g * known.flat()[i]);
            *residual = theta * drift - (pull + known) - delta;
        }
        force
    }

    /// Δ += δ; max |δ| and max |Δ| come back, not finite if a component is not.
    fn correct(&mut self) -> [f64; 2] {
        let (mut size, mut step, mut odd) = (0.0_f64, 0.0_f64, 0.0);
        for (delta, change) in self.delta.flat_mut().iter_mut().zip(self.correction.flat()) {
            *delta += change;
            size = size.max(change.abs());
            step = step.max(delta.abs());
            // max() drops a NaN, and 0·x is 0 for a finite x only.
            odd += 0.0 * *delta;
        }
        [size + odd, step + odd]
    }

    fn factorise(&mut self, equation: &Equation<'_, D>, theta: f64) -> bool {
        if theta == 1.0 {
            return self.matrix.factorise(equation.g);
        }
        self.velocity.clone_from(equation.g);
        self.velocity.flat_mut().iter_mut().for_each(|g| *g *= theta * theta);
        self.matrix.factorise(&self.velocity)
    }
}
