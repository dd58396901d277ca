//! Benchmarks of the native build: parsing, detection and segmentation.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use plantigrade::bvh::{self, Clip};
use plantigrade::plants::{self, Feet, Params};
use plantigrade::segments;
use plantigrade::skeleton::{Overrides, Skeleton};
use plantigrade_synth::{generate, long_mix};

fn clip(frames: usize) -> Clip {
    generate(&long_mix(frames, 1.0), 0).clip
}

/// Parses about 10 MB of BVH text.
fn parse(criterion: &mut Criterion) {
    let bytes = bvh::write(&clip(19_500)).into_bytes();
    let mut group = criterion.benchmark_group("read");
    group.throughput(Throughput::Bytes(bytes.len() as u64));
    group.bench_function("ten-megabytes", |bencher| {
        bencher.iter_batched(
            || (),
            |()| bvh::parse(&bytes, Default::default()).expect("valid BVH"),
            // The clip is large; dropping it is not measured.
            BatchSize::PerIteration,
        );
    });
}

/// Detects plants of all parts of both feet.
fn detect(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("detect");
    for frames in [300, 1_000, 10_000] {
        let clip = clip(frames);
        let skeleton = Skeleton::main(&clip, &Overrides::default());
        let params = Params::default().check().expect("valid defaults");
        group.bench_function(frames.to_string(), |bencher| {
            bencher.iter(|| plants::detect(&Feet::new(&clip, &skeleton).expect("feet"), params));
        });
    }
}

/// Segments a clip with the default method.
fn segment(criterion: &mut Criterion) {
    let clip = clip(10_000);
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let params = segments::Params::default().check().expect("valid defaults");
    let mut group = criterion.benchmark_group("cut");
    group.bench_function("10000", |bencher| {
        bencher
            .iter(|| segments::segment(&clip, &skeleton, params, &mut |_| Ok(())).expect("a body in motion"));
    });
}

criterion_group!(benches, parse, detect, segment);
criterion_main!(benches);
