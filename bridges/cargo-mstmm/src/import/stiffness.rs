//! The stiffness of a limit: the effort of the file over 1 deg or 1 mm.

use std::f64::consts::PI;

use super::numbers::{number, shortest};

/// The distance beyond a limit at which the effort of the file acts.
#[derive(Clone, Copy, Debug)]
pub enum Distance {
    Degree,
    Millimetre,
}

impl Distance {
    /// Returns the stiffness of an effort in SI units, with the roundings of `N*m/deg` and `N/mm` in the language.
    fn stiffness(self, effort: f64) -> f64 {
        match self {
            Distance::Degree => effort * 180.0 / PI,
            Distance::Millimetre => effort * 1000.0,
        }
    }

    /// Returns the effort that has a stiffness: of several that round to it, the one with the fewest digits.
    pub fn effort(self, stiffness: f64) -> f64 {
        let near = match self {
            Distance::Degree => stiffness * PI / 180.0,
            Distance::Millimetre => stiffness / 1000.0,
        };
        if !(near.is_normal() && near > 0.0) {
            return near;
        }
        // Two roundings in each direction are at most four units in the last place.
        let neighbours = (near.to_bits() - 4..=near.to_bits() + 4).map(f64::from_bits);
        let exact = neighbours.filter(|effort| self.stiffness(*effort) == stiffness);
        exact.min_by_key(|effort| number(*effort).len()).unwrap_or_else(|| shortest(near))
    }

    /// Returns the effort that stands for one of the file. Both have the same stiffness, and the stiffness determines this
    /// one, so that a file that is written from it has the same effort.
    pub fn written(self, effort: f64) -> f64 {
        self.effort(self.stiffness(effort))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn written_efforts_keep_their_stiffness() {
        let mut changed = 0;
        for index in 0..20_000_u32 {
            // Numbers of 16 digits, from 1e-3 to 1e4.
            let fraction = (f64::from(index) * 0.618_033_988_749_895).fract();
            let size = 10_f64.powi(i32::try_from(index % 7).unwrap_or(0) - 3);
            let effort = (1.0 + 9.0 * fraction) * size;
            for distance in [Distance::Degree, Distance::Millimetre] {
                let written = distance.written(effort);
                assert_eq!(distance.stiffness(written), distance.stiffness(effort), "{effort}");
                assert_eq!(distance.written(written), written, "{effort}");
                changed += u32::from(written != effort);
            }
        }
        assert!(changed > 100, "{changed}");
    }

    #[test]
    fn short_efforts_stay() {
        for effort in [0.1, 1.0, 2.7, 87.0, 123.456, 1e-3, 1e8] {
            for distance in [Distance::Degree, Distance::Millimetre] {
                assert_eq!(distance.written(effort), effort);
            }
        }
    }
}
