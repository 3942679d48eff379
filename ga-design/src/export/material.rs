//! Decides how a surface looks: a colour, how rough, how metallic, how opaque.

use super::ExportError;

/// The look of a surface or line, in the terms of glTF's metallic-roughness model.
///
/// ```
/// use ga_design::export::Material;
/// let glass = Material::new("glass", [180, 210, 230]).with_opacity(0.3)?;
/// assert_eq!(glass.opacity(), 0.3);
/// assert!(glass.with_opacity(f64::NAN).is_err());
/// # Ok::<(), ga_design::export::ExportError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    name: String,
    color: [u8; 3],
    roughness: f64,
    metallic: f64,
    opacity: f64,
}

impl Material {
    /// An opaque, half-matt material of this colour: red, green, blue as on a screen (sRGB).
    #[must_use]
    pub fn new(name: impl Into<String>, color: [u8; 3]) -> Self {
        Self {
            name: name.into(),
            color,
            roughness: 0.5,
            metallic: 0.0,
            opacity: 1.0,
        }
    }

    /// The same with this roughness: 0 is a mirror, 1 chalk.
    ///
    /// # Errors
    /// [`ExportError::Number`] if it is not from 0 to 1.
    pub fn with_roughness(mut self, roughness: f64) -> Result<Self, ExportError> {
        self.roughness = checked_part("the roughness of a material", roughness)?;
        Ok(self)
    }

    /// The same, from 0 (plastic, stone) to 1 (bare metal).
    ///
    /// # Errors
    /// [`ExportError::Number`] if it is not from 0 to 1.
    pub fn with_metallic(mut self, metallic: f64) -> Result<Self, ExportError> {
        self.metallic = checked_part("the metallic part of a material", metallic)?;
        Ok(self)
    }

    /// The same, from 0 (invisible) to 1 (opaque).
    ///
    /// # Errors
    /// [`ExportError::Number`] if it is not from 0 to 1.
    pub fn with_opacity(mut self, opacity: f64) -> Result<Self, ExportError> {
        self.opacity = checked_part("the opacity of a material", opacity)?;
        Ok(self)
    }

    /// The name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Red, green, blue as on a screen (sRGB).
    #[must_use]
    pub fn color(&self) -> [u8; 3] {
        self.color
    }

    /// Red, green, blue in proportion to light, from 0 to 1 (IEC 61966-2-1).
    #[must_use]
    pub fn linear_color(&self) -> [f64; 3] {
        self.color.map(|channel| {
            let part = f64::from(channel) / 255.0;
            if part <= 0.04045 {
                part / 12.92
            } else {
                ((part + 0.055) / 1.055).powf(2.4)
            }
        })
    }

    /// From 0 (mirror) to 1 (chalk).
    #[must_use]
    pub fn roughness(&self) -> f64 {
        self.roughness
    }

    /// From 0 (not metal) to 1 (metal).
    #[must_use]
    pub fn metallic(&self) -> f64 {
        self.metallic
    }

    /// From 0 (invisible) to 1 (opaque).
    #[must_use]
    pub fn opacity(&self) -> f64 {
        self.opacity
    }
}

fn checked_part(what: &'static str, value: f64) -> Result<f64, ExportError> {
    if (0.0..=1.0).contains(&value) {
        Ok(value)
    } else {
        Err(ExportError::Number {
            what,
            value,
            remedy: "it must be from 0 to 1",
        })
    }
}
