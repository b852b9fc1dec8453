//! Factors that several products have in common are multiplied once.
//!
//! Greedy: the pair of atoms that stands together in most products becomes an atom of its own, until no pair stands in
//! two. Ties go to the pair that is ready first. Under an exchange of the two ends of a step pairs are taken together
//! with their images, so that the choice does not depend on which end is called a.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::hash::Map;

use super::atom::{Atom, AtomKind, Atoms};
use super::mirror::Mirror;

type Pair = (Atom, Atom);

fn ordered(one: Atom, two: Atom) -> Pair {
    (one.min(two), one.max(two))
}

/// The pairs of a product that have an atom in view, each once.
fn pairs_of(product: &[Atom], in_view: impl Fn(Atom) -> bool) -> Vec<Pair> {
    let mut pairs = vec![];
    for (i, &one) in product.iter().enumerate() {
        let one_in_view = in_view(one);
        for &two in &product[i + 1..] {
            if one_in_view || in_view(two) {
                pairs.push(ordered(one, two));
            }
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// Multiplies every atom with its own image first: the result does not change under the exchange.
pub(super) fn group_images(product: &mut Vec<Atom>, atoms: &mut Atoms, mirror: &mut Mirror, ready: &[u32]) {
    let mut i = 0;
    while i < product.len() {
        let image = mirror.image(atoms, product[i], ready);
        let partner = product.iter().skip(i + 1).position(|&other| other == image && other != product[i]);
        if let Some(offset) = partner {
            let two = product.remove(i + 1 + offset);
            let one = product.remove(i);
            let (one, two) = ordered(one, two);
            let pair = atoms.intern(AtomKind::Pair(one, two), ready);
            product.push(pair);
        } else {
            i += 1;
        }
    }
}

/// Rewrites the products until they share no pair.
pub(super) fn share(products: &mut [Vec<Atom>], atoms: &mut Atoms, mirror: &mut Mirror, ready: &[u32]) {
    let mut pairs = Pairs::default();
    for (i, product) in products.iter().enumerate() {
        for pair in pairs_of(product, |_| true) {
            pairs.places.entry(pair).or_default().push(i);
        }
    }
    pairs.queue = pairs.places.iter().filter_map(|(&pair, at)| turn(pair, at.len(), atoms)).collect();
    while let Some(pair) = pairs.best(atoms) {
        let image = ordered(mirror.image(atoms, pair.0, ready), mirror.image(atoms, pair.1, ready));
        let both = if image == pair { vec![pair] } else { vec![pair, image] };
        for pair in both {
            pairs.replace(pair, products, atoms, ready);
        }
    }
}

/// How many products a pair stands in, when it is ready, and itself: the greatest is taken next.
type Turn = (usize, Reverse<(u32, Pair)>);

fn turn(pair: Pair, count: usize, atoms: &Atoms) -> Option<Turn> {
    let ready = atoms.ready[pair.0.index()].max(atoms.ready[pair.1.index()]);
    (count > 1).then_some((count, Reverse((ready, pair))))
}

/// Where each pair stands.
#[derive(Default)]
struct Pairs {
    /// The products that each pair stands in, in order.
    places: Map<Pair, Vec<usize>>,
    /// At least one turn for each shared pair, none of its counts too low; too high a count is put right when its turn comes, so
    /// that no pair is looked for again after every rewriting.
    queue: BinaryHeap<Turn>,
}

impl Pairs {
    fn best(&mut self, atoms: &Atoms) -> Option<Pair> {
        while let Some((believed, Reverse((_, pair)))) = self.queue.pop() {
            let count = self.places.get(&pair).map_or(0, Vec::len);
            if count == believed {
                return Some(pair);
            }
            self.queue.extend(turn(pair, count, atoms));
        }
        None
    }

    /// Makes the pair one atom in every product, if it stands in several.
    fn replace(&mut self, pair: Pair, products: &mut [Vec<Atom>], atoms: &mut Atoms, ready: &[u32]) {
        let at = match self.places.get(&pair) {
            Some(at) if at.len() > 1 => at.clone(),
            _ => return,
        };
        let joined = atoms.intern(AtomKind::Pair(pair.0, pair.1), ready);
        let changes = |atom| atom == pair.0 || atom == pair.1 || atom == joined;
        let mut grown = vec![];
        for i in at {
            let product = &mut products[i];
            for old in pairs_of(product, changes) {
                self.leave(old, i);
            }
            for atom in [pair.0, pair.1] {
                let position = product.iter().position(|&a| a == atom).expect("the product contains the pair");
                product.remove(position);
            }
            product.push(joined);
            for new in pairs_of(product, changes) {
                self.enter(new, i);
                grown.push(new);
            }
        }
        grown.sort_unstable();
        grown.dedup();
        let turns = grown.iter().filter_map(|pair| turn(*pair, self.places[pair].len(), atoms));
        self.queue.extend(turns);
    }

    fn leave(&mut self, pair: Pair, place: usize) {
        let Some(places) = self.places.get_mut(&pair) else { return };
        if let Ok(i) = places.binary_search(&place) {
            places.remove(i);
        }
    }

    fn enter(&mut self, pair: Pair, place: usize) {
        let places = self.places.entry(pair).or_default();
        if let Err(i) = places.binary_search(&place) {
            places.insert(i, place);
        }
    }
}
