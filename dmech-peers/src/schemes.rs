//! The schemes of dmech that take part: one list, for laws of one body and for the chain.

use dmech::prelude::*;
use dmech::scene::{Chain, Linked};

use crate::entrant::{Crate, Entrant, Finish, steps};
use crate::problem::{Fput, Problem};

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
    };
}

/// The same for schemes that need the Hessian, which a scene does not have.
macro_rules! every_hessian_scheme {
    ($add:ident) => {
        $add!("FG 4", ForceGradient::order4());
        $add!("FG 6", ForceGradient::order6());
        $add!("FG 8", ForceGradient::order8());
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
    };
}

/// All schemes on a law of one body of mass 1.
pub fn law_schemes<'a, L, M, const D: usize>(law: L, problem: &'a Problem<M, D>) -> Vec<Entrant<'a>>
where
    L: Law<D> + VelocityIndependent + Clone + 'a,
{
    let mut entrants = Vec::new();
    macro_rules! add {
        ($label:literal, $scheme:expr) => {
            let law = law.clone();
            let run = move |steps: f64| {
                let simulation = Simulation::new(law.clone(), problem.start).scheme($scheme).dt(problem.end / steps);
                Finish::of(&problem.truth, || {
                    let mut stepper = simulation.stepper().map_err(|error| error.to_string())?;
                    stepper.advance(steps as u64).map_err(|error| error.to_string())?;
                    Ok((stepper.q(), stepper.evaluations()))
                })
            };
            entrants.push(Entrant::new(Crate::Dmech, name(&$scheme), $label, steps(problem.end, problem.coarse), run));
        };
    }
    every_scheme!(add);
    every_hessian_scheme!(add);
    macro_rules! add_adaptive {
        ($label:literal, $scheme:expr) => {
            let law = law.clone();
            // A study steps to the end exactly, without watching the run that it times.
            let run = move |tolerance: f64| {
                let study = Study::new(law.clone(), problem.start, problem.end).adaptive($scheme, [tolerance]);
                let report = study.exact(|_| problem.truth).repetitions(1).run().map_err(|error| error.to_string())?;
                let row = report.rows().first().ok_or("no run")?;
                let figures = row.result().map_err(|error| error.to_string())?;
                let (error, evaluations, time) = (figures.error(), figures.evaluations(), figures.time());
                Ok(Finish { error, evaluations, time })
            };
            let name = format!("{}, adaptive", name(&$scheme));
            entrants.push(Entrant::new(Crate::Dmech, name, $label, crate::tolerances(), run));
        };
    }
    every_adaptive_scheme!(add_adaptive);
    entrants
}

/// All schemes on the chain, as a scene.
pub fn chain_schemes(problem: &Problem<Fput, 64>) -> Vec<Entrant<'_>> {
    let mut entrants = Vec::new();
    macro_rules! add {
        ($label:literal, $scheme:expr) => {
            let scene = chain(&problem.start, problem.motion.alpha);
            let run = move |steps: f64| {
                let simulation = Simulation::scene(scene.clone()).scheme($scheme).dt(problem.end / steps);
                Finish::of(&problem.truth, || {
                    let mut stepper = simulation.stepper().map_err(|error| error.to_string())?;
                    stepper.advance(steps as u64).map_err(|error| error.to_string())?;
                    Ok((core::array::from_fn(|j| stepper.q().get(j + 1)[0]), stepper.evaluations()))
                })
            };
            entrants.push(Entrant::new(Crate::Dmech, name(&$scheme), $label, steps(problem.end, problem.coarse), run));
        };
    }
    every_scheme!(add);
    entrants
}

fn name<S: Method>(_: &S) -> &'static str {
    S::NAME
}

/// Three bodies of mass 1 in the plane as one law of six coordinates, g = 1.
#[derive(Clone, Copy, Debug)]
pub struct ThreeBodies {
    g: f64,
}

#[dmech::law]
impl ThreeBodies {
    /// −g Σ 1/rᵢⱼ.
    #[potential]
    fn energy(&self, q: [f64; 6]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let (x, y) = (q[2 * i] - q[2 * j], q[2 * i + 1] - q[2 * j + 1]);
                sum -= self.g / (x * x + y * y).sqrt();
            }
        }
        sum
    }
}

/// g = 1.
pub fn three_bodies() -> ThreeBodies {
    ThreeBodies { g: 1.0 }
}

/// A spring of energy r²/2 + α r³/3, where r is by how much it is longer than at rest: as the others get it, without the terms
/// that the library's spring has besides.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spring {
    alpha: f64,
}

#[dmech::law]
impl Spring {
    #[pair]
    fn energy(&self, d: [f64; 1]) -> f64 {
        // d is the position of a body less that of the next.
        let r = -d[0];
        r * r * (0.5 + self.alpha * r / 3.0)
    }
}

/// 64 masses between pinned bodies 0 and 65.
pub(crate) fn chain(start: &State<64>, alpha: f64) -> Scene<1, (), ((), Linked<Spring, Chain>)> {
    let mut scene = Scene::new().body(1.0, [0.0], [0.0]);
    for (q, v) in start.q.into_iter().zip(start.v) {
        scene = scene.body(1.0, [q], [v]);
    }
    scene.body(1.0, [0.0], [0.0]).pin(0).pin(65).chain(Spring { alpha })
}
