//! The fuzz targets on seeds, on inputs that once failed, and on mutations of both.
//!
//! `npm run fuzz` searches longer, guided by coverage.

#[path = "../fuzz/src/targets.rs"]
mod targets;

use std::fs;
use std::panic::{catch_unwind, resume_unwind};
use std::path::Path;
use std::sync::Mutex;

use peak_alloc::PeakAlloc;
use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

/// Held while a target runs, as memory is measured for the whole process.
static RUNNING: Mutex<()> = Mutex::new(());

/// Runs a target on all inputs of a folder, and on mutations of them.
fn check(name: &str, target: fn(&[u8]), mutations: usize) {
    let running = RUNNING.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz");
    let mut inputs = Vec::new();
    for kind in ["seeds", "regressions"] {
        let entries = fs::read_dir(folder.join(kind).join(name)).into_iter().flatten();
        let mut paths: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
        paths.sort();
        for path in paths {
            let bytes = fs::read(&path).expect("an input");
            run(target, &bytes, || path.display().to_string());
            inputs.push(bytes);
        }
    }
    assert!(!inputs.is_empty(), "no seeds");
    let mut rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]);
    for round in 0..mutations {
        let mutated = mutate(&inputs, &mut rng);
        run(target, &mutated, || format!("mutation {round}: {mutated:02x?}"));
    }
    drop(running);
}

/// Runs a target, and writes the input if it fails. Printing every input would allocate memory in the thread
/// that collects the output, which counts for the next test.
fn run(target: fn(&[u8]), input: &[u8], description: impl FnOnce() -> String) {
    let outcome = catch_unwind(|| targets::run(&ALLOCATOR, target, input));
    if let Err(panic) = outcome {
        println!("{}", description());
        resume_unwind(panic);
    }
}

/// Returns an input with some bytes changed, inserted, deleted, repeated or taken from another input.
fn mutate(inputs: &[Vec<u8>], rng: &mut TestRng) -> Vec<u8> {
    let mut below = |limit: usize| rng.next_u32() as usize % limit.max(1);
    let mut bytes = inputs[below(inputs.len())].clone();
    for _ in 0..=below(6) {
        let at = below(bytes.len() + 1);
        let end = (at + 1 + below(8)).min(bytes.len());
        match below(6) {
            0 => bytes.get_mut(at).into_iter().for_each(|byte| *byte = below(256) as u8),
            1 => bytes.get_mut(at).into_iter().for_each(|byte| *byte ^= 1 << below(8)),
            2 => bytes.insert(at, b"\n\r {}-+.,0e9\x00\xff#"[below(15)]),
            3 if at < end => drop(bytes.drain(at..end)),
            4 if at < end => {
                let repeated = bytes[at..end].repeat(1 + below(20));
                bytes.splice(at..at, repeated);
            }
            _ => {
                let other = &inputs[below(inputs.len())];
                let from = below(other.len() + 1);
                let part = other[from..(from + below(64)).min(other.len())].to_vec();
                bytes.splice(at..at, part);
            }
        }
    }
    bytes
}

#[test]
fn bvh_files() {
    check("bvh", targets::bvh, 20_000);
}

#[test]
fn labels() {
    check("labels", targets::labels, 20_000);
}

#[test]
fn pipeline() {
    check("pipeline", targets::pipeline, 150);
}
