//! The way back, and the scale of ω.

use super::{Adaptable, Adaptive};
use crate::State;
use crate::law::{Conservative, Potential};
use crate::scheme::splitting::SplittingMemory;
use crate::scheme::{Composed, DiscreteGradient, ForceGradient, Leapfrog, Nystrom, Scheme};
use crate::system::{Beginning, Particle, System, TimeScale};

/// −k/r.
struct Kepler {
    k: f64,
}

impl Conservative for Kepler {}

impl Potential<2> for Kepler {
    fn potential(&self, q: [f64; 2]) -> f64 {
        -self.k / q[0].hypot(q[1])
    }
    fn gradient(&self, q: [f64; 2]) -> [f64; 2] {
        self.discrete_gradient(q, q)
    }
    fn hessian(&self, q: [f64; 2]) -> [[f64; 2]; 2] {
        self.discrete_gradient_jacobian(q, q).map(|row| row.map(|x| 2.0 * x))
    }
    fn discrete_gradient(&self, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
        let (ra, rb) = (a[0].hypot(a[1]), b[0].hypot(b[1]));
        let c = self.k / (ra * rb * (ra + rb));
        [c * (a[0] + b[0]), c * (a[1] + b[1])]
    }
    fn discrete_gradient_jacobian(&self, a: [f64; 2], b: [f64; 2]) -> [[f64; 2]; 2] {
        let (ra, rb) = (a[0].hypot(a[1]), b[0].hypot(b[1]));
        let c = self.k / (ra * rb * (ra + rb));
        let d = -c * (1.0 / rb + 1.0 / (ra + rb)) / rb;
        let sum = [a[0] + b[0], a[1] + b[1]];
        [[c + d * sum[0] * b[0], d * sum[0] * b[1]], [d * sum[1] * b[0], c + d * sum[1] * b[1]]]
    }
}

const MASS: f64 = 1.3;

type Sun = Particle<Kepler, 2>;

/// Forward, the velocity turned round, and back: the steps are those of the way there, and so is the motion.
fn comes_back<S: Adaptable + Scheme<Sun>>(scheme: S, tolerance: f64, turn: impl Fn(&mut S::Memory)) {
    let law = Sun::new(Kepler { k: 1.7 }, MASS);
    let adaptive = Adaptive::new(scheme, tolerance);
    let unlimited = law.stride(f64::INFINITY, 0.0);
    let start = State::new([1.4, 0.2], [-0.1, 0.45]);
    let mut workspace = Scheme::<Sun>::workspace(&adaptive, &law, &unlimited);
    let mut slope = [0.0; 2];
    law.slope(0.0, &start.q, &start.v, &mut slope);
    let first = Beginning { t: 0.0, q: &start.q, v: &start.v, slope: &slope };
    let mut memory = adaptive.begin(&law, &unlimited, &first, &mut workspace).unwrap();
    let mut step = |memory: &mut _| {
        let t = Scheme::<Sun>::time(&adaptive, 0.0, 0, 0.0, memory);
        adaptive.step(&law, &unlimited, t, memory, &mut workspace).map(|_| ()).unwrap();
    };
    let (steps, mut forth, mut back) = (100 * adaptive.row as usize, Vec::new(), Vec::new());
    for _ in 0..steps {
        forth.push(memory.pacing.dt);
        step(&mut memory);
    }
    turn(&mut memory.inner);
    let (q, v) = (*adaptive.position(&memory), adaptive.velocity(&law, &unlimited, 0.0, &memory));
    // ρ of the step that would have come next is ρ of the step before, seen backward.
    memory.pacing.density = adaptive.follow(&memory.pacing, &law.look(&mut (), 0.0, &q, &v, 0.0));
    adaptive.plan(f64::INFINITY, &mut memory.pacing);
    for _ in 0..steps {
        back.push(memory.pacing.dt);
        step(&mut memory);
    }
    back.reverse();
    let longest = forth.iter().fold(0.0, |most: f64, x| most.max(*x));
    let shortest = forth.iter().fold(f64::INFINITY, |least: f64, x| least.min(*x));
    assert!(longest > 8.0 * shortest, "{shortest} to {longest}: nothing to follow");
    for (k, (there, here)) in forth.iter().zip(&back).enumerate() {
        assert!((there - here).abs() < 1e-9 * there, "{}, step {k}: {there} forward, {here} backward", S::NAME);
    }
    let (q, v) = (adaptive.position(&memory), adaptive.velocity(&law, &unlimited, 0.0, &memory));
    for i in 0..2 {
        let apart = (q[i] - start.q[i]).abs().max((v[i] + start.v[i]).abs());
        // K̈ is a difference over 0.05: the steps differ by roundings of 1e-12, and by as much the motion is late.
        assert!(apart < 1e-9, "{}: {apart:e} from the start", S::NAME);
    }
}

#[test]
fn the_way_back_is_the_way_there() {
    comes_back(DiscreteGradient, 1e-1, |memory| {
        memory.v.hi = memory.v.hi.map(|x| -x);
        memory.v.lo = memory.v.lo.map(|x| -x);
    });
    comes_back(Composed::order6(DiscreteGradient), 1e-4, |memory| {
        memory.v.hi = memory.v.hi.map(|x| -x);
        memory.v.lo = memory.v.lo.map(|x| -x);
    });
    // The kick that is shared with the next step lies before a turn, and after it.
    fn turn(memory: &mut SplittingMemory<Sun>) {
        (memory.v_before, memory.v_after) = (memory.v_after.map(|x| -x), memory.v_before.map(|x| -x));
    }
    comes_back(Nystrom::order4(), 1e-5, turn);
    comes_back(Nystrom::order6(), 1e-5, turn);
    comes_back(ForceGradient::order8(), 1e-5, turn);
    comes_back(Composed::order6(Leapfrog), 1e-4, turn);
}

/// In other units of length and time ω is the same frequency, from 1e-120 to 1e120 of them, and its growth is that of
/// ω ∝ r^(−3/2) on a straight fall, where K, K̇ and K̈ scale alike.
#[test]
fn the_frequency_has_no_scale_of_its_own() {
    let look = |length: f64, time: f64| {
        let law = Kepler { k: 1.7 * length * length * length / (time * time) };
        let r = 0.8 * length;
        // E = 0.
        let v = -(2.0 * law.k / r).sqrt();
        let look = Sun::new(law, 1.0).look(&mut (), 0.0, &[0.6 * r, 0.8 * r], &[0.6 * v, 0.8 * v], 0.0);
        let growth = -1.5 * v / r;
        assert!((look.growth / growth - 1.0).abs() < 0.02, "{} for {growth}", look.growth);
        [look.rate() * time, look.growth * time]
    };
    let here = look(1.0, 1.0);
    for (length, time) in [(1e-40, 1e-60), (1e40, 1e60), (1e30, 1e-60), (3.0, 7.0)] {
        let there = look(length, time);
        for i in 0..2 {
            assert!((there[i] / here[i] - 1.0).abs() < 1e-9, "{length:e}, {time:e}: {there:?} for {here:?}");
        }
    }
}

/// q⁻¹² − q⁻⁶ along q, of which the force does not fall on one side as on the other.
struct Well;

impl Conservative for Well {}

impl Potential<1> for Well {
    fn potential(&self, [q]: [f64; 1]) -> f64 {
        q.powi(-12) - q.powi(-6)
    }
    fn gradient(&self, [q]: [f64; 1]) -> [f64; 1] {
        [6.0 * q.powi(-7) - 12.0 * q.powi(-13)]
    }
    fn hessian(&self, [q]: [f64; 1]) -> [[f64; 1]; 1] {
        [[156.0 * q.powi(-14) - 42.0 * q.powi(-8)]]
    }
    fn discrete_gradient(&self, _: [f64; 1], _: [f64; 1]) -> [f64; 1] {
        unreachable!("steps between two points are not made here")
    }
    fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] {
        unreachable!("steps between two points are not made here")
    }
}

/// exp(−2q) − 2 exp(−q): beside K = 0 it grows without bound on one side.
struct Bond;

impl Conservative for Bond {}

impl Potential<1> for Bond {
    fn potential(&self, [q]: [f64; 1]) -> f64 {
        (-2.0 * q).exp() - 2.0 * (-q).exp()
    }
    fn gradient(&self, [q]: [f64; 1]) -> [f64; 1] {
        [2.0 * (-q).exp() - 2.0 * (-2.0 * q).exp()]
    }
    fn hessian(&self, [q]: [f64; 1]) -> [[f64; 1]; 1] {
        [[4.0 * (-2.0 * q).exp() - 2.0 * (-q).exp()]]
    }
    fn discrete_gradient(&self, _: [f64; 1], _: [f64; 1]) -> [f64; 1] {
        unreachable!("steps between two points are not made here")
    }
    fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] {
        unreachable!("steps between two points are not made here")
    }
}

/// Where K passes through zero, the places that so small a K would have the law looked at are far away: it is looked at nearer, and ω is
/// there what it is beside.
#[test]
fn the_frequency_is_continuous_where_the_stiffness_vanishes() {
    fn check<L: crate::Law<1>>(law: L, zero: f64, v: f64)
    where
        Particle<L, 1>: TimeScale<Room = (), Vector = [f64; 1], Scalar = f64>,
    {
        let law = Particle::new(law, 1.0);
        let at = |q: f64| law.look(&mut (), 0.0, &[q], &[v], 0.0);
        let [before, after] = [-0.01, 0.01].map(|d| at(zero + d));
        let [least, most] = [f64::min, f64::max].map(|of| of(before.rate(), after.rate()));
        let [slow, fast] = [f64::min, f64::max].map(|of| of(before.growth, after.growth));
        // At distances from 0.01 down to 10⁻¹³: K itself has no more digits.
        for k in 0..260 {
            let d = 0.01 * 0.91_f64.powi(k);
            for q in [zero - d, zero + d] {
                let look = at(q);
                let (rate, growth) = (look.rate(), look.growth);
                assert!(rate > 0.9 * least && rate < 1.1 * most, "{d:e}: {rate} between {least} and {most}");
                let room = 0.25 * most;
                assert!(growth > slow - room && growth < fast + room, "{d:e}: {growth} between {slow} and {fast}");
            }
        }
    }
    for v in [-0.9, 0.75] {
        check(Well, (156.0_f64 / 42.0).powf(1.0 / 6.0), v);
        check(Bond, 2.0_f64.ln(), v);
    }
}
