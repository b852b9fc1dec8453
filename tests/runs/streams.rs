//! Recorded states that are written as they come.

use std::io::{self, Cursor, Write};

use dmech::models::Kepler;
use dmech::models::pairs::Gravity;
use dmech::prelude::*;

fn planet() -> Simulation<Kepler, State<2>, Leapfrog> {
    let law = Kepler { gm: 1.3 };
    Simulation::new(law, law.pericentre(1.0, 0.3)).scheme(Leapfrog).dt(0.01)
}

#[test]
fn a_stream_has_what_a_table_has() {
    let mut streamed = Vec::new();
    let run = planet().record_every(3).stream(Csv::new(&mut streamed)).run(100).unwrap();
    assert!(run.states().is_empty());
    // What went there is not left to be written again: no empty table is made of it.
    for refused in [run.write_csv(Vec::new()), run.write(Npy::new(Cursor::new(Vec::new())))] {
        assert_eq!(refused.unwrap_err().kind(), io::ErrorKind::InvalidInput);
    }
    let kept = planet().record_every(3).run(100).unwrap();
    let mut table = Vec::new();
    kept.write_csv(&mut table).unwrap();
    assert_eq!(streamed, table);
    assert_eq!((run.last(), run.steps()), (kept.last(), kept.steps()));
    assert_eq!(run.drift(Invariant::Energy).unwrap().max_abs(), kept.drift(Invariant::Energy).unwrap().max_abs());
    // By time, and for a scene.
    let mut streamed = Vec::new();
    let scene = Scene::new().body(1.0, [0.0], [0.0]).body(0.3, [1.0], [0.0]).pairs(Gravity { g: -1.0 });
    let simulation = || Simulation::scene(scene.clone()).scheme(Leapfrog).dt(0.1).record_dt(0.07);
    simulation().stream(Csv::new(&mut streamed)).run(20).unwrap();
    let mut table = Vec::new();
    simulation().run(20).unwrap().write_csv(&mut table).unwrap();
    assert_eq!(streamed, table);
    assert!(String::from_utf8(table).unwrap().starts_with("t,q0_0,q1_0,v0_0,v1_0\n0,0,1,0,0\n0.07"));
}

/// A row for each state of each body, named or numbered, from a stream and from a run.
#[test]
fn a_long_table_has_a_row_for_each_body() {
    let scene =
        Scene::new().body(1.0, [0.0, 0.5], [0.0; 2]).body(0.3, [1.0, 0.0], [0.0, 1.0]).body(2.0, [9.0; 2], [0.0; 2]);
    let simulation =
        || Simulation::scene(scene.clone().pairs(Gravity { g: 0.1 })).scheme(Leapfrog).dt(0.1).record_every(2);
    let (mut streamed, mut written) = (Vec::new(), Vec::new());
    let names = ["sun", "a \"moon\", far"];
    simulation().stream(Csv::long(&mut streamed).names(names)).run(7).unwrap();
    let kept = simulation().run(7).unwrap();
    kept.write(Csv::long(&mut written).names(names)).unwrap();
    assert_eq!(streamed, written);
    let table = String::from_utf8(written).unwrap();
    let lines: Vec<_> = table.lines().collect();
    assert_eq!(lines[..2], ["t,body,q0,q1,v0,v1", "0,sun,0,0.5,0,0"]);
    assert!(lines[2].starts_with("0,\"a \"\"moon\"\", far\",1,0,0,1") && lines[3].starts_with("0,2,9,9,"));
    assert_eq!(lines.len(), 1 + 3 * kept.states().len());
    let last: Vec<f64> = lines.last().unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    let state = kept.states().last().unwrap();
    assert_eq!(last, [state.t, 2.0, state.q[2][0], state.q[2][1], state.v[2][0], state.v[2][1]]);
    let mut plain = Vec::new();
    kept.write(Csv::long(&mut plain)).unwrap();
    assert!(String::from_utf8(plain).unwrap().contains("\n0,0,0,0.5,0,0\n0,1,1,0,0,1\n"));
    // As many names as bodies at most, and none twice.
    for (names, told) in [
        (&["a", "b", "c", "d"][..], "4 names for 3 bodies"),
        (&["a", "b", "a"], "two bodies are called a"),
        (&["2"], "two bodies are called 2"),
    ] {
        let refused = kept.write(Csv::long(io::sink()).names(names)).unwrap_err();
        assert_eq!((refused.kind(), refused.to_string().as_str()), (io::ErrorKind::InvalidInput, told));
        let stopped = simulation().stream(Csv::long(io::sink()).names(names)).run(7).unwrap_err().cause();
        assert_eq!(stopped, Error::Stream(io::ErrorKind::InvalidInput));
        assert!(stopped.to_string().ends_with(", for example more names than bodies, or two bodies of the same name"));
    }
    // A run is written as NumPy as well.
    let mut file = Cursor::new(Vec::new());
    kept.write(Npy::new(&mut file)).unwrap();
    assert_eq!(file.into_inner().len(), 128 + 8 * 13 * kept.states().len());
}

/// The head and the numbers of NumPy's format 1.0, read back byte by byte.
#[test]
fn a_table_of_numpy_reads_back() {
    let mut file = Cursor::new(Vec::new());
    planet().record_every(7).stream(Npy::new(&mut file)).run(700).unwrap();
    let kept = planet().record_every(7).run(700).unwrap();
    let bytes = file.into_inner();
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!((10 + length) % 64, 0);
    let head = core::str::from_utf8(&bytes[10..10 + length]).unwrap();
    assert!(head.starts_with("{'descr': '<f8', 'fortran_order': False, 'shape': (101, 5), }") && head.ends_with('\n'));
    let numbers: Vec<f64> = bytes[10 + length..].chunks(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect();
    let expected: Vec<f64> =
        kept.states().iter().flat_map(|state| [state.t, state.q[0], state.q[1], state.v[0], state.v[1]]).collect();
    assert_eq!(numbers, expected);
    // Nothing recorded: an empty table.
    let mut file = Cursor::new(Vec::new());
    planet().record_at([]).stream(Npy::new(&mut file)).run(7).unwrap();
    assert_eq!(file.into_inner().len(), 128);
}

/// A disk that is full after some bytes.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.0 < bytes.len() {
            return Err(io::ErrorKind::StorageFull.into());
        }
        self.0 -= bytes.len();
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_full_disk_ends_the_run_with_what_it_has() {
    let failed = planet().stream(Csv::new(Full(1000))).run(100).unwrap_err();
    assert_eq!(failed.cause(), Error::Stream(io::ErrorKind::StorageFull));
    assert!(failed.run().steps() > 3 && failed.run().last().t > 0.03);
    assert_eq!(failed.cause().to_string(), "a recorded state could not be written: no storage space");
    // A stream that fails at once, and events that are kept.
    assert_eq!(planet().stream(Csv::new(Full(0))).run(100).unwrap_err().run().steps(), 0);
    let run = planet().event(|state| state.q[1], Crossing::Falling).stream(Csv::new(io::sink())).run(1000).unwrap();
    // Twice in 1.8 revolutions.
    assert_eq!(run.events().len(), 2);
}

/// What a full disk has taken of a row is none; a table may stand behind other bytes; a table of nothing has its columns.
#[test]
fn tables_are_whole_wherever_they_end() {
    struct Short(Cursor<Vec<u8>>, usize);
    impl Write for Short {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            // The head is put in at the end, where there was one.
            let room = if self.0.position() < 128 { usize::MAX } else { self.1 };
            if room < bytes.len() {
                return Err(io::ErrorKind::StorageFull.into());
            }
            self.1 -= if room == usize::MAX { 0 } else { bytes.len() };
            self.0.write(bytes)
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
    impl io::Seek for Short {
        fn seek(&mut self, to: io::SeekFrom) -> io::Result<u64> {
            self.0.seek(to)
        }
    }
    let head = |bytes: &[u8]| String::from_utf8(bytes[10..128].to_vec()).unwrap();
    for (rows, part) in [(3, 24), (1, 24), (0, 8)] {
        let mut disk = Short(Cursor::new(Vec::new()), rows * 40 + part);
        let failed = planet().stream(Npy::new(&mut disk)).run(100).unwrap_err();
        assert_eq!(failed.cause(), Error::Stream(io::ErrorKind::StorageFull));
        assert!(head(&disk.0.into_inner()).contains(&format!("'shape': ({rows}, 5)")), "{rows}");
    }
    let mut file = Cursor::new(vec![7; 30]);
    file.set_position(30);
    planet().record_every(50).stream(Npy::new(&mut file)).run(100).unwrap();
    assert_eq!(file.position(), 30 + 128 + 3 * 40);
    let bytes = file.into_inner();
    assert!(bytes[..30].iter().all(|&x| x == 7) && &bytes[30..36] == b"\x93NUMPY" && bytes.len() == 30 + 128 + 120);
    let mut file = Cursor::new(Vec::new());
    planet().record_at([]).stream(Npy::new(&mut file)).run(7).unwrap();
    assert!(head(&file.into_inner()).contains("'shape': (0, 5)"));
    let mut names = Vec::new();
    planet().record_at([]).stream(Csv::new(&mut names)).run(7).unwrap();
    assert_eq!(names, b"t,q0,q1,v0,v1\n");
}

/// The run tells why it ended, also where the stream cannot be ended either.
#[test]
fn the_cause_of_a_run_comes_before_that_of_its_stream() {
    struct Broken;
    impl Write for Broken {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            Ok(bytes.len())
        }
        fn flush(&mut self) -> io::Result<()> {
            Err(io::ErrorKind::BrokenPipe.into())
        }
    }
    let falling = Simulation::new(Kepler { gm: 1.3 }, State::new([1.0, 0.0], [0.0, 0.0]));
    let failed = falling.scheme(DiscreteGradient).dt(0.05).stream(Csv::new(Broken)).run(1000).unwrap_err();
    assert!(!matches!(failed.cause(), Error::Stream(_)), "{failed}");
    assert!(failed.to_string().contains("steps done"), "{failed}");
    assert_eq!(planet().stream(Csv::new(Broken)).run(9).unwrap_err().cause(), Error::Stream(io::ErrorKind::BrokenPipe));
}
