//! What a run says that it must keep.

use dmech::Kept;
use dmech::models::{DampedPendulum, DrivenPendulum, Kepler};
use dmech::prelude::*;

/// What there is not is not kept, however well the scheme keeps it of other laws: alone, in a scene, before the first step.
#[test]
fn nothing_is_claimed_of_what_there_is_not() -> Result<(), Box<dyn std::error::Error>> {
    fn consistent<X>(run: &Run<X>, energy: Kept) {
        assert_eq!(run.kept(Invariant::Energy), energy, "{run}");
        for invariant in Invariant::ALL {
            assert!(run.drift(invariant).is_some() || run.kept(invariant) == Kept::No, "{invariant}: {run}");
            assert_eq!(run.report().kept(invariant), run.kept(invariant));
        }
    }
    let drag = DampedPendulum { k: 1.7, alpha: 0.2 };
    let driven = DrivenPendulum { k: 1.7, alpha: 0.1, amplitude: 0.2, omega: 2.1 };
    let start = State::new([0.4], [0.3]);
    consistent(&Simulation::new(drag, start).scheme(DiscreteGradient).dt(0.1).run(10)?, Kept::No);
    consistent(&Simulation::new(driven, start).scheme(DiscreteGradient).dt(0.1).run(10)?, Kept::No);
    let planet = Simulation::new(Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63])).scheme(DiscreteGradient);
    consistent(&planet.clone().dt(0.01).run(10)?, Kept::Exact);
    consistent(&planet.clone().adaptive(1e-3).run(10)?, Kept::Exact);
    consistent(planet.dt(0.0).run(10).unwrap_err().run(), Kept::No);
    let scene = || Scene::<1>::new().body(1.3, [0.4], [0.3]);
    consistent(&Simulation::scene(scene().field(drag)).scheme(DiscreteGradient).dt(0.1).run(10)?, Kept::No);
    Ok(())
}
