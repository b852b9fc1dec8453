//! The page of results: what it takes from the examples, and how it looks in a browser.

mod browser;
#[path = "../../examples/gallery/entry.rs"]
mod entry;
#[path = "../../examples/shared/html.rs"]
mod html;
#[path = "../../examples/gallery/list.rs"]
mod list;
mod page;
#[path = "../../examples/gallery/source.rs"]
mod source;
mod sources;
