//! What was derived from the text of a law against the method itself.

use super::Subject;
use super::report::Check;
use dmech_core::Law;
use dmech_core::written::{Agreement, Probe, agreement};

/// At the start and the points around it where the potential is finite.
pub(super) fn check<L: Law<D>, const D: usize>(subject: &Subject<L, D>, checks: &mut Vec<Check>) {
    let Subject { law, start, mass, .. } = subject;
    const NAME: &str = "as written";
    let Some(written) = law.written() else {
        checks.push(Check::not_applicable(NAME, "written by hand, not derived from a text"));
        return;
    };
    let points = subject.points();
    let places = points.iter().map(|&q| Probe { q, v: [start.v; 2], m: [*mass; 2], t: start.t });
    let (mut worst, mut compared) = (0.0_f64, 0);
    for place in places {
        match agreement(written, &place) {
            Agreement::Compared(ratio, _) if ratio <= 1.0 => (worst, compared) = (worst.max(ratio), compared + 1),
            Agreement::OneSided(difference) if !difference.panics() => {}
            Agreement::Compared(_, difference) | Agreement::OneSided(difference) => {
                checks.push(Check::failed(NAME, difference.to_string()));
                return;
            }
            Agreement::Nowhere => {}
        }
    }
    checks.push(match compared {
        0 => Check::not_applicable(NAME, "not finite around the start"),
        _ => Check::at_most(NAME, worst, 1.0, "the method's own values, in units of what rounding may change"),
    });
}
