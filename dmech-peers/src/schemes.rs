//! The schemes of dmech that take part: one list, for laws of one body and for the chain.

use dmech::extend::AtStages;
use dmech::prelude::*;
use dmech::{StudyError, StudyReport};

use crate::entrant::{Crate, Entrant, Finish, steps};
use crate::laws::chain;
use crate::motion::Fput;
use crate::problem::Problem;

/// The list: names in pictures, and schemes.
macro_rules! every_scheme {
    ($add:ident) => {
        $add!("Leapfrog", Leapfrog);
        $add!("LF 4", Composed::order4(Leapfrog));
        $add!("LF 6", Composed::order6(Leapfrog));
        $add!("LF 8", Composed::order8(Leapfrog));
        $add!("RKN 4", Nystrom::order4());
        $add!("RKN 6S11", Nystrom::new(coefficients::BlanesMoan6S11));
        $add!("RKN 6", Nystrom::order6());
        $add!("RKN 8", Nystrom::order8());
        $add!("DG", DiscreteGradient);
        $add!("DG 4", Composed::order4(DiscreteGradient));
        $add!("DG 6", Composed::order6(DiscreteGradient));
        $add!("DG 8", Composed::order8(DiscreteGradient));
        $add!("FG 4", ForceGradient::order4());
        $add!("FG 6", ForceGradient::order6());
        $add!("FG 8", ForceGradient::order8());
        $add!("LI 8", LineIntegral::order8());
        $add!("LI 10", LineIntegral::order10());
        $add!("Gauss 16", Gauss::order16());
    };
}

/// The same for steps that follow the motion.
macro_rules! every_adaptive_scheme {
    ($add:ident) => {
        $add!("RKN 4 ad.", Nystrom::order4());
        $add!("RKN 6 ad.", Nystrom::order6());
        $add!("RKN 8 ad.", Nystrom::order8());
        $add!("FG 4 ad.", ForceGradient::order4());
        $add!("FG 6 ad.", ForceGradient::order6());
        $add!("FG 8 ad.", ForceGradient::order8());
        $add!("DG 4 ad.", Composed::order4(DiscreteGradient));
        $add!("DG 6 ad.", Composed::order6(DiscreteGradient));
        $add!("DG 8 ad.", Composed::order8(DiscreteGradient));
        $add!("Gauss 16 ad.", Gauss::order16());
    };
}

/// The one run of a study, which steps to the end exactly and does not watch what it times.
fn finish(report: Result<StudyReport, StudyError>) -> Result<Finish, String> {
    let report = report.map_err(|error| error.to_string())?;
    let row = report.rows().first().ok_or("no run")?;
    let figures = row.result().map_err(|error| error.to_string())?;
    let (error, evaluations, time) = (figures.error(), figures.evaluations(), figures.time());
    Ok(Finish { error, evaluations, time })
}

/// Adds every scheme of a list, in steps of equal length.
macro_rules! entrants {
    ($list:ident, $problem:ident, $entrants:ident, $study:expr) => {{
        macro_rules! add {
            ($label:literal, $scheme:expr) => {
                let study = $study;
                let run = move |steps: f64| {
                    finish(study().scheme($scheme).ladder([$problem.end / steps]).repetitions(1).run())
                };
                let knobs = steps($problem.end, $problem.coarse, order(&$scheme));
                $entrants.push(Entrant::new(Crate::Dmech, name(&$scheme), $label, knobs, run));
            };
        }
        $list!(add);
    }};
}

/// All schemes on a law of one body of mass 1.
pub fn law_schemes<'a, L, M, const D: usize>(law: L, problem: &'a Problem<M, D>) -> Vec<Entrant<'a>>
where
    L: AtStages<D, f64> + VelocityIndependent + Clone + 'a,
{
    let mut entrants = Vec::new();
    let study = || {
        let law = law.clone();
        move || Study::new(law.clone(), problem.start, problem.end).exact(|_| problem.truth)
    };
    entrants!(every_scheme, problem, entrants, study());
    macro_rules! add_adaptive {
        ($label:literal, $scheme:expr) => {
            let study = study();
            let run = move |tolerance: f64| finish(study().adaptive($scheme, [tolerance]).repetitions(1).run());
            let name = format!("{}, adaptive", name(&$scheme));
            entrants.push(Entrant::new(Crate::Dmech, name, $label, crate::tolerances(), run));
        };
    }
    every_adaptive_scheme!(add_adaptive);
    entrants
}

/// All schemes on the chain, as a scene between two pinned bodies.
pub fn chain_schemes(problem: &Problem<Fput, 64>) -> Vec<Entrant<'_>> {
    let mut entrants = Vec::new();
    let study = || {
        let scene = chain(&problem.start, problem.motion.beta);
        let ends = |x: &[f64; 64]| [&[0.0], x.as_slice(), &[0.0]].concat().into_iter().map(|x| [x]).collect::<Vec<_>>();
        let truth = ends(&problem.truth);
        move || {
            let truth = truth.clone();
            Study::scene(scene.clone(), problem.end).exact(move |_| truth.clone())
        }
    };
    entrants!(every_scheme, problem, entrants, study());
    entrants
}

fn name<S: Method>(_: &S) -> &'static str {
    S::NAME
}

fn order<S: Method>(_: &S) -> u32 {
    S::ORDER
}
