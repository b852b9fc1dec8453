//! A charged particle in magnetic fields, and what is measured of its motion.

use std::f64::consts::TAU;

use dmech::prelude::*;

/// A uniform field B e_z in space: F = b v × e_z with b = charge · B.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Uniform {
    /// Charge times field.
    pub(crate) b: f64,
}

#[dmech::law]
impl Uniform {
    #[force]
    fn lorentz(&self, v: [f64; 3]) -> [f64; 3] {
        [self.b * v[1], -self.b * v[0], 0.0]
    }
}

/// A field across the plane that grows with x: F = b (1 + x/length) v × e_z.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Graded {
    /// Charge times field at x = 0.
    pub(crate) b: f64,
    /// The way over which the field grows by its value at x = 0.
    pub(crate) length: f64,
}

#[dmech::law]
impl Graded {
    #[force]
    fn lorentz(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let b = self.b * (1.0 + q[0] / self.length);
        [b * v[1], -b * v[0]]
    }
}

/// Crossed fields: E along x as a potential, B across the plane as a force.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossed {
    /// Charge times magnetic field.
    pub(crate) b: f64,
    /// Charge times electric field.
    pub(crate) e: f64,
}

#[dmech::law]
impl Crossed {
    #[potential]
    fn electric(&self, q: [f64; 2]) -> f64 {
        -self.e * q[0]
    }
    #[force]
    fn lorentz(&self, v: [f64; 2]) -> [f64; 2] {
        [self.b * v[1], -self.b * v[0]]
    }
}

pub(crate) const MASS: f64 = 1.3;
pub(crate) const UNIFORM: Uniform = Uniform { b: 2.1 };
pub(crate) const GRADED: Graded = Graded { b: 2.1, length: 4.0 };
pub(crate) const CROSSED: Crossed = Crossed { b: 2.1, e: 0.4 };
/// In the plane with a speed of 1.5, and a slow motion along the field in space.
pub(crate) const IN_SPACE: State<3> = State::new([0.3, -0.2, 0.0], [0.9, 1.2, 0.25]);
pub(crate) const IN_THE_PLANE: State<2> = State::new([0.3, -0.2], [0.9, 1.2]);
pub(crate) const SPEED: f64 = 1.5;

/// A circle in the uniform field.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Circle {
    pub(crate) radius: f64,
    pub(crate) period: f64,
}

impl Circle {
    /// m v/b and 2π m/b.
    pub(crate) fn exact() -> Self {
        Circle { radius: MASS * SPEED / UNIFORM.b, period: TAU * MASS / UNIFORM.b }
    }

    /// Half the width of the orbit, and the time over the turns that the velocity has made.
    pub(crate) fn measured(states: &[State<3>]) -> Self {
        let (mut low, mut high, mut turns) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
        for pair in states.windows(2) {
            low = low.min(pair[1].q[0]);
            high = high.max(pair[1].q[0]);
            // The velocity turns clockwise; it comes round where its angle with the first one falls through zero.
            let [before, after] = [pair[0].v, pair[1].v].map(|v| clockwise(states[0].v, v));
            turns += f64::from(before < 0.0 && after >= 0.0);
        }
        let last = states[states.len() - 1];
        let turns = turns + clockwise(states[0].v, last.v).rem_euclid(TAU) / TAU;
        Circle { radius: 0.5 * (high - low), period: (last.t - states[0].t) / turns }
    }

    /// What the energy-exact step, and the implicit one, make of it: with ω = b/m they turn the velocity by
    /// 2 atan(ωh/2) where ωh is due, on a circle of just the right radius.
    pub(crate) fn of_the_step(h: f64) -> Self {
        let exact = Circle::exact();
        let turn = 2.0 * (0.5 * h * UNIFORM.b / MASS).atan();
        Circle { radius: exact.radius, period: TAU * h / turn }
    }
}

/// The angle in the plane from u clockwise to v, between −π and π.
fn clockwise(u: [f64; 3], v: [f64; 3]) -> f64 {
    (u[1] * v[0] - u[0] * v[1]).atan2(u[0] * v[0] + u[1] * v[1])
}

/// The mean velocity with which the centres of gyration move, q + (m/b) (v_y, −v_x) with the b of the place.
pub(crate) fn drift(first: &State<2>, last: &State<2>, b: impl Fn([f64; 2]) -> f64) -> [f64; 2] {
    let centre = |state: &State<2>| {
        let arm = MASS / b(state.q);
        [state.q[0] + arm * state.v[1], state.q[1] - arm * state.v[0]]
    };
    let (from, to, time) = (centre(first), centre(last), last.t - first.t);
    [(to[0] - from[0]) / time, (to[1] - from[1]) / time]
}

/// The drift along y in the graded field, to first order in radius/length: ½ v² (m/b) ∇b/b at the centre of gyration.
pub(crate) fn graded_drift(start: &State<2>) -> f64 {
    let field = |x: f64| GRADED.b * (1.0 + x / GRADED.length);
    // The centre is where the arm of gyration, drawn with the field at its end, leads; once more with the field there.
    let near = start.q[0] + MASS / field(start.q[0]) * start.v[1];
    let b = field(near);
    0.5 * SPEED * SPEED * MASS / b * (GRADED.b / GRADED.length) / b
}
