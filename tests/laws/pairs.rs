//! Laws between two bodies: what the macro writes, against formulas by hand and against the method as its author wrote it.

use approx::assert_abs_diff_eq;
use dmech::extend::{Between, Numbers, PairLaw, Reads, Symmetric, VelocityIndependent};
use dmech::prelude::*;
use nalgebra::Vector3;

#[derive(Clone, Copy, Debug)]
struct Shell {
    radii: [f64; 2],
}

#[derive(Clone, Copy, Debug)]
struct Charge {
    q: f64,
    shell: Shell,
}

const ION: Charge = Charge { q: 0.7, shell: Shell { radii: [0.4, 0.9] } };
const OTHER: Charge = Charge { q: -1.9, shell: Shell { radii: [0.3, 0.2] } };

#[derive(Clone, Copy, Debug)]
struct Coulomb {
    k: f64,
}

#[dmech::law]
impl Coulomb {
    #[pair]
    fn energy(&self, r: f64, a: &Charge, b: &Charge) -> f64 {
        self.k * a.q * b.q / r
    }
}

/// What a and b are read of differs; numbers nested in the data; masses; helpers; a type that is named like generated code.
#[derive(Clone, Copy, Debug)]
struct Pair {
    k: f64,
    d: f64,
}

#[dmech::law]
impl Pair {
    const POWER: f64 = 1.5;

    fn charge(x: &Charge) -> f64 {
        2.0 * x.q
    }

    #[pair]
    fn energy(&self, r: f64, a: &Charge, ma: f64, mb: f64, b: &Charge) -> f64 {
        let overlap = (a.shell.radii[1] - self.d * b.shell.radii[0]) * r;
        self.k * ma * mb * (-r / self.d).exp() + overlap * overlap + Self::charge(a) * Self::POWER / r
    }
}

/// Even in a slanted separation, with friction between the two beside it.
#[derive(Clone, Copy, Debug)]
struct Slanted<const N: usize> {
    k: [f64; N],
    drag: f64,
}

#[dmech::law]
impl<const N: usize> Slanted<N> {
    #[pair]
    fn energy(&self, d: Vector3<f64>) -> f64 {
        0.25 * self.k[0] * (d.norm_squared() + d.x * d.x).powi(2) + self.k[1] * d.y * d.z
    }

    #[pair_force]
    fn friction(&self, d: Vector3<f64>, va: Vector3<f64>, vb: Vector3<f64>, t: f64) -> Vector3<f64> {
        (va - vb) * (-self.drag * (1.0 + 0.5 * t.sin()) / (1.0 + d.norm_squared()))
    }
}

/// Greenspan §6: not reciprocal when α ≠ 0.
#[derive(Clone, Copy, Debug)]
struct Molecular {
    g: f64,
    h: f64,
    alpha: f64,
}

#[dmech::law]
impl Molecular {
    #[pair_force]
    fn force(&self, d: [f64; 2], va: [f64; 2], ma: f64, mb: f64) -> [f64; 2] {
        let r = (d[0] * d[0] + d[1] * d[1]).sqrt();
        let speed = (va[0] * va[0] + va[1] * va[1]).sqrt();
        let f = ma * mb * (-self.g / r.powi(2) + self.h / r.powi(3) - self.alpha * speed) / r;
        [f * d[0], f * d[1]]
    }
}

/// Cubic in d: which body is the first matters.
#[derive(Clone, Copy, Debug)]
struct Fput {
    alpha: f64,
}

#[dmech::law]
impl Fput {
    #[pair]
    fn energy(&self, d: [f64; 1]) -> f64 {
        let s = d[0];
        0.5 * s * s + self.alpha * s.powi(3) / 3.0
    }
}

const COULOMB: Coulomb = Coulomb { k: 1.3 };
const PAIR: Pair = Pair { k: 0.8, d: 1.7 };
const SLANTED: Slanted<2> = Slanted { k: [1.3, 0.4], drag: 0.6 };
const MOLECULAR: Molecular = Molecular { g: 1.4, h: 2.2, alpha: 0.08 };

pub(super) fn numbers<P, L: Reads<P>>(_: &L, mass: f64, data: &P) -> <L::Numbers as Numbers>::Of<f64> {
    let numbers = L::numbers(mass, data);
    let numbers = numbers.list();
    <L::Numbers as Numbers>::gather(|i| numbers[i])
}

fn close(computed: f64, expected: f64, what: &str) {
    assert!((computed - expected).abs() <= 1e-14 * (1.0 + expected.abs()), "{what}: {computed} {expected}");
}

/// Energy, gradient, Hessian and discrete gradient of what acts between two bodies, against the energy by hand.
pub(super) fn is_a_potential<const D: usize>(
    acts: &impl Potential<D>,
    energy: impl Fn([f64; D]) -> f64,
    a: [f64; D],
    b: [f64; D],
) {
    let shifted = |x: [f64; D], j: usize, h: f64| core::array::from_fn(|i| if i == j { x[i] + h } else { x[i] });
    let difference = |f: &dyn Fn(f64) -> f64| {
        let h = 1e-3;
        // Of order six: an error of 1e-18 in units of the seventh derivative.
        (45.0 * (f(h) - f(-h)) - 9.0 * (f(2.0 * h) - f(-2.0 * h)) + f(3.0 * h) - f(-3.0 * h)) / (60.0 * h)
    };
    close(acts.potential(a), energy(a), "potential");
    let (gradient, hessian) = (acts.gradient(a), acts.hessian(a));
    let between = acts.discrete_gradient(a, b);
    assert_eq!(between, acts.discrete_gradient(b, a), "symmetric to the bit");
    let secant: f64 = (0..D).map(|i| between[i] * (b[i] - a[i])).sum();
    close(secant, energy(b) - energy(a), "along the secant");
    let jacobian = acts.discrete_gradient_jacobian(a, b);
    for j in 0..D {
        let near = |x: f64, y: f64, what: &str| assert!((x - y).abs() < 1e-10 * (1.0 + y.abs()), "{what}: {x} {y}");
        near(gradient[j], difference(&|h| energy(shifted(a, j, h))), "gradient");
        for i in 0..D {
            near(hessian[i][j], difference(&|h| acts.gradient(shifted(a, j, h))[i]), "hessian");
            near(jacobian[i][j], difference(&|h| acts.discrete_gradient(a, shifted(b, j, h))[i]), "∂∇̄Φ/∂b");
        }
    }
}

pub(super) fn norm<const D: usize>(d: [f64; D]) -> f64 {
    d.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn coulomb_in_any_number_of_dimensions() {
    assert_eq!(<Coulomb as Reads<Charge>>::numbers(5.0, &ION).list(), [ION.q]);
    let (a, b) = (numbers(&COULOMB, 2.0, &ION), numbers(&COULOMB, 3.0, &OTHER));
    fn check<const D: usize>(a: [f64; 1], b: [f64; 1], here: [f64; D], there: [f64; D]) {
        let acts = PairLaw::<D, Charge>::between(&COULOMB, a, b, 0.0);
        is_a_potential(&acts, |d| COULOMB.energy(norm(d), &ION, &OTHER), here, there);
        let c = -COULOMB.k * ION.q * OTHER.q / norm(here).powi(3);
        acts.gradient(here).iter().zip(here).for_each(|(&g, x)| close(g, c * x, "by hand"));
        // Kanatani (3.25).
        let (ra, rb) = (norm(here), norm(there));
        let c = -COULOMB.k * ION.q * OTHER.q / (ra * rb * (ra + rb));
        let sums = here.iter().zip(there).map(|(x, y)| x + y);
        acts.discrete_gradient(here, there).iter().zip(sums).for_each(|(&g, x)| close(g, c * x, "Kanatani (3.25)"));
    }
    check(a, b, [0.9], [1.7]);
    check(a, b, [0.3, -0.8], [0.9, 0.4]);
    check(a, b, [0.3, -0.8, 0.5], [0.1, -0.6, 1.1]);
    check(a, b, [0.3, -0.8, 0.5, 0.2], [0.1, -0.6, 1.1, 0.4]);
}

#[test]
fn numbers_of_both_bodies_in_one_layout() {
    let (a, b) = (numbers(&PAIR, 2.5, &ION), numbers(&PAIR, 0.6, &OTHER));
    let mut read = a.to_vec();
    read.sort_by(f64::total_cmp);
    assert_eq!(read, [0.4, 0.7, 0.9, 2.5], "the mass, q and both radii, each once");
    let acts = PairLaw::<2, Charge>::between(&PAIR, a, b, 0.0);
    is_a_potential(&acts, |d| PAIR.energy(norm(d), &ION, 2.5, 0.6, &OTHER), [0.3, -0.8], [0.9, 0.4]);
    // The other way round is another energy: this law is for chains and bonds.
    let turned = PairLaw::<2, Charge>::between(&PAIR, b, a, 0.0);
    assert!((turned.potential([0.3, -0.8]) - acts.potential([0.3, -0.8])).abs() > 0.1);
}

#[test]
fn a_separation_and_a_force_beside_it() {
    let t = 0.9;
    let acts = PairLaw::<3, ()>::between(&SLANTED, [], [], t);
    let (d, va, vb) = ([0.3, -0.8, 0.5], [1.1, 0.2, -0.6], [-0.4, 0.7, 0.9]);
    is_a_potential(&acts, |d| SLANTED.energy(d.into()), d, [0.1, -0.6, 1.1]);
    let force = acts.force(d, va, vb);
    let expected = SLANTED.friction(d.into(), va.into(), vb.into(), t);
    force.iter().zip(expected.iter()).for_each(|(&f, &x)| close(f, x, "friction"));
    assert_eq!(acts.force(d.map(|x| -x), vb, va), force.map(|x| -x), "reciprocal to the bit");
    assert!(constants(&acts) == (true, true, true));
    assert!(!autonomous::<3, (), _>(&SLANTED) && autonomous::<1, (), _>(&Fput { alpha: 0.3 }));
    let [by_d, by_va, by_vb] = acts.force_jacobians(d, va, vb);
    let h = 1e-4;
    for j in 0..3 {
        let shifted =
            |x: [f64; 3], h: f64| -> [f64; 3] { core::array::from_fn(|i| if i == j { x[i] + h } else { x[i] }) };
        for i in 0..3 {
            let slope = |f: &dyn Fn(f64) -> [f64; 3]| (f(h)[i] - f(-h)[i]) / (2.0 * h);
            assert_abs_diff_eq!(by_d[i][j], slope(&|h| acts.force(shifted(d, h), va, vb)), epsilon = 1e-7);
            assert_abs_diff_eq!(by_va[i][j], slope(&|h| acts.force(d, shifted(va, h), vb)), epsilon = 1e-7);
            assert_abs_diff_eq!(by_vb[i][j], slope(&|h| acts.force(d, va, shifted(vb, h))), epsilon = 1e-7);
        }
    }
}

/// (POTENTIAL, FORCED, RECIPROCAL)
fn constants<const D: usize, B: Between<D>>(_: &B) -> (bool, bool, bool) {
    (B::POTENTIAL, B::FORCED, B::RECIPROCAL)
}

fn autonomous<const D: usize, P, L: PairLaw<D, P>>(_: &L) -> bool {
    L::AUTONOMOUS
}

#[test]
fn a_force_alone_has_no_potential() {
    let acts = PairLaw::<2, ()>::between(&MOLECULAR, [2.0], [3.0], 0.0);
    let (d, va, vb) = ([0.3, -0.4], [0.1, 0.7], [9.0, 9.0]);
    let expected = MOLECULAR.force(d, va, 2.0, 3.0);
    acts.force(d, va, vb).iter().zip(expected).for_each(|(&f, x)| close(f, x, "(6.8)–(6.13)"));
    assert_eq!(constants(&acts), (false, true, false));
    assert_eq!((acts.potential(d), acts.gradient(d)), (0.0, [0.0; 2]));
}

#[test]
fn what_is_symmetric_and_what_needs_no_velocity() {
    fn symmetric<L: Symmetric>(_: &L) {}
    fn still<L: VelocityIndependent>(_: &L) {}
    symmetric(&COULOMB);
    symmetric(&SLANTED);
    symmetric(&MOLECULAR);
    still(&COULOMB);
    still(&PAIR);
    still(&Fput { alpha: 0.3 });
}

#[test]
fn the_derivation_shows_what_was_found() {
    let shows = |text: &str, parts: &[&str]| {
        for part in parts {
            assert!(text.contains(part), "no `{part}` in\n{text}");
        }
    };
    shows(
        COULOMB.derivation(),
        &["Φ = k·a_q·b_q/r", "c = −k·a_q·b_q/r³", "C(a, b) =", "1 division, 1 root", "symmetric:"],
    );
    shows(MOLECULAR.derivation(), &["Fx =", "∂Fy/∂vax", "depends on the velocity", "not reciprocal"]);
    shows(SLANTED.derivation(), &["∂Φ/∂x", "reciprocal: the force on b is opposite", "names the time"]);
    shows(Fput { alpha: 0.3 }.derivation(), &["not symmetric", "in 1 dimension,"]);
}

/// Types of the author's that are called as what generated code calls its own: the number of dimensions is none of them.
mod called_alike {
    use dmech::prelude::*;

    type D = f64;
    type R = D;
    type P = R;

    #[derive(Clone, Copy, Debug)]
    struct Tie {
        k: P,
    }

    #[dmech::law]
    impl Tie {
        #[pair]
        fn energy(&self, r: f64) -> f64 {
            0.5 * self.k * r * r
        }
    }

    /// A body on a spring to a pinned one is an oscillator, on a line and in space.
    #[test]
    fn a_type_may_be_called_as_the_dimension_is() {
        fn swung<const N: usize>() -> f64 {
            let scene =
                Scene::new().body(1.0, [0.0; N], [0.0; N]).body(1.0, [0.3; N], [0.0; N]).pin(0).pairs(Tie { k: 4.0 });
            let run = Simulation::scene(scene).scheme(Gauss::order16()).dt(0.1).run(10).unwrap();
            run.last().q[1].iter().map(|q| (q - 0.3 * 2.0_f64.cos()).abs()).fold(0.0, f64::max)
        }
        assert!(swung::<1>() < 1e-14 && swung::<3>() < 1e-14);
    }
}
