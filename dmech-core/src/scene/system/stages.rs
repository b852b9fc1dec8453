//! Eight stages of many bodies, side by side: one pass over the columns a sweep.

use dmech_scalar::{Lanes, Real};

use super::{SceneStride, SceneSystem};
use crate::scene::compensated::CompensatedVectors;
use crate::scene::eights::Eights;
use crate::scene::terms::{Acts, ActsAtStages, Moments};
use crate::scene::vectors::Vectors;
use crate::scheme::tableau::{GAUSS, STAGES, Tableau};
use crate::system::stages::{Eight, Nearing, Staged, of_path, weighed};

/// What stays the same from sweep to sweep, and room for it.
#[derive(Clone, Debug)]
pub struct SceneAim<const D: usize> {
    /// t + cᵢ h.
    t: Lanes,
    /// q + cᵢ h v, and the places of driven bodies.
    base: Eights<D>,
    /// v likewise, where a force depends on it.
    speed: Eights<D>,
    /// Where all are, in this sweep.
    q: Eights<D>,
    v: Eights<D>,
    slopes: Eights<D>,
    /// The positions of each stage where distances decide who is linked.
    apart: Vec<Vectors<D>>,
    /// 1 over the change of a push that counts, of each body.
    per_unit: Vec<f64>,
    /// The larger of |q| and |h v|, of each body.
    reach: Vec<f64>,
    /// How near the sweeps are.
    nearing: Nearing<f64>,
}

impl<const D: usize, A: ActsAtStages<D>> Staged for SceneSystem<D, A> {
    type Pushes = Eights<D>;
    type Aim = SceneAim<D>;

    const PIECEWISE: bool = A::PIECEWISE;

    fn pushes(&self, stride: &SceneStride<D>, slope: &Vectors<D>) -> Eights<D> {
        let mut pushes = Eights::zeros(slope.bodies());
        let weights = Lanes::row(&GAUSS.weights);
        for (push, (slope, kick)) in pushes.flat_mut().iter_mut().zip(slope.flat().iter().zip(stride.kick.flat())) {
            *push = weights * Lanes::splat(-stride.dt * kick * slope);
        }
        pushes
    }

    fn aims(&self) -> SceneAim<D> {
        let bodies = self.masses.len();
        let speeds = if A::FORCED { bodies } else { 0 };
        let [base, q, slopes] = [(); 3].map(|()| Eights::zeros(bodies));
        let [speed, v] = [(); 2].map(|()| Eights::zeros(speeds));
        let apart = vec![Vectors::zeros(bodies); if A::OF_DISTANCE { STAGES } else { 1 }];
        let (t, nearing) = (Lanes::ZERO, Nearing::none());
        let [per_unit, reach] = [(); 2].map(|()| vec![0.0; bodies]);
        SceneAim { t, base, speed, q, v, slopes, apart, per_unit, reach, nearing }
    }

    fn eights(pushes: &Eights<D>) -> &[Lanes] {
        pushes.flat()
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
        let (nodes, bodies) = (Lanes::row(&tableau.nodes), self.masses.len());
        let (q, v) = (q.hi.flat(), v.hi.flat());
        aim.t = nodes.mul_add(Lanes::splat(stride.dt), Lanes::splat(t));
        aim.per_unit.fill(0.0);
        aim.reach.fill(0.0);
        let mut largest = 0.0_f64;
        for (i, base) in aim.base.flat_mut().iter_mut().enumerate() {
            let drift = stride.dt * v[i];
            *base = nodes.mul_add(Lanes::splat(drift), Lanes::splat(q[i]));
            let least = of_path(drift).max(Lanes::ZERO.or_larger(pushes.flat()[i]).largest());
            let (unit, reach) = (&mut aim.per_unit[i % bodies], &mut aim.reach[i % bodies]);
            (*unit, *reach) = (unit.max(least), reach.max(q[i].abs()).max(drift.abs()));
            largest = largest.max(least);
        }
        if A::FORCED {
            aim.speed.flat_mut().iter_mut().zip(v).for_each(|(speed, &v)| *speed = Lanes::splat(v));
        }
        self.place_driven(aim);
        aim.nearing = Nearing::begin(largest);
        for (unit, reach) in aim.per_unit.iter_mut().zip(&aim.reach) {
            *unit = aim.nearing.per_unit(*unit, *reach);
        }
    }

    fn sweep(&self, tableau: &Tableau, stride: &SceneStride<D>, aim: &mut SceneAim<D>, pushes: &mut Eights<D>) -> bool {
        let SceneAim { t, base, speed, q, v, slopes, apart, per_unit, nearing, .. } = aim;
        for (q, (push, base)) in q.flat_mut().iter_mut().zip(pushes.flat().iter().zip(base.flat())) {
            *q = weighed(&tableau.places, *push, *base);
        }
        if A::FORCED {
            let rate = Lanes::splat(stride.dt.recip());
            for (v, (push, speed)) in v.flat_mut().iter_mut().zip(pushes.flat().iter().zip(speed.flat())) {
                *v = weighed(&tableau.speeds, *push, Lanes::ZERO).mul_add(rate, *speed);
            }
        }
        if A::OF_DISTANCE {
            apart.iter_mut().enumerate().for_each(|(stage, apart)| q.copy_to(stage, apart));
        }
        slopes.clear();
        self.acts.add_slopes(&Moments { t: *t, q, v, apart }, slopes);
        let (weights, mut most) = (Lanes::row(&tableau.weights), Lanes::ZERO);
        let bodies = per_unit.len();
        for (k, kick) in stride.kick.columns().into_iter().enumerate() {
            let columns = (&mut pushes.flat_mut()[k * bodies..], &slopes.flat()[k * bodies..]);
            for (i, (push, slope)) in columns.0.iter_mut().zip(columns.1).take(bodies).enumerate() {
                let new = weights * Lanes::splat(-stride.dt * kick[i]) * *slope;
                most = most.or_larger((new - *push) * Lanes::splat(per_unit[i]));
                *push = new;
            }
        }
        nearing.comes_nearer(most)
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
        let (rests, dt, pushes) = (Lanes::row(&tableau.rests), stride.dt, pushes.flat());
        q.add(|i| dt.mul_add(v.hi.flat()[i], dt.mul_add(v.lo.flat()[i], (rests * pushes[i]).sum())));
        // A true quotient: a product with a rounded 1/h would be wrong by the same relative amount in each step.
        v.add(|i| pushes[i].sum() / dt);
    }

    fn work_of_pushes(&self, tableau: &Tableau, dt: f64, v: &Vectors<D>, pushes: &Eights<D>) -> f64 {
        let (rate, bodies) = (dt.recip(), self.weights.len());
        let works = pushes.flat().iter().zip(v.flat()).enumerate().map(|(i, (push, v))| {
            let speed = weighed(&tableau.working, *push, Lanes::ZERO).mul_add(Lanes::splat(rate), Lanes::splat(*v));
            self.weights[i % bodies] * ((speed * *push).sum() / dt)
        });
        works.sum()
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
