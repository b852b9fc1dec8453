//! The five motions: starts, ends, and where they end.

use crate::recommended::Kind;
use std::f64::consts::{FRAC_PI_4, PI};

use dmech::prelude::State;

use crate::ends;
use crate::motion::{Eight, Fput, Planet, Swing};

/// A motion from a start at t = 0 to an end.
#[derive(Clone, Copy, Debug)]
pub struct Problem<M, const D: usize> {
    /// In names of files.
    pub name: &'static str,
    /// In tables and pictures.
    pub title: &'static str,
    /// The force.
    pub motion: M,
    /// The start.
    pub start: State<D>,
    /// The end.
    pub end: f64,
    /// The position at the end.
    pub truth: [f64; D],
    /// The longest step that is tried.
    pub coarse: f64,
    /// What the advice depends on.
    pub kind: Kind,
}

/// Greenspan's planet, 87 revolutions on an ellipse of eccentricity 0.33.
pub fn orbit() -> Problem<Planet, 2> {
    Problem {
        name: "orbit",
        title: "Greenspan's orbit to t = 350",
        motion: Planet,
        start: State::new([0.5, 0.0], [0.0, 1.63]),
        end: 350.0,
        truth: ends::ORBIT,
        coarse: 1.0,
        kind: Kind::Even,
    }
}

/// 100 periods of an ellipse of eccentricity 0.9 from its apocentre, which is where they end; major half-axis 1.
pub fn eccentric() -> Problem<Planet, 2> {
    Problem {
        name: "eccentric",
        title: "Kepler, e = 0.9, 100 periods from apocentre",
        motion: Planet,
        start: State::new([-1.9, 0.0], [0.0, -(0.1_f64 / 1.9).sqrt()]),
        end: 200.0 * PI,
        truth: ends::ECCENTRIC,
        coarse: 1.0,
        kind: Kind::Encounters,
    }
}

/// The pendulum from π/4 at rest.
pub fn pendulum() -> Problem<Swing, 1> {
    Problem {
        name: "pendulum",
        title: "Pendulum from π/4 to t = 100",
        motion: Swing,
        start: State::new([FRAC_PI_4], [0.0]),
        end: 100.0,
        truth: ends::PENDULUM,
        coarse: 4.0,
        kind: Kind::Even,
    }
}

/// Three bodies on a figure of eight, 15.8 times around.
///
/// A. Chenciner, R. Montgomery, Ann. Math. 152 (2000) 881–901, digits by C. Simó.
pub fn eight() -> Problem<Eight, 6> {
    let (q, v) = ([0.97000436, -0.24308753], [-0.93240737, -0.86473146]);
    let half = [-0.5 * v[0], -0.5 * v[1]];
    Problem {
        name: "eight",
        title: "Figure-eight of three bodies to t = 100",
        motion: Eight,
        start: State::new([q[0], q[1], -q[0], -q[1], 0.0, 0.0], [half[0], half[1], half[0], half[1], v[0], v[1]]),
        end: 100.0,
        truth: ends::EIGHT,
        coarse: 1.0,
        kind: Kind::Even,
    }
}

/// The β chain of Fermi, Pasta, Ulam and Tsingou with 64 moving masses, β = 0.3, from rest in half a sine of amplitude 10.
pub fn fput() -> Problem<Fput, 64> {
    Problem {
        name: "fput",
        title: "FPUT chain of 64 masses, β = 0.3, to t = 1000",
        motion: Fput { beta: 0.3 },
        start: State::new(core::array::from_fn(|j| 10.0 * (PI * (j + 1) as f64 / 65.0).sin()), [0.0; 64]),
        end: 1000.0,
        truth: ends::FPUT,
        coarse: 4.0,
        kind: Kind::Many,
    }
}
