//! Sweeps that are kept, killed, and gone on with.

use std::fmt::Debug;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use dmech::extend::{Columns, Company, Fields, Flat, Reach, Rides, StoreError};
use dmech::models::pairs::{LennardJones, Spring};
use dmech::prelude::*;
use dmech::scene::{OnBonds, OnNear, Scene};
use dmech_tests::few::FewInBox;
use rusqlite::{Connection, OpenFlags};

use crate::laws::{Contact, Driven, Many, Orbit, Pair, Saddle};
use crate::same::{Made, of, the_same};

/// A file that is not there yet, in a directory of its own that goes with it.
pub(crate) struct Place(PathBuf);

impl Place {
    pub(crate) fn new(name: &str) -> Self {
        let directory = std::env::temp_dir().join(format!("dmech-store-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&directory);
        fs::create_dir_all(&directory).unwrap();
        Place(directory)
    }

    pub(crate) fn file(&self) -> PathBuf {
        self.0.join("sweep.sqlite")
    }

    pub(crate) fn sql(&self, sql: &str) {
        Connection::open(self.file()).unwrap().execute_batch(sql).unwrap();
    }

    pub(crate) fn number(&self, sql: &str) -> i64 {
        Connection::open(self.file()).unwrap().query_row(sql, [], |row| row.get(0)).unwrap()
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// From a store that has all, and from one that has some, in any order, comes what was computed.
#[test]
fn what_comes_back_is_what_was_computed() {
    fn check<L, S, const D: usize>(name: &str, ensemble: Made<L, S, D>)
    where
        L: Many<D> + Fields<D>,
        S: Rides<L, D> + Sync,
    {
        let place = Place::new(name);
        let plain = ensemble.clone().run_until(2.0).unwrap();
        let kept = || ensemble.clone().store(place.file()).run_until(2.0).unwrap();
        the_same(&plain, &kept());
        // Whoever moved a member again would write it.
        place.sql("CREATE TRIGGER again BEFORE INSERT ON last BEGIN SELECT RAISE(ABORT, 'moved again'); END");
        the_same(&plain, &kept());
        place.sql(
            "DELETE FROM last WHERE k % 3 = 1; DELETE FROM drift WHERE k % 3 = 1; DELETE FROM state WHERE k % 3 = 1",
        );
        if !plain.is_empty() {
            let refused = ensemble.clone().store(place.file()).run_until(2.0).unwrap_err();
            assert!(matches!(refused, Error::Store(StoreError::Sqlite { .. })), "{name}: {refused}");
        }
        place.sql("DROP TRIGGER again");
        the_same(&plain, &kept());
        assert_eq!(place.number("SELECT COUNT(*) FROM last"), plain.len() as i64);
    }
    check("leapfrog", of::<Orbit, _, 2>(83, Leapfrog).dt(0.01).look_every(7));
    check("own", of::<Saddle, _, 2>(83, DiscreteGradient).dt(0.05));
    check("recorded", of::<Driven, _, 1>(40, Nystrom::order6()).dt(0.06).record_at([0.3, 0.3, 1.1, 7.0]));
    check("adaptive", of::<Orbit, _, 2>(20, Composed::order4(DiscreteGradient)).adaptive(1e-6));
    check("rough", of::<Contact, _, 1>(20, Gauss::order16()).dt(0.2).record_dt(0.17));
    check("none", of::<Contact, _, 1>(0, Leapfrog).dt(0.2));
}

/// Time is that of the steps made now: what the store had took none.
#[test]
fn the_time_of_a_step_is_that_of_those_made_now() {
    let place = Place::new("time");
    let sweep = || Ensemble::of(50).law(Orbit::member).start(Orbit::start).scheme(Leapfrog).dt(0.01);
    let counted = |stored: u64| {
        let run = sweep().store(place.file()).run(40).unwrap();
        let (seconds, made) = (run.elapsed().as_secs_f64(), 40 * (50 - stored));
        let each = if made == 0 { 0.0 } else { 1e9 * seconds / made as f64 };
        let [members, steps] = match stored {
            0 => [String::new(), String::new()],
            _ => [format!(", {stored} from the store"), format!(", and {} steps from the store", 40 * stored)],
        };
        let expected =
            format!("50 members, 0 failed{members}\n{made} steps in {seconds:.3} s, {each:.2} ns each{steps}\n");
        assert!(run.to_string().starts_with(&expected), "{run}{expected}");
    };
    counted(0);
    counted(50);
    place.sql("DELETE FROM last WHERE k % 3 = 1; DELETE FROM drift WHERE k % 3 = 1");
    counted(33);
    let alone = sweep().run(40).unwrap().to_string();
    assert!(alone.starts_with("50 members, 0 failed\n2000 steps in "), "{alone}");
}

/// The masses of coordinates are columns of the set-up, and another is found out.
#[test]
fn masses_of_coordinates() {
    let place = Place::new("masses");
    let of = |last: f64| {
        let masses = move |k: usize| [1.0, 1.0, 2.5, if k == 7 { last } else { 0.5 + 0.1 * k as f64 }];
        let pairs = Ensemble::of(12).law(Pair::member).masses(masses).start(Pair::start).scheme(Leapfrog).dt(0.01);
        pairs.store(place.file()).run(100)
    };
    let sum = of(3.0).unwrap().checksum();
    assert_eq!(of(3.0).unwrap().checksum(), sum);
    assert_eq!(place.number("SELECT COUNT(*) FROM member WHERE law_masses_2 = 2.5 AND law_g > 1"), 12);
    let refused = of(3.5).unwrap_err();
    assert!(matches!(refused, Error::Store(StoreError::Member { member: 7, store: 3.0, here: 3.5, .. })), "{refused}");
}

/// What fails, and numbers that SQLite does not keep: NaN and −0.
#[test]
fn failures_and_odd_numbers_come_back() {
    fn start(k: usize) -> State<2> {
        match k {
            3 => State::new([0.0, 0.0], [0.0, 0.0]),
            17 => State::new([f64::NAN, 0.0], [0.0, 0.0]),
            30 => State::new([1.0, 0.0], [0.0, f64::MAX]),
            44 => State::new([1e-200, 0.0], [0.0, f64::INFINITY]),
            _ => State::new([1.0 + k as f64, -0.0], [-0.0, 5e-324]).at_time(-0.0),
        }
    }
    for (scheme, steps) in [(0, 0), (0, 40), (1, 40)] {
        let place = Place::new(&format!("odd-{scheme}-{steps}"));
        let run = |path: Option<PathBuf>| {
            let ensemble = Ensemble::of(50).law(Orbit::member).start(start).dt(0.02);
            let (leapfrog, exact) = (ensemble.clone().scheme(Leapfrog), ensemble.scheme(DiscreteGradient));
            match (path, scheme) {
                (None, 0) => leapfrog.run(steps),
                (None, _) => exact.run(steps),
                (Some(path), 0) => leapfrog.store(path).run(steps),
                (Some(path), _) => exact.store(path).run(steps),
            }
            .unwrap()
        };
        let plain = run(None);
        let failed = plain.failures().count();
        assert!((3..10).contains(&failed), "{failed}");
        for _ in 0..2 {
            the_same(&plain, &run(Some(place.file())));
        }
        assert_eq!(place.number("SELECT COUNT(*) FROM last WHERE failed IS NOT NULL"), failed as i64);
        // What stands there for people is not something else than its bits.
        place.sql("UPDATE member SET q0 = 7 WHERE k = 20");
        let ensemble = Ensemble::of(50).law(Orbit::member).start(start).dt(0.02);
        let refused = match scheme {
            0 => ensemble.scheme(Leapfrog).store(place.file()).run(steps),
            _ => ensemble.scheme(DiscreteGradient).store(place.file()).run(steps),
        };
        assert_eq!(refused.unwrap_err(), Error::Store(StoreError::Changed { table: "member", member: 20 }));
        if steps == 0 {
            assert!(plain.last(0).unwrap().q[1].is_sign_negative());
            assert!(place.number("SELECT COUNT(*) FROM last WHERE bits IS NOT NULL") > 40);
        }
    }
}

/// Members that are handed over and not kept; and what other tools find in the file.
#[test]
fn members_come_in_order_from_both() {
    let place = Place::new("order");
    let ensemble = || of::<Orbit, _, 2>(300, Leapfrog).dt(0.01).look_every(50);
    let all = ensemble().run_until(0.8).unwrap();
    for threads in [1, 2, 3] {
        let mut next = 0;
        let kept = ensemble().threads(threads).store(place.file());
        kept.for_each_until(0.8, |k, member| {
            assert_eq!((k, member.unwrap().last()), (next, &all.last(k).unwrap()));
            next += 1;
        })
        .unwrap();
        assert_eq!(next, 300);
        place.sql("DELETE FROM last WHERE k % 7 < 3; DELETE FROM drift WHERE k % 7 < 3");
    }
    let database = Connection::open(place.file()).unwrap();
    let select = "SELECT law_gm, member.q0, last.v1, max_relative FROM member JOIN last USING (k) JOIN drift USING (k)
        WHERE k = 4 AND invariant = 'energy'";
    let found: [f64; 4] =
        database.query_row(select, [], |row| Ok([row.get(0)?, row.get(1)?, row.get(2)?, row.get(3)?])).unwrap();
    let energy = all.drift(4, Invariant::Energy).unwrap().max_relative();
    assert_eq!(found, [Orbit::member(4).gm, Orbit::start(4).q[0], all.last(4).unwrap().v[1], energy]);
    let sum: String =
        database.query_row("SELECT value FROM sweep WHERE key = 'checksum'", [], |row| row.get(0)).unwrap();
    assert_eq!(sum, format!("{:016x}", all.checksum()));
}

/// What a sweep is refused with that is not that of the store.
#[test]
fn another_sweep_is_refused_with_what_differs() {
    type Other = Ensemble<fn(usize) -> Orbit, fn(usize) -> State<2>, Implicit>;
    let place = Place::new("another");
    let made = |members| of::<Orbit, _, 2>(members, Implicit).dt(0.05).look_every(5);
    let original = made(20).store(place.file()).run_until(1.0).unwrap();
    let refused = |ensemble: Other| ensemble.store(place.file()).run_until(1.0).unwrap_err();
    let store = |error: Result<EnsembleRun<State<2>>, Error>| match error.unwrap_err() {
        Error::Store(error) => error,
        error => panic!("{error}"),
    };
    let (until, steps) = (Reach::Until(1.0), Reach::Steps(7));
    let name = |text: &str| dmech::extend::Name::of(&[text]);
    let orbit = |error: StoreError| Error::Store(error);
    assert_eq!(refused(made(21)), orbit(StoreError::Members { store: 20, here: 21 }));
    assert_eq!(refused(made(20).dt(0.06)), orbit(StoreError::TimeStep { store: 0.05, here: 0.06 }));
    let looks = |here| orbit(StoreError::Looks { store: name("after every 5 steps"), here });
    assert_eq!(refused(made(20).look_every(6)), looks("after every 6 steps"));
    let in_time = refused(made(20).record_dt(10.0));
    assert_eq!(in_time, looks("every 10.0 of time"));
    let told =
        "states are recorded, or looked at, after every 5 steps in the store, every 10.0 of time in this ensemble";
    assert!(in_time.to_string().ends_with(told), "{in_time}");
    let by_time = refused(made(20).record_at([0.5]));
    assert_eq!(by_time, looks("at t = [0.5]"));
    let file = || place.file();
    assert_eq!(store(made(20).store(file()).run(7)), StoreError::Reach { store: until, here: steps });
    let later = store(made(20).store(file()).run_until(2.0));
    assert_eq!(later, StoreError::Reach { store: until, here: Reach::Until(2.0) });
    let scheme = store(made(20).scheme(DiscreteGradient).store(file()).run_until(1.0));
    assert_eq!(scheme, StoreError::Scheme { store: name("Implicit"), here: "DiscreteGradient" });
    let nudged =
        store(made(20).scheme(Leapfrog).scheme(Implicit).mass(|k| [1.0, 2.0][k / 12]).store(file()).run_until(1.0));
    assert_eq!(nudged, StoreError::Member { member: 12, column: name("mass"), store: 1.0, here: 2.0 });
    let law = |k: usize| Orbit { gm: if k == 7 { 1.5 } else { Orbit::member(k).gm } };
    let field = store(made(20).law(law).store(file()).run_until(1.0));
    let gm = Orbit::member(7).gm;
    assert_eq!(field, StoreError::Member { member: 7, column: name("law_gm"), store: gm, here: 1.5 });
    let start = |k: usize| {
        let mut start = Orbit::start(k);
        start.v[1] = if k == 19 { start.v[1].next_up() } else { start.v[1] };
        start
    };
    let v1 = Orbit::start(19).v[1];
    let start = store(made(20).start(start).store(file()).run_until(1.0));
    assert_eq!(start, StoreError::Member { member: 19, column: name("v1"), store: v1, here: v1.next_up() });
    // Laws of other fields, of the same field, and of the same field and name of it under which something else acts.
    let fields = store(made(20).law(Saddle::member).store(file()).run_until(1.0));
    assert_eq!(fields, StoreError::Law { what: "fields", store: name("law_gm"), here: "law_l, law_lambda" });
    let steeper = store(made(20).law(|k| Steeper { gm: Orbit::member(k).gm }).store(file()).run_until(1.0));
    assert_eq!(steeper, StoreError::Acts { member: 0 });
    let line = of::<Driven, _, 1>(20, Implicit).dt(0.05).look_every(5).store(file()).run_until(1.0).unwrap_err();
    assert_eq!(line, orbit(StoreError::Dimension { store: 2, here: 1 }));
    for error in [fields, steeper, start, scheme, later] {
        println!("{}", Error::Store(error));
    }
    let watched = made(20).with(|_, member| member.watch("first", |state: &State<2>| state.q[0])).store(file());
    let (none, one) = (name("0 events and 0 watched quantities"), "0 events and 1 watched quantities");
    assert_eq!(store(watched.run_until(1.0)), StoreError::Company { store: none, here: one });
    // None of them has touched it.
    place.sql("CREATE TRIGGER again BEFORE INSERT ON last BEGIN SELECT RAISE(ABORT, 'moved again'); END");
    the_same(&made(20).store(file()).run_until(1.0).unwrap(), &original);

    let place = Place::new("tolerance");
    let adaptive = |tolerance| of::<Orbit, _, 2>(5, Implicit).adaptive(tolerance).store(place.file()).run_until(0.2);
    adaptive(1e-5).unwrap();
    assert_eq!(store(adaptive(1e-6)), StoreError::Tolerance { store: 1e-5, here: 1e-6 });
}

/// What differs between two small scenes is told by its name.
#[test]
fn the_numbers_of_a_small_scene_have_names() {
    let place = Place::new("few");
    let molecule = |mass, strength, list: &[(usize, usize)], cutoff, length| {
        Scene::<2>::new()
            .body(mass, [0.1, 0.2], [0.3, 0.1])
            .body(1.5, [1.2, 0.3], [-0.1, 0.4])
            .body(0.7, [0.4, 1.3], [0.0, 0.0])
            .bonds(Spring { k: strength, length: 1.0 }, list.iter().copied())
            .pairs(LennardJones { epsilon: 0.2, sigma: 0.9 })
            .cutoff(cutoff)
            .periodic([3.5, length])
    };
    let swept = |member: &(dyn Fn(usize) -> FewInBox<OfMolecule, (), 2, 3, 6> + Sync)| {
        let ensemble = Ensemble::of(4).law(member).start(|k| member(k).start()).scheme(Leapfrog).dt(0.01);
        ensemble.store(place.file()).run(20)
    };
    let all = [(0, 1), (1, 2)];
    swept(&|_| molecule(1.0, 30.0, &all, 1.6, 4.0).as_law()).unwrap();
    let cases: [(&dyn Fn() -> FewInBox<OfMolecule, (), 2, 3, 6>, _, _, _); 6] = [
        (&|| molecule(1.25, 30.0, &all, 1.6, 4.0).as_law(), "law_mass_0", 1.0, 1.25),
        (&|| molecule(1.0, 30.0, &all, 1.6, 4.0).pin(2).as_law(), "law_inertia_2", 0.7, f64::INFINITY),
        (&|| molecule(1.0, 31.0, &all, 1.6, 4.0).as_law(), "law_k", 30.0, 31.0),
        (&|| molecule(1.0, 30.0, &[(0, 1)], 1.6, 4.0).as_law(), "law_bonds_1", 4.0, 0.0),
        (&|| molecule(1.0, 30.0, &all, 1.5, 4.0).as_law(), "law_cutoff", 1.6, 1.5),
        (&|| molecule(1.0, 30.0, &all, 1.6, 4.5).as_law(), "law_box_1", 4.0, 4.5),
    ];
    for (other, column, store, here) in cases {
        let column = dmech::extend::Name::of(&[column]);
        // In one member of several.
        let plain = || molecule(1.0, 30.0, &all, 1.6, 4.0).as_law();
        let both = (other(), plain());
        let refused = swept(&|k| if k == 2 { both.0 } else { both.1 });
        assert_eq!(refused.unwrap_err(), Error::Store(StoreError::Member { member: 2, column, store, here }));
    }
}

/// Two who are too far apart for their law to tell: simulations each by itself, and steppers, know its numbers too.
#[test]
fn a_small_scene_by_itself_tells_its_numbers() {
    let law = |cutoff: f64, length: f64| {
        let scene = Scene::<2>::new().body(1.0, [0.0, 0.0], [0.4, 0.0]).body(1.5, [3.0, 0.3], [-0.4, 0.0]);
        let scene = scene.pairs(LennardJones { epsilon: 0.2, sigma: 0.9 }).cutoff(cutoff).periodic([20.0, length]);
        scene.as_law::<2, 4>()
    };
    let start = law(1.6, 20.0).start();
    let two = |cutoff: f64, length: f64| {
        Simulation::new(law(cutoff, length), start).scheme(Leapfrog).dt(0.01).record_every(100)
    };
    let perhaps =
        |cutoff: f64, length: f64| Simulation::new(Some(law(cutoff, length)), start).scheme(Leapfrog).dt(0.01);
    let place = Place::new("few-each");
    let each = |cutoff, length| Ensemble::each(3, |_| two(cutoff, length)).store(place.file()).run_until(4.0);
    let mut stepper = two(1.6, 20.0).stepper().unwrap();
    stepper.advance(10).unwrap();
    let saved = stepper.checkpoint();
    let perhaps_saved = perhaps(1.6, 20.0).stepper().unwrap().checkpoint();
    let kept = each(1.6, 20.0).unwrap();
    for (cutoff, length, column, store, here) in [(1.2, 20.0, "cutoff", 1.6, 1.2), (1.6, 10.0, "box", 20.0, 10.0)] {
        let column = dmech::extend::Name::of(&[column]);
        let refused = each(cutoff, length).unwrap_err();
        assert_eq!(refused, Error::Store(StoreError::Member { member: 0, column, store, here }));
        assert!(matches!(two(cutoff, length).resume(&saved), Err(Error::Checkpoint(_))));
        assert!(matches!(perhaps(cutoff, length).resume(&perhaps_saved), Err(Error::Checkpoint(_))));
    }
    the_same(&each(1.6, 20.0).unwrap(), &kept);
    let resumed = two(1.6, 20.0).resume(&saved).unwrap();
    assert_eq!(resumed.state(), stepper.state());
}

type OfMolecule = (((), OnBonds<Spring>), OnNear<LennardJones>);

/// As [`Orbit`], but for the power.
#[derive(Clone, Copy)]
struct Steeper {
    gm: f64,
}

#[dmech::law]
impl Steeper {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / (q[0] * q[0] + q[1] * q[1])
    }
}

/// Files that are no store, or no longer: refused, or as they were where nothing was lost. Never anything else.
#[test]
fn damaged_files_are_refused() {
    let place = Place::new("damaged");
    let sweep = || of::<Saddle, _, 2>(300, Leapfrog).dt(0.05).record_dt(0.5).threads(1);
    let whole = sweep().store(place.file()).run_until(1.0).unwrap();
    let bytes = fs::read(place.file()).unwrap();
    let with = |bytes: &[u8]| {
        for end in ["-wal", "-shm"] {
            let _ = fs::remove_file(place.file().with_extension(format!("sqlite{end}")));
        }
        fs::write(place.file(), bytes).unwrap();
        sweep().store(place.file()).run_until(1.0)
    };
    let text = "q,v\n1,2\n".repeat(1000);
    for length in [5, 9, 700, text.len()] {
        let refused = with(&text.as_bytes()[..length]).unwrap_err();
        assert_eq!(refused, Error::Store(StoreError::NotADatabase), "{length}");
        assert_eq!(fs::read(place.file()).unwrap(), &text.as_bytes()[..length]);
    }
    // As it was where what is missing was nothing but zeros.
    let refused = |bytes: &[u8], what: String| match with(bytes) {
        Ok(run) => {
            the_same(&run, &whole);
            false
        }
        Err(Error::Store(_)) => true,
        Err(error) => panic!("{what}: {error}"),
    };
    for length in [50, 100, 4096, bytes.len() / 3, bytes.len() / 2, bytes.len() - 4096] {
        assert!(refused(&bytes[..length], format!("{length} bytes")), "{length} of {} bytes", bytes.len());
    }
    refused(&bytes[..bytes.len() - 1], "a byte less".to_owned());
    let places: Vec<usize> = (0..100).chain((100..bytes.len()).step_by(613)).collect();
    let found = places.iter().filter(|&&at| {
        let mut flipped = bytes.clone();
        flipped[at] ^= 0xff;
        refused(&flipped, format!("byte {at}"))
    });
    let found = found.count();
    println!("{found} of {} flipped bytes refused, of {}", places.len(), bytes.len());
    assert!(found > places.len() / 3, "{found} of {}", places.len());
    // A number that somebody has corrected, a member that was taken away, another database.
    type Edit = (&'static str, StoreError);
    let edits: [Edit; 10] = [
        ("UPDATE last SET q0 = 0.5 WHERE k = 31", StoreError::Changed { table: "last", member: 31 }),
        ("UPDATE drift SET max_abs = 0 WHERE k = 8", StoreError::Changed { table: "drift", member: 8 }),
        ("UPDATE drift SET mean_t = 0 WHERE k = 8", StoreError::Changed { table: "last", member: 8 }),
        ("DELETE FROM state WHERE k = 4 AND n = 1", StoreError::Changed { table: "last", member: 4 }),
        ("UPDATE member SET law_l = 1 WHERE k = 5", StoreError::Changed { table: "member", member: 5 }),
        ("UPDATE last SET failed = 'so it did' WHERE k = 7", StoreError::Changed { table: "last", member: 7 }),
        ("DELETE FROM sweep WHERE key = 'dt'", StoreError::Setting { key: "dt" }),
        ("DELETE FROM sweep WHERE key = 'scalar'", StoreError::Setting { key: "scalar" }),
        ("DROP TABLE last", StoreError::NotAnEnsemble),
        ("ALTER TABLE drift RENAME COLUMN mean_t TO mean", StoreError::Missing { table: "drift" }),
    ];
    for (sql, expected) in edits {
        with(&bytes).unwrap();
        place.sql(sql);
        assert_eq!(sweep().store(place.file()).run_until(1.0).unwrap_err(), Error::Store(expected), "{sql}");
    }
    let elsewhere = place.0.join("nowhere").join("sweep.sqlite");
    let refused = sweep().store(elsewhere).run_until(1.0).unwrap_err();
    assert_eq!(refused, Error::Store(StoreError::NoFolder));
    let refused = sweep().store(&place.0).run_until(1.0).unwrap_err();
    assert_eq!(refused, Error::Store(StoreError::Folder));
}

/// A member that failed has not done so to the end: nobody makes it by leaving out why.
#[test]
fn what_failed_stays_failed() {
    let place = Place::new("failed");
    let start = |k: usize| State::new([1.0, 0.0], [0.0, if k == 2 { 0.0 } else { 1.0 }]);
    let sweep = || Ensemble::of(5).law(Orbit::member).start(start).scheme(DiscreteGradient).dt(0.3);
    let whole = sweep().run(8).unwrap();
    assert_eq!(whole.failures().count(), 1);
    the_same(&whole, &sweep().store(place.file()).run(8).unwrap());
    the_same(&whole, &sweep().store(place.file()).run(8).unwrap());
    place.sql("UPDATE last SET failed = NULL WHERE k = 2");
    let refused = sweep().store(place.file()).run(8).unwrap_err();
    assert_eq!(refused, Error::Store(StoreError::Changed { table: "last", member: 2 }));
}

/// A weight above a floor.
#[derive(Clone, Copy, Debug)]
struct Weight {
    g: f64,
}

#[dmech::law]
impl Weight {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        self.g * q
    }
}

/// What is moved again is written anew, with nothing left of the run that failed: it may have had more events and more states.
#[test]
fn nothing_is_left_of_what_failed() {
    const WEIGHT: Weight = Weight { g: 1.0 };
    const END: f64 = 8.0;
    fn check<X: Clone + Columns + Debug + Flat>(
        place: &Place,
        moved: impl Fn(f64, Option<PathBuf>) -> Result<EnsembleRun<X>, Error>,
    ) {
        let kept = |e| moved(e, Some(place.file())).unwrap();
        assert_eq!(kept(0.5).failures().count(), 4);
        let events = || place.number("SELECT COUNT(*) FROM event");
        let lossy = events();
        // What happens at a bounce is no number, and not known to the store.
        let plain = moved(0.9, None).unwrap();
        the_same(&plain, &kept(0.9));
        assert!(lossy > 4 * 20 && events() < 4 * 5, "{lossy}, {}", events());
        the_same(&plain, &kept(0.9));
        // From where a motion went on is as sealed as where it was.
        let (table, of) = if X::LISTED { ("body", "what = 'change' AND body = 1 AND") } else { ("change", "") };
        let scaled = |by: f64| format!("UPDATE {table} SET v0 = {by:?} * v0 WHERE {of} k = 1 AND n = 0;");
        let lost = "DELETE FROM change WHERE k = 2 AND n = 0;";
        for (sql, member) in [(scaled(2.0), 1), (scaled(0.5) + lost, 2)] {
            place.sql(&sql);
            match moved(0.9, Some(place.file())) {
                Err(Error::Store(StoreError::Changed { member: told, .. })) => assert_eq!(told, member, "{sql}"),
                other => panic!("{sql}: {:?}", other.err()),
            }
        }
    }
    let start = |k: usize| State::new([1.0 + 0.1 * k as f64], [0.0]);
    let falling = || Ensemble::of(4).law(|_| WEIGHT).start(start).scheme(Leapfrog).dt(0.01);
    let balls = move |e: f64| {
        falling().with(move |_, ball: Company<State<1>>| ball.bounce_off(|s| s.q[0], move |s| s.v[0] *= -e))
    };
    check(&Place::new("again"), |e, file| match file {
        Some(file) => balls(e).store(file).run_until(END),
        None => balls(e).run_until(END),
    });
    let ball = move |k: usize, e: f64| {
        let floor = Scene::<1>::new().body(1.0, [-0.5], [0.0]).pin(0).body(1.0, start(k).q, [0.0]).field(WEIGHT);
        Simulation::scene(floor).scheme(Leapfrog).dt(0.01).collide_at(0.5, move |s, [_, b]| s.v[b][0] *= -e)
    };
    check(&Place::new("again-each"), |e, file| match file {
        Some(file) => Ensemble::each(4, move |k| ball(k, e)).store(file).run_until(END),
        None => Ensemble::each(4, move |k| ball(k, e)).run_until(END),
    });
}

/// A name that SQLite would take for a URI, for memory or for a file that goes is that of a file.
#[test]
fn every_name_is_a_path() {
    let place = Place::new("names");
    let sweep = |name: &std::path::Path| of::<Orbit, _, 2>(3, Leapfrog).dt(0.05).store(name).run(3);
    // Relative to where the tests run, so that nothing stands before the name.
    let here = std::env::current_dir().unwrap();
    for (n, name) in ["file:", ":memory:", "file::memory:", "file:store?mode=memory"].into_iter().enumerate() {
        let name = format!("{name}-dmech-{}-{n}.sqlite", std::process::id());
        let sum = sweep(name.as_ref()).unwrap().checksum();
        let is_there = here.join(&name).metadata().is_ok_and(|file| file.is_file());
        let again = sweep(name.as_ref()).unwrap().checksum();
        let _ = ["", "-wal", "-shm"].map(|end| fs::remove_file(here.join(format!("{name}{end}"))));
        assert!(is_there && again == sum, "{name}");
    }
    assert_eq!(sweep("".as_ref()).unwrap_err(), Error::Store(StoreError::NoPath));
    assert!(sweep(&place.file()).is_ok());
}

/// Two that begin a store at once have the same results, and it has them once.
#[test]
fn two_begin_a_store_at_once() {
    for n in 0..20 {
        let place = Place::new(&format!("two-{n}"));
        let sweep = || of::<Orbit, _, 2>(60, Leapfrog).dt(0.05).threads(1).store(place.file()).run(20);
        let (one, other) = std::thread::scope(|scope| {
            let one = scope.spawn(sweep);
            let other = sweep();
            (one.join(), other)
        });
        let plain = of::<Orbit, _, 2>(60, Leapfrog).dt(0.05).run(20).unwrap();
        for run in [one.unwrap(), other] {
            the_same(&plain, &run.unwrap());
        }
        assert_eq!(place.number("SELECT COUNT(*) FROM last"), 60);
    }
}

/// So have processes, which wait for one another to make the file.
#[cfg(unix)]
#[test]
fn processes_that_begin_a_store_at_once() {
    let sweep = || of::<Orbit, _, 2>(60, Leapfrog).dt(0.05).threads(1);
    let at_once = |file: &Path| file.with_extension("begin");
    if let Some(file) = std::env::var_os(CHILD).map(PathBuf::from) {
        let began = Instant::now();
        while !at_once(&file).exists() {
            assert!(began.elapsed() < Duration::from_secs(60), "nobody says when to begin");
        }
        sweep().store(file).run(20).unwrap();
        return;
    }
    let plain = sweep().run(20).unwrap();
    for n in 0..30 {
        let place = Place::new(&format!("processes-{n}"));
        let begin = || child("store::processes_that_begin_a_store_at_once", &place.file(), "").spawn().unwrap();
        let processes = [(); 4].map(|()| begin());
        std::thread::sleep(Duration::from_millis(30));
        fs::write(at_once(&place.file()), "").unwrap();
        for mut process in processes {
            assert!(process.wait().unwrap().success(), "of the four in place {n}");
        }
        the_same(&plain, &sweep().store(place.file()).run(20).unwrap());
    }
}

/// The sweep that is killed, a part of a second long.
fn killed(members: usize) -> Made<Orbit, Leapfrog, 2> {
    of::<Orbit, _, 2>(members, Leapfrog).dt(0.002).look_every(100).threads(2)
}

/// Where a process of this test is the one to be killed.
const CHILD: &str = "DMECH_STORE_OF_A_CHILD";

/// This test once more, in a process of its own that writes to a file; `shell` may limit it.
fn child(test: &str, file: &Path, shell: &str) -> Command {
    let program = std::env::current_exe().unwrap();
    let mut command = Command::new("sh");
    command.args(["-c", &format!("{shell} exec \"$0\" \"$@\"")]).arg(program);
    command.args([test, "--exact", "--nocapture"]).env(CHILD, file).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// Killed with signal 9, once or twice, until it was so many times that some members were stored and others not; gone on with, it is
/// the same every time. A sweep writes to a file, if one is given, and says its checksum.
#[cfg(unix)]
pub(crate) fn goes_on_after_kills(test: &str, members: i32, times: usize, sweep: impl Fn(Option<PathBuf>) -> u64) {
    if let Some(file) = std::env::var_os(CHILD) {
        sweep(Some(file.into()));
        return;
    }
    let place = Place::new(&test.replace("::", "-"));
    let clear = || {
        for end in ["", "-wal", "-shm"] {
            let _ = fs::remove_file(place.file().with_extension(format!("sqlite{end}")));
        }
    };
    let plain = sweep(None);
    let clock = Instant::now();
    assert!(child(test, &place.file(), "").status().unwrap().success());
    let whole = clock.elapsed();
    assert_eq!(place.number("SELECT COUNT(*) FROM last"), members.into());
    // It need not have come to make the file, or the table, and may just be at it.
    let there = |flags| -> i32 {
        let file = Connection::open_with_flags(place.file(), flags);
        let count = file.and_then(|file| file.query_row("SELECT COUNT(*) FROM last", [], |row| row.get(0)));
        count.unwrap_or(0)
    };
    let (mut kills, mut partly) = (0_u32, Vec::new());
    while partly.len() < times && kills < 60 {
        clear();
        let mut stored = 0_i32;
        for again in 0..=u32::from(kills % 4 == 3) {
            let moment = (0.618 * f64::from(kills) + 0.2 * f64::from(again)).fract();
            let mut running = child(test, &place.file(), "").spawn().unwrap();
            let began = Instant::now();
            if kills % 3 == 0 {
                // By the clock: before there is a table, too.
                std::thread::sleep(whole.mul_f64(0.5 * moment));
            } else {
                // By what is stored: how long the process takes depends on what else the machine does.
                let wanted = stored + (moment * f64::from(members - 1 - stored)) as i32;
                while there(OpenFlags::SQLITE_OPEN_READ_ONLY) <= wanted && running.try_wait().unwrap().is_none() {
                    std::thread::sleep(Duration::from_millis(1));
                    assert!(began.elapsed() < 20 * whole + Duration::from_secs(60), "it does not end");
                }
            }
            running.kill().unwrap();
            running.wait().unwrap();
            let count = there(OpenFlags::default());
            assert!(count >= stored, "{count} members where {stored} were");
            stored = count;
        }
        kills += 1;
        if stored > 0 && stored < members {
            partly.push(stored);
        }
        assert_eq!(sweep(Some(place.file())), plain, "killed with {stored} members stored");
    }
    println!("{kills} kills, with so many members stored: {partly:?}; the whole takes {whole:.2?}");
    assert_eq!(partly.len(), times, "{partly:?}");
}

#[cfg(unix)]
#[test]
fn a_sweep_that_was_killed_goes_on() {
    let plain = std::cell::OnceCell::new();
    goes_on_after_kills("store::a_sweep_that_was_killed_goes_on", 2000, 10, |file| match file {
        Some(file) => {
            let run = killed(2000).store(file).run_until(2.0).unwrap();
            plain.get().inspect(|plain| the_same(&run, plain));
            run.checksum()
        }
        None => plain.get_or_init(|| killed(2000).run_until(2.0).unwrap()).checksum(),
    });
}

/// No room: an error, and what was written before is gone on from when there is.
#[cfg(unix)]
#[test]
fn a_file_that_cannot_grow_loses_nothing() {
    const END: f64 = 0.5;
    if let Some(file) = std::env::var_os(CHILD) {
        let refused = killed(4000).store(file).run_until(END).unwrap_err();
        assert!(matches!(refused, Error::Store(StoreError::Sqlite { .. } | StoreError::Full)), "{refused}");
        return;
    }
    let place = Place::new("full");
    let test = "store::a_file_that_cannot_grow_loses_nothing";
    // In blocks of 512 or 1024 bytes, as the shell has it.
    let limited = child(test, &place.file(), "ulimit -f 1500; trap '' XFSZ;").status().unwrap();
    assert!(limited.success());
    let stored = place.number("SELECT COUNT(*) FROM last");
    assert!(stored > 0 && stored < 4000, "{stored}");
    the_same(&killed(4000).store(place.file()).run_until(END).unwrap(), &killed(4000).run_until(END).unwrap());
}
