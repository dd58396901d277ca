//! Derived clips: lower frame rates, action sequences, long mixes.

use plantigrade::foot::{Part, Side};
use plantigrade_synth::{action_sequences, decimate, generate, generate_sequence, long_mix, samples};

#[test]
fn decimation_preserves_rows_and_labels() {
    let original = generate(&samples(1.0)[5], 0);
    let decimated = decimate(&original, 4);
    assert_eq!(decimated.clip.frame_count(), original.clip.frame_count().div_ceil(4));
    assert!((decimated.clip.rate() - original.clip.rate() / 4.0).abs() < 1e-9);
    assert_eq!(decimated.truth.header.frames, decimated.clip.frame_count());
    let labels =
        [&original, &decimated].map(|generated| generated.truth.labels(Side::Left, Part::Toe).unwrap());
    for frame in 0..decimated.clip.frame_count() {
        assert_eq!(decimated.clip.row(frame), original.clip.row(4 * frame));
        assert_eq!(labels[1][frame], labels[0][4 * frame]);
    }
    assert_eq!(decimate(&original, 1), original);
}

#[test]
fn sequences_have_ordered_cuts_within_the_clip() {
    for sequence in action_sequences() {
        let action_clip = generate_sequence(&sequence, 0, 1.0);
        let (frames, name) = (action_clip.generated.clip.frame_count(), &sequence.name);
        assert!((20 * 120..=60 * 120).contains(&frames), "{name}: {frames} frames");
        assert!((4..=8).contains(&action_clip.actions.len()));
        assert_eq!(action_clip.cuts.len() + 1, action_clip.actions.len());
        for cut in &action_clip.cuts {
            assert!(cut.earliest < cut.middle && cut.middle < cut.latest, "{name}: {cut:?}");
            assert!(cut.latest - cut.earliest < 4 * 120, "{name}: {cut:?}");
        }
        for pair in action_clip.cuts.windows(2) {
            assert!(pair[1].earliest > pair[0].latest + 120, "{name}: {pair:?}");
        }
        assert!(action_clip.cuts.last().is_none_or(|cut| cut.latest < frames));
    }
}

#[test]
fn sequence_clips_are_reproducible_and_depend_on_the_seed() {
    let sequence = &action_sequences()[2];
    assert_eq!(generate_sequence(sequence, 0, 1.0), generate_sequence(sequence, 0, 1.0));
    assert_ne!(
        generate_sequence(sequence, 0, 1.0).generated.clip,
        generate_sequence(sequence, 1, 1.0).generated.clip
    );
}

#[test]
fn long_mix_has_the_requested_length() {
    for frames in [120, 36_000] {
        let generated = generate(&long_mix(frames, 1.0), 0);
        assert_eq!(generated.clip.frame_count(), frames);
        assert_eq!(generated.truth.header.frames, frames);
    }
}
