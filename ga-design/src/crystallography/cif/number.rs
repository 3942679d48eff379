//! How CIF files spell numbers: `1.234(5)`, `-.5`, `2.5e-3`, and what is none.

use super::super::crystal::Measured;

/// A finite number with its standard uncertainty, which counts in units of the last digit.
///
/// A fraction such as `1/3` is accepted, since files have it; words such as `nan` and `inf` are
/// not numbers.
pub fn measured(text: &str) -> Option<Measured> {
    let text = text.trim();
    if let Some((above, below)) = text.split_once('/') {
        let (above, below) = (plain(above)?, plain(below)?);
        let value = above / below;
        return value.is_finite().then_some(Measured {
            value,
            uncertainty: None,
        });
    }
    let Some((number, rest)) = text.split_once('(') else {
        return plain(text).map(|value| Measured {
            value,
            uncertainty: None,
        });
    };
    let (digits, exponent) = rest.split_once(')')?;
    let value = plain(&format!("{number}{exponent}"))?;
    // Some programs write `8.5()` for a value that was not refined.
    if digits.trim().is_empty() {
        return Some(Measured {
            value,
            uncertainty: None,
        });
    }
    if !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let decimals = number
        .split_once('.')
        .map_or(0, |(_, decimals)| decimals.len());
    let unit = plain(&format!("1e-{decimals}"))? * plain(&format!("1{exponent}"))?;
    let uncertainty = plain(digits)? * unit;
    uncertainty.is_finite().then_some(Measured {
        value,
        uncertainty: Some(uncertainty),
    })
}

/// A finite number of digits, sign, point and exponent only.
fn plain(text: &str) -> Option<f64> {
    let allowed =
        |byte: u8| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'e' | b'E');
    if text.len() > 64 || !text.bytes().all(allowed) {
        return None;
    }
    text.parse().ok().filter(|value: &f64| value.is_finite())
}
