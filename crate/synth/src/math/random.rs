//! Random numbers: PCG-64 (XSL-RR 128/64), seeded by a number and a purpose.

use rand_core::Rng;
use rand_pcg::Pcg64;

/// Stream of random numbers, reproducible for a seed and a purpose on any machine.
pub struct Random(Pcg64);

impl Random {
    /// Creates the stream of `seed` for `purpose`. Streams of different purposes are independent.
    pub fn new(seed: u64, purpose: &str) -> Random {
        // The FNV-1a hash of the purpose selects the generator's stream.
        let stream = purpose.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        });
        Random(Pcg64::new(u128::from(seed) << 64 | 0x9e37_79b9_7f4a_7c15, u128::from(stream)))
    }

    /// Draws from the uniform distribution over [`low`, `high`).
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        low + (high - low) * unit
    }

    /// Draws from the standard normal distribution (Box–Muller).
    pub fn normal(&mut self) -> f64 {
        let radius = libm::sqrt(-2.0 * libm::log(1.0 - self.uniform(0.0, 1.0)));
        radius * libm::cos(self.uniform(0.0, std::f64::consts::TAU))
    }

    /// Draws a factor around 1 with standard deviation `sd`, clamped to two standard deviations.
    pub fn vary(&mut self, sd: f64) -> f64 {
        1.0 + sd * self.normal().clamp(-2.0, 2.0)
    }
}
