//! A page in headless Chromium: how wide it is, what it has loaded, and what went wrong.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

/// What a page has told of itself.
#[derive(Clone, Debug)]
pub(crate) struct Facts {
    /// The width that it had, what it needed, and what it needed with all pictures in full size and all lines unfolded.
    pub(crate) client: f64,
    pub(crate) scroll: f64,
    pub(crate) unfolded: f64,
    /// Pictures that are seen, and those that are not.
    pub(crate) pictures: f64,
    pub(crate) missing: f64,
    /// Of the widths of pictures before that, the most that is not seen.
    pub(crate) cut: f64,
    /// The smallest letters outside pictures, in pixels.
    pub(crate) letters: f64,
    /// Messages to the console and resources that could not be had.
    pub(crate) errors: f64,
}

/// Put at the head of a page: tells its facts to the page that it is framed by, which names it.
const TELL: &str = "<script>let errors=0;addEventListener('error',()=>errors++,true);
console.error=console.warn=()=>errors++;
addEventListener('load',()=>{const root=document.documentElement,letters=[];
const all=[...document.querySelectorAll('svg,img')];
const seen=all.filter(one=>one.clientWidth>0&&one.clientHeight>0&&(one.naturalWidth??1)>0).length;
const texts=document.createTreeWalker(document.body,NodeFilter.SHOW_TEXT);
while(texts.nextNode()){const of=texts.currentNode.parentElement;
if(!of.closest('svg')&&texts.currentNode.data.trim())letters.push(parseFloat(getComputedStyle(of).fontSize))}
const told=[name,root.clientWidth,root.scrollWidth];
const cut=Math.max(...[...document.querySelectorAll('.picture')].map(picture=>picture.scrollWidth-picture.clientWidth));
document.querySelectorAll('input').forEach(input=>input.click());
document.querySelectorAll('details').forEach(details=>details.open=true);
parent.postMessage([...told,root.scrollWidth,seen,all.length-seen,cut,Math.min(...letters),errors].join(' '),'*')})
</script>";

/// Frames the pages that it is to be told of.
const HEAR: &str = "<!doctype html><meta charset=\"utf-8\"><pre id=\"facts\"></pre>
<script>addEventListener('message',told=>document.getElementById('facts').textContent+='FACTS '+told.data+'\\n')</script>";

/// The browser that there is: what `DMECH_CHROMIUM` names, or one of those that the system may have.
pub(crate) fn find() -> Option<String> {
    let runs = |program: &String| Command::new(program).arg("--version").output().is_ok_and(|o| o.status.success());
    if let Ok(program) = env::var("DMECH_CHROMIUM") {
        assert!(runs(&program), "DMECH_CHROMIUM is {program}, which does not run");
        return Some(program);
    }
    ["chromium", "chromium-browser", "google-chrome"].map(str::to_owned).into_iter().find(runs)
}

/// The facts of one page at several widths, in their order.
///
/// A window of Chromium has a least width, which a frame in it has not.
pub(crate) fn facts<const N: usize>(browser: &str, folder: &Path, page: &str, widths: [u32; N]) -> [Facts; N] {
    let told = page.replacen("<head>", &format!("<head>{TELL}"), 1);
    assert_ne!(told, page, "the page has no head");
    fs::write(folder.join("page.html"), told).unwrap();
    let frame =
        |width| format!("<iframe name=\"{width}\" src=\"page.html\" width=\"{width}\" height=\"2000\"></iframe>\n");
    let frames: String = widths.iter().map(frame).collect();
    let outside = folder.join("frames.html");
    fs::write(&outside, format!("{HEAR}\n{frames}")).unwrap();
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--window-size=1600,2400", "--enable-logging=stderr"])
        // Waits for what is under way.
        .args(["--virtual-time-budget=10000", "--dump-dom"])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("file://{}", outside.display()))
        .output()
        .unwrap();
    let (seen, log) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    let console = log.lines().filter(|line| line.contains(":CONSOLE")).count() as f64;
    widths.map(|width| {
        let from = format!("FACTS {width} ");
        let line = seen.lines().find_map(|line| Some(line.split_once(&from)?.1));
        let line = line.unwrap_or_else(|| panic!("nothing was told at {width}: {seen}\n{log}"));
        let numbers: Vec<f64> = line.split_whitespace().map(|number| number.parse().unwrap()).collect();
        let [client, scroll, unfolded, pictures, missing, cut, letters, errors] = numbers[..] else { panic!("{line}") };
        Facts { client, scroll, unfolded, pictures, missing, cut, letters, errors: errors + console }
    })
}
