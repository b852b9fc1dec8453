//! Laws of every kind that a step tells apart, with the numbers and the start of each member.

use dmech::extend::Fields;
use dmech::prelude::*;

use dmech_tests::few::{self, part};
use dmech_tests::restricted;

/// A law whose members differ in every number.
pub(crate) trait Many<const D: usize>: Copy + Sync {
    fn member(k: usize) -> Self;
    fn start(k: usize) -> State<D>;
}

macro_rules! many {
    ($name:ident { $($field:ident: $value:expr),* }, $d:literal, |$k:ident| [$q:expr, $v:expr]; $($block:tt)*) => {
        #[derive(Clone, Copy)]
        pub(crate) struct $name { $(pub(crate) $field: f64),* }

        #[dmech::law]
        $($block)*

        impl Many<$d> for $name {
            fn member($k: usize) -> Self {
                Self { $($field: $value),* }
            }
            fn start($k: usize) -> State<$d> {
                State::new($q, $v).at_time(0.25 * part($k, 0.71))
            }
        }
    };
}

many! {
    Orbit { gm: 0.9 + 0.3 * part(k, 0.31) }, 2, |k| [[0.7 + 0.4 * part(k, 0.17), 0.1], [-0.05, 0.8 + 0.5 * part(k, 0.23)]];
    impl Orbit {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            -self.gm / (q[0] * q[0] + q[1] * q[1]).sqrt()
        }
    }
}

many! {
    Saddle { lambda: 0.4 + 0.5 * part(k, 0.13), l: 0.8 + 0.2 * part(k, 0.57) }, 2, |k| [[0.1, 0.2 * part(k, 0.41)], [0.25, 0.1 * part(k, 0.29)]];
    impl Saddle {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let [x, y] = q;
            0.5 * (x * x + self.l * y * y) + self.lambda * (x * x * y - y.powi(3) / 3.0) + 0.1 * (self.l * x).sin()
        }
        #[invariant]
        fn twice(&self, q: [f64; 2], v: [f64; 2]) -> f64 {
            v[0] * v[0] + v[1] * v[1] + 2.0 * self.energy(q)
        }
    }
}

many! {
    Contact { k: 30.0 + 20.0 * part(k, 0.19), friction: 0.2 + 0.1 * part(k, 0.43) }, 1, |k| [[-0.3 * part(k, 0.37)], [0.4 + 0.3 * part(k, 0.11)]];
    impl Contact {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            if q > 0.0 { 0.5 * self.k * q * q } else { self.friction * q.abs() }
        }
    }
}

many! {
    Driven { k: 1.2 + 0.3 * part(k, 0.47), a: 0.3 * part(k, 0.59), omega: 1.1 + 0.2 * part(k, 0.67) }, 1, |k| [[0.3 + part(k, 0.07)], [0.2]];
    impl Driven {
        #[potential]
        fn energy(&self, q: f64, t: f64) -> f64 {
            -self.k * q.cos() - self.a * q * (self.omega * t).cos()
        }
    }
}

many! {
    Damped { k: 1.3 + 0.4 * part(k, 0.53), c: 0.05 + 0.1 * part(k, 0.61) }, 1, |k| [[0.4 + part(k, 0.09)], [-0.1]];
    impl Damped {
        #[potential]
        fn energy(&self, q: f64, m: f64) -> f64 {
            0.25 * self.k * m * q.powi(4)
        }
        #[force]
        fn drag(&self, v: f64) -> f64 {
            -self.c * v * v.abs()
        }
    }
}

many! {
    Bottle { b: 1.1 + 0.5 * part(k, 0.21), k: 0.3 + 0.2 * part(k, 0.33) }, 2, |k| [[0.4, 0.3 * part(k, 0.39)], [0.3, -0.4 + 0.2 * part(k, 0.51)]];
    impl Bottle {
        #[potential]
        fn well(&self, q: [f64; 2]) -> f64 {
            0.25 * self.k * (q[0] * q[0] + 1.5 * q[1] * q[1]).powi(2)
        }
        #[force]
        fn lorentz(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
            let b = self.b * (1.0 + 0.3 * q[0]);
            [b * v[1], -b * v[0]]
        }
    }
}

many! {
    Plummer { gm: 1.4 + 0.4 * part(k, 0.63), eps: 0.2 + 0.2 * part(k, 0.73) }, 3, |k| [[0.6, 0.2 * part(k, 0.81), -0.1], [0.1, 0.5, 0.6 * part(k, 0.27)]];
    impl Plummer {
        #[potential]
        fn energy(&self, q: [f64; 3]) -> f64 {
            -self.gm / (q[0].powi(2) + q[1].powi(2) + q[2].powi(2) + self.eps.powi(2)).sqrt()
        }
    }
}

many! {
    Pair { g: 1.1 + 0.3 * part(k, 0.49), eps: 0.1 + 0.1 * part(k, 0.77) }, 4, |k| [[0.5, 0.1 * part(k, 0.83), -0.6, 0.0], [0.0, 0.4, 0.1 * part(k, 0.03), -0.7]];
    impl Pair {
        #[potential]
        fn energy(&self, q: [f64; 4]) -> f64 {
            -self.g / ((q[0] - q[2]).powi(2) + (q[1] - q[3]).powi(2) + self.eps.powi(2)).sqrt()
        }
    }
}

/// A law and a start for each member.
pub(crate) trait Each<const D: usize> {
    type Law: Fields<D>;
    fn law(k: usize) -> Self::Law;
    fn begin(k: usize) -> State<D>;
}

impl<L: Many<D> + Fields<D>, const D: usize> Each<D> for L {
    type Law = L;

    fn law(k: usize) -> L {
        L::member(k)
    }
    fn begin(k: usize) -> State<D> {
        L::start(k)
    }
}

/// Scenes of few bodies.
macro_rules! few {
    ($from:ident, $as_law:ident: $($name:ident, $d:literal: $scene:path;)*) => {$(
        pub(crate) struct $name;

        impl Each<$d> for $name {
            type Law = $from::$name;

            fn law(k: usize) -> $from::$name {
                $scene(k).$as_law()
            }
            fn begin(k: usize) -> State<$d> {
                Self::law(k).start()
            }
        }
    )*};
}

few! { few, as_law:
    Stars, 6: few::stars;
    Rope, 4: few::rope;
    Tides, 6: few::tides;
    Creatures, 6: few::creatures;
    Ions, 6: few::ions;
    Molecules, 8: few::molecules;
    Clusters, 12: few::clusters;
    Beads, 4: few::beads;
    Packs, 6: few::packs;
    Fluid, 12: few::fluid;
    Loops, 6: few::loops;
    Tied, 8: few::tied;
    Hung, 8: few::hung;
}

// Of which some are test bodies, in each member others.
few! { restricted, as_restricted_law:
    Clones, 8: restricted::clones;
    Cords, 4: restricted::cords;
    Herds, 6: restricted::herds;
    Tethers, 8: restricted::tethers;
    Traps, 6: restricted::traps;
    Vapours, 8: restricted::vapours;
}
