//! Laws that are refused, with every word that their author is told, and laws that are unusual and right.
//!
//! `TRYBUILD=overwrite cargo test --test ui` writes the messages anew; read what it wrote.
//!
//! With default features only: the compiler names a trait by its shortest unique path, and the crates that other features bring
//! change what is unique.
#![cfg(not(feature = "progress"))]

#[test]
fn messages() {
    let cases = trybuild::TestCases::new();
    cases.pass("tests/ui/pass/*.rs");
    cases.compile_fail("tests/ui/fail/*/*.rs");
}
