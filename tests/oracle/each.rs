//! Lists of types spelled out: all types of an algebra, and all ordered pairs of them.

/// An oracle for a generated module, given by its metric and a list of its types.
macro_rules! oracle {
    ($module:ident $metric:expr, units $units:expr, [$($Type:ident)*]) => {{
        type Q = ga::core::Rational;
        let kinds = vec![$(crate::kind::Kind::of::<$module::$Type<Q>>()),*];
        crate::reference::Oracle::new(&$metric, &$units, kinds)
    }};
}

/// `each_type!(oracle, module, [A B], check)` calls `check!(oracle, module, A)` for every type.
macro_rules! each_type {
    ($oracle:ident, $module:ident, [$($Type:ident)*], $check:ident) => {
        $($check!($oracle, $module, $Type);)*
    };
}

/// `each_pair!(oracle, module, [A B], check)` calls `check!(oracle, module, A, B)` for every
/// ordered pair.
macro_rules! each_pair {
    ($oracle:ident, $module:ident, $types:tt, $check:ident) => {
        each_pair!(@rows $oracle, $module, $types, $types, $check)
    };
    (@rows $oracle:ident, $module:ident, [$($Type:ident)*], $all:tt, $check:ident) => {
        $(each_pair!(@row $oracle, $module, $Type, $all, $check);)*
    };
    (@row $oracle:ident, $module:ident, $Left:ident, [$($Right:ident)*], $check:ident) => {
        // A function per row keeps single functions small for the compiler.
        {
            #[inline(never)]
            fn row($oracle: &crate::reference::Oracle) {
                $($check!($oracle, $module, $Left, $Right);)*
            }
            row(&$oracle);
        }
    };
}
