//! Pair loops give the same bits on any number of threads, and as a plain loop to round-off.

use crate::gravity::Gravity;
use dmech_core::prelude::*;

/// Bodies of different masses off the points of a lattice.
fn cloud(n: usize) -> Scene<3> {
    let mut seed = 7_u64;
    let mut uniform = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let side = (n as f64).cbrt().ceil() as usize;
    (0..n).fold(Scene::new(), |scene, i| {
        let cell = [i % side, i / side % side, i / (side * side)];
        let q = cell.map(|k| k as f64 + 0.5 * uniform());
        scene.body(0.5 + uniform(), q, [0.1 * uniform(), -0.2 * uniform(), 0.0])
    })
}

#[test]
fn the_same_bits_on_any_number_of_threads() {
    let n = 700;
    let end = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let simulation = Simulation::scene(cloud(n).pairs(Gravity { g: 0.8 })).dt(0.01).record_every(20);
            simulation.scheme(Leapfrog).run(20).unwrap().last().clone()
        })
    };
    let alone = end(1);
    assert!(alone.q != end_without_forces(n), "the bodies must feel each other");
    for threads in [2, 3, 5] {
        assert_eq!(end(threads), alone, "{threads} threads");
    }
}

fn end_without_forces(n: usize) -> Vec<[f64; 3]> {
    let simulation = Simulation::scene(cloud(n)).dt(0.01).record_every(20);
    simulation.scheme(Leapfrog).run(20).unwrap().last().q.clone()
}

/// Chunks and lanes are only another order of the same sum: momentum is kept, and the acceleration of a body is that of a
/// plain sum over the others.
#[test]
fn chunks_add_up_to_the_plain_sum() {
    let (n, g, h) = (531, 0.8, 1e-3);
    let run = Simulation::scene(cloud(n).pairs(Gravity { g })).scheme(Explicit).dt(h).run(1).unwrap();
    let [start, end] = [&run.states()[0], run.last()];
    let masses = cloud(n).masses().to_vec();
    for i in [0, 1, 255, 256, 520, 530] {
        let mut a = [0.0; 3];
        for j in (0..n).filter(|&j| j != i) {
            let d: [f64; 3] = core::array::from_fn(|k| start.q[j][k] - start.q[i][k]);
            let s = d.iter().map(|x| x * x).sum::<f64>();
            (0..3).for_each(|k| a[k] += g * masses[j] * d[k] / (s * s.sqrt()));
        }
        let scale = a.iter().fold(0.0_f64, |max, x| max.max(x.abs()));
        for k in 0..3 {
            let found = (end.v[i][k] - start.v[i][k]) / h;
            assert!((found - a[k]).abs() < 1e-11 * scale.max(1.0), "body {i}: {found} {}", a[k]);
        }
    }
    assert!(run.drift(Invariant::LinearMomentum).unwrap().max_abs() < 1e-12);
}
