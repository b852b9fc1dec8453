//! Toda's chain, whose waves pass through each other unchanged.

use crate::State;

/// Toda's spring, Φ = (a/b) (e^(−b r) + b r − 1), with r = −d = q_b − q_a.
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `a` > 0 | E/L | greatest pull |
/// | `b` > 0 | 1/L | steepness of the push |
///
/// The positions of a chain are the displacements of its masses from rest, so that r is by how much the spring from a to b,
/// the next on the chain, is longer than at rest. For small r it is a spring of stiffness a b: Φ = a b r²/2 − a b² r³/6 + ….
///
/// # Domain
/// A line; all positions.
/// # Invariants
/// Energy and linear momentum; with pinned ends the energy. A closed or free chain of n masses has n invariants in all
/// (M. Hénon, Phys. Rev. B 9 (1974) 1921; H. Flaschka, ibid. 1924), of which the schemes keep those two.
/// # Source
/// M. Toda, J. Phys. Soc. Jpn. 22 (1967) 431; solitons: 23 (1967) 501.
///
/// ```
/// use dmech::{models::pairs::Toda, prelude::*};
///
/// // A soliton runs along a chain.
/// let (law, kappa, mass) = (Toda { a: 0.8, b: 1.4 }, 0.7, 1.3);
/// let chain = (0..60).fold(Scene::new(), |scene, j| {
///     let at = law.soliton(kappa, mass, f64::from(j) - 20.0, 0.0);
///     scene.body(mass, at.q, at.v)
/// });
/// let run = Simulation::scene(chain.chain(law)).scheme(Nystrom::order6()).dt(0.05).run(200)?;
/// for (j, q) in (0..60).zip(&run.last().q) {
///     assert!((q[0] - law.soliton(kappa, mass, f64::from(j) - 20.0, 10.0).q[0]).abs() < 1e-6);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Toda {
    /// Greatest pull.
    pub a: f64,
    /// Steepness of the push.
    pub b: f64,
}

impl Default for Toda {
    /// a = b = 1.
    fn default() -> Self {
        Toda { a: 1.0, b: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Toda {
    /// Φ = (a/b) (e^(−b r) + b r − 1) with r = −d.
    #[pair]
    pub fn energy(&self, d: f64) -> f64 {
        let s = self.b * d;
        self.a / self.b * (s.exp_m1() - s)
    }
}

impl Toda {
    /// Position and velocity of mass n at time t where a soliton of width 1/κ, κ > 0, runs up an endless chain of equal
    /// masses m; its top passes n = ½ at t = 0.
    ///
    /// With τ_n = 1 + e^(2(κn − ωt)), ω = √(a b/m) sinh κ, q_n = ln(τ_{n−1}/τ_n)/b: behind it the masses are at 0, before it at
    /// −2κ/b, and it advances by the speed ω/κ, faster than sound.
    ///
    /// ```
    /// let law = dmech::models::pairs::Toda { a: 0.8, b: 1.4 };
    /// let (behind, before) = (law.soliton(0.7, 1.3, -40.0, 0.0), law.soliton(0.7, 1.3, 40.0, 0.0));
    /// assert!(behind.q[0].abs() < 1e-14 && (before.q[0] + 1.0).abs() < 1e-14);
    /// ```
    pub fn soliton(&self, kappa: f64, mass: f64, n: f64, t: f64) -> State<1> {
        let omega = (self.a * self.b / mass).sqrt() * kappa.sinh();
        let phase = |n: f64| 2.0 * (kappa * n - omega * t);
        // ln(1 + eˣ) and its derivative, for x of any size.
        let ln_tau = |x: f64| x.max(0.0) + (-x.abs()).exp().ln_1p();
        let slope = |x: f64| (1.0 + (-x).exp()).recip();
        let [last, this] = [phase(n - 1.0), phase(n)];
        let q = (ln_tau(last) - ln_tau(this)) / self.b;
        let v = 2.0 * omega / self.b * (slope(this) - slope(last));
        State::new([q], [v]).at_time(t)
    }
}
