//! The exchange of the two ends of a step, on expressions and atoms.

use crate::expression::{Expr, Graph, Substitution};
use crate::hash::Map;

use super::atom::{Atom, AtomKind, Atoms};

/// The image of everything that the exchange moves; without an exchange everything is its own.
#[derive(Default)]
pub(super) struct Mirror {
    images: Map<Expr, Expr>,
    atoms: Map<Atom, Atom>,
}

/// A mirror that can find the images of atoms not seen before.
pub(super) struct Exchange<'a> {
    mirror: &'a mut Mirror,
    ready: &'a [u32],
}

impl Mirror {
    pub(super) fn new(graph: &mut Graph, order: &[Expr], mut exchange: Substitution) -> Self {
        let images = order.iter().map(|&e| (e, exchange.apply(graph, e))).collect();
        Self { images, atoms: Map::default() }
    }

    pub(super) fn images(&self) -> impl Iterator<Item = Expr> {
        self.images.values().copied()
    }

    pub(super) fn of_expr(&self, e: Expr) -> Expr {
        self.images.get(&e).copied().unwrap_or(e)
    }

    pub(super) fn with<'a>(&'a mut self, ready: &'a [u32]) -> Exchange<'a> {
        Exchange { mirror: self, ready }
    }
}

impl Exchange<'_> {
    /// The image of an atom.
    pub(super) fn image(&mut self, atoms: &mut Atoms, atom: Atom) -> Atom {
        if self.mirror.images.is_empty() {
            return atom;
        }
        if let Some(&image) = self.mirror.atoms.get(&atom) {
            return image;
        }
        let kind = match atoms.kind(atom).clone() {
            AtomKind::Base(e) => AtomKind::Base(self.mirror.of_expr(e)),
            AtomKind::Number(n) => AtomKind::Number(n),
            AtomKind::Power(e, n) => AtomKind::Power(self.mirror.of_expr(e), n),
            AtomKind::Inverse(e, n) => AtomKind::Inverse(self.mirror.of_expr(e), n),
            AtomKind::Denominator(below) => {
                let mut below: Vec<_> = below.iter().map(|&(e, n)| (self.mirror.of_expr(e), n)).collect();
                below.sort_unstable();
                AtomKind::Denominator(below)
            }
            AtomKind::Pair(one, two) => {
                let (one, two) = (self.image(atoms, one), self.image(atoms, two));
                AtomKind::Pair(one.min(two), one.max(two))
            }
        };
        let image = atoms.intern(kind, self.ready);
        self.mirror.atoms.insert(atom, image);
        self.mirror.atoms.insert(image, atom);
        image
    }
}
