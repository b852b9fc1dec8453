//! Elements of orbits: there and back, along the orbit, at the edges.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dmech::models::kepler::{Elements, OrbitError, anomaly};
use dmech::models::units::*;
use dmech::models::{Kepler, Kepler3};
use dmech::prelude::*;

use dmech_tests::motion::distance;

/// Numbers between 0 and 1, the same in every run (Knuth's linear congruential generator).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// One of the edges first, as long as there are any.
    fn one_of(&mut self, edges: &[f64], scale: f64) -> f64 {
        let at = (self.next() * 1.6 * edges.len() as f64) as usize;
        edges.get(at).copied().unwrap_or(scale * self.next())
    }
}

const ECCENTRICITIES: [f64; 16] = [
    0.0,
    1e-300,
    1e-17,
    1e-12,
    1e-6,
    0.5,
    0.99,
    1.0 - 1e-6,
    1.0 - 1e-10,
    1.0 - 1e-16,
    1.0,
    1.0 + 1e-15,
    1.0 + 1e-10,
    1.0 + 1e-6,
    1.5,
    30.0,
];

fn random(numbers: &mut Numbers) -> Elements {
    let gm = 10.0_f64.powf(40.0 * numbers.next() - 20.0);
    let pericentre = 10.0_f64.powf(40.0 * numbers.next() - 20.0);
    let eccentricity = numbers.one_of(&ECCENTRICITIES, 2.0);
    let inclination = numbers.one_of(&[0.0, 1e-300, 1e-17, 1e-8, FRAC_PI_2, PI - 1e-8, PI], PI);
    let node = numbers.one_of(&[0.0, FRAC_PI_2, PI, 1.5 * PI], TAU);
    let argument = numbers.one_of(&[0.0, FRAC_PI_2, PI, 1.5 * PI], TAU);
    Elements { gm, pericentre, eccentricity, inclination, node, argument, passage: 0.0 }
}

/// |a − b| in units in the last place of b.
fn ulps<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    // Not |b|², which may overflow.
    let size = b.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    distance(a.map(|x| x / size), b.map(|x| x / size)) / f64::EPSILON
}

/// Elements → state → elements → state: the state comes back to a few ulp, far out on what is nearly a parabola times r/q,
/// the part of the energy in the rounding of e. The elements come back as far as the state has them: far out its angular
/// momentum is a part q/r of |q| |v|.
#[test]
fn states_have_their_elements() -> Result<(), OrbitError> {
    let mut numbers = Numbers(1);
    let (mut worst, mut seen) = ([[0.0_f64; 2]; 2], 0);
    for _ in 0..60_000 {
        let orbit = random(&mut numbers);
        // A mean anomaly up to half a revolution, or as far as a thousand times the time scale of the pericentre.
        let unit = (orbit.pericentre / orbit.gm).sqrt() * orbit.pericentre;
        let reach = orbit.period().map_or(f64::INFINITY, |period| 0.5 * period / unit).min(1e3);
        let t = (2.0 * numbers.next() - 1.0) * numbers.one_of(&[0.0, 1e-12, 1.0], 1.0) * reach * unit;
        let state = orbit.at(t)?;
        let back = Elements::of(orbit.gm, &state)?;
        let again = back.at(t)?;
        let r = distance(state.q.map(|x| x / orbit.pericentre), [0.0; 3]);
        let (e, of_state) = (orbit.eccentricity, back.eccentricity);
        let near_parabola = (0.9..1.1).contains(&e);
        let condition = if near_parabola { r } else { 1.0 };
        for (worst, ulps) in
            worst[usize::from(near_parabola)].iter_mut().zip([ulps(again.q, state.q), ulps(again.v, state.v)])
        {
            *worst = worst.max(ulps / condition);
            assert!(ulps < 40.0 * condition, "{ulps:.1} ulp, r = {r} q\n{orbit:?}\n{back:?}");
        }
        assert!((e - of_state).abs() < 30.0 * f64::EPSILON * r * (1.0 + e), "{orbit:?}\n{back:?}");
        assert!((back.pericentre / orbit.pericentre - 1.0).abs() < 60.0 * f64::EPSILON * r, "{orbit:?}\n{back:?}");
        assert!((back.inclination - orbit.inclination).abs() < 30.0 * f64::EPSILON * r, "{orbit:?}\n{back:?}");
        seen += usize::from(e == 1.0) + usize::from(orbit.inclination == PI);
    }
    println!(
        "position and velocity: {:.1?} ulp, near the parabola {:.1?} ulp over r/q; {seen} edges",
        worst[0], worst[1]
    );
    assert!(seen > 1000);
    Ok(())
}

/// A plane orbit is one in space that stays in the plane, run either way.
#[test]
fn planes_are_kept() -> Result<(), OrbitError> {
    let law = Kepler { gm: 1.3 };
    for (e, sense) in [(0.0, 1.0), (0.4, -1.0), (1.0, 1.0), (1.7, -1.0)] {
        let start = State::new(
            [0.3, -0.7],
            [sense * 0.7, sense * 0.3].map(|v| v * ((1.0 + e) / 0.58_f64.sqrt() * 1.3 / 0.58).sqrt()),
        );
        let orbit = law.elements(&start)?;
        assert_eq!((orbit.inclination, orbit.node), (if sense > 0.0 { 0.0 } else { PI }, 0.0));
        let State { q: [x, y], .. } = orbit.in_plane(2.0)?;
        assert_eq!(orbit.at(2.0)?.q, [x, y, 0.0]);
        assert!((orbit.eccentricity - e).abs() < 1e-15 && ulps(orbit.in_plane(0.0)?.q, start.q) < 8.0);
    }
    assert!(law.elements(&State::new([1.0, 0.0], [0.0, 1.3_f64.sqrt()]))?.period().is_some());
    Ok(())
}

/// Kepler's equation against a run of high order, for every kind of conic, through the pericentre.
#[test]
fn runs_follow_their_elements() -> Result<(), Box<dyn std::error::Error>> {
    for e in [0.0, 0.3, 0.8, 1.0 - 1e-10, 1.0, 1.0 + 1e-10, 2.5] {
        let shape = Elements { gm: 1.3, pericentre: 0.8, eccentricity: e, ..Elements::default() };
        let orbit = Elements { inclination: 2.1, node: 0.4, argument: 5.0, passage: 0.7, ..shape };
        let law = Kepler3 { gm: orbit.gm };
        let run = Simulation::new(law, orbit.at(-1.5)?).scheme(Nystrom::order8()).dt(0.01).run_until(3.5)?;
        let end = orbit.at(3.5)?;
        assert!(ulps(run.last().q, end.q) < 400.0, "{e}: {} ulp", ulps(run.last().q, end.q));
        assert!(ulps(run.last().v, end.v) < 400.0, "{e}: {} ulp", ulps(run.last().v, end.v));
        let back = law.elements(run.last())?;
        // A circle has its pericentre anywhere.
        assert!(
            e == 0.0 || (back.passage - orbit.passage).abs() < 1e-11 && (back.node - orbit.node).abs() < 1e-12,
            "{back:?}"
        );
    }
    Ok(())
}

/// The period, energy and momentum of an orbit are those of its states, and with the half-axis those of the law.
#[test]
fn what_follows_from_elements() -> Result<(), OrbitError> {
    let law = Kepler { gm: 2.3 };
    for e in [0.0, 0.6, 1.0, 3.0] {
        let orbit = Elements { gm: law.gm, pericentre: 0.7, eccentricity: e, ..Elements::default() };
        let State { q: [x, y], v: [vx, vy], .. } = orbit.in_plane(0.9)?;
        assert!((law.energy([x, y]) + 0.5 * (vx * vx + vy * vy) - orbit.energy()).abs() < 4e-15);
        assert!((x * vy - y * vx - orbit.angular_momentum()).abs() < 4e-15);
        let nu = orbit.true_anomaly(0.9);
        assert!((x.hypot(y) * (1.0 + e * nu.cos()) - orbit.semi_latus_rectum()).abs() < 4e-15);
        let (mean, eccentric) = (orbit.mean_anomaly(0.9), orbit.eccentric_anomaly(0.9));
        for (found, wanted) in [
            (anomaly::mean_to_true(e, mean), nu),
            (anomaly::true_to_mean(e, nu), mean),
            (anomaly::mean_to_eccentric(e, mean), eccentric),
            (anomaly::eccentric_to_mean(e, eccentric), mean),
            (anomaly::eccentric_to_true(e, eccentric), nu),
            (anomaly::true_to_eccentric(e, nu), eccentric),
            (orbit.with_true_anomaly(0.9, nu)?.passage, 0.0),
            (orbit.with_mean_anomaly(0.9, mean).passage, 0.0),
        ] {
            assert!((found - wanted).abs() < 4e-15, "{e}: {found} {wanted}");
        }
        let kepler = if e < 1.0 {
            eccentric - e * eccentric.sin()
        } else if e == 1.0 {
            eccentric + eccentric.powi(3) / 3.0
        } else {
            e * eccentric.sinh() - eccentric
        };
        assert!((kepler - mean).abs() < 4e-15, "{e}: {kepler} {mean}");
        assert_eq!((orbit.period().is_some(), orbit.apocentre().is_some()), (e < 1.0, e < 1.0));
        if let (Some(period), Some(far)) = (orbit.period(), orbit.apocentre()) {
            assert!((period / law.period(orbit.half_axis()) - 1.0).abs() < 1e-15);
            assert!((orbit.in_plane(0.5 * period)?.q[0] + far).abs() < 4e-15);
            let turned = orbit.in_plane(0.9 + 1000.0 * period)?;
            assert!(distance(turned.q, [x, y]) < 1e-11, "{:?}", turned);
        }
    }
    Ok(())
}

/// What has no elements, and what are none, is refused with its numbers.
#[test]
fn refusals() {
    let of = |q, v| Elements::of(1.0, &State::new(q, v));
    for (q, v) in [([1.0, 2.0, 3.0], [0.1, 0.2, 0.3]), ([1.0, 0.0, 0.0], [0.0; 3]), ([0.0; 3], [1.0, 0.0, 0.0])] {
        assert!(matches!(of(q, v), Err(OrbitError::Rectilinear { .. })), "{:?}", of(q, v));
    }
    assert!(of([1.0, 0.0, 0.0], [1.0, 1e-14, 0.0]).is_ok());
    let message = of([1.0, 0.0, 0.0], [2.0, 0.0, 0.0]).unwrap_err().to_string();
    assert!(
        message.starts_with("the motion is along a line through the centre: its angular momentum is 0.0"),
        "{message}"
    );
    assert!(matches!(of([f64::NAN, 0.0, 0.0], [1.0; 3]), Err(OrbitError::NotFinite { quantity: "position", .. })));
    let positive = Elements::of(-1.0, &State::new([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])).unwrap_err();
    assert_eq!(positive.to_string(), "the strength gm must be positive, not -1.0");

    let circle = Elements::default();
    for (refused, begins) in [
        (Elements { pericentre: 0.0, ..circle }.at(0.0), "the distance of the pericentre must be positive, not 0.0"),
        (Elements { eccentricity: -0.1, ..circle }.at(0.0), "the eccentricity must not be negative: -0.1"),
        (Elements { node: f64::INFINITY, ..circle }.at(0.0), "the longitude of the node must be finite, not inf"),
        (circle.at(f64::NAN), "the time must be finite, not NaN"),
    ] {
        assert_eq!(refused.unwrap_err().to_string(), begins);
    }
    let tilted = Elements { inclination: 0.1, ..circle }.in_plane(0.0).unwrap_err();
    assert_eq!(tilted, OrbitError::Inclined { inclination: 0.1 });
    let hyperbola = Elements { eccentricity: 2.0, ..circle };
    let beyond = hyperbola.with_true_anomaly(0.0, 2.2).unwrap_err();
    assert!(matches!(beyond, OrbitError::Beyond { limit, .. } if (limit - TAU / 3.0).abs() < 1e-15), "{beyond}");
    assert!(hyperbola.with_true_anomaly(0.0, -2.09).is_ok());
    assert!(Elements { eccentricity: 1.0, ..circle }.with_true_anomaly(0.0, PI).is_err());
    assert!(Elements { eccentricity: 0.5, ..circle }.with_true_anomaly(0.0, PI).is_ok());
    assert!(anomaly::true_to_mean(2.0, 2.2).is_nan());
}

/// Energies of 1e33 J and of 1e-18 J, steps of a day and of 1e-18 s: the columns of a report stay, and no number is a row
/// of zeros.
#[test]
fn reports_in_si_read_well() -> Result<(), Box<dyn std::error::Error>> {
    let earth = Kepler { gm: GM_SUN * EARTH_MASS };
    let start = State::new([AU, 0.0], [0.0, (GM_SUN / AU).sqrt()]);
    let year = Simulation::new(earth, start).mass(EARTH_MASS).scheme(DiscreteGradient).dt(DAY).run(365)?.to_string();
    let electron = Kepler { gm: COULOMB * ELEMENTARY_CHARGE * ELEMENTARY_CHARGE };
    let start = State::new([BOHR_RADIUS, 0.0], [0.0, (electron.gm / ELECTRON_MASS / BOHR_RADIUS).sqrt()]);
    let atom = Simulation::new(electron, start).mass(ELECTRON_MASS).scheme(DiscreteGradient).dt(1e-18).run(100)?;
    assert!((atom.drift(Invariant::AngularMomentum).unwrap().start() / REDUCED_PLANCK - 1.0).abs() < 1e-9);
    let atom = atom.to_string();
    for (report, parts) in
        [(&year, ["dt = 86400, 365", " -2.64", "e33 "]), (&atom, ["dt = 1e-18, 100", " -2.179", "e-18 "])]
    {
        assert!(parts.iter().all(|part| report.contains(part)) && !report.contains("00000"), "{report}");
        let column = report.lines().find_map(|line| line.find("must be")).unwrap();
        let table: Vec<_> = report.lines().filter_map(|line| line.find("exact")).collect();
        assert_eq!(table, [column; 3], "{report}");
    }
    Ok(())
}

/// What is no ellipse has no period, and no start that a simulation takes.
#[test]
fn no_ellipse() {
    let law = Kepler { gm: 1.3 };
    let orbits = [(0.0, 0.3), (-1.0, 0.3), (f64::NAN, 0.3), (1.0, 1.0), (1.0, 1.7), (1.0, f64::NAN)];
    for (half_axis, e) in orbits {
        let start = law.pericentre(half_axis, e);
        let refused = Simulation::new(law, start).scheme(Leapfrog).dt(0.1).run(1).unwrap_err();
        assert!(matches!(refused.cause(), Error::State { .. }), "{half_axis}, {e}: {refused}");
    }
    assert!(law.period(-1.0).is_nan());
    assert!(law.period(1.0) > 0.0 && law.pericentre(1.0, 0.0).v[1].is_finite());
}
