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
            assert!(((back - x) / x).hi().abs() < 1e-30, "{x:?}: {text}, {back:?}");
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
