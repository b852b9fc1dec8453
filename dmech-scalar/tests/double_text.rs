//! Double-double numbers in decimal digits.

mod exact;
mod uniform;
mod wide;

use dmech_scalar::DoubleDouble;
use uniform::Uniform;
use wide::{exact_value, filled, magnitude};

#[test]
fn digits_are_written_and_read() {
    let read = |text: &str| text.parse::<DoubleDouble>();
    let mut uniform = Uniform(5);
    for _ in 0..1000 {
        let x = magnitude(&mut uniform, 1e-40, 1e40);
        let x = filled(&mut uniform, x);
        for text in [x.to_string(), format!("{x:e}")] {
            let back = read(&text).unwrap();
            assert_eq!((back.hi(), back.lo()), (x.hi(), x.lo()), "{x:?}: {text}, {back:?}");
            assert!(text.len() < 50, "{text}");
        }
        // Against the digits of dashu, which rounds half to even where this rounds half up.
        let exact = exact_value(x).to_decimal().value().with_precision(20).value().to_string();
        let ours = read(&exact).unwrap();
        assert!(((ours - x) / x).hi().abs() < 1e-19, "{exact}");
    }
    let shown = [("1", "1"), ("-0.5", "-0.5"), ("0.1", "0.1"), ("1e40", "1e40"), ("123456789e-30", "1.23456789e-22")];
    for (text, expected) in shown {
        assert_eq!(read(text).unwrap().to_string(), expected);
    }
    let x = read("2.99999999999999999999999999").unwrap();
    assert_eq!((format!("{x:.3}"), format!("{x:.26}")), ("3.000".into(), "2.99999999999999999999999999".into()));
    assert_eq!((format!("{x:.4e}"), format!("{:9.2}|", -x)), ("3.0000e0".into(), "    -3.00|".into()));
    assert_eq!(
        format!("{:.1} {:.1} {:.0}", read("0.04").unwrap(), read("0.06").unwrap(), read("9.7").unwrap()),
        "0.0 0.1 10"
    );
    assert_eq!(format!("{} {}", DoubleDouble::from(f64::NAN), DoubleDouble::from(-f64::INFINITY)), "NaN -inf");
    for text in ["", "x", "1e", "1.2.3", "0x10", "--1"] {
        assert!(read(text).is_err(), "{text}");
    }
    assert_eq!(read("inf").unwrap().hi(), f64::INFINITY);
    assert_eq!(read("1e999").unwrap().hi(), f64::INFINITY);
    assert_eq!(read(&format!("{}", DoubleDouble::from(1e-320))).unwrap().hi(), 1e-320);
}

/// Parts far from one another, at the ends of the range, and of both signs: the same two parts come back.
#[test]
fn every_number_reads_back_as_itself() {
    let read = |x: DoubleDouble| [x.to_string(), format!("{x:e}")].map(|text| text.parse::<DoubleDouble>().unwrap());
    let parts = [
        (1.0, 1e-300),
        (-1.0, 1e-40),
        (0.1, 1e-25),
        (1e308, 1e290),
        (1e-300, -1e-318),
        (5e-324, 0.0),
        (-1.5e16, 1.0),
        (1.0, 2f64.powi(-53)),
        (2.0, -2f64.powi(-53)),
        (f64::MAX, -1.0),
    ];
    for (hi, lo) in parts {
        let x = DoubleDouble::from(hi) + DoubleDouble::from(lo);
        for back in read(x) {
            assert_eq!((back.hi(), back.lo()), (x.hi(), x.lo()), "{x}");
        }
    }
    let mut uniform = Uniform(11);
    for _ in 0..2000 {
        let x = magnitude(&mut uniform, 1e-290, 1e300);
        let x = filled(&mut uniform, x);
        for back in read(-x) {
            assert_eq!((back.hi(), back.lo()), (-x.hi(), -x.lo()), "{x}");
        }
    }
}
