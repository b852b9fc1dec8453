//! Between the steps of a ladder.

/// What an error costs, in time or in forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cost {
    /// Between two steps of the ladder.
    About(f64),
    /// That of the largest step.
    AtMost(f64),
}

impl Cost {
    /// In the unit of the costs that were given.
    pub fn value(self) -> f64 {
        match self {
            Cost::About(cost) | Cost::AtMost(cost) => cost,
        }
    }
}

/// The cost at which an error is reached, from positive (error, cost) in the order of falling steps: linear in the
/// logarithms.
///
/// Of several pairs of neighbours that enclose the error the one with the smallest steps is taken, as a single small
/// error among large ones is chance; or a run with smaller steps, if that costs less, as where larger steps have to be tried
/// in parts. Where the error is reached with every step, the least cost is an upper bound, and is returned; where it is not
/// reached, there is no cost.
///
/// A [`Study`](crate::Study) measures with it; it serves as well for runs of other programs beside one.
///
/// ```
/// use dmech_study::study::{Cost, cost_at};
/// // Order 4: a tenth of the step, a ten-thousandth of the error.
/// let runs = [(1e-2, 1.0), (1e-6, 10.0), (1e-10, 100.0)];
/// assert!((cost_at(1e-4, &runs).unwrap().value() - 10_f64.sqrt()).abs() < 1e-12);
/// assert_eq!(cost_at(0.1, &runs), Some(Cost::AtMost(1.0)));
/// assert_eq!(cost_at(1e-12, &runs), None);
/// ```
pub fn cost_at(error: f64, points: &[(f64, f64)]) -> Option<Cost> {
    let cheapest = |runs: &[(f64, f64)]| runs.iter().map(|run| run.1).reduce(f64::min);
    let encloses = |pair: &[(f64, f64)]| pair[0].0 > error && pair[1].0 <= error;
    let Some(first) = points.windows(2).rposition(encloses) else {
        return cheapest(points).filter(|_| points[0].0 <= error).map(Cost::AtMost);
    };
    let [(e0, c0), (e1, c1)] = [points[first], points[first + 1]].map(|(e, c)| (e.ln(), c.ln()));
    let between = (c0 + (c1 - c0) * (error.ln() - e0) / (e1 - e0)).exp();
    let reached = &points[first + 1..];
    let reached = &reached[..reached.iter().position(|run| run.0 > error).unwrap_or(reached.len())];
    cheapest(reached).map(|cost| Cost::About(cost.min(between)))
}

#[cfg(test)]
mod tests {
    use super::{Cost, cost_at};

    /// cost = 3 error^(−1/4) is a line in the logarithms.
    #[test]
    fn a_power_law_comes_back() {
        let cost = |error: f64| 3.0 * error.powf(-0.25);
        let points: Vec<_> = [1e-1, 2e-4, 3e-7, 5e-9].map(|e| (e, cost(e))).into();
        for error in [1e-2, 1e-3, 1e-6, 3e-7, 1e-8] {
            let found = cost_at(error, &points).unwrap().value();
            assert!((found / cost(error) - 1.0).abs() < 1e-13, "{error}: {found}");
        }
        assert_eq!(cost_at(0.5, &points), Some(Cost::AtMost(points[0].1)));
        assert_eq!(cost_at(1e-9, &points), None);
        assert_eq!(cost_at(1e-3, &[]), None);
    }

    /// A lucky large step does not count, nor does rounding at the end take back what was reached.
    #[test]
    fn chance_and_rounding_do_not_count() {
        let points = [(1e-7, 1.0), (1e-2, 2.0), (1e-4, 4.0), (1e-6, 8.0), (3e-6, 16.0)];
        assert!((cost_at(1e-5, &points).unwrap().value() - 32_f64.sqrt()).abs() < 1e-13);
        // All steps reach it, the third for the least.
        assert_eq!(cost_at(0.1, &points), Some(Cost::AtMost(1.0)));
        let tried = [(5e-12, 7.8), (2e-13, 6.9), (6e-12, 3.4), (1e-13, 3.0), (7e-14, 3.6)];
        assert_eq!(cost_at(1e-11, &tried), Some(Cost::AtMost(3.0)));
        assert_eq!(cost_at(1e-13, &tried), Some(Cost::About(3.0)));
        // exp ∘ ln costs a few ulps.
        assert!((cost_at(1e-6, &points).unwrap().value() / 8.0 - 1.0).abs() < 8.0 * f64::EPSILON);
    }
}
