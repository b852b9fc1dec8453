//! A law has parameters, not alternatives.
use dmech::prelude::*;

#[dmech::law]
enum Well {
    Harmonic,
    Quartic,
}

fn main() {
    let _: Option<State<2>> = None;
    let _ = (Well::Harmonic, Well::Quartic);
}
