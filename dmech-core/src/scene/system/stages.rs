//! Eight stages of many bodies, side by side.

use dmech_scalar::{Lanes, Real};

use super::{SceneStride, SceneSystem};
use crate::scene::compensated::CompensatedVectors;
use crate::scene::eights::Eights;
use crate::scene::terms::{Acts, ActsAtStages, Moments};
use crate::scene::vectors::Vectors;
use crate::system::stages::{self, Eight, Nearing, Staged, weighed};
use crate::system::tableau::{GAUSS, STAGES, Tableau};

/// Places of a chain are computed as what acts is asked for. Where the coefficients leave no registers for that, they are stored before.
pub(super) const PLACED_IN_PASSING: bool = cfg!(target_feature = "avx512f");

/// What stays the same from sweep to sweep, and room for it.
#[derive(Clone, Debug)]
pub struct SceneAim<const D: usize> {
    /// t + cᵢ h.
    pub(super) t: Lanes,
    /// q + cᵢ h v, and the places of driven bodies.
    pub(super) base: Eights<D>,
    /// v likewise, where a force depends on it.
    pub(super) speed: Eights<D>,
    /// Where all are in this sweep, if that is stored.
    pub(super) q: Eights<D>,
    pub(super) v: Eights<D>,
    slopes: Eights<D>,
    /// The positions of each stage where distances decide who is linked.
    apart: Vec<Vectors<D>>,
    /// −(h²/m) bᵢ, of each coordinate.
    pub(super) shares: Eights<D>,
    /// 1 over the change of a push that counts, of each body.
    pub(super) per_unit: Vec<f64>,
    /// The larger of |q| and |h v|, of each body; then what the rounding of a position may make of a push.
    reach: Vec<f64>,
    /// How coordinates move in the step.
    moves: [Vectors<D>; 3],
    /// How near the sweeps are.
    pub(super) nearing: Nearing<f64>,
}

impl<const D: usize, A: ActsAtStages<D>> Staged for SceneSystem<D, A> {
    type Pushes = Eights<D>;
    type Aim = SceneAim<D>;

    fn pushes(&self, stride: &SceneStride<D>, slope: &Vectors<D>) -> Eights<D> {
        let mut pushes = Eights::zeros(slope.bodies());
        let weights = Lanes::row(&GAUSS.weights, 0);
        for (push, (slope, kick)) in pushes.flat_mut().iter_mut().zip(slope.flat().iter().zip(stride.kick.flat())) {
            *push = weights * Lanes::splat(-stride.dt * kick * slope);
        }
        pushes
    }

    fn aims(&self) -> SceneAim<D> {
        let bodies = self.masses.len();
        let stored = if A::CHAIN && PLACED_IN_PASSING { 0 } else { bodies };
        let [base, q, slopes] = [bodies, stored, if A::CHAIN { 0 } else { bodies }].map(Eights::zeros);
        let [speed, v] = [bodies, stored].map(|bodies| Eights::zeros(if A::FORCED { bodies } else { 0 }));
        let apart = vec![Vectors::zeros(bodies); if A::OF_DISTANCE { STAGES } else { 1 }];
        let (t, nearing, shares) = (Lanes::ZERO, Nearing::none(), Eights::zeros(bodies));
        let [per_unit, reach] = [(); 2].map(|()| vec![0.0; bodies]);
        let moves = [(); 3].map(|()| Vectors::zeros(bodies));
        SceneAim { t, base, speed, q, v, slopes, apart, shares, per_unit, reach, moves, nearing }
    }

    fn eights(pushes: &Eights<D>) -> &[Lanes] {
        pushes.flat()
    }

    fn coordinates(q: &Vectors<D>) -> &[f64] {
        q.flat()
    }

    fn eights_mut(pushes: &mut Eights<D>) -> &mut [Lanes] {
        pushes.flat_mut()
    }

    fn aim(
        &self,
        tableau: &Tableau,
        stride: &SceneStride<D>,
        t: f64,
        q: &CompensatedVectors<D>,
        v: &CompensatedVectors<D>,
        pushes: &Eights<D>,
        aim: &mut SceneAim<D>,
    ) {
        let (nodes, weights) = (Lanes::row(&tableau.nodes, 0), Lanes::row(&tableau.weights, 0));
        aim.t = nodes.mul_add(Lanes::splat(stride.dt), Lanes::splat(t));
        let [drifts, counts, reach] = &mut aim.moves;
        let start = [q.hi.flat(), v.hi.flat(), v.lo.flat()];
        stages::moves(stride.dt, start, pushes.flat(), [drifts.flat_mut(), counts.flat_mut(), reach.flat_mut()]);
        let places = drifts.flat().iter().zip(q.hi.flat());
        for (base, (&drift, &q)) in aim.base.flat_mut().iter_mut().zip(places) {
            *base = nodes.mul_add(Lanes::splat(drift), Lanes::splat(q));
        }
        for (share, &kick) in aim.shares.flat_mut().iter_mut().zip(stride.kick.flat()) {
            *share = weights * Lanes::splat(-stride.dt * kick);
        }
        for (of_each, of_body) in [(counts, &mut aim.per_unit), (reach, &mut aim.reach)] {
            of_body.fill(0.0);
            for column in of_each.columns() {
                of_body.iter_mut().zip(column).for_each(|(most, x)| *most = most.max(*x));
            }
        }
        if A::FORCED {
            aim.speed.flat_mut().iter_mut().zip(v.hi.flat()).for_each(|(speed, &v)| *speed = Lanes::splat(v));
        }
        self.place_driven(aim);
        aim.nearing = Nearing::begin(&mut aim.per_unit, &mut aim.reach);
    }

    fn sweep(&self, tableau: &Tableau, stride: &SceneStride<D>, aim: &mut SceneAim<D>, pushes: &mut Eights<D>) -> bool {
        if A::CHAIN {
            return self.sweep_in_passing(tableau, stride, aim, pushes);
        }
        aim.place(A::FORCED, tableau, stride, pushes);
        let SceneAim { t, q, v, slopes, apart, shares, per_unit, nearing, .. } = aim;
        if A::OF_DISTANCE {
            apart.iter_mut().enumerate().for_each(|(stage, apart)| q.copy_to(stage, apart));
        }
        slopes.clear();
        self.acts.terms.add_slopes(&Moments { t: *t, q, v, apart }, slopes);
        let mut most = Lanes::ZERO;
        let columns = pushes.columns_mut().into_iter().zip(slopes.columns()).zip(shares.columns());
        for ((pushes, slopes), shares) in columns {
            let parts = pushes.iter_mut().zip(slopes.iter().zip(shares)).zip(&*per_unit);
            for ((push, (slope, share)), per_unit) in parts {
                let new = *share * *slope;
                most = Lanes::larger(most, (new - *push) * Lanes::splat(*per_unit));
                *push = new;
            }
        }
        nearing.comes_nearer(0, most)
    }

    fn per_unit(aim: &SceneAim<D>) -> &[f64] {
        &aim.per_unit
    }

    fn nearing(aim: &SceneAim<D>) -> &Nearing<f64> {
        &aim.nearing
    }

    fn settle_pushes(
        tableau: &Tableau,
        stride: &SceneStride<D>,
        pushes: &Eights<D>,
        [q, v]: [&mut CompensatedVectors<D>; 2],
    ) {
        let moved = [q.hi.flat_mut(), q.lo.flat_mut(), v.hi.flat_mut(), v.lo.flat_mut()];
        stages::settle(tableau, stride.dt, pushes.flat(), moved);
    }

    fn work_of_pushes(&self, tableau: &Tableau, dt: f64, v: &Vectors<D>, pushes: &Eights<D>) -> f64 {
        let (rate, bodies) = (dt.recip(), self.weights.len());
        let works = pushes.flat().iter().zip(v.flat()).enumerate().map(|(i, (push, v))| {
            let speed = weighed(&tableau.working, push, 0, Lanes::ZERO).mul_add(Lanes::splat(rate), Lanes::splat(*v));
            self.weights[i % bodies] * ((speed * *push).sum() / dt)
        });
        works.sum()
    }
}

impl<const D: usize> SceneAim<D> {
    /// Stores where all bodies are, and their velocities where a force depends on them.
    pub(super) fn place(&mut self, forced: bool, tableau: &Tableau, stride: &SceneStride<D>, pushes: &Eights<D>) {
        for (q, (push, base)) in self.q.flat_mut().iter_mut().zip(pushes.flat().iter().zip(self.base.flat())) {
            *q = weighed(&tableau.places, push, 0, *base);
        }
        if forced {
            let rate = Lanes::splat(stride.dt.recip());
            for (v, (push, speed)) in self.v.flat_mut().iter_mut().zip(pushes.flat().iter().zip(self.speed.flat())) {
                *v = weighed(&tableau.speeds, push, 0, Lanes::ZERO).mul_add(rate, *speed);
            }
        }
    }
}

impl<const D: usize, A: Acts<D>> SceneSystem<D, A> {
    /// Puts driven bodies where they are at each stage.
    fn place_driven(&self, aim: &mut SceneAim<D>) {
        if self.acts.drives.is_empty() {
            return;
        }
        for stage in 0..STAGES {
            for (body, [place, velocity]) in self.acts.drives.at(aim.t[stage]) {
                let mut all = aim.base.get(body);
                (0..D).for_each(|k| all[k][stage] = place[k]);
                aim.base.set(body, all);
                if A::FORCED {
                    let mut all = aim.speed.get(body);
                    (0..D).for_each(|k| all[k][stage] = velocity[k]);
                    aim.speed.set(body, all);
                }
            }
        }
    }
}
