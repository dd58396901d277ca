//! Arithmetic at the peak of the processor, as a physical limit for `npm run bench`; compiled into a wasm
//! module of its own.

/// Values of the independent chains of multiply-adds: twelve vectors of four. Enough to hide the latency of
/// an instruction, and few enough to stay in registers.
const VALUES: usize = 48;
/// Executes 48 multiply-adds in single precision per repeat and returns a result that depends on all of them.
#[unsafe(no_mangle)]
pub extern "C" fn multiply_adds(repeats: u32) -> f32 {
    let mut values = [1.0_f32; VALUES];
    for _ in 0..repeats {
        for value in &mut values {
            *value = *value * 0.999 + 0.5;
        }
    }
    values.iter().sum()
}
