//! Eight stages of a chain, side by side: one pass over the bodies a sweep, after which nothing but the pushes is kept.

use dmech_scalar::{Lanes, Real};

use super::stages::{PLACED_IN_PASSING, SceneAim};
use super::{SceneStride, SceneSystem};
use crate::scene::eights::Eights;
use crate::scene::terms::{ActsAtStages, BodyAtStages};
use crate::system::Tableau;
use crate::system::stages::{Eight, weighed};

impl<const D: usize, A: ActsAtStages<D>> SceneSystem<D, A> {
    /// [`sweep`](crate::system::stages::Staged::sweep) where no others than consecutive bodies are linked: the push of a body is
    /// known, and may take the place of the last, as soon as the next one's place is.
    pub(super) fn sweep_in_passing(
        &self,
        tableau: &Tableau,
        stride: &SceneStride<D>,
        aim: &mut SceneAim<D>,
        pushes: &mut Eights<D>,
    ) -> bool {
        if !PLACED_IN_PASSING {
            aim.place(A::FORCED, tableau, stride, pushes);
        }
        let SceneAim { t, base, speed, q, v, shares, per_unit, nearing, .. } = aim;
        let (bases, speeds, shares) = (base.columns(), speed.columns(), shares.columns());
        let rate = Lanes::splat(stride.dt.recip());
        let mut pushes = pushes.columns_mut();

        let place = |pushes: &[&mut [Lanes]; D], i: usize| {
            if !PLACED_IN_PASSING {
                return BodyAtStages { q: q.get(i), v: if A::FORCED { v.get(i) } else { [Lanes::ZERO; D] } };
            }
            let mut body = BodyAtStages { q: [Lanes::ZERO; D], v: [Lanes::ZERO; D] };
            for k in 0..D {
                body.q[k] = weighed(&tableau.places, &pushes[k][i], 0, bases[k][i]);
                if A::FORCED {
                    body.v[k] = weighed(&tableau.speeds, &pushes[k][i], 0, Lanes::ZERO).mul_add(rate, speeds[k][i]);
                }
            }
            body
        };
        let mut most = Lanes::ZERO;
        let mut push = |pushes: &mut [&mut [Lanes]; D], i: usize, slope: [Lanes; D]| {
            for k in 0..D {
                let new = shares[k][i] * slope[k];
                most = Lanes::larger(most, (new - pushes[k][i]) * Lanes::splat(per_unit[i]));
                pushes[k][i] = new;
            }
        };

        let bodies = per_unit.len();
        if bodies > 0 {
            let (mut here, mut before) = (place(&pushes, 0), A::UNFELT);
            for next in 1..bodies {
                let there = place(&pushes, next);
                let after = self.acts.terms.felt(*t, next - 1, [&here, &there]);
                push(&mut pushes, next - 1, self.acts.terms.slope(*t, next - 1, &here, [&before, &after]));
                (here, before) = (there, after);
            }
            let end = self.acts.terms.slope(*t, bodies - 1, &here, [&before, &A::UNFELT]);
            push(&mut pushes, bodies - 1, end);
        }
        nearing.comes_nearer(0, most)
    }
}
