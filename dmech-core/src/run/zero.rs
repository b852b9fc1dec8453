//! A zero between two times.

/// More halvings than there are numbers between two of `f64`.
const MOST: u32 = 200;

/// The time of a zero between two times at which a function has values of different signs, to the rounding of the time: inverse
/// quadratic interpolation where three values promise that it is good, halving elsewhere. Where no time gives a zero, the first that is
/// known to lie behind it, so that a motion that goes on from there does not pass it again; or the one nearer to it.
///
/// # Reference
/// T. R. Chandrupatla, Adv. Eng. Softw. 28 (1997) 145–149.
pub(super) fn zero<E>(
    mut function: impl FnMut(f64) -> Result<f64, E>,
    [mut a, mut b]: [f64; 2],
    [mut fa, mut fb]: [f64; 2],
    nearer: bool,
) -> Result<f64, E> {
    let (rounding, before) = (f64::EPSILON * a.abs().max(b.abs()), fa > 0.0);
    // The first trial is that of a straight line.
    let mut share = fa / (fa - fb);
    if share.is_nan() {
        share = 0.5;
    }
    for _ in 0..MOST {
        let least = rounding / (b - a).abs();
        if fa == 0.0 || fb == 0.0 || least.is_nan() || least >= 1.0 {
            break;
        }
        let least = least.min(0.5);
        let time = share.clamp(least, 1.0 - least).mul_add(b - a, a);
        let value = function(time)?;
        // a is the newest, b lies on the other side of the zero, c is what fell away.
        let (c, fc);
        if (value > 0.0) == (fa > 0.0) {
            (c, fc) = (a, fa);
        } else {
            (c, fc) = (b, fb);
            (b, fb) = (a, fa);
        }
        (a, fa) = (time, value);
        let (along, rise) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
        let trusted = rise * rise < along && (1.0 - rise) * (1.0 - rise) < 1.0 - along;
        share = if trusted {
            fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        } else {
            0.5
        };
    }
    let first = if nearer {
        fa.abs() <= fb.abs()
    } else if fa == 0.0 || fb == 0.0 {
        fa == 0.0
    } else {
        (fa > 0.0) != before
    };
    Ok(if first { a } else { b })
}

#[cfg(test)]
mod tests {
    use super::zero;

    /// Simple, multiple and one-sided zeros, kinks, jumps and steep functions, at times large and small: within two roundings of
    /// the time, and in few evaluations where the function is smooth.
    #[test]
    fn zeros_are_found_to_the_rounding_of_the_time() {
        type Shape = (fn(f64) -> f64, usize);
        let shapes: [Shape; 8] = [
            (|x| x, 3),
            (|x| x.sin(), 8),
            (|x| x.exp_m1(), 9),
            (|x| x * x * x, 140),
            (|x| if x < 0.0 { x } else { 1e9 * x }, 110),
            (|x| if x < 0.0 { -1.0 } else { 1.0 }, 110),
            (|x| (1e6 * x).tanh(), 110),
            (|x| x.signum() * x.abs().sqrt(), 110),
        ];
        for (shape, most) in shapes {
            for origin in [0.0, 3.0, -1e3, 1e9] {
                for [below, above] in [[0.3, 0.7], [1e-3, 1.0], [0.9, 1e-6]] {
                    for sign in [1.0, -1.0] {
                        let ends = [origin - below, origin + above];
                        let mut count = 0;
                        let f = |t: f64| {
                            count += 1;
                            Ok::<_, ()>(sign * shape(t - origin))
                        };
                        let values = ends.map(|t| sign * shape(t - origin));
                        let found = zero(f, ends, values, false).unwrap();
                        let rounding = 2.0 * f64::EPSILON * origin.abs().max(ends[0].abs()).max(ends[1].abs());
                        assert!((found - origin).abs() <= rounding, "{origin} {found}");
                        let [value, end] = [found, ends[1]].map(|t| sign * shape(t - origin));
                        assert!(value == 0.0 || value.is_sign_positive() == end.is_sign_positive(), "{origin} {found}");
                        assert!(count <= most, "{count} evaluations");
                    }
                }
            }
        }
    }
}
