//! Functions that add to what they are given, as those of nothing and of two terms.

/// Nothing is added.
macro_rules! of_nothing {
    ($($(#[$how:meta])? $name:ident $(<const $k:ident: usize>)? ($($x:ident: $t:ty),*);)*) => {$(
        fn $name $(<const $k: usize>)? (&self, $(_: $t),*) {}
    )*};
}

/// The first adds, then the second.
macro_rules! of_both {
    ($($(#[$how:meta])? $name:ident $(<const $k:ident: usize>)? ($($x:ident: $t:ty),*);)*) => {$(
        $(#[$how])?
        fn $name $(<const $k: usize>)? (&self, $($x: $t),*) {
            self.0.$name($($x),*);
            self.1.$name($($x),*);
        }
    )*};
}

pub(super) use {of_both, of_nothing};
