//! Members in other numbers than `f64`: moved, kept to the last bit of every part, and gone on with.

use std::fmt::Debug;

use dmech::extend::{DoubleDouble, Exact, Flat, Lanes, Name, Rows, StoreError};
use dmech::models::pairs::{Gravity, Spring};
use dmech::prelude::*;
use rusqlite::{Connection, Row};

use crate::each::everything;
use crate::laws::{Contact, Many, Orbit, Saddle};
use crate::same::the_same;
use crate::store::{Place, goes_on_after_kills};

/// A number with as many digits as its scalar has, about x.
fn third<R: Exact>(x: f64) -> R {
    R::from_f64(x) + R::from_f64(1e-3) / R::from_f64(3.0)
}

/// The start of a member in another scalar, with digits that `f64` does not have.
fn start<L: Many<D>, R: Exact, const D: usize>(k: usize) -> State<D, R> {
    let State { t, q, v } = L::start(k);
    State::of(q.map(third), v.map(third)).at_time(t)
}

fn refused<T: Debug>(run: Result<T, Error>) -> StoreError {
    match run {
        Err(Error::Store(error)) => error,
        other => panic!("{other:?}"),
    }
}

fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|x| x.to_bits()).collect()
}

/// The macro writes a law for all scalars, so that a function over them cannot say what it needs of one.
macro_rules! in_each_scalar {
    ($check:ident) => {
        $check!(f32);
        $check!(DoubleDouble);
    };
}

#[test]
fn laws_are_kept_and_sent() {
    macro_rules! check {
        ($real:ident) => {
            let name = |of: &str| format!("{}-{of}", stringify!($real));
            let orbit = |k: usize| {
                Simulation::new(Orbit::member(k), start::<Orbit, $real, 2>(k))
                    .scheme(Leapfrog)
                    .dt(0.01)
                    .record_every(20)
                    .event(|state: &State<2, $real>| state.q[1].to_f64(), Crossing::Any)
                    .stop_when(move |state: &State<2, $real>| state.q[0].to_f64() + 0.01 * k as f64, Crossing::Falling)
            };
            let [failed, happened] = everything(&name("orbit"), 23, orbit, 3.0);
            assert!(failed == 0 && happened > 15, "{failed}, {happened}");
            let saddle = |k: usize| {
                Simulation::new(Saddle::member(k), start::<Saddle, $real, 2>(k))
                    .masses([1.0, 1.0 + 0.1 * k as f64])
                    .scheme(DiscreteGradient)
                    .dt(0.05)
                    .record_at([0.3, 0.31, 1.1, 7.0])
                    .watch("first", |state: &State<2, $real>| state.q[0].to_f64())
            };
            assert_eq!(everything(&name("saddle"), 11, saddle, 1.3), [0, 0]);
            let contact = |k: usize| {
                let law = (k % 3 != 1).then_some(Contact::member(k));
                Simulation::new(law, start::<Contact, $real, 1>(k)).scheme(Implicit).dt(0.02).record_dt(0.17)
            };
            assert_eq!(everything(&name("contact"), 10, contact, 1.0), [0, 0]);
        };
    }
    in_each_scalar!(check);
}

/// Scenes of few bodies are laws, in any scalar.
#[test]
fn small_scenes_are_kept_and_sent() {
    macro_rules! check {
        ($real:ident) => {
            let member = |k: usize| {
                let scene = Scene::<2>::new()
                    .body(1.0, [0.0, 0.0], [0.0, 0.0])
                    .body(0.01 * (k + 1) as f64, [1.0, 0.0], [0.0, 1.0])
                    .body(0.02, [0.0, 2.0], [0.7, 0.0])
                    .pairs(Gravity { g: 1.0 })
                    .bonds(Spring { k: 0.1, length: 1.0 }, [(0, 1 + k % 2)]);
                let law = scene.as_law::<3, 6>();
                let State { q, v, .. } = law.start();
                let start = State::of(q.map(third::<$real>), v.map(third::<$real>));
                Simulation::new(law, start).scheme(Nystrom::order6()).dt(0.05).record_every(10)
            };
            assert_eq!(everything(&format!("{}-scene", stringify!($real)), 12, member, 1.0), [0, 0]);
        };
    }
    in_each_scalar!(check);
}

/// Members that are refused, that begin nowhere and that fail midway.
#[test]
fn members_that_fail() {
    macro_rules! check {
        ($real:ident) => {
            let member = |k: usize| {
                let begin = match k {
                    2 => State::of([0.0, 0.0].map($real::from_f64), [0.0, 0.0].map($real::from_f64)),
                    3 => State::of([f64::NAN, 0.0].map($real::from_f64), [-0.0, f64::INFINITY].map($real::from_f64)),
                    5 => State::of([1.0, 0.0].map($real::from_f64), [0.0, 0.0].map($real::from_f64)),
                    _ => start::<Orbit, $real, 2>(k),
                };
                let dt = if k == 7 { -1.0 } else { 0.3 };
                Simulation::new(Orbit::member(k), begin).scheme(DiscreteGradient).dt(dt)
            };
            let [failed, _] = everything(&format!("{}-fail", stringify!($real)), 10, member, 6.0);
            assert!((4..8).contains(&failed), "{failed}");
        };
    }
    in_each_scalar!(check);
}

/// Numbers that are hard to keep, by their parts: −0, the smallest there are, low parts below them and of either sign, what is not finite.
trait Odd: Exact {
    fn odd() -> Vec<Self>;
}

impl Odd for f32 {
    fn odd() -> Vec<f32> {
        vec![
            0.1,
            -0.0,
            f32::from_bits(1),
            -f32::MIN_POSITIVE,
            f32::MAX,
            0.0,
            f32::NAN,
            f32::INFINITY,
            f32::NEG_INFINITY,
        ]
    }
}

impl Odd for DoubleDouble {
    fn odd() -> Vec<DoubleDouble> {
        let pairs = [(1.0, 1e-20), (-1.0, 5e-324), (1e-300, -1e-317), (f64::MAX, -1e290)];
        let mut all: Vec<_> = pairs.into_iter().map(|(hi, lo)| DoubleDouble::new(hi, lo)).collect();
        all.extend([-0.0, 5e-324, 0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(DoubleDouble::from));
        // Turned round, a number without a low part has one of −0.
        all.extend([-DoubleDouble::from(3.0), -DoubleDouble::from(0.0)]);
        assert!(all.iter().any(|x| x.lo() == 0.0 && x.lo().is_sign_negative()));
        assert!(all.iter().any(|x| x.lo().is_subnormal()));
        all
    }
}

impl Odd for Lanes {
    fn odd() -> Vec<Lanes> {
        let lanes = [0.1, -0.0, 5e-324, f64::NAN, f64::INFINITY, -1.0, f64::MAX, 0.0];
        (0..8).map(|by| Lanes::from_fn(|lane| lanes[(lane + by) % 8])).collect()
    }
}

impl Odd for Rows<2> {
    fn odd() -> Vec<Rows<2>> {
        Lanes::odd()
            .into_iter()
            .map(|lanes| Rows::from_fn(|lane| lanes.to_array()[lane % 8] * (lane + 1) as f64))
            .collect()
    }
}

/// Rests wherever it is.
#[derive(Clone, Copy)]
struct Nothing;

#[dmech::law]
impl Nothing {
    #[potential]
    fn energy(&self, _q: f64) -> f64 {
        0.0
    }
}

/// The numbers of a row from a column on, with those that stand in its bits.
fn kept(row: &Row<'_>, from: usize, count: usize) -> Vec<f64> {
    let numbers: Vec<_> = (from..from + count).map(|i| row.get::<_, Option<f64>>(i).unwrap()).collect();
    match row.get::<_, Option<Vec<u8>>>(from + count).unwrap() {
        Some(blob) => {
            let (eights, _) = blob.as_chunks();
            let all: Vec<f64> = eights.iter().map(|&eight| f64::from_le_bytes(eight)).collect();
            all[all.len() - count..].to_vec()
        }
        None => numbers.into_iter().map(Option::unwrap).collect(),
    }
}

/// Every part of every number stands in the tables, at starts, at ends and in between, also of members that are refused.
#[test]
fn every_part_is_kept() {
    macro_rules! check {
        ($real:ty, $last:literal) => {{
            let odd = <$real>::odd();
            let start =
                |k: usize| State::of([odd[k]], [if k % 2 == 0 { <$real>::ZERO } else { odd[k - 1] }]).at_time(-0.0);
            for k in 0..odd.len() {
                let flat = start(k).flat();
                assert_eq!(flat.len(), 1 + 2 * <$real>::PARTS);
                assert_eq!(bits(&State::<1, $real>::of_flat(&flat).flat()), bits(&flat), "{k}");
            }
            let place = Place::new(&format!("odd-{}", <$real>::name()));
            let member = |k: usize| Simulation::new(Nothing, start(k)).scheme(Leapfrog).dt(0.5);
            let sweep = || Ensemble::each(odd.len(), member).store(place.file()).run(0).unwrap();
            let first = sweep();
            let rows = |table: &str, of: &mut dyn FnMut(usize, Vec<f64>)| {
                let names: Vec<_> = ["q0", "v0"]
                    .into_iter()
                    .flat_map(|x| (0..<$real>::PARTS).map(move |n| x.to_owned() + &<$real>::part(n)))
                    .collect();
                let database = Connection::open(place.file()).unwrap();
                let select = format!("SELECT k, t, {}, bits FROM {table} ORDER BY k", names.join(", "));
                let mut statement = database.prepare(&select).unwrap();
                let mut rows = statement.query([]).unwrap();
                while let Some(row) = rows.next().unwrap() {
                    of(row.get::<_, i64>(0).unwrap() as usize, kept(row, 1, 1 + 2 * <$real>::PARTS));
                }
            };
            let (mut starts, mut ends, mut recorded) = (0, 0, 0);
            rows("member", &mut |k, numbers| {
                assert_eq!(bits(&numbers), bits(&start(k).flat()), "{k}");
                starts += 1;
            });
            rows("last", &mut |k, numbers| {
                let last = first.member(k).unwrap_or_else(|failed| failed.run()).last().flat();
                assert_eq!(bits(&numbers), bits(&last), "{k}");
                assert_eq!(bits(&numbers), bits(&start(k).flat()), "{k}");
                ends += 1;
            });
            rows("state", &mut |k, numbers| {
                assert_eq!(bits(&numbers), bits(&start(k).flat()), "{k}");
                recorded += 1;
            });
            assert_eq!([starts, ends], [odd.len(); 2]);
            assert!(recorded >= $last, "{recorded} of {}", odd.len());
            let again = sweep();
            assert_eq!(again.checksum(), first.checksum());
            for k in 0..odd.len() {
                let run = |of: &EnsembleRun<State<1, $real>>| of.member(k).map_or(vec![], |run| run.last().flat());
                assert_eq!(bits(&run(&again)), bits(&run(&first)));
            }
        }};
    }
    check!(f32, 5);
    check!(DoubleDouble, 8);
    check!(Lanes, 0);
    check!(Rows<2>, 0);
}

/// Several numbers side by side are numbers as well.
#[test]
fn lanes_are_kept() {
    let place = Place::new("lanes");
    let start = |k: usize| State::of([Lanes::from_fn(|lane| 1.0 + (k * 8 + lane) as f64 / 3.0)], [Lanes::ZERO]);
    let member = |k: usize| Simulation::new(Contact::member(k), start(k)).scheme(Leapfrog).dt(0.01).record_every(10);
    let plain = Ensemble::each(6, member).run(30).unwrap();
    let kept = || Ensemble::each(6, member).store(place.file()).run(30).unwrap();
    the_same(&plain, &kept());
    place.sql("DELETE FROM last WHERE k > 3; DELETE FROM drift WHERE k > 3; DELETE FROM state WHERE k > 3");
    the_same(&plain, &kept());
    assert_eq!(place.number("SELECT COUNT(*) FROM last WHERE q0_lane0 <> q0_lane7"), 6);
}

/// Two sets of results that differ in a last low part are two.
#[test]
fn checksums_depend_on_low_parts() {
    let run = |low: f64| {
        let start =
            move |k: usize| State::of([DoubleDouble::new(1.0, if k == 3 { low } else { 0.0 })], [DoubleDouble::ZERO]);
        Ensemble::each(5, move |k| Simulation::new(Nothing, start(k)).scheme(Leapfrog).dt(0.5)).run(2).unwrap()
    };
    assert_ne!(run(0.0).checksum(), run(5e-324).checksum());
    assert_ne!(run(0.0).checksum(), run(1e-17).checksum());
    assert_eq!(run(1e-17).checksum(), run(1e-17).checksum());
    // Numbers that are `f64` give what they gave.
    let plain = |k: usize| Simulation::new(Orbit::member(k), Orbit::start(k)).scheme(Leapfrog).dt(0.01);
    let law = Ensemble::of(9).law(Orbit::member).start(Orbit::start).scheme(Leapfrog).dt(0.01);
    assert_eq!(Ensemble::each(9, plain).run(20).unwrap().checksum(), law.run(20).unwrap().checksum());
}

/// A sweep of the same numbers in another scalar is another.
#[test]
fn another_scalar_is_refused() {
    macro_rules! sweep {
        ($real:ty, $place:expr) => {{
            let start = |k: usize| State::of([<$real>::from_f64(1.0 + k as f64)], [<$real>::ZERO]);
            let member = |k: usize| Simulation::new(Nothing, start(k)).scheme(Leapfrog).dt(0.5);
            Ensemble::each(3, member).store($place.file()).run(4).map(|run| run.checksum())
        }};
    }
    let names = ["f64", "f32", "DoubleDouble", "Lanes", "Rows<2>"];
    type Sweep = fn(&Place) -> Result<u64, Error>;
    let sweeps: [Sweep; 5] = [
        |place| sweep!(f64, place),
        |place| sweep!(f32, place),
        |place| sweep!(DoubleDouble, place),
        |place| sweep!(Lanes, place),
        |place| sweep!(Rows<2>, place),
    ];
    for (store, first) in names.into_iter().zip(sweeps) {
        let place = Place::new(&format!("scalar-{store}"));
        let sum = first(&place).unwrap();
        for (here, other) in names.into_iter().zip(sweeps) {
            if here == store {
                assert_eq!(other(&place), Ok(sum));
            } else {
                let refused = refused(other(&place));
                assert_eq!(refused, StoreError::Scalar { store: Name::of(&[store]), here });
                assert_eq!(
                    refused.to_string(),
                    format!("the numbers of the store are {store}, those of this ensemble {here}")
                );
            }
        }
        place.sql("UPDATE sweep SET value = 'f16' WHERE key = 'scalar'");
        let f16 = StoreError::Scalar { store: Name::of(&["f16"]), here: store };
        assert_eq!(refused(first(&place)), f16);
        place.sql("DELETE FROM sweep WHERE key = 'scalar'");
        assert_eq!(refused(first(&place)), StoreError::Setting { key: "scalar" });
    }
}

/// A law by hand whose number has 31 digits: Φ = k x²/2.
#[derive(Clone, Copy)]
struct ByHand(DoubleDouble);

impl Conservative for ByHand {}

impl Potential<1, DoubleDouble> for ByHand {
    fn potential(&self, [x]: [DoubleDouble; 1]) -> DoubleDouble {
        DoubleDouble::from(0.5) * self.0 * x * x
    }
    fn gradient(&self, [x]: [DoubleDouble; 1]) -> [DoubleDouble; 1] {
        [self.0 * x]
    }
    fn hessian(&self, _: [DoubleDouble; 1]) -> [[DoubleDouble; 1]; 1] {
        [[self.0]]
    }
    fn discrete_gradient(&self, [a]: [DoubleDouble; 1], [b]: [DoubleDouble; 1]) -> [DoubleDouble; 1] {
        [DoubleDouble::from(0.5) * self.0 * (a + b)]
    }
    fn discrete_gradient_jacobian(&self, _: [DoubleDouble; 1], _: [DoubleDouble; 1]) -> [[DoubleDouble; 1]; 1] {
        [[DoubleDouble::from(0.5) * self.0]]
    }
}

/// What differs in a low part alone: a start, what acts.
#[test]
fn another_low_part_is_refused() {
    let place = Place::new("low");
    let sweep = |low: f64, k: DoubleDouble| {
        let start = move |of: usize| {
            State::of([DoubleDouble::new(1.0, if of == 2 { low } else { 1e-18 })], [DoubleDouble::ONE])
        };
        let member = move |of: usize| Simulation::new(ByHand(k), start(of)).scheme(DiscreteGradient).dt(0.1);
        Ensemble::each(4, member).store(place.file()).run(5)
    };
    let k = DoubleDouble::new(2.0, 1e-17);
    let first = sweep(1e-18, k).unwrap();
    let start = StoreError::Member { member: 2, column: Name::of(&["q0_low"]), store: 1e-18, here: 2e-18 };
    assert_eq!(refused(sweep(2e-18, k)), start);
    assert_eq!(refused(sweep(1e-18, DoubleDouble::new(2.0, 2e-17))), StoreError::Acts { member: 0 });
    the_same(&sweep(1e-18, k).unwrap(), &first);
}

/// Numbers that somebody has changed, also so little that the scalar does not see it.
#[test]
fn damaged_parts_are_refused() {
    macro_rules! check {
        ($real:ident, [$($edit:expr),*]) => {
            let member = |k: usize| {
                Simulation::new(Orbit::member(k), start::<Orbit, $real, 2>(k))
                    .scheme(Leapfrog)
                    .dt(0.05)
                    .record_every(10)
                    .event(|state: &State<2, $real>| state.q[1].to_f64() - 0.2, Crossing::Any)
            };
            for (sql, table) in [$($edit),*] {
                let place = Place::new(&format!("edited-{}", stringify!($real)));
                let sweep = || Ensemble::each(8, member).store(place.file()).run(40);
                let first = sweep().unwrap();
                the_same(&sweep().unwrap(), &first);
                let changed = Connection::open(place.file()).unwrap().execute(&sql, []).unwrap();
                assert_eq!(changed, 1, "{sql}");
                assert_eq!(refused(sweep()), StoreError::Changed { table, member: 3 }, "{sql}");
            }
        };
    }
    let nudge = |table: &str, column: &str| {
        let of = if matches!(table, "event" | "state") { " AND n = 0" } else { "" };
        format!("UPDATE {table} SET {column} = {column} * (1 + 1e-15) WHERE k = 3{of}")
    };
    check!(
        f32,
        [
            (nudge("last", "q0"), "last"),
            (nudge("state", "v1"), "last"),
            (nudge("event", "q0"), "last"),
            (nudge("member", "q0"), "member")
        ]
    );
    check!(
        DoubleDouble,
        [
            (nudge("last", "q0_low"), "last"),
            (nudge("state", "v1_low"), "last"),
            (nudge("event", "q0_low"), "last"),
            (nudge("member", "q0_low"), "member"),
            (nudge("last", "q0"), "last"),
            ("UPDATE last SET q0_low = NULL WHERE k = 3".to_owned(), "last"),
            ("UPDATE last SET q0_low = 0 WHERE k = 3".to_owned(), "last"),
            ("UPDATE last SET v0_low = 'none' WHERE k = 3".to_owned(), "last")
        ]
    );
}

/// Killed with signal 9 and gone on with, numbers of 31 digits are the same every time.
#[cfg(unix)]
#[test]
fn digits_that_were_killed_go_on() {
    let sweep = |file: Option<std::path::PathBuf>| {
        let member = |k: usize| {
            Simulation::new(Orbit::member(k), start::<Orbit, DoubleDouble, 2>(k))
                .scheme(Leapfrog)
                .dt(0.005)
                .record_every(100)
        };
        let each = Ensemble::each(300, member).threads(2);
        match file {
            Some(file) => each.store(file).run_until(2.0),
            None => each.run_until(2.0),
        }
        .unwrap()
        .checksum()
    };
    goes_on_after_kills("scalars::digits_that_were_killed_go_on", 300, 3, sweep);
}

/// The ends of members as a table have all digits, and in one of NumPy those of `f64`.
#[test]
fn tables_have_the_digits() {
    let member =
        |k: usize| Simulation::new(Orbit::member(k), start::<Orbit, DoubleDouble, 2>(k)).scheme(Leapfrog).dt(0.01);
    let run = Ensemble::each(7, member).run(40).unwrap();
    let mut table = Vec::new();
    run.write(Csv::new(&mut table)).unwrap();
    let table = String::from_utf8(table).unwrap();
    for (k, line) in table.lines().skip(1).enumerate() {
        let State { q, v, .. } = run.last(k).unwrap();
        let read: Vec<DoubleDouble> = line.split(',').skip(2).map(|number| number.parse().unwrap()).collect();
        assert_eq!(read, [q, v].concat());
    }
    assert_eq!(table.lines().count(), 8);
}
