//! Greenspan §7: a heavy string of 201 particles that move up and down.
#![allow(dead_code, reason = "each program uses its part")]

use dmech::prelude::*;

/// Δx.
pub(crate) const SPACING: f64 = 0.01;
pub(crate) const PARTICLES: usize = 201;
pub(crate) const MASS: f64 = 0.005;
/// Δt.
pub(crate) const DT: f64 = 0.001;

/// The tension (7.2)–(7.3) between neighbours Δx apart, T = T₀ (1 + s + ε s²) with the slope s = |Δy|/Δx, as a force.
///
/// Its part along y is T Δy/√(Δx² + Δy²) (7.1).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tension {
    /// Distance of neighbours along x.
    pub(crate) dx: f64,
    pub(crate) t0: f64,
    pub(crate) epsilon: f64,
}

#[dmech::law]
impl Tension {
    #[pair_force]
    pub(crate) fn force(&self, d: [f64; 1]) -> [f64; 1] {
        let slope = d[0] / self.dx;
        let s = slope.abs();
        let tension = self.t0 * (1.0 + s + self.epsilon * s * s);
        [-tension * slope / (1.0 + s * s).sqrt()]
    }
}

/// The same as a potential.
///
/// With w = √(1 + s²) the part of the tension along y is T₀ (1 + s + ε s²) s/w, and from
///
/// ```text
/// ∫ s/w ds = w,    ∫ s²/w ds = (s w − asinh s)/2,    ∫ s³/w ds = w³/3 − w
/// ```
///
/// the energy of a spring is T₀ Δx [(w − 1) + (s w − asinh s)/2 + ε (w³/3 − w + 2/3)], 0 when it is level.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spring {
    /// Distance of neighbours along x.
    pub(crate) dx: f64,
    pub(crate) t0: f64,
    pub(crate) epsilon: f64,
}

#[dmech::law]
impl Spring {
    #[pair]
    pub(crate) fn energy(&self, d: [f64; 1]) -> f64 {
        let s = (d[0] / self.dx).abs();
        let w = (1.0 + s * s).sqrt();
        let along = w - 1.0;
        let stiffening = 0.5 * (s * w - s.asinh());
        let second = w.powi(3) / 3.0 - w + 2.0 / 3.0;
        self.t0 * self.dx * (along + stiffening + self.epsilon * second)
    }
}

/// Φ = m g y.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weight {
    pub(crate) g: f64,
}

#[dmech::law]
impl Weight {
    #[potential]
    pub(crate) fn energy(&self, q: f64, m: f64) -> f64 {
        m * self.g * q
    }
}

pub(crate) const TENSION: Tension = Tension { dx: SPACING, t0: 20.0, epsilon: 0.01 };
pub(crate) const SPRING: Spring = Spring { dx: SPACING, t0: 20.0, epsilon: 0.01 };
pub(crate) const WEIGHT: Weight = Weight { g: 32.2 };

/// The string held up in the middle and pinned at both ends: y = x, then y = 2 − x.
///
/// For the second half the paper prints y = −x + 1, which is not the tent of its Figure 7.1 and jumps at x = 1.
pub(crate) fn tent() -> Scene<1> {
    let mut scene = Scene::new();
    for j in 0..PARTICLES {
        let nearer_end = j.min(PARTICLES - 1 - j);
        scene = scene.body(MASS, [nearer_end as f64 * SPACING], [0.0]);
    }
    scene.pin(0).pin(PARTICLES - 1)
}

pub(crate) type Outcome = Result<Run<SceneState<1>>, Interrupted<SceneState<1>>>;

/// The leap-frog formulas (7.4)–(7.6) with the tension as a force.
///
/// # Errors
/// Those of the run.
pub(crate) fn force_form(steps: u64) -> Outcome {
    Simulation::scene(tent().chain(TENSION).field(WEIGHT)).scheme(Leapfrog).dt(DT).run(steps)
}

/// The same with the tension as a potential.
///
/// # Errors
/// Those of the run.
pub(crate) fn potential_form(steps: u64) -> Outcome {
    Simulation::scene(tent().chain(SPRING).field(WEIGHT)).scheme(Leapfrog).dt(DT).run(steps)
}

/// The largest |y_j| difference between two states.
pub(crate) fn difference(a: &SceneState<1>, b: &SceneState<1>) -> f64 {
    a.q.iter().zip(&b.q).map(|([a], [b])| (a - b).abs()).fold(0.0, f64::max)
}

/// The largest |y_j − y_{200−j}|.
pub(crate) fn asymmetry(state: &SceneState<1>) -> f64 {
    let mirrored = state.q.iter().zip(state.q.iter().rev());
    mirrored.map(|([a], [b])| (a - b).abs()).fold(0.0, f64::max)
}

/// The energy of the string by its parts, whichever form was stepped.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Energies {
    pub(crate) kinetic: f64,
    pub(crate) weight: f64,
    pub(crate) springs: f64,
}

impl Energies {
    pub(crate) fn of(state: &SceneState<1>) -> Self {
        Energies {
            kinetic: state.v.iter().map(|[v]| 0.5 * MASS * v * v).sum(),
            // The pinned ends are at height 0.
            weight: state.q.iter().map(|&[y]| WEIGHT.energy(y, MASS)).sum(),
            springs: state.q.windows(2).map(|pair| SPRING.energy([pair[0][0] - pair[1][0]])).sum(),
        }
    }

    pub(crate) fn total(&self) -> f64 {
        self.kinetic + self.weight + self.springs
    }
}
