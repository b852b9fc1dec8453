//! Axes of any range: no panic, no endless loop, every mark inside of the picture.

use dmech_plot::{Axis, BLUE, Fit, chart, dashed, dots, draw, equal_axes, label, label_beside, line, number, rings};

const ODD: [f64; 22] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1.0 + f64::EPSILON,
    1e-20,
    -1e-20,
    3e-16,
    1e20,
    1e20 + 1e5,
    -1e20,
    5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    1e300,
    -4e307,
    12345.678,
    350.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
];

/// The numbers of every attribute that is a place.
fn places(svg: &str) -> Vec<f64> {
    let named = [" x=\"", " y=\"", " cx=\"", " cy=\"", " x1=\"", " y1=\"", " x2=\"", " y2=\""];
    let values = named.into_iter().flat_map(|name| svg.split(name).skip(1));
    values.map(|rest| rest.split('"').next().unwrap().parse().unwrap()).collect()
}

#[test]
fn axes_of_any_range_are_drawn() {
    for from in ODD {
        for to in ODD {
            let kinds: [fn(f64, f64) -> [Axis<'static>; 2]; 3] = [
                |from, to| [Axis::linear("x", from..to), Axis::linear("y", 0.0..1.0)],
                |from, to| [Axis::linear("x", 0.0..1.0), Axis::linear("y", from..to)],
                |from, to| [Axis::powers_of_ten("x", from..to), Axis::powers_of_ten("y", to..from)],
            ];
            for axes in kinds {
                let [x, y] = axes(from, to);
                let svg = draw([300, 200], |area| chart(area, "Any", x, y, 20).map(drop)).unwrap();
                let most = 1200.0;
                assert!(places(&svg).iter().all(|x| (0.0..=most).contains(x)), "{from:e}..{to:e}: {:?}", places(&svg));
                assert!(svg.contains("Any") && !svg.contains("NaN") && !svg.contains("inf"), "{from:e}..{to:e}");
            }
            let [x, y] = [Axis::linear("x", from..to), Axis::linear("y", to..from)];
            draw([300, 200], |area| equal_axes(area, "Any", x, y, 20).map(drop)).unwrap();
        }
    }
}

/// Points that are not finite are left out of all that is drawn.
#[test]
fn points_of_any_size_are_drawn() {
    let svg = draw([300, 200], |area| {
        let mut chart = chart(area, "Any", Axis::linear("x", 0.0..1.0), Axis::linear("y", 0.0..1.0), 20)?;
        let lost = [(0.2, 0.2), (f64::NAN, 0.5), (0.4, f64::INFINITY), (0.6, 0.4), (f64::NEG_INFINITY, f64::NAN)];
        line(&mut chart, lost.to_vec(), BLUE, 1.5)?;
        dashed(&mut chart, lost.to_vec(), BLUE, 1.5)?;
        dots(&mut chart, &lost, BLUE, 3.0)?;
        rings(&mut chart, &lost, BLUE, 3.0)?;
        line(&mut chart, Vec::new(), BLUE, 1.5)?;
        label(&chart, (0.5, 0.5), (4, 0), "words", BLUE)?;
        label_beside(&chart, &[lost.to_vec()], &[((0.2, 0.2), "more words".to_owned(), BLUE)])
    })
    .unwrap();
    assert_eq!(svg.matches("<circle").count(), 4);
    assert!(svg.contains("more words") && !svg.contains("NaN"));
}

/// Whatever two values there are, they stand within the range of their axis, apart if it is more than rounding that parts them.
#[test]
fn values_fit_on_their_axis() {
    for a in ODD {
        for b in ODD {
            let fit = Fit::of([a, b]);
            let range = fit.range(0.05);
            assert!(
                range.start < range.end && range.start.is_finite() && range.end.is_finite(),
                "{a:e} {b:e} {range:?}"
            );
            for x in [a, b].into_iter().filter(|x| x.is_finite()) {
                assert!(range.contains(&fit.at(x)), "{x:e} of {a:e}, {b:e}: {} in {range:?}", fit.at(x));
            }
            if a.is_finite() && b.is_finite() && (a - b).abs() > 1e-6 * a.abs().max(b.abs()) && (a - b).abs() > 1e-300 {
                let part = (fit.at(a) - fit.at(b)).abs() / (range.end - range.start);
                assert!(part > 0.8, "{a:e} and {b:e} are {part} of the axis apart");
            }
            assert!(!fit.name("x").contains("NaN"));
        }
    }
}

/// A number that is printed is the number.
#[test]
fn numbers_are_printed_in_full() {
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";
    let lowered =
        |raised: char| RAISED.chars().zip("0123456789-".chars()).find_map(|(c, low)| (c == raised).then_some(low));
    for x in ODD {
        let text = number(x).replace('−', "-");
        let power: String = text.chars().filter_map(lowered).collect();
        let plain = text.trim_end_matches(|c| RAISED.contains(c));
        let plain = match (power.as_str(), plain.strip_suffix("10").unwrap_or_default().trim_end_matches('·')) {
            ("", _) => plain.to_owned(),
            (power, "") => format!("1e{power}"),
            (power, "-") => format!("-1e{power}"),
            (power, mantissa) => format!("{mantissa}e{power}"),
        };
        let back: f64 = plain.parse().unwrap();
        assert!(back == x || x.is_nan(), "{x:e} is printed {text}");
    }
}
