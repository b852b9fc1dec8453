//! Runs that are written and read.

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::prelude::*;

/// q²/2, by hand.
#[derive(Clone, Copy, Debug)]
struct Bowl;

impl Conservative for Bowl {}

impl Potential<1> for Bowl {
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        0.5 * x * x
    }
    fn gradient(&self, q: [f64; 1]) -> [f64; 1] {
        q
    }
    fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        [0.5 * (a + b)]
    }
    fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] {
        [[0.5]]
    }
}

/// The same run, every number to the bit, in a format of text with its own numbers and in one of bits.
fn comes_back<X: core::fmt::Debug + Serialize + DeserializeOwned + Clone>(run: &Run<X>) {
    // The history is not written.
    let run = &Run { histories: None, ..run.clone() };
    let value = serde_json::to_value(run).unwrap();
    let read: Run<X> = serde_json::from_value(value).unwrap();
    assert_eq!(format!("{read:?}"), format!("{run:?}"));
    assert_eq!(read.to_string(), run.to_string());
    #[cfg(feature = "ranks")]
    {
        let read: Run<X> = postcard::from_bytes(&postcard::to_allocvec(run).unwrap()).unwrap();
        assert_eq!(format!("{read:?}"), format!("{run:?}"));
    }
}

#[test]
fn a_run_is_read_as_it_was_written() {
    let motion = Simulation::new(Bowl, State::new([0.3], [-0.1])).scheme(DiscreteGradient).dt(0.1).record_every(7);
    let run = motion.watch("sum", |state| state.q[0] + state.v[0]).event(|state| state.q[0], Crossing::Any).run(100);
    let run = run.unwrap();
    assert!(run.events().len() > 2 && run.drift_of("sum").is_some());
    comes_back(&run);
}

/// Without a longest step, and without any: what was not said is missing in the file, and no number that it cannot hold.
#[test]
fn a_run_without_a_step_of_its_own_is_read_as_it_was_written() {
    let follows = Simulation::new(Bowl, State::new([0.3], [-0.1])).scheme(DiscreteGradient).adaptive(1e-3);
    for run in [follows.clone().run_until(3.0), follows.dt(0.2).run_until(3.0)] {
        comes_back(&run.unwrap());
    }
    let refused = Simulation::new(Bowl, State::new([0.3], [-0.1])).scheme(DiscreteGradient).run(3).unwrap_err();
    comes_back(refused.run());
}

#[cfg(feature = "scene")]
#[test]
fn a_run_of_a_scene_is_read_as_it_was_written() {
    let scene = Scene::new().body(1.0, [0.1], [0.3]).body(3.0, [-0.7], [-0.0]).field(Bowl);
    comes_back(&Simulation::scene(scene).scheme(Leapfrog).dt(0.01).record_every(9).run(40).unwrap());
}

/// Not a number stays what it is where the format has it; in JSON it is `null`, which is refused as a number.
#[test]
fn what_is_not_a_number_is_kept_or_refused() {
    let lost = State::new([f64::NAN, f64::INFINITY], [0.0, f64::NEG_INFINITY]);
    assert!(serde_json::from_str::<State<2>>(&serde_json::to_string(&lost).unwrap()).is_err());
    #[cfg(feature = "ranks")]
    {
        let read: State<2> = postcard::from_bytes(&postcard::to_allocvec(&lost).unwrap()).unwrap();
        assert_eq!(read.q.map(f64::to_bits), lost.q.map(f64::to_bits));
        assert_eq!(read.v.map(f64::to_bits), lost.v.map(f64::to_bits));
    }
}
