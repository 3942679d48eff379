//! Why an operation misses its goal where it does, and what was tried: printed below a table for
//! the rows that miss.

/// What is to be said of an operation; nothing of most.
pub fn remark(operation: &str) -> Option<&'static str> {
    Some(match operation {
        "rotor·rotor" => {
            "the product is one and the same, 16 multiplications; a loop over structs is \
             vectorised as the compiler likes, glam's f32 quaternion by hand; by slices it is in \
             lanes"
        }
        "motor·motor" => {
            "a motor has 48 multiplications for 8 numbers, an isometry of quaternion and vector 31 \
             for 7, glam's matrix is multiplied in vectors by hand; tried for the loop: sums in the \
             order of the left and of the right factor, signs on either factor, no fused \
             operations, of which none reaches the others; by slices several products are \
             computed at a time"
        }
        "motor-on-point" => {
            "a matrix has 9 multiplications for a point, a motor 18, and glam's columns are vectors \
             by type; it has twice the size of a motor, and has to be made of the motion first; by \
             slices motors are in lanes"
        }
        _ => return None,
    })
}
