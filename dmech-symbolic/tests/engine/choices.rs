//! Random laws with choices, vanishing roots and huge sides, at generic and special points: every promise of `dmech_laws`.
//! Millions of them are tried by the fuzz target.

use std::sync::LazyLock;

use dmech_laws::{Engine, FUNCTIONS, Law, Place, Random, Tally, Tree, campaign, is_continuous, pairs, try_pair};

const LAWS: u64 = 3000;

static TALLY: LazyLock<Tally> = LazyLock::new(|| campaign(2026, 0, LAWS, 2));

#[test]
fn what_is_promised_of_a_law_holds() {
    let tally = &*TALLY;
    tally.findings.iter().for_each(|finding| println!("{finding}\n"));
    println!("{tally:#?}");
    assert!(tally.broken.is_empty(), "{:?} of {LAWS} laws, see above", tally.broken);
}

/// There was something to try: every kind of node and of point, on both sides of seams and across them.
#[test]
fn every_kind_of_law_and_point_is_tried() {
    let tally = &*TALLY;
    let often = |kind: &str| tally.kinds.get(kind).copied().unwrap_or(0);
    for f in FUNCTIONS {
        assert!(often(f.method()) >= LAWS / 50, "{f:?}: {} laws", often(f.method()));
    }
    for kind in ["if", "if not", "if and", "if or", "min", "max", "clamp", "powf", "powi", "/"] {
        assert!(often(kind) >= LAWS / 20, "{kind}: {} laws", often(kind));
    }
    assert!(often("hypot") >= LAWS / 60 && often("atan2") >= LAWS / 60);
    assert!(tally.crossed > LAWS / 2, "{} laws were crossed", tally.crossed);
    assert!(tally.absent > LAWS / 5, "{} laws with an absent coordinate", tally.absent);
    for place in Place::ALL {
        let [all, unbounded, crossing] = tally.places[&place];
        assert!(
            all > LAWS / 4 && 8 * unbounded < all,
            "{place:?}: {all} pairs, {unbounded} where the law is not finite"
        );
        let steps = !matches!(place, Place::Same | Place::SameOnSeam);
        let wide = steps && place != Place::Near;
        assert!(!wide || 8 * crossing > all, "{place:?}: {crossing} of {all} pairs cross a seam");
    }
}

/// What is tried is a law: it does not jump.
#[test]
fn random_laws_are_continuous() {
    for k in 0..LAWS {
        let law = Law::random(&mut Random::member(2026, k));
        assert!(is_continuous(&law), "law {k}: {}", law.tree);
    }
}

/// A law that is not the engine's own is found out: each of these differs by one choice only.
#[test]
fn another_law_is_found_out() {
    let x = || Tree::Coordinate(0).into();
    let zero = || Tree::Number(0.0).into();
    use dmech_symbolic::expression::{Binary, Unary};
    let trees: [Tree; 5] = [
        Tree::Coordinate(0),
        Tree::Unary(Unary::Abs, x()),
        Tree::Binary(Binary::Max, x(), zero()),
        Tree::Binary(Binary::Min, x(), zero()),
        Tree::Clamp(x(), -1.0, 1.0),
    ];
    let laws = trees.map(|tree| Law { tree, dimension: 1 });
    for (i, one) in laws.iter().enumerate() {
        for (j, other) in laws.iter().enumerate() {
            let engine = Engine::new(other, false);
            let mut random = Random::new(7);
            let failures = (0..5).flat_map(|_| pairs(one, &mut random));
            let failures = failures.filter(|(_, a, b)| try_pair(one, &engine, a, b, false).failure.is_some()).count();
            assert_eq!(failures == 0, i == j, "{} as {}", one.tree, other.tree);
        }
    }
}
