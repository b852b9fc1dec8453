//! Compositions of any symmetric one-step scheme, step by step.

use dmech_scalar::Real;

use super::{Coefficients, Composable, Composed, gamma, strides};
use crate::invariant::{Invariant, Kept};
use crate::newton::NotConverged;
use crate::scheme::{Effort, Method, Scheme};
use crate::system::{Beginning, System};

/// A symmetric scheme whose step depends on the state alone, or that can [`stretch`](Scheme::stretch) what it carries: steps of
/// any lengths, also backward, may follow one another. It says so of itself, to be composed in [`Steps`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say that its steps may differ in length",
    note = "where a step depends on the state alone, `impl OneStep for {Self} {{}}` says so"
)]
pub trait OneStep: Method {}

/// A scheme of one's own in a composition: `Composed::order4(Steps(scheme))`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Steps<S>(pub S);

impl<S: OneStep> Composable for Steps<S> {}

impl<S: OneStep> Method for Steps<S> {
    const NAME: &'static str = S::NAME;
    const ORDER: u32 = S::ORDER;
    const SYMMETRIC: bool = S::SYMMETRIC;

    fn keeps(invariant: Invariant) -> Kept {
        S::keeps(invariant)
    }
}

/// What a composition of steps carries: what the scheme does, and the work of the last step.
#[derive(Clone, Copy, Debug)]
pub struct StepsMemory<M, R> {
    inner: M,
    work: R,
}

/// What a step works in.
#[derive(Clone, Debug)]
pub struct StepsRoom<T, M, W, const N: usize> {
    /// γ_k h and what follows from it.
    strides: [T; N],
    inner: W,
    /// The stage that the inner workspace is prepared for: after one that failed it is not the first.
    paced: usize,
    /// What the scheme carried before a stage, where its work is asked for.
    before: Option<M>,
    /// It is from before the whole step was stretched, which is work of the first stage.
    stretched: bool,
    watched: bool,
}

/// A copy, into what is there if there is.
fn keep<M: Clone>(place: &mut Option<M>, memory: &M) {
    match place {
        Some(place) => place.clone_from(memory),
        None => *place = Some(memory.clone()),
    }
}

#[cfg(feature = "serde")]
impl<M: crate::checkpoint::Carried, R: Clone> crate::checkpoint::Carried for StepsMemory<M, R> {
    fn carried(&mut self) -> Vec<&mut [f64]> {
        self.inner.carried()
    }
}

impl<S: OneStep, C: Coefficients<N>, const N: usize> Composed<Steps<S>, C, N> {
    const SYMMETRIC_STAGES: () = assert!(S::SYMMETRIC, "only symmetric schemes gain an order by composition");
}

impl<Y: System, S: OneStep + Scheme<Y>, C: Coefficients<N>, const N: usize> Scheme<Y> for Composed<Steps<S>, C, N> {
    const STRETCHES: bool = S::STRETCHES;

    type Memory = StepsMemory<S::Memory, Y::Scalar>;
    type Workspace = StepsRoom<Y::Stride, S::Memory, S::Workspace, N>;

    fn workspace(&self, system: &Y, stride: &Y::Stride) -> Self::Workspace {
        let () = Self::SYMMETRIC_STAGES;
        let strides = strides::<Y, C, N>(system, stride, S::SHARE);
        let inner = self.scheme.0.workspace(system, &strides[0]);
        StepsRoom { strides, inner, paced: 0, before: None, stretched: false, watched: true }
    }

    fn pace(&self, system: &Y, stride: &Y::Stride, room: &mut Self::Workspace) {
        room.strides = strides::<Y, C, N>(system, stride, S::SHARE);
        room.paced = 0;
        self.scheme.0.pace(system, &room.strides[0], &mut room.inner);
    }

    /// The first stage is as many times longer as the step, and as long as the last.
    fn stretch(
        &self,
        system: &Y,
        _: &Y::Stride,
        t: Y::Scalar,
        ratio: Y::Scalar,
        memory: &mut Self::Memory,
        StepsRoom { strides, inner, before, stretched, watched, .. }: &mut Self::Workspace,
    ) -> u32 {
        if *watched {
            keep(before, &memory.inner);
            *stretched = true;
        }
        self.scheme.0.stretch(system, &strides[0], t, ratio, &mut memory.inner, inner)
    }

    fn watch(&self, watched: bool, room: &mut Self::Workspace) {
        room.watched = watched;
        self.scheme.0.watch(watched, &mut room.inner);
    }

    fn begin(
        &self,
        system: &Y,
        _: &Y::Stride,
        start: &Beginning<'_, Y>,
        StepsRoom { strides, inner, .. }: &mut Self::Workspace,
    ) -> Result<Self::Memory, NotConverged> {
        let inner = self.scheme.0.begin(system, &strides[0], start, inner)?;
        Ok(StepsMemory { inner, work: Y::Scalar::ZERO })
    }

    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        StepsMemory { inner: memory, work }: &mut Self::Memory,
        StepsRoom { strides, inner, paced, before, stretched, watched }: &mut Self::Workspace,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        let (scheme, mut effort) = (&self.scheme.0, Effort::default());
        *work = Y::Scalar::ZERO;
        for k in 0..N {
            let t = Y::Scalar::from_f64(Self::begins(k)).mul_add(Y::dt(stride), t);
            if *watched && !core::mem::take(stretched) {
                keep(before, memory);
            }
            if C::GAMMA[k] != C::GAMMA[*paced] {
                scheme.pace(system, &strides[k], inner);
            }
            *paced = k;
            // The first stage is as long as the last one of the step before.
            if k > 0 && C::GAMMA[k] != C::GAMMA[k - 1] {
                let ratio = Y::dt(&strides[k]) / Y::dt(&strides[k - 1]);
                effort += Effort::of(scheme.stretch(system, &strides[k], t, ratio, memory, inner));
            }
            let cost = scheme.step(system, &strides[k], t, memory, inner)?;
            if let Some(before) = before.as_ref().filter(|_| *watched) {
                *work += scheme.work(system, &strides[k], before, memory);
            }
            effort += cost;
        }
        Ok(effort)
    }

    fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Y::Vector {
        self.scheme.0.position(&memory.inner)
    }

    fn velocity(&self, system: &Y, stride: &Y::Stride, t: Y::Scalar, memory: &Self::Memory) -> Y::Vector {
        let last = system.stage(stride, gamma::<_, C, N>(N - 1), S::SHARE);
        self.scheme.0.velocity(system, &last, t, &memory.inner)
    }

    fn finite(&self, memory: &Self::Memory) -> bool {
        self.scheme.0.finite(&memory.inner)
    }

    fn kinetic_energy(&self, system: &Y, memory: &Self::Memory) -> Y::Scalar {
        self.scheme.0.kinetic_energy(system, &memory.inner)
    }

    /// The sum over the stages, each as the scheme has it.
    fn work(&self, _: &Y, _: &Y::Stride, _: &Self::Memory, after: &Self::Memory) -> Y::Scalar {
        after.work
    }

    fn discrete_energy(&self, system: &Y, t: Y::Scalar, memory: &Self::Memory) -> Option<Y::Scalar> {
        self.scheme.0.discrete_energy(system, t, &memory.inner)
    }
}
