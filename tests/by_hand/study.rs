//! Studies: errors, orders, costs and failures as rows.

use approx::{abs_diff_eq, assert_abs_diff_eq, relative_eq};
use std::time::Duration;

use crate::common::{DrivenSpring, Kepler, Pendulum, SUN, Spring, greenspan_orbit, kepler_position};
use dmech_core::prelude::*;
use dmech_study::study::StudyRow;
use dmech_study::{Study, StudyError, StudyReport};

/// Where the errors of a row and of the one with half its step are, and the order that they show.
fn orders(report: &StudyReport, scheme: usize) -> Vec<f64> {
    let points: Vec<_> = report.rows_of(scheme).map(|row| (row.dt(), row.result().unwrap().error())).collect();
    points.windows(2).map(|p| (p[0].1 / p[1].1).ln() / (p[0].0 / p[1].0).ln()).collect()
}

fn error(row: &StudyRow) -> f64 {
    row.result().unwrap().error()
}

/// Kepler's equation on a nonlinear law, off the period: each declared order comes from the rows, and what a scheme
/// keeps exactly has no drift.
#[test]
fn rows_show_the_order_and_what_is_kept() {
    let study =
        |steps: [f64; 3]| Study::new(SUN, greenspan_orbit(), 1.0).ladder(steps).exact(kepler_position).repetitions(1);
    let small = study([1.0 / 800.0, 1.0 / 1600.0, 1.0 / 3200.0])
        .scheme(Explicit)
        .scheme(Leapfrog)
        .scheme(Implicit)
        .scheme(DiscreteGradient)
        .scheme(Kanatani);
    let large = study([1.0 / 40.0, 1.0 / 80.0, 1.0 / 160.0])
        .scheme(Composed::order4(Leapfrog))
        .scheme(Composed::order4(DiscreteGradient));
    let mut seen = 0;
    for report in [small.run().unwrap(), large.run().unwrap()] {
        println!("{report}");
        assert!(report.reference().is_none());
        for (scheme, &(name, order)) in report.schemes().iter().enumerate() {
            let measured = orders(&report, scheme);
            assert!(report.rows_of(scheme).map(error).is_sorted_by(|a, b| a > b), "{name}");
            let last = measured[measured.len() - 1];
            assert!(abs_diff_eq!(last, f64::from(order), epsilon = 0.1), "{name}: {measured:?}");
            seen += measured.len();
            for row in report.rows_of(scheme) {
                let figures = row.result().unwrap();
                let relative = |i| figures.drift(i).unwrap().max_relative();
                assert!(figures.time() > Duration::ZERO && figures.time() < Duration::from_secs(60));
                assert!(figures.evaluations() >= row.steps());
                if name.contains("DiscreteGradient") {
                    assert!(relative(Invariant::Energy) < 1e-14, "{name}: {}", relative(Invariant::Energy));
                } else if name != "Kanatani" {
                    assert!(relative(Invariant::Energy) > 1e-13, "{name}: nothing to see");
                }
                assert_eq!(figures.drift(Invariant::DiscreteEnergy).is_some(), name == "Kanatani");
                let kept = relative(Invariant::AngularMomentum) < 1e-13;
                assert_eq!(kept, !matches!(name, "Explicit" | "Implicit"), "{name}");
            }
        }
    }
    assert_eq!(seen, 14);
}

/// The oscillator q = 0.7 cos ωt + (0.4/ω) sin ωt with ω² = k/m, and what leap-frog makes of it in closed form.
#[test]
fn the_error_is_the_distance_to_the_exact_solution() {
    let (k, m, end) = (2.3, 1.7, 9.0);
    let omega = f64::sqrt(k / m);
    let exact = |t: f64| [0.7 * (omega * t).cos() + 0.4 / omega * (omega * t).sin()];
    let report = Study::new(Spring { k }, State::new([0.7], [0.4]), end)
        .mass(m)
        .scheme(Leapfrog)
        .scheme(Composed::order8(DiscreteGradient))
        .ladder([0.01, 0.02, 0.02, 0.04])
        .exact(exact)
        .run()
        .unwrap();
    // Sorted, each step once, and shortened to whole steps: 9/0.04 = 225, 9/0.02 = 450, 9/0.01 = 900.
    assert_eq!(report.rows().iter().map(|row| row.steps()).collect::<Vec<_>>(), [225, 450, 900, 225, 450, 900]);
    for row in report.rows_of(0) {
        // q_n of leap-frog is A cos(ω′ t_n) + B sin(ω′ t_n) with sin(ω′h/2) = ωh/2 and B = v₀/(ω √(1 − (ωh/2)²)).
        let half = 0.5 * omega * row.dt();
        let phase = 2.0 * half.asin() / row.dt() * end;
        let q = 0.7 * phase.cos() + 0.4 / (omega * (1.0 - half * half).sqrt()) * phase.sin();
        let expected = (q - exact(end)[0]).abs();
        assert!((error(row) - expected).abs() < 1e-12 && expected > 1e-6, "{} {expected}", error(row));
    }
    assert!(report.rows_of(1).all(|row| error(row) < 1e-12));
}

/// Steps are cut to whole numbers: 1/0.3 is 4 steps of 0.25, and a step beyond the end is one step.
#[test]
fn steps_end_at_the_end() {
    let report = Study::new(SUN, greenspan_orbit().at_time(2.0), 3.0)
        .scheme(Leapfrog)
        .ladder([0.3, 7.0])
        .exact(|t| kepler_position(t - 2.0))
        .run()
        .unwrap();
    let rows: Vec<_> = report.rows().iter().map(|row| (row.steps(), row.dt())).collect();
    assert_eq!(rows, [(1, 1.0), (4, 0.25)]);
}

/// Without an exact solution: the reference is at least as near the truth as it says.
#[test]
fn the_reference_knows_its_error() {
    let study = || Study::new(SUN, greenspan_orbit(), 7.3).scheme(Leapfrog).ladder([0.01, 0.002]).repetitions(1);
    let (known, computed) = (study().exact(kepler_position).run().unwrap(), study().run().unwrap());
    let reference = *computed.reference().unwrap();
    assert!(reference.error() < 1e-11, "{reference:?}");
    for (a, b) in known.rows().iter().zip(computed.rows()) {
        let apart = (error(a) - error(b)).abs();
        // kepler_position itself is known to a few ulps of the mean anomaly.
        assert!(apart <= reference.error() + 1e-13, "{apart} {reference:?}");
    }
    assert!(computed.to_string().contains("q*: Composed(DiscreteGradient, SofroniouSpaletta8)"), "{computed}");
    // What is below the error of the reference cannot be told.
    assert!(computed.time_at(0.5 * reference.error()).iter().all(|(_, time)| time.is_none()));
}

/// A ladder of the study's own: coarse to fine, until the error stalls or the work is large; costs rise as errors fall.
#[test]
fn the_default_ladder_goes_from_coarse_to_the_level_of_rounding() {
    let report = Study::new(Pendulum { k: 1.3 }, State::new([2.1], [0.4]), 20.0)
        .scheme(Composed::order4(Leapfrog))
        .scheme(Composed::order8(DiscreteGradient))
        .scheme(Leapfrog)
        .repetitions(1)
        .run()
        .unwrap();
    println!("{report}");
    for (scheme, (name, _)) in report.schemes().iter().enumerate() {
        let rows: Vec<_> = report.rows_of(scheme).collect();
        assert!(rows.windows(2).all(|pair| pair[1].dt() < pair[0].dt()), "{name}");
        assert!(error(rows[0]) > 1e-3 && error(rows[rows.len() - 1]) < 1e-8, "{name}");
    }
    let forces = [1e-3, 1e-6, 1e-8].map(|goal| report.evaluations_at(goal));
    for scheme in 0..3 {
        let [a, b, c] = [0, 1, 2].map(|goal: usize| forces[goal][scheme].1.unwrap());
        assert!(a < b && b < c, "{}: {a} {b} {c}", report.schemes()[scheme].0);
    }
    // From 1e-3 to 1e-6 a scheme of order p needs 1000^(1/p) times the forces: 31.6 at order 2, 5.6 at order 4.
    let growth = |scheme: usize| forces[1][scheme].1.unwrap() / forces[0][scheme].1.unwrap();
    assert!(relative_eq!(growth(2), 1000_f64.powf(0.5), max_relative = 0.1), "{}", growth(2));
}

/// Φ = −g e^(5q): steeper than any power.
#[derive(Clone, Copy)]
struct Well {
    g: f64,
}

impl Conservative for Well {}

impl Potential<1> for Well {
    fn potential(&self, [q]: [f64; 1]) -> f64 {
        -self.g * (5.0 * q).exp()
    }
    fn gradient(&self, [q]: [f64; 1]) -> [f64; 1] {
        [-5.0 * self.g * (5.0 * q).exp()]
    }
    fn hessian(&self, [q]: [f64; 1]) -> [[f64; 1]; 1] {
        [[-25.0 * self.g * (5.0 * q).exp()]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        let (m, d) = (2.5 * (a + b), 2.5 * (b - a));
        [-5.0 * self.g * m.exp() * if d == 0.0 { 1.0 } else { d.sinh() / d }]
    }
    fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
        let (m, d) = (2.5 * (a + b), 2.5 * (b - a));
        let (sinc, slope) = if d.abs() < 1e-4 { (1.0, d / 3.0) } else { (d.sinh() / d, (d.cosh() - d.sinh() / d) / d) };
        [[-12.5 * self.g * m.exp() * (sinc + slope)]]
    }
}

/// Under Φ = −g e^(5q) the motion reaches infinity in a finite time: every run fails, as a row with its cause.
#[test]
fn a_run_that_fails_is_a_row() {
    let report = Study::new(Well { g: 1.0 }, State::new([0.0], [0.0]), 5.0)
        .scheme(Leapfrog)
        .scheme(DiscreteGradient)
        .ladder([0.1, 0.01])
        .exact(|_| [0.0])
        .run()
        .unwrap();
    println!("{report}");
    assert_eq!(report.rows().len(), 4);
    for row in report.rows_of(0) {
        assert!(matches!(row.result(), Err(Error::NotFinite { dt, .. }) if dt == row.dt()), "{row:?}");
    }
    for row in report.rows_of(1) {
        assert!(matches!(row.result(), Err(Error::NotConverged { .. } | Error::NotFinite { .. })), "{row:?}");
    }
    assert!(report.fastest_at(1.0).is_none());
    let table = report.to_string();
    assert!(table.contains("fastest at 1e-6: not reached") && !table.contains("NaN"), "{table}");
    assert!(table.lines().all(|line| line.chars().count() <= 100), "{table}");
    // Nor is there a reference for such a motion.
    let error = Study::new(Well { g: 1.0 }, State::new([0.0], [0.0]), 100.0).scheme(Leapfrog).run().unwrap_err();
    assert!(matches!(error, StudyError::Motion(Error::NotConverged { .. } | Error::NotFinite { .. })), "{error}");
}

/// The same motion, q = −(2/5) ln cos(5 √(g/2) t), until just before: a step too large has no solution there and fails
/// alone, as it does outside a study; the others have their errors.
#[test]
fn a_step_too_large_fails_alone() {
    let (law, start, end) = (Well { g: 1.0 }, State::new([0.0], [0.0]), 0.42);
    let exact = |t: f64| [-0.4 * (12.5_f64.sqrt() * t).cos().ln()];
    let run = |dt| Simulation::new(law, start).scheme(DiscreteGradient).dt(dt).run_until(end).map(|run| *run.last());
    let study = Study::new(law, start, end).scheme(DiscreteGradient).ladder([0.14, 0.105, 1e-3, 5e-4]).exact(exact);
    let report = study.run().unwrap();
    println!("{report}");
    let failed: Vec<_> = report.rows().iter().map(|row| row.result().is_err()).collect();
    assert_eq!(failed, [true, true, false, false], "{report}");
    for row in report.rows() {
        let alone = run(row.dt()).map(|last| (last.q[0] - exact(end)[0]).abs());
        assert_eq!(row.result().map(|figures| figures.error()), alone.map_err(|interrupted| interrupted.cause()));
    }
    let order = (error(&report.rows()[2]) / error(&report.rows()[3])).log2();
    assert_abs_diff_eq!(order, 2.0, epsilon = 0.1);
}

/// Without a ladder too: every step fails, down to the smallest, and the study ends.
#[test]
fn a_default_ladder_of_failures_ends() {
    let study = Study::new(Well { g: 1.0 }, State::new([0.0], [0.0]), 5.0).scheme(Leapfrog).scheme(Implicit);
    let report = study.exact(|_| [0.0]).run().unwrap();
    for scheme in 0..2 {
        assert!(report.rows_of(scheme).count() > 10);
        assert!(report.rows_of(scheme).all(|row| row.result().is_err()));
    }
}

/// A spring that is driven has no energy to keep, and a reference all the same: the order shows against it.
#[test]
fn laws_that_name_the_time_have_a_reference() {
    let law = DrivenSpring { k: 2.3, epsilon: 0.4, omega: 1.9 };
    let study = Study::new(law, State::new([0.7], [0.4]).at_time(0.3), 6.1).mass(1.7);
    let report = study.scheme(Leapfrog).scheme(DiscreteGradient).ladder([0.02, 0.01, 0.005]).run().unwrap();
    assert!(report.resolution() < 1e-12 && report.span() == [0.3, 6.1]);
    for scheme in 0..2 {
        let measured = orders(&report, scheme);
        assert!(measured.iter().all(|order| (order - 2.0).abs() < 0.05), "{measured:?}");
    }
    for row in report.rows() {
        assert!(row.result().unwrap().drift(Invariant::Energy).is_none());
    }
    let table = report.to_string();
    assert!(!table.contains("energy") && table.contains("K − work"), "{table}");
}

/// What no run could do anything with is refused before any run.
#[test]
fn refusals() {
    let spring = Spring { k: 2.0 };
    let start = State::new([0.7], [0.0]);
    let study = |start: State<1>, end| Study::new(spring, start, end).scheme(Leapfrog).exact(|_| [0.0]);
    assert_eq!(Study::new(spring, start, 1.0).run().unwrap_err(), StudyError::NoSchemes);
    for end in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(study(start, end).run().unwrap_err(), StudyError::Motion(Error::Span { start: 0.0, end }));
    }
    assert!(matches!(study(start, f64::NAN).run(), Err(StudyError::Motion(Error::Span { .. }))));
    assert_eq!(study(start, 1.0).ladder([]).run().unwrap_err(), StudyError::NoSteps);
    assert_eq!(
        study(start, 1.0).ladder([0.1, -0.1]).run().unwrap_err(),
        StudyError::Motion(Error::TimeStep { dt: -0.1 })
    );
    for dt in [0.0, -1.0] {
        assert_eq!(study(start, 1.0).dt(dt).run().unwrap_err(), StudyError::Motion(Error::TimeStep { dt }));
    }
    // Steps longer than the span are the span, once.
    let report = study(start, 1.0).ladder([3.0, 0.5, 5.0, 1.0]).repetitions(1).run().unwrap();
    assert_eq!(report.rows().iter().map(|row| row.steps()).collect::<Vec<_>>(), [1, 2]);
    assert_eq!(study(start, 1.0).mass(0.0).run().unwrap_err(), StudyError::Motion(Error::Mass { mass: 0.0 }));
    assert!(matches!(study(State::new([f64::NAN], [0.0]), 1.0).run(), Err(StudyError::Motion(Error::State { .. }))));
    assert!(matches!(study(start.at_time(f64::INFINITY), 1.0).run(), Err(StudyError::Motion(Error::State { .. }))));
    let infinite = study(start, 1.5).exact(|t| [t / 0.0]).run().unwrap_err();
    assert_eq!(infinite, StudyError::Exact { value: f64::INFINITY, time: 1.5 });
    let row = &study(start, 1.0).ladder([1e-17]).run().unwrap().rows()[0].clone();
    assert_eq!(row.result().unwrap_err(), Error::EndTime { end: 1.0, dt: 1e-17 });
    let at_centre = Study::new(Kepler::<true> { k: 1.0 }, State::new([0.0, 0.0], [0.0, 0.0]), 1.0).scheme(Leapfrog);
    assert!(matches!(at_centre.run(), Err(StudyError::Motion(Error::Law { .. }))));
}

/// Tolerances take the place of the ladder for schemes that follow the motion, and rows tell what came of them.
#[test]
fn adaptive_schemes_have_tolerances() {
    let end = 20.0;
    let report = Study::new(SUN, greenspan_orbit(), end)
        .scheme(Composed::order6(DiscreteGradient))
        .adaptive(Composed::order6(DiscreteGradient), [1e-3, 1e-5, 1e-7])
        .ladder([0.2, 0.1, 0.05, 0.025, 0.0125])
        .exact(kepler_position)
        .repetitions(1)
        .run()
        .unwrap();
    println!("{report}");
    let rows: Vec<_> = report.rows_of(1).collect();
    assert_eq!(report.schemes()[1], ("Adaptive(Composed(DiscreteGradient, SofroniouSpaletta6))", 6));
    assert_eq!(rows.iter().map(|row| row.tolerance()).collect::<Vec<_>>(), [Some(1e-3), Some(1e-5), Some(1e-7)]);
    assert!(report.rows_of(0).all(|row| row.tolerance().is_none()));
    for row in &rows {
        let figures = row.result().unwrap();
        assert_abs_diff_eq!(row.dt() * row.steps() as f64 / end, 1.0, epsilon = 1e-12);
        assert!(figures.error() < row.tolerance().unwrap() * end, "{:e}", figures.error());
        assert!(figures.time() < Duration::from_secs(60) && figures.evaluations() > 13 * row.steps());
        let energy = figures.drift(Invariant::Energy).unwrap();
        assert!(energy.samples() > row.steps().min(4096) / 2 && energy.max_relative() < 1e-13);
    }
    let forces = report.evaluations_at(1e-5);
    assert!(forces[1].1.unwrap() < forces[0].1.unwrap(), "{forces:?}");

    // In whatever order they are given, each once.
    let study = || Study::new(SUN, greenspan_orbit(), end).exact(kepler_position).repetitions(1);
    let shuffled = study().adaptive(Nystrom::order6(), [1e-7, 1e-3, 1e-9, 1e-3]).run().unwrap();
    assert_eq!(shuffled.rows().iter().map(|row| row.tolerance().unwrap()).collect::<Vec<_>>(), [1e-3, 1e-7, 1e-9]);
    let falling = study().adaptive(Nystrom::order6(), [1e-3, 1e-7, 1e-9]).run().unwrap();
    assert_eq!(shuffled.evaluations_at(1e-6), falling.evaluations_at(1e-6));
    for tolerance in [-1.0, 0.0, f64::INFINITY] {
        let refused = study().adaptive(DiscreteGradient, [1e-3, tolerance]).run().unwrap_err();
        assert_eq!(refused, StudyError::Motion(Error::Tolerance { tolerance }));
    }
    // One that no step can follow fails alone; a longest step that does not reach the end is one for all.
    let fine = study().adaptive(DiscreteGradient, [1e-3, 1e-300]).run().unwrap();
    let results: Vec<_> = fine.rows().iter().map(|row| row.result().map(|_| ())).collect();
    assert!(matches!(results[..], [Ok(()), Err(Error::TurnVanished { tolerance: 1e-300, .. })]), "{results:?}");
    let short = study().adaptive(DiscreteGradient, [1e-3]).dt(1e-300).run().unwrap_err();
    assert_eq!(short, StudyError::Motion(Error::EndTime { end, dt: 1e-300 }));
    assert_eq!(study().adaptive(DiscreteGradient, []).run().unwrap_err(), StudyError::NoTolerances);
}

/// A start so late that the reference cannot halve its steps as often as it would, and times with many digits in the table.
#[test]
fn late_starts_have_a_reference() {
    for t in [1e12, 1e14] {
        let study = Study::new(Spring { k: 1.0 }, State::new([1.0], [0.0]).at_time(t), t + 8.0).scheme(Leapfrog);
        let report = study.ladder([0.5, 0.25]).repetitions(1).run().unwrap();
        assert!(report.resolution() < 1e-6, "{report}");
        // Where start and end look alike, the table says what lies between.
        assert!(report.to_string().contains(" + 8,"), "{report}");
    }
    let end = 2.0 * core::f64::consts::PI.powi(2);
    let study = Study::new(Spring { k: 1.0 }, State::new([1.0], [0.0]).at_time(-1.7e-9), end).ladder([0.1]);
    let report = study.scheme(Leapfrog).adaptive(Nystrom::order6(), [1e-300, 1e-3]).repetitions(1).run().unwrap();
    let table = report.to_string();
    assert!(table.lines().all(|line| line.chars().count() <= 100), "{table}");
    assert!(table.contains("tol 1e-3") && table.contains("tol 1e-300"), "{table}");
}

/// A law that names the time does not tell how long a step may be: the study takes the longest, and says so where it is missing.
#[test]
fn laws_of_time_are_studied_with_a_longest_step() {
    let study = || {
        Study::new(DrivenSpring { k: 1.3, epsilon: 0.2, omega: 2.1 }, State::new([0.3], [0.1]), 4.0)
            .adaptive(Nystrom::order6(), [1e-5])
            .repetitions(1)
    };
    let row = &study().run().unwrap().rows()[0].clone();
    assert!(row.result().unwrap_err().to_string().contains(".dt(h)"), "{:?}", row.result());
    let row = &study().dt(0.2).run().unwrap().rows()[0].clone();
    assert!(row.steps() >= 20 && row.result().unwrap().error() < 1e-4, "{row:?}");
}
