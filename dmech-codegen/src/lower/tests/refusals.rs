//! What the body of a potential cannot contain: the words, and the piece of the text they point at.

use super::{assert_refused, body, lower_derive, lower_text};

/// A law of two coordinates whose body is refused at the marks.
fn refused(text: &str, messages: &[&str]) {
    assert_refused(&body("[f64; 2]", text), messages, lower_text);
}

/// A whole block that is refused at the marks.
fn refused_block(text: &str, messages: &[&str]) {
    assert_refused(text, messages, lower_text);
}

#[test]
fn integers_where_numbers_belong() {
    let two = "`2` is an integer and a number is expected here; write `2.0`";
    refused("«2» * q[0]", &[two]);
    refused("q[0] * «-2»", &["`-2` is an integer and a number is expected here; write `-2.0`"]);
    refused("let mut s = 0.0; s += «2»; s * q[0]", &[two]);
    refused("let s: f64 = «2»; s * q[0]", &[two]);
    refused("q[0].max(«2»)", &[two]);
    refused("«2».sqrt() * q[0]", &["x"]);
}
