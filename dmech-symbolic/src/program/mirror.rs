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

    /// The image of an atom.
    pub(super) fn image(&mut self, atoms: &mut Atoms, atom: Atom, ready: &[u32]) -> Atom {
        if self.images.is_empty() {
            return atom;
        }
        if let Some(&image) = self.atoms.get(&atom) {
            return image;
        }
        let kind = match atoms.kind(atom).clone() {
            AtomKind::Base(e) => AtomKind::Base(self.of_expr(e)),
            AtomKind::Number(n) => AtomKind::Number(n),
            AtomKind::Power(e, n) => AtomKind::Power(self.of_expr(e), n),
            AtomKind::Inverse(e, n) => AtomKind::Inverse(self.of_expr(e), n),
            AtomKind::Denominator(below) => {
                let mut below: Vec<_> = below.iter().map(|&(e, n)| (self.of_expr(e), n)).collect();
                below.sort_unstable();
                AtomKind::Denominator(below)
            }
            AtomKind::Pair(one, two) => {
                let (one, two) = (self.image(atoms, one, ready), self.image(atoms, two, ready));
                AtomKind::Pair(one.min(two), one.max(two))
            }
        };
        let image = atoms.intern(kind, ready);
        self.atoms.insert(atom, image);
        self.atoms.insert(image, atom);
        image
    }
}
