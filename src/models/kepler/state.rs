//! From elements to states and back.

use core::f64::consts::{PI, TAU};

use super::conic::Place;
use super::elements::{Elements, finite, positive};
use super::error::OrbitError;
use crate::State;

/// Below this part of |q| |v| the angular momentum q × v is what rounding leaves of nothing.
const LOST: f64 = 4.0 * f64::EPSILON;

/// Nearer to the parabola than this, e = √(1 − p/a) has fewer roundings than the eccentricity vector.
const NEAR_PARABOLA: f64 = 0.5;

/// Above this eccentricity the place on the orbit comes from distance and speed, below from the true anomaly.
const NEAR_CIRCLE: f64 = 0.5;

impl Elements {
    /// The elements of the orbit through a state about a sun of strength gm; the pericentre is the nearest in time.
    ///
    /// [`at`](Elements::at) brings the state back to a few ulp. Far out on an orbit that is nearly a parabola, at r ≫ q, the
    /// rounding of e is a part r/q of ulp of the energy, as for everybody who notes pericentre and eccentricity.
    ///
    /// # Errors
    /// [`OrbitError`] where gm is not positive, a component is not finite, or position and velocity are on one line.
    pub fn of(gm: f64, state: &State<3>) -> Result<Elements, OrbitError> {
        positive("strength gm", gm)?;
        finite("time", state.t)?;
        for (x, v) in state.q.into_iter().zip(state.v) {
            finite("position", x)?;
            finite("velocity", v)?;
        }
        let (q, v) = (state.q, state.v);
        let [r, speed] = [length(q), length(v)];
        let momentum = cross(q, v);
        let [angular_momentum, least] = [length(momentum), LOST * r * speed];
        // Nothing moves, or everything overflows: no comparison holds for NaN.
        if !(angular_momentum > least && angular_momentum.is_finite()) {
            return Err(OrbitError::Rectilinear { angular_momentum, least });
        }

        let tilt = momentum[0].hypot(momentum[1]);
        let inclination = tilt.atan2(momentum[2]);
        let node = if tilt == 0.0 { 0.0 } else { turn(momentum[0].atan2(-momentum[1])) };
        let axes = Axes::new(inclination, node, 0.0);
        let latitude = dot(q, axes.across).atan2(dot(q, axes.along));

        let p = angular_momentum * (angular_momentum / gm);
        let radial = dot(q, v);
        let [cos, sin] = [p / r - 1.0, radial / r * (angular_momentum / gm)];
        let over_axis = p * (2.0 / r - speed * (speed / gm));
        let eccentricity = if over_axis.abs() < NEAR_PARABOLA { (1.0 - over_axis).sqrt() } else { cos.hypot(sin) };
        let anomaly = if eccentricity == 0.0 { latitude } else { sin.atan2(cos) };

        let pericentre = p / (1.0 + eccentricity);
        let argument = turn(latitude - anomaly);
        let orbit = Elements { gm, pericentre, eccentricity, inclination, node, argument, passage: 0.0 };
        let conic = orbit.conic();
        let s = if eccentricity > NEAR_CIRCLE {
            conic.at_radius(r / pericentre, radial / (gm * pericentre).sqrt())
        } else {
            conic.at_true(anomaly)
        };
        Ok(Elements { passage: state.t - conic.time(s) / orbit.rate(), ..orbit })
    }

    /// The same for a state of the plane: the inclination is 0, or π where the motion is clockwise, and the node is 0.
    ///
    /// ```
    /// use dmech::{State, models::kepler::Elements};
    ///
    /// let orbit = Elements::of_plane(1.0, &State::new([0.5, 0.0], [0.0, -1.8]))?;
    /// assert_eq!((orbit.inclination, orbit.node, orbit.argument), (core::f64::consts::PI, 0.0, 0.0));
    /// assert!((orbit.eccentricity - 0.62).abs() < 1e-15);
    /// # Ok::<(), dmech::models::kepler::OrbitError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`of`](Elements::of).
    pub fn of_plane(gm: f64, &State { t, q: [x, y], v: [vx, vy] }: &State<2>) -> Result<Elements, OrbitError> {
        Elements::of(gm, &State { t, q: [x, y, 0.0], v: [vx, vy, 0.0] })
    }

    /// The state at time t, by Kepler's equation, to a few ulp for every eccentricity.
    ///
    /// The time since the pericentre is known to the rounding of t and of `passage`: count time from near the motion.
    ///
    /// # Errors
    /// [`OrbitError`] where gm or the pericentre distance is not positive, the eccentricity is negative, or a number is not
    /// finite.
    pub fn at(&self, t: f64) -> Result<State<3>, OrbitError> {
        self.check()?;
        finite("time", t)?;
        let Place { q, v } = self.conic().place(self.since_pericentre(t));
        let Axes { along, across } = Axes::new(self.inclination, self.node, self.argument);
        let speed = (self.gm / self.pericentre).sqrt();
        let in_space = |scale: f64, [x, y]: [f64; 2]| [0, 1, 2].map(|i| scale * (x * along[i] + y * across[i]));
        Ok(State { t, q: in_space(self.pericentre, q), v: in_space(speed, v) })
    }

    /// The state at time t of an orbit in the plane of the first two coordinates.
    ///
    /// # Errors
    /// [`OrbitError::Inclined`] unless the inclination is 0 or π, and those of [`at`](Elements::at).
    pub fn in_plane(&self, t: f64) -> Result<State<2>, OrbitError> {
        let inclination = self.inclination;
        let State { t, q: [x, y, _], v: [vx, vy, _] } = self.at(t)?;
        if inclination != 0.0 && inclination != PI {
            return Err(OrbitError::Inclined { inclination });
        }
        Ok(State { t, q: [x, y], v: [vx, vy] })
    }
}

/// Unit vectors in the plane of an orbit: to a point of it, and a right angle further along the motion.
struct Axes {
    along: [f64; 3],
    across: [f64; 3],
}

impl Axes {
    /// The point is `argument` after the node.
    fn new(inclination: f64, node: f64, argument: f64) -> Self {
        // sin π is not 0 in floating point, and an orbit that runs clockwise is in the plane.
        let (sin_i, cos_i) = if inclination == PI { (0.0, -1.0) } else { inclination.sin_cos() };
        let ((sin_n, cos_n), (sin_a, cos_a)) = (node.sin_cos(), argument.sin_cos());
        let [x, y] = [[cos_n, sin_n, 0.0], [-sin_n * cos_i, cos_n * cos_i, sin_i]];
        Axes {
            along: [0, 1, 2].map(|i| cos_a * x[i] + sin_a * y[i]),
            across: [0, 1, 2].map(|i| cos_a * y[i] - sin_a * x[i]),
        }
    }
}

/// An angle from 0 to 2π, which is 0 again.
fn turn(angle: f64) -> f64 {
    let turned = angle.rem_euclid(TAU);
    if turned < TAU { turned } else { 0.0 }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// hypot does not overflow where the square does.
fn length(a: [f64; 3]) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}

/// Without what cancels: far out q and v are nearly parallel, and the plane must hold both.
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let component = |i: usize, j: usize| {
        // W. Kahan's difference of products.
        let product = a[j] * b[i];
        let lost = (-a[j]).mul_add(b[i], product);
        a[i].mul_add(b[j], -product) + lost
    };
    [component(1, 2), component(2, 0), component(0, 1)]
}
