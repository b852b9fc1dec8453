//! Single laws with seams, and the table of them that suites run over.

use dmech::prelude::*;

/// Declares a law with named numbers and a potential of q.
macro_rules! laws {
    ($($(#[$doc:meta])* $name:ident($($field:ident),*) $q:ident: $at:ty, $energy:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct $name {
            $(pub(crate) $field: f64,)*
        }

        #[dmech::law]
        impl $name {
            #[potential]
            fn energy(&self, $q: $at) -> f64 {
                let Self { $($field),* } = *self;
                $energy
            }
        }
    )*};
}

laws! {
    /// A ball that bounces on a tent.
    Tent(k, g) q: f64, k * q.abs() + g * q;
    Kinked(k) q: f64, q * q / 2.0 + k * q.abs();
    Ramps(k) q: f64, if q > 0.0 { k * q } else { -2.0 * k * q };
    Manhattan(k) q: [f64; 2], k * (q[0].abs() + 1.3 * q[1].abs());
    /// Its branches do not couple x and y; the choice does.
    Larger(a, b) q: [f64; 2], (a * q[0] * q[0]).max(b * q[1] * q[1]);
    Chord(k) q: [f64; 2], k * (q[0] - q[1]).abs() + 0.3 * q[0] * q[0] + 0.2 * q[1] * q[1];
    /// The curved seam knows nothing of z, which moves all the same.
    Spectator(k, c) q: [f64; 3], {
        let [x, y, z] = q;
        let over = x + y * y - c;
        let beyond = if over > 0.0 { k * over * (1.0 + x * x) } else { 0.0 };
        0.5 * (x * x + 1.3 * y * y + 0.7 * z * z) + 0.1 * z * x + beyond
    };
    /// A Hertzian contact under a weight.
    Hertz(k, g) q: f64, k * (-q).max(0.0).powf(2.5) + g * q;
    Soft(k, g) q: f64, k * (-q).max(0.0).powf(1.5) + g * q;
    /// A round wall, and a valley with two edges.
    Walls(k) q: [f64; 2], {
        let r = q[0].hypot(q[1]);
        let wall = if r > 1.0 { 0.5 * k * (r - 1.0) * (r - 1.0) } else { 0.0 };
        wall + 0.2 * q[0].clamp(-0.4, 0.3) + 0.1 * q[1]
    };
    Nested(k) q: [f64; 2], {
        let [x, y] = q;
        let slope = if x > 0.2 { if y > x - 0.2 { x - 0.2 } else { y } } else { (y).min(0.0) };
        0.5 * (x * x + y * y) + k * slope
    };
    /// Two walls and nothing between them.
    Gap(k) q: f64, {
        let over = (q.abs() - 0.6).max(0.0);
        0.5 * k * over * over
    };
    /// A hole with a rim in a bowl that is not round: a cut-off of the potential and its first derivative.
    Hole(k) q: [f64; 2], {
        let [x, y] = q;
        let r2 = x * x + y * y;
        let hole = if r2 < 0.5 { -k * (0.5 - r2) * (0.5 - r2) } else { 0.0 };
        0.5 * (x * x + 1.3 * y * y) + hole
    };
    /// The lower of two tubs: a ridge, which pushes away from its seam.
    Ridge(k) q: f64, (0.5 * k * (q - 0.1) * (q - 0.1)).min(0.4 * k * (q + 0.2) * (q + 0.2));
}

/// Runs a macro over the table: name, law, number of coordinates, the power of the distance from its sharpest seam by
/// which the potential departs there from the other branch, and the side of a seam on which a point is.
macro_rules! for_each_seam {
    ($run:ident) => {
        $run! {
            a_tent: Tent { k: 3.0, g: 1.1 }, 1, 1.0, |q| q[0] > 0.0;
            an_oscillator_with_a_kink: Kinked { k: 0.7 }, 1, 1.0, |q| q[0] > 0.0;
            two_ramps: Ramps { k: 0.7 }, 1, 1.0, |q| q[0] > 0.0;
            kinks_side_by_side: Manhattan { k: 0.8 }, 2, 1.0, |q| q[1] > 0.0;
            a_kink_along_a_difference: Chord { k: 0.8 }, 2, 1.0, |q| q[0] > q[1];
            a_seam_that_ignores_a_coordinate: Spectator { k: 0.8, c: 0.3 }, 3, 1.0, |q| q[0] + q[1] * q[1] > 0.3;
            a_hertzian_contact: Hertz { k: 50.0, g: 1.1 }, 1, 2.5, |q| q[0] > 0.0;
            a_soft_contact: Soft { k: 50.0, g: 1.1 }, 1, 1.5, |q| q[0] > 0.0;
            walls_and_edges: Walls { k: 9.0 }, 2, 1.0, |q| q[0].hypot(q[1]) > 1.0;
            choices_within_choices: Nested { k: 0.4 }, 2, 1.0, |q| q[0] > 0.2;
            a_choice_that_couples: Larger { a: 1.0, b: 2.0 }, 2, 1.0, |q| q[0].abs() > 2f64.sqrt() * q[1].abs();
            two_walls: Gap { k: 40.0 }, 1, 2.0, |q| q[0].abs() > 0.6;
            a_cut_off: Hole { k: 1.2 }, 2, 2.0, |q| q[0] * q[0] + q[1] * q[1] < 0.5;
            a_ridge: Ridge { k: 0.9 }, 1, 1.0, |q| 0.4 * (q[0] + 0.2).powi(2) < 0.5 * (q[0] - 0.1).powi(2);
        }
    };
}
pub(crate) use for_each_seam;

/// Starts that differ in all coordinates.
pub(crate) fn starts<const D: usize>(count: usize) -> Vec<State<D>> {
    let wave = |i: usize, k: usize| (1.7 * i as f64 + 2.3 * k as f64 + 0.4).sin();
    (0..count)
        .map(|i| State::new(std::array::from_fn(|k| wave(i, k)), std::array::from_fn(|k| wave(i + 31, k + 7))))
        .collect()
}

/// How often a motion goes from one side of a seam to the other.
pub(crate) fn crossings<X>(states: &[X], side: impl Fn(&X) -> bool) -> usize {
    states.windows(2).filter(|pair| side(&pair[0]) != side(&pair[1])).count()
}
