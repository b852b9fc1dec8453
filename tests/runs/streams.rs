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
    let run = planet().record_every(3).stream(Csv(&mut streamed)).run(100).unwrap();
    assert!(run.states().is_empty());
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
    simulation().stream(Csv(&mut streamed)).run(20).unwrap();
    let mut table = Vec::new();
    simulation().run(20).unwrap().write_csv(&mut table).unwrap();
    assert_eq!(streamed, table);
    assert!(String::from_utf8(table).unwrap().starts_with("t,q0_0,q1_0,v0_0,v1_0\n0,0,1,0,0\n0.07"));
}

/// The head and the numbers of NumPy's format 1.0, read back byte by byte.
#[test]
fn a_table_of_numpy_reads_back() {
    let mut file = Cursor::new(Vec::new());
    planet().record_every(7).stream(Npy(&mut file)).run(700).unwrap();
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
    planet().record_at([]).stream(Npy(&mut file)).run(7).unwrap();
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
    let failed = planet().stream(Csv(Full(1000))).run(100).unwrap_err();
    assert_eq!(failed.cause(), Error::Stream(io::ErrorKind::StorageFull));
    assert!(failed.run().steps() > 3 && failed.run().last().t > 0.03);
    assert_eq!(failed.cause().to_string(), "a recorded state could not be written: no storage space");
    // A stream that fails at once, and events that are kept.
    assert_eq!(planet().stream(Csv(Full(0))).run(100).unwrap_err().run().steps(), 0);
    let run = planet().event(|state| state.q[1], Crossing::Falling).stream(Csv(io::sink())).run(1000).unwrap();
    // Twice in 1.8 revolutions.
    assert_eq!(run.events().len(), 2);
}
