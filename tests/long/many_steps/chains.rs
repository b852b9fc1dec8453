//! A chain is solved in one sweep along it and one back, eight bodies at a time: the motion is that of the dense matrix, for
//! any number of bodies, and a body costs the same in a long chain as in a short one.

use dmech::models::pairs::FermiPastaUlamTsingou;
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

/// A spring of charged ends: k (r − rest)²/2 + 0.07 mₐ m_b r⁴.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    k: f64,
    rest: f64,
}

#[dmech::law]
impl Stretch {
    #[pair]
    fn energy(&self, r: f64, ma: f64, mb: f64) -> f64 {
        0.5 * self.k * (r - self.rest).powi(2) + 0.07 * ma * mb * r.powi(4)
    }
}

/// Not symmetric in its ends: a spring between a and a point beside b.
#[derive(Clone, Copy, Debug)]
struct Askew {
    k: f64,
}

#[dmech::law]
impl Askew {
    #[pair]
    fn energy(&self, r: f64, a: &f64, b: &f64) -> f64 {
        self.k * (a + 2.0 * b) * (r * r + 0.3).sqrt()
    }
}

/// A bowl that tilts with time, and a steady push beside it: forces that do not depend on the velocity.
#[derive(Clone, Copy, Debug)]
struct Bowl {
    k: f64,
    push: f64,
}

#[dmech::law]
impl Bowl {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64, t: f64) -> f64 {
        let r2 = q[0] * q[0] + q[1] * q[1];
        self.k * m * (1.0 + 0.2 * t.sin()) * (r2 + 0.1 * r2 * r2)
    }

    #[force]
    fn pushed(&self, q: [f64; 2]) -> [f64; 2] {
        [self.push / (1.0 + q[0] * q[0]), 0.0]
    }
}

/// Nothing acts, between any two: the matrix becomes dense.
#[derive(Clone, Copy, Debug)]
struct Nothing {
    zero: f64,
}

#[dmech::law]
impl Nothing {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        self.zero * r * r
    }
}
const NOTHING: Nothing = Nothing { zero: 0.0 };

/// n bodies about one apart, with unequal masses, some pinned.
fn bodies<const D: usize>(n: usize) -> Scene<D, f64> {
    let mut scene = Scene::new();
    for i in 0..n {
        let x = i as f64;
        let pinned = i % 5 == 4;
        let mut q = [0.3 * (1.7 * x).sin(); D];
        q[0] = 1.1 * x + 0.2 * (2.3 * x).cos();
        let v = core::array::from_fn(|k| if pinned { 0.0 } else { 0.6 * (x + k as f64).cos() });
        scene = scene.body_with(1.0 + 0.4 * (3.1 * x).sin(), q, v, 0.5 + 0.2 * x.cos());
        if pinned {
            scene = scene.pin(i);
        }
    }
    scene
}

/// The largest difference of positions and velocities after a time of 2, relative to the size of the chain.
fn difference<const D: usize, L, M, S>(chain: Scene<D, f64, L>, dense: Scene<D, f64, M>, scheme: S) -> f64
where
    L: Term<D, f64>,
    M: Term<D, f64>,
    S: Scheme<SceneSystem<D, L::Ready>> + Scheme<SceneSystem<D, M::Ready>>,
{
    let end = |state: SceneState<D>| [state.q, state.v];
    let chain = Simulation::scene(chain).scheme(scheme).dt(0.04).run(50).expect("a chain");
    let dense = Simulation::scene(dense).scheme(scheme).dt(0.04).run(50).expect("a dense scene");
    let (a, b, start) = (end(chain.last().clone()), end(dense.last().clone()), end(chain.states()[0].clone()));
    let apart = |x: &[Vec<[f64; D]>; 2], y: &[Vec<[f64; D]>; 2]| {
        let components = |x: &[Vec<[f64; D]>; 2]| x.concat().concat();
        components(x).into_iter().zip(components(y)).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    };
    assert!(apart(&a, &start) > 0.1, "nothing moved");
    apart(&a, &b) / a[0].concat().iter().fold(1.0, |max: f64, x| max.max(x.abs()))
}

#[test]
fn a_chain_moves_as_with_a_dense_matrix() {
    let (stretch, askew, bowl) = (Stretch { k: 3.0, rest: 0.9 }, Askew { k: 0.8 }, Bowl { k: 0.15, push: 0.4 });
    let mut worst = 0.0_f64;
    let mut cases = 0;
    let mut check = |off: f64, what: &str| {
        assert!(off < 1e-13, "{what}: {off:e}");
        worst = worst.max(off);
        cases += 1;
    };
    for n in [1, 2, 3, 7, 8, 9, 10, 15, 16, 17, 18, 33] {
        macro_rules! against_dense {
            ($scheme:expr) => {
                let name = format!("{n} bodies, {:?}", $scheme);
                if n > 1 {
                    let line = || bodies::<1>(n).chain(stretch);
                    check(difference(line(), line().pairs(NOTHING), $scheme), &name);
                    let space = || bodies::<3>(n).chain(askew).chain(stretch);
                    check(difference(space(), space().pairs(NOTHING), $scheme), &name);
                }
                let plane = || bodies::<2>(n).field(bowl).chain(stretch).chain(askew);
                check(difference(plane(), plane().pairs(NOTHING), $scheme), &name);
            };
        }
        against_dense!(DiscreteGradient);
        against_dense!(Kanatani);
        against_dense!(Composed::order4(DiscreteGradient));
        against_dense!(Implicit);
    }
    println!("{cases} scenes, {worst:.1e} apart at most");
    assert!(cases > 100 && worst > 0.0);
}

/// Where nobody asks for the work of a step, a kick and the drift after it are one pass along the chain.
#[test]
fn a_chain_in_one_pass_moves_as_in_two() {
    for n in [2, 3, 8, 9, 10, 16, 17, 18, 33] {
        let scene = bodies::<2>(n).chain(Askew { k: 0.8 });
        let stepper =
            || Simulation::scene(scene.clone()).scheme(Nystrom::order8()).dt(0.07).stepper().expect("a chain");
        let (mut one, mut two) = (stepper(), stepper());
        one.advance(40).expect("steps");
        (0..40).for_each(|_| two.step().expect("a step"));
        assert_eq!(one.state(), two.state(), "{n} bodies");
    }
}

/// In a long smooth chain the forces on a body nearly cancel, and their sum has few digits; to look for more of them than
/// there are would cost corrections that a short chain does not need.
#[test]
fn a_long_chain_needs_no_more_corrections_than_a_short_one() {
    fn corrections<S: Scheme<SceneSystem<1, A>>, L: Term<1, f64, Ready = A>, A: dmech::scene::Acts<1>>(
        law: impl Fn(Scene<1, f64>) -> Scene<1, f64, L>,
        scheme: S,
        n: usize,
    ) -> f64 {
        let mode = |i: usize, k: f64| (std::f64::consts::PI * k * i as f64 / (n - 1) as f64).sin();
        let mut scene = Scene::new();
        for i in 0..n {
            scene = scene.body_with(1.0, [0.7 * mode(i, 1.0) + 0.3 * mode(i, 2.0)], [0.0], 0.0);
        }
        let scene = law(scene).pin(0).pin(n - 1);
        let mut stepper = Simulation::scene(scene).scheme(scheme).dt(0.05).stepper().expect("a chain");
        stepper.advance(40).expect("a finite motion");
        stepper.iterations() as f64 / 40.0
    }
    let law = |scene: Scene<1, f64>| scene.chain(FermiPastaUlamTsingou { k: 1.1, alpha: 0.0, beta: 0.3 });
    for n in [1000, 30_000] {
        for (scheme, corrections) in [
            ("Implicit", corrections(law, Implicit, n)),
            ("DiscreteGradient", corrections(law, DiscreteGradient, n)),
            ("Kanatani", corrections(law, Kanatani, n)),
        ] {
            println!("{scheme:<18} {n:>6} bodies: {corrections:.2} corrections a step");
            assert!((1.0..1.2).contains(&corrections), "{scheme}, {n} bodies: {corrections}");
        }
    }
}
