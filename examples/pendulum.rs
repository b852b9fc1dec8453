//! The pendulum of Greenspan's §4, computed again.
//!
//! ```text
//! cargo run --release --example pendulum
//! ```
//!
//! A particle of unit mass moves by x″ = −sin x − α x′ from x₀ = π/4 at rest. D. Greenspan ("New Forms of Discrete
//! Mechanics", 1971, §4) followed it for 10⁴ steps by the implicit formulas, with four dampings and three time steps,
//! and by leap-frog where α = 0. He reports that every run was stable, that the undamped extrema are within 1e-5 of
//! ±π/4, that leap-frog took a quarter of the time, and that the explicit method would need Δt < max(2α, 2/α).
//!
//! The program runs the fifteen cases, puts what it finds beside each of these statements, and draws Figure 4.2.

#[path = "shared/picture.rs"]
mod picture;
#[path = "shared/section_4.rs"]
mod section_4;

use std::f64::consts::FRAC_PI_4;
use std::hint::black_box;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use dmech::prelude::*;
use dmech::scheme::Scheme;
use picture::{Axis, BLUE, Drawn, INK, OCHRE};
use section_4::{ALPHAS, Extrema, Outcome, PENDULUM, START, STEPS, TIME_STEPS};

fn main() -> Drawn {
    final_states()?;
    extrema()?;
    times()?;
    explicit_limits()?;
    println!("Picture: {}", figure_4_2()?.display());
    Ok(())
}

fn final_states() -> Drawn {
    println!("{FINAL_STATES}");
    for alpha in ALPHAS {
        for dt in TIME_STEPS {
            final_state(alpha, &section_4::implicit(alpha, dt)?);
        }
    }
    for dt in TIME_STEPS {
        final_state(0.0, &section_4::leapfrog(dt)?);
    }
    Ok(())
}

/// α and the scheme once for each group of three.
fn final_state(alpha: f64, run: &Run<State<1>>) {
    let report = run.report();
    let group = if report.dt() == TIME_STEPS[0] { format!("{:<9} {alpha:<5}", report.scheme()) } else { String::new() };
    let State { q: [x], v: [v], t } = *run.last();
    let iterations = report.iterations() as f64 / report.steps() as f64;
    let iterations = if iterations > 0.0 { format!("{iterations:.2}") } else { "–".to_owned() };
    println!("{group:<15} {:<5} │ {t:>6.0} {x:>16.12} {v:>16.12} │ {iterations:>6}", report.dt());
}

fn extrema() -> Drawn {
    println!("{EXTREMA}");
    let undamped: fn(f64) -> Outcome = |dt| section_4::implicit(0.0, dt);
    for (scheme, run) in [("Implicit", undamped), ("Leapfrog", section_4::leapfrog)] {
        for dt in TIME_STEPS {
            let Extrema { count, raw, parabola, overshoot } = Extrema::of(run(dt)?.states());
            let scheme = if dt == TIME_STEPS[0] { scheme } else { "" };
            let marked = |error: f64| format!("{error:.1e}{}", if error < 1e-5 { ' ' } else { '*' });
            println!(
                "{scheme:<9} {dt:<5} │ {count:>5} │ {:>8} {:>10} │ {:>9}",
                marked(raw),
                marked(parabola),
                if overshoot > 0.0 { format!("{overshoot:.1e}") } else { "never".to_owned() }
            );
        }
    }
    println!("{OVERSHOOT}");
    Ok(())
}

fn times() -> Drawn {
    println!("{TIMES}");
    for dt in TIME_STEPS {
        let damped = per_step(section_4::damped(0.0), Implicit, dt)?;
        let implicit = per_step(PENDULUM, Implicit, dt)?;
        let leapfrog = per_step(PENDULUM, Leapfrog, dt)?;
        println!("{dt:<5} │ {damped:>8.1} │ {implicit:>8.1} {leapfrog:>8.1} │ {:>5.1} : 1", implicit / leapfrog);
    }
    println!();
    Ok(())
}

/// Nanoseconds in a step: the shortest of several runs of 10⁴ steps, nothing recorded.
fn per_step<L: Law<1> + Copy, S: Scheme<Particle<L, 1>>>(law: L, scheme: S, dt: f64) -> Drawn<f64> {
    let mut shortest = Duration::MAX;
    for _ in 0..20 {
        let mut stepper = Simulation::new(law, START).scheme(scheme).dt(dt).stepper()?;
        let begin = Instant::now();
        stepper.advance(STEPS)?;
        shortest = shortest.min(begin.elapsed());
        black_box(stepper.state());
    }
    Ok(1e9 * shortest.as_secs_f64() / STEPS as f64)
}

fn explicit_limits() -> Drawn {
    println!("{STABILITY}");
    for (alpha, n) in section_4::STABILITY {
        let limit = section_4::explicit_limit(alpha);
        for part in [0.98, 1.02] {
            let dt = part * limit;
            let growth = section_4::measured_growth(alpha, dt, n)? - 1.0;
            let predicted = section_4::predicted_growth(alpha, dt) - 1.0;
            let verdict = if growth < 0.0 { "decays" } else { "grows" };
            let group = if part < 1.0 {
                format!("{alpha:<5} │ {:>7.4} {:>8.4}", limit, (2.0 * alpha).max(2.0 / alpha))
            } else {
                format!("{:<5} │ {:>16}", "", "")
            };
            println!("{group} │ {dt:>8.5} {growth:>+10.2e} {predicted:>+10.2e}  {verdict}");
        }
    }
    println!("{LIMIT}");
    Ok(())
}

/// x(t) for α = 0.003, Δt = 0.01, with the amplitude that weak damping leaves.
fn figure_4_2() -> Drawn<PathBuf> {
    let run = section_4::implicit(0.003, 0.01)?;
    let motion: Vec<_> = run.states().iter().map(|state| (state.t, state.q[0])).collect();
    let envelope =
        |sign: f64| (0..=100).map(|t| (f64::from(t), sign * FRAC_PI_4 * (-0.0015 * f64::from(t)).exp())).collect();
    picture::save("figure_4_2.svg", [900, 420], |area| {
        let title = "Figure 4.2: the damped pendulum, α = 0.003, Δt = 0.01, implicit";
        let mut chart = picture::chart(
            area,
            title,
            Axis::linear("t (dimensionless)", 0.0..100.0),
            Axis::linear("x (radians)", -1.0..1.0),
            110,
        )?;
        picture::line(&mut chart, envelope(1.0), OCHRE, 1.5)?;
        picture::line(&mut chart, envelope(-1.0), OCHRE, 1.5)?;
        picture::dots(&mut chart, &motion[..1], BLUE, 3.5)?;
        picture::label(&chart, motion[0], (10, -8), "start", INK)?;
        picture::line(&mut chart, motion, BLUE, 1.5)?;
        picture::label(&chart, (100.0, 0.68), (8, 0), "π/4 e^(−αt/2)", OCHRE)?;
        picture::label(&chart, (100.0, -0.517), (8, 0), "end, t = 100", INK)?;
        Ok(())
    })
}

const FINAL_STATES: &str = "
The pendulum x″ = −sin x − α x′ from x = π/4 at rest: D. Greenspan's §4 (1971), computed again

After 10⁴ steps
                      │                                          │ Newton
scheme    α     Δt    │      t                x                v │ a step
──────────────────────┼──────────────────────────────────────────┼───────";

const EXTREMA: &str = "
Undamped extrema: the largest ||X| − π/4|, of which the paper says that it is below 1e-5 in all cases
                │       │ as they   vertex of │    beyond
scheme    Δt    │ count │  stand   a parabola │       π/4
────────────────┼───────┼─────────────────────┼──────────";

const OVERSHOOT: &str = "
  *  above 1e-5: at Δt = 1 and 0.1 the sequence x_k simply has no point near its turning points. The motion itself
     turns at ±π/4 and never passes it.
";

const TIMES: &str = "\
Nanoseconds a step, α = 0 (the paper: implicit to leap-frog four to one)
      │ law with │ law without v     │
Δt    │ damping  │ Implicit Leapfrog │     ratio
──────┼──────────┼───────────────────┼──────────";

const STABILITY: &str = "\
The explicit method, small swings: growth of the amplitude in a step, 2 % below and above the limit
      │ of 2α and 2/α    │          growth − 1
α     │ smaller   larger │       Δt   measured  predicted
──────┼──────────────────┼───────────────────────────────────────";

const LIMIT: &str = "
  The limit is the smaller of 2α and 2/α, where the paper prints the larger: with α = 0.003 none of its three time
  steps would be stable, and with α = 0 none at all.
";
