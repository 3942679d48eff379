//! Decides what a finished picture is: rows of red, green and blue bytes, and its PNG encoding.

use crate::export::{ExportError, Format};
use glam::Vec3;

/// A picture in eight bits per channel (sRGB).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Image {
    width: u32,
    height: u32,
    bytes: Vec<u8>,
}

impl Image {
    /// Pixels across.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Pixels down.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Red, green and blue of a pixel, counted from the top left; nothing outside the picture.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        if x >= self.width {
            return None;
        }
        let start = 3 * (y as usize * self.width as usize + x as usize);
        let channels = self.bytes.get(start..start + 3)?;
        channels.try_into().ok()
    }

    /// The picture at half the size, each pixel the mean of four; a picture one pixel wide or high
    /// stays as it is.
    #[must_use]
    pub fn halved(&self) -> Self {
        let [width, height] = [self.width / 2, self.height / 2];
        if width == 0 || height == 0 {
            return self.clone();
        }
        let mut bytes = Vec::with_capacity(3 * width as usize * height as usize);
        for y in 0..height {
            for x in 0..width {
                let mut sums = [0_u16; 3];
                for [dx, dy] in [[0, 0], [1, 0], [0, 1], [1, 1]] {
                    let pixel = self.pixel(2 * x + dx, 2 * y + dy).unwrap_or_default();
                    for (sum, channel) in sums.iter_mut().zip(pixel) {
                        *sum += u16::from(channel);
                    }
                }
                bytes.extend(sums.map(|sum| ((sum + 2) / 4) as u8));
            }
        }
        Self {
            width,
            height,
            bytes,
        }
    }

    /// The bytes of a PNG file.
    ///
    /// # Errors
    /// [`ExportError::Encode`] if the encoder refuses.
    pub fn to_png(&self) -> Result<Vec<u8>, ExportError> {
        let refused = |error: png::EncodingError| ExportError::Encode {
            format: Format::Png,
            reason: error.to_string(),
        };
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header().map_err(refused)?;
        writer.write_image_data(&self.bytes).map_err(refused)?;
        writer.finish().map_err(refused)?;
        Ok(file)
    }

    /// The picture of these samples: the mean of each block of `per_side` by `per_side`.
    pub(super) fn averaged(colors: &[Vec3], width: usize, height: usize, per_side: usize) -> Self {
        let [across, down] = [width / per_side, height / per_side];
        let mut bytes = Vec::with_capacity(3 * across * down);
        for row in 0..down {
            for column in 0..across {
                let mut sum = Vec3::ZERO;
                for y in 0..per_side {
                    for x in 0..per_side {
                        let index = (row * per_side + y) * width + column * per_side + x;
                        // Softened before the mean: a highlight must not outweigh its edge.
                        sum += colors.get(index).copied().map_or(Vec3::ZERO, softened);
                    }
                }
                let mean = sum / (per_side * per_side) as f32;
                bytes.extend(mean.to_array().map(encoded));
            }
        }
        Self {
            width: across as u32,
            height: down as u32,
            bytes,
        }
    }
}

/// Keeps the darker tones as they are and bends the brightest below white.
fn softened(color: Vec3) -> Vec3 {
    const KNEE: f32 = 0.8;
    const ROOM: f32 = 1.0 - KNEE;
    let bend = |value: f32| {
        if value <= KNEE {
            value.max(0.0)
        } else {
            KNEE + ROOM * (1.0 - (-(value - KNEE) / ROOM).exp())
        }
    };
    Vec3::from(color.to_array().map(bend))
}

/// A channel as on a screen (IEC 61966-2-1).
fn encoded(value: f32) -> u8 {
    let encoded = if value <= 0.003_130_8 {
        12.92 * value
    } else {
        1.055 * value.powf(1.0 / 2.4) - 0.055
    };
    // A saturating conversion: from 0 to 255 whatever comes in.
    (255.0 * encoded).round() as u8
}
