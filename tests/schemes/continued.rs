//! Steps that are far too long, of laws that are not linear: where one is taken the matrix 1 + g J at its root may have grown from the
//! unit matrix without having been singular, and where none is, the step is refused.

use dmech::prelude::*;
use dmech::{Ensemble, Potential};
use nalgebra::SMatrix;

use crate::first_step;

law!(Ripples, 1, |self, q| 0.5 * q[0] * q[0] + self.k * (3.0 * q[0]).cos());
law!(Hump, 1, |self, q| self.k * (-q[0] * q[0]).exp());
law!(Shelf, 1, |self, q| if q[0] > 0.0 { self.k * (-q[0] * q[0]).exp() } else { self.k });
law!(HenonHeiles, 2, |self, q| 0.5 * (q[0] * q[0] + self.k * q[1] * q[1]) + q[0] * q[0] * q[1] - q[1].powi(3) / 3.0);
law!(Bottle, 2, |self, q| -0.5 * self.k * (q[0] * q[0] + q[1] * q[1]) + 0.02 * (q[0] * q[0] + q[1] * q[1]).powi(2));
law!(Eggs, 2, |self, q| (2.0 * q[0]).cos() * (1.5 * q[1]).cos() + 0.1 * self.k * (q[0] * q[0] + q[1] * q[1]));
law!(Three, 3, |self, q| 0.5 * (q[0] * q[0] - self.k * q[1] * q[1] + q[2] * q[2])
    + q[0] * q[1] * q[2]
    + 0.1 * q[1].powi(4));
law!(Four, 4, |self, q| q[0] * q[1] * q[2] - self.k * (q[3] - q[0]).cos() + 0.1 * (q[1].powi(4) + q[2].powi(4)));
law!(Dragged, 2, |self, q| 0.5 * q[0] * q[0] - self.k * (q[0] - q[1]).cos(), |v| [-0.3 * v[0], -0.3 * v[1]]);
law!(Charged, 2, |self, q| q[0] * q[0] * q[1] + self.k * q[1].cos(), |v| [0.7 * v[1], -0.7 * v[0]]);

/// Starts and steps from short to far too long.
fn tries<const D: usize>() -> impl Iterator<Item = (State<D>, f64)> {
    (0..160).map(|k| {
        let at = |shift: f64, rate: f64| {
            core::array::from_fn(|i| 1.5 * (rate * f64::from(k) + (1.0 + shift) * i as f64 + shift).sin())
        };
        (State::new(at(0.0, 1.7), at(1.2, 2.3)), 0.2 * 1.023_f64.powi(k))
    })
}

/// How many of them are taken by both schemes, all with a matrix as it must be, and how many are refused. The force is −C v.
macro_rules! counted {
    ($law:ident { $k:literal }, $d:literal, $medium:expr) => {{
        let law = $law { k: $k };
        let medium: SMatrix<f64, $d, $d> = $medium;
        let [mut taken, mut refused] = [0, 0];
        for (start, h) in tries::<$d>() {
            let run = |exact: bool| {
                let run = Simulation::new(law, start).dt(h);
                if exact { run.scheme(DiscreteGradient).run(1) } else { run.scheme(Implicit).run(1) }
            };
            for exact in [false, true] {
                let place = format!("{} from {start:?} by {h}, exact {exact}", stringify!($law));
                match first_step(run(exact), h, &place) {
                    Some(run) => {
                        let end = run.last().q;
                        let (share, jacobian) = match exact {
                            true => (0.5, law.discrete_gradient_jacobian(start.q, end)),
                            false => (0.25, law.hessian(end)),
                        };
                        let jacobian = SMatrix::<f64, $d, $d>::from_fn(|i, j| jacobian[i][j]);
                        let matrix = SMatrix::identity() + 0.5 * h * medium + share * h * h * jacobian;
                        // Of a determinant of 0 rounding decides.
                        let least = if matrix == matrix.transpose() {
                            matrix.symmetric_eigenvalues().min()
                        } else {
                            matrix.determinant()
                        };
                        assert!(least > -1e-9, "{place}: {least}");
                        taken += 1;
                    }
                    None => {
                        refused += 1;
                    }
                }
            }
        }
        assert!(taken > 150, "{}: {taken}", stringify!($law));
        refused
    }};
}

#[test]
fn no_root_is_taken_that_cannot_continue_those_of_shorter_steps() {
    let refused = [
        counted!(Ripples { 0.8 }, 1, SMatrix::zeros()),
        counted!(Hump { 2.0 }, 1, SMatrix::zeros()),
        counted!(Shelf { 1.7 }, 1, SMatrix::zeros()),
        counted!(HenonHeiles { 1.3 }, 2, SMatrix::zeros()),
        counted!(Bottle { 1.1 }, 2, SMatrix::zeros()),
        counted!(Eggs { 0.9 }, 2, SMatrix::zeros()),
        counted!(Three { 1.2 }, 3, SMatrix::zeros()),
        counted!(Four { 0.8 }, 4, SMatrix::zeros()),
        counted!(Dragged { 1.9 }, 2, SMatrix::identity() * 0.3),
        counted!(Charged { 1.4 }, 2, SMatrix::<f64, 2, 2>::new(0.0, -0.7, 0.7, 0.0)),
    ];
    assert!(refused.iter().sum::<usize>() > 300, "{refused:?}");
}

/// Members whose steps are refused, and those whose longer way is gone alone, are what they are alone.
#[test]
fn of_members_side_by_side_each_is_what_it_is_alone() {
    let law = HenonHeiles { k: 1.3 };
    let tried: Vec<_> = tries::<2>().collect();
    let h = 0.8;
    let members =
        Ensemble::of(tried.len()).law(|_| law).start(|k| tried[k].0).scheme(DiscreteGradient).dt(h).run(3).unwrap();
    let mut refused = 0;
    for (k, (start, _)) in tried.iter().enumerate() {
        match (members.last(k), Simulation::new(law, *start).scheme(DiscreteGradient).dt(h).run(3)) {
            (Ok(last), Ok(alone)) => assert_eq!(last.q.map(f64::to_bits), alone.last().q.map(f64::to_bits), "{k}"),
            (Err(cause), Err(alone)) => {
                assert_eq!(cause, alone.cause(), "{k}");
                refused += 1;
            }
            (member, alone) => panic!("member {k}: {member:?}, alone {:?}", alone.map(|_| ())),
        }
    }
    assert!((20..140).contains(&refused), "{refused}");
}

/// Newton's method from where a long step starts leads to roots that no shorter step has; it is believed only where it is swift. Against
/// roots that are followed in 4000 parts of the step.
#[test]
fn a_root_from_where_the_step_starts_is_the_one_that_shorter_steps_lead_to() {
    law!(Cups, 2, |self, q| self.k * (2.0 * q[0]).cos() * (1.5 * q[1]).cos() + 0.08 * (q[0] * q[0] + q[1] * q[1]));
    law!(Waves, 2, |self, q| 0.5 * (q[0] * q[0] + 0.7 * q[1] * q[1])
        + 0.6 * self.k * (3.0 * q[0]).cos()
        + 0.4 * (2.0 * q[1] + q[0]).cos());
    fn followed(law: &impl Potential<2>, q: [f64; 2], v: [f64; 2], h: f64) -> [f64; 2] {
        let here = law.gradient(q);
        let mut delta = [0.0; 2];
        for part in 1..=4000 {
            let [h, g] = [h * f64::from(part) / 4000.0, (h * f64::from(part) / 4000.0).powi(2) / 4.0];
            for _ in 0..20 {
                let b = [q[0] + delta[0], q[1] + delta[1]];
                let (force, [row, below]) = (law.gradient(b), law.hessian(b));
                let r = [0, 1].map(|i| h * v[i] - g * (here[i] + force[i]) - delta[i]);
                let [a, b, c] = [1.0 + g * row[0], g * row[1], 1.0 + g * below[1]];
                let determinant = a * c - b * b;
                delta[0] += (c * r[0] - b * r[1]) / determinant;
                delta[1] += (a * r[1] - b * r[0]) / determinant;
            }
        }
        [q[0] + delta[0], q[1] + delta[1]]
    }
    macro_rules! same {
        ($($law:expr, $q:expr, $v:expr, $h:expr;)*) => {$({
            let alone = Simulation::new($law, State::new($q, $v)).scheme(Implicit).dt($h).run(1).unwrap().last().q;
            let scene = Simulation::scene(Scene::new().body(1.0, $q, $v).field($law)).scheme(Implicit).dt($h);
            let root = followed(&$law, $q, $v, $h);
            for taken in [alone, scene.run(1).unwrap().last().q[0]] {
                let off = f64::max((taken[0] - root[0]).abs(), (taken[1] - root[1]).abs());
                assert!(off < 1e-9, "{} in {}: {taken:?} for {root:?}", stringify!($law), $h);
            }
        })*};
    }
    same! {
        Cups { k: 1.0 }, [-0.4, -2.0], [-1.0, 0.85], 2.65;
        Waves { k: 1.0 }, [-1.55, -1.25], [1.45, -0.65], 1.55;
        Waves { k: 1.0 }, [0.45, 1.95], [1.55, -1.25], 1.8;
        Waves { k: 1.0 }, [1.6, 1.25], [1.15, 0.95], 2.0;
    }
}
