//! Members of an ensemble against a loop over lanes written by hand, and against each alone, in one run.
//!
//! `cargo bench -p dmech-benches --bench ensembles` prints the time of a member and step on one core, the best of some runs. With
//! `RUSTFLAGS="-C target-cpu=native"` both sides use the widest registers and fused multiply-adds. The bits are those of each alone; the
//! suite `ensembles` sees to that.

use std::hint::black_box;
use std::time::Instant;

use dmech::extend::{Rides, Rows};
use dmech::models::Kepler;
use dmech::models::pairs::Gravity;
use dmech::prelude::*;
use dmech::scene::OnPairs;

const MEMBERS: usize = 64;

fn law(k: usize) -> Kepler {
    Kepler { gm: 1.0 + 1e-4 * k as f64 }
}

fn start(k: usize) -> State<2> {
    State::new([0.5, 0.0], [0.0, 1.2 + 0.6 * k as f64 / MEMBERS as f64])
}

/// Leap-frog on Kepler, N registers of eight lanes side by side, in drifts and kicks of a whole step.
fn by_hand<const N: usize>(steps: u64) -> f64 {
    let mut sum = 0.0;
    for group in (0..MEMBERS).step_by(Rows::<N>::COUNT) {
        let of = |f: &dyn Fn(usize) -> f64| Rows::<N>::from_fn(|lane| f(group + lane));
        let h = of(&|_| 0.01);
        let c = h * of(&|k| law(k).gm);
        let mut q = [of(&|k| start(k).q[0]), of(&|k| start(k).q[1])];
        let mut v = [of(&|k| start(k).v[0]), of(&|k| start(k).v[1])];
        for _ in 0..steps {
            q = [q[0] + h * v[0], q[1] + h * v[1]];
            let r2 = q[0].mul_add(q[0], q[1] * q[1]);
            let pull = c / (r2 * r2.sqrt());
            v = [v[0] - pull * q[0], v[1] - pull * q[1]];
        }
        sum += (0..Rows::<N>::COUNT).map(|lane| q[0][lane]).sum::<f64>();
    }
    sum
}

/// One root and one quotient a step, and nothing else: no step that rounds both correctly takes less.
fn bound(steps: u64) -> f64 {
    let mut sum = 0.0;
    for group in (0..MEMBERS).step_by(Rows::<8>::COUNT) {
        let of = |f: &dyn Fn(usize) -> f64| Rows::<8>::from_fn(|lane| f(group + lane));
        let c = of(&|k| law(k).gm);
        let mut x = of(&|k| start(k).v[1]);
        for _ in 0..steps {
            x = c / x.sqrt();
        }
        sum += (0..Rows::<8>::COUNT).map(|lane| x[lane]).sum::<f64>();
    }
    sum
}

/// Nanoseconds of a member and step: the best of five.
fn time(steps: u64, mut run: impl FnMut(u64)) -> f64 {
    let times = (0..5).map(|_| {
        let clock = Instant::now();
        run(steps);
        clock.elapsed().as_secs_f64()
    });
    1e9 * times.fold(f64::INFINITY, f64::min) / (steps * MEMBERS as u64) as f64
}

fn ensemble<S: Rides<Kepler, 2> + Sync>(scheme: S, dt: f64, every: u64, lanes: usize, steps: u64) {
    let members = Ensemble::of(MEMBERS).law(law).start(start).scheme(scheme).dt(dt).look_every(every);
    let run = members.lanes(lanes).threads(1).run(steps).expect("a step that is a number");
    assert_eq!(black_box(run).failures().count(), 0);
}

/// As [`ensemble`], with passages of the pericentre.
fn events<S: Rides<Kepler, 2> + Sync>(scheme: S, dt: f64, lanes: usize, steps: u64) {
    let members = Ensemble::of(MEMBERS).law(law).start(start).scheme(scheme).dt(dt).look_every(100).lanes(lanes);
    let members = members.with(|_, member| member.event(|state| state.q[1], Crossing::Rising));
    let run = members.threads(1).run(steps).expect("a step that is a number");
    assert!(black_box(run).members().flatten().all(|run| !run.events().is_empty()));
}

fn compare<S: Rides<Kepler, 2> + Sync>(name: &str, scheme: S, dt: f64, steps: u64) {
    let together = time(steps, |steps| ensemble(scheme, dt, 100, usize::MAX, steps));
    let each = time(steps, |steps| ensemble(scheme, dt, 1, usize::MAX, steps));
    let alone = time(steps, |steps| ensemble(scheme, dt, 100, 1, steps));
    let [met, met_alone] = [usize::MAX, 1].map(|lanes| time(steps, |steps| events(scheme, dt, lanes, steps)));
    let [ratio, met_ratio] = [alone / together, met_alone / met];
    println!(
        "{name:<36} {together:9.2} {each:12.2} {alone:9.2} {ratio:9.2} {met:12.2} {met_alone:9.2} {met_ratio:9.2}"
    );
}

/// A sun, and planets on circles that are tilted.
fn planets<const N: usize>(k: usize) -> Scene<3, (), ((), OnPairs<Gravity>)> {
    let sun = Scene::new().body(1.0, [0.0; 3], [0.0; 3]);
    let planets = (1..N).fold(sun, |scene, i| {
        let (r, angle) = (1.6_f64.powi(i as i32), 1.3 * i as f64 + 0.1 * k as f64);
        let (speed, [x, y]) = (r.sqrt().recip(), [angle.cos(), angle.sin()]);
        scene.body(1e-4 * i as f64, [r * x, r * y, 0.02 * r * x], [-speed * y, speed * x, 0.01 * speed])
    });
    planets.pairs(Gravity { g: 1.0 })
}

/// Scenes of N bodies: side by side in lanes, each alone as a law, and each alone as a scene.
macro_rules! scenes {
    ($($scheme:expr, $n:literal, $k:literal, $steps:expr;)*) => {$({
        let law = |k| planets::<$n>(k).as_law::<$n, $k>();
        let ensemble = |lanes: usize, steps: u64| {
            let members = Ensemble::of(MEMBERS).scene(law).scheme($scheme).dt(0.02).look_every(100);
            let run = members.lanes(lanes).threads(1).run(steps).expect("a step that is a number");
            assert_eq!(black_box(run).failures().count(), 0);
        };
        let [together, alone] = [usize::MAX, 1].map(|lanes| time($steps, |steps| ensemble(lanes, steps)));
        let each = time($steps, |steps| {
            let scene = |k| Simulation::scene(planets::<$n>(k)).scheme($scheme).dt(0.02).record_every(100);
            let run = Ensemble::each(MEMBERS, scene).threads(1).run(steps).expect("a step that is a number");
            assert_eq!(black_box(run).failures().count(), 0);
        });
        let name = format!("{} bodies, {}", $n, stringify!($scheme));
        println!("{name:<36} {together:9.0} {alone:12.0} {each:9.0} {:9.2} {:9.2}", alone / together, each / together);
    })*};
}

fn main() {
    let steps = 20_000;
    println!("nanoseconds a member and step, {MEMBERS} planets on one core");
    let least = time(steps, |steps| {
        black_box(bound(steps));
    });
    println!("a root and a quotient, 8 x 8 lanes      {least:9.2}");
    for (rows, by_hand) in [(1, by_hand::<1> as fn(u64) -> f64), (2, by_hand::<2>), (4, by_hand::<4>)] {
        let time = time(steps, |steps| {
            black_box(by_hand(steps));
        });
        println!("leap-frog by hand, {rows} x 8 lanes        {time:9.2}");
    }
    println!(
        "\nscheme                                 in lanes  a look each     alone     ratio   with events     alone     ratio"
    );
    compare("Leapfrog", Leapfrog, 0.01, steps);
    compare("Nystrom::order6()", Nystrom::order6(), 0.05, steps / 5);
    compare("DiscreteGradient", DiscreteGradient, 0.01, steps / 5);
    compare("Implicit", Implicit, 0.01, steps / 5);
    compare("Composed::order6(DiscreteGradient)", Composed::order6(DiscreteGradient), 0.05, steps / 20);
    compare("RungeKuttaNystrom::order12()", RungeKuttaNystrom::order12(), 0.05, steps / 20);
    compare("Gauss::order16()", Gauss::order16(), 0.05, steps / 20);
    compare("LineIntegral::order6()", LineIntegral::order6(), 0.05, steps / 20);
    println!("\nscene                                  in lanes    law alone     scene     law/lanes  scene/lanes");
    scenes! {
        Leapfrog, 3, 9, steps / 10;
        Leapfrog, 5, 15, steps / 10;
        Leapfrog, 10, 30, steps / 20;
        Nystrom::order6(), 3, 9, steps / 20;
        Nystrom::order6(), 5, 15, steps / 20;
        Nystrom::order6(), 10, 30, steps / 40;
        DiscreteGradient, 3, 9, steps / 40;
        DiscreteGradient, 5, 15, steps / 40;
        Gauss::order16(), 3, 9, steps / 40;
        Gauss::order16(), 5, 15, steps / 40;
    }
}
