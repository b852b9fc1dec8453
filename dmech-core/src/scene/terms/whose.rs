//! Whose a law is that acts on each body: one for all of them, or each its own.

use std::sync::Arc;

use crate::law::Law;

/// Where the law on each body comes from, for bodies that carry a `P`.
pub trait Given<P> {
    /// The laws, once they are there.
    type Laws: OfBodies;

    /// The laws on bodies that carry these.
    fn laws(self, data: &[P]) -> Self::Laws;
}

/// Where the law on a body is found.
pub trait OfBodies {
    /// One of them.
    type Law;
    /// Each body has its own.
    const OWN: bool;

    /// The law on body i.
    fn of(&self, i: usize) -> &Self::Law;
    /// The law that is one for all, or, on a body, the one that it has of its own.
    fn of_mut(&mut self, on: Option<usize>) -> Option<&mut Self::Law>;
    /// The numbers of all of them, by name.
    fn tell<const D: usize>(&self, see: &mut dyn FnMut(&'static str, f64))
    where
        Self::Law: Law<D>;
}

/// One law on all bodies.
#[derive(Clone, Copy, Debug)]
pub struct One<X>(pub(in crate::scene) X);

impl<P, X> Given<P> for One<X> {
    type Laws = Self;

    fn laws(self, _: &[P]) -> Self {
        self
    }
}

impl<X> OfBodies for One<X> {
    type Law = X;
    const OWN: bool = false;

    #[inline(always)]
    fn of(&self, _: usize) -> &X {
        &self.0
    }

    fn of_mut(&mut self, on: Option<usize>) -> Option<&mut X> {
        on.is_none().then_some(&mut self.0)
    }

    fn tell<const D: usize>(&self, see: &mut dyn FnMut(&'static str, f64))
    where
        X: Law<D>,
    {
        self.0.tell(see);
    }
}

/// What makes the law of a body, of its number and of what it carries.
type Maker<X, P> = dyn Fn(usize, &P) -> X + Send + Sync;

/// A law on each body of its own, by the number of the body and what it carries.
pub struct Own<X, P>(Arc<Maker<X, P>>);

impl<X, P> Own<X, P> {
    pub(in crate::scene) fn new(law: impl Fn(usize, &P) -> X + Send + Sync + 'static) -> Self {
        Own(Arc::new(law))
    }
}

impl<X, P> Clone for Own<X, P> {
    fn clone(&self) -> Self {
        Own(Arc::clone(&self.0))
    }
}

impl<X, P> core::fmt::Debug for Own<X, P> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Own").finish_non_exhaustive()
    }
}

impl<X, P> Given<P> for Own<X, P> {
    type Laws = List<X>;

    fn laws(self, data: &[P]) -> List<X> {
        List(data.iter().enumerate().map(|(i, data)| (self.0)(i, data)).collect())
    }
}

/// The law on each body.
#[derive(Clone, Debug)]
pub struct List<X>(Vec<X>);

impl<X> OfBodies for List<X> {
    type Law = X;
    const OWN: bool = true;

    #[inline(always)]
    fn of(&self, i: usize) -> &X {
        &self.0[i]
    }

    fn of_mut(&mut self, on: Option<usize>) -> Option<&mut X> {
        self.0.get_mut(on?)
    }

    /// Those of one name follow each other, so that a checkpoint has a line for each name and not for each body; and whose they are,
    /// as a law that is not there tells nothing.
    fn tell<const D: usize>(&self, see: &mut dyn FnMut(&'static str, f64))
    where
        X: Law<D>,
    {
        let mut columns: Vec<(&'static str, Vec<f64>)> = Vec::new();
        for (i, law) in self.0.iter().enumerate() {
            let mut tells = false;
            law.tell(&mut |name, x| {
                if !core::mem::replace(&mut tells, true) {
                    see("bodies with a law", i as f64);
                }
                match columns.iter_mut().find(|(other, _)| *other == name) {
                    Some((_, column)) => column.push(x),
                    None => columns.push((name, vec![x])),
                }
            });
        }
        for (name, column) in columns {
            column.into_iter().for_each(|x| see(name, x));
        }
    }
}
