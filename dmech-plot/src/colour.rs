//! Colours that stay apart for colour-blind readers and in print (P. Tol, "Colour schemes", SRON/EPS/TN/09-002, 2021).

use plotters::style::RGBColor;

/// Blue.
pub const BLUE: RGBColor = RGBColor(68, 119, 170);
/// Red.
pub const RED: RGBColor = RGBColor(204, 102, 119);
/// Green.
pub const GREEN: RGBColor = RGBColor(34, 136, 51);
/// Ochre.
pub const OCHRE: RGBColor = RGBColor(190, 150, 40);
/// Purple.
pub const PURPLE: RGBColor = RGBColor(136, 80, 150);
/// Dark grey: words, axes, what is not one of several.
pub const INK: RGBColor = RGBColor(70, 70, 70);
/// Teal.
pub const TEAL: RGBColor = RGBColor(0, 140, 150);
/// Light grey: what stands behind the rest.
pub const PALE: RGBColor = RGBColor(215, 215, 215);
