//! The products of a program, each once, with the atoms that it is multiplied from.

use crate::expression::{Expr, Graph, Node, Number};
use crate::hash::Map;

use super::atom::{Atom, AtomKind, Atoms, Denominators, Factors};
use super::mirror::Mirror;
use super::sharing;

/// Which product.
#[derive(Clone, Copy, Debug)]
pub(super) struct Product(usize);

/// All products of a program.
pub(super) struct Products {
    /// |c|·t, as it stands in sums and alone.
    of_term: Map<(Number, Expr), Option<Product>>,
    of_factors: Map<Factors, Product>,
    /// How often each stands in the expressions.
    uses: Vec<usize>,
    atoms: Vec<Vec<Atom>>,
    /// How many products and shared pairs each atom is part of.
    company: Vec<usize>,
    pub(super) denominators: Denominators,
}

impl Products {
    /// Finds the products, and multiplies what they have in common once.
    pub(super) fn new(
        graph: &Graph,
        order: &[Expr],
        outputs: &[Expr],
        atoms: &mut Atoms,
        mirror: &mut Mirror,
        ready: &[u32],
    ) -> Self {
        let mut products = Self {
            of_term: Map::default(),
            of_factors: Map::default(),
            uses: vec![],
            atoms: vec![],
            company: vec![],
            denominators: Denominators::default(),
        };
        for &e in order {
            match graph.node(e) {
                Node::Sum { terms, .. } => terms.iter().for_each(|&(c, t)| products.count(graph, c, t)),
                Node::Product { factors, .. } => {
                    factors.iter().for_each(|&(f, _)| products.count(graph, Number::ONE, f));
                }
                _ => graph.each_child(e, |c| products.count(graph, Number::ONE, c)),
            }
        }
        outputs.iter().for_each(|&e| products.count(graph, Number::ONE, e));
        products.denominators = Denominators::of(graph, products.of_factors.keys());
        let compared = products.compared(graph, order);
        products.atoms = vec![vec![]; products.uses.len()];
        // What an atom is numbered must not depend on the order of a map.
        let mut sorted: Vec<_> = products.of_factors.iter().collect();
        sorted.sort_unstable_by_key(|&(factors, _)| factors);
        for &(factors, &Product(i)) in &sorted {
            let denominators = if compared[i] { None } else { Some(&products.denominators) };
            products.atoms[i] = atoms.of_product(graph, factors, denominators, ready);
        }
        for (_, &Product(i)) in sorted {
            sharing::group_images(&mut products.atoms[i], atoms, mirror, ready);
        }
        sharing::share(&mut products.atoms, atoms, mirror, ready);
        products.count_company(atoms);
        products
    }

    fn count(&mut self, graph: &Graph, c: Number, t: Expr) {
        let found = match self.of_term.get(&(c, t)) {
            Some(&found) => found,
            None => {
                let found = factors_of_term(graph, c, t).map(|factors| {
                    let next = Product(self.uses.len());
                    let product = *self.of_factors.entry(factors).or_insert(next);
                    if product.0 == next.0 {
                        self.uses.push(0);
                    }
                    product
                });
                self.of_term.insert((c, t), found);
                found
            }
        };
        if let Some(Product(i)) = found {
            self.uses[i] += 1;
        }
    }

    fn count_company(&mut self, atoms: &Atoms) {
        let mut company = vec![0; atoms.kinds.len()];
        for list in &self.atoms {
            let mut list = list.clone();
            list.sort_unstable();
            list.dedup();
            list.into_iter().for_each(|atom| company[atom.index()] += 1);
        }
        for kind in &atoms.kinds {
            if let &AtomKind::Pair(one, two) = kind {
                company[one.index()] += 1;
                if two != one {
                    company[two.index()] += 1;
                }
            }
        }
        self.company = company;
    }

    /// The products that choices are made by, alone or in a sum: their values must be right even where they are infinite.
    fn compared(&self, graph: &Graph, order: &[Expr]) -> Vec<bool> {
        let mut found = vec![false; self.uses.len()];
        for &e in order {
            let sides = match graph.node(e) {
                Node::Select(condition, ..) => condition.operands(),
                Node::Binary(f, u, w) if f.is_extremum() => vec![*u, *w],
                _ => continue,
            };
            for side in sides {
                let alone = [(Number::ONE, side)];
                let terms = match graph.node(side) {
                    Node::Sum { terms, .. } => terms,
                    _ => &alone[..],
                };
                terms.iter().filter_map(|&(c, t)| self.of_term(c, t)).for_each(|Product(i)| found[i] = true);
            }
        }
        found
    }

    /// |c|·t as a product, if it is one.
    pub(super) fn of_term(&self, c: Number, t: Expr) -> Option<Product> {
        self.of_term[&(c, t)]
    }

    /// Whether it stands in one place only.
    pub(super) fn stands_once(&self, product: Product) -> bool {
        self.uses[product.0] == 1
    }

    pub(super) fn atoms(&self, product: Product) -> &[Atom] {
        &self.atoms[product.0]
    }

    /// Whether the atom is part of one product or pair only.
    pub(super) fn single(&self, atom: Atom) -> bool {
        self.company.get(atom.index()) == Some(&1)
    }
}

/// The coefficient of c t: normal form keeps it outside of terms, and a term of its own has coefficient 1.
fn coefficient(graph: &Graph, c: Number, t: Expr) -> Number {
    match graph.node(t) {
        Node::Product { coefficient, .. } if *coefficient != Number::ONE => *coefficient,
        _ => c,
    }
}

pub(super) fn is_negative(graph: &Graph, c: Number, t: Expr) -> bool {
    coefficient(graph, c, t).value() < 0.0
}

fn factors_of_term(graph: &Graph, c: Number, t: Expr) -> Option<Factors> {
    let size = Number::new(coefficient(graph, c, t).value().abs());
    let is_product = matches!(graph.node(t), Node::Product { .. });
    (is_product || size != Number::ONE).then(|| (size, graph.factors(t).1))
}
