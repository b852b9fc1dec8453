//! The implicit instructions of a scene: Newton over all coordinates together.

use crate::newton::NotConverged;
use crate::scene::compensated::CompensatedVectors;
use crate::scene::matrix::Matrix;
use crate::scene::newton::{Equations, Solver, Unknown};
use crate::scene::system::{SceneStride, SceneSystem};
use crate::scene::terms::stencil::Stencil;
use crate::scene::terms::{Acts, Driven};
use crate::scene::vectors::Vectors;
use crate::scheme::Effort;
use crate::system::{Ahead, Step};

/// The Newton matrix and the vectors of an iteration, allocated once: N² numbers where any two bodies are linked.
#[derive(Clone, Debug)]
pub struct SceneSolver<const D: usize> {
    newton: Solver<D>,
    /// The part of the slope that is known: −F/2 or −F at the start of the step, where there are forces.
    known: Vectors<D>,
}

/// ∇Φ(b) − F(b, v) at the end of the step.
struct AtEnd<'a, A> {
    acts: &'a A,
    t: f64,
}

impl<const D: usize, A: Acts<D>> Unknown<D> for AtEnd<'_, A> {
    const LINEAR: bool = A::LINEAR && !A::FORCED;
    const PIECEWISE: bool = A::PIECEWISE;
    const CHAIN: bool = A::CHAIN;
    const FORCED: bool = A::FORCED;
    const EXACT: bool = false;

    fn gradient(&self, _: f64, b: &Vectors<D>, v: &Vectors<D>, out: &mut Vectors<D>) {
        self.acts.set_gradient(b, self.t, out);
        self.acts.subtract_force(1.0, b, v, self.t, out);
    }

    fn jacobian(&self, _: f64, b: &Vectors<D>, v: &Vectors<D>, rate: f64, out: &mut Matrix<D>) {
        self.acts.add_hessian(1.0, b, self.t, out);
        self.acts.subtract_force_jacobian(1.0, b, v, self.t, rate, out);
    }

    #[inline(always)]
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>) {
        self.acts.add_stencil(b, self.t, first, out);
    }
}

/// ∇̄Φ(a, b) − F(b, v)/2.
struct Exact<'a, const D: usize, A> {
    acts: &'a A,
    a: &'a Vectors<D>,
    middle: f64,
    end: f64,
}

impl<const D: usize, A: Acts<D>> Unknown<D> for Exact<'_, D, A> {
    const LINEAR: bool = A::LINEAR && !A::FORCED;
    const PIECEWISE: bool = A::PIECEWISE;
    const CHAIN: bool = A::CHAIN;
    const FORCED: bool = A::FORCED;
    const EXACT: bool = true;

    fn gradient(&self, _: f64, b: &Vectors<D>, v: &Vectors<D>, out: &mut Vectors<D>) {
        self.acts.set_discrete_gradient(self.a, b, self.middle, out);
        self.acts.subtract_force(0.5, b, v, self.end, out);
    }

    fn jacobian(&self, _: f64, b: &Vectors<D>, v: &Vectors<D>, rate: f64, out: &mut Matrix<D>) {
        self.acts.add_discrete_jacobian(self.a, b, self.middle, out);
        self.acts.subtract_force_jacobian(0.5, b, v, self.end, rate, out);
    }

    #[inline(always)]
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>) {
        self.acts.add_discrete_stencil(self.a, b, self.middle, first, out);
    }
}

/// ∇̄Φ(q₋, b).
struct Across<'a, const D: usize, A> {
    acts: &'a A,
    before: &'a Vectors<D>,
    q: &'a Vectors<D>,
    t: f64,
}

impl<const D: usize, A> Across<'_, D, A> {
    /// q + θ (q₋ − q): both ends move as the step is lengthened.
    fn behind(&self, theta: f64) -> Vectors<D> {
        let mut a = self.q.clone();
        for (a, before) in a.flat_mut().iter_mut().zip(self.before.flat()) {
            *a += theta * (before - *a);
        }
        a
    }
}

impl<const D: usize, A: Acts<D>> Unknown<D> for Across<'_, D, A> {
    const LINEAR: bool = A::LINEAR;
    const PIECEWISE: bool = A::PIECEWISE;
    const CHAIN: bool = A::CHAIN;
    const FORCED: bool = false;
    const EXACT: bool = true;

    fn gradient(&self, theta: f64, b: &Vectors<D>, _: &Vectors<D>, out: &mut Vectors<D>) {
        if theta == 1.0 {
            self.acts.set_discrete_gradient(self.before, b, self.t, out);
        } else {
            self.acts.set_discrete_gradient(&self.behind(theta), b, self.t, out);
        }
    }

    fn jacobian(&self, theta: f64, b: &Vectors<D>, _: &Vectors<D>, _: f64, out: &mut Matrix<D>) {
        if theta == 1.0 {
            self.acts.add_discrete_jacobian(self.before, b, self.t, out);
        } else {
            self.acts.add_discrete_jacobian(&self.behind(theta), b, self.t, out);
        }
    }

    #[inline(always)]
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>) {
        self.acts.add_discrete_stencil(self.before, b, self.t, first, out);
    }
}

/// The equation of a step, with the part of the slope that is known.
fn equation<'a, const D: usize, A: Acts<D>>(
    step: &Step<'a, SceneSystem<D, A>>,
    known: Option<&'a Vectors<D>>,
) -> Equations<'a, D> {
    let Step { stride, q, v, ahead, newton, .. } = *step;
    let last = match ahead {
        Ahead::Continued(last) => last,
        // Three equal slopes continue to themselves.
        Ahead::Expected(expected) => [expected; 3],
    };
    Equations {
        q: &q.hi,
        q_low: &q.lo,
        h: stride.dt,
        known,
        g: &stride.g,
        v: &v.hi,
        v_low: &v.lo,
        rate: 2.0 / stride.dt,
        last,
        last_are_whole: true,
        newton,
    }
}

impl<const D: usize> SceneSolver<D> {
    pub(super) fn new<A: Acts<D>>(bodies: usize, acts: &A) -> Self {
        let known = Vectors::zeros(if A::FORCED { bodies } else { 0 });
        SceneSolver { newton: Solver::for_links(bodies, &acts.links(bodies)), known }
    }

    pub(super) fn mean<A: Acts<D>>(
        &mut self,
        acts: &Driven<D, A>,
        step: &Step<'_, SceneSystem<D, A>>,
        known: &Vectors<D>,
    ) -> Result<Effort, NotConverged> {
        let equation = Equations { last_are_whole: false, ..equation(step, Some(known)) };
        self.newton.solve(&equation, &AtEnd { acts, t: step.t + step.stride.dt })
    }

    pub(super) fn exact<A: Acts<D>>(
        &mut self,
        acts: &Driven<D, A>,
        step: &Step<'_, SceneSystem<D, A>>,
    ) -> Result<Effort, NotConverged> {
        let SceneSolver { newton, known } = self;
        let (t, h) = (step.t, step.stride.dt);
        // The share of the force at the start of the step is known.
        known_force(acts, 0.5, step, known);
        let unknown = Exact { acts, a: &step.q.hi, middle: t + 0.5 * h, end: t + h };
        let effort = newton.solve(&equation(step, A::FORCED.then_some(&*known)), &unknown)?;
        self.add_known::<A>();
        Ok(effort)
    }

    pub(super) fn across<A: Acts<D>>(
        &mut self,
        acts: &Driven<D, A>,
        step: &Step<'_, SceneSystem<D, A>>,
        before: &Vectors<D>,
    ) -> Result<Effort, NotConverged> {
        let SceneSolver { newton, known } = self;
        // A force beside the potential is that at the position now.
        known_force(acts, 1.0, step, known);
        let unknown = Across { acts, before, q: &step.q.hi, t: step.t };
        let equation = Equations { rate: 0.0, ..equation(step, A::FORCED.then_some(&*known)) };
        let effort = newton.solve(&equation, &unknown)?;
        self.add_known::<A>();
        Ok(effort)
    }

    fn add_known<A: Acts<D>>(&mut self) {
        if A::FORCED {
            for (found, known) in self.newton.gradient.flat_mut().iter_mut().zip(self.known.flat()) {
                *found += known;
            }
        }
    }

    pub(super) fn settle(
        &self,
        stride: &SceneStride<D>,
        share: f64,
        q: &mut CompensatedVectors<D>,
        v: &mut CompensatedVectors<D>,
    ) {
        let (kick, found, rest) = (stride.kick.flat(), self.newton.gradient.flat(), self.newton.rest.flat());
        let change = |i: usize| [-kick[i] * found[i], -kick[i] * rest[i]];
        CompensatedVectors::kick_in_parts_and_drift(q, v, stride.dt, share, change);
    }

    pub(super) fn settle_mean(
        &self,
        stride: &SceneStride<D>,
        known: &Vectors<D>,
        q: &mut CompensatedVectors<D>,
        v: &mut CompensatedVectors<D>,
    ) {
        let (kick, known, found) = (stride.kick.flat(), known.flat(), self.newton.gradient.flat());
        let change = |i: usize| -0.5 * kick[i] * (known[i] + found[i]);
        CompensatedVectors::kick_and_drift(q, v, stride.dt, 0.5, change);
    }

    pub(super) fn gradient(&self) -> &Vectors<D> {
        &self.newton.gradient
    }

    pub(super) fn gradient_mut(&mut self) -> &mut Vectors<D> {
        &mut self.newton.gradient
    }

    pub(super) fn moved(&self) -> &Vectors<D> {
        &self.newton.delta
    }
}

/// known ← −c F at the start of the step.
fn known_force<const D: usize, A: Acts<D>>(
    acts: &Driven<D, A>,
    c: f64,
    step: &Step<'_, SceneSystem<D, A>>,
    known: &mut Vectors<D>,
) {
    if A::FORCED {
        known.clear();
        acts.subtract_force(c, &step.q.hi, &step.v.hi, step.t, known);
    }
}
