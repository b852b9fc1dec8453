//! Loops by hand, with their force inside: what a scheme costs that is written for one motion and nothing else.

use crate::entrant::{Crate, Entrant, Finish, steps};
use crate::gauss::{add as add_compensated, gauss16};
use crate::motion::{Motion, Planet};
use crate::problem::Problem;

/// Leap-frog, SRKN₁₄ᵃ, and Gauss's method of order 16 with its stages in lanes.
pub fn twins<'a, M: Motion<D> + 'a, const D: usize>(problem: &'a Problem<M, D>) -> Vec<Entrant<'a>> {
    let twin = |name: &str, label, forces: u64, run: fn(M, f64, u64, &mut [f64; D], &mut [f64; D])| {
        let knobs = steps(problem.end, problem.coarse, 6);
        Entrant::new(Crate::Hand, name, label, knobs, move |steps| {
            Finish::of(&problem.truth, || {
                let (mut q, mut v) = (problem.start.q, problem.start.v);
                run(problem.motion, problem.end / steps, steps as u64, &mut q, &mut v);
                Ok((q, forces * steps as u64))
            })
        })
    };
    vec![
        twin("Leap-frog by hand", "leap-frog by hand", 1, leapfrog::<M, D>),
        twin("SRKN14 of order 6 by hand", "SRKN14 by hand", 14, srkn14::<M, D>),
        Entrant::new(
            Crate::Hand,
            "Gauss of order 16 by hand",
            "Gauss 16 by hand",
            steps(problem.end, problem.coarse, 16),
            |steps| Finish::of(&problem.truth, || Ok(gauss_in_equal_steps(problem, steps as u64))),
        ),
    ]
}

#[inline(never)]
fn gauss_in_equal_steps<M: Motion<D>, const D: usize>(problem: &Problem<M, D>, steps: u64) -> ([f64; D], u64) {
    let (h, mut left) = (problem.end / steps as f64, steps);
    let (end, evaluations) = gauss16(problem.motion, &problem.start, |_, _| {
        left = left.checked_sub(1)?;
        Some(h)
    });
    (end.q, evaluations)
}

/// Gauss's method of order 16 in steps of ε r^{3/2}, which is a part of the period of a circle there; r in the middle of the step.
pub fn planet_twin(problem: &Problem<Planet, 2>) -> Entrant<'_> {
    Entrant::new(
        Crate::Hand,
        "Gauss of order 16 by hand, steps of r^(3/2)",
        "Gauss 16 by hand ad.",
        (0..20).map(|k| 0.8 * 0.5_f64.powf(0.125 * f64::from(k))).collect(),
        |part| Finish::of(&problem.truth, || Ok(gauss_in_steps_of_the_planet(problem, part))),
    )
}

#[inline(never)]
fn gauss_in_steps_of_the_planet(problem: &Problem<Planet, 2>, part: f64) -> ([f64; 2], u64) {
    let (mut t, mut lost) = (0.0, 0.0);
    let length = |[x, y]: [f64; 2]| {
        let s = x * x + y * y;
        part * s.sqrt().sqrt() * s.sqrt()
    };
    let (end, evaluations) = gauss16(problem.motion, &problem.start, |q, v| {
        let left = (problem.end - t) - lost;
        let (mut a, mut h) = ([0.0; 2], length(*q));
        problem.motion.acceleration(q, &mut a);
        for _ in 0..2 {
            h = length([0, 1].map(|k| q[k] + 0.5 * h * (v[k] + 0.25 * h * a[k])));
        }
        let h = h.min(left);
        add_compensated(&mut t, &mut lost, h);
        (h > 0.0).then_some(h)
    });
    (end.q, evaluations)
}

/// x += c y.
#[inline(always)]
fn add<const D: usize>(x: &mut [f64; D], c: f64, y: &[f64; D]) {
    for (x, y) in x.iter_mut().zip(y) {
        *x += c * y;
    }
}

/// Drift by half a step, then kick and drift by turns; the last drift is by half a step again.
#[inline(never)]
fn leapfrog<M: Motion<D>, const D: usize>(motion: M, dt: f64, steps: u64, q: &mut [f64; D], v: &mut [f64; D]) {
    let (mut x, mut u, mut a) = (*q, *v, [0.0; D]);
    add(&mut x, 0.5 * dt, &u);
    for step in 1..=steps {
        motion.acceleration(&x, &mut a);
        add(&mut u, dt, &a);
        add(&mut x, if step < steps { dt } else { 0.5 * dt }, &u);
    }
    (*q, *v) = (x, u);
}

/// The drifts a₁ … a₈, which return as a₇ … a₁.
const DRIFTS: [f64; 8] = [
    0.0378593198406116,
    0.102635633102435,
    -0.0258678882665587,
    0.314241403071447,
    -0.130144459517415,
    0.106417700369543,
    -0.00879424312851058,
    0.2073050690568954,
];

/// The kicks b₁ … b₇, which return as b₇ … b₁.
const KICKS: [f64; 7] = [
    0.0917191526244620,
    0.183983170005006,
    -0.0565343658328881,
    0.00491468877471189,
    0.143761127168358,
    0.328567693746804,
    -0.19641146648645424,
];

/// SRKN₁₄ᵃ of order 6: a₁ b₁ a₂ … b₁₄ a₁; the last drift is made together with the first of the next step.
///
/// S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313–330, table 3; a₈ and b₇ from Σ a = Σ b = 1.
#[inline(never)]
fn srkn14<M: Motion<D>, const D: usize>(motion: M, dt: f64, steps: u64, q: &mut [f64; D], v: &mut [f64; D]) {
    let (mut x, mut u, mut a) = (*q, *v, [0.0; D]);
    let (drifts, kicks) = (DRIFTS.map(|a| a * dt), KICKS.map(|b| b * dt));
    add(&mut x, drifts[0], &u);
    for step in 1..=steps {
        for stage in 0..14 {
            motion.acceleration(&x, &mut a);
            add(&mut u, kicks[if stage < 7 { stage } else { 13 - stage }], &a);
            let drift = match stage {
                13 if step < steps => 2.0 * drifts[0],
                0..7 => drifts[stage + 1],
                _ => drifts[13 - stage],
            };
            add(&mut x, drift, &u);
        }
    }
    (*q, *v) = (x, u);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::{eccentric, eight, fput, orbit, pendulum};

    #[test]
    fn drifts_and_kicks_fill_the_step() {
        let drifts = DRIFTS[7] + 2.0 * DRIFTS[..7].iter().sum::<f64>();
        let kicks = 2.0 * KICKS.iter().sum::<f64>();
        assert!((drifts - 1.0).abs() < 1e-15 && (kicks - 1.0).abs() < 1e-15, "{drifts} {kicks}");
    }

    /// The error falls by 2^p where the step is halved, on an orbit that is not close to a circle.
    #[test]
    fn loops_have_their_orders() {
        fn order<M: Motion<2>>(problem: &Problem<M, 2>, entrant: &Entrant<'_>, steps: f64) -> f64 {
            let error = |steps| entrant.run(steps).unwrap().error;
            assert!(error(2.0 * steps) > 1e-10, "{}", problem.title);
            (error(steps) / error(2.0 * steps)).log2()
        }
        for (twin, p, steps) in [(0, 2.0, 700_000.0), (1, 6.0, 3000.0)] {
            let problem = orbit();
            let found = order(&problem, &twins(&problem)[twin], steps);
            assert!((found - p).abs() < 0.1, "order {found} for {p}");
        }
        // Below 80 000 steps the pericentre is passed in too few for the leading term of the error to rule.
        let problem = eccentric();
        let found = order(&problem, &twins(&problem)[1], 80_000.0);
        assert!((found - 6.0).abs() < 0.1, "order {found}");
    }

    /// Eight stages end where 22 digits do: a few roundings of the way.
    #[test]
    fn gauss_ends_where_the_motion_does() {
        fn error<M: Motion<D>, const D: usize>(problem: &Problem<M, D>, steps: f64) -> f64 {
            let entrants = twins(problem);
            let gauss = entrants.iter().find(|entrant| entrant.label.starts_with("Gauss")).unwrap();
            gauss.run(steps).unwrap().error
        }
        for (found, most) in [
            (error(&orbit(), 2000.0), 3e-12),
            (error(&pendulum(), 120.0), 2e-13),
            (error(&eight(), 600.0), 2e-12),
            (error(&fput(), 700.0), 2e-12),
            (planet_twin(&eccentric()).run(0.2).unwrap().error, 2e-11),
        ] {
            assert!(found < most, "{found:e}, at most {most:e}");
        }
    }

    #[test]
    fn gauss_has_order_16() {
        let problem = orbit();
        let gauss = &twins(&problem)[2];
        let error = |steps| gauss.run(steps).unwrap().error;
        let order = (error(700.0) / error(1200.0)).ln() / (1200.0_f64 / 700.0).ln();
        assert!((order - 16.0).abs() < 1.0, "order {order}");
    }
}
