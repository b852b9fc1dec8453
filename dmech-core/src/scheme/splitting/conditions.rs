//! The order conditions of drifts and kicks, as trees, and every set of coefficients against them.
//!
//! The velocity after a step is Σ over trees of (Σ_k b_k g(c_k)) times derivatives of the acceleration, where g of a tree is
//! the product over its branches: c for one that ends at the velocity, and for one that ends at the force of another
//! tree the second integral of that tree's g, Σ_{j<k} b_j (c_k − c_j) g_j. With the integrals taken exactly g is K xᵖ⁻¹, p
//! the order of the tree, and ∫g = K/p: each tree is a condition (E. Hairer, S. P. Nørsett and G. Wanner, Solving
//! Ordinary Differential Equations I, II.14). The term e_k a′a of a kick applies the product rule to g with a derivative
//! that turns a branch of the force of a tree into the tree. Conditions on the position follow from those on the
//! velocity, as the step reads the same from both ends.

use super::super::coefficients::*;
use super::super::{ForceGradient, Nystrom};
use super::{First, Splitting};

/// A tree: the branches that end at the velocity, and those that end at the force of smaller trees.
struct Tree {
    order: usize,
    leaves: u32,
    subtrees: Vec<usize>,
}

/// All trees up to an order, smaller ones first.
fn trees(order: usize) -> Vec<Tree> {
    let mut all: Vec<Tree> = Vec::new();
    for order in 1..=order {
        let known: Vec<usize> = all.iter().map(|tree| tree.order).collect();
        extend(&mut all, &known, order, order - 1, known.len(), &mut Vec::new());
    }
    all
}

/// Adds the trees with these branches and more, none of them later than `last`, and leaves for what is left.
fn extend(all: &mut Vec<Tree>, known: &[usize], order: usize, left: usize, last: usize, subtrees: &mut Vec<usize>) {
    all.push(Tree { order, leaves: left as u32, subtrees: subtrees.clone() });
    for i in (0..last).filter(|&i| known[i] < left) {
        subtrees.push(i);
        extend(all, known, order, left - known[i] - 1, i + 1, subtrees);
        subtrees.pop();
    }
}

/// A kick: where in the step, its length, its gradient term.
struct Kick {
    c: f64,
    b: f64,
    e: f64,
}

fn kicks<S: Splitting<N>, const N: usize>() -> Vec<Kick> {
    let kick = |c, k| Kick { c, b: S::KICKS[k], e: S::GRADIENTS[k] };
    let mut all = Vec::new();
    let mut c = 0.0;
    for k in 0..N {
        if S::FIRST == First::Kick {
            all.push(kick(c, k));
        }
        c += S::DRIFTS[k];
        if S::FIRST == First::Drift {
            all.push(kick(c, k));
        }
    }
    if S::FIRST == First::Kick {
        all.push(kick(c, 0));
    }
    all
}

/// g of a tree at each kick, its second integral, K.
struct Values {
    g: Vec<f64>,
    integral: Vec<f64>,
    k: f64,
}

/// For each tree what the step makes of it, in the order of `trees`, and the exact value.
fn sums(kicks: &[Kick], trees: &[Tree]) -> Vec<(f64, f64)> {
    let mut known: Vec<Values> = Vec::new();
    let mut all = Vec::new();
    for tree in trees {
        let product = |i: usize, without: Option<usize>| -> f64 {
            let branches = tree.subtrees.iter().enumerate().filter(|&(branch, _)| Some(branch) != without);
            kicks[i].c.powi(tree.leaves as i32) * branches.map(|(_, &s)| known[s].integral[i]).product::<f64>()
        };
        let g: Vec<f64> = (0..kicks.len()).map(|i| product(i, None)).collect();
        let derived = |i: usize| -> f64 {
            let branches = tree.subtrees.iter().enumerate();
            branches.map(|(branch, &s)| known[s].g[i] * product(i, Some(branch))).sum()
        };
        let derived: Vec<f64> = (0..kicks.len()).map(derived).collect();
        let k = tree.subtrees.iter().map(|&s| known[s].k / (trees[s].order * (trees[s].order + 1)) as f64).product();
        let jump = |j: usize| kicks[j].b * g[j] + kicks[j].e * derived[j];
        let integral = |i: usize| (0..i).map(|j| jump(j) * (kicks[i].c - kicks[j].c)).sum();
        let integral = (0..kicks.len()).map(integral).collect();
        all.push(((0..kicks.len()).map(jump).sum(), k / tree.order as f64));
        known.push(Values { g, integral, k });
    }
    all
}

/// The largest violation of a condition up to the order, in units of what rounding leaves of the sums, and the largest of
/// the next order.
fn violations<S: Splitting<N>, const N: usize>() -> (f64, f64) {
    let trees = trees(S::ORDER as usize + 1);
    let found = kicks::<S, N>();
    let sizes: Vec<_> = found.iter().map(|kick| Kick { c: kick.c, b: kick.b.abs(), e: kick.e.abs() }).collect();
    let (mut worst, mut beyond) = (0.0_f64, 0.0_f64);
    for ((tree, (sum, exact)), (size, _)) in trees.iter().zip(sums(&found, &trees)).zip(sums(&sizes, &trees)) {
        let violation = (sum - exact).abs();
        if tree.order <= S::ORDER as usize {
            worst = worst.max(violation / (f64::EPSILON * size.abs()));
        } else {
            beyond = beyond.max(violation);
        }
    }
    println!("{:<32} {N:>2} stages: {worst:.1} units of rounding, {beyond:.1e} beyond", S::NAME);
    (worst, beyond)
}

/// Runs a macro for every set.
macro_rules! for_each_set {
    ($run:ident) => {
        $run! { Nystrom: McLachlan4S4 McLachlan4S5 BlanesMoan4S6 OkunborSkeel6S7 BlanesMoan6S11 BlanesMoan6S14
        Blanes8S19 }
        $run! { ForceGradient: Chin4A Chin4C Omelyan4S3 Omelyan4S4 Omelyan4S5 Omelyan6S5 Omelyan8S11
        Smooth8S14 }
    };
}

#[test]
fn every_set_satisfies_the_conditions_of_its_order_and_no_more() {
    // Trees of orders 1, 2, …: their number is known.
    let counted: Vec<usize> = (1..=8).map(|order| trees(8).iter().filter(|tree| tree.order == order).count()).collect();
    assert_eq!(counted, [1, 1, 2, 3, 6, 10, 20, 36]);
    let mut sets = 0;
    macro_rules! check {
        ($scheme:ident: $($set:ident)*) => { $({
            let (worst, beyond) = violations::<$scheme<$set, _>, _>();
            assert!(worst < 4.0, "{}: {worst}", $set::NAME);
            assert!(beyond > 1e-8, "{}: {beyond:e}, so its order is higher", $set::NAME);
            let reversed = kicks::<$scheme<$set, _>, _>();
            for (ahead, back) in reversed.iter().zip(reversed.iter().rev()) {
                assert_eq!((ahead.b, ahead.e), (back.b, back.e), "{} is no palindrome", $set::NAME);
                assert!((ahead.c + back.c - 1.0).abs() < 1e-15, "{} is no palindrome", $set::NAME);
            }
            sets += 1;
        })* };
    }
    for_each_set!(check);
    assert_eq!(sets, 15);
}

/// One wrong digit in the 12th place is seen, in each kind of coefficient.
#[test]
fn a_wrong_digit_is_noticed() {
    for slip in 0..3 {
        let mut found = kicks::<ForceGradient<Omelyan4S4, _>, _>();
        let last = found.len() - 1;
        for k in [1, last - 1] {
            match slip {
                0 => found[k].b += 1e-12,
                1 => found[k].c += 1e-12 * if k == 1 { 1.0 } else { -1.0 },
                _ => found[k].e += 1e-12,
            }
        }
        let trees = trees(4);
        let worst = sums(&found, &trees).into_iter().map(|(sum, exact)| (sum - exact).abs()).fold(0.0, f64::max);
        assert!(worst > 1e-13, "{slip}: {worst:e}");
    }
}
