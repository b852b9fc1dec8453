//! Chains of free bodies, which are kicked in one pass: as the same bonds in a list, of every length around that of a register.

use dmech::extend::Watch;
use dmech::models::pairs::Spring;
use dmech::prelude::*;
use dmech::scene::{OnBonds, OnChain};

type Law = Spring;

const LAW: Law = Spring { k: 1.3, length: 0.9 };

fn bodies<const D: usize>(n: usize) -> Scene<D> {
    let number = |i: usize, k: usize| ((i * 7 + k * 5) % 11) as f64 / 11.0 - 0.4;
    (0..n).fold(Scene::new(), |scene, i| {
        let q = core::array::from_fn(|k| if k == 0 { i as f64 + 0.3 * number(i, 1) } else { number(i, k) });
        scene.body(0.6 + 0.1 * (i % 5) as f64, q, core::array::from_fn(|k| number(i, k + 3)))
    })
}

/// The largest distance of a coordinate from the same motion with its bonds in a list; and to the bit, that steps in a row,
/// steps one by one and a run are the same, and that the momentum stays.
fn compare<S, const D: usize>(scheme: S, n: usize) -> f64
where
    S: Scheme<<Scene<D, (), ((), OnChain<Law>)> as dmech::extend::Setup<()>>::System>
        + Scheme<<Scene<D, (), ((), OnBonds<Law>)> as dmech::extend::Setup<()>>::System>,
{
    let chain = || Simulation::scene(bodies::<D>(n).chain(LAW)).scheme(scheme).dt(0.01);
    let run = chain().run(60).unwrap();
    let (mut row, mut single) = (chain().stepper().unwrap(), chain().stepper().unwrap());
    row.advance(40).unwrap();
    row.step().unwrap();
    row.advance(19).unwrap();
    (0..60).for_each(|_| single.step().unwrap());
    assert_eq!(row.state(), *run.last(), "{} of {n} bodies", S::NAME);
    assert_eq!(single.state(), *run.last(), "{} of {n} bodies", S::NAME);
    let momentum = run.drift(Invariant::LinearMomentum).unwrap();
    assert!(momentum.max_abs() < 1e-13, "{} of {n} bodies: {:e}", S::NAME, momentum.max_abs());
    let work = run.drift(Invariant::WorkEnergy).unwrap();
    assert!(work.max_abs() < 1e-13, "{} of {n} bodies: {:e}", S::NAME, work.max_abs());
    // Steps in a row add up no work; whoever watches after them finds that of the steps watched.
    let mut watch = Watch::begin(&row);
    (0..20).for_each(|_| watch.step(&mut row).unwrap());
    watch.observe(&row, &row.state());
    let work = watch.drifts()[Invariant::WorkEnergy as usize].unwrap();
    assert!(work.max_abs() < 1e-13, "{} of {n} bodies: {:e}", S::NAME, work.max_abs());
    let list = Simulation::scene(bodies::<D>(n).bonds(LAW, (1..n).map(|b| (b - 1, b)))).scheme(scheme).dt(0.01);
    let list = list.run(60).unwrap();
    let apart = |x: &Vec<[f64; D]>, y: &Vec<[f64; D]>| {
        x.as_flattened().iter().zip(y.as_flattened()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    };
    apart(&run.last().q, &list.last().q).max(apart(&run.last().v, &list.last().v))
}

#[test]
fn a_chain_is_a_list_of_bonds() {
    let mut moved = 0;
    for n in [1, 2, 3, 7, 8, 9, 10, 16, 17, 25, 66] {
        macro_rules! same {
            ($($scheme:expr),*) => { $({
                for apart in [compare::<_, 1>($scheme, n), compare::<_, 2>($scheme, n), compare::<_, 3>($scheme, n)] {
                    assert!(apart < 1e-12, "{n} bodies: {apart:e}");
                    moved += 1;
                }
            })* };
        }
        same!(
            Leapfrog,
            Explicit,
            CompensatedLeapfrog,
            Nystrom::order6(),
            ForceGradient::order4(),
            Composed::order4(Leapfrog)
        );
    }
    assert_eq!(moved, 11 * 6 * 3);
}
