//! What every scheme promises, over laws.

use dmech::Interrupted;
use dmech::prelude::*;

/// A law with one parameter k, of its energy and, where there is one, its force.
macro_rules! law {
    ($name:ident, $d:literal, |$self:ident, $q:ident| $energy:expr $(, |$v:ident| $force:expr)?) => {
        #[derive(Clone, Copy, Debug)]
        struct $name {
            k: f64,
        }

        #[dmech::law]
        impl $name {
            #[potential]
            fn energy(&$self, $q: [f64; $d]) -> f64 {
                $energy
            }
            $(
                #[force]
                fn force(&$self, $v: [f64; $d]) -> [f64; $d] {
                    $force
                }
            )?
        }
    };
}

mod adaptive;
mod allocation;
mod at_rest;
mod balanced;
mod bodies;
mod compensated;
mod composed;
mod continued;
mod double_double;
mod hills;
mod hills_beside;
mod order;
mod published;
mod quadratic;
mod relaxed;
mod runge_kutta_nystrom;
mod splittings;
mod stiff;
mod walls;

/// The run if it was not refused at its first step; if it was, nothing else is the matter than the root.
fn first_step<X>(run: Result<Run<X>, Interrupted<X>>, dt: f64, place: &str) -> Option<Run<X>> {
    run.map_err(|interrupted| {
        let cause = interrupted.cause();
        let Error::NotConverged { step, time, dt: told, .. } = cause else { panic!("{place}: {cause}") };
        assert_eq!((step, time, told), (1, 0.0, dt), "{place}: {cause}");
    })
    .ok()
}
