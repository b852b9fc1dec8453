//! Where something is 0 or infinite and the law is not: choices and products of roots have the limits that they should.

use dmech_symbolic::expression::Unary;

use crate::common::laws::Law;
use crate::common::notation::{E, choose, norm};

fn gradient(law: &mut Law, q: &[f64]) -> Vec<f64> {
    law.kernels().gradient.run(law.at(q, q))
}

/// A power that undoes a root goes into the branches: (cosh x ∛x)³ is x cosh³ x, also where it is clamped; a spring on a
/// distance that is capped has no root at all.
#[test]
fn powers_undo_roots_within_choices() {
    let mut cubed = Law::build(1, |q, _| (q[0].of(Unary::Cosh) * q[0].cbrt()).clamp(-0.5, 2.0).powi(3));
    assert_eq!(gradient(&mut cubed, &[0.0]), [1.0]);
    let mut capped = Law::build(2, |q, p| p[1] * norm(q).min(p[0]).powi(2));
    assert_eq!(gradient(&mut capped, &[0.0, 0.0]), [0.0, 0.0]);
    assert_eq!(gradient(&mut capped, &[0.3, 0.0]), [2.0 * 1.9 * 0.3, 0.0]);
    assert_eq!(gradient(&mut capped, &[3.0, 4.0]), [0.0, 0.0]);
}
