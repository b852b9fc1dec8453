//! Motions whose order can be measured up to 8, and the measurement.

use dmech::prelude::*;

use crate::motion::{MASS, distance};

/// A bowl that grows steeper: central.
#[derive(Clone, Copy, Debug)]
pub struct Bowl {
    pub k: f64,
    pub l: f64,
}

#[dmech::law]
impl Bowl {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let r2 = q[0] * q[0] + q[1] * q[1];
        0.5 * self.k * r2 + 0.25 * self.l * r2 * r2
    }
}

pub const BOWL: Bowl = Bowl { k: 1.2, l: 0.8 };

/// A pendulum whose pivot is shaken: time and position, no velocity.
#[derive(Clone, Copy, Debug)]
pub struct Shaken {
    pub k: f64,
    pub a: f64,
    pub omega: f64,
}

#[dmech::law]
impl Shaken {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        -self.k * q.cos()
    }
    #[force]
    fn shake(&self, q: f64, t: f64) -> f64 {
        self.a * q.cos() * (self.omega * t).sin()
    }
}

pub const SHAKEN: Shaken = Shaken { k: 1.4, a: 0.6, omega: 1.7 };

/// A quartic bowl that pulsates, with air drag and a wind that turns: velocity and time, nonlinear in both.
#[derive(Clone, Copy, Debug)]
pub struct Wind {
    pub k: f64,
    pub drag: f64,
    pub gust: f64,
    pub omega: f64,
}

#[dmech::law]
impl Wind {
    #[potential]
    fn bowl(&self, q: [f64; 2], t: f64) -> f64 {
        0.25 * self.k * (1.3 + (0.7 * t).sin()) * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
    }

    #[force]
    fn drag(&self, q: [f64; 2], v: [f64; 2], t: f64, m: f64) -> [f64; 2] {
        let u = [v[0] - self.gust * (self.omega * t).cos(), v[1] - self.gust * (self.omega * t).sin()];
        let c = self.drag * m * (1.0 + q[0] * q[0]) * (1.1 + u[0] * u[0] + u[1] * u[1]).sqrt();
        [-c * u[0], -c * u[1]]
    }
}

pub const WIND: Wind = Wind { k: 1.7, drag: 0.3, gust: 0.8, omega: 2.3 };

/// How long the motions last whose order is measured.
pub const SPAN: f64 = 4.0;

/// How often the motions are compared on the way: at a single time the leading error may happen to vanish.
pub const LOOKS: u64 = 2;

/// The states at equal distances up to `SPAN`, after so many steps each; `None` where so large a step has no solution.
pub fn path<L: Law<D>, S: Scheme<Particle<L, D>>, const D: usize>(
    law: L,
    scheme: S,
    start: State<D>,
    steps: u64,
) -> Option<Vec<State<D>>> {
    let simulation = Simulation::new(law, start).mass(MASS).scheme(scheme).dt(SPAN / (LOOKS * steps) as f64);
    simulation.record_every(steps).run(LOOKS * steps).ok().map(|run| run.states().to_vec())
}

/// The exponent of h in the error, from the two smallest steps whose errors are clear of rounding.
pub fn measured_order<L, S, const D: usize>(law: L, scheme: S, start: State<D>, exact: &[State<D>]) -> f64
where
    L: Law<D> + Copy,
    S: Scheme<Particle<L, D>>,
{
    order_of(|steps| path(law, scheme, start, steps), exact)
}

/// The same of any motion that is given for a number of steps.
pub fn order_of<const D: usize>(path: impl Fn(u64) -> Option<Vec<State<D>>>, exact: &[State<D>]) -> f64 {
    // Thirty times what the roundings of so many steps add up to.
    let rounding = |steps: f64| 30.0 * 16.0 * f64::EPSILON * (LOOKS as f64 * steps).sqrt();
    let error = |steps| {
        let path = path(steps)?;
        let miss = |(s, exact): (&State<D>, &State<D>)| distance(s.q, exact.q) + distance(s.v, exact.v);
        Some(path.iter().zip(exact).map(miss).fold(0.0, f64::max))
    };
    // Thirds of an octave.
    let ladder = (4..36).map(|i| (f64::from(i) / 3.0).exp2().round() as u64);
    let errors = ladder.filter_map(|steps| Some((steps as f64, error(steps)?)));
    let clear: Vec<(f64, f64)> = errors.take_while(|&(steps, error)| error > rounding(steps)).collect();
    let [.., (many, coarse), (more, fine)] = clear[..] else { panic!("no error is clear of rounding") };
    (coarse / fine).ln() / (more / many).ln()
}
