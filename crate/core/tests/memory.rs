//! Memory of reading and of the search for roles: in proportion to the file, whatever its shape. Memory of
//! detection: in proportion to the frames, whatever their rate.

use std::sync::Mutex;

use peak_alloc::PeakAlloc;
use plantigrade::bvh::{self, Options};
use plantigrade::gait::Gait;
use plantigrade::plants::{self, Feet, ValidParams};
use plantigrade::segments;
use plantigrade::skate::{self, Contacts};
use plantigrade::skeleton::{Overrides, Skeleton};

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

/// Held while memory is measured, as it is measured for the whole process.
static MEASURING: Mutex<()> = Mutex::new(());

const CHANNELS: &str = "CHANNELS 3 Zrotation Xrotation Yrotation";

/// Returns a file with a hierarchy, whose rotation channels are counted, and three frames.
fn file(hierarchy: &str) -> Vec<u8> {
    let width = hierarchy.matches("rotation").count();
    let frame = |frame: usize| (0..width).map(|n| (n * frame % 9).to_string()).collect::<Vec<_>>().join(" ");
    let frames: Vec<String> = (0..3).map(frame).collect();
    format!("HIERARCHY\n{hierarchy}MOTION\nFrames: 3\nFrame Time: 0.03\n{}\n", frames.join("\n")).into_bytes()
}

fn joint(kind: &str, name: &str, content: &str) -> String {
    format!("{kind} {name}\n{{\nOFFSET 1 2 3\n{CHANNELS}\n{content}}}\n")
}

/// Returns files of a shape with `size` joints, roots or repetitions.
fn shapes(size: usize) -> Vec<(&'static str, Vec<u8>)> {
    let root = |content: &str| joint("ROOT", "hips", content);
    let leaves = |name: &dyn Fn(usize) -> String| -> String {
        (0..size).map(|n| joint("JOINT", &name(n), "")).collect()
    };
    let chain = (0..size.min(900)).fold(String::new(), |below, n| {
        joint("JOINT", &format!("s{n}"), &(joint("JOINT", &format!("l{n}"), "") + &below))
    });
    let short = "OFFSET 1 2 3 ".repeat(20 * size);
    vec![
        ("leaves", file(&root(&leaves(&|n| format!("j{n}"))))),
        ("roots", file(&(0..size).map(|n| joint("ROOT", &format!("r{n}"), "")).collect::<String>())),
        ("a chain with leaves", file(&root(&chain))),
        ("equal names", file(&root(&leaves(&|_| "foot".into())))),
        ("long names", file(&root(&leaves(&|n| format!("{n}{}", "x".repeat(300)))))),
        ("one long name", file(&joint("ROOT", &"x".repeat(100 * size), ""))),
        ("joints on one line", file(&root(&leaves(&|n| format!("j{n}"))).replace('\n', " ")).to_vec()),
        ("repeated offsets", file(&joint("ROOT", &"x".repeat(10 * size), &short))),
        ("missing offsets", file(&root(&leaves(&|n| format!("j{n}"))).replace("OFFSET 1 2 3\n", ""))),
        ("wrong channel counts", file(&root(&leaves(&|n| format!("j{n}"))).replace("S 3 Z", "S 5 Z"))),
    ]
}

#[test]
fn memory_is_in_proportion_to_the_file() {
    let _measuring = MEASURING.lock();
    let overrides = Overrides::default();
    for ((shape, small), (_, large)) in shapes(400).into_iter().zip(shapes(2000)) {
        let per_byte = [small, large].map(|file| {
            let before = ALLOCATOR.current_usage();
            ALLOCATOR.reset_peak_usage();
            let parsed =
                bvh::parse(&file, Options::default()).unwrap_or_else(|error| panic!("{shape}: {error}"));
            assert!(!Skeleton::all(&parsed.clip, &overrides).is_empty());
            (ALLOCATOR.peak_usage() - before) as f64 / file.len() as f64
        });
        println!("{shape}: {:.1} and {:.1} bytes per byte", per_byte[0], per_byte[1]);
        assert!(per_byte.iter().all(|&ratio| ratio < 200.0), "{shape}: {per_byte:?}");
        assert!(per_byte[1] < 1.5 * per_byte[0] + 1.0, "{shape} grows faster than the file: {per_byte:?}");
    }
}

/// Motion of [`legs`].
#[derive(Clone, Copy, Debug, PartialEq)]
enum Motion {
    /// The root moves up and down.
    UpAndDown,
    /// The same, with three channels.
    ThreeChannels,
    /// The left thigh turns by pseudorandom angles.
    Noise,
}

/// Returns a file of two legs whose rows have one digit per channel, with a frame time in seconds.
fn legs(frames: usize, frame_time: f64, motion: Motion) -> Vec<u8> {
    let joint = |name: &str, offset: &str, channels: &str, content: &str| {
        format!("JOINT {name}\n{{\nOFFSET {offset}\nCHANNELS {channels}\n{content}}}\n")
    };
    let leg = |side: &str, x: i32, channels: &str| {
        let toe = joint(&format!("{side}ToeBase"), "0 -5 10", "0", "End Site\n{\nOFFSET 0 0 5\n}\n");
        let foot = joint(&format!("{side}Foot"), "0 -40 0", "0", &toe);
        let shank = joint(&format!("{side}Leg"), "0 -40 0", "0", &foot);
        joint(&format!("{side}UpLeg"), &format!("{x} 0 0"), channels, &shank)
    };
    let [root, thigh] = match motion {
        Motion::UpAndDown => ["1 Yposition", "0"],
        Motion::ThreeChannels => ["3 Xposition Yposition Zposition", "0"],
        Motion::Noise => ["0", "1 Xrotation"],
    };
    let (left, right) = (leg("Left", 9, thigh), leg("Right", -9, "0"));
    let row = |frame: usize| match motion {
        Motion::UpAndDown => format!("{}\n", frame * frame % 7),
        Motion::ThreeChannels => format!("0 {} 0\n", frame * frame % 7),
        Motion::Noise => {
            format!("{}\n", (frame as u32).wrapping_mul(2_654_435_761).wrapping_mul(frame as u32) >> 16 & 7)
        }
    };
    let rows: String = (0..frames).map(row).collect();
    format!(
        "HIERARCHY\nROOT Hips\n{{\nOFFSET 0 0 0\nCHANNELS {root}\n{left}{right}}}\n\
         MOTION\nFrames: {frames}\nFrame Time: {frame_time}\n{rows}"
    )
    .into_bytes()
}

#[test]
fn memory_of_detection_does_not_grow_with_the_frame_time() {
    let _measuring = MEASURING.lock();
    const FRAMES: usize = 4000;
    let per_frame = [1.0 / 120.0, 1.0 / 12.0, 0.5, 1.0].map(|frame_time| {
        let file = legs(FRAMES, frame_time, Motion::ThreeChannels);
        let parsed = bvh::parse(&file, Options::default()).expect("a clip");
        let skeleton = Skeleton::main(&parsed.clip, &Overrides::default());
        let feet = Feet::new(&parsed.clip, &skeleton).expect("feet");
        let before = ALLOCATOR.current_usage();
        ALLOCATOR.reset_peak_usage();
        plants::detect(&feet, ValidParams::default());
        (ALLOCATOR.peak_usage() - before) / FRAMES
    });
    println!("bytes per frame: {per_frame:?}");
    assert!(per_frame.iter().all(|&bytes| bytes < 2000), "{per_frame:?}");
}

/// Memory that a short file may need, in bytes: 200 per byte of the file, and 4 MiB for a file of any length, as in
/// the fuzz targets.
const BASE_BYTES: usize = 4 << 20;
const BYTES_PER_BYTE: usize = 200;

/// Files of 10 kB with as many frames as possible.
#[test]
fn files_of_many_short_rows_need_little_memory() {
    let _measuring = MEASURING.lock();
    let methods = segments::Method::ALL.iter().filter(|method| **method != segments::Method::Mvu);
    for motion in [Motion::UpAndDown, Motion::ThreeChannels, Motion::Noise] {
        let row = if motion == Motion::ThreeChannels { 6 } else { 2 };
        let frames = (10_000 - legs(0, 0.1, motion).len()) / row;
        for rate in [1.0, 12.0, 24.0, 30.0, 60.0, 120.0, 1000.0] {
            let file = legs(frames, 1.0 / rate, motion);
            let mut used = Vec::new();
            let before = ALLOCATOR.current_usage();
            let mut measure = |stage: &str| {
                used.push((stage.to_owned(), ALLOCATOR.peak_usage() - before));
                ALLOCATOR.reset_peak_usage();
            };
            ALLOCATOR.reset_peak_usage();
            let clip = bvh::parse(&file, Options::default()).expect("a clip").clip;
            let skeleton = Skeleton::main(&clip, &Overrides::default());
            let feet = Feet::new(&clip, &skeleton).expect("feet");
            measure("reading");
            let detection = plants::detect(&feet, ValidParams::default());
            measure("detection");
            Gait::from_detection(&feet, &detection);
            measure("gait");
            let contacts = Contacts::from(&detection);
            drop((detection, feet));
            let _ = skate::clean(&clip, &skeleton, &contacts, &skate::Options::default());
            measure("clean-up");
            for &method in methods.clone() {
                let params = segments::Params { method, ..Default::default() }.check().expect("parameters");
                let _ = segments::segment(&clip, &skeleton, params, &mut |_| Ok(()));
                measure(method.name());
            }
            let limit = BASE_BYTES + BYTES_PER_BYTE * file.len();
            println!("{motion:?}, {rate} Hz: {used:?}");
            assert!(
                used.iter().all(|(_, bytes)| *bytes <= limit),
                "{motion:?}, {rate} Hz, limit {limit}: {used:?}"
            );
        }
    }
}
