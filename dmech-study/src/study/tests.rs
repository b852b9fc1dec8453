//! Reports made of given figures: what is the fastest does not hang on the machine.

use std::time::Duration;

use dmech_core::Error;

use super::reference::Settling;
use super::report::StudyReport;
use super::row::{Figures, StudyRow};

/// Costs c e^(−1/p) microseconds and forces, so that the order p decides at small errors and the cost c at large ones.
fn report() -> StudyReport {
    let schemes = vec![("cheap", 2), ("middle", 4), ("costly", 8)];
    let costs = [1.0, 10.0, 80.0];
    let mut rows = Vec::new();
    for (entrant, &(name, order)) in schemes.iter().enumerate() {
        for (k, error) in [1e-1, 2e-3, 3e-5, 4e-7, 5e-10].into_iter().enumerate() {
            let cost = costs[entrant] * f64::powf(error, -1.0 / f64::from(order));
            let time = Duration::from_secs_f64(1e-6 * cost);
            let figures = Figures { time, evaluations: cost as u64, iterations: 0, error, drifts: Default::default() };
            // "cheap" fails with its smallest step, and so does not reach 1e-9.
            let failure = Error::NotFinite { step: 7, time: 0.5, dt: 0.1 };
            let result = if entrant == 0 && k == 4 { Err(failure) } else { Ok(figures) };
            rows.push(StudyRow::new((entrant, name, order), (0.5_f64.powi(k as i32), 10 << k), result));
        }
    }
    StudyReport::new(schemes, rows, [0.0, 10.0], 1e-12, None)
}

/// 1 e^(−1/2), 10 e^(−1/4), 80 e^(−1/8): at 1e-3 32, 56, 190; at 1e-6 1000, 316, 450; at 1e-9 –, 1778, 1067.
#[test]
fn the_summary_names_the_fastest_at_each_error() {
    let report = report();
    for (error, name, micros) in [(1e-3, "cheap", 31.62), (1e-6, "middle", 316.2), (1e-9, "costly", 1066.9)] {
        let (found, time) = report.fastest_at(error).unwrap();
        assert_eq!(found, name);
        let time = 1e6 * time.as_secs_f64();
        assert!((time / micros - 1.0).abs() < 1e-3, "{error}: {time}");
        let line = format!("fastest at {error:.0e}: {name}, ");
        assert!(report.to_string().contains(&line), "{report}");
    }
    assert!(report.time_at(1e-9)[0].1.is_none() && report.evaluations_at(1e-9)[0].1.is_none());
    assert!(report.fastest_at(1e-11).is_none());
    // The resolution is 1e-12: what is below cannot be told, whatever the rows say.
    assert!(report.fastest_at(5e-13).is_none());
    let forces = report.evaluations_at(1e-6)[1].1.unwrap();
    assert!((forces / 316.2 - 1.0).abs() < 0.02, "{forces}");
}

/// A failed run is a line of the table and of the file, with its cause.
#[test]
fn a_failed_run_is_shown_with_its_cause() {
    let report = report();
    let table = report.to_string();
    assert!(table.contains("step 7 from t = 0.5 with dt = 0.1 led to"), "{table}");
    assert!(table.lines().all(|line| line.chars().count() <= 100), "{table}");
    let mut csv = Vec::new();
    report.write_csv(&mut csv).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    assert_eq!(csv.lines().count(), 1 + report.rows().len());
    let columns = csv.lines().next().unwrap().split(',').count();
    let failed: Vec<_> = csv.lines().filter(|line| line.contains("step 7")).collect();
    assert_eq!(failed.len(), 1);
    assert!(csv.lines().all(|line| line.split(',').count() == columns), "{csv}");
}

/// Figures as they are, a failure in words.
#[cfg(feature = "serde")]
#[test]
fn a_report_is_written() {
    let report = report();
    let value = serde_json::to_value(&report).unwrap();
    let rows = value["rows"].as_array().unwrap();
    assert_eq!(rows.len(), report.rows().len());
    for (written, row) in rows.iter().zip(report.rows()) {
        assert_eq!(written["dt"].as_f64(), Some(row.dt()));
        match row.result() {
            Ok(figures) => assert_eq!(written["result"]["Ok"]["error"].as_f64(), Some(figures.error())),
            Err(error) => assert_eq!(written["result"]["Err"].as_str(), Some(error.to_string().as_str())),
        }
    }
}

/// What changes of the final position say of its error: the smallest where the order shows, and not where it is chance.
#[test]
fn a_change_that_is_small_by_chance_is_no_error() {
    let said = |changes: &[f64]| {
        let mut settling = Settling::default();
        changes.iter().filter_map(|&change| settling.nearer(change)).last()
    };
    // Order 8 down to rounding: as if nothing were asked.
    assert_eq!(said(&[1e-2, 4e-5, 1.6e-7, 6e-10, 2.4e-12]), Some(2.4e-12));
    assert_eq!(said(&[1e-2, 4e-5, 1.6e-7, 6e-10, 2.4e-12, 4e-13, 3e-13]), Some(4e-13));
    // A kink lets it fall by 4 or so, and a jump by 2: the third is chance.
    assert_eq!(said(&[4e-6, 1e-6, 3e-10, 9e-8, 2e-8]), Some(9e-8));
    assert_eq!(said(&[4e-6, 1e-6, 3e-10]), Some(1e-6));
    // Where the order has shown before, too.
    assert_eq!(said(&[1e-1, 1e-3, 1e-5, 3e-7, 1e-6, 4e-7]), Some(1e-6));
}

/// At rest where all numbers are 0 there is no error, and none is told as less than the smallest number.
#[test]
fn no_error_is_told_as_none() {
    let figures =
        Figures { time: Duration::ZERO, evaluations: 1, iterations: 0, error: 0.0, drifts: Default::default() };
    let row = || vec![StudyRow::new((0, "still", 2), (0.1, 10), Ok(figures))];
    let table = |resolution| StudyReport::new(vec![("still", 2)], row(), [0.0, 1.0], resolution, None).to_string();
    assert!(table(5e-324).contains("        0     –"), "{}", table(5e-324));
    assert!(table(1e-16).contains(" <1.0e-16     –"), "{}", table(1e-16));
}
