//! `verify` passes right laws and catches wrong ones.

use dmech::Conservative;
use dmech::extend::Field;
use dmech::extend::newton::{self, Equation, Increment, NotConverged};
use dmech::prelude::*;
use dmech_study::verify::{Outcome, Verification, Verify};

use dmech_tests::for_each_law;
use dmech_tests::laws::*;

/// A quartic bowl with drag in a wind that turns: velocity and time.
#[derive(Clone, Copy, Debug)]
struct Wind {
    k: f64,
    drag: f64,
    gust: f64,
    omega: f64,
}

#[dmech::law]
impl Wind {
    #[potential]
    fn bowl(&self, q: [f64; 2]) -> f64 {
        0.25 * self.k * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
    }
    #[force]
    fn drag(&self, v: [f64; 2], t: f64) -> [f64; 2] {
        let u = [v[0] - self.gust * (self.omega * t).cos(), v[1] - self.gust * (self.omega * t).sin()];
        let c = self.drag * (0.1 + u[0] * u[0] + u[1] * u[1]).sqrt();
        [-c * u[0], -c * u[1]]
    }
}

/// A magnetic field that grows with x, and a well beside it: the force does no work.
#[derive(Clone, Copy, Debug)]
struct Bottle {
    b: f64,
    k: f64,
}

#[dmech::law]
impl Bottle {
    #[potential]
    fn well(&self, q: [f64; 2]) -> f64 {
        0.5 * self.k * (q[0] * q[0] + 1.5 * q[1] * q[1]) + 0.1 * q[0].powi(4)
    }
    #[force]
    fn lorentz(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let b = self.b * (1.0 + 0.4 * q[0] * q[0]);
        [b * v[1], -b * v[0]]
    }
}

/// k x⁴ + l x² by hand, right or with one mistake.
struct Quartic {
    k: f64,
    l: f64,
    mistake: Mistake,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Mistake {
    None,
    SignOfHessian,
    SignOfGradient,
    MidpointGradient,
    EndGradient,
    Jacobian,
    QuotientWithoutLimit,
}

impl Conservative for Quartic {}
impl Potential<1> for Quartic {
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        self.k * x.powi(4) + self.l * x * x
    }
    fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] {
        let sign = if self.mistake == Mistake::SignOfGradient { -1.0 } else { 1.0 };
        [4.0 * self.k * x.powi(3) + sign * 2.0 * self.l * x]
    }
    fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] {
        let sign = if self.mistake == Mistake::SignOfHessian { -1.0 } else { 1.0 };
        [[12.0 * self.k * x * x + sign * 2.0 * self.l]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        match self.mistake {
            Mistake::MidpointGradient => self.gradient([0.5 * (a + b)]),
            Mistake::EndGradient => self.gradient([b]),
            Mistake::QuotientWithoutLimit => [(self.potential([b]) - self.potential([a])) / (b - a)],
            _ => [self.k * (a + b) * (a * a + b * b) + self.l * (a + b)],
        }
    }
    fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
        let factor = if self.mistake == Mistake::Jacobian { 1.0 } else { 2.0 };
        match self.mistake {
            Mistake::MidpointGradient => [[0.5 * self.hessian([0.5 * (a + b)])[0][0]]],
            Mistake::EndGradient => self.hessian([b]),
            _ => [[self.k * (a * a + b * b + factor * b * (a + b)) + self.l]],
        }
    }
}

/// k m x⁴/4 with a drag −c (1 + x²) v³ by hand, right or with one mistake.
struct Drag {
    k: f64,
    c: f64,
    mistake: DragMistake,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum DragMistake {
    None,
    ByPosition,
    ByVelocity,
    Slope,
    GradientWithoutMass,
}

/// It for one mass.
struct DragField<'a> {
    law: &'a Drag,
    m: f64,
}

impl Law<1> for Drag {
    type Field<'a> = DragField<'a>;

    fn field(&self, m: f64, _: f64) -> DragField<'_> {
        DragField { law: self, m }
    }
}

impl Potential<1> for DragField<'_> {
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        0.25 * self.law.k * self.m * x.powi(4)
    }
    fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] {
        let m = if self.law.mistake == DragMistake::GradientWithoutMass { 1.0 } else { self.m };
        [self.law.k * m * x.powi(3)]
    }
    fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] {
        [[3.0 * self.law.k * self.m * x * x]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        [0.25 * self.law.k * self.m * (a + b) * (a * a + b * b)]
    }
    fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
        [[0.25 * self.law.k * self.m * (a * a + b * b + 2.0 * b * (a + b))]]
    }
}

impl Field<1> for DragField<'_> {
    const FORCED: bool = true;
    const CONSERVES_ENERGY: bool = false;

    fn kick(&self, c: f64, q: [f64; 1], v: [f64; 1]) -> [f64; 1] {
        [v[0] - c * (self.gradient(q)[0] - self.force(q, v, 0.0)[0])]
    }
    fn implicit_increment(&self, equation: &Equation<1, f64>) -> Result<Increment<1, f64>, NotConverged> {
        newton::dense_forced(equation, |_, _, q, v| {
            let [dq, dv] = [self.force_dq(q, v, 0.0), self.force_dv(q, v, 0.0)].map(|jacobian| jacobian[0][0]);
            let slope = self.gradient(q)[0] - self.force(q, v, 0.0)[0];
            ([slope], [[self.hessian(q)[0][0] - dq]], [[-dv]])
        })
    }
    fn discrete_increment(&self, equation: &Equation<1, f64>) -> Result<Increment<1, f64>, NotConverged> {
        newton::dense_forced(equation, |equation, _, q, v| {
            let [dq, dv] = [self.force_dq(q, v, 0.0), self.force_dv(q, v, 0.0)].map(|jacobian| jacobian[0][0]);
            let slope = self.discrete_gradient(equation.a, q)[0] - 0.5 * self.force(q, v, 0.0)[0];
            let by_position = self.discrete_gradient_jacobian(equation.a, q)[0][0] - 0.5 * dq;
            ([slope], [[by_position]], [[-0.5 * dv]])
        })
    }

    fn slope(&self, q: [f64; 1], v: [f64; 1]) -> [f64; 1] {
        let sign = if self.law.mistake == DragMistake::Slope { 1.0 } else { -1.0 };
        [self.gradient(q)[0] + sign * self.force(q, v, 0.0)[0]]
    }
    fn half_force(&self, q: [f64; 1], v: [f64; 1]) -> [f64; 1] {
        [0.5 * self.force(q, v, 0.0)[0]]
    }
    fn force(&self, [x]: [f64; 1], [v]: [f64; 1], _: f64) -> [f64; 1] {
        [-self.law.c * (1.0 + x * x) * v.powi(3)]
    }
    fn force_dq(&self, [x]: [f64; 1], [v]: [f64; 1], _: f64) -> [[f64; 1]; 1] {
        let factor = if self.law.mistake == DragMistake::ByPosition { 1.0 } else { 2.0 };
        [[-factor * self.law.c * x * v.powi(3)]]
    }
    fn force_dv(&self, [x]: [f64; 1], [v]: [f64; 1], _: f64) -> [[f64; 1]; 1] {
        let factor = if self.law.mistake == DragMistake::ByVelocity { 2.0 } else { 3.0 };
        [[-factor * self.law.c * (1.0 + x * x) * v * v]]
    }
}

/// Names of the checks with this outcome.
pub(super) fn with<Of>(report: &Verification<Of>, outcome: Outcome) -> Vec<&str> {
    report.checks().iter().filter(|check| check.outcome() == outcome).map(|check| check.name()).collect()
}

#[test]
fn right_laws_pass() {
    let mut wrong = Vec::new();
    macro_rules! one {
        ($law:ident, $d:literal, $q:expr, $v:expr) => {{
            let report = verify($law::new(), State::<$d>::new($q, $v)).with_half_step_schemes();
            println!("{}\n{report}\n", stringify!($law));
            let passed = with(&report, Outcome::Passed).len();
            // One row less for the floor: near its kink there is no derivative to compare.
            let least = if stringify!($law) == "Floor" { 21 } else { 22 };
            assert!(passed >= least, "{}: only {passed} checks had something to check", stringify!($law));
            if !report.passed() {
                wrong.push((stringify!($law), with(&report, Outcome::Failed).join(", ")));
            }
        }};
    }
    for_each_law!(one);
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A pendulum over three magnets: in the middle their forces cancel, to their own rounding and not to that of what is left.
#[derive(Clone, Copy, Debug)]
struct Magnets {
    pull: f64,
}

#[dmech::law]
impl Magnets {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let mut sum = 0.25 * (q[0] * q[0] + q[1] * q[1]);
        for i in 0..3 {
            let angle = 2.0943951023931953 * (i as f64);
            let (x, y) = (q[0] - angle.cos(), q[1] - angle.sin());
            sum += -self.pull / (x * x + y * y + 0.04).powf(1.5);
        }
        sum
    }
}

#[test]
fn a_law_passes_where_its_forces_cancel() {
    for (q, v) in [([0.0, 0.0], [0.2, -0.1]), ([1.5, 0.3], [0.0, 0.0])] {
        let report = verify(Magnets { pull: 0.1 }, State::new(q, v));
        assert!(report.passed(), "{q:?} {v:?}\n{report}");
    }
}

#[test]
fn laws_with_forces_pass() {
    let start = State::new([0.7, -0.4], [0.3, 0.9]);
    let wind = verify(Wind { k: 1.7, drag: 0.3, gust: 0.8, omega: 2.3 }, start);
    println!("Wind\n{wind}\n");
    wind.assert();
    assert!(with(&wind, Outcome::NotApplicable).contains(&"DiscreteGradient: energy"));
    let bottle = verify(Bottle { b: 1.3, k: 0.6 }, start);
    println!("Bottle\n{bottle}");
    bottle.assert();
    assert!(with(&bottle, Outcome::Passed).contains(&"claim: no work"));
    assert!(with(&bottle, Outcome::Passed).contains(&"DiscreteGradient: energy"));
    for report in [&with(&wind, Outcome::Passed), &with(&bottle, Outcome::Passed)] {
        assert!(report.contains(&"force by position") && report.contains(&"force by velocity"), "{report:?}");
    }
}

#[test]
fn wrong_forces_are_caught_where_they_are_wrong() {
    let cases: [(DragMistake, &[&str]); 5] = [
        (DragMistake::None, &[]),
        (DragMistake::ByPosition, &["force by position"]),
        (DragMistake::ByVelocity, &["force by velocity"]),
        (DragMistake::Slope, &["kick and slope", "slope and gradient"]),
        (DragMistake::GradientWithoutMass, &["gradient", "limit b = a", "Hessian"]),
    ];
    for (mistake, expected) in cases {
        let law = || Drag { k: 1.7, c: 0.4, mistake };
        let start = State::new([0.9], [0.7]);
        let report = Verify::new(law(), start).mass(2.3).run();
        println!("{mistake:?}\n{report}\n");
        let failed = with(&report, Outcome::Failed);
        assert_eq!(report.passed(), expected.is_empty(), "{mistake:?}\n{report}");
        let missing: Vec<_> = expected.iter().filter(|name| !failed.contains(name)).collect();
        assert!(missing.is_empty(), "{mistake:?} not seen by {missing:?}");
        // A mass of 1 hides a mass that was forgotten: that is what the option is for.
        let hidden = mistake == DragMistake::GradientWithoutMass;
        assert_eq!(verify(law(), start).passed(), hidden || expected.is_empty(), "{mistake:?}");
    }
}

#[test]
fn any_mass_will_do_but_a_senseless_one() {
    let start = State::new([0.7, -0.4], [0.3, 0.9]);
    // Bound at any speed: a heavy particle has much energy.
    let well = State::new([0.8, -0.6, 0.5], [0.2, 0.5, -0.7]);
    for mass in [1e-3, 0.6, 1e3] {
        Verify::new(Wind { k: 1.7, drag: 0.3, gust: 0.8, omega: 2.3 }, start).mass(mass).run().assert();
        Verify::new(Wells::new(), well).mass(mass).run().with_half_step_schemes().assert();
    }
    for mass in [0.0, -1.3, f64::NAN, f64::INFINITY] {
        let report = Verify::new(Wells::new(), well).mass(mass).run();
        assert!(!report.passed() && report.to_string().contains("the mass must be positive"), "{report}");
    }
}

#[test]
fn units_are_free() {
    for unit in [1e-9, 1.0, 1e11] {
        // Lengths in another unit: m v² and k x⁴ stay energies of the same kind.
        let law = Quartic { k: 0.7 / (unit * unit), l: 0.4, mistake: Mistake::None };
        let report = verify(law, State::new([0.9 * unit], [0.3 * unit])).with_half_step_schemes();
        assert!(report.passed(), "unit {unit:e}\n{report}");
        assert!(with(&report, Outcome::Passed).len() >= 22, "unit {unit:e}\n{report}");
    }
}

#[test]
fn wrong_laws_are_caught_where_they_are_wrong() {
    let cases: [(Mistake, &[&str]); 6] = [
        (Mistake::SignOfHessian, &["Hessian"]),
        (Mistake::SignOfGradient, &["gradient", "Hessian", "limit b = a"]),
        (Mistake::MidpointGradient, &["secant identity", "DiscreteGradient: energy", "Kanatani: discrete energy"]),
        (Mistake::EndGradient, &["secant identity", "symmetry in a, b", "DiscreteGradient: order"]),
        (Mistake::Jacobian, &["its Jacobian"]),
        (Mistake::QuotientWithoutLimit, &["limit b = a"]),
    ];
    for (mistake, expected) in cases {
        let law = Quartic { k: 0.7, l: 0.4, mistake };
        let report = verify(law, State::new([0.9], [0.3])).with_half_step_schemes();
        println!("{mistake:?}\n{report}\n");
        assert!(!report.passed(), "{mistake:?}");
        let failed = with(&report, Outcome::Failed);
        let missing: Vec<_> = expected.iter().filter(|name| !failed.contains(name)).collect();
        assert!(missing.is_empty(), "{mistake:?} not seen by {missing:?}");
    }
}

#[test]
fn senseless_starts_fail_without_a_panic() {
    for q in [f64::NAN, f64::INFINITY] {
        let report = verify(Quartic { k: 0.7, l: 0.4, mistake: Mistake::None }, State::new([q], [0.3]));
        assert!(!report.passed(), "{report}");
    }
    assert!(!verify(Kepler { gm: 1.3 }, State::new([0.0, 0.0], [0.1, 0.2])).passed());
    // At rest in an equilibrium nothing moves, and nothing is wrong.
    let report = verify(Quartic { k: 0.7, l: 0.4, mistake: Mistake::None }, State::new([0.0], [0.0]));
    println!("{report}");
    assert!(report.passed(), "{report}");
}

#[test]
#[should_panic(expected = "the verification failed")]
fn one_line_in_a_test() {
    verify(Quartic { k: 0.7, l: 0.4, mistake: Mistake::SignOfHessian }, State::new([0.9], [0.3])).assert();
}

#[test]
fn the_table_is_aligned_and_the_same_each_time() {
    let make = || verify(Kepler { gm: 1.3 }, State::new([0.9, 0.2], [-0.1, 1.1])).with_half_step_schemes().to_string();
    let table = make();
    assert_eq!(table, make());
    let lines: Vec<&str> = table.lines().collect();
    let column = lines[0].find("note").unwrap();
    for line in &lines[1..lines.len() - 1] {
        assert!(
            line.is_char_boundary(column) && line[..column].ends_with("  ") && !line[column..].starts_with(' '),
            "{line}"
        );
    }
}
