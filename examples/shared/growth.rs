//! How the error of a conserved quantity grows with the number of steps.
#![allow(dead_code, reason = "the example and the tests use their parts")]

use std::f64::consts::TAU;

use dmech::models::pairs::FermiPastaUlamTsingou;
use dmech::models::{HenonHeiles, Kepler};
use dmech::prelude::*;
use dmech::scene::{Chain, Linked, SceneSystem, Term};
use dmech::scheme::{Method, Scheme};

/// Starts of one motion, whose errors are averaged.
pub(crate) const STARTS: u32 = 8;
/// Steps to a period: no simple fraction, or a planet would come back to where it was, with the same rounding errors.
const STEPS: f64 = 200.618034;
/// At how many states of a run the quantity is looked at.
const LOOKS: u64 = 50;

/// Φ = −gm/√(x² + y²/p²): an attracting mass in a space that is stretched along y.
///
/// No function of the distance unless p = 1, which is not known when code is made of it: a step has two unknowns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretched {
    gm: f64,
    p: f64,
}

#[dmech::law]
impl Stretched {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = [q[0], q[1] / self.p];
        -self.gm / (x * x + y * y).sqrt()
    }
}

type FputChain = <((), Linked<FermiPastaUlamTsingou, Chain>) as Term<1, ()>>::Ready;

/// A scheme that every motion here can be stepped by.
pub(crate) trait Any:
    Scheme<Particle<Kepler, 2>>
    + Scheme<Particle<Stretched, 2>>
    + Scheme<Particle<HenonHeiles, 2>>
    + Scheme<SceneSystem<1, FputChain>>
{
}
impl<S> Any for S where
    S: Scheme<Particle<Kepler, 2>>
        + Scheme<Particle<Stretched, 2>>
        + Scheme<Particle<HenonHeiles, 2>>
        + Scheme<SceneSystem<1, FputChain>>
{
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Motion {
    /// Ellipses of eccentricity 0.3 to 0.65, [`STEPS`] steps to a period.
    Kepler,
    /// The same ellipses, by a law that is not known to be central.
    Components,
    /// Energies about 1/12, h = 0.1.
    HenonHeiles,
    /// Eight bodies between walls, h = 0.1.
    Chain,
}

impl Motion {
    pub(crate) const ALL: [Motion; 4] = [Motion::Kepler, Motion::Components, Motion::HenonHeiles, Motion::Chain];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Motion::Kepler => "Kepler",
            Motion::Components => "Kepler in components",
            Motion::HenonHeiles => "Hénon–Heiles",
            Motion::Chain => "FPUT chain",
        }
    }

    /// How the quantity moves in `steps` steps from one of the starts.
    fn drift<S: Any>(self, scheme: S, invariant: Invariant, start: u32, steps: u64) -> Result<Drift, String> {
        let every = (steps / LOOKS).max(1);
        let x = f64::from(start);
        let drift = match self {
            Motion::Kepler => {
                let (gm, state, period) = ellipse(x);
                let simulation = Simulation::new(Kepler { gm }, state).scheme(scheme).dt(period / STEPS);
                simulation.record_every(every).run(steps).map(|run| run.drift(invariant)).map_err(|e| e.to_string())
            }
            Motion::Components => {
                let (gm, state, period) = ellipse(x);
                let law = Stretched { gm, p: 1.0 };
                let simulation = Simulation::new(law, state).scheme(scheme).dt(period / STEPS);
                simulation.record_every(every).run(steps).map(|run| run.drift(invariant)).map_err(|e| e.to_string())
            }
            Motion::HenonHeiles => {
                let state = State::new([0.05 * (x + 1.0).sin(), -0.1 + 0.03 * x], [0.3 + 0.01 * x, 0.21 - 0.02 * x]);
                let simulation = Simulation::new(HenonHeiles { lambda: 1.0 }, state).scheme(scheme).dt(0.1);
                simulation.record_every(every).run(steps).map(|run| run.drift(invariant)).map_err(|e| e.to_string())
            }
            Motion::Chain => {
                let mut scene = Scene::new();
                for i in 0..10 {
                    let along = std::f64::consts::PI * f64::from(i) / 9.0;
                    let q = if i % 9 == 0 { 0.0 } else { 0.7 * along.sin() + (0.3 - 0.07 * x) * (2.0 * along).sin() };
                    scene = scene.body(1.0, [q], [0.0]);
                }
                let scene = scene.chain(FermiPastaUlamTsingou { k: 1.1, alpha: 0.0, beta: 0.3 }).pin(0).pin(9);
                let simulation = Simulation::scene(scene).scheme(scheme).dt(0.1);
                simulation.record_every(every).run(steps).map(|run| run.drift(invariant)).map_err(|e| e.to_string())
            }
        }?;
        drift.ok_or_else(|| format!("{} has no such invariant", self.name()))
    }

    /// The same from all starts.
    fn drifts<S: Any + Send>(self, scheme: S, invariant: Invariant, steps: u64) -> Result<Vec<Drift>, String> {
        std::thread::scope(|scope| {
            let one = |start| scope.spawn(move || self.drift(scheme, invariant, start, steps));
            let threads: Vec<_> = (0..STARTS).map(one).collect();
            threads.into_iter().map(|thread| thread.join().expect("a run")).collect()
        })
    }

    /// The root mean square over the starts of the largest relative error in so many steps.
    pub(crate) fn error<S: Any + Send>(self, scheme: S, invariant: Invariant, steps: u64) -> Result<f64, String> {
        let drifts = self.drifts(scheme, invariant, steps)?;
        let squares: f64 = drifts.iter().map(|drift| drift.max_relative().powi(2)).sum();
        Ok((squares / f64::from(STARTS)).sqrt())
    }

    /// These errors for numbers of steps from 10² to 10^decades.
    pub(crate) fn growth<S: Any + Send>(
        self,
        scheme: S,
        invariant: Invariant,
        decades: u32,
    ) -> Result<Growth, Box<dyn std::error::Error>> {
        let mut points = Vec::new();
        for half_decade in 4..=2 * decades {
            let steps = 10_f64.powf(0.5 * f64::from(half_decade)).round() as u64;
            points.push((steps as f64, self.error(scheme, invariant, steps)?));
        }
        Ok(Growth { scheme: <S as Method>::NAME, points })
    }
}

/// An ellipse from its apocentre at distance 1.3, turned by an angle that is no simple part of a turn: G M, the start and
/// the period.
fn ellipse(x: f64) -> (f64, State<2>, f64) {
    let (gm, e, angle) = (1.1, 0.3 + 0.05 * x, 0.7 + 1.9 * x);
    let (r, half_axis) = (1.3, 1.3 / (1.0 + e));
    let speed = (gm * (1.0 - e) / r).sqrt();
    let (sin, cos) = angle.sin_cos();
    let period = TAU * (half_axis.powi(3) / gm).sqrt();
    (gm, State::new([r * cos, r * sin], [-speed * sin, speed * cos]), period)
}

/// The error after numbers of steps.
#[derive(Clone, Debug)]
pub(crate) struct Growth {
    pub(crate) scheme: &'static str,
    /// Steps, and the root mean square of the largest errors until then.
    pub(crate) points: Vec<(f64, f64)>,
}

impl Growth {
    /// The points that stand clear of the rounding of a single value, with which the first agrees.
    pub(crate) fn clear(&self) -> &[(f64, f64)] {
        let floor = self.points.first().map_or(0.0, |first| first.1);
        let clear = self.points.iter().rposition(|point| point.1 < 3.0 * floor).map_or(0, |last| last + 1);
        &self.points[clear..]
    }

    /// p of the fit a nᵖ to these points; `None` for less than a decade of them.
    pub(crate) fn exponent(&self) -> Option<f64> {
        let clear = self.clear();
        let (first, last) = (clear.first()?, clear.last()?);
        if last.0 < 9.0 * first.0 {
            return None;
        }
        let logs: Vec<_> = clear.iter().map(|(n, error)| (n.ln(), error.ln())).collect();
        let count = logs.len() as f64;
        let (x, y) = (logs.iter().map(|p| p.0).sum::<f64>() / count, logs.iter().map(|p| p.1).sum::<f64>() / count);
        let over: f64 = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
        let under: f64 = logs.iter().map(|p| (p.0 - x).powi(2)).sum();
        Some(over / under)
    }
}
