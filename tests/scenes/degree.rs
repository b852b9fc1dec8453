//! Of which degree the potential of a scene is: the largest of its terms, and none where one of them is no polynomial.

use dmech::extend::System;
use dmech::models::pairs::{FermiPastaUlamTsingou, Gravity, Spring};
use dmech::models::{HenonHeiles, Quartic};
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};
use dmech_tests::few::Damper;

const CHAIN: FermiPastaUlamTsingou = FermiPastaUlamTsingou { k: 1.3, alpha: 0.0, beta: 0.4 };
const SPRING: Spring = Spring { k: 7.0, length: 0.8 };
const BOWL: HenonHeiles = HenonHeiles { lambda: 0.8 };

/// Springs without a length.
#[derive(Clone, Copy, Debug)]
struct Elastic {
    k: f64,
}

#[dmech::law]
impl Elastic {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        0.5 * self.k * r * r
    }
}

const ELASTIC: Elastic = Elastic { k: 1.3 };

fn degree<const D: usize, P, L: Term<D, P, B>, B>(_: &Scene<D, P, L, B>) -> Option<u32> {
    <SceneSystem<D, L::Ready> as System>::DEGREE
}

fn line() -> Scene<1> {
    (0..5).fold(Scene::new(), |scene, i| scene.body(1.3, [f64::from(i)], [0.0]))
}

fn plane() -> Scene<2> {
    (0..5).fold(Scene::new(), |scene, i| scene.body(1.3, [f64::from(i), 0.2], [0.0, 0.1]))
}

#[test]
fn the_largest_of_all_terms() {
    assert_eq!(degree(&line()), Some(0), "nothing acts");
    assert_eq!(degree(&line().chain(CHAIN)), Some(4));
    assert_eq!(degree(&line().pin(0).pin(4).chain(CHAIN)), Some(4));
    assert_eq!(degree(&line().chain(Some(CHAIN))), Some(4));
    assert_eq!(degree(&line().chain(ELASTIC)), Some(2));
    assert_eq!(degree(&line().chain(ELASTIC).chain(CHAIN)), Some(4));
    assert_eq!(degree(&line().chain(CHAIN).chain(ELASTIC)), Some(4));
    assert_eq!(degree(&line().bonds(CHAIN, [(0, 3)]).field(Quartic { beta: 0.3 })), Some(4));
    assert_eq!(degree(&plane().pairs(ELASTIC)), Some(2));
    assert_eq!(degree(&plane().pairs(ELASTIC).field(BOWL)), Some(3));
    assert_eq!(degree(&plane().field(BOWL).pairs(ELASTIC)), Some(3));
    assert_eq!(degree(&plane().drive(0, |t| ([t, 0.0], [1.0, 0.0])).pairs(ELASTIC)), Some(2), "of the others");
    assert_eq!(degree(&plane().test_body(0.1, [0.4, 3.0], [0.0; 2]).pairs(ELASTIC)), Some(2));
}

#[test]
fn none_where_a_term_has_none() {
    assert_eq!(degree(&line().chain(SPRING)), None);
    assert_eq!(degree(&plane().bonds(SPRING, [(0, 3)])), None);
    assert_eq!(degree(&plane().field(BOWL).pairs(Gravity { g: 1.3 })), None);
    assert_eq!(degree(&plane().pairs(Gravity { g: 1.3 }).field(BOWL)), None);
    // What acts across a border or a cut-off jumps there.
    assert_eq!(degree(&plane().pairs(ELASTIC).cutoff(1.5)), None);
    assert_eq!(degree(&plane().pairs(ELASTIC).periodic([9.0; 2])), None);
    assert_eq!(degree(&plane().field(BOWL).periodic([9.0; 2])), Some(3), "of a place, not of a difference");
    // Beside a force nothing follows from the potential alone.
    assert_eq!(degree(&plane().pairs(ELASTIC).chain(Damper { c: 0.4 })), None);
    assert_eq!(degree(&plane().chain(Damper { c: 0.4 })), None);
}
