//! Clips made from others or of others: lower rates, sequences, long mixes.

use plantigrade::foot::{Part, Side};
use plantigrade_synth::{catalogue, chained, decimated, generate, long, sequences};

#[test]
fn every_fourth_frame_keeps_its_row_and_its_truth() {
    let whole = generate(&catalogue(1.0)[5], 0);
    let fewer = decimated(&whole, 4);
    assert_eq!(fewer.clip.frame_count(), whole.clip.frame_count().div_ceil(4));
    assert!((fewer.clip.rate() - whole.clip.rate() / 4.0).abs() < 1e-9);
    assert_eq!(fewer.truth.frames, fewer.clip.frame_count());
    let labels = [&whole, &fewer].map(|generated| generated.truth.labels(Side::Left, Part::Toe).unwrap());
    for frame in 0..fewer.clip.frame_count() {
        assert_eq!(fewer.clip.row(frame), whole.clip.row(4 * frame));
        assert_eq!(labels[1][frame], labels[0][4 * frame]);
    }
    assert_eq!(decimated(&whole, 1), whole);
}

#[test]
fn sequences_are_chained_with_known_cuts() {
    for sequence in sequences() {
        let chain = chained(&sequence, 0, 1.0);
        let (frames, name) = (chain.generated.clip.frame_count(), &sequence.name);
        assert!((20 * 120..=60 * 120).contains(&frames), "{name}: {frames} frames");
        assert!((4..=8).contains(&chain.actions.len()));
        assert_eq!(chain.cuts.len() + 1, chain.actions.len());
        for cut in &chain.cuts {
            assert!(cut.earliest < cut.middle && cut.middle < cut.latest, "{name}: {cut:?}");
            assert!(cut.latest - cut.earliest < 4 * 120, "{name}: {cut:?}");
        }
        for pair in chain.cuts.windows(2) {
            assert!(pair[1].earliest > pair[0].latest + 120, "{name}: {pair:?}");
        }
        assert!(chain.cuts.last().is_none_or(|cut| cut.latest < frames));
    }
}

#[test]
fn a_chain_follows_its_seed() {
    let sequence = &sequences()[2];
    assert_eq!(chained(sequence, 0, 1.0), chained(sequence, 0, 1.0));
    assert_ne!(chained(sequence, 0, 1.0).generated.clip, chained(sequence, 1, 1.0).generated.clip);
}

#[test]
fn long_mixes_are_of_any_length() {
    for frames in [120, 36_000] {
        let generated = generate(&long(frames, 1.0), 0);
        assert_eq!(generated.clip.frame_count(), frames);
        assert_eq!(generated.truth.frames, frames);
    }
}
