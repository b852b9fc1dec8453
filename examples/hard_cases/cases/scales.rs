//! The same motions in other units.

use dmech::Law;
use dmech::models::{HenonHeiles, Kepler, LennardJones, Morse, Quartic, Wall};
use dmech::prelude::*;

use super::trial::{Motion, Trial, every_scheme};
use super::{Case, Length, Row, in_short, rounding, short};

/// Powers of two: the first are 1e-12 and 1e12, the last 1e-150 and 1e150.
const POWERS: [i32; 12] = [-40, 40, -80, 80, -140, 140, -249, 249, -332, 332, -498, 498];
const STEPS: u64 = 200;

pub(crate) fn case(_: Length) -> Case {
    let mut case = Case::new(
        "scales",
        "Six motions in units of length from 1e-150 to 1e150",
        "A law has powers of the lengths that its motion does not have: of Kepler's at 1e-150 the force is made of 1/r⁴ = 1e600.",
        "Units that are powers of two change no digit: each motion is the same to the bit, or it is refused, or stops with an error; nowhere is it another motion.",
        &["same", "refused", "stopped", "off by"],
    );
    for n in POWERS {
        kepler(&mut case, n);
        let start = State::new([0.2, -0.1], [0.25, 0.3]);
        compare(&mut case, "HenonHeiles", [n, 0], |n| HenonHeiles { lambda: 0.8 * two(-n) }, start);
        let atoms = |n: i32| LennardJones { epsilon: 0.7 * two(2 * n), sigma: 1.2 * two(n) };
        compare(&mut case, "LennardJones", [n, 0], atoms, State::new([1.4], [0.2]));
        let wall = |n: i32| Wall { k: 40.0, pull: 1.3 * two(n) };
        compare(&mut case, "Wall", [n, 0], wall, State::new([0.2], [0.2]));
        compare(&mut case, "Quartic", [n, 0], |n| Quartic { beta: 1.7 * two(-2 * n) }, State::new([1.3], [0.4]));
        let morse = |n: i32| Morse { depth: 1.5 * two(2 * n), width: 1.2 * two(-n), length: 0.8 * two(n) };
        compare(&mut case, "Morse", [n, 0], morse, State::new([1.1], [0.5]));
    }
    case
}

/// The unit of time as that of length, so that gm is no larger than a length.
fn kepler(case: &mut Case, n: i32) {
    compare(case, "Kepler", [n, n], |n| Kepler { gm: 1.3 * two(n) }, State::new([0.9, 0.2], [-0.1, 1.1]));
}

fn two(n: i32) -> f64 {
    // powi by repeated squaring would overflow on the way to the smallest.
    f64::from(n).exp2()
}

/// Whether the potential, as the law writes it, still has a value in these units: that of q⁴ at 1e-100 is 0, while the
/// motion needs q³ only. What the report then calls energy is the kinetic one.
fn told<const D: usize>(plain: &Trial<State<D>>, scaled: &Trial<State<D>>, inverse_speed: f64) -> bool {
    let start = |trial: &Trial<State<D>>| trial.run.drift(Invariant::Energy).map_or(f64::NAN, |drift| drift.start());
    start(scaled) * inverse_speed * inverse_speed == start(plain)
}

/// Lengths in units of 2ⁿ and times in units of 2ᵏ against those in units of 1.
fn compare<L, const D: usize>(
    case: &mut Case,
    name: &'static str,
    [n, k]: [i32; 2],
    law: impl Fn(i32) -> L,
    start: State<D>,
) where
    L: Law<D> + VelocityIndependent + Copy,
{
    let run = |n: i32, k: i32| -> Vec<Trial<State<D>>> {
        let start = State::new(start.q.map(|x| two(n) * x), start.v.map(|x| two(n - k) * x));
        let motion = Motion { dt: 0.02 * two(k), ..Motion::until(law(n), start, 1.0, STEPS) };
        every_scheme!(positions: motion)
    };
    let [mut schemes, mut same, mut refused, mut stopped] = [0; 4];
    let (mut furthest, mut energy, mut ended) = (0.0_f64, 0.0_f64, String::new());
    for (plain, scaled) in run(0, 0).into_iter().zip(run(n, k)) {
        let scheme = scaled.scheme;
        schemes += 1;
        if let Err(what) = scaled.sound() {
            case.check(format!("{name} · 2^{n}: {what}"), f64::NAN, 0.0);
        }
        let pairs = || plain.states().zip(scaled.states());
        let equal = pairs().all(|(a, b)| (0..D).all(|i| two(n) * a.q[i] == b.q[i] && two(n - k) * a.v[i] == b.v[i]));
        let off = pairs().flat_map(|(a, b)| (0..D).map(move |i| (a.q[i] - b.q[i] / two(n)).abs()));
        let off = off.fold(0.0, f64::max);
        match scaled.cause {
            None if equal => same += 1,
            None => {
                furthest = furthest.max(off);
                // A Newton correction more or less, where a derivative of the force is lost.
                case.check(format!("{name} · 2^{n}: {scheme} is off by"), off, 1e-12);
            }
            Some(cause) if scaled.run.states().is_empty() => {
                refused += 1;
                ended = in_short(cause);
            }
            Some(cause) => {
                stopped += 1;
                ended = in_short(cause);
            }
        }
        if scaled.completed() && scaled.exact_energy() && told(&plain, &scaled, two(k - n)) {
            energy = energy.max(scaled.own_energy_error());
            let most = rounding(STEPS);
            case.check(format!("{name} · 2^{n}: {scheme}: energy error"), scaled.own_energy_error(), most);
        }
    }
    if n.abs() == 40 {
        case.check(format!("{name} · 2^{n}: schemes that are not the same"), f64::from(schemes - same), 0.0);
    }
    let cells = vec![same.to_string(), refused.to_string(), stopped.to_string(), short(furthest)];
    case.rows.push(Row { scheme: name, dt: two(n), energy, cells, ended });
}
