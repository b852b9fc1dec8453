//! The outer Solar System: the Sun with what is within Jupiter, Jupiter, Saturn, Uranus, Neptune, and Pluto.
//!
//! Lengths in astronomical units, times in years of 365 days, masses in that of the Sun, as heyoka's benchmark
//! `outer_ss_long_term` has them, after C. J. Cohen, E. C. Hubbard, C. Oesterwinter, Astron. Papers Am. Ephem. 22 (1973) 1.

use dmech::models::pairs::Gravity;
use dmech::prelude::*;
use dmech::scene::{Linked, Pairs};
use wide::f64x8;

use crate::gauss::gauss16;
use crate::motion::{Motion, inverse_cubes};

/// Days in its year.
const YEAR: f64 = 365.0;

/// Gauss's constant squared, for that year.
const G: f64 = 0.01720209895 * 0.01720209895 * YEAR * YEAR;

const MASSES: [f64; 6] = [1.00000597682, 1.0 / 1047.355, 1.0 / 3501.6, 1.0 / 22869.0, 1.0 / 19314.0, 7.4074074e-9];

/// Place, and velocity by the day.
type Body = ([f64; 3], [f64; 3]);

const START: [Body; 6] = [
    (
        [-4.06428567034226e-3, -6.08813756435987e-3, -1.66162304225834e-6],
        [6.69048890636161e-6, -6.33922479583593e-6, -3.13202145590767e-9],
    ),
    (
        [3.40546614227466, 3.62978190075864, 3.42386261766577e-2],
        [-5.59797969310664e-3, 5.51815399480116e-3, -2.66711392865591e-6],
    ),
    (
        [6.60801554403466, 6.38084674585064, -1.36145963724542e-1],
        [-4.17354020307064e-3, 3.99723751748116e-3, 1.67206320571441e-5],
    ),
    (
        [1.11636331405597e1, 1.60373479057256e1, 3.61783279369958e-1],
        [-3.25884806151064e-3, 2.06438412905916e-3, -2.17699042180559e-5],
    ),
    (
        [-3.01777243405203e1, 1.91155314998064, -1.53887595621042e-1],
        [-2.17471785045538e-4, -3.11361111025884e-3, 3.58344705491441e-5],
    ),
    (
        [-2.13858977531573e1, 3.20719104739886e1, 2.49245689556096],
        [-1.76936577252484e-3, -2.06720938381724e-3, 6.58091931493844e-4],
    ),
];

/// Positions and velocities of the six at the start, from their common centre of mass, which rests.
pub fn outer_start() -> State<18> {
    let total: f64 = MASSES.iter().sum();
    let centred = |of: fn(&Body) -> [f64; 3], unit: f64| {
        let middle = |k| MASSES.iter().zip(&START).map(|(m, body)| m * of(body)[k]).sum::<f64>() / total;
        core::array::from_fn(|i| unit * (of(&START[i / 3])[i % 3] - middle(i % 3)))
    };
    State::new(centred(|body| body.0, 1.0), centred(|body| body.1, YEAR))
}

/// The same as a scene.
pub fn outer_scene() -> Scene<3, (), ((), Linked<Gravity, Pairs>)> {
    let start = outer_start();
    let mut scene = Scene::new();
    for (i, mass) in MASSES.into_iter().enumerate() {
        let of = |x: &[f64; 18]| [x[3 * i], x[3 * i + 1], x[3 * i + 2]];
        scene = scene.body(mass, of(&start.q), of(&start.v));
    }
    scene.pairs(Gravity { g: G })
}

/// Energy, in two sums, so that the rounding of the sum is none of what is measured.
pub fn outer_energy(state: &State<18>) -> f64 {
    let (mut sum, mut lost) = (0.0, 0.0);
    let mut add = |x: f64| crate::gauss::add(&mut sum, &mut lost, x);
    for i in 0..6 {
        let square = |x: &[f64; 18]| (0..3).map(|k| x[3 * i + k] * x[3 * i + k]).sum::<f64>();
        add(0.5 * MASSES[i] * square(&state.v));
        for j in 0..i {
            let s: f64 = (0..3).map(|k| (state.q[3 * i + k] - state.q[3 * j + k]).powi(2)).sum();
            add(-G * MASSES[i] * MASSES[j] / s.sqrt());
        }
    }
    sum + lost
}

/// Angular momentum.
pub fn outer_angular_momentum(state: &State<18>) -> [f64; 3] {
    core::array::from_fn(|k| {
        let (mut sum, mut lost) = (0.0, 0.0);
        for (body, mass) in MASSES.into_iter().enumerate() {
            let (i, j) = (3 * body + (k + 1) % 3, 3 * body + (k + 2) % 3);
            crate::gauss::add(&mut sum, &mut lost, mass * state.q[i] * state.v[j]);
            crate::gauss::add(&mut sum, &mut lost, -mass * state.q[j] * state.v[i]);
        }
        sum + lost
    })
}

/// The forces on the six, by hand.
#[derive(Clone, Copy, Debug)]
pub struct OuterPlanets;

impl Motion<18> for OuterPlanets {
    fn acceleration(&self, q: &[f64; 18], a: &mut [f64; 18]) {
        let mut lanes = [f64x8::ZERO; 18];
        self.in_lanes(&q.map(f64x8::splat), &mut lanes);
        *a = lanes.map(|a| a.to_array()[0]);
    }

    #[inline(always)]
    fn in_lanes(&self, q: &[f64x8; 18], a: &mut [f64x8; 18]) {
        *a = [f64x8::ZERO; 18];
        for i in 1..6 {
            for j in 0..i {
                let d = [0, 1, 2].map(|k| q[3 * j + k] - q[3 * i + k]);
                let c = inverse_cubes(d[0].mul_add(d[0], d[1].mul_add(d[1], d[2] * d[2])));
                let (on_i, on_j) = (c * f64x8::splat(G * MASSES[j]), c * f64x8::splat(G * MASSES[i]));
                for k in 0..3 {
                    a[3 * i + k] = on_i.mul_add(d[k], a[3 * i + k]);
                    a[3 * j + k] = on_j.mul_neg_add(d[k], a[3 * j + k]);
                }
            }
        }
    }

    fn change(&self, q: &[f64; 18], dq: &[f64; 18], da: &mut [f64; 18]) {
        *da = [0.0; 18];
        for i in 1..6 {
            for j in 0..i {
                let [d, along] = [q, dq].map(|x| [0, 1, 2].map(|k| x[3 * j + k] - x[3 * i + k]));
                let s = d.iter().map(|d| d * d).sum::<f64>();
                let c = 1.0 / (s * s.sqrt());
                let part = 3.0 * d.iter().zip(&along).map(|(d, e)| d * e).sum::<f64>() / s;
                for k in 0..3 {
                    let pull = G * c * (along[k] - part * d[k]);
                    da[3 * i + k] += MASSES[j] * pull;
                    da[3 * j + k] -= MASSES[i] * pull;
                }
            }
        }
    }
}

/// Gauss's method of order 16 by hand: the state after some steps of h.
pub fn outer_gauss(start: &State<18>, h: f64, steps: u64) -> State<18> {
    let mut left = steps;
    let (end, _) = gauss16(OuterPlanets, start, |_, _| {
        left = left.checked_sub(1)?;
        Some(h)
    });
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The scene's forces by those of the energy, the centre of mass at rest, and both invariants kept over a century.
    #[test]
    fn planets_by_hand_are_the_scene() {
        let start = outer_start();
        let mut a = [0.0; 18];
        OuterPlanets.acceleration(&start.q, &mut a);
        for i in 0..18 {
            let energy = |h: f64| {
                let mut moved = start;
                moved.q[i] += h;
                outer_energy(&moved)
            };
            let force = (energy(-1e-4) - energy(1e-4)) / 2e-4;
            assert!((MASSES[i / 3] * a[i] - force).abs() < 1e-9, "{i}: {} and {force}", MASSES[i / 3] * a[i]);
        }
        let end = outer_gauss(&start, 0.5, 200);
        let drift = outer_energy(&end) / outer_energy(&start) - 1.0;
        assert!(drift.abs() < 1e-14, "{drift:e}");
        let turn = outer_angular_momentum(&end)[2] / outer_angular_momentum(&start)[2] - 1.0;
        assert!(turn.abs() < 1e-14, "{turn:e}");
        let simulation = Simulation::scene(outer_scene()).scheme(Nystrom::order8());
        let mut stepper = simulation.dt(0.1).stepper().unwrap();
        stepper.advance(1000).unwrap();
        for body in 0..6 {
            for k in 0..3 {
                let (scene, hand) = (stepper.q().get(body)[k], end.q[3 * body + k]);
                assert!((scene - hand).abs() < 1e-9, "{body}, {k}: {scene} and {hand}");
            }
        }
    }

    /// ∂a/∂q by differences.
    #[test]
    fn change_is_that_of_the_force() {
        let start = outer_start();
        let dq: [f64; 18] = core::array::from_fn(|i| (1.3 * i as f64).cos());
        let at = |h: f64| {
            let mut a = [0.0; 18];
            OuterPlanets.acceleration(&core::array::from_fn(|i| start.q[i] + h * dq[i]), &mut a);
            a
        };
        let (ahead, behind, mut da) = (at(1e-4), at(-1e-4), [0.0; 18]);
        OuterPlanets.change(&start.q, &dq, &mut da);
        for i in 0..18 {
            assert!((da[i] - (ahead[i] - behind[i]) / 2e-4).abs() < 1e-8, "{i}: {}", da[i]);
        }
    }
}
