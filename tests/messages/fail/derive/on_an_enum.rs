//! A law has parameters, not alternatives.
use dmech::prelude::*;

#[derive(dmech::Law)]
#[potential(|q: f64| q * q)]
enum Spring {
    Soft,
    Hard,
}

fn main() {
    let _: Option<State<2>> = None;
    let _ = (Spring::Soft, Spring::Hard);
}
