//! The derivation that the macro writes for people.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

#[derive(Clone, Copy, Debug)]
struct Damped {
    k: f64,
    alpha: f64,
}

#[dmech::law]
impl Damped {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        -self.k * q.cos()
    }
    #[force]
    fn drag(&self, v: f64, t: f64) -> f64 {
        -self.alpha * v * (1.0 + t)
    }
}

#[test]
fn a_conservative_law() {
    let text = Kepler { gm: 1.0 }.derivation();
    println!("{text}");
    for line in [
        "Kepler, 2 coordinates",
        "  Φ = −gm/√(x² + y²)",
        "  ∂Φ/∂x = gm·x/(√(x² + y²))³",
        "  ∂²Φ/∂x∂y = −3·gm·x·y/(√(x² + y²))⁵",
        "  ∇̄Φx(a, b) = gm·(xa + xb)/(√(xa² + ya²)·√(xb² + yb²)·(√(xa² + ya²) + √(xb² + yb²)))",
        "  central: implicit steps have one scalar unknown",
    ] {
        assert!(text.lines().any(|l| l == line), "{line}");
    }
}

#[test]
fn a_law_with_a_force() {
    let text = Damped { k: 1.0, alpha: 0.1 }.derivation();
    println!("{text}");
    for line in [
        "Damped, 1 coordinate",
        "  Φ = −k·cos(x)",
        "  ∂Fx/∂vx = −alpha·(t + 1)",
        "  the force depends on the velocity",
        "  names the time: the energy is not kept",
    ] {
        assert!(text.lines().any(|l| l == line), "{line}\n{text}");
    }
}
