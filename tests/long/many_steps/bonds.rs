//! Scenes with listed bonds on sparse Newton matrices: a ring, a tree and a sheet of springs.

use dmech::models::pairs::Spring;
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

/// Friction between two bodies, along no direction in particular.
#[derive(Clone, Copy, Debug)]
struct Friction {
    c: f64,
}

#[dmech::law]
impl Friction {
    #[pair_force]
    fn force(&self, va: [f64; 3], vb: [f64; 3]) -> [f64; 3] {
        [-self.c * (va[0] - vb[0]), -self.c * (va[1] - vb[1]), -self.c * (va[2] - vb[2])]
    }
}

/// Acts between any two bodies and does nothing: with it the Newton matrix is dense.
const NOTHING: Spring = Spring { k: 0.0, length: 0.5 };

/// A closed ring of n bodies, stretched and turning.
fn ring(n: usize) -> (Scene<2>, Vec<(usize, usize)>) {
    let mut scene = Scene::new();
    for i in 0..n {
        let (f, phi) = (i as f64, std::f64::consts::TAU * i as f64 / n as f64);
        let r = 1.3 * n as f64 / std::f64::consts::TAU * (1.0 + 0.01 * (3.0 * phi).cos());
        scene = scene.body(1.0 + 0.3 * f.sin(), [r * phi.cos(), r * phi.sin()], [-0.4 * phi.sin(), 0.3 * phi.cos()]);
    }
    (scene, (0..n).map(|i| (i, (i + 1) % n)).collect())
}

/// A binary tree in space with its root pinned; body i hangs on (i − 1)/2.
fn tree(n: usize) -> (Scene<3>, Vec<(usize, usize)>) {
    let mut scene = Scene::new();
    for i in 0..n {
        let (f, level) = (i as f64, ((i + 1) as f64).log2().floor());
        let across = (f + 1.5) / level.exp2() - 1.5;
        let v = if i == 0 { [0.0; 3] } else { [0.2 * f.sin(), 0.1 * f.cos(), 0.3 * (2.0 * f).sin()] };
        scene = scene.body(1.0 + 0.2 * f.cos(), [6.0 * across, -1.2 * level, (0.7 * f).sin()], v);
    }
    (scene.pin(0), (1..n).map(|i| (i, (i - 1) / 2)).collect())
}

/// A sheet of side × side bodies in space with two corners pinned, rows, columns and one diagonal of each square.
fn sheet(side: usize) -> (Scene<3>, Vec<(usize, usize)>) {
    let (mut scene, mut bonds) = (Scene::new(), Vec::new());
    for i in 0..side * side {
        let (x, y) = ((i % side) as f64, (i / side) as f64);
        let corner = i == 0 || i == side - 1;
        let v = if corner { [0.0; 3] } else { [0.0, 0.1 * (x - y).sin(), 0.5 * (0.4 * x).sin() * (0.3 * y).cos()] };
        scene = scene.body(1.0 + 0.4 * (x * y).sin(), [1.05 * x, -0.97 * y, 0.1 * (x + 2.0 * y).sin()], v);
        let (right, below) = ((i + 1) % side != 0, i + side < side * side);
        bonds.extend(right.then_some((i, i + 1)));
        bonds.extend(below.then_some((i + side, i)));
        bonds.extend((right && below).then_some((i, i + side + 1)));
    }
    (scene.pin(0).pin(side - 1), bonds)
}

/// The largest difference of positions and velocities after a time of 3, relative to the largest component: with steps in
/// which the power series of the Newton matrix is summed, and with longer ones that need factors.
fn difference<const D: usize, P, L, M, S>(sparse: Scene<D, P, L>, dense: Scene<D, P, M>, scheme: S) -> f64
where
    P: Clone,
    L: Term<D, P> + Clone,
    M: Term<D, P> + Clone,
    S: Scheme<SceneSystem<D, L::Ready>> + Scheme<SceneSystem<D, M::Ready>>,
{
    let short = difference_at(sparse.clone(), dense.clone(), scheme, 0.025);
    f64::max(short, difference_at(sparse, dense, scheme, 0.2))
}

fn difference_at<const D: usize, P, L, M, S>(sparse: Scene<D, P, L>, dense: Scene<D, P, M>, scheme: S, dt: f64) -> f64
where
    L: Term<D, P>,
    M: Term<D, P>,
    S: Scheme<SceneSystem<D, L::Ready>> + Scheme<SceneSystem<D, M::Ready>>,
{
    let mut sparse = Simulation::scene(sparse).scheme(scheme).dt(dt).stepper().unwrap();
    let mut dense = Simulation::scene(dense).scheme(scheme).dt(dt).stepper().unwrap();
    let start = sparse.state();
    for _ in 0..(3.0 / dt).round() as u64 {
        sparse.step().unwrap();
        dense.step().unwrap();
    }
    let (a, b) = (sparse.state(), dense.state());
    let largest = |x: &[[f64; D]], y: &[[f64; D]]| {
        x.iter().flatten().zip(y.iter().flatten()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    };
    let size = largest(&a.q, &vec![[0.0; D]; a.q.len()]);
    assert!(largest(&a.q, &start.q) > 0.1, "nothing moved");
    f64::max(largest(&a.q, &b.q), largest(&a.v, &b.v)) / size
}

const SPRING: Spring = Spring { k: 7.0, length: 1.1 };

#[test]
fn sparse_and_dense_matrices_lead_to_the_same_motion() {
    let (scene, bonds) = ring(150);
    let on = |scene: &Scene<2>| scene.clone().bonds(SPRING, bonds.clone());
    let off = difference(on(&scene), on(&scene).pairs(NOTHING), DiscreteGradient);
    assert!(off < 1e-13, "ring: {off:e}");

    let (scene, bonds) = tree(127);
    let on = |scene: &Scene<3>| scene.clone().bonds(SPRING, bonds.clone());
    let off = difference(on(&scene), on(&scene).pairs(NOTHING), Implicit);
    assert!(off < 1e-13, "tree: {off:e}");
    let rubbing = |scene: &Scene<3>| on(scene).bonds(Friction { c: 0.2 }, bonds.iter().rev().copied());
    let off = difference(rubbing(&scene), rubbing(&scene).pairs(NOTHING), DiscreteGradient);
    assert!(off < 1e-13, "tree with friction: {off:e}");

    let (scene, bonds) = sheet(11);
    let on = |scene: &Scene<3>| scene.clone().bonds(SPRING, bonds.clone());
    let off = difference(on(&scene), on(&scene).pairs(NOTHING), Kanatani);
    assert!(off < 1e-13, "sheet: {off:e}");
    // Neighbours in the order of bodies as well: the last of a row and the first of the next.
    let chained = |scene: &Scene<3>| on(scene).chain(Spring { k: 0.3, length: 0.8 });
    let off = difference(chained(&scene), chained(&scene).pairs(NOTHING), DiscreteGradient);
    assert!(off < 1e-13, "sheet with a chain: {off:e}");
}

#[test]
fn energy_and_momenta_are_kept_on_sparse_matrices() {
    let drift = |run: Run<SceneState<3>>| run.drift(Invariant::Energy).unwrap().max_relative();
    let (scene, bonds) = tree(127);
    let run = Simulation::scene(scene.bonds(SPRING, bonds)).scheme(DiscreteGradient).dt(0.2).run(1000).unwrap();
    let energy = drift(run);
    assert!(energy < 1e-12, "tree: {energy:e}");

    let (scene, bonds) = sheet(10);
    let run = Simulation::scene(scene.bonds(SPRING, bonds)).scheme(DiscreteGradient).dt(0.2).run(1000).unwrap();
    let energy = drift(run);
    assert!(energy < 1e-12, "sheet: {energy:e}");

    let (scene, bonds) = ring(200);
    let run = Simulation::scene(scene.bonds(SPRING, bonds)).scheme(DiscreteGradient).dt(0.2).run(1000).unwrap();
    for invariant in [Invariant::Energy, Invariant::AngularMomentum] {
        let drift = run.drift(invariant).unwrap().max_relative();
        assert!(drift < 1e-12, "ring, {invariant:?}: {drift:e}");
    }
    // The momentum at the start is near zero, so its drift is measured on the sum of all |m v|.
    let drift = run.drift(Invariant::LinearMomentum).unwrap().max_abs();
    assert!(drift < 1e-12 * 0.35 * 200.0, "ring, linear momentum: {drift:e}");
}
