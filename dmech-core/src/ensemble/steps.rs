//! The steps of members side by side: of one length for each, or each as long as its motion allows.

use dmech_scalar::{Compensated, Mask, Real, Rows};

use super::together::Together;
use crate::law::Fields;
use crate::scheme::{Adaptable, Adaptive, ByLane, Pacing, Scheme};
use crate::stepper::Stepper;
use crate::system::{EVALUATIONS, Effort, Particle, System};

/// A member alone.
pub(super) type Alone<L, S, const D: usize> = Stepper<Particle<L, D>, S>;

/// A scheme whose steps can be made side by side: every operation of a step is one of each lane, to the bit, and equations are solved
/// for each lane with its own last correction.
pub trait InLanes<L: Fields<D>, const D: usize, const W: usize>: Scheme<Particle<L, D>> {
    /// What all carry.
    type All;

    /// Takes up what one carries, in every lane.
    fn alike(&self, system: &Together<L, D, W>, alone: &Alone<L, Self, D>) -> Self::All;

    /// Takes up what one carries in its lane.
    fn seat(&self, all: &mut Self::All, lane: usize, alone: &Alone<L, Self, D>);

    /// Takes the lengths of the steps of those who have been seated.
    fn set_strides(&self, system: &Together<L, D, W>, all: &mut Self::All);

    /// So many steps, or fewer if a member arrives: how many. `None`, and no step, where they cannot be made together, or one has to be
    /// made again. Who sums the work asks for one step at a time.
    fn advance(
        &self,
        system: &Together<L, D, W>,
        all: &mut Self::All,
        steps: u64,
        cost: &mut Effort<Rows<W>>,
        work: Option<&mut Compensated<Rows<W>>>,
    ) -> Option<u64>;

    /// What one carries.
    fn lane(&self, all: &Self::All, lane: usize) -> Self::Memory;

    /// Time, position, velocity.
    fn state(&self, system: &Together<L, D, W>, all: &Self::All) -> (Rows<W>, [[Rows<W>; D]; 2]);

    /// The scheme's own kinetic energy, the one that its work changes.
    fn own_kinetic_energy(&self, system: &Together<L, D, W>, all: &Self::All) -> Rows<W>;

    /// The scheme's own energy, if it has one.
    fn own_energy(&self, _system: &Together<L, D, W>, _all: &Self::All) -> Option<Rows<W>> {
        None
    }

    /// 1 for those who have come to the end that they were given, if there are any.
    fn at_the_end(&self, _all: &Self::All) -> Option<Rows<W>> {
        None
    }
}

/// A scheme for a law alone and for many side by side.
pub trait BySide<L: Fields<D>, const D: usize, const W: usize>:
    Scheme<Particle<L, D>> + Scheme<Together<L, D, W>, Memory: ByLane<<Self as Scheme<Particle<L, D>>>::Memory, W>>
{
}

impl<L: Fields<D>, const D: usize, const W: usize, S> BySide<L, D, W> for S where
    S: Scheme<Particle<L, D>> + Scheme<Together<L, D, W>, Memory: ByLane<<S as Scheme<Particle<L, D>>>::Memory, W>>
{
}

type Memory<L, S, const D: usize, const W: usize> = <S as Scheme<Together<L, D, W>>>::Memory;
type Workspace<L, S, const D: usize, const W: usize> = <S as Scheme<Together<L, D, W>>>::Workspace;
type Stride<L, const D: usize, const W: usize> = <Together<L, D, W> as System>::Stride;

/// A workspace that sees what the scheme can see.
fn watching<L: Fields<D>, S: BySide<L, D, W>, const D: usize, const W: usize>(
    scheme: &S,
    system: &Together<L, D, W>,
    stride: &Stride<L, D, W>,
) -> Workspace<L, S, D, W> {
    let mut workspace = scheme.workspace(system, stride);
    <S as Scheme<Together<L, D, W>>>::watch(scheme, <S as Scheme<Together<L, D, W>>>::SEES_ROUGH, &mut workspace);
    workspace
}

/// Members with steps of one length each.
pub struct Even<L: Fields<D>, S: BySide<L, D, W>, const D: usize, const W: usize> {
    stride: Stride<L, D, W>,
    memory: Memory<L, S, D, W>,
    workspace: Workspace<L, S, D, W>,
    start: Rows<W>,
    dt: Rows<W>,
    made: Rows<W>,
}

impl<L: Fields<D>, S: BySide<L, D, W>, const D: usize, const W: usize> Even<L, S, D, W> {
    fn t(&self) -> Rows<W> {
        self.start + self.made * self.dt
    }
}

impl<L: Fields<D>, S: BySide<L, D, W>, const D: usize, const W: usize> InLanes<L, D, W> for S {
    type All = Even<L, S, D, W>;

    fn alike(&self, system: &Together<L, D, W>, alone: &Alone<L, S, D>) -> Even<L, S, D, W> {
        let [start, dt, made] = [alone.start.t, alone.dt, alone.steps as f64].map(Rows::from_f64);
        let stride = system.stride(dt, <S as Scheme<Together<L, D, W>>>::SHARE);
        let workspace = watching::<L, S, D, W>(self, system, &stride);
        Even { stride, memory: ByLane::alike(&alone.memory), workspace, start, dt, made }
    }

    fn seat(&self, all: &mut Even<L, S, D, W>, lane: usize, alone: &Alone<L, S, D>) {
        all.start[lane] = alone.start.t;
        all.dt[lane] = alone.dt;
        all.made[lane] = alone.steps as f64;
        all.memory.set(lane, &alone.memory);
    }

    fn set_strides(&self, system: &Together<L, D, W>, all: &mut Even<L, S, D, W>) {
        all.stride = system.stride(all.dt, <S as Scheme<Together<L, D, W>>>::SHARE);
        <S as Scheme<Together<L, D, W>>>::pace(self, system, &all.stride, &mut all.workspace);
    }

    fn advance(
        &self,
        system: &Together<L, D, W>,
        all: &mut Even<L, S, D, W>,
        steps: u64,
        cost: &mut Effort<Rows<W>>,
        work: Option<&mut Compensated<Rows<W>>>,
    ) -> Option<u64> {
        let alike = const { <S as Scheme<Together<L, D, W>>>::ALIKE };
        let Even { stride, workspace, start, dt, made, .. } = all;
        let (mut memory, mut spent, mut last) = (all.memory.clone(), *cost, Effort::default());
        // Nothing is counted up from step to step where a step does not ask for it: counters take registers from the motion.
        for k in 0..steps {
            let t = *start + (*made + Rows::from_f64(k as f64)) * *dt;
            last = self.step(system, stride, t, &mut memory, workspace).ok()?;
            if !alike {
                spent += last;
            }
        }
        if alike {
            spent.evaluations += last.evaluations * Rows::from_f64(steps as f64);
        }
        if !<S as Scheme<Together<L, D, W>>>::finite(self, &memory) {
            return None;
        }
        if let Some(work) = work {
            work.add(self.work(system, stride, &all.memory, &memory));
        }
        *made += Rows::from_f64(steps as f64);
        (all.memory, *cost) = (memory, spent);
        Some(steps)
    }

    fn lane(&self, all: &Even<L, S, D, W>, lane: usize) -> <S as Scheme<Particle<L, D>>>::Memory {
        all.memory.lane(lane)
    }

    fn state(&self, system: &Together<L, D, W>, all: &Even<L, S, D, W>) -> (Rows<W>, [[Rows<W>; D]; 2]) {
        let (t, Even { stride, memory, .. }) = (all.t(), all);
        let q = *<S as Scheme<Together<L, D, W>>>::position(self, memory);
        (t, [q, self.velocity(system, stride, t, memory)])
    }

    fn own_kinetic_energy(&self, system: &Together<L, D, W>, all: &Even<L, S, D, W>) -> Rows<W> {
        self.kinetic_energy(system, &all.memory)
    }

    fn own_energy(&self, system: &Together<L, D, W>, all: &Even<L, S, D, W>) -> Option<Rows<W>> {
        self.discrete_energy(system, all.t(), &all.memory)
    }
}

/// Members with steps that follow the motion of each.
pub struct Paced<L: Fields<D>, S: BySide<L, D, W>, const D: usize, const W: usize> {
    stride: Stride<L, D, W>,
    memory: Memory<L, S, D, W>,
    workspace: Workspace<L, S, D, W>,
    pacing: Pacing<Rows<W>>,
    longest: Rows<W>,
}

impl<L: Fields<D>, S: Adaptable + BySide<L, D, W>, const D: usize, const W: usize> InLanes<L, D, W> for Adaptive<S> {
    type All = Paced<L, S, D, W>;

    fn alike(&self, system: &Together<L, D, W>, alone: &Alone<L, Self, D>) -> Paced<L, S, D, W> {
        let pacing: Pacing<Rows<W>> = ByLane::alike(&alone.memory.pacing);
        let stride = system.stride(pacing.dt, <S as Scheme<Together<L, D, W>>>::SHARE);
        let workspace = watching::<L, S, D, W>(&self.scheme, system, &stride);
        let memory = ByLane::alike(&alone.memory.inner);
        Paced { stride, memory, workspace, pacing, longest: Rows::from_f64(alone.dt) }
    }

    fn seat(&self, all: &mut Paced<L, S, D, W>, lane: usize, alone: &Alone<L, Self, D>) {
        all.pacing.set(lane, &alone.memory.pacing);
        all.memory.set(lane, &alone.memory.inner);
        all.longest[lane] = alone.dt;
    }

    fn set_strides(&self, system: &Together<L, D, W>, all: &mut Paced<L, S, D, W>) {
        all.stride = system.stride(all.pacing.dt, <S as Scheme<Together<L, D, W>>>::SHARE);
        self.scheme.pace(system, &all.stride, &mut all.workspace);
    }

    fn advance(
        &self,
        system: &Together<L, D, W>,
        all: &mut Paced<L, S, D, W>,
        steps: u64,
        cost: &mut Effort<Rows<W>>,
        work: Option<&mut Compensated<Rows<W>>>,
    ) -> Option<u64> {
        let (scheme, mut spent) = (self.scheme, *cost);
        let (mut memory, mut pacing) = (all.memory.clone(), all.pacing);
        let Paced { stride, workspace, longest, .. } = all;
        let mut made = 0;
        while made < steps && !self.has_arrived(&pacing).any() {
            if !pacing.moves_on().and(self.is_in_reach(&pacing)).all() {
                return None;
            }
            let t = pacing.time.value();
            if !Together::<L, D, W>::dt(stride).equal(pacing.dt).all() {
                system.set_stride(stride, pacing.dt, <S as Scheme<Together<L, D, W>>>::SHARE);
                scheme.pace(system, stride, workspace);
            }
            let ratio = pacing.ratio();
            let same = ratio.equal(Rows::ONE);
            if <S as Scheme<Together<L, D, W>>>::STRETCHES && !same.all() {
                let before = same.any().then(|| memory.clone());
                let stretched = scheme.stretch(system, stride, t, ratio, &mut memory, workspace);
                if let Some(before) = before {
                    memory.put(same, &before);
                }
                spent.evaluations += Rows::either(same, Rows::ZERO, Rows::from_f64(stretched.into()));
            }
            spent += scheme.step(system, stride, t, &mut memory, workspace).ok()?;
            let due = self.made(*longest, &mut pacing);
            if due.any() {
                let end = pacing.time.value();
                let q = <S as Scheme<Together<L, D, W>>>::position(&scheme, &memory);
                let v = scheme.velocity(system, stride, end, &memory);
                let look = system.look_along(end, *q, v, pacing.least(*longest));
                spent.evaluations += Rows::either(due, Rows::from_f64(EVALUATIONS.into()), Rows::ZERO);
                if self.is_too_long(&look, &pacing).and(due).any() {
                    return None;
                }
                self.looked(&look, due, &mut pacing);
            }
            self.plan(*longest, &mut pacing);
            made += 1;
        }
        if !<S as Scheme<Together<L, D, W>>>::finite(&scheme, &memory) {
            return None;
        }
        if let Some(work) = work.filter(|_| made > 0) {
            work.add(scheme.work(system, stride, &all.memory, &memory));
        }
        (all.memory, all.pacing, *cost) = (memory, pacing, spent);
        Some(made)
    }

    fn lane(&self, all: &Paced<L, S, D, W>, lane: usize) -> <Self as Scheme<Particle<L, D>>>::Memory {
        crate::scheme::AdaptiveMemory { inner: all.memory.lane(lane), pacing: all.pacing.lane(lane), too_long: false }
    }

    fn state(&self, system: &Together<L, D, W>, all: &Paced<L, S, D, W>) -> (Rows<W>, [[Rows<W>; D]; 2]) {
        let (scheme, Paced { stride, memory, pacing, .. }) = (self.scheme, all);
        let t = pacing.time.value();
        let q = *<S as Scheme<Together<L, D, W>>>::position(&scheme, memory);
        (t, [q, scheme.velocity(system, stride, t, memory)])
    }

    fn own_kinetic_energy(&self, system: &Together<L, D, W>, all: &Paced<L, S, D, W>) -> Rows<W> {
        self.scheme.kinetic_energy(system, &all.memory)
    }

    fn at_the_end(&self, all: &Paced<L, S, D, W>) -> Option<Rows<W>> {
        let arrived = self.has_arrived(&all.pacing);
        arrived.any().then(|| Rows::either(arrived, Rows::ONE, Rows::ZERO))
    }
}
