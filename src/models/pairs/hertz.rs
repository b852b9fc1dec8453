//! Balls that touch and do not stick.

/// Hertz's contact on a line, Φ = k max(d, 0)^(5/2).
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `k` > 0 | E/L^(5/2) | stiffness of the contact |
///
/// The positions of a chain are the displacements of its balls from where they just touch, so that d = q_a − q_b is the
/// overlap of a ball with the next. Of two spheres k follows from their radii and their matter: [`HertzSpheres::on_a_line`].
///
/// # Domain
/// A line; all positions. Φ″ is continuous and Φ‴ is not where a contact opens: there a step has a local error of its own,
/// so that order beyond two does not show, while `DiscreteGradient` keeps the energy all the same.
/// # Invariants
/// Energy and linear momentum.
/// # Source
/// H. Hertz, J. reine angew. Math. 92 (1882) 156; L. D. Landau, E. M. Lifshitz, *Theory of Elasticity*, §9; chains of beads:
/// V. F. Nesterenko, J. Appl. Mech. Tech. Phys. 24 (1983) 733.
///
/// ```
/// use dmech::{models::pairs::Hertz, prelude::*};
///
/// // Newton's cradle: five balls that touch, struck by the first.
/// let balls = (0..5).fold(Scene::new(), |scene, j| scene.body(1.0, [0.0], [if j == 0 { 1.0 } else { 0.0 }]));
/// let run = Simulation::scene(balls.chain(Hertz { k: 400.0 })).scheme(DiscreteGradient).dt(0.002).run(2000)?;
/// assert!(run.last().v[4][0] > 0.98);
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hertz {
    /// Stiffness of the contact.
    pub k: f64,
}

impl Default for Hertz {
    /// k = 1.
    fn default() -> Self {
        Hertz { k: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl Hertz {
    /// Φ = k max(d, 0)^(5/2).
    #[pair]
    pub fn energy(&self, d: f64) -> f64 {
        self.k * d.max(0.0).powf(2.5)
    }
}

impl Hertz {
    /// The force by which balls that overlap by d push each other apart, 5 k max(d, 0)^(3/2)/2.
    ///
    /// ```
    /// let law = dmech::models::pairs::Hertz { k: 0.4 };
    /// assert_eq!((law.force(4.0), law.force(-0.3)), (8.0, 0.0));
    /// ```
    pub fn force(&self, overlap: f64) -> f64 {
        2.5 * self.k * overlap.max(0.0).powf(1.5)
    }

    /// The deepest overlap of two balls of reduced mass μ that meet with the speed u: (μ u²/2k)^(2/5).
    ///
    /// ```
    /// let law = dmech::models::pairs::Hertz { k: 0.7 };
    /// assert!((law.energy(law.deepest(1.3, 0.4)) - 0.5 * 0.4 * 1.3 * 1.3).abs() < 1e-15);
    /// ```
    pub fn deepest(&self, speed: f64, reduced: f64) -> f64 {
        (0.5 * reduced * speed * speed / self.k).powf(0.4)
    }

    /// How long the two touch: 2.943 275… times the deepest overlap over the speed
    /// (Landau and Lifshitz, problem 1 of §9; the number is 4√π Γ(2/5)/(5 Γ(9/10))).
    ///
    /// ```
    /// use dmech::{models::pairs::Hertz, prelude::*};
    ///
    /// let law = Hertz { k: 5.0 };
    /// let touching = law.contact_time(1.3, 0.75);
    /// let balls = Scene::new().body(1.0, [0.0], [1.3]).body(3.0, [0.0], [0.0]).chain(law);
    /// let run = Simulation::scene(balls).scheme(DiscreteGradient).dt(touching / 4000.0).run(4000)?;
    /// // They just touch, and part as fast as they met.
    /// let [overlap, speed] = [&run.last().q, &run.last().v].map(|x| x[0][0] - x[1][0]);
    /// assert!(overlap.abs() < 1e-5 && (speed + 1.3).abs() < 1e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn contact_time(&self, speed: f64, reduced: f64) -> f64 {
        2.943_275_184_324_704_3 * self.deepest(speed, reduced) / speed
    }
}

/// A ball: the data that [`HertzSpheres`] reads, `.body_with(mass, position, velocity, Sphere { radius })`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Radius, > 0.
    pub radius: f64,
}

/// Hertz's contact of spheres, Φ(r) = (8/15) E √(R_a R_b/(R_a + R_b)) max(R_a + R_b − r, 0)^(5/2).
///
/// | parameter | dimension | meaning |
/// |---|---|---|
/// | `modulus` > 0 | E/L³ | effective modulus E |
///
/// 1/E = (1 − ν_a²)/E_a + (1 − ν_b²)/E_b with Young's moduli and Poisson's ratios of the two; of one matter E = E_a/(2 (1 − ν²)).
/// The radii belong to the bodies, which carry a [`Sphere`].
///
/// # Domain
/// r > 0, radii > 0 (two of radius 0 have no law, which is told as one that is not finite) and overlaps that are small beside the
/// radii. Without friction: spheres do not feel how they turn. Seams as those of [`Hertz`].
/// # Invariants
/// Energy, linear and angular momentum.
/// # Source
/// As of [`Hertz`]: Landau and Lifshitz, (9.14) and (9.15).
///
/// ```
/// use dmech::models::pairs::{HertzSpheres, Sphere};
/// use dmech::prelude::*;
///
/// // One ball strikes two others in the plane.
/// let ball = |scene: Scene<2, Sphere>, q, v, radius: f64| scene.body_with(radius.powi(3), q, v, Sphere { radius });
/// let balls = ball(Scene::new(), [-3.0, 0.1], [1.0, 0.0], 1.0);
/// let balls = ball(ball(balls, [0.0, 0.8], [0.0, 0.0], 0.7), [0.0, -1.1], [0.0, 0.0], 1.2);
/// let run = Simulation::scene(balls.pairs(HertzSpheres { modulus: 50.0 })).scheme(DiscreteGradient).dt(0.01).run(1000)?;
/// for kept in [Invariant::Energy, Invariant::AngularMomentum] {
///     assert!(run.drift(kept).unwrap().max_relative() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzSpheres {
    /// Effective modulus.
    pub modulus: f64,
}

impl Default for HertzSpheres {
    /// E = 1.
    fn default() -> Self {
        HertzSpheres { modulus: 1.0 }
    }
}

#[dmech_macros::law(crate = crate)]
impl HertzSpheres {
    /// Φ(r) = (8/15) E √(R_a R_b/(R_a + R_b)) max(R_a + R_b − r, 0)^(5/2).
    #[pair]
    pub fn energy(&self, r: f64, a: &Sphere, b: &Sphere) -> f64 {
        let touching = a.radius + b.radius;
        let stiffness = 8.0 / 15.0 * self.modulus * (a.radius * b.radius / touching).sqrt();
        stiffness * (touching - r).max(0.0).powf(2.5)
    }
}

impl HertzSpheres {
    /// The same for two spheres that move along the line through their centres: k = (8/15) E √(R_a R_b/(R_a + R_b)).
    ///
    /// ```
    /// use dmech::models::pairs::{HertzSpheres, Sphere};
    ///
    /// let law = HertzSpheres { modulus: 3.0 };
    /// let (a, b) = (Sphere { radius: 0.7 }, Sphere { radius: 1.2 });
    /// assert!((law.energy(1.6, &a, &b) - law.on_a_line(a, b).energy(0.3)).abs() < 1e-15);
    /// ```
    pub fn on_a_line(&self, a: Sphere, b: Sphere) -> Hertz {
        Hertz { k: 8.0 / 15.0 * self.modulus * (a.radius * b.radius / (a.radius + b.radius)).sqrt() }
    }
}
