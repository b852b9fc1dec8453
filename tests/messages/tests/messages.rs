//! Laws that are refused, with every word that their author is told; those that are unusual and right are in `pass`.
//!
//! `TRYBUILD=overwrite cargo test -p dmech-messages` writes the messages anew; read what it wrote.

#[test]
fn messages() {
    // Without any that pass, which would be built one after another, and these with them.
    trybuild::TestCases::new().compile_fail("fail/*/*.rs");
}
