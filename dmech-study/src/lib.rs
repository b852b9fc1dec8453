//! What measures the schemes of dmech: [`Study`], speed against error on a law or a scene; [`verify`](fn@verify), a law put
//! through its checks; [`verify_scheme`], a scheme put through its own.
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

mod error;
mod motion;
pub mod study;
pub mod verify;

pub use error::StudyError;
pub use motion::Coordinates;
pub use study::{Study, StudyReport};
pub use verify::{verify, verify_scheme};
