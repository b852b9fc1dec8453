//! Coefficients, and what holds for them without rounding.

use dmech_scalar::{DoubleDouble, Real};

use crate::system::tableau::{Columns, Row, STAGES, Tableau};

fn all(row: &Row) -> [DoubleDouble; STAGES] {
    core::array::from_fn(|i| DoubleDouble::new(row.hi[i], row.lo[i]))
}

/// Σ bᵢ cᵢᵏ = 1/(k + 1) to degree 15, and not at 16.
#[test]
fn weights_integrate_polynomials_to_degree_15() {
    let gauss = Tableau::of(STAGES);
    let (b, c) = (all(&gauss.weights), all(&gauss.nodes));
    for k in 0..=16 {
        let sum = (0..STAGES).fold(DoubleDouble::ZERO, |sum, i| sum + b[i] * c[i].powi(k));
        let error = (sum - DoubleDouble::from(f64::from(k + 1)).recip()).to_f64().abs();
        assert!(if k < 16 { error < 1e-29 } else { error > 1e-11 }, "{k}: {error:e}");
    }
}

/// Σⱼ bⱼ μᵢⱼ cⱼᵏ = cᵢᵏ⁺¹/(k + 1) and Σⱼ bⱼ νᵢⱼ cⱼᵏ = cᵢᵏ⁺²/(k + 1)(k + 2), for all powers that the polynomials hold.
#[test]
fn stages_integrate_what_their_polynomials_hold() {
    for s in [2, 3, 4, 5, STAGES] {
        let tableau = Tableau::of(s);
        let (b, c) = (all(&tableau.weights), all(&tableau.nodes));
        let weighed = |columns: &Columns, i: usize, k: i32| {
            (0..STAGES).fold(DoubleDouble::ZERO, |sum, j| sum + all(&columns[j])[i] * b[j] * c[j].powi(k))
        };
        for i in 0..STAGES {
            for k in 0..s as i32 {
                let whole = |n: i32| DoubleDouble::from(f64::from(n));
                let speed = weighed(&tableau.speeds, i, k) - c[i].powi(k + 1) / whole(k + 1);
                assert!(speed.to_f64().abs() < 1e-29, "{s} {i} {k}: {speed}");
                if k + 1 < s as i32 {
                    let place = weighed(&tableau.places, i, k) - c[i].powi(k + 2) / whole((k + 1) * (k + 2));
                    assert!(place.to_f64().abs() < 1e-29, "{s} {i} {k}: {place}");
                    let working = weighed(&tableau.working, i, k) - c[i].powi(k + 1) / whole(k + 1);
                    assert!(working.to_f64().abs() < 1e-29, "{s} {i} {k}: {working}");
                }
            }
        }
        // One power more is beyond a projection.
        let beyond = (weighed(&tableau.speeds, 0, s as i32)
            - c[0].powi(s as i32 + 1) / DoubleDouble::from(s as f64 + 1.0))
        .to_f64();
        assert!(beyond.abs() > 1e-9, "{s}: {beyond:e}");
    }
}

/// What makes a step symmetric holds to the bit for all, what makes it symplectic for Gauss's method alone.
#[test]
fn steps_are_symmetric_and_symplectic_to_the_bit() {
    for s in [2, 3, 4, 5, STAGES] {
        let Tableau { nodes, rests, weights, speeds, places, working, highest, .. } = Tableau::of(s);
        let mut skew = 0;
        for i in 0..STAGES {
            let back = STAGES - 1 - i;
            assert_eq!(
                (nodes.hi[i] + nodes.hi[back], rests.hi[i], weights.hi[i]),
                (1.0, nodes.hi[back], weights.hi[back])
            );
            for (highest, parity) in highest.iter().zip([1.0, -1.0, 1.0, -1.0]) {
                assert_eq!(highest.hi[i], parity * highest.hi[back]);
            }
            for j in 0..STAGES {
                // Sums and differences of these are exact.
                let there = STAGES - 1 - j;
                assert_eq!(speeds[j].hi[i] + speeds[there].hi[back], 1.0);
                assert_eq!(working[j].hi[i] + working[there].hi[back], 1.0);
                assert_eq!(places[j].hi[i] - places[there].hi[back], nodes.hi[i] - nodes.hi[j], "{s} {i} {j}");
                let turned = places[j].hi[i] - places[i].hi[j] == nodes.hi[i] - nodes.hi[j];
                skew += u32::from(turned && speeds[j].hi[i] + speeds[i].hi[j] == 1.0);
            }
        }
        assert_eq!(skew == 64, s == STAGES, "{s}: {skew}");
    }
}

/// Polynomials to degree 7 go on as they are, into a step of the same length or another.
#[test]
fn a_polynomial_is_continued() {
    use crate::system::stages::go_on;
    use dmech_scalar::Lanes;
    let gauss = Tableau::of(STAGES);
    let (b, c) = (Lanes::from_array(gauss.weights.hi), Lanes::from_array(gauss.nodes.hi));
    let forces = [
        |x: Lanes| (x - Lanes::splat(0.3)).powi(7) + Lanes::splat(1.7) * x * x - Lanes::splat(0.4),
        |x: Lanes| Lanes::splat(0.9) - x.powi(5),
        |_: Lanes| Lanes::splat(1.3),
    ];
    // The next number beside 1 goes the way of the others.
    for ratio in [0.2, 0.37, 1.0, 1.0 + f64::EPSILON, 1.9] {
        let mut pushes = forces.map(|force| b * force(c));
        go_on(&mut pushes, &gauss, ratio);
        for (pushes, force) in pushes.iter().zip(forces) {
            let expected = Lanes::splat(ratio * ratio) * b * force(c * Lanes::splat(ratio) + Lanes::ONE);
            for i in 0..STAGES {
                assert!((pushes[i] / expected[i] - 1.0).abs() < 1e-10, "{ratio} {i}: {pushes} {expected}");
            }
        }
    }
}
