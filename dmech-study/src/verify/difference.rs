//! Derivatives from values.

/// A derivative from values alone, and how far it may be off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Estimate {
    pub(super) value: f64,
    pub(super) error: f64,
}

const ROWS: usize = 10;

/// f′(x) by central differences of steps h, h/2, h/4, … extrapolated to zero (Richardson).
///
/// The error is that of the tableau: the largest distance of an entry from the two that it came from, the entry being
/// that where this distance is least (C. Ridders, Adv. Eng. Softw. 4 (1982) 75). It cannot see an error of rounding
/// that neighbours share, so that ε|f|/h at the step in use is added: the condition of the quotient, with `size` in place of a
/// smaller |f| that is a sum of parts of that size. Steps are what x ± h
/// are after rounding; a quotient by 2h would magnify that rounding by x/h.
///
/// On a kink central differences have the mean of both sides, to all digits: there the error is infinite.
pub(super) fn derivative(f: impl Fn(f64) -> f64, x: f64, h: f64, size: f64) -> Estimate {
    let mut table = [[0.0; ROWS]; ROWS];
    let mut best = Estimate { value: f64::NAN, error: f64::INFINITY };
    let (middle, mut bends) = (f(x), [0.0; ROWS]);
    let mut step = h;
    for row in 0..ROWS {
        let (right, left) = (x + step, x - step);
        let (plus, minus) = (f(right), f(left));
        let noise = f64::EPSILON * (plus.abs() + minus.abs()).max(2.0 * size) / step;
        table[row][0] = (plus - minus) / (right - left);
        let bend = (plus - middle) / (right - x) - (middle - minus) / (x - left);
        bends[row] = if bend.abs() > 16.0 * noise { bend } else { 0.0 };
        let mut factor = 1.0;
        for k in 1..=row {
            factor *= 4.0;
            table[row][k] = table[row][k - 1] + (table[row][k - 1] - table[row - 1][k - 1]) / (factor - 1.0);
            let spread = (table[row][k] - table[row][k - 1]).abs().max((table[row][k] - table[row - 1][k - 1]).abs());
            if spread + noise < best.error {
                best = Estimate { value: table[row][k], error: spread + noise };
            }
        }
        step *= 0.5;
    }
    if is_kink(bends) { Estimate { error: f64::INFINITY, ..best } } else { best }
}

/// Whether the slopes on both sides stay apart as the steps become small; otherwise what they differ by is halved with the step.
fn is_kink(bends: [f64; ROWS]) -> bool {
    let [.., before, last] = bends;
    last != 0.0 && (0.75..1.5).contains(&(last / before))
}

/// Compares derivatives with their estimates and remembers the worst.
#[derive(Clone, Copy, Debug)]
pub(super) struct Worst {
    /// Deviation and tolerance, both relative to the size of the derivatives.
    pub(super) measured: f64,
    pub(super) bound: f64,
    pub(super) compared: usize,
}

impl Worst {
    pub(super) fn new() -> Self {
        Worst { measured: 0.0, bound: 1.0, compared: 0 }
    }

    /// `scale` is the size of the derivatives around. The tolerance is sixteen times the error of the estimate, which
    /// is itself an estimate, and as many units of rounding in the derivative; an estimate too poor to tell a wrong
    /// derivative from a right one (tolerance above 10⁻⁴) is not compared.
    pub(super) fn compare(&mut self, exact: f64, estimate: Estimate, scale: f64) {
        let bound = 16.0 * (estimate.error / scale + f64::EPSILON);
        let measured = (exact - estimate.value).abs() / scale;
        if exact.is_finite() && (!bound.is_finite() || bound > 1e-4) {
            return;
        }
        self.compared += 1;
        // A NaN is the worst of all and stays.
        let (new, worst) = (measured / bound, self.measured / self.bound);
        if new.is_nan() || new > worst {
            (self.measured, self.bound) = (measured, bound);
        }
    }
}
