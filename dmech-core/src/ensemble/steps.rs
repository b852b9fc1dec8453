//! The steps of members side by side: of one length for each, or each as long as its motion allows.

use dmech_scalar::Real;

use super::lanes::{Ride, Together};
use crate::law::Fields;
use crate::scheme::{Adaptable, Adaptive, ByLane, Pacing, Scheme};
use crate::stepper::Stepper;
use crate::system::{EVALUATIONS, Look, Particle, System};

/// A member alone.
pub(super) type Alone<L, S, const D: usize> = Stepper<Particle<L, D>, S>;

/// What members have cost: evaluations of the force by each, and corrections, which are those of the slowest.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    pub(super) evaluations: [u64; Ride::COUNT],
    pub(super) iterations: u64,
}

impl Cost {
    pub(super) const NONE: Cost = Cost { evaluations: [0; Ride::COUNT], iterations: 0 };

    fn add(&mut self, evaluations: u32, iterations: u32) {
        self.evaluations.iter_mut().for_each(|all| *all += u64::from(evaluations));
        self.iterations += u64::from(iterations);
    }
}

/// A scheme whose steps can be made side by side: every operation of a step is one of each lane, to the bit, and equations are solved
/// for each lane with its own last correction.
pub trait InLanes<L: Fields<D>, const D: usize>: Scheme<Particle<L, D>> {
    /// What all carry.
    type All;

    /// Takes up what each carries, lane by lane.
    fn gather<'a>(&self, system: &Together<L, D>, alone: &impl Fn(usize) -> &'a Alone<L, Self, D>) -> Self::All
    where
        L: 'a,
        Self: 'a;

    /// So many steps, or fewer if a member arrives: how many. `None`, and no step, where they cannot be made together.
    fn advance(&self, system: &Together<L, D>, all: &mut Self::All, steps: u64, cost: &mut Cost) -> Option<u64>;

    /// What one carries.
    fn lane(&self, all: &Self::All, lane: usize) -> Self::Memory;

    /// Time, position, velocity, and the scheme's own energy if it has one.
    fn state(&self, system: &Together<L, D>, all: &Self::All) -> (Ride, [[Ride; D]; 2], Option<Ride>);

    /// Whether one has come to the end that it was given.
    fn has_arrived(&self, _all: &Self::All, _lane: usize) -> bool {
        false
    }
}

/// A scheme for a law alone and for many side by side.
pub trait BySide<L: Fields<D>, const D: usize>:
    Scheme<Particle<L, D>> + Scheme<Together<L, D>, Memory: ByLane<<Self as Scheme<Particle<L, D>>>::Memory>>
{
}

impl<L: Fields<D>, const D: usize, S> BySide<L, D> for S where
    S: Scheme<Particle<L, D>> + Scheme<Together<L, D>, Memory: ByLane<<S as Scheme<Particle<L, D>>>::Memory>>
{
}

type Memory<L, S, const D: usize> = <S as Scheme<Together<L, D>>>::Memory;
type Workspace<L, S, const D: usize> = <S as Scheme<Together<L, D>>>::Workspace;
type Stride<L, const D: usize> = <Together<L, D> as System>::Stride;

/// Members with steps of one length each.
pub struct Even<L: Fields<D>, S: BySide<L, D>, const D: usize> {
    stride: Stride<L, D>,
    memory: Memory<L, S, D>,
    workspace: Workspace<L, S, D>,
    start: Ride,
    dt: Ride,
    made: Ride,
}

impl<L: Fields<D>, S: BySide<L, D>, const D: usize> Even<L, S, D> {
    fn t(&self) -> Ride {
        self.start + self.made * self.dt
    }
}

impl<L: Fields<D>, S: BySide<L, D>, const D: usize> InLanes<L, D> for S {
    type All = Even<L, S, D>;

    fn gather<'a>(&self, system: &Together<L, D>, alone: &impl Fn(usize) -> &'a Alone<L, S, D>) -> Even<L, S, D>
    where
        L: 'a,
        S: 'a,
    {
        let dt = Ride::from_fn(|lane| alone(lane).dt);
        let stride = system.stride(dt, <S as Scheme<Together<L, D>>>::SHARE);
        let mut workspace = self.workspace(system, &stride);
        <S as Scheme<Together<L, D>>>::watch(self, false, &mut workspace);
        Even {
            stride,
            memory: ByLane::of(&|lane| &alone(lane).memory),
            workspace,
            start: Ride::from_fn(|lane| alone(lane).start.t),
            dt,
            made: Ride::from_fn(|lane| alone(lane).steps as f64),
        }
    }

    fn advance(&self, system: &Together<L, D>, all: &mut Even<L, S, D>, steps: u64, cost: &mut Cost) -> Option<u64> {
        let Even { stride, workspace, start, dt, .. } = all;
        let (mut made, mut memory, mut efforts) = (all.made, all.memory.clone(), [0; 2]);
        for _ in 0..steps {
            let effort = self.step(system, stride, *start + made * *dt, &mut memory, workspace).ok()?;
            efforts[0] += effort.evaluations;
            efforts[1] += effort.iterations;
            made += Ride::ONE;
        }
        if !<S as Scheme<Together<L, D>>>::finite(self, &memory) {
            return None;
        }
        (all.memory, all.made) = (memory, made);
        cost.add(efforts[0], efforts[1]);
        Some(steps)
    }

    fn lane(&self, all: &Even<L, S, D>, lane: usize) -> <S as Scheme<Particle<L, D>>>::Memory {
        all.memory.lane(lane)
    }

    fn state(&self, system: &Together<L, D>, all: &Even<L, S, D>) -> (Ride, [[Ride; D]; 2], Option<Ride>) {
        let (t, Even { stride, memory, .. }) = (all.t(), all);
        let q = *<S as Scheme<Together<L, D>>>::position(self, memory);
        (t, [q, self.velocity(system, stride, t, memory)], self.discrete_energy(system, t, memory))
    }
}

/// Members with steps that follow the motion of each.
pub struct Paced<L: Fields<D>, S: BySide<L, D>, const D: usize> {
    stride: Stride<L, D>,
    memory: Memory<L, S, D>,
    workspace: Workspace<L, S, D>,
    pacings: [Pacing; Ride::COUNT],
    longest: [f64; Ride::COUNT],
}

impl<L: Fields<D>, S: Adaptable + BySide<L, D>, const D: usize> InLanes<L, D> for Adaptive<S> {
    type All = Paced<L, S, D>;

    fn gather<'a>(&self, system: &Together<L, D>, alone: &impl Fn(usize) -> &'a Alone<L, Self, D>) -> Paced<L, S, D>
    where
        L: 'a,
        S: 'a,
    {
        let pacings: [Pacing; Ride::COUNT] = core::array::from_fn(|lane| alone(lane).memory.pacing);
        let dt = Ride::from_fn(|lane| pacings[lane].dt);
        let stride = system.stride(dt, <S as Scheme<Together<L, D>>>::SHARE);
        let scheme = self.inner();
        let mut workspace = scheme.workspace(system, &stride);
        <S as Scheme<Together<L, D>>>::watch(&scheme, false, &mut workspace);
        Paced {
            stride,
            memory: ByLane::of(&|lane| &alone(lane).memory.inner),
            workspace,
            pacings,
            longest: core::array::from_fn(|lane| alone(lane).dt),
        }
    }

    fn advance(&self, system: &Together<L, D>, all: &mut Paced<L, S, D>, steps: u64, cost: &mut Cost) -> Option<u64> {
        let (scheme, mut spent) = (self.inner(), *cost);
        let (mut memory, mut pacings) = (all.memory.clone(), all.pacings);
        let Paced { stride, workspace, longest, .. } = all;
        let mut made = 0;
        while made < steps && !pacings.iter().any(|pacing| self.has_arrived(pacing)) {
            if pacings.iter().any(|pacing| self.is_ready(0, pacing).is_err()) {
                return None;
            }
            let t = Ride::from_fn(|lane| pacings[lane].time.value());
            system.set_stride(stride, Ride::from_fn(|lane| pacings[lane].dt), <S as Scheme<Together<L, D>>>::SHARE);
            scheme.pace(system, stride, workspace);
            let ratios = pacings.map(|pacing| pacing.ratio());
            if ratios != [1.0; Ride::COUNT] {
                let stretched = stretch(&scheme, system, (stride, t), &ratios, &mut memory, workspace);
                for (evaluations, ratio) in spent.evaluations.iter_mut().zip(ratios) {
                    *evaluations += if ratio == 1.0 { 0 } else { u64::from(stretched) };
                }
            }
            let effort = scheme.step(system, stride, t, &mut memory, workspace).ok()?;
            spent.add(effort.evaluations, effort.iterations);
            let looks = pacings.each_mut().map(|pacing| self.made(pacing));
            if looks.contains(&true) {
                let end = Ride::from_fn(|lane| pacings[lane].time.value());
                let q = <S as Scheme<Together<L, D>>>::position(&scheme, &memory);
                let v = scheme.velocity(system, stride, end, &memory);
                let least = Ride::from_fn(|lane| self.least(longest[lane]));
                let Look { power, s, growth } = system.look_along(end, *q, v, least);
                for lane in (0..Ride::COUNT).filter(|&lane| looks[lane]) {
                    let look = Look { power: power[lane], s: s[lane], growth: growth[lane] };
                    spent.evaluations[lane] += u64::from(EVALUATIONS);
                    self.looked(&look, &mut pacings[lane]);
                }
            }
            pacings.iter_mut().zip(&*longest).for_each(|(pacing, &longest)| self.plan(longest, pacing));
            made += 1;
        }
        if !<S as Scheme<Together<L, D>>>::finite(&scheme, &memory) {
            return None;
        }
        (all.memory, all.pacings, *cost) = (memory, pacings, spent);
        Some(made)
    }

    fn lane(&self, all: &Paced<L, S, D>, lane: usize) -> <Self as Scheme<Particle<L, D>>>::Memory {
        crate::scheme::AdaptiveMemory { inner: all.memory.lane(lane), pacing: all.pacings[lane] }
    }

    fn state(&self, system: &Together<L, D>, all: &Paced<L, S, D>) -> (Ride, [[Ride; D]; 2], Option<Ride>) {
        let (scheme, Paced { stride, memory, pacings, .. }) = (self.inner(), all);
        let t = Ride::from_fn(|lane| pacings[lane].time.value());
        let q = *<S as Scheme<Together<L, D>>>::position(&scheme, memory);
        (t, [q, scheme.velocity(system, stride, t, memory)], None)
    }

    fn has_arrived(&self, all: &Paced<L, S, D>, lane: usize) -> bool {
        Adaptive::has_arrived(self, &all.pacings[lane])
    }
}

/// What each carries, for a step that is so many times as long as the last; where it is as long, nothing changes. What it costs.
fn stretch<L: Fields<D>, S: BySide<L, D>, const D: usize>(
    scheme: &S,
    system: &Together<L, D>,
    (stride, t): (&Stride<L, D>, Ride),
    ratios: &[f64; Ride::COUNT],
    memory: &mut Memory<L, S, D>,
    workspace: &mut Workspace<L, S, D>,
) -> u32 {
    let before = memory.clone();
    let cost = scheme.stretch(system, stride, t, Ride::from_fn(|lane| ratios[lane]), memory, workspace);
    if ratios.contains(&1.0) {
        let one = |lane: usize| if ratios[lane] == 1.0 { before.lane(lane) } else { memory.lane(lane) };
        let each: Vec<<S as Scheme<Particle<L, D>>>::Memory> = (0..Ride::COUNT).map(one).collect();
        *memory = ByLane::of(&|lane| &each[lane]);
    }
    cost
}
