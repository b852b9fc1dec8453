//! Events that change the motion: bounces, collisions, pushes; what they leave alone, and where they pile up.

use core::cell::Cell;
use core::f64::consts::TAU;

use dmech::extend::{Particle, Scheme};
use dmech::models::{Kepler, Pendulum, Quartic};
use dmech::prelude::*;

use crate::walls::strike;

/// m g y and, across, an anharmonic valley.
#[derive(Clone, Copy, Debug)]
struct Slope {
    g: f64,
    k: f64,
}

#[dmech::law]
impl Slope {
    #[potential]
    fn energy(&self, m: f64, q: [f64; 2]) -> f64 {
        m * self.g * q[1] + 0.25 * self.k * q[0].powi(4)
    }
}

/// A weight that is heavier below each of two heights.
#[derive(Clone, Copy, Debug)]
struct Layers {
    g: f64,
    more: f64,
    above: [f64; 2],
}

#[dmech::law]
impl Layers {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        let [a, b] = self.above;
        self.g * q + self.more * ((q - a).min(0.0) + (q - b).min(0.0))
    }
}

/// k x²/2.
#[derive(Clone, Copy, Debug)]
struct Rubber {
    k: f64,
}

#[dmech::law]
impl Rubber {
    #[potential]
    fn energy(&self, q: [f64; 1]) -> f64 {
        0.5 * self.k * q[0] * q[0]
    }
}

/// A ball that is dropped from `height` above a floor and gives back the share e of its speed.
#[derive(Clone, Copy)]
struct Ball {
    floor: f64,
    g: f64,
    height: f64,
    e: f64,
}

impl Ball {
    fn run<S: Scheme<Particle<Slope, 2>>>(
        &self,
        scheme: S,
        dt: f64,
        end: f64,
    ) -> Result<Run<State<2>>, Interrupted<State<2>>> {
        let (Ball { floor, e, .. }, law) = (*self, Slope { g: self.g, k: 0.0 });
        Simulation::new(law, State::new([0.3, floor + self.height], [0.2, 0.0]))
            .mass(1.7)
            .scheme(scheme)
            .dt(dt)
            .bounce_off(move |state| state.q[1] - floor, move |state| state.v[1] *= -e)
            .run_until(end)
    }

    /// t₀ + 2 t₀ (e + e² + … + eⁿ) with t₀ = √(2 h/g).
    fn bounce(&self, n: usize) -> f64 {
        let t = (2.0 * self.height / self.g).sqrt();
        (1..=n).fold(t, |sum, k| sum + 2.0 * t * self.e.powi(k as i32))
    }

    fn rest(&self) -> f64 {
        (2.0 * self.height / self.g).sqrt() * (1.0 + 2.0 * self.e / (1.0 - self.e))
    }
}

/// Every scheme is exact under a uniform force: so are the times, in hops longer and shorter than a step, wherever the floor is.
/// The ball is never below it, and the run goes on to its end or to where the ball comes to rest.
#[test]
fn a_ball_bounces_until_it_rests() {
    let (mut hops, mut rests, mut ends) = (0, 0, 0);
    for floor in [0.0, 1.0, -3.7, 1e6] {
        for e in [0.0, 1e-3, 0.3, 0.5, 0.8, 0.95, 0.999, 1.0] {
            for dt in [0.007, 0.13, 1.9] {
                let ball = Ball { floor, g: 1.3, height: 0.9, e };
                // Of the place, and of the time at the speeds that there are.
                let rounding = 16.0 * f64::EPSILON * floor.abs().max(30.0);
                macro_rules! schemes {
                    ($($scheme:expr),*) => {$({
                        let run = match ball.run($scheme, dt, 30.0) {
                            Ok(run) => {
                                ends += 1;
                                assert!(run.last().t >= 30.0 && run.last().t < 30.0 + dt && ball.rest() > 30.0);
                                run
                            }
                            Err(failed) => {
                                rests += 1;
                                let Error::ComesToRest { event: 0, time, .. } = failed.cause() else {
                                    panic!("{failed}");
                                };
                                // Of what is left at rest the hops are too many, or lost in the rounding of the place.
                                let left = 64.0 * dt * (1.0 - e) + 2.0 * (rounding / 1.3).sqrt() / (1.0 - e);
                                assert!((time - ball.rest()).abs() < left, "{floor} {e} {dt}: {time} {}", ball.rest());
                                failed.into_run()
                            }
                        };
                        for (n, event) in run.events().iter().enumerate() {
                            let (State { t, q, v }, exact) = (*event.state(), ball.bounce(n));
                            // An error of the place is one of the time, over the speed.
                            let off = 8.0 * rounding / v[1].abs() + 64.0 * f64::EPSILON * (n + 1) as f64 * exact;
                            let carried = 2.0 * rounding * (n + 1) as f64 / (1.0 - e).max(0.01) / v[1].abs();
                            assert!((t - exact).abs() < off + carried, "{floor} {e} {dt} {n}: {t} {exact} {v:?}");
                            assert!((q[1] - floor).abs() < rounding && v[1] < 0.0 && v[0] == 0.2, "{floor} {e} {dt} {n} {q:?} {v:?}");
                            hops += 1;
                        }
                        // They are counted from one on, and anew from the first after a step: no more than twice 64 in a step.
                        let times: Vec<f64> = run.events().iter().map(|event| event.state().t).collect();
                        assert!(times.windows(129).all(|row| row[128] - row[0] > dt), "{floor} {e} {dt}");
                        assert!(run.states().iter().all(|state| state.q[1] > floor - 100.0 * rounding));
                        let drift = run.drift(Invariant::Energy).unwrap();
                        assert!(drift.max_abs() < 1.7 * 1.3 * 4.0 * (run.events().len() + 2) as f64 * rounding + 1e-14, "{drift:?}");
                    })*};
                }
                schemes!(Leapfrog, Nystrom::order4(), DiscreteGradient, Gauss::order16());
            }
        }
    }
    assert!(hops > 5000 && rests > 100 && ends > 100, "{hops} {rests} {ends}");
}

/// What a run with changes does is what runs do that stop there and go on from the changed state, to the bit, whatever is recorded.
#[test]
fn a_change_is_a_stop_and_a_new_start() {
    fn both<S: Scheme<Particle<Quartic, 1>> + Copy>(scheme: S, dt: f64, e: f64) -> usize {
        let law = Quartic { beta: 1.3 };
        let end = 30.0;
        let simulation = |start| Simulation::new(law, start).mass(0.7).scheme(scheme).dt(dt);
        let start = State::new([1.0], [0.1]);
        let wall = |state: &State<1>| state.q[0] + 0.4;
        let run = simulation(start)
            .change_when(wall, Crossing::Falling, |state| state.v[0] *= -e)
            .event(|state| state.v[0], Crossing::Falling)
            .run_until(end)
            .unwrap();
        let (mut state, mut states, mut events, mut steps) = (start, Vec::new(), Vec::new(), 0);
        loop {
            let leg = simulation(state)
                .stop_when(wall, Crossing::Falling)
                .event(|state| state.v[0], Crossing::Falling)
                .run_until(end)
                .unwrap();
            states.extend_from_slice(&leg.states()[usize::from(steps > 0)..]);
            events.extend_from_slice(leg.events());
            steps += leg.steps();
            state = *leg.last();
            if !leg.stopped() {
                break;
            }
            state.v[0] *= -e;
            states.push(state);
        }
        // After the step of a change the state is the changed one.
        assert_eq!(run.states(), states);
        let seen = |event: &Event<State<1>>| (event.which(), *event.state(), event.crossing());
        let [of_one, of_legs] = [run.events(), &events].map(|events| events.iter().map(seen).collect::<Vec<_>>());
        assert_eq!((of_one, run.steps(), run.last()), (of_legs, steps, &state));
        let turned = |event: &Event<State<1>>| State { v: [-e * event.state().v[0]], ..*event.state() };
        let after = |event: &Event<State<1>>| (event.which() == 0).then(|| turned(event));
        assert!(run.events().iter().all(|event| event.after() == after(event).as_ref()));
        events.len()
    }
    let mut seen = 0;
    macro_rules! schemes {
        ($($scheme:expr),*) => {$(
            for (dt, e) in [(0.05, 1.0), (0.05, 0.9), (0.21, 0.97)] {
                seen += both($scheme, dt, e);
            }
        )*};
    }
    schemes!(
        Leapfrog,
        Implicit,
        DiscreteGradient,
        Kanatani,
        Nystrom::order6(),
        ForceGradient::order4(),
        RungeKuttaNystrom::order12(),
        Gauss::order16(),
        LineIntegral::order6(),
        Composed::order4(DiscreteGradient),
        CompensatedLeapfrog
    );
    assert!(seen > 500, "{seen}");
}

/// States at given times lie on the motion on both sides of a change, and the run ends where it was told to.
#[test]
fn output_and_end_are_kept() {
    let k = 1.4_f64;
    // |cos √k t| of a spring that is reflected at 0.
    let law = Rubber { k };
    let spring = Simulation::new(law, State::new([1.0], [0.0])).scheme(Nystrom::order8());
    let times: Vec<f64> = (0..200).map(|n| 0.1 * f64::from(n)).collect();
    macro_rules! run {
        ($simulation:expr) => {{
            let run = $simulation
                .bounce_off(|state| state.q[0], |state| state.v[0] = -state.v[0])
                .record_at(times.iter().copied())
                .watch("depth", |state| state.q[0].min(0.0))
                .run_until(20.0)
                .unwrap();
            // Nobody has seen where it would be without the wall.
            assert!(run.drift_of("depth").unwrap().max_abs() < 1e-14);
            assert_eq!(run.states().len(), times.len());
            for (state, &t) in run.states().iter().zip(&times) {
                assert!(state.t == t && (state.q[0] - (k.sqrt() * t).cos().abs()).abs() < 1e-7, "{state:?}");
            }
            assert_eq!(run.events().len(), (20.0 * k.sqrt() / (TAU / 2.0) + 0.5) as usize);
            run
        }};
    }
    let run = run!(spring.clone().dt(0.1));
    assert!(run.last().t >= 20.0 && run.last().t < 20.1);
    assert_eq!(run!(spring.adaptive(1e-9).dt(0.3)).last().t, 20.0);
    // Steps that are counted are counted with those in which something has changed.
    let run = Simulation::new(law, State::new([1.0], [0.0]))
        .scheme(Leapfrog)
        .dt(0.1)
        .record_every(7)
        .bounce_off(|state| state.q[0], |state| state.v[0] = -state.v[0])
        .run(70)
        .unwrap();
    assert_eq!((run.steps(), run.states().len()), (70, 11));
    assert!(run.last().t < 7.0 && run.events().len() == 3);
}

/// The energy that a change takes is not counted, what the scheme does to it is; so are momenta and the law's own invariants.
#[test]
fn drifts_are_those_between_changes() {
    let law = Kepler { gm: 1.1 };
    let start = State::new([1.0, 0.0], [0.0, 1.15]);
    let orbit = |change: fn(&mut State<2>)| {
        Simulation::new(law, start)
            .scheme(Leapfrog)
            .dt(0.02)
            .change_when(|state| state.q[1] - 0.01, Crossing::Rising, change)
            .run_until(60.0)
            .unwrap()
    };
    let free = Simulation::new(law, start).scheme(Leapfrog).dt(0.02).run_until(60.0).unwrap();
    let push = orbit(|state| state.v[1] *= 1.02);
    assert!(push.events().len() > 2);
    let drift = |run: &Run<State<2>>, of| run.drift(of).unwrap().max_abs();
    // Leap-frog's own error, of the second order, and nothing of the push; its angular momentum is exact.
    let [own, with] = [&free, &push].map(|run| drift(run, Invariant::Energy));
    assert!(with > 0.3 * own && with < 3.0 * own, "{own} {with}");
    assert!(drift(&push, Invariant::AngularMomentum) < 1e-13);
    assert!(push.drift(Invariant::Energy).unwrap().last() > push.drift(Invariant::Energy).unwrap().start() + 0.01);
    // What is watched is what it is.
    let spin = |state: &State<2>| state.q[0] * state.v[1] - state.q[1] * state.v[0];
    let watched = Simulation::new(law, start)
        .scheme(Leapfrog)
        .dt(0.02)
        .watch("spin", spin)
        .change_when(|state| state.q[1] - 0.01, Crossing::Rising, |state| state.v[1] *= 1.02)
        .run_until(60.0)
        .unwrap();
    assert!(watched.drift_of("spin").unwrap().max_abs() > 0.02);
    // Exact energies stay exact, whatever is taken from them; so do the scheme's own.
    let quartic =
        Simulation::new(Quartic { beta: 1.3 }, State::new([1.0], [0.3])).mass(0.7).scheme(DiscreteGradient).dt(0.1);
    let run = quartic.change_when(|s| s.q[0] + 0.2, Crossing::Falling, |s| s.v[0] *= -0.9).run_until(30.0).unwrap();
    assert!(run.events().len() > 4 && run.drift(Invariant::Energy).unwrap().max_abs() < 1e-14, "{run}");
    let pendulum = Simulation::new(Pendulum { k: 1.3 }, State::new([1.0], [0.3])).mass(0.7).scheme(Kanatani).dt(0.1);
    let run = pendulum.change_when(|s| s.q[0] + 0.2, Crossing::Falling, |s| s.v[0] *= -0.9).run_until(30.0).unwrap();
    assert!(run.events().len() > 4 && run.drift(Invariant::DiscreteEnergy).unwrap().max_abs() < 1e-13);
    let work = Simulation::new(Pendulum { k: 1.3 }, State::new([1.0], [0.3])).scheme(Implicit).dt(0.1);
    let run = work.change_when(|s| s.q[0] + 0.2, Crossing::Falling, |s| s.v[0] *= -0.9).run_until(30.0).unwrap();
    assert!(run.drift(Invariant::WorkEnergy).unwrap().max_abs() < 1e-13);
}

/// An orbit with an invariant of its own.
#[derive(Clone, Copy, Debug)]
struct Orbit {
    gm: f64,
}

#[dmech::law]
impl Orbit {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }

    #[invariant]
    fn towards_the_pericentre(&self, q: [f64; 2], v: [f64; 2]) -> f64 {
        v[1] * (q[0] * v[1] - q[1] * v[0]) - self.gm * q[0] / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

/// What a scheme does to the invariants adds up over changes that do nothing, of a law and of bodies.
#[test]
fn drifts_add_up_over_changes() {
    let law = Orbit { gm: 1.1 };
    let orbit = Simulation::new(law, State::new([1.0, 0.0], [0.0, 0.9])).mass(1.3).scheme(Explicit).dt(2e-3);
    let run = orbit.change_when(|state| state.q[1], Crossing::Any, |_| ()).run_until(20.0).unwrap();
    assert!(run.events().len() > 3);
    let spin = |State { q, v, .. }: &State<2>| 1.3 * (q[0] * v[1] - q[1] * v[0]);
    let energy = |State { q, v, .. }: &State<2>| 1.3 * 0.5 * (v[0] * v[0] + v[1] * v[1]) + law.energy(*q);
    let own = |State { q, v, .. }: &State<2>| law.towards_the_pericentre(*q, *v);
    let most = |value: &dyn Fn(&State<2>) -> f64| {
        let start = value(&run.states()[0]);
        run.states().iter().map(|state| (value(state) - start).abs()).fold(0.0, f64::max)
    };
    for (drift, most) in [
        (run.drift(Invariant::Energy), most(&energy)),
        (run.drift(Invariant::AngularMomentum), most(&spin)),
        (run.drift_of("towards_the_pericentre"), most(&own)),
    ] {
        let drift = drift.unwrap().max_abs();
        assert!(most > 0.01 && (drift / most - 1.0).abs() < 1e-9, "{drift} {most}");
    }
    // A push is no part of them.
    let orbit =
        Simulation::new(law, State::new([1.0, 0.0], [0.0, 0.9])).scheme(Composed::order8(DiscreteGradient)).dt(0.02);
    let push = |state: &mut State<2>| state.v = state.v.map(|v| 1.05 * v);
    let run = orbit.change_when(|state| state.q[1], Crossing::Falling, push).run_until(20.0).unwrap();
    assert!(run.events().len() > 1);
    for drift in
        [run.drift(Invariant::Energy), run.drift(Invariant::AngularMomentum), run.drift_of("towards_the_pericentre")]
    {
        assert!(
            drift.unwrap().max_abs() < 1e-6 && (drift.unwrap().last() - drift.unwrap().start()).abs() > 1e-2,
            "{drift:?}"
        );
    }
}

/// In a corner both walls change the state, which is told twice at one time; a stop there has both changes.
#[test]
fn what_happens_together_changes_together() {
    let flight = || {
        Simulation::new(Slope { g: 0.0, k: 0.0 }, State::new([1.0, 1.0], [-1.0, -1.0]))
            .scheme(Leapfrog)
            .dt(0.3)
            .bounce_off(|state| state.q[0], |state| state.v[0] *= -1.0)
            .bounce_off(|state| state.q[1], |state| state.v[1] *= -1.0)
    };
    let run = flight().run_until(2.5).unwrap();
    assert_eq!(run.events().iter().map(Event::which).collect::<Vec<_>>(), [0, 1]);
    assert!(run.events()[0].state().t == run.events()[1].state().t && run.last().v == [1.0, 1.0]);
    let run = flight().stop_when(|state| state.q[0] + state.q[1], Crossing::Falling).run_until(2.5).unwrap();
    assert!(run.stopped() && run.last().v == [1.0, 1.0] && run.events().len() == 3);
    // A stop that comes first is not passed by a change, nor the other way round.
    let run = flight().stop_when(|state| state.q[0] - 0.01, Crossing::Falling).run_until(2.5).unwrap();
    assert!(run.stopped() && run.last().v == [-1.0, -1.0] && run.events().len() == 1);
    let run = flight().stop_when(|state| state.q[0] + 0.01, Crossing::Falling).run_until(2.5).unwrap();
    assert!(!run.stopped() && run.events().len() == 2);
}

/// A change that lets the motion through changes it once: a push on, a push of what is no place, a jump to the other side.
#[test]
fn what_is_let_through_goes_on() {
    let law = Pendulum { k: 0.9 };
    let pendulum =
        |level: f64| Simulation::new(law, State::new([1.0 + level], [0.0])).scheme(Nystrom::order6()).dt(0.1);
    for level in [0.0, 0.3] {
        let run = pendulum(level)
            .change_when(move |s| s.q[0] - level, Crossing::Falling, |s| s.v[0] *= 1.1)
            .run_until(10.0)
            .unwrap();
        assert!(run.events().len() == 2, "{:?}", run.events());
    }
    let run =
        pendulum(0.0).change_when(|s| s.v[0], Crossing::Any, |s| s.v[0] -= 1e-3 * s.q[0]).run_until(20.0).unwrap();
    assert!((5..9).contains(&run.events().len()), "{:?}", run.events());
    let run = pendulum(0.0).change_when(|s| s.q[0], Crossing::Falling, |s| s.q[0] += 0.5).run_until(2.0).unwrap();
    assert!((1..4).contains(&run.events().len()), "{:?}", run.events());
    // Of the velocity, with a change of the place; to behind, from where it comes back.
    let run = pendulum(0.0).change_when(|s| s.v[0], Crossing::Falling, |s| s.q[0] -= 1e-3).run_until(20.0).unwrap();
    assert!((2..5).contains(&run.events().len()), "{:?}", run.events());
    let back = |s: &mut State<1>| (s.q[0], s.v[0]) = (s.q[0] - 0.1, -s.v[0]);
    let run = pendulum(0.0).change_when(|s| s.q[0], Crossing::Falling, back).run_until(20.0).unwrap();
    assert!((3..9).contains(&run.events().len()), "{:?}", run.events());
    // A clock does not turn back.
    let ticks = Cell::new(0);
    let clock = |s: &State<1>| (TAU * s.t).sin();
    let tick = |_: &mut State<1>| ticks.set(ticks.get() + 1);
    let run = pendulum(0.0).change_when(clock, Crossing::Rising, tick).run_until(5.5).unwrap();
    assert_eq!((ticks.get(), run.events().len()), (5, 5));
}

/// States between those that were recorded are of the motion before a change or after it, not of both.
#[test]
fn between_changes() {
    fn follows<S: Scheme<Particle<Rubber, 1>> + Copy>(scheme: S, recorded: f64) {
        // Free, from 0 with velocity 1, turned back at 0.9 and at 1.3, pushed to another place at 2.1.
        let free = Simulation::new(Rubber { k: 0.0 }, State::new([0.0], [1.0])).scheme(scheme).dt(0.25);
        let turned = |at: f64| move |s: &State<1>| s.t - at;
        let run = free
            .record_dt(recorded)
            .change_when(turned(0.9), Crossing::Rising, |s| s.v[0] = -1.0)
            .change_when(turned(1.3), Crossing::Rising, |s| s.v[0] = 0.5)
            .change_when(turned(1.3), Crossing::Rising, |s| s.v[0] *= 3.0)
            .change_when(turned(2.1), Crossing::Rising, |s| s.q[0] = -7.0)
            .run_until(3.0)
            .unwrap();
        let exact = |t: f64| match t {
            t if t < 0.9 => t,
            t if t < 1.3 => 1.8 - t,
            t if t < 2.1 => 0.5 + 1.5 * (t - 1.3),
            t => -7.0 + 1.5 * (t - 2.1),
        };
        for k in 0..=3000 {
            let t = 1e-3 * f64::from(k);
            let state = run.at(t).unwrap();
            let near = (t - 0.9).abs().min((t - 1.3).abs()).min((t - 2.1).abs()) < 1e-12;
            assert!(near || (state.q[0] - exact(t)).abs() < 1e-12, "{}, {t}: {state:?}", S::NAME);
        }
        // At a change, where nothing was recorded, the motion has gone on.
        let [.., push] = run.events() else { panic!("{:?}", run.events()) };
        let after = push.after().unwrap();
        assert_eq!((after.q, run.at(push.state().t).as_ref()), ([-7.0], Some(after)));
        let several: Vec<_> = run.events().iter().map(|event| event.after().unwrap().v[0]).collect();
        assert_eq!(several, [-1.0, 0.5, 1.5, 1.5]);
        assert!(run.at(-0.1).is_none() && run.at(run.last().t + 0.1).is_none() && run.at(f64::NAN).is_none());
    }
    for recorded in [0.25, 0.5, 1.7] {
        follows(Leapfrog, recorded);
        follows(Nystrom::order8(), recorded);
        follows(Gauss::order16(), recorded);
    }
}

/// A report tells of the whole run, not of what followed the last change.
#[test]
fn what_is_told_of_steps_is_told_of_all() {
    let eccentric = State::new([1.9, 0.0], [0.0, (0.1_f64 / 1.9).sqrt()]);
    let orbit = || Simulation::new(Kepler { gm: 1.0 }, eccentric).scheme(DiscreteGradient).adaptive(1e-5).dt(1.0);
    let whole = orbit().run_until(12.0).unwrap().report().dt_range().unwrap();
    let late = |s: &State<2>| s.t - 11.9;
    let changed = orbit().change_when(late, Crossing::Rising, |_| ()).run_until(12.0).unwrap();
    assert_eq!((changed.report().dt_range(), changed.events().len()), (Some(whole), 1));
    assert!(whole[1] > 20.0 * whole[0], "{whole:?}");

    // A fall through two seams, onto a floor below one of them or both.
    let law = Layers { g: 1.3, more: 0.4, above: [0.7, 0.3] };
    for (floor, seams) in [(0.5, 1), (0.1, 2)] {
        let fall = Simulation::new(law, State::new([1.0], [0.0])).scheme(Gauss::order16()).dt(0.05);
        let run = fall.bounce_off(move |s| s.q[0] - floor, |s| s.v[0] = 0.2).run_until(1.2).unwrap();
        assert!(!run.events().is_empty() && run.report().rough() == seams, "{floor}: {}", run.report());
    }
}

/// What cannot be gone on from ends the run, with what there is of it.
#[test]
fn changes_that_are_refused() {
    let law = Pendulum { k: 0.9 };
    let pendulum = || Simulation::new(law, State::new([1.0], [0.0])).scheme(Leapfrog).dt(0.1);
    type Bad = (fn(&mut State<1>), fn(&Error) -> bool);
    let bad: [Bad; 3] = [
        (
            |state| state.v[0] = f64::NAN,
            |error| matches!(error, Error::State { quantity: "v", value } if value.is_nan()),
        ),
        (|state| state.q[0] = f64::INFINITY, |error| matches!(error, Error::State { quantity: "q", .. })),
        (
            |state| state.t += 1.0,
            |error| matches!(error, Error::ChangedTime { time, changed } if *changed == time + 1.0),
        ),
    ];
    for (change, right) in bad {
        let failed = pendulum().change_when(|s| s.q[0], Crossing::Falling, change).run_until(10.0).unwrap_err();
        assert!(right(&failed.cause()), "{failed}");
        let run = failed.run();
        assert!(run.last() == run.events()[0].state(), "{:?}", run.last());
        assert!(run.events().len() == 1 && run.states().len() > 10 && run.events()[0].state().q[0].abs() < 1e-15);
    }
    let scene = || Scene::<1>::new().body(1.0, [0.0], [1.0]).body(1.0, [2.0], [0.0]).body(1.0, [9.0], [0.0]).pin(2);
    let bad: [fn(&mut SceneState<1>, [usize; 2]); 3] =
        [|state, _| state.q.truncate(2), |state, [a, _]| state.v[a][0] = f64::NAN, |state, _| state.v[2][0] = 1.0];
    for change in bad {
        let balls = Simulation::scene(scene()).scheme(Leapfrog).dt(0.3).collide_at(0.5, change);
        let failed = balls.run_until(10.0).unwrap_err();
        assert!(matches!(failed.cause(), Error::Scene(_)), "{failed}");
        assert!(failed.run().events().len() == 1 && failed.run().last().q.len() == 3);
    }
}

/// Hard balls on a line exchange their velocities: in the order of their places these are always sorted copies of those at the start. Energy
/// and momentum are kept to rounding, and nothing passes through anything.
#[test]
fn hard_balls_collide() {
    let (size, mut collisions) = (0.25, 0);
    for (dt, masses) in [(0.05, [1.0, 1.0, 1.0, 1.0]), (0.2, [1.0, 1.0, 1.0, 1.0]), (0.1, [1.0, 2.5, 0.3, 4.0])] {
        let scene =
            (0..4).fold(Scene::<1>::new(), |scene, i| scene.body(masses[i], [i as f64], [[0.9, -0.2, 0.35, -1.1][i]]));
        // Walls on both sides, and times at which three meet at once: a ball, its neighbour and a wall.
        let run = Simulation::scene(scene)
            .scheme(Leapfrog)
            .dt(dt)
            .collide_at(size, strike(masses, 1.0))
            .bounce_off(|state| state.q[0][0] + 1.0, |state| state.v[0][0] *= -1.0)
            .bounce_off(|state| 4.0 - state.q[3][0], |state| state.v[3][0] *= -1.0)
            .run_until(40.0)
            .unwrap();
        for state in run.states() {
            assert!(state.q.windows(2).all(|pair| pair[1][0] - pair[0][0] > size - 1e-13), "{dt} {state:?}");
            if masses[1] == 1.0 {
                let mut speeds: Vec<f64> = state.v.iter().map(|v| v[0].abs()).collect();
                speeds.sort_by(f64::total_cmp);
                assert!(
                    speeds.iter().zip([0.2, 0.35, 0.9, 1.1]).all(|(v, exact)| (v - exact).abs() < 1e-13),
                    "{speeds:?}"
                );
            }
        }
        assert!(run.drift(Invariant::Energy).unwrap().max_abs() < 1e-12);
        collisions += run.events().iter().filter(|event| event.bodies().is_some()).count();
    }
    assert!(collisions > 100, "{collisions}");
}

/// Two balls in one valley, which strike each other: between collisions and over them the scheme has its order.
#[test]
fn collisions_under_forces_have_the_order_of_the_scheme() {
    let swing = |dt: f64| {
        let scene = Scene::<1>::new().body(1.3, [-1.5], [0.0]).body(1.3, [0.7], [0.2]).field(Quartic { beta: 0.9 });
        Simulation::scene(scene)
            .scheme(Nystrom::order6())
            .dt(dt)
            .collide_at(0.6, |state, [a, b]| state.v.swap(a, b))
            .record_at([12.0])
            .run_until(12.0)
            .unwrap()
    };
    let [coarse, fine, exact] = [0.1, 0.05, 0.005].map(swing);
    let at = |run: &Run<SceneState<1>>| run.states()[0].q[0][0];
    assert!(exact.events().len() > 4 && coarse.events().len() == exact.events().len(), "{:?}", exact.events());
    let order = ((at(&coarse) - at(&exact)) / (at(&fine) - at(&exact))).abs().log2();
    assert!((order - 6.0).abs() < 1.2, "{order}");
    assert!(fine.drift(Invariant::Energy).unwrap().max_abs() < 1e-5);
}

/// Members that are moved each alone bounce as they do by themselves.
#[test]
fn members_bounce() {
    let member = |k: usize| {
        Simulation::new(Slope { g: 1.3, k: 0.4 }, State::new([0.3, 1.0], [0.2, 0.0]))
            .scheme(Leapfrog)
            .dt(0.01)
            .bounce_off(|state| state.q[1], move |state| state.v[1] *= -1.0 + 0.05 * k as f64)
    };
    let run = Ensemble::each(9, member).run_until(6.0).unwrap();
    for k in 0..9 {
        match (member(k).run_until(6.0), run.last(k)) {
            (Ok(alone), Ok(last)) => assert_eq!(*alone.last(), last),
            (Err(alone), Err(failed)) => assert_eq!(alone.cause(), failed),
            other => panic!("{k}: {other:?}"),
        }
    }
}
