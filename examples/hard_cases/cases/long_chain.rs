//! A chain of Fermi, Pasta, Ulam and Tsingou for ten million steps.

use std::f64::consts::PI;

use dmech::models::pairs::FermiPastaUlamTsingou;
use dmech::prelude::*;

use super::trial::{Together, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, short};

const SPRINGS: usize = 9;
const SPRING: FermiPastaUlamTsingou = FermiPastaUlamTsingou { k: 1.0, alpha: 0.25, beta: 0.4 };

pub(crate) fn case(length: Length) -> Case {
    let mut case = Case::new(
        "long_chain",
        "Eight masses of Fermi, Pasta, Ulam and Tsingou for ten million steps (compositions: half a million)",
        "Nothing is hard in a step; but an error that always has the same sign, however small, is ten million times as large at the end.",
        "The energy of DiscreteGradient, its compositions and Kanatani (its own) is kept to what n steps may lose by rounding, (64 + 4√n) ulps, and that of leap-frog and the trapezoid stays within its bound; `Explicit` ends with an error.",
        &["drift", "ns/step"],
    );
    let mut scene = Scene::new();
    for j in 0..=SPRINGS {
        let shape = if j == SPRINGS { 0.0 } else { (PI * j as f64 / SPRINGS as f64).sin() };
        scene = scene.body(1.0, [1.3 * shape], [0.0]);
    }
    let scene = scene.pin(0).pin(SPRINGS).chain(SPRING);
    let motion =
        |steps: u64| Together { scene: scene.clone(), masses: vec![1.0], dt: 0.1, steps, record_every: steps / 2000 };
    let shorter = motion(length.of(40_000, 500_000));
    let mut trials = every_scheme!(positions: shorter);
    if length == Length::Whole {
        let long = motion(10_000_000);
        for trial in &mut trials {
            match trial.scheme {
                "Leapfrog" => *trial = long.by(Leapfrog),
                "Implicit" => *trial = long.by(Implicit),
                "DiscreteGradient" => *trial = long.by(DiscreteGradient),
                "Kanatani" => *trial = long.by(Kanatani),
                _ => {}
            }
        }
    }
    for trial in &trials {
        measure(&mut case, trial);
    }
    case.pictures.push(picture(&trials));
    case
}

fn measure(case: &mut Case, trial: &Trial<SceneState<1>>) {
    let own = [Invariant::DiscreteEnergy, Invariant::Energy].into_iter().find_map(|energy| trial.run.drift(energy));
    let drift = own.map_or(f64::NAN, |drift| drift.slope() * trial.run.last().t / drift.start());
    let per_step = trial.run.report().elapsed().as_nanos() as f64 / trial.run.steps() as f64;
    case.row(trial, vec![short(drift), short(per_step)]);
    if !trial.exact_energy() && trial.scheme != "Explicit" {
        let error = trial.energy_error();
        case.check(format!("{}: drift, of its largest error", trial.scheme), drift.abs(), 0.1 * error + 1e-11);
    }
}

fn energy(state: &SceneState<1>) -> f64 {
    let kinetic: f64 = state.v.iter().map(|[v]| 0.5 * v * v).sum();
    kinetic + state.q.windows(2).map(|pair| SPRING.energy(pair[0][0] - pair[1][0])).sum::<f64>()
}

fn picture(trials: &[Trial<SceneState<1>>]) -> Picture {
    let drawn = ["Leapfrog", "Implicit", "DiscreteGradient"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        let (start, mut largest) = (energy(&trial.run.states()[0]), 1e-17_f64);
        let errors = trial.run.states().iter().skip(1).map(|state| {
            largest = largest.max((energy(state) / start - 1.0).abs());
            ((state.t / trial.dt).log10(), largest.log10())
        });
        Some(Line::new(trial, errors.collect()))
    });
    let last = (trials[3].asked as f64).log10();
    Picture {
        name: "hard_long_chain",
        title: "Eight masses of Fermi, Pasta, Ulam and Tsingou, dt = 0.1: the largest energy error so far".to_owned(),
        words: vec![
            "DiscreteGradient keeps the energy to rounding over ten million steps;".to_owned(),
            "Leapfrog and Implicit keep it within a bound that does not grow.".to_owned(),
        ],
        x: Scale::powers("steps", 3.5, last),
        y: Scale::powers("|E − E₀| / E₀", -17.0, -1.0),
        lines: lines.collect(),
        behind: None,
    }
}
