//! Schemes of the project as schemes of one's own.

use core::marker::PhantomData;

use dmech::extend::{Beginning, Effort, Kept, Method, NotConverged, OneStep, Real, Scheme, System};
use dmech::prelude::*;

/// Any scheme as one of one's own, which promises what `P` says and finds no solution from a time on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Own<S, P = Honest> {
    scheme: S,
    until: f64,
    promise: PhantomData<P>,
}

/// What a scheme says of itself, where it is not what `S` says.
pub(super) trait Promise<S: Method>: Copy + core::fmt::Debug {
    const ORDER: u32 = S::ORDER;

    fn keeps(invariant: Invariant) -> Kept {
        S::keeps(invariant)
    }
}

/// What `S` says.
#[derive(Clone, Copy, Debug)]
pub(super) struct Honest;
impl<S: Method> Promise<S> for Honest {}

pub(super) fn own<S>(scheme: S) -> Own<S> {
    until(scheme, f64::INFINITY)
}

pub(super) fn until<S>(scheme: S, until: f64) -> Own<S> {
    Own { scheme, until, promise: PhantomData }
}

pub(super) fn promising<P, S>(scheme: S) -> Own<S, P> {
    Own { scheme, until: f64::INFINITY, promise: PhantomData }
}

impl<S: Method, P: Promise<S>> OneStep for Own<S, P> {}

impl<S: Method, P: Promise<S>> Method for Own<S, P> {
    const NAME: &'static str = S::NAME;
    const ORDER: u32 = P::ORDER;
    const SYMMETRIC: bool = S::SYMMETRIC;

    fn keeps(invariant: Invariant) -> Kept {
        P::keeps(invariant)
    }
}

impl<Y: System, S: Scheme<Y>, P: Promise<S>> Scheme<Y> for Own<S, P> {
    const SHARE: f64 = S::SHARE;
    type Memory = S::Memory;
    type Workspace = S::Workspace;

    fn workspace(&self, system: &Y, stride: &Y::Stride) -> S::Workspace {
        self.scheme.workspace(system, stride)
    }
    fn pace(&self, system: &Y, stride: &Y::Stride, workspace: &mut S::Workspace) {
        self.scheme.pace(system, stride, workspace);
    }
    fn watch(&self, watched: bool, workspace: &mut S::Workspace) {
        self.scheme.watch(watched, workspace);
    }
    fn begin(
        &self,
        system: &Y,
        stride: &Y::Stride,
        start: &Beginning<'_, Y>,
        workspace: &mut S::Workspace,
    ) -> Result<S::Memory, NotConverged> {
        self.scheme.begin(system, stride, start, workspace)
    }
    fn step(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        memory: &mut S::Memory,
        workspace: &mut S::Workspace,
    ) -> Result<Effort<Y::Scalar>, NotConverged> {
        if t.to_f64() > self.until {
            return Err(NotConverged { iterations: 1, residual: 0.5 });
        }
        self.scheme.step(system, stride, t, memory, workspace)
    }
    fn stretch(
        &self,
        system: &Y,
        stride: &Y::Stride,
        t: Y::Scalar,
        ratio: Y::Scalar,
        memory: &mut S::Memory,
        workspace: &mut S::Workspace,
    ) -> u32 {
        self.scheme.stretch(system, stride, t, ratio, memory, workspace)
    }
    fn position<'m>(&self, memory: &'m S::Memory) -> &'m Y::Vector {
        self.scheme.position(memory)
    }
    fn velocity(&self, system: &Y, stride: &Y::Stride, t: Y::Scalar, memory: &S::Memory) -> Y::Vector {
        self.scheme.velocity(system, stride, t, memory)
    }
    fn finite(&self, memory: &S::Memory) -> bool {
        self.scheme.finite(memory)
    }
    fn kinetic_energy(&self, system: &Y, memory: &S::Memory) -> Y::Scalar {
        self.scheme.kinetic_energy(system, memory)
    }
    fn work(&self, system: &Y, stride: &Y::Stride, before: &S::Memory, after: &S::Memory) -> Y::Scalar {
        self.scheme.work(system, stride, before, after)
    }
}
