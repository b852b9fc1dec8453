//! Laws that are refused, with every word that their author is told, and laws that are unusual and right.
//!
//! `TRYBUILD=overwrite cargo test -p dmech-messages` writes the messages anew; read what it wrote.

#[test]
fn messages() {
    let cases = trybuild::TestCases::new();
    cases.pass("pass/*.rs");
    cases.compile_fail("fail/*/*.rs");
}
