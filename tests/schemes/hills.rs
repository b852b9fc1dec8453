//! Down a quadratic hill: beyond a length of the step the only root of its equation is not the continuation of that of a shorter
//! one, but has come in from infinity on the other side. It is refused, from the first step on.

use dmech::Interrupted;
use dmech::extend::Potential;
use dmech::prelude::*;

use crate::first_step;

// Φ = Σ κᵢⱼ qᵢ qⱼ/2, written out: in one, two, three and five coordinates, apart and coupled.
law!(Slope, 1, |self, q| -0.5 * self.k * q[0] * q[0]);
// Of a determinant that is positive on the far side.
law!(Round, 2, |self, q| -0.5 * self.k * (q[0] * q[0] + q[1] * q[1]));
law!(Saddle, 2, |self, q| 0.5 * self.k * (q[0] * q[0] - 3.0 * q[0] * q[1] - 0.4 * q[1] * q[1]));
law!(Ridge, 3, |self, q| -0.5 * self.k * ((q[0] - q[1]).powi(2) + (q[1] - 0.5 * q[2]).powi(2)) + q[2] * q[2]);
law!(Loose, 5, |self, q| {
    -0.5 * self.k * (0..4).map(|i| (q[i] - q[i + 1]) * (q[i] - q[i + 1])).sum::<f64>() + 0.3 * q[0] * q[3]
});

/// The least eigenvalue of the Hessian, negated.
fn curvature<const D: usize>(law: &impl Potential<D>) -> f64 {
    let hessian = law.hessian([0.0; D]);
    -nalgebra::DMatrix::from_fn(D, D, |i, j| hessian[i][j]).symmetric_eigenvalues().min()
}

/// Steps of these parts of the longest; the first two are taken.
const PARTS: [f64; 7] = [0.3, 0.999, 1.001, 1.4, 3.0, 10.0, 1e4];

/// Whether ten steps were taken; if not, none was.
fn taken<X>(run: Result<Run<X>, Interrupted<X>>, dt: f64) -> bool {
    first_step(run, dt, "down a hill").is_some()
}

#[test]
fn steps_of_laws_are_refused_where_their_root_has_come_in_from_infinity() {
    let mut tried = 0;
    // The scheme, and by how much its equation takes h² κ/4.
    macro_rules! refused {
        ($law:expr, $d:literal, $($scheme:expr, $share:expr);*) => {$(
            let (law, mass) = ($law, 1.7);
            let longest = 2.0 * (mass / (curvature::<$d>(&law) * f64::from($share))).sqrt();
            let start = State::new(std::array::from_fn(|i| 0.3 + 0.2 * i as f64), std::array::from_fn(|i| 0.7 - 0.6 * i as f64));
            for part in PARTS {
                let dt = part * longest;
                let run = Simulation::new(law, start).mass(mass).scheme($scheme).dt(dt).run(10);
                assert_eq!(taken(run, dt), part < 1.0, "{} {} in steps of {part} of the longest", stringify!($law), stringify!($scheme));
                tried += 1;
            }
        )*};
    }
    macro_rules! each {
        ($($law:expr, $d:literal;)*) => {$(
            refused!($law, $d, DiscreteGradient, 1; Implicit, 1; Kanatani, 2);
        )*};
    }
    each! {
        Slope { k: 2.3 }, 1;
        Round { k: 2.3 }, 2;
        Saddle { k: 1.1 }, 2;
        Ridge { k: 1.9 }, 3;
        Loose { k: 0.7 }, 5;
    }
    assert_eq!(tried, 5 * 3 * PARTS.len());
}

/// A medium and a magnetic field on a hill.
#[derive(Clone, Copy, Debug)]
struct Forced {
    k: f64,
    drag: f64,
    turn: f64,
}

#[dmech::law]
impl Forced {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -0.5 * self.k * (q[0] * q[0] + 2.0 * q[1] * q[1])
    }

    #[force]
    fn force(&self, v: [f64; 2]) -> [f64; 2] {
        [self.turn * v[1] - self.drag * v[0], -self.turn * v[0] - self.drag * v[1]]
    }
}

/// The steeper side of the hill under drag: 1 + h c/2m − h² k/4m = 0.
#[test]
fn steps_under_drag_are_longer_by_as_much_as_it_holds_back() {
    for drag in [0.0, 0.8, 5.0] {
        let (law, mass) = (Forced { k: 1.1, drag, turn: 0.0 }, 1.3);
        let steep = 2.0 * law.k;
        let longest = (drag + (drag * drag + 4.0 * steep * mass).sqrt()) / steep;
        for part in PARTS {
            let (dt, start) = (part * longest, State::new([0.4, 0.2], [0.3, -0.1]));
            let simulation = || Simulation::new(law, start).mass(mass).dt(dt);
            // On the gentler side the determinant changes its sign once more, √2 times and more as far.
            if part < 1.4 {
                assert_eq!(taken(simulation().scheme(Implicit).run(10), dt), part < 1.0, "{drag} {part}");
                assert_eq!(taken(simulation().scheme(DiscreteGradient).run(10), dt), part < 1.0, "{drag} {part}");
            }
        }
    }
}

/// In a magnetic field the determinant of a round hill is (1 − h² k/4m)² + (h b/2m)², and no step is too long.
#[test]
fn a_charge_that_a_field_turns_on_a_hill_is_stepped_as_long_as_there_is_a_root_all_the_way() {
    let start = State::new([0.4, 0.2], [0.3, -0.1]);
    for part in PARTS {
        for turn in [3.1, 0.4] {
            let law = Charge { k: 1.2, turn };
            let dt = part * 2.0 / law.k.sqrt();
            assert!(taken(Simulation::new(law, start).scheme(DiscreteGradient).dt(dt).run(10), dt), "{turn} {part}");
        }
    }
}

/// A charge on a round hill.
#[derive(Clone, Copy, Debug)]
struct Charge {
    k: f64,
    turn: f64,
}

#[dmech::law]
impl Charge {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -0.5 * self.k * (q[0] * q[0] + q[1] * q[1])
    }

    #[force]
    fn force(&self, v: [f64; 2]) -> [f64; 2] {
        [self.turn * v[1], -self.turn * v[0]]
    }
}

/// Whoever has too long a step is told so; the others go on.
#[test]
fn of_members_side_by_side_those_are_refused_whose_step_is_too_long() {
    let dt = 1.3;
    let steep = |k: usize| 0.2 + 0.3 * k as f64;
    let members = Ensemble::of(17)
        .law(|k| Slope { k: steep(k) })
        .start(|k| State::new([0.3 + 0.01 * k as f64], [0.1]))
        .scheme(DiscreteGradient)
        .dt(dt)
        .run(4)
        .unwrap();
    let mut refused = 0;
    for k in 0..17 {
        let longest = 2.0 / steep(k).sqrt();
        let start = State::new([0.3 + 0.01 * k as f64], [0.1]);
        let alone = Simulation::new(Slope { k: steep(k) }, start).scheme(DiscreteGradient).dt(dt).run(4);
        match (members.last(k), alone) {
            (Ok(last), Ok(alone)) => {
                assert!(dt < longest);
                assert_eq!(last.q[0].to_bits(), alone.last().q[0].to_bits());
            }
            (Err(cause), Err(alone)) => {
                assert!(dt > longest && cause == alone.cause(), "{cause}");
                refused += 1;
            }
            (member, alone) => panic!("member {k}: {member:?}, alone {:?}", alone.map(|_| ())),
        }
    }
    assert!((4..=13).contains(&refused), "{refused}");
}

/// Two bodies push each other apart, k |d|²/2 downhill.
#[derive(Clone, Copy, Debug)]
struct Push {
    k: f64,
}

#[dmech::law]
impl Push {
    #[pair]
    fn energy(&self, d: [f64; 2]) -> f64 {
        -0.5 * self.k * (d[0] * d[0] + d[1] * d[1])
    }
}

/// As laws: on a hill, in pairs, along a chain and in bonds, which have matrices of four kinds; and the same bodies as one law.
#[test]
fn steps_of_scenes_are_refused_as_those_of_laws() {
    const BODIES: usize = 5;
    let mass = |i: usize| 0.7 + 0.5 * i as f64;
    let bodies = || {
        (0..BODIES).fold(Scene::new(), |scene, i| {
            let x = i as f64;
            scene.body(mass(i), [x, 0.3 * x * x - 1.0], [0.2 * x, 0.5 - 0.3 * x])
        })
    };
    let k = 1.3;
    // The largest of −M^(−1/2) Φ″ M^(−1/2), of links as often as they are listed and of a hill for each: each coordinate by itself.
    let steepest = |links: &[(f64, &[(usize, usize)])], own: f64| {
        let mut h = nalgebra::DMatrix::<f64>::zeros(BODIES, BODIES);
        for i in 0..BODIES {
            h[(i, i)] = own / mass(i);
        }
        for (k, links) in links {
            for &(a, b) in *links {
                for (i, j, sign) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
                    h[(i, j)] += sign * k / (mass(i) * mass(j)).sqrt();
                }
            }
        }
        h.symmetric_eigenvalues().max()
    };
    let pairs: Vec<_> = (0..BODIES).flat_map(|a| (0..a).map(move |b| (a, b))).collect();
    let chain: Vec<_> = (1..BODIES).map(|i| (i - 1, i)).collect();
    let bonds = [(0, 2), (1, 4), (2, 3)];
    let mut tried = 0;
    macro_rules! refused {
        ($($scene:expr, $steepest:expr;)*) => {$(
            let longest = 2.0 / f64::sqrt($steepest);
            for part in PARTS {
                let place = format!("{} in steps of {part} of the longest", stringify!($scene));
                let run = |share: f64| Simulation::scene($scene).dt(share * part * longest);
                let (dt, shorter) = (part * longest, 0.5f64.sqrt());
                assert_eq!(taken(run(1.0).scheme(DiscreteGradient).run(3), dt), part < 1.0, "{place}");
                assert_eq!(taken(run(1.0).scheme(Implicit).run(3), dt), part < 1.0, "{place}");
                assert_eq!(taken(run(shorter).scheme(Kanatani).run(3), shorter * part * longest), part < 1.0, "{place}");
                tried += 1;
            }
        )*};
    }
    refused! {
        bodies().field(Round { k }), steepest(&[], k);
        bodies().pairs(Push { k }), steepest(&[(k, &pairs)], 0.0);
        bodies().chain(Push { k }), steepest(&[(k, &chain)], 0.0);
        bodies().bonds(Push { k }, bonds), steepest(&[(k, &bonds)], 0.0);
        bodies().field(Round { k: 0.9 }).chain(Push { k }), steepest(&[(k, &chain)], 0.9);
        // It feels the last body, which does not feel it.
        bodies().test_body(0.1, [2.0, 0.4], [0.1, 0.0]).chain(Push { k }), f64::max(k / 0.1, steepest(&[(k, &chain)], 0.0));
        bodies().pairs(Push { k: -k }).chain(Push { k: 2.0 * k }), steepest(&[(-k, &pairs), (2.0 * k, &chain)], 0.0);
    }
    assert_eq!(tried, 7 * PARTS.len());
}

/// Two directions of one hill, coupled and under a drag, twice over too long: of such a matrix the determinant is positive again, but the
/// macro sees that it is symmetric, and asks both pivots.
#[test]
fn steps_under_drag_are_refused_where_two_directions_are_too_long() {
    law!(
        Drop,
        2,
        |self, q| -0.5 * self.k * ((0.6 * q[0] + 0.8 * q[1]).powi(2) + 0.7 * (0.8 * q[0] - 0.6 * q[1]).powi(2)),
        |v| [-0.1 * v[0], -0.1 * v[1]]
    );
    law!(
        Bent,
        2,
        |self, q| -0.5 * self.k * ((0.6 * q[0] + 0.8 * q[1]).powi(2) + 0.7 * (0.8 * q[0] - 0.6 * q[1]).powi(2))
            - 1e-4 * q[0].powi(4),
        |v| [-0.1 * v[0], -0.1 * v[1]]
    );
    let start = State::new([0.1, 0.2], [0.3, -0.1]);
    let mut counts = [0; 2];
    macro_rules! each {
        ($($law:expr, $scheme:expr;)*) => {$(
            for h in [0.5, 1.0, 1.5, 1.8, 2.6, 3.0, 5.0, 9.0] {
                // 1 − h²/4 k and 1 − 0.7 h²/4 k, with a drag that lengthens the limit by less than a tenth.
                let beyond = h > 2.3;
                let run = taken(Simulation::new($law, start).scheme($scheme).dt(h).run(1), h);
                assert_eq!(run, !beyond, "{} {}: a step of {h}", stringify!($law), stringify!($scheme));
                counts[usize::from(beyond)] += 1;
            }
        )*};
    }
    each! {
        Drop { k: 1.0 }, Implicit;
        Drop { k: 1.0 }, DiscreteGradient;
        Bent { k: 1.0 }, Implicit;
    }
    assert_eq!(counts, [12, 12]);
}

/// From the top of a hill, in steps far too long and in some that are not: the step that starts from Δ = 0 finds that of a motion which has
/// turned round, with an exact energy and a positive determinant.
#[test]
fn a_motion_from_the_top_of_a_hill_does_not_turn_round() {
    law!(Top, 2, |self, q| self.k / (q[0] * q[0] + q[1] * q[1] + 0.01).sqrt() + 0.1 * q[0] * q[0]);
    let (q, v) = ([0.0, 0.0], [1.0, 0.3]);
    for k in [0.3, 1.0, 3.0, 10.0] {
        for h in [0.2, 0.3, 0.5, 1.0, 2.0, 3.0] {
            let alone = Simulation::new(Top { k }, State::new(q, v)).scheme(DiscreteGradient).dt(h).run(1);
            let scene = Simulation::scene(Scene::new().body(1.0, q, v).field(Top { k }));
            let scene = scene.scheme(DiscreteGradient).dt(h).run(1);
            for (by, [x, y]) in [("law", alone.unwrap().last().q), ("scene", scene.unwrap().last().q[0])] {
                // Down the hill it becomes faster.
                let ahead = (x * v[0] + y * v[1]) / (v[0] * v[0] + v[1] * v[1]);
                assert!(ahead > 0.9 * h, "{by}, k = {k}: a step of {h} leads to {x}, {y}");
            }
        }
    }
    // Beside it.
    law!(Needle, 2, |self, q| self.k / (q[0] * q[0] + q[1] * q[1] + 0.00114383).sqrt() + 0.1 * q[0] * q[0]);
    let ([x, y], law) = ([-0.005005, 0.003409], Needle { k: 0.188185 });
    let scene = Simulation::scene(Scene::new().body(1.0, [x, y], [-0.972358, 0.403902]).field(law));
    let [to_x, to_y] = scene.scheme(DiscreteGradient).dt(1.116612).run(1).unwrap().last().q[0];
    assert!(to_x < x && to_y > y, "a step from {x}, {y} leads to {to_x}, {to_y}");
}
