//! A liquid near its triple point: atoms of Lennard-Jones in a periodic box.
//!
//! ```text
//! cargo run --release --example liquid             500 atoms, some seconds
//! cargo run --release --example liquid -- 32000    or any 4 n³: a minute or two
//! ```
//!
//! Atoms attract and repel each other by 4 (r⁻¹² − r⁻⁶), cut off at 2.5 and shifted to 0 there, in units of Lennard-Jones.
//! They start as a crystal of 0.8442 atoms in a unit of volume, melt, and are brought to the temperature 0.722, where
//! L. Verlet (Phys. Rev. 159 (1967) 98) saw this liquid. The program measures temperature, energy, pressure by the virial
//! theorem and the radial distribution function. Energy and pressure are those of atoms whose law is not cut off, in the
//! places to which the law with a cut-off has brought them: farther away than half the box the liquid is taken as uniform.
//! Beside them stand those of the equation of state of J. Kolafa and I. Nezbeda (Fluid Phase Equilib. 100 (1994) 1), which
//! was fitted to simulations; here, near the triple point, the isotherm is so steep that a hundredth of the density is worth
//! 0.14 of the pressure.
//!
//! It ends with what becomes of the energy by leap-frog, whose force jumps at the cut-off, and by `DiscreteGradient`.

#[path = "shared/picture.rs"]
mod picture;

use std::f64::consts::PI;
use std::path::PathBuf;
use std::time::Instant;

use dmech::models::pairs::LennardJones;
use dmech::prelude::*;
use dmech::scene::{OnNear, Periodic, SceneStepper};
use picture::{Axis, Drawn, GREEN, INK, OCHRE};

const ATOMS: LennardJones = LennardJones { epsilon: 1.0, sigma: 1.0 };
const DENSITY: f64 = 0.8442;
const TEMPERATURE: f64 = 0.722;
const CUTOFF: f64 = 2.5;
const DT: f64 = 0.004;
/// How far the radial distribution function goes, and in how many bins: half of the smallest box.
const FAR: f64 = 4.19;
const BINS: usize = 210;

type Liquid = SceneStepper<3, ((), OnNear<LennardJones>), Leapfrog, (), Periodic<3>>;
type Atoms = Scene<3, (), ((), OnNear<LennardJones>), Periodic<3>>;

/// The side of the box.
fn side(atoms: usize) -> f64 {
    (atoms as f64 / DENSITY).cbrt()
}

/// 4 n³ atoms of a cubic crystal, closest packed, with velocities at random.
fn crystal(n: usize) -> Atoms {
    let atoms = 4 * n.pow(3);
    let spacing = side(atoms) / n as f64;
    let corner = |i: usize| [i / n / n, i / n % n, i % n].map(|x| x as f64);
    let basis = [[0.25, 0.25, 0.25], [0.25, 0.75, 0.75], [0.75, 0.25, 0.75], [0.75, 0.75, 0.25]];
    let places = (0..n.pow(3)).flat_map(|i| basis.map(|at| [0, 1, 2].map(|k| spacing * (corner(i)[k] + at[k]))));
    let mut dice = 1_u64;
    let mut roll = || {
        dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (dice >> 11) as f64 / (1_u64 << 53) as f64
    };
    // Sums of twelve numbers are nearly normal.
    let mut speeds: Vec<[f64; 3]> =
        (0..atoms).map(|_| [(); 3].map(|()| (0..12).map(|_| roll()).sum::<f64>() - 6.0)).collect();
    for k in 0..3 {
        let mean = speeds.iter().map(|v| v[k]).sum::<f64>() / atoms as f64;
        speeds.iter_mut().for_each(|v| v[k] -= mean);
    }
    let scene = places.zip(speeds).fold(Scene::new(), |scene, (q, v)| scene.body(1.0, q, v));
    scene.pairs(ATOMS).cutoff(CUTOFF).periodic([side(atoms); 3])
}

/// 2 K/(3 (N − 1)): the momentum of all is 0.
fn temperature(v: &[[f64; 3]]) -> f64 {
    v.as_flattened().iter().map(|v| v * v).sum::<f64>() / (3 * (v.len() - 1)) as f64
}

/// Velocities as they are at a temperature.
fn heated(mut state: SceneState<3>, to: f64) -> SceneState<3> {
    let factor = (to / temperature(&state.v)).sqrt();
    state.v.iter_mut().flatten().for_each(|v| *v *= factor);
    state
}

/// The crystal melted and the liquid brought to the temperature, until it keeps it.
fn liquid(n: usize) -> Result<SceneState<3>, Error> {
    let mut state = heated(Simulation::scene(crystal(n)).start(), 2.2);
    for round in 0..30 {
        let mut stepper = leapfrog(n, &state)?;
        stepper.advance(100)?;
        state = heated(stepper.state(), if round < 10 { 1.4 } else { TEMPERATURE });
        state.t = 0.0;
    }
    Ok(state)
}

fn leapfrog(n: usize, from: &SceneState<3>) -> Result<Liquid, Error> {
    Simulation::scene(crystal(n).starting_from(from)).scheme(Leapfrog).dt(DT).stepper()
}

/// Visits the distance of every two atoms that are nearer than `FAR`, by cells of that size.
fn each_near(q: &[[f64; 3]], mut visit: impl FnMut(f64)) {
    let side = side(q.len());
    let cells = (side / FAR) as usize;
    let of = |x: f64| ((x / side - (x / side).floor()) * cells as f64) as usize % cells;
    let mut inside = vec![Vec::new(); cells.pow(3)];
    for (i, q) in q.iter().enumerate() {
        inside[(of(q[0]) * cells + of(q[1])) * cells + of(q[2])].push(i);
    }
    let beside = |c: usize| {
        let mut all = [(c + cells - 1) % cells, c, (c + 1) % cells].to_vec();
        all.sort_unstable();
        all.dedup();
        all
    };
    for (a, place) in q.iter().enumerate() {
        let [x, y, z] = place.map(|x| beside(of(x)));
        let row = |x: usize| y.iter().map(move |y| x * cells + y);
        let around = x.iter().flat_map(|&x| row(x)).flat_map(|row| z.iter().map(move |z| row * cells + z));
        for &b in around.flat_map(|cell| &inside[cell]).filter(|&&b| b < a) {
            let apart = [0, 1, 2].map(|k| place[k] - q[b][k]).map(|d| d - side * (d / side).round());
            let r = apart.iter().map(|d| d * d).sum::<f64>().sqrt();
            if r < FAR {
                visit(r);
            }
        }
    }
}

/// Sums over states.
#[derive(Default)]
struct Measured {
    states: u32,
    temperature: f64,
    /// Of the potential that is not cut off, up to `FAR`.
    energy: f64,
    virial: f64,
    distances: Vec<f64>,
}

impl Measured {
    fn add(&mut self, state: &SceneState<3>) {
        self.distances.resize(BINS, 0.0);
        self.states += 1;
        self.temperature += temperature(&state.v);
        each_near(&state.q, |r| {
            self.distances[(r / FAR * BINS as f64) as usize] += 1.0;
            let s6 = r.powi(-6);
            self.energy += 4.0 * (s6 * s6 - s6);
            self.virial += 24.0 * (2.0 * s6 * s6 - s6);
        });
    }

    /// Temperature, energy of an atom and pressure; farther away than `FAR` the liquid is taken as uniform.
    fn values(&self, atoms: usize) -> [f64; 3] {
        let (states, atoms, cube) = (f64::from(self.states), atoms as f64, FAR.powi(-3));
        let temperature = self.temperature / states;
        let beyond = 8.0 / 3.0 * PI * DENSITY * (cube.powi(3) / 3.0 - cube);
        let pressure_beyond = 16.0 / 3.0 * PI * DENSITY * DENSITY * (2.0 / 3.0 * cube.powi(3) - cube);
        let pressure = DENSITY * (temperature + self.virial / (3.0 * states * atoms));
        [temperature, self.energy / (states * atoms) + beyond, pressure + pressure_beyond]
    }

    /// g(r): how many atoms there are at a distance, of those of a uniform liquid.
    fn distribution(&self, atoms: usize) -> Vec<(f64, f64)> {
        let width = FAR / BINS as f64;
        let uniform = |i: usize| {
            let shell = 4.0 / 3.0 * PI * width.powi(3) * ((i + 1).pow(3) - i.pow(3)) as f64;
            0.5 * (atoms - 1) as f64 * DENSITY * shell * f64::from(self.states)
        };
        self.distances.iter().enumerate().map(|(i, n)| ((i as f64 + 0.5) * width, n / uniform(i))).collect()
    }
}

/// Energy of an atom and pressure by the equation of state of Kolafa and Nezbeda.
fn equation_of_state(t: f64, rho: f64) -> [f64; 2] {
    const GAMMA: f64 = 1.929_072_78;
    // C_ij of ρʲ T^(i/2), j from 2 on.
    let terms: [(f64, &[f64]); 4] = [
        (0.0, &[2.015_467_97, -28.178_816_36, 28.283_138_47, -10.424_028_73]),
        (-0.5, &[-19.583_716_55, 75.623_402_89, -120.705_865_98, 93.927_403_28, -27.377_373_54]),
        (-1.0, &[29.344_705_20, -112.353_569_37, 170.649_089_80, -123.066_691_87, 34.422_889_69]),
        (-2.0, &[-13.370_319_68, 65.380_595_70, -115.092_331_13, 88.919_730_82, -25.620_998_90]),
    ];
    // The diameter of hard spheres and the second virial coefficient beside theirs, with their slopes in 1/T.
    let root = t.sqrt();
    let d = -0.063_920_968 * t.ln() + 0.011_117_524 / t - 0.076_383_859 / root + 1.080_142_248 + 0.000_693_129 * root;
    let d_slope = 0.063_920_968 * t + 0.011_117_524 - 0.5 * (0.076_383_859 + 0.000_693_129 * t) * root;
    let second =
        [0.024_598_77, 0.0, -7.021_819_62, 2.906_162_79, -4.137_499_95, 0.873_613_69, 0.431_020_52, -0.585_449_78];
    let powers = || second.iter().enumerate().map(|(i, c)| (0.5 * i as f64, c));
    let b: f64 = powers().map(|(power, c)| c * t.powf(-power)).sum();
    let b_slope: f64 = powers().map(|(power, c)| power * c * t.powf(1.0 - power)).sum();
    let eta = PI / 6.0 * rho * d.powi(3);
    let hard = (1.0 + eta * (1.0 + eta * (1.0 - eta / 1.5 * (1.0 + eta)))) / (1.0 - eta).powi(3);
    let fade = (-GAMMA * rho * rho).exp();
    let sum = |weight: &dyn Fn(f64, f64) -> f64| -> f64 {
        let of = |&(i, c): &(f64, &[f64])| -> f64 {
            c.iter().zip(2..).map(|(c, j)| weight(i, f64::from(j)) * c * t.powf(i) * rho.powi(j)).sum()
        };
        terms.iter().map(of).sum()
    };
    let energy = 3.0 * (hard - 1.0) * d_slope / d + rho * b_slope * fade + sum(&|i, _| 1.0 - i);
    let pressure = rho * (t * (hard + b * fade * rho * (1.0 - 2.0 * GAMMA * rho * rho)) + sum(&|_, j| j));
    [energy, pressure]
}

fn main() -> Drawn {
    let asked: usize = std::env::args().nth(1).map_or(Ok(500), |atoms| atoms.parse())?;
    let n = (1..).find(|n: &usize| 4 * n.pow(3) >= asked.max(500)).unwrap_or(5);
    let atoms = 4 * n.pow(3);
    println!("\n{atoms} atoms of Lennard-Jones in a box of side {:.4}, cut off at {CUTOFF}; dt = {DT}\n", side(atoms));
    let clock = Instant::now();
    let start = liquid(n)?;
    let mut stepper = leapfrog(n, &start)?;
    let (states, between) = if atoms > 4000 { (40, 25) } else { (1500, 20) };
    println!("melted and brought to T = {TEMPERATURE} in {:.1} s", clock.elapsed().as_secs_f64());
    let (mut measured, mut stepping) = (Measured::default(), 0.0);
    for _ in 0..states {
        let clock = Instant::now();
        stepper.advance(between)?;
        stepping += clock.elapsed().as_secs_f64();
        measured.add(&stepper.state());
    }
    let steps = states * between;
    println!("{steps} steps in {stepping:.1} s, {:.3} ms a step\n", 1e3 * stepping / steps as f64);
    let [t, energy, pressure] = measured.values(atoms);
    let [fitted, fitted_pressure] = equation_of_state(t, DENSITY);
    println!("{TABLE}");
    println!("temperature │ {t:>9.4} │");
    println!("energy      │ {energy:>9.4} │ {fitted:>9.4}");
    println!("pressure    │ {pressure:>9.4} │ {fitted_pressure:>9.4}");
    let distribution = measured.distribution(atoms);
    peaks(&distribution);
    energies()?;
    println!("\nPicture: {}", picture_of(&distribution, atoms)?.display());
    Ok(())
}

/// The first peak, the trough after it, and how many atoms are nearer than that.
fn peaks(distribution: &[(f64, f64)]) {
    let highest = |range: &[(f64, f64)]| range.iter().copied().fold((0.0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
    let first = highest(distribution);
    let after = |r: f64| distribution.iter().filter(move |at| at.0 > first.0 && at.0 < r);
    let trough = after(2.0).copied().fold((0.0, f64::MAX), |a, b| if b.1 < a.1 { b } else { a });
    let width = FAR / BINS as f64;
    let nearer = distribution.iter().filter(|at| at.0 < trough.0);
    let count: f64 = nearer.map(|(r, g)| 4.0 * PI * DENSITY * r * r * g * width).sum();
    println!(
        "\ng(r) has its first peak, {:.2}, at r = {:.2} and its trough, {:.2}, at {:.2}:",
        first.1, first.0, trough.1, trough.0
    );
    println!("{count:.1} atoms are nearer to an atom than that");
}

/// The largest errors of the energy of 500 atoms, by two schemes at some steps.
fn energies() -> Drawn {
    println!("{ENERGIES}");
    let start = liquid(5)?;
    let scene = || crystal(5).starting_from(&start);
    for dt in [0.002, 0.004, 0.008] {
        let steps = (2.0 / dt) as u64;
        let leapfrog = Simulation::scene(scene()).scheme(Leapfrog).dt(dt).record_every(10).run(steps)?;
        let exact = Simulation::scene(scene()).scheme(DiscreteGradient).dt(dt).record_every(10).run(steps)?;
        let error =
            |run: &Run<SceneState<3>>| run.drift(Invariant::Energy).map_or(f64::NAN, |drift| drift.max_relative());
        let time = |run: &Run<SceneState<3>>| 1e3 * run.report().elapsed().as_secs_f64() / steps as f64;
        println!(
            "{dt:<5} │ {:>8.0e} {:>8.2} │ {:>8.0e} {:>8.2}",
            error(&leapfrog),
            time(&leapfrog),
            error(&exact),
            time(&exact)
        );
    }
    Ok(())
}

fn picture_of(distribution: &[(f64, f64)], atoms: usize) -> Drawn<PathBuf> {
    picture::save("liquid.svg", [960, 480], |area| {
        let title = format!("{atoms} atoms at ρ = {DENSITY}, T = {TEMPERATURE}: radial distribution function");
        let (x, y) = (Axis::linear("r / σ", 0.0..FAR), Axis::linear("g(r)", 0.0..3.5));
        let mut chart = picture::chart(area, &title, x, y, 40)?;
        picture::line(&mut chart, vec![(0.0, 1.0), (FAR, 1.0)], INK, 0.8)?;
        picture::line(&mut chart, vec![(CUTOFF, 0.0), (CUTOFF, 3.5)], OCHRE, 1.2)?;
        picture::line(&mut chart, distribution.to_vec(), GREEN, 2.0)?;
        picture::label(&chart, (CUTOFF, 3.3), (8, 0), "cut-off", OCHRE)?;
        picture::label(&chart, (0.02, 1.0), (8, -12), "uniform", INK)
    })
}

const TABLE: &str = "
            │ measured  │ Kolafa and Nezbeda
────────────┼───────────┼────────────────────";

const ENERGIES: &str = "
500 atoms, 2 units of time: the largest relative error of the energy, and ms a step

dt    │      Leapfrog     │  DiscreteGradient
──────┼───────────────────┼───────────────────";
