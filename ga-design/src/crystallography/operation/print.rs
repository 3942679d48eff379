//! How an operation is spelled: coordinate triplets as International Tables print them.

use std::fmt;

use num_rational::Ratio;

use super::Operation;

/// `x,y,z` with the variables first and the fraction last: `-y+1/2,x-y,z+1/3`.
impl fmt::Display for Operation {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let translation = self.translation();
        for (place, (row, shift)) in self.rotation.iter().zip(translation).enumerate() {
            if place > 0 {
                out.write_str(",")?;
            }
            write_component(out, row, shift)?;
        }
        Ok(())
    }
}

fn write_component(out: &mut fmt::Formatter<'_>, row: &[i32; 3], shift: Ratio<i32>) -> fmt::Result {
    let mut first = true;
    for (factor, axis) in row.iter().zip(["x", "y", "z"]) {
        match *factor {
            0 => continue,
            1 if first => out.write_str(axis)?,
            1 => write!(out, "+{axis}")?,
            -1 => write!(out, "-{axis}")?,
            other if first => write!(out, "{other}{axis}")?,
            other => write!(out, "{other:+}{axis}")?,
        }
        first = false;
    }
    // A row of an invertible matrix is never zero, so a variable always stands before the sign.
    if *shift.numer() != 0 {
        write!(out, "+{shift}")?;
    }
    Ok(())
}
