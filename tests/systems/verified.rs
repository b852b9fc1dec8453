//! `verify_scheme` passes every scheme and catches those that promise too much; a study of a scene is one of its law.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use dmech::extend::{Kept, Method};
use dmech::models::pairs::Spring;
use dmech::prelude::*;
use dmech::{StudyError, verify_scheme};
use dmech_study::verify::Outcome;

use super::own::KickAfter;
use super::wrapped::{Honest, Promise, promising};

/// Every scheme passes, on laws and on the scene, and each has something to show.
#[test]
fn every_scheme_passes() {
    macro_rules! passes {
        ($least:literal: $($scheme:expr),* $(,)?) => { $({
            let report = verify_scheme($scheme);
            report.assert();
            let measured = report.checks().iter().filter(|check| check.measured().is_some()).count();
            assert!(measured >= $least, "{report}");
        })* };
    }
    passes![
        6: Explicit,
        Leapfrog,
        CompensatedLeapfrog,
        Boris,
        Implicit,
        DiscreteGradient,
        Kanatani,
        Composed::order4(Leapfrog),
        Composed::order4(Boris),
        Composed::order4(Implicit),
        Composed::order6(DiscreteGradient),
        Nystrom::order6(),
        Relaxed::order6(),
        ForceGradient::order4(),
        LineIntegral::order4(),
        LineIntegral::order10(),
        Gauss::order16(),
    ];
    // Its errors are at the level of rounding, and it has no way back.
    passes![4: RungeKuttaNystrom::order12()];
}

#[derive(Clone, Copy, Debug)]
struct OrderFour;
impl<S: Method> Promise<S> for OrderFour {
    const ORDER: u32 = 4;
}

#[derive(Clone, Copy, Debug)]
struct ExactEnergy;
impl<S: Method> Promise<S> for ExactEnergy {
    fn keeps(invariant: Invariant) -> Kept {
        if invariant == Invariant::Energy { Kept::Exact } else { S::keeps(invariant) }
    }
}

#[test]
fn promises_that_are_not_kept_are_found() {
    fn failed<P: Promise<Leapfrog>>() -> Vec<String> {
        let report = verify_scheme(promising::<P, _>(Leapfrog));
        let failed = report.checks().iter().filter(|check| check.outcome() == Outcome::Failed);
        failed.map(|check| check.name().to_owned()).collect()
    }
    assert_eq!(failed::<Honest>(), [""; 0]);
    let on_all = |what: &str| ["one coordinate", "two coordinates", "three bodies"].map(|on| format!("{on}: {what}"));
    assert_eq!(failed::<OrderFour>(), on_all("order"));
    assert_eq!(failed::<ExactEnergy>(), on_all("energy"));
    // Leap-frog has none.
    assert_eq!(failed::<EnergyOfItsOwn>(), on_all("discrete energy"));
}

#[derive(Clone, Copy, Debug)]
struct BoundedEnergy;
impl<S: Method> Promise<S> for BoundedEnergy {
    fn keeps(invariant: Invariant) -> Kept {
        if invariant == Invariant::Energy { Kept::Bounded } else { S::keeps(invariant) }
    }
}

/// Of order 1 what is bounded deviates by the step itself, as a drift does; a drift grows with the time. The kick, and then the drift, or
/// the other way round, have a bounded energy.
#[test]
fn a_bound_of_first_order_is_no_drift() {
    verify_scheme(KickAfter::<0>).assert();
    verify_scheme(KickAfter::<2>).assert();
    let report = verify_scheme(promising::<BoundedEnergy, _>(Explicit));
    let energies = report.checks().iter().filter(|check| check.name().ends_with(": energy"));
    assert_eq!(energies.filter(|check| check.outcome() == Outcome::Failed).count(), 3, "{report}");
}

#[derive(Clone, Copy, Debug)]
struct EnergyOfItsOwn;
impl<S: Method> Promise<S> for EnergyOfItsOwn {
    fn keeps(invariant: Invariant) -> Kept {
        if invariant == Invariant::DiscreteEnergy { Kept::Exact } else { S::keeps(invariant) }
    }
}

/// Bodies in a periodic box, who never come near its ends, and the same in the open.
#[test]
fn a_study_of_a_periodic_scene_is_one_of_its_bodies() -> Result<(), StudyError> {
    let scene = || Scene::new().body(1.7, [0.7], [0.0]).body(0.6, [-0.4], [0.0]).pairs(Spring { k: 2.3, length: 0.0 });
    let boxed = Study::scene(scene().periodic([10.0]), 9.0).scheme(Leapfrog).ladder([0.1]).repetitions(1).run()?;
    let open = Study::scene(scene(), 9.0).scheme(Leapfrog).ladder([0.1]).repetitions(1).run()?;
    let [boxed, open] = [boxed, open].map(|report| report.rows()[0].result().unwrap().error());
    assert_abs_diff_eq!(boxed, open, epsilon = 1e-11);
    Ok(())
}

/// Two bodies on a spring in a scene and as one law of their distance: the same errors, step for step.
#[test]
fn a_study_of_a_scene_is_one_of_its_law() -> Result<(), StudyError> {
    let spring = Spring { k: 2.3, length: 0.0 };
    let scene = || Scene::new().body(1.7, [0.7], [0.0]).body(0.6, [-0.4], [0.0]).pairs(spring);
    // d = q₁ − q₂ = 1.1 cos ωt, ω² = k/μ, about a centre that rests.
    let (centre, omega) = ((1.7 * 0.7 - 0.6 * 0.4) / 2.3, (2.3_f64 * 2.3 / (1.7 * 0.6)).sqrt());
    let exact = |t: f64| {
        let d = 1.1 * (omega * t).cos();
        vec![[centre + 0.6 / 2.3 * d], [centre - 1.7 / 2.3 * d]]
    };
    let steps = [0.1, 0.05, 0.025];
    let study = |study: Study<'static, (), _>| {
        study
            .scheme(Leapfrog)
            .scheme(DiscreteGradient)
            .adaptive(Nystrom::order6(), [1e-4, 1e-7])
            .ladder(steps)
            .repetitions(1)
    };
    let report = study(Study::scene(scene(), 9.0)).exact(exact).run()?;
    println!("{report}");
    assert_eq!(report.rows().len(), 8);
    let error = |scheme: usize, row: usize| report.rows_of(scheme).nth(row).unwrap().result().unwrap().error();
    for scheme in 0..2 {
        let order = (error(scheme, 1) / error(scheme, 2)).log2();
        assert_abs_diff_eq!(order, 2.0, epsilon = 0.05);
    }
    assert!(error(2, 1) < 1e-6 && error(2, 1) < error(2, 0));
    // As one coordinate of reduced mass: the distance in the space of both bodies is √(0.6² + 1.7²)/2.3 of that.
    #[derive(Clone, Copy, Debug, dmech::Law)]
    #[potential(|q: [f64; 1]| 0.5 * self.k * q[0] * q[0])]
    struct Apart {
        k: f64,
    }
    let law = Study::new(Apart { k: 2.3 }, State::new([1.1], [0.0]), 9.0).mass(1.7 * 0.6 / 2.3).scheme(Leapfrog);
    let one = law.ladder(steps).exact(|t| [1.1 * (omega * t).cos()]).repetitions(1).run()?;
    let share = 0.6_f64.hypot(1.7) / 2.3;
    for (row, expected) in one.rows().iter().enumerate() {
        let expected = share * expected.result().unwrap().error();
        assert!(abs_diff_eq!(error(0, row) / expected, 1.0, epsilon = 1e-9), "{} {expected}", error(0, row));
    }
    // Without a solution: a reference of its own.
    let computed = study(Study::scene(scene(), 9.0)).run()?;
    let reference = computed.reference().unwrap().error();
    assert!(reference < 1e-11, "{reference:e}");
    let again = computed.rows_of(0).next().unwrap().result().unwrap().error();
    assert_abs_diff_eq!(again, error(0, 0), epsilon = 1e-11);
    // A solution with too few coordinates is refused.
    let few = Study::scene(scene(), 9.0).scheme(Leapfrog).exact(|_| vec![[0.0]]).run().unwrap_err();
    assert_eq!(few, StudyError::Coordinates { given: 1, needed: 2 });
    Ok(())
}

/// A scene goes on from a state, and not from one of other bodies.
#[test]
fn a_scene_starts_from_a_state() {
    let spring = Spring { k: 2.3, length: 0.4 };
    let scene = || Scene::new().body(1.7, [0.7], [0.1]).body(0.6, [-0.4], [0.0]).pairs(spring);
    let run = |steps| Simulation::scene(scene()).scheme(DiscreteGradient).dt(0.01).run(steps).unwrap();
    let (whole, half) = (run(200), run(100));
    let rest =
        Simulation::scene(scene()).scheme(DiscreteGradient).dt(0.01).starting_from(half.last()).run(100).unwrap();
    assert_eq!(rest.states()[0], *half.last());
    for (a, b) in whole.last().q.iter().zip(&rest.last().q) {
        assert_abs_diff_eq!(a[0], b[0], epsilon = 1e-13);
    }
    let mut one = half.last().clone();
    one.q.pop();
    let refused = Simulation::scene(scene()).scheme(Leapfrog).dt(0.01).starting_from(&one).run(1).unwrap_err();
    assert_eq!(refused.cause(), Error::Scene(dmech::SceneError::Bodies { given: 1, bodies: 2 }));
}
