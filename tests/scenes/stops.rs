//! Scenes that are stopped at an event and go on from there; scenes that wait for laws to have values.

use dmech::models::pairs::{Gravity, Spring};
use dmech::prelude::*;

/// How far apart the first two bodies are.
fn apart(state: &SceneState<2>) -> f64 {
    (state.q[0][0] - state.q[1][0]).hypot(state.q[0][1] - state.q[1][1])
}

/// Three on springs, of which two come near each other again and again.
fn three() -> Scene<2> {
    Scene::new().body(1.3, [0.0, 0.0], [0.1, 0.7]).body(0.8, [1.4, 0.1], [0.0, -0.6]).body(0.6, [0.3, 1.7], [-0.3, 0.0])
}

/// Where a hand is that moves to and fro.
fn hand(t: f64) -> ([f64; 2], [f64; 2]) {
    ([0.2 * (1.9 * t).sin(), 0.1], [0.38 * (1.9 * t).cos(), 0.0])
}

/// A contact: nothing beyond a distance.
#[derive(Clone, Copy, Debug)]
struct Touch {
    k: f64,
    reach: f64,
}

#[dmech::law]
impl Touch {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        self.k * (self.reach - r).max(0.0).powi(6)
    }
}

const SPRING: Spring = Spring { k: 1.7, length: 0.9 };

/// Whatever stops it, a scene passes as often as in one run, and never twice where it was stopped.
#[test]
fn a_scene_goes_on_from_a_stop() {
    let (mut seen, end) = (0, 4.5);
    macro_rules! legs {
        ($scene:expr, $level:expr, $crossing:expr, $($scheme:expr => $step:ident $h:expr);* $(;)?) => {$({
            let event = |state: &SceneState<2>| apart(state) - $level;
            // The longest step, which a driven body asks for.
            let whole = Simulation::scene($scene).dt(1.0).scheme($scheme)
.$step($h).event(event, $crossing).run_until(end).unwrap();
            let (mut last, mut stops) = (Simulation::scene($scene).start(), Vec::new());
            while last.t < end {
                let on = Simulation::scene($scene).starting_from(&last).dt(1.0).scheme($scheme)
.$step($h);
                let run = on.stop_when(event, $crossing).run_until(end).unwrap();
                last = run.last().clone();
                assert!(stops.len() < 100, "{} stands at {last:?}", stringify!($scheme));
                stops.extend((run.stopped() && last.t <= end).then_some(last.t));
            }
            let times: Vec<f64> = whole.events().iter().map(|event| event.state().t).collect();
            assert_eq!(stops.len(), times.len(), "{} {}: {stops:?} {times:?}", stringify!($scheme), stringify!($scene));
            assert!(stops.windows(2).all(|two| two[1] > two[0] + 1e-3), "{stops:?}");
            seen += stops.len();
        })*};
    }
    macro_rules! every {
        ($($scene:expr),*) => {$(
            for level in [0.9, 1.1, 0.6] {
                for crossing in [Crossing::Any, Crossing::Falling] {
                    legs! { $scene, level, crossing,
                        Leapfrog => dt 0.004;
                        Nystrom::order6() => dt 0.02;
                        DiscreteGradient => dt 0.005;
                        Implicit => dt 0.005;
                        Gauss::order16() => dt 0.02;
                        LineIntegral::order6() => dt 0.02;
                        Nystrom::order6() => adaptive 1e-6;
                        Gauss::order16() => adaptive 1e-8;
                    }
                }
            }
        )*};
    }
    every!(
        three().bonds(SPRING, [(0, 1), (1, 2), (0, 2)]),
        three().chain(SPRING).drive(0, hand),
        three().body(2.0, [0.4, -0.8], [0.0; 2]).bonds(SPRING, [(0, 1), (1, 2), (0, 2), (3, 0)]).pin(3),
        three().pairs(SPRING).periodic([12.0, 12.0]),
        three().pairs(Touch { k: 900.0, reach: 0.7 }).chain(SPRING)
    );
    assert!(seen > 400, "{seen}");
}

/// Stopped where two bodies meet, of which an encounter tells; it goes on, and tells of it no second time.
#[test]
fn a_scene_goes_on_from_an_encounter() {
    let scene = || three().pairs(SPRING);
    let whole = Simulation::scene(scene()).scheme(Nystrom::order6()).dt(0.05).encounter(0.8).run_until(25.0).unwrap();
    let (mut last, mut met) = (Simulation::scene(scene()).start(), Vec::new());
    while last.t < 25.0 {
        let on = Simulation::scene(scene()).starting_from(&last).scheme(Nystrom::order6()).dt(0.05);
        let run = on.stop_at_encounter(0.8).run_until(25.0).unwrap();
        met.extend(run.events().iter().map(|event| event.bodies().unwrap()));
        assert!(run.events().len() <= 1 || run.events().iter().all(|event| event.state() == run.last()));
        last = run.last().clone();
    }
    assert_eq!(met, whole.events().iter().map(|event| event.bodies().unwrap()).collect::<Vec<_>>());
    assert!(met.len() > 5, "{met:?}");
}

/// A law without a value where the bodies are stops the next step, saved and resumed or not; a better one lets it go on.
#[test]
fn a_scene_waits_for_a_law_with_a_value() {
    let mut waited = 0;
    let scene = |g| three().pairs(Gravity { g }).chain(SPRING);
    macro_rules! waits {
        ($($scheme:expr),*) => {$({
            let mut stepper = Simulation::scene(scene(0.3)).scheme($scheme).dt(0.01).stepper().unwrap();
            stepper.advance(5).unwrap();
            let state = stepper.state();
            stepper.law_mut::<Gravity>().unwrap().g = f64::NAN;
            let error = stepper.step().unwrap_err();
            assert_eq!(format!("{:?}", stepper.advance(3).unwrap_err()), format!("{error:?}"));
            let between = stepper.at(stepper.t() + 0.004).unwrap_err();
            assert_eq!(format!("{between:?}"), format!("{error:?}"));
            assert_eq!((stepper.state(), stepper.steps()), (state.clone(), 5));
            // Where it can be saved: with numbers that are none no checkpoint is taken up.
            let huge = 1e308;
            stepper.law_mut::<Gravity>().unwrap().g = huge;
            if stepper.step().is_err() {
                let wide = Scene::new()
                    .body(1.3, [0.0, 0.0], [0.0; 2])
                    .body(0.8, [1e3, 0.0], [0.0; 2])
                    .body(0.6, [0.0, 1e3], [0.0; 2])
                    .pairs(Gravity { g: huge })
                    .chain(SPRING);
                let mut other = Simulation::scene(wide).scheme($scheme).dt(0.01).resume(&stepper.checkpoint()).unwrap();
                assert!(other.step().is_err() && other.advance(2).is_err());
                other.law_mut::<Gravity>().unwrap().g = 0.2;
                stepper.law_mut::<Gravity>().unwrap().g = 0.2;
                let mut anew = Simulation::scene(scene(0.2).starting_from(&state)).scheme($scheme).dt(0.01).stepper().unwrap();
                [&mut stepper, &mut other, &mut anew].into_iter().for_each(|stepper| stepper.advance(7).unwrap());
                assert_eq!((other.state(), other.steps()), (stepper.state(), stepper.steps()));
                assert_eq!(anew.state(), stepper.state());
                waited += 1;
            }
        })*};
    }
    waits!(
        Leapfrog,
        Nystrom::order6(),
        Implicit,
        DiscreteGradient,
        Kanatani,
        Gauss::order16(),
        Composed::order4(DiscreteGradient)
    );
    assert!(waited > 5, "{waited}");
}
