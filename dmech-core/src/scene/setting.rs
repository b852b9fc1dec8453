//! What a scheme needs to know of a scene beside what acts in it.

use super::builder::Bodies;
use super::terms::Acts;
use super::vectors::Vectors;

/// What acts, and on whom.
#[derive(Clone, Debug)]
pub struct System<const D: usize, A> {
    /// All terms together.
    pub acts: A,
    /// The bodies and the time step.
    pub setting: Setting<D>,
}

impl<const D: usize, A: Acts<D>> System<D, A> {
    /// out ← ∇Φ(q) − F(q, v) at time t.
    pub(super) fn slope(&self, q: &Vectors<D>, v: &Vectors<D>, t: f64, out: &mut Vectors<D>) {
        self.acts.set_gradient(q, t, out);
        self.acts.subtract_force(1.0, q, v, t, out);
    }
}

/// The length of a step, the masses, and who may move.
#[derive(Clone, Debug)]
pub struct Setting<const D: usize> {
    /// h.
    pub dt: f64,
    /// The masses.
    pub masses: Vec<f64>,
    /// h/m for each coordinate, 0 for those of pinned bodies.
    pub kick: Vectors<D>,
    /// Some body is pinned.
    pub pinned: bool,
}

impl<const D: usize> Setting<D> {
    pub(super) fn new<P>(dt: f64, bodies: &Bodies<D, P>) -> Self {
        let mut kick = Vectors::zeros(bodies.masses.len());
        for (i, &mass) in bodies.masses.iter().enumerate() {
            kick.set(i, [dt / mass; D]);
        }
        for &i in &bodies.pins {
            kick.set(i, [0.0; D]);
        }
        Setting { dt, masses: bodies.masses.clone(), kick, pinned: !bodies.pins.is_empty() }
    }

    /// The same bodies and γ times the step; γ may be negative.
    pub fn times(&self, gamma: f64) -> Self {
        let mut other = Setting { dt: gamma * self.dt, ..self.clone() };
        other.kick.flat_mut().iter_mut().for_each(|k| *k *= gamma);
        other
    }

    /// c h/m for each coordinate.
    pub(super) fn g(&self, c: f64) -> Vectors<D> {
        let mut g = self.kick.clone();
        g.flat_mut().iter_mut().for_each(|g| *g *= c);
        g
    }

    /// Σ m v²/2.
    pub fn kinetic_energy(&self, v: &Vectors<D>) -> f64 {
        let squares = v.columns().map(|column| column.iter().zip(&self.masses).map(|(v, m)| m * (v * v)).sum::<f64>());
        0.5 * squares.iter().sum::<f64>()
    }

    /// Σ F·Δq of the force −G that acts on the bodies that move: work on a pinned body is none.
    pub(super) fn work(&self, gradient: &Vectors<D>, moved: impl Fn(usize) -> f64) -> f64 {
        -gradient.flat().iter().enumerate().map(|(i, g)| g * moved(i)).sum::<f64>()
    }
}
