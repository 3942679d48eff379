//! The same rotation, motion, vector in the types of each of the other libraries.

/// The conversions over one type of numbers, given the types that the libraries have for it.
macro_rules! conversions {
    (
        $module:ident $float:ident
        $Quat:ident $GlamVec:ident $Affine:ident $Mat4:ident
        $Rotor:ident $Bivec:ident $UltraVec:ident $Isometry:ident
    ) => {
        /// Data over these numbers.
        pub mod $module {
            use ga_benches::data::Motion;

            /// A number.
            pub fn number(x: f64) -> $float {
                x as $float
            }

            /// The rotation by nalgebra.
            pub fn quaternion(q: &[f64; 4]) -> nalgebra::UnitQuaternion<$float> {
                let [w, x, y, z] = q.map(number);
                nalgebra::UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(w, x, y, z))
            }

            /// The vector by nalgebra.
            pub fn column(x: &[f64; 3]) -> nalgebra::Vector3<$float> {
                nalgebra::Vector3::from(x.map(number))
            }

            /// The point by nalgebra.
            pub fn point(x: &[f64; 3]) -> nalgebra::Point3<$float> {
                nalgebra::Point3::from(x.map(number))
            }

            /// The motion by nalgebra.
            pub fn isometry(motion: &Motion) -> nalgebra::Isometry3<$float> {
                let translation = nalgebra::Translation3::from(column(&motion.translation));
                nalgebra::Isometry3::from_parts(translation, quaternion(&motion.rotation))
            }

            /// The motion by nalgebra, as a dual quaternion.
            pub fn dual_quaternion(motion: &Motion) -> nalgebra::UnitDualQuaternion<$float> {
                nalgebra::UnitDualQuaternion::from_isometry(&isometry(motion))
            }

            /// The rotation by glam.
            pub fn quat(q: &[f64; 4]) -> glam::$Quat {
                let [w, x, y, z] = q.map(number);
                glam::$Quat::from_xyzw(x, y, z, w)
            }

            /// The vector by glam.
            pub fn vec(x: &[f64; 3]) -> glam::$GlamVec {
                glam::$GlamVec::from(x.map(number))
            }

            /// The motion by glam.
            pub fn affine(motion: &Motion) -> glam::$Affine {
                let rotation = quat(&motion.rotation);
                glam::$Affine::from_rotation_translation(rotation, vec(&motion.translation))
            }

            /// The motion by glam, as a 4×4 matrix.
            pub fn matrix(motion: &Motion) -> glam::$Mat4 {
                let rotation = quat(&motion.rotation);
                glam::$Mat4::from_rotation_translation(rotation, vec(&motion.translation))
            }

            /// The rotation by ultraviolet, whose bivectors are e₁₂, e₁₃, e₂₃.
            pub fn ultra_rotor(q: &[f64; 4]) -> ultraviolet::$Rotor {
                let [w, x, y, z] = q.map(number);
                ultraviolet::$Rotor::new(w, ultraviolet::$Bivec::new(-z, y, -x))
            }

            /// The vector by ultraviolet.
            pub fn ultra_vec(x: &[f64; 3]) -> ultraviolet::$UltraVec {
                ultraviolet::$UltraVec::from(x.map(number))
            }

            /// The motion by ultraviolet.
            pub fn ultra_isometry(motion: &Motion) -> ultraviolet::$Isometry {
                let rotation = ultra_rotor(&motion.rotation);
                ultraviolet::$Isometry::new(ultra_vec(&motion.translation), rotation)
            }

            /// Coordinates to be compared.
            pub fn view<const N: usize>(x: [$float; N]) -> Vec<f64> {
                x.map(f64::from).to_vec()
            }
        }
    };
}

conversions!(single f32 Quat Vec3 Affine3A Mat4 Rotor3 Bivec3 Vec3 Isometry3);
conversions!(double f64 DQuat DVec3 DAffine3 DMat4 DRotor3 DBivec3 DVec3 DIsometry3);
