//! `verify` on laws with choices: potentials that jump, starts on a seam.

use dmech::Conservative;
use dmech::prelude::*;
use dmech_study::verify::Outcome;

use dmech_tests::laws::*;

use super::verify::with;

/// Laws with choices: some of them jump, in each of the ways in which a formula does.
mod jumps {
    macro_rules! laws {
        ($($name:ident |$q:ident: $d:literal| $energy:expr;)*) => {$(
            #[derive(Clone, Copy, Debug)]
            pub(super) struct $name;

            #[dmech::law]
            impl $name {
                #[potential]
                fn energy(&self, $q: [f64; $d]) -> f64 {
                    $energy
                }
            }
        )*};
    }

    laws! {
        Step |q: 1| 0.5 * q[0] * q[0] + if q[0] > 0.61 { 1.0 } else { 0.0 };
        Low |q: 1| 20.0 * q[0].powi(4) + if q[0] > 0.43 { 1e-7 } else { 0.0 };
        Disc |q: 2| { let s = q[0] * q[0] + q[1] * q[1]; s + if s < 0.5 { 0.3 } else { 0.0 } };
        Rounded |q: 2| 0.5 * (q[0] - 0.4 * (q[0] / 0.4).round()) + 0.3 * q[1] * q[1];
        Bound |q: 1| (q[0] * q[0]).max(if q[0] > 0.37 { 0.2 } else { 0.0 });

        Kink |q: 2| (q[0] - 0.3).abs() + q[1].max(0.0) + 0.2 * (q[0] * q[0] + q[1] * q[1]);
        Wall |q: 1| 0.5 * q[0] * q[0] + if q[0] > 0.4 { 1e8 * (q[0] - 0.4) * (q[0] - 0.4) } else { 0.0 };
        Images |q: 2| 0.5 * (q[0] - 0.4 * (q[0] / 0.4).round()).powi(2) + 0.3 * q[1] * q[1];
        Steep |q: 1| 0.5 * q[0] * q[0] + if q[0] > 0.2 { (1e9 * (q[0] - 0.2)).tanh() } else { 0.0 };
        Off |q: 2| 0.5 * (q[0] * q[0] + q[1] * q[1]) + if q[0] > 0.5 { 0.1 } else { 0.0 };
        Root |q: 1| if q[0] > 0.1 { (q[0] - 0.1).sqrt() } else { 0.1 - q[0] };
        Pole |q: 1| q[0] * q[0] + if q[0] > -0.7 { 1e-3 / (q[0] + 0.5).abs() } else { 5e-3 };
        Stop |q: 1| 0.5 * q[0] * q[0] + (q[0] - 0.4).max(0.0);
        Far |q: 1| 1e9 + 0.5 * (q[0] - 0.2).max(0.0).powi(2);
    }
}

#[test]
fn a_potential_that_jumps_is_caught() {
    fn continuity<L: Law<D>, const D: usize>(law: L) -> (Outcome, String) {
        let report = verify(law, State::new([0.5; D], [0.3; D]));
        let check = report.checks().iter().find(|check| check.name() == "continuity").unwrap();
        (check.outcome(), check.note().to_owned())
    }
    macro_rules! all {
        ($outcome:ident, $($law:ident),*) => {
            [$((stringify!($law), continuity(jumps::$law), Outcome::$outcome)),*]
        };
    }
    let caught = all!(Failed, Step, Low, Disc, Rounded, Bound);
    let sound = all!(Passed, Kink, Wall, Images, Steep, Root, Pole, Far);
    for (law, (outcome, note), expected) in caught.into_iter().chain(sound) {
        assert_eq!(outcome, expected, "{law}: {note}");
        assert_eq!(note.contains("jumps by"), expected == Outcome::Failed, "{law}: {note}");
    }
    assert_eq!(continuity(jumps::Step).1, "the potential jumps by 1.000e0 at q = [0.61000]: no scheme can step that");
    // Further than the coordinates of the start, where the motion leads.
    let off = verify(jumps::Off, State::new([0.0, 0.2], [1.5, 0.0]));
    assert!(with(&off, Outcome::Failed).contains(&"continuity"), "{off}");
    // What has no choices does not jump, and nothing is said.
    assert!(
        verify(Kepler { gm: 1.3 }, State::new([0.9, 0.2], [-0.1, 1.1]))
            .checks()
            .iter()
            .all(|check| check.name() != "continuity")
    );
}

/// k max(−q, 0)²/2 + g q by hand, right or with a Hessian that is wrong below the floor.
struct SoftFloor {
    wrong: f64,
}

impl Conservative for SoftFloor {}
impl Potential<1> for SoftFloor {
    const PIECEWISE: bool = true;

    fn potential(&self, [x]: [f64; 1]) -> f64 {
        x + 50.0 * x.min(0.0) * x.min(0.0)
    }
    fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] {
        [1.0 + 100.0 * x.min(0.0)]
    }
    fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] {
        [[if x < 0.0 { 100.0 * self.wrong } else { 0.0 }]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        match (a < 0.0, b < 0.0) {
            (true, true) => [1.0 + 50.0 * (a + b)],
            (false, false) => [1.0],
            _ => [(self.potential([b]) - self.potential([a])) / (b - a)],
        }
    }
    fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
        match (a < 0.0, b < 0.0) {
            (true, true) => [[50.0]],
            (false, false) => [[0.0]],
            _ => [[(self.gradient([b])[0] - self.discrete_gradient([a], [b])[0]) / (b - a)]],
        }
    }
}

/// On a seam central differences have the mean of both sides; beside it they tell right from wrong.
#[test]
fn a_start_on_a_seam_is_compared_beside_it() {
    for v in [0.0, -1.0] {
        let report = verify(SoftFloor { wrong: 1.0 }, State::new([0.0], [v]));
        assert!(!with(&report, Outcome::Failed).contains(&"Hessian"), "{report}");
        assert!(with(&report, Outcome::Passed).contains(&"Hessian"), "{report}");
        let report = verify(SoftFloor { wrong: 1.001 }, State::new([0.0], [v]));
        assert!(with(&report, Outcome::Failed).contains(&"Hessian"), "{report}");
    }
    verify(Floor::new(), State::new([0.0], [-1.0])).with_half_step_schemes().assert();
}

/// A power of the step that is too low is told with what a seam may have to do with it, of laws with choices alone.
#[test]
fn seams_are_named_where_they_lower_the_order() {
    let report = verify(jumps::Stop, State::new([0.3], [0.5])).with_half_step_schemes();
    let powers: Vec<_> = report.checks().iter().filter(|check| check.outcome() == Outcome::Failed).collect();
    assert!(powers.iter().any(|check| check.name() == "Leapfrog: order"), "{report}");
    assert!(powers.iter().all(|check| check.note().ends_with("a seam on the way lowers the power")), "{report}");
    let smooth = verify(Kepler { gm: 1.3 }, State::new([0.9, 0.2], [-0.1, 1.1])).to_string();
    assert!(!smooth.contains("seam"), "{smooth}");
}
