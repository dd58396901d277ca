#![no_main]

use libfuzzer_sys::fuzz_target;
use plantigrade_fuzz::{ALLOCATOR, run, targets};

fuzz_target!(|data: &[u8]| run(&ALLOCATOR, targets::bvh, data));
