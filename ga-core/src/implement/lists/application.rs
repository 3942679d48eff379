//! Versors applied to elements: by products, by the sandwich, by duality.

/// Sandwiches computed as two products, of which only the result's blades are kept.
#[doc(hidden)]
#[macro_export]
macro_rules! composed_sandwich {
    ($Versor:ident even: $($Operand:ident => $Result:ident $doc:literal),*) => {$(
        $crate::composed_sandwich! { @one $Versor $Operand $Result false $doc }
    )*};
    ($Versor:ident odd: $($Operand:ident => $Result:ident $doc:literal),*) => {$(
        $crate::composed_sandwich! { @one $Versor $Operand $Result true $doc }
    )*};
    (@one $Versor:ident $Operand:ident $Result:ident $odd:literal $doc:literal) => {
        impl<T: $crate::Field> $crate::ops::Sandwich<$Operand<T>> for $Versor<T> {
            type Output = $Result<T>;
            #[doc = $doc]
            #[inline]
            fn sandwich(self, x: $Operand<T>) -> $Result<T> {
                let back = $crate::ops::Reverse::reverse(self);
                let image = $crate::ops::Geometric::geometric(self, x);
                let image = $crate::ops::Geometric::geometric(image, back);
                $crate::convert::image::<_, $Operand<T>, _>(image, $odd)
            }
        }
    };
}

/// Versor application by way of the sandwich.
#[doc(hidden)]
#[macro_export]
macro_rules! application {
    ($Versor:ident unit: $($Operand:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::Apply<$Operand<T>> for $Versor<T> {
            type Output = <$Versor<T> as $crate::ops::Sandwich<$Operand<T>>>::Output;
            #[doc = $doc]
            #[inline]
            fn apply(self, x: $Operand<T>) -> Self::Output {
                $crate::ops::Sandwich::sandwich(self, x)
            }
        }
    )*};
    ($Versor:ident divided: $($Operand:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::Apply<$Operand<T>> for $Versor<T> {
            type Output = <$Versor<T> as $crate::ops::Sandwich<$Operand<T>>>::Output;
            #[doc = $doc]
            #[inline]
            fn apply(self, x: $Operand<T>) -> Self::Output {
                let factor = T::ONE / $crate::ops::NormSquared::norm_squared(self);
                $crate::ops::Sandwich::sandwich(self, x) * factor
            }
        }
    )*};
}

/// Versor application handed on by duality: the pseudoscalar passes through versors, so that
/// `(V I)[x] = V[x̂]` and `V[x I] = ±V[x] I`, minus for odd versors.
#[doc(hidden)]
#[macro_export]
macro_rules! dual_application {
    ($Versor:ident: $($form:ident $Operand:ident => $Output:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::Apply<$Operand<T>> for $Versor<T> {
            type Output = $Output<T>;
            #[doc = $doc]
            #[inline]
            fn apply(self, x: $Operand<T>) -> $Output<T> {
                $crate::dual_application!(@$form self x)
            }
        }
    )*};
    (@versor $v:ident $x:ident) => {
        $v.dual().apply($x)
    };
    (@minus_versor $v:ident $x:ident) => {
        -$v.dual().apply($x)
    };
    (@involuted_versor $v:ident $x:ident) => {
        $v.dual().apply($x.involute())
    };
    (@operand $v:ident $x:ident) => {
        $v.apply($x.dual()).undual()
    };
    (@minus_operand $v:ident $x:ident) => {
        -$v.apply($x.dual()).undual()
    };
}
