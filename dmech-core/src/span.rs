//! How long steps may be, and how many lie between two times.

use dmech_scalar::Real;

use crate::error::Error;
use crate::method::Method;

/// How far a run goes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(not(feature = "ranks"), expect(unreachable_pub, reason = "ranks alone name it"))]
pub enum Span {
    /// So many steps.
    Steps(u64),
    /// Until a time.
    Until(f64),
}

impl Span {
    /// Refuses an end that no start reaches, by steps of this length.
    pub(crate) fn check(self, dt: f64) -> Result<(), Error> {
        match self {
            Span::Until(end) if !end.is_finite() => Err(Error::EndTime { end, dt }),
            _ => Ok(()),
        }
    }

    /// The time that so many steps take from a start, where it is known before.
    pub(crate) fn time(self, start: f64, steps: u64, dt: f64) -> f64 {
        match self {
            Span::Steps(_) => steps as f64 * dt,
            Span::Until(end) => end - start,
        }
    }

    /// The steps that it takes from a time: of equal length, where times are told apart to this resolution, or such as follow
    /// the motion.
    pub(crate) fn steps(self, start: f64, dt: f64, resolution: Option<f64>) -> Result<u64, Error> {
        self.check(dt)?;
        match (self, resolution) {
            (Span::Steps(steps), _) => possible(steps, start, dt, resolution),
            (Span::Until(end), Some(resolution)) => {
                let steps = steps_until(start, end, dt)?;
                moves_on(end, dt, resolution).map(|()| steps)
            }
            (Span::Until(end), None) if end < start => Err(Error::Span { start, end }),
            (Span::Until(end), None) => within_reach(start, end, dt).map(|()| UNCOUNTED),
        }
    }
}

/// Refuses lengths of steps, and tolerances.
pub(crate) fn check_step<R: Real>(scheme: &impl Method, dt: f64) -> Result<(), Error> {
    scheme.check()?;
    let positive = |x: f64| x > 0.0 && x.is_finite();
    let unlimited = scheme.tolerance().is_some() && dt == f64::INFINITY;
    // The scalar in use may be narrower than f64: 1e-60 is no time step in f32.
    if !unlimited && (!positive(dt) || !positive(R::from_f64(dt).to_f64())) {
        return Err(Error::TimeStep { dt });
    }
    Ok(())
}

/// Refuses an end that steps no longer than dt do not reach.
///
/// # Errors
/// [`Error::EndTime`]
fn within_reach(start: f64, end: f64, dt: f64) -> Result<(), Error> {
    let n = (end - start) / dt;
    if n.is_finite() && n <= TOLD_APART { Ok(()) } else { Err(Error::EndTime { end, dt }) }
}

/// More steps of one length than this, and the time t₀ + k h no longer distinguishes them: 2⁵³.
pub(crate) const TOLD_APART: f64 = 9_007_199_254_740_992.0;

/// As many steps as it takes to arrive.
pub(crate) const UNCOUNTED: u64 = u64::MAX;

/// The steps from `start` to `end`: ⌈n⌉ with n = (end − start)/dt, and the whole number itself where n is that but for
/// rounding, or for the digits that a user has left out of dt: up to 10⁻⁹ n and a thousandth of a step.
///
/// # Errors
/// [`Error::EndTime`], [`Error::Span`] and [`Error::TimeStandsStill`], as [`Simulation::run_until`](crate::Simulation::run_until).
pub fn steps_until(start: f64, end: f64, dt: f64) -> Result<u64, Error> {
    within_reach(start, end, dt)?;
    let n = (end - start) / dt;
    moves_on(end, dt, f64::EPSILON)?;
    let rounding = 4.0 * f64::EPSILON * (n.abs() + (start.abs() + end.abs()) / dt);
    if n < -rounding {
        return Err(Error::Span { start, end });
    }
    let whole = n.round();
    let steps = if (n - whole).abs() <= f64::min(1e-9 * n, 1e-3).max(rounding) { whole } else { n.ceil() };
    Ok(steps as u64)
}

/// So many steps from a time, if every one of them changes it.
pub(crate) fn possible(steps: u64, start: f64, dt: f64, resolution: Option<f64>) -> Result<u64, Error> {
    is_possible(start, dt, resolution)?;
    is_possible(steps as f64 * dt + start, dt, resolution)?;
    Ok(steps)
}

/// Whether a step changes a time, if it is one of equal steps; those that follow the motion look at the time themselves.
pub(crate) fn is_possible(time: f64, dt: f64, resolution: Option<f64>) -> Result<(), Error> {
    resolution.map_or(Ok(()), |resolution| moves_on(time, dt, resolution))
}

/// Whether a step changes a time by more than its rounding, relative to it.
pub(crate) fn moves_on(time: f64, dt: f64, resolution: f64) -> Result<(), Error> {
    if time.abs() * resolution < dt {
        return Ok(());
    }
    if time.is_infinite() {
        return Err(Error::EndTime { end: time, dt });
    }
    // The power of two below the time, and the last bit of a number that begins with it.
    let begins = f64::from_bits(time.to_bits() & f64::INFINITY.to_bits());
    Err(Error::TimeStandsStill { time, dt, next: begins * resolution })
}

/// Whether times are a few roundings apart.
pub(crate) fn is_rounding(time: f64, other: f64) -> bool {
    (other - time).abs() <= 4.0 * f64::EPSILON * other.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In everyday numbers neither rounding nor a few digits left out add a step; and a part of a step is one.
    #[test]
    fn steps_are_counted_right_for_any_number() {
        for dt in [0.1, 0.01, 0.3, 1e-3, 1.0 / 3.0, 7e-12, 1e9] {
            for steps in [1_u64, 2, 3, 7, 10, 1000, 123_457, 10_000_019, 2_000_000_000, 40_000_000_003, 1 << 45] {
                for start in [0.0, 100.0 * dt, -0.7 * steps as f64 * dt] {
                    let end = start + steps as f64 * dt;
                    assert_eq!(steps_until(start, end, dt), Ok(steps), "{steps} steps of {dt} from {start}");
                    let later = start + (steps as f64 + 0.5) * dt;
                    assert_eq!(steps_until(start, later, dt), Ok(steps + 1), "{steps} steps and a half of {dt}");
                }
            }
        }
        assert_eq!(steps_until(0.0, 1.0, 0.333_333_333_3), Ok(3));
        assert_eq!(steps_until(0.0, 1e-9, 1.0), Ok(1));
        assert_eq!(steps_until(3.0, 3.0, 0.1), Ok(0));
        // 0.1 + 0.2, and the same by rounding.
        assert_eq!(steps_until(0.1 + 0.2, 0.3, 0.1), Ok(0));
    }

    #[test]
    fn an_end_that_cannot_be_reached_is_refused() {
        assert_eq!(steps_until(0.0, -1.0, 0.1), Err(Error::Span { start: 0.0, end: -1.0 }));
        assert_eq!(steps_until(1e17, 1.5e17, 0.1), Err(Error::EndTime { end: 1.5e17, dt: 0.1 }));
        let still = Error::TimeStandsStill { time: 1e17 + 160.0, dt: 0.1, next: 16.0 };
        assert_eq!(steps_until(1e17, 1e17 + 160.0, 0.1), Err(still));
        assert_eq!(steps_until(1e17, 1e17 + 3200.0, 32.0), Ok(100));
        let possible = |steps| possible(steps, 0.0, 0.1, Some(f64::EPSILON));
        assert!(possible(u64::MAX).is_err() && possible(1 << 51).is_ok());
        // Of steps so long that the end is no number.
        let endless = Err(Error::EndTime { end: f64::INFINITY, dt: 1e308 });
        assert_eq!(super::possible(2, 0.0, 1e308, Some(f64::EPSILON)), endless);
    }
}
