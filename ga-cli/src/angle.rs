//! Decides how angles are written on the command line: in radians, or in degrees if `deg` stands after
//! the number.

/// An angle in radians.
///
/// # Errors
/// What is wrong with the text, for clap, which names the option.
pub fn angle(text: &str) -> Result<f64, String> {
    let (number, is_degrees) = match text.strip_suffix("deg") {
        Some(number) => (number.trim_end(), true),
        None => (text, false),
    };
    let value: f64 = number
        .parse()
        .map_err(|_| "it is no angle; write it as 0.5236 or 30deg".to_owned())?;
    if !value.is_finite() {
        return Err("it must be finite".to_owned());
    }
    Ok(if is_degrees {
        value.to_radians()
    } else {
        value
    })
}

#[cfg(test)]
mod tests {
    use super::angle;
    use std::f64::consts::FRAC_PI_6;

    #[test]
    fn degrees_are_written_radians_are_not() {
        assert_eq!(angle("0.5"), Ok(0.5));
        assert_eq!(angle("-2e-1"), Ok(-0.2));
        for text in ["30deg", "30 deg", "+3e1deg"] {
            let degrees = angle(text).unwrap_or(f64::NAN);
            assert!((degrees - FRAC_PI_6).abs() < 1e-15, "{text}");
        }
    }

    #[test]
    fn what_is_no_angle_is_refused() {
        for text in ["", "deg", "30°", "30 degrees", "30DEG", "pi", "1/2"] {
            assert!(
                angle(text).is_err_and(|told| told.contains("30deg")),
                "{text}"
            );
        }
        for text in ["inf", "-infdeg", "NaN", "1e999"] {
            assert!(
                angle(text).is_err_and(|told| told.contains("finite")),
                "{text}"
            );
        }
    }
}
