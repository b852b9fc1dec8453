//! Invariants that a law declares itself.

use dmech::prelude::*;
use dmech::{
    Error,
    models::{DampedPendulum, Kepler},
};

/// A planet, with what no scheme knows of it; the perturbation c/r³ turns its pericentre.
#[derive(Clone, Copy, Debug)]
struct Planet {
    gm: f64,
    c: f64,
}

#[dmech::law]
impl Planet {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let r2 = q[0] * q[0] + q[1] * q[1];
        -self.gm / r2.sqrt() - self.c / (r2 * r2.sqrt())
    }

    /// Along the pericentre.
    #[invariant]
    fn laplace_runge_lenz(&self, q: [f64; 2], v: [f64; 2]) -> f64 {
        v[1] * self.swept(q, v) - self.gm * q[0] / q[0].hypot(q[1])
    }

    #[invariant]
    fn area(&self, q: [f64; 2], v: [f64; 2]) -> f64 {
        0.5 * self.swept(q, v)
    }

    fn swept(&self, q: [f64; 2], v: [f64; 2]) -> f64 {
        q[0] * v[1] - q[1] * v[0]
    }
}

const START: State<2> = State::new([0.5, 0.0], [0.0, 1.63]);

#[test]
fn a_run_watches_them() -> Result<(), Box<dyn std::error::Error>> {
    let law = Planet { gm: 1.0, c: 0.0 };
    let run = Simulation::new(law, START).scheme(Nystrom::order6()).dt(0.01).run_until(50.0)?;
    let [vector, area] = ["laplace_runge_lenz", "area"].map(|name| run.drift_of(name).unwrap());
    assert_eq!(vector.start(), law.laplace_runge_lenz(START.q, START.v));
    assert_eq!((vector.last(), vector.samples()), (law.laplace_runge_lenz(run.last().q, run.last().v), 5001));
    assert!(vector.max_relative() < 1e-6, "{vector:?}");
    assert!(area.max_relative() < 1e-13 && area.start() == 0.5 * 0.5 * 1.63, "{area:?}");
    assert!(run.drift_of("energy").is_none() && run.drift_of("swept").is_none());
    let names: Vec<_> = run.report().own_drifts().map(|(name, _)| name).collect();
    assert_eq!(names, ["laplace_runge_lenz", "area"]);

    let turned =
        Simulation::new(Planet { c: 0.01, ..law }, START).scheme(Nystrom::order6()).dt(0.01).run_until(50.0)?;
    assert!(turned.drift_of("laplace_runge_lenz").unwrap().max_relative() > 0.1);
    assert!(turned.drift_of("area").unwrap().max_relative() < 1e-13);
    assert!(law.derivation().contains("area = 0.5·("), "{}", law.derivation());
    Ok(())
}

#[test]
fn the_report_shows_them() -> Result<(), Box<dyn std::error::Error>> {
    let report = |text: String| text.lines().map(str::to_owned).collect::<Vec<_>>();
    let law = Planet { gm: 1.0, c: 0.0 };
    let own = report(Simulation::new(law, START).scheme(DiscreteGradient).dt(0.01).run(10)?.to_string());
    let line = own.iter().find(|line| line.contains("laplace runge lenz")).unwrap();
    let heading = own.iter().find(|line| line.contains("must be")).unwrap();
    assert!(line.ends_with("  –") && line.chars().count() == heading.chars().count() - 6, "{own:#?}");
    let none =
        report(Simulation::new(Kepler { gm: 1.0 }, START).scheme(DiscreteGradient).dt(0.01).run(10)?.to_string());
    assert_eq!(own.len(), none.len() + 2);
    Ok(())
}

/// A constant of one's own that the macro takes for that of `std`.
mod consts {
    pub(super) const PI: f64 = 3.0;
}

#[derive(Clone, Copy, Debug)]
struct Disguised {
    k: f64,
}

#[dmech::law]
impl Disguised {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        0.5 * self.k * q * q
    }

    #[invariant]
    fn kept(&self, q: f64, v: f64) -> f64 {
        consts::PI * (0.5 * v * v + self.energy(q))
    }
}

#[test]
fn what_is_watched_is_what_is_written() {
    let simulation = Simulation::new(Disguised { k: 1.7 }, State::new([0.4], [0.3])).scheme(Leapfrog);
    let error = simulation.dt(0.1).run(1).unwrap_err().cause();
    let Error::NotAsWritten(difference) = error else { panic!("{error}") };
    assert_eq!((difference.quantity(), difference.written()), ("kept", 3.0 * (0.045 + 0.5 * 1.7 * 0.4 * 0.4)));
}

/// A spring whose rest position moves: what it keeps names the time, and has more digits than `f64`.
#[derive(Clone, Copy, Debug)]
struct Moving {
    k: f64,
    speed: f64,
}

#[dmech::law]
impl Moving {
    #[potential]
    fn energy(&self, q: f64, t: f64) -> f64 {
        0.5 * self.k * (q - self.speed * t).powi(2)
    }

    #[invariant]
    fn energy_beside(&self, q: f64, v: f64, t: f64) -> f64 {
        0.5 * (v - self.speed).powi(2) + self.energy(q, t)
    }
}

#[test]
fn they_may_name_the_time_in_any_scalar() -> Result<(), Box<dyn std::error::Error>> {
    let law = Moving { k: 1.5, speed: 0.25 };
    let run = Simulation::new(law, State::new([1.0], [0.5])).scheme(Composed::order8(Leapfrog)).dt(0.0625).run(100)?;
    assert!(run.drift(Invariant::Energy).is_none());
    assert!(run.drift_of("energy_beside").unwrap().max_relative() < 1e-9);

    let start = State::of([DoubleDouble::from(1.0)], [DoubleDouble::from(0.5)]);
    let run = Simulation::new(law, start).scheme(Composed::order8(Leapfrog)).dt(0.0078125).run(100)?;
    let drift = run.drift_of("energy_beside").unwrap();
    assert!(drift.max_relative() > 0.0 && drift.max_relative() < 1e-17, "{drift:?}");

    let heavy = Simulation::new(Planet { gm: 1.0, c: 0.0 }, START)
        .masses([1.0, 1.0])
        .scheme(DiscreteGradient)
        .dt(0.01)
        .run(10)?;
    assert!(heavy.drift_of("area").unwrap().max_relative() < 1e-14);
    Ok(())
}

/// Quantities that a run watches, beside those that a law declares, on a scene, in a stream and where the run is stopped.
#[test]
fn quantities_are_watched() -> Result<(), Box<dyn std::error::Error>> {
    let law = Planet { gm: 1.0, c: 0.0 };
    let sum = |state: &State<2>| state.q[0] + state.q[1];
    let mut looks = 0;
    let run = Simulation::new(law, START)
        .scheme(Leapfrog)
        .dt(0.01)
        .record_every(10)
        .watch("sum", sum)
        .watch("looks", |_| {
            looks += 1;
            f64::from(looks)
        })
        .run(105)?;
    let drift = run.drift_of("sum").unwrap();
    assert_eq!((drift.start(), drift.last(), drift.samples()), (sum(&START), sum(run.last()), 12));
    let farthest = run.states().iter().chain([run.last()]).map(|state| (sum(state) - sum(&START)).abs());
    assert_eq!(drift.max_abs(), farthest.fold(0.0, f64::max));
    assert_eq!(run.drift_of("looks").unwrap().last(), 12.0);
    let names: Vec<_> = run.report().own_drifts().map(|(name, _)| name).collect();
    assert_eq!(names, ["laplace_runge_lenz", "area", "sum", "looks"]);
    assert!(run.to_string().contains("\n  sum "), "{run}");

    // A scene: the distance of two bodies on a circle, which a stop leaves at the state of the stop.
    let scene = Scene::new().body(1.0, [0.5, 0.0], [0.0, 0.5]).body(1.0, [-0.5, 0.0], [0.0, -0.5]);
    let scene = scene.pairs(dmech::models::pairs::Gravity { g: 0.5 });
    let distance = |state: &SceneState<2>| (state.q[0][0] - state.q[1][0]).hypot(state.q[0][1] - state.q[1][1]);
    let mut table = Vec::new();
    let run = Simulation::scene(scene)
        .scheme(Nystrom::order6())
        .dt(0.05)
        .watch("distance", distance)
        .stop_when(|state| state.t - 3.21, Crossing::Rising)
        .watch("time", |state| state.t)
        .stream(Csv::new(&mut table))
        .run(1000)?;
    let [distance, time] = ["distance", "time"].map(|name| run.drift_of(name).unwrap());
    assert!(distance.max_abs() < 1e-9 && distance.samples() > 60, "{distance:?}");
    assert!((time.last() - 3.21).abs() < 1e-13 && run.stopped());
    assert!(run.states().is_empty());
    Ok(())
}

/// The columns are as wide as the longest name.
#[test]
fn columns_hold_long_names() {
    let name = "the distance of the planet from its pericentre";
    let planet = Simulation::new(Planet { gm: 1.0, c: 0.0 }, START).scheme(Leapfrog).dt(0.01);
    let table = planet.watch(name, |state| state.q[0] - 0.5).run(10).unwrap().to_string();
    let ends: Vec<_> = table.lines().skip(1).take(8).map(|line| line.split_at(2 + name.len() + 1 + 22).0).collect();
    assert!(ends[0].ends_with("at the start") && ends[7].ends_with(" 10"), "{table}");
    assert!(ends[1..7].iter().all(|line| line.ends_with(|digit: char| digit.is_ascii_digit())), "{table}");
}

/// A name says which quantity it is: given twice, or to one of the law's own, it is refused before the first step.
#[test]
fn a_name_is_given_once() {
    let planet = || Simulation::new(Planet { gm: 1.0, c: 0.0 }, START).scheme(Leapfrog).dt(0.01);
    let refused = |name| Error::WatchedTwice { name };
    let twice =
        planet().watch("x", |state| state.q[0]).stop_when(|_| -1.0, Crossing::Any).watch("x", |state| state.v[0]);
    let ended = twice.run(10).unwrap_err();
    assert_eq!((ended.cause(), ended.run().steps()), (refused("x"), 0));
    assert_eq!(planet().watch("area", |state| state.t).run(10).unwrap_err().cause(), refused("area"));
    // What the law does not watch is free, as the energy of a damped law is.
    assert!(planet().watch("swept", |state| state.t).run(10).unwrap().drift_of("swept").is_some());
    let damped = Simulation::new(DampedPendulum { k: 1.7, alpha: 0.2 }, State::new([1.0], [0.0]));
    let free = damped.scheme(DiscreteGradient).dt(0.1).watch("energy", |state| state.v[0]).run(10).unwrap();
    assert!(free.drift_of("energy").is_some());
    // What it does watch is not, in either way to write it: the report would have two lines of the name.
    for name in ["energy", "angular momentum", "angular_momentum", "kinetic energy - work"] {
        assert_eq!(planet().watch(name, |state| state.t).run(10).unwrap_err().cause(), refused(name));
    }

    let body = Scene::<1>::new().body(1.0, [0.0], [0.5]);
    let scene = Simulation::scene(body).scheme(Leapfrog).dt(0.1).watch("x", |_| 0.0).watch("x", |_| 1.0);
    assert_eq!(scene.run(10).unwrap_err().cause(), refused("x"));
    let ensemble = Ensemble::over((0..9).map(|_| (Planet { gm: 1.0, c: 0.0 }, START))).scheme(Leapfrog).dt(0.01);
    let members = ensemble.with(|k, alone| {
        alone.watch("x", |state: &State<2>| state.q[0]).watch(if k == 4 { "x" } else { "y" }, |state| state.q[1])
    });
    for (k, member) in members.run(10).unwrap().members().enumerate() {
        let watched = member.map(|run| run.report().own_drifts().count()).map_err(|ended| ended.cause());
        assert_eq!(watched, if k == 4 { Err(refused("x")) } else { Ok(4) }, "{k}");
    }
}
