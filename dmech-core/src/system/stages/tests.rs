//! Coordinates side by side are as each alone.

use dmech_scalar::{DoubleDouble, Lanes, Real, two_sum};

use super::abreast::{Abreast, ByEight, Singly, divided, largest_number};
use super::tableau::GAUSS;
use super::{Nearing, STAGES, moves, settle};

/// Numbers of many sizes and both signs, some of them 0.
fn numbers(n: usize, seed: f64) -> Vec<f64> {
    let number = |i: usize| (seed + 1.7 * i as f64).sin() * 10_f64.powi((7 * i as i32 + seed as i32) % 23 - 11);
    (0..n).map(|i| if i % 6 == 5 { 0.0 } else { number(i) }).collect()
}

fn pushes(n: usize) -> Vec<Lanes> {
    numbers(n * STAGES, 4.0).as_chunks().0.iter().map(|&eight| Lanes::from_array(eight)).collect()
}

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|x| x.to_bits()).collect()
}

/// Every number of coordinates to 20, with all and no rest.
#[test]
fn coordinates_side_by_side_are_as_alone() {
    let (dt, mut together) = (0.15, 0);
    for n in 0..=20 {
        let [q, v, low] = [1.0, 2.0, 3.0].map(|seed| numbers(n, seed));
        let (v_low, pushes) = (low.iter().map(|x| 1e-17 * x).collect::<Vec<_>>(), pushes(n));
        together += divided::<f64>(n)[0].len();

        let mut moved = [q.clone(), low.clone(), v.clone(), v_low.clone()];
        settle(&GAUSS, dt, &pushes, moved.each_mut().map(Vec::as_mut_slice));
        let mut found = [(); 3].map(|()| vec![0.0; n]);
        moves(dt, [&q, &v, &v_low], &pushes, found.each_mut().map(Vec::as_mut_slice));
        let [drifts, counts, reach] = found;
        for k in 0..n {
            let mut one = [q[k], low[k], v[k], v_low[k]];
            let [a, b, c, d] = one.each_mut().map(core::slice::from_mut);
            settle(&GAUSS, dt, &pushes[k..=k], [a, b, c, d]);
            assert_eq!(bits(&one), bits(&moved.each_ref().map(|x| x[k])), "{k} of {n}");
            let mut one = [0.0; 3];
            let [a, b, c] = one.each_mut().map(core::slice::from_mut);
            moves(dt, [&q[k..=k], &v[k..=k], &v_low[k..=k]], &pushes[k..=k], [a, b, c]);
            assert_eq!(bits(&one), bits(&[drifts[k], counts[k], reach[k]]), "{k} of {n}");
        }

        // What counts depends on all by the largest alone, which stands last here.
        let largest = largest_number(&counts);
        assert_eq!(largest, counts.iter().copied().fold(0.0, f64::max), "{n}");
        let measured = |range: core::ops::Range<usize>| {
            let [mut counts, mut reach] = [&counts, &reach].map(|x| x[range.clone()].to_vec());
            counts.push(largest);
            reach.push(0.0);
            Nearing::<f64>::begin(&mut counts, &mut reach);
            [counts, reach].map(|x| bits(&x[..range.len()]))
        };
        let all = measured(0..n);
        for k in 0..n {
            assert_eq!(measured(k..k + 1), [vec![all[0][k]], vec![all[1][k]]], "{k} of {n}");
        }
    }
    assert!(together > 100);
}

/// The first and the last of those that are computed together, which no zero fills up, and what is put back.
#[test]
fn what_is_gathered_is_put_back_where_it_was() {
    for n in 1..=STAGES + 3 {
        let all = numbers(n, 1.0);
        for at in (0..n).step_by(STAGES) {
            let mut back = vec![f64::NAN; n];
            ByEight::scatter(ByEight::gather(&all, at), &mut back, at);
            let here = at..n.min(at + STAGES);
            assert_eq!(back[here.clone()], all[here.clone()]);
            assert_eq!(back.iter().filter(|x| x.is_nan()).count(), n - here.len());
        }
        assert_eq!(Singly::gather(&all, n - 1), all[n - 1]);
    }
}

/// v + Σ Lⱼ/h to twice the digits, for h near short fractions and far from them.
#[test]
fn a_step_ends_with_what_rounding_leaves_out() {
    let mut inexact = 0;
    for (i, dt) in [0.1, 0.15, 0.2, 0.3, 1.0 / 3.0, 0.37, 1e-7, 123.4].into_iter().enumerate() {
        let push = pushes(i + 1)[i];
        let mut moved = [0.7, 1e-17, -0.3, 2e-17];
        let [q, q_low, v, v_low] = moved.each_mut().map(core::slice::from_mut);
        settle(&GAUSS, dt, &[push], [q, q_low, v, v_low]);
        let two = |hi: f64, lo: f64| DoubleDouble::from(hi) + DoubleDouble::from(lo);
        let speed = two(-0.3, 2e-17) + DoubleDouble::from(push.sum()) / DoubleDouble::from(dt);
        let size = speed.to_f64().abs().max(push.sum().abs() / dt).max(0.3);
        assert!((two(moved[2], moved[3]) - speed).to_f64().abs() < 4e-32 * size, "{dt}");
        // A sum of eight is rounded, a path is not.
        let rests = Lanes::from_array(GAUSS.rests.hi) * push;
        let path = DoubleDouble::from(dt) * two(-0.3, 2e-17);
        let place = two(0.7, 1e-17) + path + DoubleDouble::from(rests.sum());
        let least = 2.0 * f64::EPSILON * f64::EPSILON * (path.to_f64().abs() + 1.0) + f64::EPSILON * rests.sum().abs();
        assert!((two(moved[0], moved[1]) - place).to_f64().abs() < least, "{dt}");
        inexact += u32::from(moved[3] != 0.0);
        assert_eq!(two_sum(moved[2], moved[3]), (moved[2], moved[3]));
    }
    assert!(inexact > 6);
}

/// The low part of the velocity, of which all steps together make more than rounding.
#[test]
fn a_path_goes_on_with_what_the_velocity_left_out() {
    for dt in [0.1, 0.15, 0.7, 3.0] {
        let mut moved = [0.7, 1e-17, -0.3, 2e-17];
        let [q, q_low, v, v_low] = moved.each_mut().map(core::slice::from_mut);
        settle(&GAUSS, dt, &[Lanes::ZERO], [q, q_low, v, v_low]);
        let two = |hi: f64, lo: f64| DoubleDouble::from(hi) + DoubleDouble::from(lo);
        let place = two(0.7, 1e-17) + DoubleDouble::from(dt) * two(-0.3, 2e-17);
        assert!((two(moved[0], moved[1]) - place).to_f64().abs() < 1e-31, "{dt}");
    }
}

/// What a push is measured by: itself, or the 256th part of a long path; and what |q| and |h v| reach.
#[test]
fn a_path_counts_as_a_push() {
    let (v, low) = (1.0 + f64::EPSILON, 0.3 * f64::EPSILON);
    for (q, dt, push) in
        [(0.3, 3.0, 1e-9), (-7.0, 0.1, 0.25), (0.0, 1.0, -8.0), (0.0, 1.3, 0.0), (1.0, 0.7, 1e-3), (2.0, 1.9, 1.0)]
    {
        let pushes = [Lanes::splat(0.5 * push).after(push)];
        let [mut drift, mut count, mut reach] = [[0.0]; 3];
        moves(dt, [&[q], &[v], &[low]], &pushes, [&mut drift, &mut count, &mut reach]);
        let exact = DoubleDouble::from(dt) * (DoubleDouble::from(v) + DoubleDouble::from(low));
        assert!((DoubleDouble::from(drift[0]) - exact).to_f64().abs() <= 0.5001 * f64::EPSILON * drift[0].abs());
        assert_eq!(count, [push.abs().max(drift[0] / 256.0)], "{dt}");
        assert_eq!(reach, [q.abs().max(drift[0])], "{dt}");
    }
}

/// Sweeps go on while they come nearer by more than rounding, and changes that rounding makes to and fro do not count as nearer again.
#[test]
fn sweeps_end_at_rounding() {
    let begin = |reach: f64| Nearing::<f64>::begin(&mut [1.0], &mut [reach]);
    let goes_on = |nearing: &mut Nearing<f64>, changes: &[f64]| -> Vec<bool> {
        changes.iter().map(|&change| nearing.comes_nearer(0, Lanes::splat(change))).collect()
    };
    // Squares: 1 ulp after 1e6 foretells less than one.
    assert_eq!(goes_on(&mut begin(0.0), &[1e9, 1e6, 1.0]), [true, true, false]);
    assert_eq!(goes_on(&mut begin(0.0), &[1e9, 1e6, 2e6, 1e5]), [true, true, false, true]);
    // A position of 1 lets a push of 1 vary by 128 units.
    assert_eq!(goes_on(&mut begin(1.0), &[1e9, 50.0, 100.0, 60.0]), [true, false, false, false]);
    assert_eq!(goes_on(&mut begin(1e-9), &[1e9, 50.0, 100.0, 60.0])[3..], [true]);
    let near = |reach: f64| {
        let mut nearing = begin(reach);
        nearing.comes_nearer(0, Lanes::splat(100.0));
        nearing.is_near(&[Lanes::ONE], 1.0)
    };
    assert!(near(1.0) && !near(1e-9));
}

/// A step without a reciprocal moves nothing.
#[test]
fn the_shortest_step_ends() {
    let mut moved = [0.7, 0.0, -0.3, 0.0];
    let [q, q_low, v, v_low] = moved.each_mut().map(core::slice::from_mut);
    settle(&GAUSS, 5e-324, &[Lanes::ZERO], [q, q_low, v, v_low]);
    assert_eq!(moved, [0.7, 0.0, -0.3, 0.0]);
}
