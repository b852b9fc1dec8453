//! The implicit instructions of a scene: Newton over all coordinates together.

use crate::newton::NotConverged;
use crate::scene::compensated::CompensatedVectors;
use crate::scene::driven::Driven;
use crate::scene::matrix::Matrix;
use crate::scene::newton::{Equations, Solver, Unknown};
use crate::scene::system::{SceneStride, SceneSystem};
use crate::scene::terms::Acts;
use crate::scene::terms::stencil::Stencil;
use crate::scene::vectors::Vectors;
use crate::scheme::Effort;
use crate::system::{Ahead, ImplicitSteps, Step};

/// The Newton matrix and the vectors of an iteration, allocated once: N² numbers where any two bodies are linked.
#[derive(Clone, Debug)]
pub struct SceneSolver<const D: usize> {
    newton: Solver<D>,
    /// The part of the slope that is known: −F/2 or −F at the start of the step, where there are forces.
    known: Vectors<D>,
}

/// ∇Φ(b) − F(b, v) at the end of the step.
struct AtEnd<'a, const D: usize, A> {
    acts: &'a Driven<D, A>,
    t: f64,
}

impl<const D: usize, A: Acts<D>> Unknown<D> for AtEnd<'_, D, A> {
    const LINEAR: bool = A::LINEAR && !A::FORCED;
    const PIECEWISE: bool = A::PIECEWISE;
    const CHAIN: bool = A::CHAIN;
    const FORCED: bool = A::FORCED;
    const EXACT: bool = false;

    fn gradient(&self, _: f64, b: &Vectors<D>, [x, v]: [&Vectors<D>; 2], out: &mut Vectors<D>) {
        self.acts.set_gradient(b, self.t, out);
        self.acts.subtract_force(1.0, x, v, self.t, out);
    }

    fn jacobian(&self, _: f64, b: &Vectors<D>, [x, v]: [&Vectors<D>; 2], rate: f64, out: &mut Matrix<D>) {
        self.acts.at(self.t, b, |terms, b| terms.add_hessian(1.0, b, self.t, out));
        self.acts.subtract_force_jacobian(1.0, x, v, self.t, rate, out);
    }

    #[inline(always)]
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>) {
        self.acts.terms.add_stencil(b, self.t, first, out);
    }
}

/// All forces beside the potential do no work: they are taken in the middle of the step.
const fn workless<const D: usize, A: Acts<D>>() -> bool {
    A::FORCED && A::CONSERVES_ENERGY
}

/// ∇̄Φ(a, b) − F(b, v)/2; of a force that does no work − F((a + b)/2, v̄).
struct Exact<'a, const D: usize, A> {
    acts: &'a Driven<D, A>,
    a: &'a Vectors<D>,
    middle: f64,
    end: f64,
}

impl<const D: usize, A: Acts<D>> Unknown<D> for Exact<'_, D, A> {
    const LINEAR: bool = A::LINEAR && !A::FORCED;
    const PIECEWISE: bool = A::PIECEWISE;
    const CHAIN: bool = A::CHAIN;
    const FORCED: bool = A::FORCED;
    const MIDDLE: bool = workless::<D, A>();
    const EXACT: bool = true;

    fn gradient(&self, _: f64, b: &Vectors<D>, [x, v]: [&Vectors<D>; 2], out: &mut Vectors<D>) {
        let (share, t) = if Self::MIDDLE { (1.0, self.middle) } else { (0.5, self.end) };
        self.acts.set_discrete_gradient(self.a, b, self.middle, out);
        self.acts.subtract_force(share, x, v, t, out);
    }

    /// Half of each mean is the end.
    fn jacobian(&self, _: f64, b: &Vectors<D>, [x, v]: [&Vectors<D>; 2], rate: f64, out: &mut Matrix<D>) {
        let t = if Self::MIDDLE { self.middle } else { self.end };
        self.acts.add_discrete_jacobian(self.a, b, self.middle, out);
        self.acts.subtract_force_jacobian(0.5, x, v, t, rate, out);
    }

    #[inline(always)]
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>) {
        self.acts.terms.add_discrete_stencil(self.a, b, self.middle, first, out);
    }
}

/// ∇̄Φ(q₋, b).
struct Across<'a, const D: usize, A> {
    acts: &'a Driven<D, A>,
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

    fn gradient(&self, theta: f64, b: &Vectors<D>, _: [&Vectors<D>; 2], out: &mut Vectors<D>) {
        if theta == 1.0 {
            self.acts.set_discrete_gradient(self.before, b, self.t, out);
        } else {
            self.acts.set_discrete_gradient(&self.behind(theta), b, self.t, out);
        }
    }

    fn jacobian(&self, theta: f64, b: &Vectors<D>, _: [&Vectors<D>; 2], _: f64, out: &mut Matrix<D>) {
        if theta == 1.0 {
            self.acts.add_discrete_jacobian(self.before, b, self.t, out);
        } else {
            self.acts.add_discrete_jacobian(&self.behind(theta), b, self.t, out);
        }
    }

    #[inline(always)]
    fn stencil(&self, b: &Vectors<D>, first: usize, out: &mut Stencil<D>) {
        self.acts.terms.add_discrete_stencil(self.before, b, self.t, first, out);
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

impl<const D: usize, A: Acts<D>> ImplicitSteps for SceneSystem<D, A> {
    type Solver = SceneSolver<D>;
    type Found = Effort;

    fn solver(&self) -> SceneSolver<D> {
        let bodies = self.masses.len();
        let known = Vectors::zeros(if A::FORCED { bodies } else { 0 });
        let mut newton = Solver::for_links(bodies, &self.acts.links(bodies));
        if workless::<D, A>() {
            newton.middle = Vectors::zeros(bodies);
        }
        SceneSolver { newton, known }
    }

    fn solve_mean(
        &self,
        solver: &mut SceneSolver<D>,
        step: &Step<'_, Self>,
        known: &Vectors<D>,
    ) -> Result<Effort, NotConverged> {
        let equation = Equations { last_are_whole: false, ..equation(step, Some(known)) };
        solver.newton.solve(&equation, &AtEnd { acts: &self.acts, t: step.t + step.stride.dt })
    }

    fn solve_exact(&self, solver: &mut SceneSolver<D>, step: &Step<'_, Self>) -> Result<Effort, NotConverged> {
        let (acts, t, h) = (&self.acts, step.t, step.stride.dt);
        let unknown = Exact { acts, a: &step.q.hi, middle: t + 0.5 * h, end: t + h };
        if workless::<D, A>() {
            return solver.newton.solve(&equation(step, None), &unknown);
        }
        // The share of the force at the start of the step is known.
        let known = known_force(acts, 0.5, step, &mut solver.known);
        let effort = solver.newton.solve(&equation(step, known), &unknown)?;
        solver.add_known::<A>();
        Ok(effort)
    }

    fn solve_across(
        &self,
        solver: &mut SceneSolver<D>,
        step: &Step<'_, Self>,
        before: &Vectors<D>,
    ) -> Result<Effort, NotConverged> {
        // A force beside the potential is that at the position now.
        let known = known_force(&self.acts, 1.0, step, &mut solver.known);
        let unknown = Across { acts: &self.acts, before, q: &step.q.hi, t: step.t };
        let effort = solver.newton.solve(&Equations { rate: 0.0, ..equation(step, known) }, &unknown)?;
        solver.add_known::<A>();
        Ok(effort)
    }

    fn settle(
        &self,
        solver: &mut SceneSolver<D>,
        stride: &SceneStride<D>,
        share: f64,
        _: &mut Effort,
        [q, v]: [&mut CompensatedVectors<D>; 2],
    ) {
        let (kick, excess) = (stride.kick.flat(), stride.excess.flat());
        let (found, rest) = (solver.newton.gradient.flat(), solver.newton.rest.flat());
        let change = |i: usize| [-kick[i] * found[i], excess[i] * found[i] - kick[i] * rest[i]];
        CompensatedVectors::kick_in_parts_and_drift(q, v, stride.dt, share, change);
    }

    fn settle_mean(
        &self,
        solver: &mut SceneSolver<D>,
        stride: &SceneStride<D>,
        known: &Vectors<D>,
        _: &mut Effort,
        [q, v]: [&mut CompensatedVectors<D>; 2],
    ) {
        let (kick, known, found) = (stride.kick.flat(), known.flat(), solver.newton.gradient.flat());
        let change = |i: usize| -0.5 * kick[i] * (known[i] + found[i]);
        CompensatedVectors::kick_and_drift(q, v, stride.dt, 0.5, change);
    }

    fn found<'a>(solver: &'a SceneSolver<D>, _: &'a Effort) -> &'a Vectors<D> {
        &solver.newton.gradient
    }

    fn moved<'a>(solver: &'a SceneSolver<D>, _: &'a Effort) -> &'a Vectors<D> {
        &solver.newton.delta
    }

    fn keep(solver: &mut SceneSolver<D>, _: &Effort, place: &mut Vectors<D>) {
        core::mem::swap(&mut solver.newton.gradient, place);
    }

    fn effort(found: &Effort) -> Effort {
        *found
    }
}

impl<const D: usize> SceneSolver<D> {
    /// The slope that was found is that of all that acts.
    fn add_known<A: Acts<D>>(&mut self) {
        if A::FORCED {
            for (found, known) in self.newton.gradient.flat_mut().iter_mut().zip(self.known.flat()) {
                *found += known;
            }
        }
    }
}

/// known ← −c F at the start of the step, where there are forces.
fn known_force<'a, const D: usize, A: Acts<D>>(
    acts: &Driven<D, A>,
    c: f64,
    step: &Step<'_, SceneSystem<D, A>>,
    known: &'a mut Vectors<D>,
) -> Option<&'a Vectors<D>> {
    if !A::FORCED {
        return None;
    }
    known.clear();
    acts.subtract_force(c, &step.q.hi, &step.v.hi, step.t, known);
    Some(known)
}
