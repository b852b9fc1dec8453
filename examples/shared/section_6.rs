//! Greenspan §6: three molecules in the plane.
#![allow(dead_code, reason = "each program uses its part")]

use dmech::prelude::*;

/// Greenspan (6.8)–(6.13), m = 3: the acceleration of a by b is m_b (−G/r² + H/r³ − α |v_a|) along the separation.
///
/// The last term is called viscous damping. It acts along the separation, not against the velocity, and depends on the
/// speed of a alone: b pulls a the stronger the faster a moves, and is not pulled as strongly back.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Molecular {
    pub(crate) g: f64,
    pub(crate) h: f64,
    pub(crate) alpha: f64,
}

#[dmech::law]
impl Molecular {
    #[pair_force]
    fn force(&self, d: [f64; 2], va: [f64; 2], ma: f64, mb: f64) -> [f64; 2] {
        let r = (d[0] * d[0] + d[1] * d[1]).sqrt();
        let speed = (va[0] * va[0] + va[1] * va[1]).sqrt();
        let f = ma * mb * (-self.g / r.powi(2) + self.h / r.powi(3) - self.alpha * speed) / r;
        [f * d[0], f * d[1]]
    }
}

/// Δt.
pub(crate) const DT: f64 = 0.01;
pub(crate) const MASS: f64 = 10.0;

pub(crate) const LAW: Molecular = Molecular { g: 1.0, h: 1.0, alpha: 0.08 };

/// The molecules at the start.
pub(crate) fn molecules() -> Scene<2> {
    Scene::new().body(MASS, [0.0, 100.0], [0.0, -10.0]).body(MASS, [100.0, 0.0], [-10.0, 0.0]).body(
        MASS,
        [-100.0, 0.0],
        [1.0, 0.0],
    )
}

pub(crate) type Outcome = Result<Run<SceneState<2>>, Interrupted<SceneState<2>>>;

/// The implicit formulas (6.1)–(6.7).
///
/// # Errors
/// Those of the run.
pub(crate) fn implicit(newton: Newton, steps: u64) -> Outcome {
    Simulation::scene(molecules().pairs(LAW)).scheme(Implicit.with(newton)).dt(DT).run(steps)
}

/// Σ m v²/2.
pub(crate) fn kinetic_energy(state: &SceneState<2>) -> f64 {
    0.5 * MASS * state.v.as_flattened().iter().map(|v| v * v).sum::<f64>()
}
