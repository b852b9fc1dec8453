//! The energy of a quadratic law, exact but for rounding that does no work of one sense, however stiff the law is.

use dmech::prelude::*;

/// One coordinate.
#[derive(Clone, Copy, Debug)]
struct Spring {
    k: f64,
}

#[dmech::law]
impl Spring {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        0.5 * self.k * q * q
    }
}

/// A stiff direction and a soft one, neither along an axis.
#[derive(Clone, Copy, Debug)]
struct Well {
    stiff: f64,
    soft: f64,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        0.5 * self.stiff * (0.6 * x + 0.8 * y).powi(2) + 0.5 * self.soft * (0.8 * x - 0.6 * y).powi(2)
    }
}

/// Three coordinates in a row, the last of them soft.
#[derive(Clone, Copy, Debug)]
struct Row {
    k: f64,
}

#[dmech::law]
impl Row {
    #[potential]
    fn energy(&self, q: [f64; 3]) -> f64 {
        0.5 * self.k * ((q[0] - 0.7 * q[1]).powi(2) + 1.3 * (q[1] - q[2]).powi(2)) + 0.04 * q[2] * q[2]
    }
}

/// Five, by elimination.
#[derive(Clone, Copy, Debug)]
struct Ring {
    k: f64,
}

#[dmech::law]
impl Ring {
    #[potential]
    fn energy(&self, q: [f64; 5]) -> f64 {
        let stretched = (0..5).map(|i| (q[i] - 0.9 * q[(i + 1) % 5]) * (q[i] - 0.9 * q[(i + 1) % 5])).sum::<f64>();
        0.5 * self.k * stretched + 0.05 * q[0] * q[0]
    }
}

const STEPS: u64 = 20_000;

/// What rounding may add up to in as many steps of ωh: each step rounds numbers that are ωh times as large as the energy's. Of one sense
/// it was five times as much in steps of ωh = 0.3, 10⁵ times in steps of 30 and all in steps of 1000.
fn rounding(turn: f64) -> f64 {
    1e-14 * (1.0 + 4.0 * turn)
}

const TURNS: [f64; 6] = [0.03, 0.3, 3.0, 30.0, 100.0, 1000.0];

fn well(turn: f64) -> Well {
    Well { stiff: turn * turn, soft: 0.1 * f64::min(1.0, turn * turn) }
}

fn start<const D: usize>() -> State<D> {
    State::new(std::array::from_fn(|i| 0.3 - 0.1 * i as f64), std::array::from_fn(|i| 0.1 + 0.2 * i as f64))
}

#[test]
fn the_energy_of_stiff_quadratic_laws_moves_by_rounding() {
    let mut tried = 0;
    macro_rules! exact {
        ($($law:expr, $scheme:expr, $invariant:expr;)*) => {
            for turn in TURNS {
                $({
                    let law = ($law)(turn, turn * turn);
                    let run = Simulation::new(law, start()).scheme($scheme).dt(1.0).record_every(7).run(STEPS);
                    let off = run.unwrap().drift($invariant).unwrap().max_relative();
                    println!("{turn:>6} {:>24} {:>18}: {off:.1e}", stringify!($law), stringify!($scheme));
                    assert!(off <= rounding(turn), "{turn} {}: {off:e}", stringify!($law));
                    tried += 1;
                })*
            }
        };
    }
    exact! {
        |_, k| Spring { k }, DiscreteGradient, Invariant::Energy;
        |turn, _| well(turn), DiscreteGradient, Invariant::Energy;
        |_, k| Row { k }, DiscreteGradient, Invariant::Energy;
        |_, k| Ring { k }, DiscreteGradient, Invariant::Energy;
        |_, k| Spring { k }, Kanatani, Invariant::DiscreteEnergy;
        |turn, _| well(turn), Kanatani, Invariant::DiscreteEnergy;
    }
    assert_eq!(tried, 6 * TURNS.len());
}

/// Of two bodies, each in a well of its own.
#[test]
fn the_energy_of_stiff_quadratic_scenes_moves_by_rounding() {
    for turn in TURNS {
        let bodies =
            Scene::new().body(1.0, [0.3, 0.2], [0.1, 0.3]).body(1.3, [0.5, -0.2], [-0.1, 0.3]).field(well(turn));
        let run = Simulation::scene(bodies).scheme(DiscreteGradient).dt(1.0).record_every(7).run(STEPS).unwrap();
        let off = run.drift(Invariant::Energy).unwrap().max_relative();
        println!("{turn:>6}: {off:.1e}");
        assert!(off <= rounding(turn), "{turn}: {off:e}");
    }
}
