//! The one declaration that the conformal model is generated from.

ga_macros::define_algebra! {
    /// Conformal geometric algebra of Euclidean 3-space.
    pub mod cga3: R4_1 {
        basis { e1, e2, e3, no, ni }
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, no.ni = -1 }
        types {
            Vector3 { e1, e2, e3 }
            Bivector3 { e12, e13, e23 }
            Trivector3 { e123 }
            Point { no = 1, e1, e2, e3, ni }
            DualSphere { no, e1, e2, e3, ni }
            DualPlane { e1, e2, e3, ni }
            PointPair = grade 2;
            FlatPoint { e1^ni, e2^ni, e3^ni, no^ni }
            DirectionVector { e1^ni, e2^ni, e3^ni }
            TangentVector { e1^no, e2^no, e3^no }
            DualLine { e12, e13, e23, e1^ni, e2^ni, e3^ni }
            MinkowskiPlane { no^ni }
            Circle = grade 3;
            Line { e12^ni, e13^ni, e23^ni, e1^no^ni, e2^no^ni, e3^no^ni }
            DirectionBivector { e12^ni, e13^ni, e23^ni }
            TangentBivector { e12^no, e13^no, e23^no }
            Sphere = grade 4;
            Plane { e123^ni, e12^no^ni, e13^no^ni, e23^no^ni }
            DirectionTrivector { e123^ni }
            TangentTrivector { e123^no }
            Pseudoscalar { e123^no^ni }
            #[unit] Rotor { 1, e12, e13, e23 }
            #[unit] Translator { 1 = 1, e1^ni, e2^ni, e3^ni }
            #[unit] Motor { 1, e12, e13, e23, e1^ni, e2^ni, e3^ni, e123^ni }
            #[unit] Dilator { 1, no^ni }
            #[unit] Transversor { 1 = 1, e1^no, e2^no, e3^no }
        }
    }
}
