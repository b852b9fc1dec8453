//! Sets of coefficients.

/// Declares a set, called in reports as it is here: the lists are as long as it has stages or kicks.
///
/// One at a time, so that the documentation of each leads to its own numbers.
macro_rules! set {
    (
        $(#[$about:meta])*
        pub struct $name:ident: $kind:ident<$n:literal>, order $order:literal $(, turn $turn:literal, first $first:ident)?;
        $($list:ident = $value:expr;)+
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct $name;

        #[allow(clippy::excessive_precision, reason = "the digits of the source")]
        impl $kind<$n> for $name {
            const NAME: &'static str = stringify!($name);
            const ORDER: u32 = $order;
            $(
                const TURN: f64 = $turn;
                const FIRST: First = First::$first;
            )?
            $(const $list: [f64; $n] = $value;)+
        }
    };
}
pub(crate) use set;
