//! The map of chaos of the example `sweep` of dmech, over the ranks of MPI.
//!
//! ```text
//! cargo build --release --example sweep
//! mpirun -n 4 target/release/examples/sweep [sweep.sqlite]
//! ```
//!
//! With a file the members are kept there as they come; killed and started again, with any number of ranks, it goes on. The checksum
//! is that of the example of dmech, on one machine.

#[path = "../../examples/shared/henon_heiles.rs"]
mod henon_heiles;

use std::error::Error;

use dmech::models::HenonHeiles;
use dmech::prelude::*;
use henon_heiles::{APART, END, SIDE, V, Y, cells, start};

fn main() -> Result<(), Box<dyn Error>> {
    let world = dmech_mpi::World::start()?;
    let cells = cells();
    let mut sweep = Ensemble::of(2 * cells.len())
        .law(|_| HenonHeiles { lambda: 1.0 })
        .start(|k| start(&cells, k))
        .scheme(Nystrom::order6())
        .dt(0.1)
        .look_every(100);
    if let Some(file) = std::env::args().nth(1) {
        sweep = sweep.store(file);
    }
    let Some(run) = sweep.ranks(&world).run_until(END)? else { return Ok(()) };
    println!("{} pairs, {APART:e} apart at first, on {SIDE} x {SIDE} cells of y in {Y:?}, v_y in {V:?}", cells.len());
    println!("{} ranks: {run}checksum {:016x}", world.count(), run.checksum());
    Ok(())
}
