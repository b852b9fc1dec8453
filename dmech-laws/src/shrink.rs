//! Making a law that fails smaller while it fails in the same way.

use super::engine::Engine;
use super::finding::Finding;
use super::grow::Law;
use super::points::seam_between;
use super::random::Random;
use super::tree::Tree;
use super::trial::try_pair;

/// The smallest law that was found to fail as this one does.
pub(crate) fn shrunk(mut finding: Finding, second: bool, slopes: bool) -> Finding {
    for _ in 0..200 {
        let Some(smaller) = candidates(&finding.law.tree).into_iter().find_map(|tree| {
            let law = Law { tree, dimension: finding.law.dimension };
            let [a, b] = &finding.ends;
            let failure = try_pair(&law, &Engine::new(&law, second), a, b, slopes).failure?;
            (failure.promise == finding.failure.promise && is_continuous(&law) && is_defined(&law))
                .then_some((law, failure))
        }) else {
            break;
        };
        (finding.law, finding.failure) = smaller;
    }
    finding
}

/// The tree with one kind of subtree replaced by something smaller, wherever it stands.
fn candidates(tree: &Tree) -> Vec<Tree> {
    let mut parts: Vec<&Tree> = vec![];
    tree.visit(&mut |t| {
        if !parts.contains(&t) {
            parts.push(t);
        }
    });
    let mut found = vec![];
    for part in parts {
        let mut smaller: Vec<Tree> = part.children().into_iter().cloned().collect();
        smaller.extend([0.0, 1.0].map(Tree::Number));
        smaller.extend((0..4).filter(|&i| part.contains(i)).map(Tree::Coordinate));
        smaller.retain(|s| s.size() < part.size() || matches!((s, part), (Tree::Number(_), Tree::Parameter(_))));
        found.extend(smaller.into_iter().map(|s| replaced(tree, part, &s)));
    }
    found.sort_by_key(Tree::size);
    found.dedup();
    found
}

fn replaced(tree: &Tree, old: &Tree, new: &Tree) -> Tree {
    if tree == old { new.clone() } else { tree.map(&mut |child| replaced(child, old, new)) }
}

/// Whether the law does not jump at the seams that random segments cross.
pub fn is_continuous(law: &Law) -> bool {
    let mut random = Random::new(1);
    for k in 0..32 {
        let mut point = || (0..law.dimension).map(|_| random.within(-2.5, 2.5)).collect::<Vec<_>>();
        // Every other one from the origin: what is chosen on a distance has its seam around it.
        let (a, b) = (if k % 2 == 0 { point() } else { vec![0.0; law.dimension] }, point());
        let Some((before, after)) = seam_between(law, &a, &b) else { continue };
        let (left, right): (f64, f64) = (law.tree.value(&before), law.tree.value(&after));
        // Roots are vertical somewhere: 1e-16 in the argument is 1e-4 in a fourth root.
        if (left - right).abs() > 1e-3 * (1.0 + left.abs()) {
            return false;
        }
    }
    true
}

/// Whether every expression in the law has a value at random points, as it has in the laws that are grown.
fn is_defined(law: &Law) -> bool {
    let mut random = Random::new(2);
    (0..12).all(|_| {
        let q: Vec<f64> = (0..law.dimension).map(|_| random.within(-2.5, 2.5)).collect();
        let mut defined = true;
        law.tree.visit(&mut |t| defined &= !t.value(&q).is_nan());
        defined
    })
}
