//! Random numbers: PCG-64 (XSL-RR 128/64), seeded by a number and a purpose.

use rand_core::Rng;
use rand_pcg::Pcg64;

/// A stream of random numbers, the same for the same seed and purpose on any machine.
pub struct Random(Pcg64);

impl Random {
    /// The stream of `seed` for `purpose`; purposes do not disturb each other.
    pub fn new(seed: u64, purpose: &str) -> Random {
        // FNV-1a turns the purpose into the generator's stream number.
        let stream = purpose.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        });
        Random(Pcg64::new(u128::from(seed) << 64 | 0x9e37_79b9_7f4a_7c15, u128::from(stream)))
    }

    /// Evenly distributed in [`low`, `high`).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        low + (high - low) * unit
    }

    /// Normally distributed with mean 0 and standard deviation 1 (Box and Muller).
    pub fn normal(&mut self) -> f64 {
        let radius = libm::sqrt(-2.0 * libm::log(1.0 - self.between(0.0, 1.0)));
        radius * libm::cos(self.between(0.0, std::f64::consts::TAU))
    }

    /// 1 varied by about ± `share`, within twice that.
    pub fn vary(&mut self, share: f64) -> f64 {
        1.0 + share * self.normal().clamp(-2.0, 2.0)
    }
}
