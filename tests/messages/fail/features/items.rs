//! Types and modules of features that are off: the compiler says which by itself.
use dmech::{Checkpoint, StoreError};

fn main() {
    let _: Option<(Checkpoint, StoreError)> = None;
    println!("{}", dmech::plot::rough(1.0, 3));
}
