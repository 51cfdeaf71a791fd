//! The colours of depth.
//!
//! A way through the OKLCH colour space (Ottosson 2020) on which lightness falls evenly from shallow
//! to deep while the hue turns from gold over green and teal to indigo. Even lightness makes equal
//! steps of depth look equal, and keeps them apart for eyes that do not tell the hues apart and in
//! grey print. Both ends stand off a light ground.

/// Red, green, blue; sRGB.
pub type Colour = [u8; 3];

/// Number of colours of depth.
pub const BANDS: usize = 48;

/// Lightness, chroma and hue (degrees) at the shallow and at the deep end.
const SHALLOW: [f64; 3] = [0.80, 0.155, 88.0];
const DEEP: [f64; 3] = [0.30, 0.150, 292.0];

/// The colour at `t` from 0 (shallow) to 1 (deep).
pub fn colour(t: f64) -> Colour {
    let t = t.clamp(0.0, 1.0);
    let mix = |i: usize| {
        let at = |end: [f64; 3]| end.get(i).copied().unwrap_or_default();
        at(SHALLOW) + (at(DEEP) - at(SHALLOW)) * t
    };
    // Teal and blue hold less chroma inside sRGB than the ends do.
    let chroma = mix(1) * (1.0 - 0.35 * (std::f64::consts::PI * t).sin());
    oklch(mix(0), chroma, mix(2))
}

/// The colour of a band, 0 the shallowest.
pub fn of_band(band: usize) -> Colour {
    colour(band as f64 / (BANDS - 1) as f64)
}

/// Which depths the colours stand for.
#[derive(Clone, Copy, Debug)]
pub struct Depths {
    /// Z of the deepest cut, mm.
    pub deep: f64,
    /// Z of the shallowest cut, mm.
    pub shallow: f64,
    /// Whether something is cut above `shallow`: it has the colour of `shallow`.
    pub above: bool,
}

impl Depths {
    /// Whether all cuts lie at one depth.
    pub fn is_flat(&self) -> bool {
        self.shallow - self.deep <= 1e-9 * (1.0 + self.deep.abs())
    }

    /// Depth of `z` in bands: 0 at the shallow end, [`BANDS`] at the deep one.
    pub fn in_bands(&self, z: f64) -> f64 {
        // A part of one depth has the colour of its floor: deep.
        let part = if self.is_flat() { 1.0 } else { (self.shallow - z) / (self.shallow - self.deep) };
        part.clamp(0.0, 1.0) * BANDS as f64
    }
}

/// Band of a depth counted in bands.
pub fn band(in_bands: f64) -> usize {
    (in_bands.max(0.0) as usize).min(BANDS - 1)
}

fn oklch(lightness: f64, chroma: f64, hue: f64) -> Colour {
    let (sin, cos) = hue.to_radians().sin_cos();
    let (a, b) = (chroma * cos, chroma * sin);
    let l = (lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b).powi(3);
    let m = (lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b).powi(3);
    let s = (lightness - 0.089_484_177_5 * a - 1.291_485_548 * b).powi(3);
    [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701 * s,
    ]
    .map(gamma)
}

/// Linear light to an sRGB byte (IEC 61966-2-1).
fn gamma(linear: f64) -> u8 {
    let v = linear.clamp(0.0, 1.0);
    let encoded = if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    fn luminance(c: Colour) -> f64 {
        let linear = c.map(|v| (f64::from(v) / 255.0).powf(2.2));
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    #[test]
    fn deeper_is_darker_and_no_two_bands_are_alike() {
        for i in 1..BANDS {
            assert!(luminance(of_band(i)) < luminance(of_band(i - 1)), "band {i}");
            assert_ne!(of_band(i), of_band(i - 1));
        }
    }

    #[test]
    fn depth_is_counted_from_the_shallow_end() {
        let depths = Depths { deep: -10.0, shallow: 2.0, above: false };
        assert_eq!(band(depths.in_bands(2.0)), 0);
        assert_eq!(band(depths.in_bands(-10.0)), BANDS - 1);
        assert_eq!(band(Depths { deep: 3.0, shallow: 3.0, above: true }.in_bands(3.0)), BANDS - 1);
    }
}
