//! What a study measures against, and where its steps begin, on motions that tell little of themselves at the start.

use dmech::StudyReport;
use dmech::models::Pendulum;
use dmech::prelude::*;

/// A field of space that acts in one place, and one that acts at one time.
#[derive(Clone, Copy, Debug)]
struct Brief {
    bump: f64,
    kick: f64,
    width: f64,
}

#[dmech::law]
impl Brief {
    #[potential]
    fn energy(&self, q: f64, t: f64) -> f64 {
        let [near, now] = [(q - 7.7) / self.width, (t - 5.3) / self.width];
        self.bump * (-near * near).exp() - self.kick * q * (-now * now).exp()
    }
}

fn study<'a>(law: Brief, start: [f64; 2]) -> Study<'a, Brief, State<1>> {
    let [q, v] = start;
    Study::new(law, State::new([q], [v]), 10.0).repetitions(1).scheme(Leapfrog).scheme(Gauss::order16())
}

/// The steps and errors of the first scheme.
fn rows(report: &StudyReport) -> Vec<(u64, f64)> {
    report.rows_of(0).map(|row| (row.steps(), row.result().unwrap().error())).collect()
}

/// Before and behind it the motion is free, and so exact for every scheme and every step. A bump is left by as much later as it is wide,
/// times ∫ (1/√(1 − 0.6 exp(−x²)) − 1) dx; a kick adds 0.6 √π to the speed for the 4.7 that are left.
#[test]
fn a_reference_sees_what_acts_in_between() {
    let bump = |width| (Brief { bump: 0.3, kick: 0.0, width }, [1.0, 1.0], 0.833 * width);
    let kick = |width| (Brief { bump: 0.0, kick: 0.6 / width, width }, [1.0, 0.5], 5.0);
    for (law, start, told) in [bump(0.05), kick(0.05), kick(0.005)] {
        let study = || study(law, start).ladder([2.0, 1.0, 0.5]);
        for report in [study().run().unwrap(), study().precise().run().unwrap()] {
            let rows = rows(&report);
            let passes_by = |(_, error): &(u64, f64)| (error / told - 1.0).abs() < 0.01;
            assert!(rows.iter().any(passes_by), "{law:?}: a free motion is off by {told:e}: {rows:?}");
            assert!(report.reference().unwrap().error() < 1e-3 * told, "{law:?}");
        }
    }
}

/// What acts for so short a time that these miss it is said by the longest step.
#[test]
fn the_longest_step_is_that_of_the_reference_too() {
    let free = || study(Brief { bump: 0.0, kick: 0.0, width: 1.0 }, [1.0, 1.0]).ladder([1.0]);
    for longest in [0.07, 0.02] {
        let reports = [free().dt(longest).run().unwrap(), free().dt(longest).precise().run().unwrap()];
        for reference in reports.iter().map(|report| report.reference().unwrap()) {
            assert!(reference.dt() <= longest && reference.dt() > 0.2 * longest, "{longest}: {reference:?}");
        }
    }
}

/// A start that tells a time longer than the span: the ladder begins with one step of the whole span, and goes on from there.
#[test]
fn ladders_begin_within_the_span() {
    let law = Brief { bump: 0.0, kick: 1.0, width: 0.5 };
    for start in [[0.0, 0.0], [1.0, 0.0], [0.0, 1e-3]] {
        let report = study(law, start).run().unwrap();
        for scheme in 0..2 {
            let steps: Vec<_> = report.rows_of(scheme).map(|row| row.steps()).collect();
            assert!(steps[0] == 1 && steps.windows(2).all(|two| two[1] > two[0]), "from {start:?}: {steps:?}");
        }
        let last = report.rows_of(1).last().unwrap().result().unwrap().error();
        assert!(last < 1e-9, "from {start:?}: {last:e}");
    }
}

/// A body at rest where next to nothing acts yet: that nothing is not followed to all its digits.
#[test]
fn a_kick_at_rest_is_followed_precisely() {
    let law = Brief { bump: 0.0, kick: 1.0, width: 0.1 };
    let report = study(law, [0.0, 0.0]).precise().run().unwrap();
    let reference = report.reference().unwrap();
    assert!(reference.is_precise() && reference.error() < 1e-16, "{reference:?}");
    let (_, error) = *rows(&report).last().unwrap();
    assert!(error < 1e-6, "{error:e}");
}

/// Mean steps that hardly differ tell no order.
#[test]
fn orders_are_told_where_steps_differ() {
    let motion = Study::new(Pendulum { k: 1.7 }, State::new([1.2], [0.3]), 10.0).repetitions(1);
    let report = motion.adaptive(Nystrom::order6(), [1e-6, 0.9e-6, 1e-9]).run().unwrap();
    let text = report.to_string();
    let orders: Vec<_> =
        text.lines().filter(|line| line.contains("tol")).map(|line| line.split_whitespace().nth(6).unwrap()).collect();
    assert!(orders.len() == 3 && orders[1] == "–" && orders[2].parse::<f64>().is_ok(), "{text}");
}
