//! Walls with a rounded corner: a function of the distance r to a quadrant in which nothing acts, smooth where that begins. On its border, which
//! belongs to it, r is a root of 0 as within.

use dmech::prelude::*;

/// The largest coordinate of the quadrant, and of places on its border.
const EDGE: f64 = 1.25;

/// From within the quadrant to outside of it, on its border, and one place beside.
fn around() -> [f64; 8] {
    [-3.0, 0.4, EDGE.next_down(), EDGE, EDGE.next_up(), 1.3, 1.75, 3.0]
}

/// Energies of which nothing is left where r vanishes, nor of their slopes.
macro_rules! corners {
    ($($test:ident: $law:ident($a:ident, $b:ident, $r:ident, $k:ident) $phi:expr;)*) => {$(
        #[derive(Clone, Copy, Debug)]
        struct $law {
            k: f64,
            edge: f64,
        }

        #[dmech::law]
        impl $law {
            #[potential]
            fn energy(&self, q: [f64; 2]) -> f64 {
                let ($a, $b) = ((q[0] - self.edge).max(0.0), (q[1] - self.edge).max(0.0));
                let ($r, $k) = ($a.hypot($b), self.k);
                $phi
            }
        }

        #[test]
        fn $test() {
            let law = $law { k: 3.7, edge: EDGE };
            let places = || around().into_iter().flat_map(|x| around().map(|y| [x, y]));
            let mut outside = 0;
            for a in places() {
                let gradient = law.gradient(a);
                assert!(gradient.iter().all(|x| x.is_finite()), "{gradient:?} at {a:?}");
                let within = a.iter().all(|x| *x <= EDGE);
                assert!(!within || gradient == [0.0; 2], "{gradient:?} at {a:?}");
                outside += usize::from(!within && gradient != [0.0; 2]);
                for b in places() {
                    let [x, y] = law.discrete_gradient(a, b);
                    let work = x * (b[0] - a[0]) + y * (b[1] - a[1]);
                    let (here, there) = (law.potential(a), law.potential(b));
                    let off = (there - here - work).abs();
                    assert!(off <= 1e-14 * (1.0 + here.abs() + there.abs()), "{off:e} from {a:?} to {b:?}: {x}, {y}");
                }
            }
            assert!(outside > 20, "{outside} places at which something acts");
            // Along the border, and over it.
            for (start, dt) in [(State::new([EDGE, 0.3], [0.0, 1.0]), 0.07), (State::new([0.5, 0.3], [1.0, 0.2]), 0.125)] {
                let run = Simulation::new(law, start).scheme(DiscreteGradient).dt(dt).run(400).unwrap();
                let moved = run.drift(Invariant::Energy).unwrap().max_relative();
                assert!(moved < 1e-13, "from {start:?}: {moved:e}");
            }
        }
    )*};
}

corners! {
    a_square_that_stiffens: Stiffens(a, b, r, k) k * r * r * (1.0 + r);
    a_logarithm: Logarithm(a, b, r, k) k * r * (1.0 + r).ln();
    a_level: Level(a, b, r, k) k * r * r.tanh();
    an_angle: Angle(a, b, r, k) k * r * r.atan();
    a_product: Product(a, b, r, k) k * (a * a * b / (0.1 + r) + r * r * r);
}
