//! What a run shows and writes.

use crate::common::{SUN, greenspan_orbit};
use dmech_core::prelude::*;

#[test]
fn the_csv_reads_back_as_the_same_numbers() {
    let run = Simulation::new(SUN, greenspan_orbit()).scheme(DiscreteGradient).dt(0.1).record_every(2).run(41).unwrap();
    let mut bytes = Vec::new();
    run.write_csv(&mut bytes).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t,q0,q1,v0,v1"));
    let mut rows = 0;
    for (line, state) in lines.zip(run.states()) {
        let row: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
        assert_eq!(row, [state.t, state.q[0], state.q[1], state.v[0], state.v[1]]);
        rows += 1;
    }
    assert_eq!((rows, text.lines().count()), (21, 22));
}

#[test]
fn the_csv_can_go_to_a_file() {
    let run = Simulation::new(SUN, greenspan_orbit()).scheme(Leapfrog).dt(0.1).run(3).unwrap();
    let path = std::env::temp_dir().join(format!("dmech-core-{}.csv", std::process::id()));
    run.save_csv(&path).unwrap();
    let written = std::fs::read_to_string(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    let mut bytes = Vec::new();
    run.write_csv(&mut bytes).unwrap();
    assert_eq!(written.as_bytes(), bytes);
    let refused = run.save_csv("/no/such/folder/orbit.csv").unwrap_err();
    assert_eq!(refused.kind(), std::io::ErrorKind::NotFound);
    assert!(refused.to_string().contains("/no/such/folder/orbit.csv"), "{refused}");
}

/// The report names what it must: and its columns stand under their heads.
#[test]
fn the_report_is_a_table() {
    let run = Simulation::new(SUN, greenspan_orbit()).scheme(Kanatani).dt(0.02).run_until(350.0).unwrap();
    let text = run.to_string();
    println!("{text}");
    for part in [
        "Kanatani, order 2, dt = 0.02, 17500 steps",
        "discrete energy",
        "angular momentum",
        "exact",
        "bounded",
        "force evaluations",
        "Newton iterations",
        "ns per step",
    ] {
        assert!(text.contains(part), "{part} is missing from\n{text}");
    }
    let head = text.lines().nth(1).unwrap();
    let column = head.find("must be").unwrap();
    let rows: Vec<&str> = text.lines().skip(2).take(4).collect();
    assert!(rows.iter().all(|row| ["exact", "bounded"].contains(&&row[column..])), "{text}");
    assert_eq!(run.report().evaluations(), run.report().iterations());
    assert!(run.report().elapsed().as_nanos() > 0);
}

/// A step too long throws the bodies of a chain apart: the distance is one of few digits, not of two hundred.
#[test]
fn a_distance_is_told_in_few_digits() {
    let message = |distance| Error::Link { a: 4, b: 5, distance, step: 215, time: 214.0 }.to_string();
    assert!(message(6.25e210).contains("at the distance 6.25e210 is"), "{}", message(6.25e210));
    assert!(message(0.125).contains("at the distance 0.125 is"), "{}", message(0.125));
    assert!(message(0.0).contains("bodies 4 and 5 coincide"), "{}", message(0.0));
}

/// The report in units of any size: numbers of few digits, in columns.
#[test]
fn a_report_in_large_and_small_units_has_few_digits() {
    let report = |scale: f64| {
        let law = crate::common::Kepler::<true> { k: scale };
        let run =
            Simulation::new(law, greenspan_orbit()).mass(scale).scheme(DiscreteGradient).dt(0.01).run(10).unwrap();
        run.to_string()
    };
    for (scale, start) in [(1e33, "-6.715"), (1e-30, "-6.715"), (1.0, "-0.67155000")] {
        let text = report(scale);
        let energy = text.lines().find(|line| line.contains("energy") && !line.contains("work")).unwrap();
        assert!(energy.split_whitespace().nth(1).unwrap().starts_with(start), "{text}");
        let column = text.lines().nth(1).unwrap().chars().count();
        assert!(text.lines().skip(2).take(3).all(|line| line.chars().count() <= column + 4), "{text}");
    }
    // So short that nothing but the time moves.
    let run = Simulation::new(SUN, greenspan_orbit()).scheme(Leapfrog).dt(2.5e-200).run(3).unwrap();
    assert!(run.to_string().starts_with("Leapfrog, order 2, dt = 2.5e-200, 3 steps"), "{run}");
    let error = Error::NotFinite { step: 7, time: 3e300, dt: 1e-300 };
    assert!(error.to_string().starts_with("step 7 from t = 3e300 with dt = 1e-300 led"), "{error}");
    assert!(Error::TimeStep { dt: -1e300 }.to_string().ends_with("not dt = -1e300"));
}

/// Thirty-one digits and more, as many as it takes.
#[test]
fn the_csv_of_double_doubles_reads_back_as_the_same_numbers() {
    let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
    let start = State::of([third, third * third], [-third * third * third, DoubleDouble::from(1.1)]);
    let run = Simulation::new(SUN, start).scheme(Leapfrog).dt(0.1).run(40).unwrap();
    let mut bytes = Vec::new();
    run.write_csv(&mut bytes).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    for (line, state) in text.lines().skip(1).zip(run.states()) {
        let row: Vec<DoubleDouble> = line.split(',').skip(1).map(|x| x.parse().unwrap()).collect();
        assert_eq!(row, [state.q[0], state.q[1], state.v[0], state.v[1]], "{line}");
    }
}
