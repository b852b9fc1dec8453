//! The momenta of the bodies whose coordinates a particle has.

use dmech_scalar::Real;

use super::Particle;
use crate::invariant::Invariant;
use crate::law::Law;
use crate::state::State;
use crate::vector::dot;

impl<L: Law<D, R>, const D: usize, R: Real> Particle<L, D, R> {
    /// No body is pinned.
    pub(super) fn moves_freely(&self) -> bool {
        !(0..D).any(|i| self.law.pinned(i))
    }

    /// Σ m vᵢ over the bodies.
    fn linear_momentum(&self, state: &State<D, R>, i: usize) -> R {
        let weights = self.law.weights();
        let bodies = (0..D).step_by(L::BODY);
        self.mass * bodies.fold(R::ZERO, |sum, body| weights[body + i].mul_add(state.v[body + i], sum))
    }

    /// Σ m (qᵢ vⱼ − qⱼ vᵢ) over the bodies.
    fn angular_momentum(&self, state: &State<D, R>, [i, j]: [usize; 2]) -> R {
        let weights = self.law.weights();
        let of = |body: usize| {
            let (i, j) = (body + i, body + j);
            weights[body] * dot([state.q[i], -state.q[j]], [state.v[j], state.v[i]])
        };
        self.mass * (L::BODY..D).step_by(L::BODY).fold(of(0), |sum, body| sum + of(body))
    }

    /// A momentum, and how far it is from that of the start.
    pub(super) fn momentum_since(&self, invariant: Invariant, state: &State<D, R>, start: &State<D, R>) -> (R, R) {
        let is_linear = invariant == Invariant::LinearMomentum;
        let component = |[i, j]: [usize; 2]| {
            let of =
                |state| if is_linear { self.linear_momentum(state, i) } else { self.angular_momentum(state, [i, j]) };
            [of(state), of(start)]
        };
        // Axes, or planes; where there is one alone, it has a sign.
        let first = [0, usize::from(!is_linear)];
        if L::BODY == first[1] + 1 {
            let [now, before] = component(first);
            return (now, now - before);
        }
        let (mut squares, mut changes) = (R::ZERO, R::ZERO);
        let all = (0..L::BODY).flat_map(|i| (i..L::BODY).map(move |j| [i, j])).filter(|[i, j]| (i == j) == is_linear);
        for [now, before] in all.map(component) {
            squares += now * now;
            changes += (now - before) * (now - before);
        }
        (squares.sqrt(), changes.sqrt())
    }
}
