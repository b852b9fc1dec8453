//! Nothing but a suite: see `tests/messages.rs`.
