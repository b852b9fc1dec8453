//! Sweeps that are kept, killed, and gone on with.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use dmech::extend::{Fields, Reach, Rides, StoreError};
use dmech::prelude::*;
use rusqlite::Connection;

use crate::laws::{Contact, Driven, Many, Orbit, Saddle};

/// A file that is not there yet, in a directory of its own that goes with it.
struct Place(PathBuf);

impl Place {
    fn new(name: &str) -> Self {
        let directory = std::env::temp_dir().join(format!("dmech-store-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&directory);
        fs::create_dir_all(&directory).unwrap();
        Place(directory)
    }

    fn file(&self) -> PathBuf {
        self.0.join("sweep.sqlite")
    }

    fn sql(&self, sql: &str) {
        Connection::open(self.file()).unwrap().execute_batch(sql).unwrap();
    }

    fn number(&self, sql: &str) -> i64 {
        Connection::open(self.file()).unwrap().query_row(sql, [], |row| row.get(0)).unwrap()
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// All that can be seen of two sets of results.
fn the_same<const D: usize>(a: &EnsembleRun<State<D>>, b: &EnsembleRun<State<D>>) {
    assert_eq!((a.checksum(), a.len()), (b.checksum(), b.len()));
    for k in 0..a.len() {
        let [one, other] = [a, b].map(|run| match run.member(k) {
            Ok(run) => (None, run),
            Err(failed) => (Some(format!("{:?}", failed.cause())), failed.run()),
        });
        assert_eq!(one.0, other.0, "{k}");
        let (one, other) = (one.1, other.1);
        // As text, where NaN is NaN and −0 is not 0.
        let text = |run: &Run<State<D>>| format!("{:?} {:?} {:?}", run.last(), run.states(), run.steps());
        assert_eq!(text(one), text(other), "{k}");
        let report = |run: &Run<State<D>>| {
            let report = run.report();
            let drifts: Vec<_> = Invariant::ALL.iter().map(|&of| (report.drift(of), report.kept(of))).collect();
            let own: Vec<_> = report.own_drifts().collect();
            let cost = (report.evaluations(), report.iterations(), report.rough(), report.dt_range());
            format!(
                "{drifts:?} {own:?} {cost:?} {} {} {:?} {}",
                report.scheme(),
                report.dt(),
                report.tolerance(),
                report.mass()
            )
        };
        assert_eq!(report(one), report(other), "{k}");
    }
}

type Made<L, S, const D: usize> = Ensemble<fn(usize) -> L, fn(usize) -> State<D>, S>;

fn of<L: Many<D> + Fields<D>, S: Rides<L, D> + Sync, const D: usize>(members: usize, scheme: S) -> Made<L, S, D> {
    let (law, start): (fn(usize) -> L, fn(usize) -> State<D>) = (L::member, L::start);
    Ensemble::of(members).law(law).start(start).scheme(scheme)
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

/// The sweep that is killed, a part of a second long.
fn killed() -> Made<Orbit, Leapfrog, 2> {
    of::<Orbit, _, 2>(4000, Leapfrog).dt(0.002).look_every(100).threads(2)
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

/// Killed with signal 9 at ten moments and more, once or twice, and gone on with: the same every time.
#[cfg(unix)]
#[test]
fn a_sweep_that_was_killed_goes_on() {
    const END: f64 = 5.0;
    if let Some(file) = std::env::var_os(CHILD) {
        killed().store(file).run_until(END).unwrap();
        return;
    }
    let test = "store::a_sweep_that_was_killed_goes_on";
    let place = Place::new("killed");
    let clear = || {
        for end in ["", "-wal", "-shm"] {
            let _ = fs::remove_file(place.file().with_extension(format!("sqlite{end}")));
        }
    };
    let plain = killed().run_until(END).unwrap();
    let clock = Instant::now();
    assert!(child(test, &place.file(), "").status().unwrap().success());
    let whole = clock.elapsed();
    assert_eq!(place.number("SELECT COUNT(*) FROM last"), 4000);
    let (mut kills, mut partly) = (0_u32, Vec::new());
    while kills < 10 || (partly.len() < 5 && kills < 40) {
        clear();
        let mut stored = 0;
        for again in 0..=kills % 2 {
            let moment = (0.13 + 0.618 * f64::from(kills) + 0.2 * f64::from(again)).fract();
            let mut running = child(test, &place.file(), "").spawn().unwrap();
            std::thread::sleep(whole.mul_f64(moment).max(Duration::from_millis(1)));
            running.kill().unwrap();
            running.wait().unwrap();
            // It need not have come to make the table.
            let count = Connection::open(place.file()).unwrap();
            let count = count.query_row("SELECT COUNT(*) FROM last", [], |row| row.get(0)).unwrap_or(0);
            assert!(count >= stored, "{count} members where {stored} were");
            stored = count;
        }
        kills += 1;
        if stored > 0 && stored < 4000 {
            partly.push(stored);
        }
        let resumed = killed().store(place.file()).run_until(END).unwrap();
        assert_eq!(resumed.checksum(), plain.checksum(), "killed with {stored} members stored");
        the_same(&resumed, &plain);
    }
    println!("{kills} kills, with so many members stored: {partly:?}; the whole takes {whole:.2?}");
    assert!(partly.len() >= 5, "{partly:?}");
}

/// No room: an error, and what was written before is gone on from when there is.
#[cfg(unix)]
#[test]
fn a_file_that_cannot_grow_loses_nothing() {
    const END: f64 = 0.5;
    if let Some(file) = std::env::var_os(CHILD) {
        let refused = killed().store(file).run_until(END).unwrap_err();
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
    the_same(&killed().store(place.file()).run_until(END).unwrap(), &killed().run_until(END).unwrap());
}
