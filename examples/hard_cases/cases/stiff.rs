//! A stiff spring beside a soft one.

use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Line, Picture, Scale, rounding, short};

/// Two bodies in the plane: the first on a spring from the origin, the second on a spring from the first, both of length 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TwoSprings {
    pub(crate) stiff: f64,
    pub(crate) soft: f64,
}

#[dmech::law]
impl TwoSprings {
    #[potential]
    fn energy(&self, q: [f64; 4]) -> f64 {
        let [x, y, u, w] = q;
        let inner = (x * x + y * y).sqrt() - 1.0;
        let outer = ((u - x) * (u - x) + (w - y) * (w - y)).sqrt() - 1.0;
        0.5 * self.stiff * inner * inner + 0.5 * self.soft * outer * outer
    }
}

const LAW: TwoSprings = TwoSprings { stiff: 1e8, soft: 1.7 };

pub(crate) fn case(length: Length) -> Case {
    let mut case = Case::new(
        "stiff",
        "A body on a spring of stiffness 1e8, another hung from it on one of 1.7, both turning",
        "The stiff spring swings 330 to 5000 times within a step. J. C. Simo and O. Gonzalez (Comput. Methods Appl. Mech. Eng. 134 (1996) 197) found the midpoint rule unstable there, and energy-momentum schemes not.",
        "DiscreteGradient and its compositions keep the energy, hence the strain below √(2E/K); leap-frog blows up and says so, the trapezoid (Implicit) turns unstable as the step grows.",
        &["strain", "kinetic"],
    );
    let start = State::new([1.0, 0.0, 2.1, 0.3], [0.0, 0.7, 0.2, 1.1]);
    let end = length.of(200.0, 1000.0);
    for dt in [0.02, 0.1, 0.3] {
        let motion = Motion::until(LAW, start, end, (end / dt) as u64);
        let trials = every_scheme!(positions: motion);
        for trial in &trials {
            measure(&mut case, trial);
        }
        if dt == 0.1 {
            case.pictures.push(picture(&trials));
        }
    }
    let energy = |case: &Case, name: &str| {
        let rows = case.rows.iter().filter(|row| row.scheme == name);
        rows.map(|row| row.energy).fold(0.0_f64, |a, b| if a > b { a } else { b })
    };
    // Not below, but above: the trapezoid is to fail where the energy-exact step does not.
    let failure = -energy(&case, "Implicit");
    case.check("Implicit: minus its largest energy error", failure, -0.5);
    case
}

fn strain(state: &State<4>) -> f64 {
    (state.q[0].hypot(state.q[1]) - 1.0).abs()
}

fn measure(case: &mut Case, trial: &Trial<State<4>>) {
    let Trial { scheme, dt, .. } = *trial;
    let strain = trial.states().map(strain).fold(0.0, f64::max);
    let kinetic = trial.largest_kinetic_energy();
    // One Newton correction δ is taken as enough when (δ/Δ)² is a 64th of an ulp, with Δ = q′ − q: the force is supposed
    // to vary over lengths no shorter than the step. This one turns with the direction of the spring, by K δ²/2r, and does
    // work along Δ. Errors of steps are independent of each other.
    let step = dt * (2.0 * kinetic).sqrt();
    let neglected = f64::EPSILON / 128.0 * LAW.stiff * step.powi(3) * (trial.run.steps() as f64).sqrt();
    let keeps = trial.run.kept(Invariant::Energy) == Kept::Exact;
    let most = rounding(trial.run.steps()) + neglected;
    // Kanatani's start, h² a/2 back from the first position, is itself a stretch of the stiff spring.
    case.row_within(trial, vec![short(strain), short(kinetic)], if keeps { most } else { f64::INFINITY });
    if keeps {
        let energy = trial.run.drift(Invariant::Energy).map_or(f64::NAN, |drift| drift.start());
        case.check(format!("{scheme} at dt = {dt}: strain"), strain, (2.0 * energy / LAW.stiff).sqrt());
        case.check(format!("{scheme} at dt = {dt}: steps missing"), (trial.asked - trial.run.steps()) as f64, 0.0);
    }
}

fn picture(trials: &[Trial<State<4>>]) -> Picture {
    let drawn = ["Leapfrog", "Implicit", "DiscreteGradient"];
    let lines = drawn.iter().filter_map(|name| {
        let trial = trials.iter().find(|trial| trial.scheme == *name)?;
        let mut largest = 1e-17_f64;
        let start =
            LAW.energy(trial.run.states()[0].q) + 0.5 * trial.run.states()[0].v.map(|v| v * v).iter().sum::<f64>();
        let errors = trial.run.states().iter().skip(1).map(|s| {
            let energy = LAW.energy(s.q) + 0.5 * s.v.map(|v| v * v).iter().sum::<f64>();
            largest = largest.max((energy / start - 1.0).abs());
            ((s.t / trial.dt).log10(), largest.log10())
        });
        Some(Line::new(trial, errors.take(2000).collect()))
    });
    Picture {
        name: "hard_stiff",
        title: format!("A spring of stiffness 10⁸ beside one of 1.7, dt = {}: the largest energy error so far", trials[0].dt),
        words: vec!["The exact energy error is 0. DiscreteGradient keeps the energy to rounding; Leapfrog blows up in a few steps;".to_owned(), "Implicit, the trapezoid, loses it after a hundred.".to_owned()],
        x: Scale::powers("steps", 0.0, 2000_f64.log10()),
        y: Scale::powers("|E − E₀| / E₀", -17.0, 12.0),
        lines: lines.collect(),
        behind: None,
    }
}
