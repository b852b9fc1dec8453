//! Laws between two bodies: what the macro writes, against formulas by hand.

use dmech::prelude::*;
use dmech::{Between, Numbers, PairLaw, Reads, Symmetric, VelocityIndependent};

#[derive(Clone, Copy, Debug)]
struct Charge {
    q: f64,
    shell: [f64; 2],
}

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
const ION: Charge = Charge { q: 0.7, shell: [0.4, 0.9] };
const OTHER: Charge = Charge { q: -1.9, shell: [0.3, 0.2] };

fn numbers<P, L: Reads<P>>(law: &L, mass: f64, data: &P) -> <L::Numbers as Numbers>::Of<f64> {
    let numbers = law.numbers(mass, data);
    let numbers = numbers.as_slice();
    <L::Numbers as Numbers>::gather(|i| numbers[i])
}

fn symmetric<L: Symmetric + VelocityIndependent>(_: &L) {}

#[test]
fn coulomb_reads_the_charge_and_nothing_else() {
    assert_eq!(Reads::<Charge>::numbers(&COULOMB, 5.0, &ION).as_slice(), [ION.q]);
    symmetric(&COULOMB);
    let (a, b) = (numbers(&COULOMB, 2.0, &ION), numbers(&COULOMB, 3.0, &OTHER));
    let acts = PairLaw::<3, Charge>::between(&COULOMB, a, b, 0.0);
    let d = [0.3, -0.4, 1.2];
    let r: f64 = 1.3;
    let kqq = COULOMB.k * ION.q * OTHER.q;
    assert!((acts.potential(d) - kqq / r).abs() < 1e-15);
    for (g, x) in acts.gradient(d).into_iter().zip(d) {
        assert!((g + kqq * x / r.powi(3)).abs() < 1e-15);
    }
    println!("{}", COULOMB.derivation());
}

#[test]
fn the_molecular_force() {
    let law = Molecular { g: 1.0, h: 2.0, alpha: 0.08 };
    let acts = PairLaw::<2, ()>::between(&law, [2.0], [3.0], 0.0);
    let (d, va) = ([0.3, -0.4], [0.1, 0.7]);
    assert_eq!(acts.force(d, va, [9.0, 9.0]), law.force(d, va, 2.0, 3.0));
    println!("{}", law.derivation());
    println!("{}", Fput { alpha: 0.3 }.derivation());
}
