//! Vectors turned by the Hessian, without a matrix and with one.

use core::array::from_fn;

use super::laws::{Attraction, Gravity, Pull, Wind};
use crate::scene::builder::Scene;
use crate::scene::matrix::Matrix;
use crate::scene::terms::{Acts, Term};
use crate::scene::topology::Topology;
use crate::scene::vectors::Vectors;

/// Bodies with masses of their own, off a lattice that begins at `corner`.
fn bodies<const D: usize>(n: usize, corner: f64) -> Scene<D> {
    (0..n).fold(Scene::new(), |scene, i| {
        let place = |k: usize| match D {
            1 => i as f64,
            _ => 1.3 * ((i / 9_usize.pow(k as u32)) % 9) as f64,
        };
        let q = from_fn(|k| corner + place(k) + 0.3 * ((1.7 + k as f64) * i as f64).sin());
        scene.body(0.5 + 0.13 * i as f64 % 2.0, q, [0.0; D])
    })
}

/// The term on the bodies of a scene turns vectors as its matrix does, and as differences of its forces tell.
fn turns<const D: usize, L: Term<D, ()>>(what: &str, scene: Scene<D, (), L>) {
    let n = scene.bodies();
    let acts = scene.laws.prepare(&scene.bodies, scene.space).unwrap();
    let q = Vectors::from_list(&scene.bodies.q);
    let list: Vec<[f64; D]> = (0..n).map(|i| from_fn(|k| (0.9 * i as f64 + 2.0 * k as f64).cos())).collect();
    let (w, at_rest) = (Vectors::from_list(&list), Vectors::zeros(n));
    let (c, t) = (-0.7, 0.4);
    let mut turned = Vectors::zeros(n);
    turned.flat_mut().fill(0.25);
    acts.add_turned(c, &q, &w, t, &mut turned);

    let mut matrix = Matrix::new(n, &Topology::Dense);
    acts.add_hessian(c, &q, t, &mut matrix);
    acts.subtract_force_jacobian(c, &q, &at_rest, t, 0.0, &mut matrix);
    let mut product = Vectors::zeros(n);
    product.flat_mut().fill(0.25);
    matrix.multiply_add(&w, &mut product);

    let slope = |step: f64| {
        let mut there = q.clone();
        there.flat_mut().iter_mut().zip(w.flat()).for_each(|(q, w)| *q += step * w);
        let mut slope = Vectors::zeros(n);
        acts.set_gradient(&there, t, &mut slope);
        acts.subtract_force(1.0, &there, &at_rest, t, &mut slope);
        slope
    };
    let step = 1e-5;
    let (before, after) = (slope(-step), slope(step));
    let scale = product.largest();
    assert!(scale > 0.3, "{what}: nothing turns");
    for i in 0..D * n {
        let (x, y) = (turned.flat()[i], product.flat()[i]);
        assert!((x - y).abs() < 1e-13 * scale, "{what}, {D} dimensions: {x} for {y}");
        let difference = 0.25 + c * (after.flat()[i] - before.flat()[i]) / (2.0 * step);
        assert!((x - difference).abs() < 1e-7 * scale, "{what}, {D} dimensions: {x}, by differences {difference}");
    }
}

fn in_dimensions<const D: usize>() {
    let (gravity, attraction, wind) = (Gravity { g: 1.7 }, Attraction(1.9), Wind { c: 0.8 });
    let one_way = Pull::<false> { k: 0.3, gamma: 0.0, beta: 0.0 };
    let both_ways = Pull::<true> { k: 0.2, gamma: 0.0, beta: 0.0 };
    let list = [(0, 20), (20, 3), (7, 4), (11, 12), (3, 11)];
    let bodies = |n| bodies::<D>(n, 0.7);
    turns("pairs", bodies(21).pairs(gravity));
    turns("chain", bodies(21).chain(gravity));
    turns("bonds", bodies(21).bonds(gravity, list));
    turns("forces one way", bodies(21).pairs(one_way));
    turns("forces both ways", bodies(21).chain(both_ways));
    turns("fields", bodies(21).field(attraction));
    turns("forced fields", bodies(21).field(wind));
    turns("all", bodies(21).field(attraction).chain(gravity).bonds(both_ways, list).field(wind).pairs(one_way));
}

#[test]
fn vectors_are_turned_as_by_the_matrix() {
    in_dimensions::<1>();
    in_dimensions::<2>();
    in_dimensions::<3>();
    // Pairs in chunks.
    turns("many pairs", bodies::<3>(520, 0.0).pairs(Gravity { g: 1.7 }));
}

/// Nothing turns nothing.
#[test]
fn nothing_turns_nothing() {
    let (q, mut out) = (Vectors::<2>::from_list(&[[1.0, 2.0]]), Vectors::zeros(1));
    ().add_turned(3.0, &q, &q.clone(), 0.0, &mut out);
    assert_eq!(out, Vectors::zeros(1));
}
