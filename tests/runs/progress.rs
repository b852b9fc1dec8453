//! Runs that show how far they are: the same run, and a bar that follows it.

use dmech::models::pairs::Spring;
use dmech::prelude::*;
use dmech::scene::Term;
use indicatif::{ProgressBar, ProgressDrawTarget};

fn hidden() -> ProgressBar {
    ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden())
}

fn pair() -> Simulation<(), Scene<2, (), impl Term<2, ()>>> {
    let scene = Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.3]).body(2.0, [1.2, 0.0], [0.1, 0.0]);
    Simulation::scene(scene.chain(Spring { k: 3.0, length: 1.0 }))
}

#[test]
fn a_bar_follows_a_run_and_does_not_change_it() {
    let bar = hidden();
    let shown = pair().with_progress_bar(bar.clone()).scheme(DiscreteGradient).dt(0.01).run(12_345).unwrap();
    assert_eq!((bar.length(), bar.position(), bar.is_finished()), (Some(12_345), 12_345, true));
    let quiet = pair().scheme(DiscreteGradient).dt(0.01).run(12_345).unwrap();
    assert_eq!(shown.states(), quiet.states());
    assert_eq!(shown.steps(), quiet.steps());
}

#[test]
fn single_laws_have_bars_too() {
    let bar = hidden();
    let orbit = dmech::models::Kepler { gm: 1.0 };
    let planet = State::new([0.5, 0.0], [0.0, 1.63]);
    let simulation = Simulation::new(orbit, planet).scheme(Leapfrog).dt(0.001).record_every(1000);
    let run = simulation.clone().with_progress_bar(bar.clone()).run_until(20.0).unwrap();
    assert_eq!((bar.length(), bar.position(), bar.is_finished()), (Some(20_000), 20_000, true));
    assert_eq!(run.last(), simulation.with_progress("a planet").run_until(20.0).unwrap().last());
}

/// The bar stands where the run ended, finished so that a terminal is left in order.
#[test]
fn a_run_that_fails_leaves_the_bar_where_it_was() {
    let bar = hidden();
    let wild = Simulation::new(dmech::models::Quartic { beta: 4.0 }, State::new([3.0], [0.0]));
    let failed = wild.scheme(Explicit).dt(1.0).with_progress_bar(bar.clone()).run(1000).unwrap_err();
    let done = failed.run().steps();
    assert!(done > 0 && done < 1000);
    assert_eq!((bar.length(), bar.position(), bar.is_finished()), (Some(1000), done, true));
}
