//! Pages: the head and the style that they share, and how words, code and pictures are put on them.
#![allow(dead_code, reason = "each page uses its part")]

use std::path::Path;
use std::{fs, io};

/// What is wide scrolls in a box of its own, never the page; on narrow paper the margins are narrow.
const STYLE: &str = "*{box-sizing:border-box}\
body{font:17px/1.5 sans-serif;color:#222;background:#fff;max-width:72rem;margin:0 auto;padding:1.5rem 1rem 3rem;\
overflow-wrap:break-word}\
h1,h2,h3{font-weight:600;line-height:1.25}h2{margin-top:3rem;border-bottom:1px solid #ccc}h3{margin-top:2.5rem}\
p,li,dl{max-width:46rem}a{color:#1f5a99}\
pre,code{font-family:monospace;font-size:15px}\
pre{line-height:1.35;overflow-x:auto;background:#f5f5f5;padding:.8rem 1rem;margin:.8rem 0}\
.formula{background:none;padding:0}.numbers pre{background:#fff;border:1px solid #ccc}\
li{margin:.35rem 0}.time{white-space:nowrap}\
dl{display:grid;grid-template-columns:max-content minmax(0,1fr);gap:.2rem 1rem}dt{color:#555}dd{margin:0}\
.pictures{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,30rem),1fr));gap:1rem}\
.picture{display:block;overflow-x:auto;cursor:zoom-in;max-width:60rem}\
.picture>svg{display:block;max-width:100%;height:auto}\
.picture>input{position:absolute;opacity:0}.picture:has(:focus-visible){outline:2px solid #1f5a99}\
.picture:has(:checked){grid-column:1/-1;max-width:none;cursor:zoom-out}\
.picture>:checked~svg{max-width:none}\
.numbers:has([open])>pre{display:none}summary{cursor:pointer;color:#1f5a99}\
.failed{color:#b00020;font-weight:600}\
.table{overflow-x:auto}table{border-collapse:collapse}\
td,th{padding:.15rem .9rem .15rem 0;text-align:right;white-space:nowrap}\
td:first-child,th:first-child{text-align:left;white-space:normal;overflow-wrap:anywhere;min-width:9rem}\
th{border-bottom:1px solid #ccc;font-weight:600}.best{font-weight:700;color:#1b7030}";

/// A whole page around its body.
pub(crate) fn document(title: &str, body: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{}</title>\n<style>{STYLE}</style></head>\n<body>\n{body}</body></html>\n",
        escaped(title)
    )
}

pub(crate) fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Words with `code` between backticks, as doc comments have it.
pub(crate) fn prose(words: &str) -> String {
    let parts = words.split('`').enumerate();
    parts.map(|(i, part)| if i % 2 == 1 { format!("<code>{}</code>", escaped(part)) } else { escaped(part) }).collect()
}

/// A picture as wide as there is room, which a click shows in its full size. It is part of the page, so that the page is one
/// file.
///
/// # Errors
/// Those of reading, and `InvalidData` for what is no SVG.
pub(crate) fn picture(path: &Path) -> io::Result<String> {
    let wrong = |what: &str| io::Error::new(io::ErrorKind::InvalidData, format!("{}: {what}", path.display()));
    let name = escaped(path.file_name().and_then(|name| name.to_str()).ok_or_else(|| wrong("no name"))?);
    // What SVG takes anyway is a third of a picture with many dots.
    let svg = fs::read_to_string(path)?.replace(" opacity=\"1\"", "").replace(" stroke=\"none\"", "");
    let root = svg.find("<svg ").ok_or_else(|| wrong("no <svg>"))? + "<svg ".len();
    Ok(format!(
        "<label class=\"picture\"><input type=\"checkbox\" aria-label=\"{name} in full size\">\
         <svg role=\"img\" aria-label=\"{name}\" {}</label>\n",
        &svg[root..]
    ))
}
