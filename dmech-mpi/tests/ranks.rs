//! Ranks of MPI: this program starts `mpirun` on itself.
//!
//! Where there is no `mpirun` it says so and checks nothing.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio, exit};
use std::thread::sleep;
use std::time::{Duration, Instant};

use dmech::models::Kepler;
use dmech::models::pairs::Gravity;
use dmech::prelude::*;
use dmech_mpi::World;

/// What a rank is to do.
const TASK: &str = "DMECH_TASK";
const THREADS: &str = "DMECH_THREADS";
const LANES: &str = "DMECH_LANES";
const STORE: &str = "DMECH_STORE";

const MEMBERS: usize = 20_011;

fn main() {
    match std::env::var(TASK).as_deref() {
        Ok("sweep") => sweep(20),
        Ok("long") => sweep(6000),
        Ok("scenes") => scenes(),
        Ok("panic") => panic_in_the_last(),
        Ok("other") => other(),
        _ => check(),
    }
}

fn number(name: &str) -> Option<usize> {
    std::env::var(name).ok()?.parse().ok()
}

/// Orbits of all eccentricities; some fall into the centre, and fail.
fn start(k: usize) -> State<2> {
    let e = (k % 997) as f64 / 1000.0;
    if k.is_multiple_of(1000) { State::new([0.0; 2], [0.0; 2]) } else { Kepler { gm: 1.0 }.pericentre(1.0, e) }
}

fn sweep(steps: u64) {
    let world = World::start().expect("MPI starts once");
    let mut ensemble =
        Ensemble::of(MEMBERS).law(|k| Kepler { gm: 1.0 + 1e-5 * k as f64 }).start(start).scheme(Leapfrog).dt(0.01);
    if let Some(threads) = number(THREADS) {
        ensemble = ensemble.threads(threads);
    }
    if let Some(lanes) = number(LANES) {
        ensemble = ensemble.lanes(lanes);
    }
    if let Ok(path) = std::env::var(STORE) {
        ensemble = ensemble.store(path);
    }
    match ensemble.look_every(10).ranks(&world).run(steps) {
        Ok(Some(run)) => println!("{:016x} {}", run.checksum(), run.failures().count()),
        Ok(None) => {}
        Err(error) => {
            println!("rank {}: {error}", world.rank());
            drop(world);
            exit(1);
        }
    }
}

/// Scenes of unequal numbers of bodies; some begin where nobody can.
fn scenes() {
    let world = World::start().expect("MPI starts once");
    let member = |k: usize| {
        let sun = Scene::<2>::new().body(if k % 50 == 7 { -1.0 } else { 1.0 }, [0.0; 2], [0.0; 2]);
        let planets = (1..=1 + k % 4).fold(sun, |scene, i| {
            let r = i as f64;
            scene.body(1e-3, [r, 1e-3 * k as f64], [0.0, r.sqrt().recip()])
        });
        Simulation::scene(planets.pairs(Gravity { g: 1.0 })).scheme(Leapfrog).dt(0.01).record_every(20)
    };
    let mut each = Ensemble::each(301, member);
    if let Some(threads) = number(THREADS) {
        each = each.threads(threads);
    }
    let run = match std::env::var(STORE) {
        Ok(path) => each.store(path).ranks(&world).run(100),
        Err(_) => each.ranks(&world).run(100),
    };
    if let Some(run) = run.expect("a sweep that is whole") {
        println!("{:016x} {}", run.checksum(), run.failures().count());
    }
}

fn panic_in_the_last() {
    let world = World::start().expect("MPI starts once");
    let last = world.rank() + 1 == world.count();
    let law = move |k: usize| {
        assert!(!last || k % MEMBERS < 2000 || k + 1 == MEMBERS, "a law that cannot be made");
        Kepler { gm: 1.0 }
    };
    let _ = Ensemble::of(MEMBERS).law(law).start(start).scheme(Leapfrog).dt(0.01).ranks(&world).run(100);
}

fn other() {
    let world = World::start().expect("MPI starts once");
    let members = if world.rank() == 1 { 7 } else { 8 };
    let ensemble = Ensemble::of(members).law(|_| Kepler { gm: 1.0 }).start(start).scheme(Leapfrog).dt(0.01);
    if let Err(error) = ensemble.ranks(&world).run(10) {
        println!("rank {}: {error}", world.rank());
    }
}

/// So many ranks of this program.
fn ranks(count: usize, task: &str, settings: &[(&str, &str)]) -> Command {
    let mut command = Command::new("mpirun");
    command.args(["-n", &count.to_string()]).arg(std::env::current_exe().expect("this program"));
    command.env(TASK, task).envs(settings.iter().copied());
    // More ranks than cores, each on any core, and as root: names of Open MPI, which others do not know.
    command.env("OMPI_MCA_rmaps_base_oversubscribe", "1").env("OMPI_MCA_hwloc_base_binding_policy", "none");
    command.env("PRTE_MCA_rmaps_default_mapping_policy", ":oversubscribe");
    command.env("OMPI_ALLOW_RUN_AS_ROOT", "1").env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
    command
}

/// How it ended, and what it wrote.
fn outcome(mut command: Command) -> (ExitStatus, String) {
    let output = command.output().expect("mpirun is there");
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    (output.status, text)
}

fn check() {
    let found = Command::new("mpirun").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if !found.is_ok_and(|status| status.success()) {
        println!("there is no mpirun here: nothing is checked");
        return;
    }
    one_checksum();
    one_checksum_of_scenes();
    a_panic_ends_all();
    another_ensemble_is_named();
    a_rank_that_dies();
    println!("all is well");
}

/// 1, 2 and 4 ranks × 1 and 2 threads × 1, 4 and 8 lanes, and more.
fn one_checksum() {
    let (status, alone) = outcome(ranks(1, "sweep", &[(THREADS, "1"), (LANES, "1")]));
    assert!(status.success() && alone.trim().ends_with(" 21"), "{alone}");
    for (count, threads, lanes) in [
        (1, "1", "4"),
        (1, "2", "8"),
        (2, "1", "1"),
        (2, "1", "8"),
        (2, "2", "4"),
        (4, "1", "4"),
        (4, "2", "1"),
        (4, "2", "8"),
        (7, "1", "64"),
    ] {
        let (status, text) = outcome(ranks(count, "sweep", &[(THREADS, threads), (LANES, lanes)]));
        assert!(status.success() && text == alone, "{count} ranks, {threads} threads, {lanes} lanes: {text}");
    }
    // The program without mpirun is one rank.
    let (status, text) = outcome({
        let mut command = Command::new(std::env::current_exe().expect("this program"));
        command.env(TASK, "sweep");
        command
    });
    assert!(status.success() && text == alone, "{text}");
    println!("one checksum: {}", alone.trim());
}

/// The same of simulations of any kind, and from a store.
fn one_checksum_of_scenes() {
    let (status, alone) = outcome(ranks(1, "scenes", &[(THREADS, "1")]));
    assert!(status.success() && alone.trim().ends_with(" 6"), "{alone}");
    let store = std::env::temp_dir().join(format!("dmech-mpi-scenes-{}.sqlite", std::process::id()));
    let _ = std::fs::remove_file(&store);
    let kept = (STORE, store.to_str().expect("a path"));
    for (count, threads) in [(2, "1"), (4, "2"), (3, "1")] {
        for settings in [vec![(THREADS, threads)], vec![(THREADS, threads), kept]] {
            let (status, text) = outcome(ranks(count, "scenes", &settings));
            assert!(status.success() && text == alone, "{count} ranks, {threads} threads: {text}");
        }
    }
    let _ = std::fs::remove_file(&store);
    println!("one checksum of scenes: {}", alone.trim());
}

/// Nobody waits for a rank that panics, and it is named.
fn a_panic_ends_all() {
    let (status, text) = outcome(ranks(3, "panic", &[(THREADS, "1")]));
    assert!(!status.success() && text.contains("rank 2 of 3"), "{text}");
    println!("a panic: {}", text.lines().find(|line| line.starts_with("rank 2 of 3")).unwrap_or_default());
}

fn another_ensemble_is_named() {
    let (_, text) = outcome(ranks(3, "other", &[]));
    assert!(text.contains("rank 0: rank 1 has another ensemble") && text.contains("rank 2: the first rank"), "{text}");
    println!("another ensemble: {}", text.lines().find(|line| line.starts_with("rank 0")).unwrap_or_default());
}

/// A rank that is killed: the job ends and names it, and another goes on from the store to the same results.
fn a_rank_that_dies() {
    let expected = outcome(ranks(1, "long", &[])).1;
    let directory = std::env::temp_dir().join(format!("dmech-mpi-{}", std::process::id()));
    let _ = std::fs::remove_dir_all(&directory);
    std::fs::create_dir_all(&directory).expect("a directory");
    let store = directory.join("sweep.sqlite");
    let settings = [(STORE, store.to_str().expect("a path")), (THREADS, "1")];
    let mut command = ranks(3, "long", &settings);
    let job = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("mpirun is there");
    let clock = Instant::now();
    while written(&store) < 300_000 {
        assert!(clock.elapsed() < Duration::from_secs(60), "nothing is stored");
        sleep(Duration::from_millis(5));
    }
    let killed = rank_of_this(2).expect("the last rank");
    assert!(Command::new("kill").args(["-9", &killed.to_string()]).status().is_ok_and(|status| status.success()));
    let output = job.wait_with_output().expect("the job ends");
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    assert!(!output.status.success() && text.contains("rank 2"), "{text}");
    println!("a death: {}", text.lines().find(|line| line.contains("rank 2")).unwrap_or_default());
    let stored = written(&store);
    let (status, resumed) = outcome(ranks(2, "long", &settings));
    assert!(status.success() && resumed == expected, "{resumed} for {expected}");
    println!("gone on from {stored} bytes: {}", resumed.trim());
    let _ = std::fs::remove_dir_all(&directory);
}

/// Bytes in the database and what is written ahead of it.
fn written(store: &Path) -> u64 {
    let ahead = PathBuf::from(format!("{}-wal", store.display()));
    [store, &ahead].iter().filter_map(|file| std::fs::metadata(file).ok()).map(|file| file.len()).sum()
}

/// The process of a rank that this program has started, where processes can be seen.
fn rank_of_this(rank: usize) -> Option<u32> {
    let name = format!("OMPI_COMM_WORLD_RANK={rank}");
    let this = std::env::current_exe().ok()?;
    std::fs::read_dir("/proc").ok()?.filter_map(|entry| entry.ok()?.file_name().to_str()?.parse().ok()).find(
        |process| {
            let place = PathBuf::from(format!("/proc/{process}"));
            let names = std::fs::read(place.join("environ")).unwrap_or_default();
            names.split(|&byte| byte == 0).any(|word| word == name.as_bytes())
                && std::fs::read_link(place.join("exe")).is_ok_and(|exe| exe == this)
        },
    )
}
