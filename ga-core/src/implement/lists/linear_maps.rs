//! The matrices of versors on types, given by the pattern of their entries.

/// Matrices: for each type of the operand the type of its multiples and the number of its fields,
/// from how many elements on the matrix is worthwhile, and the rows. A row is a field of the result
/// and the fields of the operand that it depends on, by position; with `+` it has a constant
/// besides, the image of the fixed coefficients.
#[doc(hidden)]
#[macro_export]
macro_rules! linear_maps {
    ($Versor:ident: $($Operand:ident in $Linear:ident $fields:literal => $Output:ident $least:tt {
        $($row:ident $sign:tt [$($column:tt)*])*
    })*) => {$(
        impl<T: $crate::Field> $crate::ops::Outermorphism<$Operand<T>> for $Versor<T> {
            type Rows = $crate::linear_maps!(@rows $([$sign $($column)*])*);
            const WORTHWHILE: ::core::option::Option<usize> = $crate::linear_maps!(@least $least);
            $crate::inlined! {
                fn rows_with(self, w: <Self as $crate::ops::Versor>::Multiple) -> Self::Rows {
                    let (fixed, columns) = $crate::linear_map::columns::<
                        _, $Operand<T>, $Linear<T>, $Output<T>, $fields,
                    >(self, w);
                    ($($crate::linear_maps!(@entries $row $sign fixed columns $($column)*),)*)
                }
            }
            $crate::inlined! {
                fn image(rows: &Self::Rows, x: $Operand<T>) -> $Output<T> {
                    let x: [T; $fields] = x.to_array();
                    let ($($row,)*) = rows;
                    $Output { $($row: $crate::linear_maps!(@sum $row $sign x $($column)*)),* }
                }
            }
        }
    )*};
    (@least 0) => {
        ::core::option::Option::None
    };
    (@least $least:tt) => {
        ::core::option::Option::Some($least)
    };
    (@rows $([$sign:tt $($column:tt)*])*) => {
        ($([T; $crate::linear_maps!(@size $sign $($column)*)],)*)
    };
    (@size + $($column:tt)*) => {
        1 + $crate::linear_maps!(@count $($column)*)
    };
    (@size - $($column:tt)*) => {
        $crate::linear_maps!(@count $($column)*)
    };
    (@count $($column:tt)*) => {
        <[usize]>::len(&[$($column),*])
    };
    (@entries $row:ident + $fixed:ident $columns:ident $($column:tt)*) => {
        [$fixed.$row, $($columns[$column].$row),*]
    };
    (@entries $row:ident - $fixed:ident $columns:ident $($column:tt)*) => {
        [$($columns[$column].$row),*]
    };
    (@sum $row:ident + $x:ident $($column:tt)*) => {
        $crate::linear_map::affine($row, &[$($x[$column]),*])
    };
    (@sum $row:ident - $x:ident $($column:tt)*) => {
        $crate::linear_map::linear($row, &[$($x[$column]),*])
    };
}

/// Matrices of versors and of operands that are the duals of others with a matrix, in the forms of
/// [`dual_application`](crate::dual_application), each with the type of the dual.
#[doc(hidden)]
#[macro_export]
macro_rules! dual_linear_maps {
    ($Versor:ident $sign:tt: $($form:ident $image:tt $Operand:ident $Dual:ident => $Output:ident),*) => {$(
        $crate::dual_linear_maps! { @$form $Versor $sign $image $Operand $Dual => $Output }
    )*};
    (@operand $Versor:ident $sign:tt $image:tt $Operand:ident $Dual:ident => $Output:ident) => {
        impl<T: $crate::Field> $crate::ops::Outermorphism<$Operand<T>> for $Versor<T> {
            type Rows = <$Versor<T> as $crate::ops::Outermorphism<$Dual<T>>>::Rows;
            const WORTHWHILE: ::core::option::Option<usize> =
                <$Versor<T> as $crate::ops::Outermorphism<$Dual<T>>>::WORTHWHILE;
            $crate::inlined! {
                fn rows_with(self, w: <Self as $crate::ops::Versor>::Multiple) -> Self::Rows {
                    <$Versor<T> as $crate::ops::Outermorphism<$Dual<T>>>::rows_with(self, w)
                }
            }
            $crate::inlined! {
                fn image(rows: &Self::Rows, x: $Operand<T>) -> $Output<T> {
                    let image =
                        <$Versor<T> as $crate::ops::Outermorphism<$Dual<T>>>::image(rows, x.dual());
                    $crate::signed!($image image.undual())
                }
            }
        }
    };
    (@involuted $Versor:ident $sign:tt $image:tt $Operand:ident $Dual:ident => $Output:ident) => {
        $crate::dual_linear_maps! { @by involute $Versor $sign $image $Operand $Dual => $Output }
    };
    (@versor $Versor:ident $sign:tt $image:tt $Operand:ident $Dual:ident => $Output:ident) => {
        $crate::dual_linear_maps! { @by into $Versor $sign $image $Operand $Dual => $Output }
    };
    (@by $step:ident $Versor:ident $sign:tt $image:tt $Operand:ident $Dual:ident => $Output:ident) => {
        impl<T: $crate::Field> $crate::ops::Outermorphism<$Operand<T>> for $Versor<T> {
            type Rows = <$Dual<T> as $crate::ops::Outermorphism<$Operand<T>>>::Rows;
            const WORTHWHILE: ::core::option::Option<usize> =
                <$Dual<T> as $crate::ops::Outermorphism<$Operand<T>>>::WORTHWHILE;
            $crate::inlined! {
                fn rows_with(self, w: <Self as $crate::ops::Versor>::Multiple) -> Self::Rows {
                    let w = $crate::signed!($sign w.dual());
                    <$Dual<T> as $crate::ops::Outermorphism<$Operand<T>>>::rows_with(self.dual(), w)
                }
            }
            $crate::inlined! {
                fn image(rows: &Self::Rows, x: $Operand<T>) -> $Output<T> {
                    let x: $Operand<T> = x.$step();
                    let image = <$Dual<T> as $crate::ops::Outermorphism<$Operand<T>>>::image(rows, x);
                    $crate::signed!($image image)
                }
            }
        }
    };
}
