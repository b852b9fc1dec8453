//! Down quadratic hills in scenes that are not quadratic by type: under drag, in a box, with a cut-off. A step is that of linear
//! algebra, or refused where no root continues that of a shorter step.

use dmech::Interrupted;
use dmech::models::pairs::Spring;
use dmech::prelude::*;
use dmech::scene::Scene;
use nalgebra::{DMatrix, DVector};

/// Φ = −k x²/2 + k y²/2 on each body, of a determinant that changes its sign.
#[derive(Clone, Copy, Debug)]
struct Saddle {
    k: f64,
}

#[dmech::law]
impl Saddle {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        0.5 * self.k * (q[1] * q[1] - q[0] * q[0])
    }
}

/// Φ = −k |q|²/2, of one that does not.
#[derive(Clone, Copy, Debug)]
struct Hill {
    k: f64,
}

#[dmech::law]
impl Hill {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -0.5 * self.k * (q[0] * q[0] + q[1] * q[1])
    }
}

/// Two bodies push each other apart, k |d|²/2 downhill.
#[derive(Clone, Copy, Debug)]
struct Push {
    k: f64,
}

#[dmech::law]
impl Push {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        -0.5 * self.k * r * r
    }
}

/// A medium and a magnetic field.
#[derive(Clone, Copy, Debug)]
struct Medium {
    drag: f64,
    turn: f64,
}

#[dmech::law]
impl Medium {
    #[force]
    fn force(&self, v: [f64; 2]) -> [f64; 2] {
        [self.turn * v[1] - self.drag * v[0], -self.turn * v[0] - self.drag * v[1]]
    }
}

/// The medium of most cases.
const MEDIUM: Medium = Medium { drag: 0.8, turn: 0.0 };

/// Separations are far smaller.
const FAR: f64 = 1e12;

/// Steps of these parts of the longest. Of 0.999 some are refused too: their roots are a thousand times as far as Newton's guess.
const PARTS: [f64; 7] = [0.3, 0.99, 1.001, 1.4, 3.0, 10.0, 1e4];

/// [`Composed::order4`](dmech::Composed).
const STAGES: [f64; 7] = {
    let (side, middle) = (0.239_069_765_742_321_25, -0.434_418_594_453_927_55);
    [side, side, side, middle, side, side, side]
};

fn mass(i: usize) -> f64 {
    0.7 + 0.5 * i as f64
}

fn place(i: usize) -> [[f64; 2]; 2] {
    let x = i as f64;
    [[0.3 + x, 0.3 * x * x - 0.8], [0.2 * x - 0.4, 0.5 - 0.3 * x]]
}

fn bodies(n: usize) -> Scene<2> {
    (0..n).fold(Scene::new(), |scene, i| scene.body(mass(i), place(i)[0], place(i)[1]))
}

/// One of them pinned.
fn pinned(n: usize, pin: usize) -> Scene<2> {
    let scene = (0..n).fold(Scene::new(), |scene, i| {
        let [q, v] = place(i);
        scene.body(mass(i), q, if i == pin { [0.0; 2] } else { v })
    });
    scene.pin(pin)
}

/// m x″ = −K x − C x′ for the bodies that are not pinned, body after body, as M^(−1/2) K M^(−1/2) and the like.
#[derive(Clone)]
struct Linear {
    free: Vec<usize>,
    stiffness: DMatrix<f64>,
    medium: DMatrix<f64>,
    /// What pinned bodies add to K q.
    pins: DVector<f64>,
}

impl Linear {
    fn of(n: usize, pinned: &[usize], [x, y, link]: [f64; 3], links: &[(usize, usize)], medium: Medium) -> Self {
        let (mut k, mut c) = (DMatrix::zeros(2 * n, 2 * n), DMatrix::zeros(2 * n, 2 * n));
        for i in 0..n {
            (k[(2 * i, 2 * i)], k[(2 * i + 1, 2 * i + 1)]) = (x, y);
            for (row, column, entry) in
                [(0, 0, medium.drag), (1, 1, medium.drag), (0, 1, -medium.turn), (1, 0, medium.turn)]
            {
                c[(2 * i + row, 2 * i + column)] = entry;
            }
        }
        for &(a, b) in links {
            for component in 0..2 {
                for (i, j, sign) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
                    k[(2 * i + component, 2 * j + component)] += sign * link;
                }
            }
        }
        let free: Vec<_> = (0..2 * n).filter(|i| !pinned.contains(&(i / 2))).collect();
        let scaled = |matrix: &DMatrix<f64>| {
            DMatrix::from_fn(free.len(), free.len(), |i, j| {
                let (i, j) = (free[i], free[j]);
                matrix[(i, j)] / (mass(i / 2) * mass(j / 2)).sqrt()
            })
        };
        let pins = free.iter().map(|&i| {
            let held = pinned.iter().flat_map(|&body| [2 * body, 2 * body + 1]);
            held.map(|j| k[(i, j)] * place(j / 2)[0][j % 2]).sum::<f64>() / mass(i / 2).sqrt()
        });
        let pins = DVector::from_iterator(free.len(), pins);
        Linear { stiffness: scaled(&k), medium: scaled(&c), pins, free }
    }

    /// 1 + θ h C/2 + θ² h² s K/4, s the share of the scheme.
    fn matrix(&self, h: f64, share: f64) -> DMatrix<f64> {
        let n = self.free.len();
        DMatrix::identity(n, n) + 0.5 * h * &self.medium + 0.25 * share * h * h * &self.stiffness
    }

    /// Whether the matrix is regular all the way to a step of h.
    fn continues(&self, h: f64, share: f64) -> bool {
        // Where it is symmetric; a determinant that a field keeps from 0 is positive.
        let least = |matrix: DMatrix<f64>| match matrix == matrix.transpose() {
            true => matrix.symmetric_eigenvalues().min(),
            false => matrix.determinant(),
        };
        (1..=8).rev().all(|part| least(self.matrix(f64::from(part) / 8.0 * h, share)) > 0.0)
    }

    /// The longest step, if there is one.
    fn longest(&self, share: f64, stages: &[f64]) -> f64 {
        // Stages are of one length but for that in the middle.
        let distinct = [stages[0], stages[stages.len() / 2]];
        let taken = |h: f64| distinct.iter().all(|stage| self.continues(stage * h, share));
        let mut most = 1e-2;
        while taken(most) && most < 1e3 {
            most *= 1.5;
        }
        let mut least = most / 1.5;
        for _ in 0..20 {
            let middle = 0.5 * (least + most);
            if taken(middle) { least = middle } else { most = middle }
        }
        least
    }

    /// Where the free coordinates are after a step: of the trapezoid, which is the energy-exact step too.
    fn step(&self, h: f64, stages: &[f64]) -> DVector<f64> {
        let column = |what: usize| {
            DVector::from_iterator(
                self.free.len(),
                self.free.iter().map(|i| mass(i / 2).sqrt() * place(i / 2)[what][i % 2]),
            )
        };
        let (mut q, mut v) = (column(0), column(1));
        for stage in stages {
            let h = stage * h;
            let right = h * &v - 0.5 * h * h * (&self.stiffness * &q + &self.pins);
            let moved = self.matrix(h, 1.0).lu().solve(&right).unwrap();
            v = 2.0 / h * &moved - v;
            q += moved;
        }
        DVector::from_iterator(q.len(), self.free.iter().zip(q.iter()).map(|(i, q)| q / mass(i / 2).sqrt()))
    }

    /// What a run has done is what is right.
    fn judge<X>(
        &self,
        run: Result<Run<X>, Interrupted<X>>,
        coordinates: impl Fn(&X) -> Vec<f64>,
        place: &str,
        right: Option<DVector<f64>>,
        taken: bool,
    ) {
        match run {
            Ok(run) => {
                assert!(taken, "{place}: taken");
                let end = coordinates(run.last());
                let Some(right) = right else { return };
                let size = right.amax();
                for (&i, right) in self.free.iter().zip(right.iter()) {
                    assert!((end[i] - right).abs() < 1e-9 * size, "{place}: {end:?} for {right}");
                }
            }
            Err(interrupted) => {
                let cause = interrupted.cause();
                let Error::NotConverged { step: 1, .. } = cause else { panic!("{place}: {cause}") };
                assert!(!taken, "{place}: {cause}");
            }
        }
    }
}

/// Runs a scene, and the same bodies as a law, one step of each length by each scheme.
macro_rules! judged {
    ($tried:ident, $linear:expr, $n:literal, $scene:expr, $($name:literal $scheme:expr, $share:expr, $stages:expr;)*) => {$(
        let linear: &Linear = $linear;
        let longest = linear.longest($share, $stages);
        for part in PARTS {
            let h = part * longest;
            let right = (part < 1.0 && $share == 1.0).then(|| linear.step(h, $stages));
            let place = format!("{} {} in steps of {part} of the longest", stringify!($scene), $name);
            let run = Simulation::scene($scene).scheme($scheme).dt(h).run(1);
            linear.judge(run, |state| state.q.as_flattened().to_vec(), &place, right.clone(), part < 1.0);
            let law = $scene.as_law::<$n, { 2 * $n }>();
            let start = law.start();
            let run = Simulation::new(law, start).scheme($scheme).dt(h).run(1);
            linear.judge(run, |state| state.q.to_vec(), &format!("as a law, {place}"), right, part < 1.0);
            $tried += 1;
        }
    )*};
}

macro_rules! under_drag {
    ($tried:ident, $linear:expr, $n:literal, $scene:expr) => {
        judged! { $tried, $linear, $n, $scene,
            "Implicit" Implicit, 1.0, &[1.0];
            "DiscreteGradient" DiscreteGradient, 1.0, &[1.0];
            "Composed" Composed::order4(DiscreteGradient), 1.0, &STAGES;
            "Composed Implicit" Composed::order4(Implicit), 1.0, &STAGES;
        }
    };
}

macro_rules! free {
    ($tried:ident, $linear:expr, $n:literal, $scene:expr) => {
        under_drag!($tried, $linear, $n, $scene);
        judged! { $tried, $linear, $n, $scene, "Kanatani" Kanatani, 2.0, &[1.0]; }
    };
}

const NONE: Medium = Medium { drag: 0.0, turn: 0.0 };
const K: f64 = 1.3;

#[test]
fn under_drag() {
    let mut tried = 0;
    let of =
        |n: usize, pinned: &[usize], own: [f64; 3], links: &[(usize, usize)]| Linear::of(n, pinned, own, links, MEDIUM);
    under_drag!(tried, &of(1, &[], [-K, K, 0.0], &[]), 1, bodies(1).field(Saddle { k: K }).field(MEDIUM));
    under_drag!(tried, &of(1, &[], [-K, -K, 0.0], &[]), 1, bodies(1).field(Hill { k: K }).field(MEDIUM));
    under_drag!(tried, &of(3, &[], [-K, K, 0.0], &[]), 3, bodies(3).field(Saddle { k: K }).field(MEDIUM));
    under_drag!(tried, &of(2, &[], [0.0, 0.0, -K], &[(0, 1)]), 2, bodies(2).pairs(Push { k: K }).field(MEDIUM));
    under_drag!(
        tried,
        &of(3, &[], [0.0, 0.0, -K], &[(0, 1), (0, 2), (1, 2)]),
        3,
        bodies(3).pairs(Push { k: K }).field(MEDIUM)
    );
    under_drag!(tried, &of(3, &[], [0.0, 0.0, -K], &[(0, 1), (1, 2)]), 3, bodies(3).chain(Push { k: K }).field(MEDIUM));
    under_drag!(
        tried,
        &of(3, &[1], [0.0, 0.0, -K], &[(0, 1), (1, 2)]),
        3,
        pinned(3, 1).chain(Push { k: K }).field(MEDIUM)
    );
    under_drag!(
        tried,
        &of(3, &[0], [0.0, 0.0, -K], &[(0, 2), (1, 2)]),
        3,
        pinned(3, 0).bonds(Push { k: K }, [(2, 0), (1, 2)]).field(MEDIUM)
    );
    under_drag!(
        tried,
        &of(3, &[], [-K, K, 0.5], &[(0, 1), (1, 2)]),
        3,
        bodies(3).chain(Push { k: -0.5 }).field(Saddle { k: K }).field(MEDIUM)
    );
    assert_eq!(tried, 9 * 4 * PARTS.len());
}

#[test]
fn in_a_box() {
    let mut tried = 0;
    let of =
        |n: usize, pinned: &[usize], own: [f64; 3], links: &[(usize, usize)]| Linear::of(n, pinned, own, links, NONE);
    free!(tried, &of(2, &[], [0.0, 0.0, -K], &[(0, 1)]), 2, bodies(2).pairs(Push { k: K }).periodic([FAR; 2]));
    free!(
        tried,
        &of(3, &[], [0.0, 0.0, -K], &[(0, 1), (0, 2), (1, 2)]),
        3,
        bodies(3).pairs(Push { k: K }).periodic([FAR; 2])
    );
    free!(tried, &of(3, &[], [0.0, 0.0, -K], &[(0, 1), (1, 2)]), 3, bodies(3).chain(Push { k: K }).periodic([FAR; 2]));
    free!(
        tried,
        &of(3, &[2], [0.0, 0.0, -K], &[(0, 1), (1, 2)]),
        3,
        pinned(3, 2).chain(Push { k: K }).periodic([FAR; 2])
    );
    free!(
        tried,
        &of(3, &[], [0.0, 0.0, -K], &[(0, 2), (1, 2)]),
        3,
        bodies(3).bonds(Push { k: K }, [(2, 0), (1, 2)]).periodic([FAR; 2])
    );
    free!(
        tried,
        &of(3, &[], [-K, K, 0.4], &[(0, 1), (1, 2)]),
        3,
        bodies(3).chain(Push { k: -0.4 }).field(Saddle { k: K }).periodic([FAR; 2])
    );
    assert_eq!(tried, 6 * 5 * PARTS.len());
}

#[test]
fn with_a_cut_off() {
    let mut tried = 0;
    let of =
        |n: usize, pinned: &[usize], own: [f64; 3], links: &[(usize, usize)]| Linear::of(n, pinned, own, links, NONE);
    free!(tried, &of(2, &[], [0.0, 0.0, -K], &[(0, 1)]), 2, bodies(2).pairs(Push { k: K }).cutoff(FAR));
    free!(tried, &of(3, &[], [0.0, 0.0, -K], &[(0, 1), (0, 2), (1, 2)]), 3, bodies(3).pairs(Push { k: K }).cutoff(FAR));
    free!(
        tried,
        &of(3, &[0], [0.0, 0.0, -K], &[(0, 1), (0, 2), (1, 2)]),
        3,
        pinned(3, 0).pairs(Push { k: K }).cutoff(FAR)
    );
    free!(
        tried,
        &of(3, &[], [-K, K, 0.4], &[(0, 1), (0, 2), (1, 2)]),
        3,
        bodies(3).field(Saddle { k: K }).pairs(Push { k: -0.4 }).cutoff(FAR)
    );
    assert_eq!(tried, 4 * 5 * PARTS.len());
}

/// In a magnetic field the determinant of a round hill is (1 − h² k/4m)² + (h b/2m)², and no step is too long.
#[test]
fn charges_on_a_hill_are_stepped_as_long_as_there_is_a_root_all_the_way() {
    let medium = Medium { drag: 0.0, turn: 0.4 };
    let linear = Linear::of(3, &[], [-K, -K, 0.0], &[], medium);
    // Longer ones lose what the field adds to the hill in its rounding.
    for part in &PARTS[..6] {
        let h = part * 2.0 * (mass(0) / K).sqrt();
        let scene = || bodies(3).field(Hill { k: K }).field(medium);
        for scheme in [0, 1] {
            let run = || Simulation::scene(scene()).dt(h);
            let run = if scheme == 0 { run().scheme(Implicit).run(1) } else { run().scheme(DiscreteGradient).run(1) };
            linear.judge(
                run,
                |state| state.q.as_flattened().to_vec(),
                &format!("{scheme} {part}"),
                Some(linear.step(h, &[1.0])),
                true,
            );
        }
    }
}

/// Two bodies on a line, pushed apart by their spring in steps of several of its periods: Newton's first root is that of bodies which
/// have changed places, and the one that continues the motion is followed.
#[test]
fn a_root_that_is_gone_over_to_is_left_again() {
    let scene = || Scene::new().body(1.0, [0.0, 0.0], [0.0, 0.0]).body(1.0, [0.6, 0.0], [0.4, 0.0]);
    for k in 1..=60 {
        let h = 0.05 * f64::from(k);
        // r = r₀ + h u − a (r₀ − l) − a (r − l), linear as long as r > 0.
        let a = h * h * 20.0 / 2.0;
        let r = (0.6 + 0.4 * h - a * (0.6 - 1.0) + a) / (1.0 + a);
        let chain = Simulation::scene(scene().chain(Spring { k: 20.0, length: 1.0 })).scheme(Implicit).dt(h);
        let pairs = Simulation::scene(scene().pairs(Spring { k: 20.0, length: 1.0 })).scheme(Implicit).dt(h);
        for run in [chain.run(1), pairs.run(1)] {
            let q = run.unwrap_or_else(|lost| panic!("steps of {h}: {lost}")).last().q.clone();
            assert!((q[1][0] - q[0][0] - r).abs() < 1e-12, "steps of {h}: {q:?} for a distance of {r}");
        }
    }
}

/// A force of which each component is felt by the next, round and round: entries without an opposite make no symmetric matrix, and its
/// determinant is positive for every step.
#[test]
fn a_cycle_is_not_symmetric() {
    #[derive(Clone, Copy, Debug)]
    struct Cycle {
        k: f64,
        c: f64,
    }
    #[dmech::law]
    impl Cycle {
        #[force]
        fn force(&self, q: [f64; 3]) -> [f64; 3] {
            [self.k * q[0] - self.c * q[1], self.k * q[1] - self.c * q[2], self.k * q[2] - self.c * q[0]]
        }
    }
    let law = Cycle { k: 1.0, c: 3.0 };
    let start = || State::new([0.3, 0.1, -0.2], [0.1, 0.0, 0.0]);
    let scene = || Scene::new().body(1.0, start().q, start().v).field(law);
    for h in [0.5, 1.9, 2.0, 2.05, 2.5, 4.0, 40.0] {
        let alone = *Simulation::new(law, start()).scheme(Implicit).dt(h).run(1).unwrap().last();
        let body = Simulation::scene(scene()).scheme(Implicit).dt(h).run(1).unwrap().last().q[0];
        let few = scene().as_law::<1, 3>();
        let few = Simulation::new(few, start()).scheme(Implicit).dt(h).run(1).unwrap().last().q;
        for k in 0..3 {
            let [body, few] = [body[k], few[k]].map(|q| (q - alone.q[k]).abs());
            assert!(body < 1e-12 && few < 1e-12, "steps of {h}: off by {body:e} and {few:e}");
        }
    }
}
