//! Secants across a cut-off and across the edge of a box.

use super::laws::Gravity;
use crate::law::{CutOff, PairLaw, Potential};
use crate::scene::space::{Open, Periodic, Space};
use crate::scene::terms::way::Way;
use crate::vector::{difference, dot};

/// The secant identity, the symmetry and the Jacobian of a way.
fn holds<B: Space<2>>(name: &str, space: B, law: &impl Potential<2>, from: [f64; 2], to: [f64; 2]) {
    let secant = |from, to| Way::new(&space, from, to).discrete_gradient(law);
    let found: [f64; 2] = secant(from, to);
    let rise = law.potential(space.image(to)) - law.potential(space.image(from));
    let error = dot(found, difference(to, from)) - rise;
    assert!(error.abs() < 1e-14, "{name}: {error:e} of {rise}");
    let back = secant(to, from);
    assert!((0..2).all(|k| (found[k] - back[k]).abs() < 1e-13), "{name}: {found:?}, {back:?}");
    let jacobian = Way::new(&space, from, to).discrete_gradient_jacobian(law);
    let h = 1e-6;
    for l in 0..2 {
        let [mut less, mut more] = [to; 2];
        less[l] -= h;
        more[l] += h;
        let [less, more] = [less, more].map(|to| secant(from, to));
        for k in 0..2 {
            let slope = (more[k] - less[k]) / (2.0 * h);
            assert!((slope - jacobian[k][l]).abs() < 1e-7, "{name}: {slope}, {}", jacobian[k][l]);
        }
    }
}

#[test]
fn secants_are_exact_across_a_cut_off() {
    let law = CutOff::new(Gravity { g: 1.3 }, 1.0);
    let between = PairLaw::<2, (), f64>::between(&law, [1.1], [0.7], 0.0);
    for (name, from, to) in [
        ("within", [0.3, 0.4], [-0.2, 0.7]),
        ("out", [0.3, 0.4], [0.9, 1.7]),
        ("in", [-1.2, 0.4], [0.1, 0.3]),
        ("just out", [0.6, 0.79], [0.7, 0.8]),
        ("beyond", [1.2, 0.4], [-3.0, 0.2]),
    ] {
        holds(name, Open, &between, from, to);
        holds(name, Periodic::new([2.5, 2.0]), &between, from, to);
    }
    assert_eq!(between.discrete_gradient([0.0, 1.0], [1.5, 0.0]), [0.0; 2]);
    // Continuous where the end comes to the cut-off from either side.
    let [inside, outside] = [1.0 - 1e-12, 1.0 + 1e-12].map(|r| between.discrete_gradient([0.3, 0.4], [r, 0.0]));
    assert!((inside[0] - outside[0]).abs() < 1e-10 && (inside[1] - outside[1]).abs() < 1e-10);
}

#[test]
fn secants_are_exact_where_the_image_becomes_another() {
    let law = Gravity { g: 1.3 };
    let between = PairLaw::<2, (), f64>::between(&law, [1.1], [0.7], 0.0);
    let space = Periodic::new([2.0, 3.0]);
    holds("along one", space, &between, [0.9, 0.4], [1.2, 0.5]);
    holds("along both", space, &between, [0.9, 1.4], [1.2, 1.7]);
    holds("far away", space, &between, [10.9, -4.4], [11.2, -4.9]);
    holds("several boxes", space, &between, [0.9, 0.4], [-7.4, 9.7]);
}
