//! Steps do not allocate.

use crate::common::{Kepler, SUN, SUN_BY_COMPONENTS, from_apocentre};
use dmech_core::prelude::*;
use dmech_tests::memory::allocations;

/// Also where the step has to be approached gradually: the pericentre of e = 0.9 is passed in few steps. (The trapezoid
/// has no solution there for steps that long.)
#[test]
fn a_step_allocates_nothing() {
    fn check<const ONE: bool, S: Scheme<Particle<Kepler<ONE>, 2>>>(law: Kepler<ONE>, scheme: S, dt: f64) {
        let mut stepper = Simulation::new(law, from_apocentre(0.9)).scheme(scheme).dt(dt).stepper().unwrap();
        let counted = allocations(|| {
            for _ in 0..2000 {
                stepper.step().unwrap();
                std::hint::black_box(stepper.state());
            }
        });
        assert_eq!(counted, 0, "{}", S::NAME);
    }
    check(SUN, Explicit, 0.03);
    check(SUN, Leapfrog, 0.03);
    check(SUN, Implicit, 0.012);
    check(SUN, DiscreteGradient, 0.03);
    check(SUN, Kanatani, 0.03);
    check(SUN_BY_COMPONENTS, Implicit, 0.012);
    check(SUN_BY_COMPONENTS, DiscreteGradient, 0.03);
    check(SUN_BY_COMPONENTS, Kanatani, 0.03);
}

/// A run allocates for what it records, not for its steps.
#[test]
fn a_run_allocates_for_its_records_only() {
    let run = |steps| {
        allocations(|| {
            let run =
                Simulation::new(SUN, from_apocentre(0.3)).scheme(Kanatani).dt(0.01).record_every(steps).run(steps);
            drop(std::hint::black_box(run.unwrap()));
        })
    };
    assert_eq!(run(10), run(10_000));
}
