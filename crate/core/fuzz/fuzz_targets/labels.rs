#![no_main]

use libfuzzer_sys::fuzz_target;
use plantigrade_fuzz::{run, targets};

fuzz_target!(|data: &[u8]| run(targets::labels, data));
