//! Pictures of runs: of any motion a picture that says what it shows.

use std::fs;
use std::path::{Path, PathBuf};

use dmech::models::{Kepler, Pendulum, pairs};
use dmech::prelude::*;

/// A force that is the same everywhere: to any place at any speed.
#[derive(Clone, Copy, Debug)]
struct Slope<const D: usize>;

impl<const D: usize> Conservative for Slope<D> {}
impl<const D: usize> Potential<D> for Slope<D> {
    fn potential(&self, q: [f64; D]) -> f64 {
        1e-3 * q[0]
    }
    fn gradient(&self, _: [f64; D]) -> [f64; D] {
        core::array::from_fn(|k| if k == 0 { 1e-3 } else { 0.0 })
    }
    fn hessian(&self, _: [f64; D]) -> [[f64; D]; D] {
        [[0.0; D]; D]
    }
    fn discrete_gradient(&self, a: [f64; D], _: [f64; D]) -> [f64; D] {
        self.gradient(a)
    }
    fn discrete_gradient_jacobian(&self, _: [f64; D], _: [f64; D]) -> [[f64; D]; D] {
        [[0.0; D]; D]
    }
}

fn place(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// The text of a picture, in which every point is a number inside of it.
fn sound(path: &Path, bytes: usize) -> String {
    let svg = fs::read_to_string(path).unwrap();
    assert!(svg.len() < bytes, "{} has {} bytes", path.display(), svg.len());
    assert!(!svg.contains("NaN") || svg.contains("&apos;NaN"), "{}", path.display());
    let number = |text: &str| text.parse::<f64>().unwrap_or_else(|_| panic!("{text} in {}", path.display()));
    let after = |text: &str, name: &str| {
        let from = text.find(&format!(" {name}=\"")).map(|at| at + name.len() + 3)?;
        Some(text[from..].split('"').next().unwrap().to_owned())
    };
    let frame = svg.split("viewBox=\"").nth(1).unwrap().split('"').next().unwrap();
    let [.., width, height] = frame.split(' ').map(number).collect::<Vec<_>>()[..] else { panic!("{frame}") };
    let inside = |x: f64, y: f64| {
        assert!((0.0..=width).contains(&x) && (0.0..=height).contains(&y), "({x}, {y}) in {}", path.display());
    };
    for element in svg.split('<') {
        for [x, y] in [["x", "y"], ["cx", "cy"], ["x1", "y1"], ["x2", "y2"]] {
            if let (Some(x), Some(y)) = (after(element, x), after(element, y)) {
                inside(number(&x), number(&y));
            }
        }
        for point in after(element, "points").iter().flat_map(|points| points.split_whitespace()) {
            let (x, y) = point.split_once(',').unwrap();
            inside(number(x), number(y));
        }
    }
    svg
}

/// Draws a run of one law both ways.
fn drawn<const D: usize>(run: &Run<State<D>>, name: &str) -> [String; 2] {
    let [path, energy] = ["path", "energy"].map(|kind| place(&format!("{name}_{kind}.svg")));
    run.plot(&path).unwrap();
    run.plot_energy(&energy).unwrap();
    let both = [sound(&path, 1_000_000), sound(&energy, 200_000)];
    for svg in &both {
        for words in [run.report().scheme(), "start", "units of the law", "t = "] {
            assert!(svg.contains(words), "{words} in {name}");
        }
    }
    both
}

fn fall<const D: usize>(q: [f64; D], v: [f64; D], dt: f64, steps: u64) -> Run<State<D>> {
    Simulation::new(Slope, State::new(q, v)).scheme(Leapfrog).dt(dt).run(steps).unwrap()
}

fn planet() -> Simulation<Kepler, State<2>> {
    Simulation::new(Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63]))
}

#[test]
fn motions_of_every_dimension_are_drawn() {
    let law = Pendulum { k: 1.0 };
    drawn(&Simulation::new(law, State::new([1.2], [0.0])).scheme(Leapfrog).dt(0.1).run(300).unwrap(), "one");
    let [path, energy] = drawn(&planet().scheme(DiscreteGradient).dt(0.01).run_until(20.0).unwrap(), "two");
    assert!(path.contains("dt = 0.01") && path.contains("2001 states") && energy.contains("must be: exact"));
    let space = State::new([0.5, 0.0, 0.1], [0.0, 1.63, 0.4]);
    let space = Simulation::new(InSpace, space).scheme(Leapfrog).dt(0.01).run(500).unwrap();
    let [path, _] = drawn(&space, "three");
    assert!(path.contains("y over x") && path.contains("z over x"));
    let [path, _] = drawn(&fall([0.0; 6], [1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 0.1, 50), "six");
    assert!(path.contains("q₂ over q₁") && path.contains("q₆ over q₅"));
    drawn(&fall([0.0; 5], [1.0; 5], 0.1, 50), "five");
}

/// −1/|q| in space.
#[derive(Clone, Copy, Debug)]
struct InSpace;

#[dmech::law]
impl InSpace {
    #[potential]
    fn energy(&self, q: [f64; 3]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt()
    }
}

#[test]
fn a_motion_may_be_none() {
    for (name, run) in [
        ("still", fall([2.0, 3.0], [0.0, 0.0], 1e-12, 1)),
        ("one_state", fall([2.0, 3.0], [1.0, 0.0], 0.1, 0)),
        ("straight", fall([0.0, 7.0], [1.0, 0.0], 0.1, 40)),
    ] {
        drawn(&run, name);
    }
    drawn(&fall([5.0], [0.0], 1e-9, 3), "still_on_a_line");
    drawn(&fall([0.0; 3], [0.0; 3], 1e-200, 3), "still_in_space");
}

/// No size of the numbers is special: axes name a power of ten, and what the values have in common.
#[test]
fn numbers_may_have_any_size() {
    let [path, _] = drawn(&fall([1e20, -2e20], [3e18, 1e18], 1.0, 100), "large");
    assert!(path.contains("x / 10²⁰"), "{path}");
    let [path, _] = drawn(&fall([1e-20, -2e-20], [3e-17, 1e-17], 1e-10, 100), "small");
    assert!(path.contains("x / 10⁻²⁰") || path.contains("x / 10⁻¹⁹"), "{path}");
    let [path, _] = drawn(&fall([1e6, 1e6], [1e-3, 1e-3], 0.01, 100), "far_away");
    assert!(path.contains("x − 1"), "{path}");
    drawn(&fall([1e-300, 0.0], [1e300, -1e300], 1.0, 10), "everything");
    drawn(&fall([1.7e308, -1.7e308], [0.0, 0.0], 1.0, 3), "the_largest");
    drawn(&fall([1.0, 1.0], [1e-15, 1e9], 1.0, 10), "different");
    let late = State::new([1.0, 2.0], [0.3, 0.4]).at_time(1e12);
    drawn(&Simulation::new(Slope::<2>, late).scheme(Leapfrog).dt(1e-2).run(50).unwrap(), "late");
}

#[test]
fn a_million_states_are_a_small_picture() {
    let run = planet().scheme(Explicit).dt(0.001).run(1_000_000).unwrap();
    let [path, energy] = drawn(&run, "million");
    assert!(path.contains("1\u{202f}000\u{202f}001 states"));
    // The explicit scheme's energy grows; it is drawn to the end.
    assert!(energy.contains("end"));
    let law = Pendulum { k: 1.0 };
    drawn(
        &Simulation::new(law, State::new([1.2], [0.0])).scheme(Leapfrog).dt(0.1).run(1_000_000).unwrap(),
        "million_one",
    );
    let wander = dmech::models::HenonHeiles { lambda: 1.0 };
    let wander = Simulation::new(wander, State::new([0.0, 0.1], [0.5, 0.08])).scheme(Leapfrog).dt(0.05);
    drawn(&wander.run(1_000_000).unwrap(), "million_wandering");
}

/// A run that ends in a failure, states that are no numbers, states that were not recorded.
#[test]
fn what_was_computed_is_drawn() {
    let stopped =
        Simulation::new(Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 0.0])).scheme(Leapfrog).dt(0.01).run(500);
    let run = match stopped {
        Ok(run) => run,
        Err(interrupted) => interrupted.into_run(),
    };
    drawn(&run, "partial");
    let fails = fall([0.0; 2], [1e308, 0.0], 1.0, 1);
    drawn(&fails, "to_the_edge");
    let over =
        Simulation::new(Slope, State::new([0.0; 2], [1e308, 1.0])).scheme(Leapfrog).dt(0.5).run(100).unwrap_err();
    assert!(over.run().steps() > 0);
    drawn(over.run(), "over_the_edge");
    let unrecorded = planet().scheme(Leapfrog).dt(0.01).record_every(u64::MAX).run(500).unwrap();
    drawn(&unrecorded, "unrecorded");
    let adaptive = planet().scheme(Nystrom::order6()).adaptive(1e-6).run_until(30.0).unwrap();
    let [path, _] = drawn(&adaptive, "adaptive");
    assert!(path.contains("tolerance 10⁻⁶"));
    let on = planet().starting_from(adaptive.last()).scheme(Leapfrog).dt(0.01).run(100).unwrap();
    let [_, energy] = drawn(&on, "resumed");
    assert!(energy.contains("t = 30"));
}

#[test]
fn scenes_are_drawn() {
    let chain = |n: u32| {
        let bodies =
            (0..n).fold(Scene::new(), |scene, i| scene.body(1.0, [f64::from(i), 0.0], [0.0, 0.3 * f64::from(i % 3)]));
        Simulation::scene(bodies.pin(0).chain(pairs::Spring { k: 2.0, length: 1.0 }))
    };
    for (name, n) in [("few", 4), ("many", 50)] {
        let run = chain(n).scheme(Leapfrog).dt(0.05).run(200).unwrap();
        let [path, energy] = ["path", "energy"].map(|kind| place(&format!("scene_{name}_{kind}.svg")));
        run.plot(&path).unwrap();
        run.plot_energy(&energy).unwrap();
        let svg = sound(&path, 1_000_000);
        assert!(svg.contains("○ start, ● end, ■ stays where it is"));
        assert_eq!(svg.contains("body 3"), n == 4);
        assert!(sound(&energy, 200_000).contains("bounded"));
    }
    let crowd = (0..20_000_u32).fold(Scene::<3>::new(), |scene, i| {
        let x = f64::from(i);
        scene.body(1.0, [x.sin() * x, x.cos() * x, x], [1.0, 0.1 * x, 0.0])
    });
    let run = Simulation::scene(crowd).scheme(Leapfrog).dt(1.0).run(10).unwrap();
    run.plot(place("scene_crowd_path.svg")).unwrap();
    assert!(sound(&place("scene_crowd_path.svg"), 1_000_000).contains("20\u{202f}000 bodies"));
    let line =
        Scene::new().body(1.0, [0.0], [0.1]).body(1.0, [1.0], [0.0]).chain(pairs::Spring { k: 2.0, length: 1.0 });
    Simulation::scene(line).scheme(Leapfrog).dt(0.05).run(200).unwrap().plot(place("scene_line.svg")).unwrap();
    sound(&place("scene_line.svg"), 1_000_000);
}

/// The largest change that is drawn is the one that is reported, whatever the number of states.
#[test]
fn a_drift_is_drawn_as_it_is_reported() {
    for steps in [10, 5000, 100_000] {
        let run = planet().scheme(Leapfrog).dt(0.01).run(steps).unwrap();
        let file = place(&format!("drift_{steps}.svg"));
        run.plot_energy(&file).unwrap();
        let largest = run.drift(Invariant::Energy).unwrap().max_relative();
        let said = dmech::plot::rough(largest, 3);
        assert!(
            sound(&file, 200_000).contains(&format!("largest change drawn {said}")),
            "{said} in {}",
            file.display()
        );
    }
    let watched = planet().scheme(Leapfrog).dt(0.01).watch("distance", |state: &State<2>| state.q[0].hypot(state.q[1]));
    let run = watched.run(1000).unwrap();
    run.plot_drift_of("distance", place("distance.svg")).unwrap();
    run.plot_drift(Invariant::AngularMomentum, place("momentum.svg")).unwrap();
    let largest = dmech::plot::rough(run.drift_of("distance").unwrap().max_relative(), 3);
    assert!(sound(&place("distance.svg"), 200_000).contains(&largest));
}

/// A study of any schemes: one panel for few, one for each family of many; runs that fail are no lines.
#[test]
fn studies_are_drawn() {
    let law = Pendulum { k: 1.0 };
    let study = || Study::new(law, State::new([1.2], [0.0]), 30.0).repetitions(1).exact(move |t| [law.exact(1.2, t)]);
    let steps = [0.4, 0.2, 0.1, 0.05];
    let few = study().scheme(Leapfrog).scheme(DiscreteGradient).ladder(steps).run().unwrap();
    few.plot(place("study_few.svg")).unwrap();
    let svg = sound(&place("study_few.svg"), 100_000);
    assert!(
        ["Time for an error", "Leapfrog", "DiscreteGradient", "t = 0 … 30"].iter().all(|words| svg.contains(words))
    );
    let lost = study().scheme(Explicit).scheme(DiscreteGradient).ladder([1.5, 0.2]).run().unwrap();
    lost.plot(place("study_lost.svg")).unwrap();
    let svg = sound(&place("study_lost.svg"), 100_000);
    assert!(svg.contains("Explicit: all errors are larger than the motion"), "what has no line is named");
    let many = study()
        .scheme(Leapfrog)
        .scheme(Implicit)
        .scheme(Nystrom::order4())
        .scheme(Nystrom::order8())
        .scheme(Composed::order4(DiscreteGradient))
        .scheme(Gauss::order16())
        .scheme(LineIntegral::order8())
        .adaptive(Composed::order6(DiscreteGradient), [1e-3, 1e-5])
        .ladder(steps)
        .run()
        .unwrap();
    many.plot_titled(place("study_many.svg"), "A pendulum").unwrap();
    let svg = sound(&place("study_many.svg"), 200_000);
    let panels = [
        "order 1 and 2",
        "Nystrom",
        "Composed(DiscreteGradient)",
        "Gauss, LineIntegral",
        "steps that follow the motion",
    ];
    assert!(panels.iter().all(|words| svg.contains(words)));
    assert!(
        ["A pendulum", "order 8", "Gauss 16", "DiscreteGradient 6", "grey"].iter().all(|words| svg.contains(words))
    );
    // What is more exact than the reference tells is drawn where that ends.
    let exact = study().scheme(Leapfrog).scheme(Gauss::order16()).ladder([0.4, 0.3, 0.2, 0.1]).run().unwrap();
    assert!(exact.rows().iter().any(|row| row.result().unwrap().error() < exact.resolution()));
    exact.plot(place("study_exact.svg")).unwrap();
    let svg = sound(&place("study_exact.svg"), 100_000);
    assert!(svg.contains("Gauss") && !svg.contains("no run reached"));
    // Steps by which no run reaches the end, or none with an error that tells anything.
    let blind = study().scheme(Explicit).ladder([3.0]).run().unwrap();
    assert!(blind.rows().iter().all(|row| row.result().is_ok()));
    blind.plot(place("study_blind.svg")).unwrap();
    assert!(sound(&place("study_blind.svg"), 100_000).contains("all errors are larger than the motion"));
    let none = study().scheme(Leapfrog).ladder([1e-30]).run().unwrap();
    none.plot(place("study_none.svg")).unwrap();
    assert!(sound(&place("study_none.svg"), 100_000).contains("no run reached the end"));
}

#[test]
fn what_is_not_there_is_an_error_and_no_picture() {
    let run = planet().scheme(Leapfrog).dt(0.01).run(10).unwrap();
    for error in [
        run.plot_drift(Invariant::LinearMomentum, place("never.svg")).unwrap_err(),
        run.plot_drift_of("nothing", place("never.svg")).unwrap_err(),
    ] {
        assert_eq!(error.kind(), std::io::ErrorKind::Unsupported);
    }
    // A name that is spelt otherwise is told beside those there are.
    let watched =
        planet().scheme(Leapfrog).dt(0.01).watch("my_speed", |s| s.v[0]).watch("x", |s| s.q[0]).run(10).unwrap();
    let error = watched.plot_drift_of("my_sped", place("never.svg")).unwrap_err().to_string();
    assert_eq!(error, r#"this run follows no "my_sped": there is "my_speed", "x""#);
    assert!(!place("never.svg").exists());
    assert!(run.plot(place("no folder").join("x.svg")).is_err());
    // A stream keeps no states; it keeps the course of the energy.
    let streamed = planet().scheme(Leapfrog).dt(0.01).stream(Csv::new(Vec::new())).run(10).unwrap();
    assert_eq!(streamed.plot(place("never.svg")).unwrap_err().kind(), std::io::ErrorKind::Unsupported);
    // The law has an energy; the run has ended before there was one.
    let refused =
        Simulation::new(Kepler { gm: 1.3 }, State::new([0.0; 2], [0.1, 0.2])).scheme(Leapfrog).dt(0.01).run(3);
    let error = refused.unwrap_err().run().plot_energy(place("never.svg")).unwrap_err();
    assert!(error.to_string().starts_with("this run has ended before its first state"), "{error}");
    assert!(!place("never.svg").exists());
    streamed.plot_energy(place("streamed_energy.svg")).unwrap();
    // A file is what its name says.
    let error = run.plot(place("orbit.PNG")).unwrap_err();
    assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput);
    assert!(error.to_string().ends_with("orbit.svg") && !place("orbit.PNG").exists(), "{error}");
}
