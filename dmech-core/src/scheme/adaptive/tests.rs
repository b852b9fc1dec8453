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
    memory.pacing.density = adaptive.follow(memory.pacing.density, &law.look(&mut (), 0.0, &q, &v, 0.0));
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
