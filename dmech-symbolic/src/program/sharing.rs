//! Factors that several products have in common are multiplied once.
//!
//! Greedy: the pair of atoms that stands together in most products becomes an atom of its own, until no pair stands in
//! two. Ties go to the pair that is ready first. Under an exchange of the two ends of a step pairs are taken together
//! with their images, so that the choice does not depend on which end is called a.

use std::collections::{BTreeMap, BTreeSet};

use super::atom::{Atom, AtomKind, Atoms};

/// The image of an atom under the exchange.
pub(super) trait Exchange {
    fn image(&mut self, atoms: &mut Atoms, atom: Atom) -> Atom;
}

type Pair = (Atom, Atom);

fn ordered(one: Atom, two: Atom) -> Pair {
    (one.min(two), one.max(two))
}

fn pairs_of(product: &[Atom]) -> BTreeSet<Pair> {
    let mut pairs = BTreeSet::new();
    for (i, &one) in product.iter().enumerate() {
        for &two in &product[i + 1..] {
            pairs.insert(ordered(one, two));
        }
    }
    pairs
}

/// Multiplies every atom with its own image first: the result does not change under the exchange.
pub(super) fn group_images(product: &mut Vec<Atom>, atoms: &mut Atoms, exchange: &mut impl Exchange, ready: &[u32]) {
    let mut i = 0;
    while i < product.len() {
        let image = exchange.image(atoms, product[i]);
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
pub(super) fn share(products: &mut [Vec<Atom>], atoms: &mut Atoms, exchange: &mut impl Exchange, ready: &[u32]) {
    let mut places: BTreeMap<Pair, BTreeSet<usize>> = BTreeMap::new();
    for (i, product) in products.iter().enumerate() {
        for pair in pairs_of(product) {
            places.entry(pair).or_default().insert(i);
        }
    }
    loop {
        let best = places
            .iter()
            .filter(|(_, at)| at.len() > 1)
            .max_by_key(|(pair, at)| {
                let ready = atoms.ready[pair.0.0 as usize].max(atoms.ready[pair.1.0 as usize]);
                (at.len(), std::cmp::Reverse((ready, **pair)))
            })
            .map(|(&pair, _)| pair);
        let Some(pair) = best else { return };
        let image = ordered(exchange.image(atoms, pair.0), exchange.image(atoms, pair.1));
        let both = if image == pair { vec![pair] } else { vec![pair, image] };
        for pair in both {
            let at = places.get(&pair).cloned().unwrap_or_default();
            if at.len() > 1 {
                replace(pair, &at, products, atoms, &mut places, ready);
            }
        }
    }
}

fn replace(
    pair: Pair,
    at: &BTreeSet<usize>,
    products: &mut [Vec<Atom>],
    atoms: &mut Atoms,
    places: &mut BTreeMap<Pair, BTreeSet<usize>>,
    ready: &[u32],
) {
    let joined = atoms.intern(AtomKind::Pair(pair.0, pair.1), ready);
    for &i in at {
        for old in pairs_of(&products[i]) {
            if let Some(set) = places.get_mut(&old) {
                set.remove(&i);
                if set.is_empty() {
                    places.remove(&old);
                }
            }
        }
        let product = &mut products[i];
        for atom in [pair.0, pair.1] {
            let position = product.iter().position(|&a| a == atom).expect("the product contains the pair");
            product.remove(position);
        }
        product.push(joined);
        for new in pairs_of(product) {
            places.entry(new).or_default().insert(i);
        }
    }
}
