//! Definitions of the measures, and their sources.

/// Terms with their definitions; numbers in brackets refer to [`SOURCES`].
pub(super) const DEFINITIONS: &[(&str, &str)] = &[
    (
        "Foot strike, foot off",
        "Beginning and end of the contact of a foot with the ground, which also define the phases of the gait \
         cycle [1, 2]. Times are instants between frames where the detection determines them.",
    ),
    (
        "Stride (gait cycle)",
        "From one foot strike to the next foot strike of the same foot: 0 to 100 % of the gait cycle.",
    ),
    ("Step", "From the foot strike of the other foot to that of this foot; named after this foot."),
    ("Stance, swing", "From foot strike to foot off, and from foot off to the next foot strike."),
    (
        "Single support, double support, flight",
        "Parts of a stride with this foot only, with both feet and with neither foot on the ground.",
    ),
    ("Cadence", "120 s over the mean stride time, in steps per minute."),
    ("Speed", "Total stride length over total stride time, relative to the belt on a treadmill."),
    (
        "Step length, step width",
        "Distance of the heel from the other heel along and across the direction of progression, which is the \
         mean direction of the two strides that share the step [3].",
    ),
    ("Stride length", "Distance between the heels of successive contacts of one foot along the ground."),
    (
        "Heel",
        "Lengths use the position of the toe during contact, less the length of the foot between toe and ankle.",
    ),
    ("Mean ± sd", "Mean and standard deviation (divisor n − 1) over the strides or steps of one foot."),
    (
        "Symmetry index",
        "100 · (R − L) / ((R + L) / 2), in percent, of the means of left (L) and right (R) [4]; 0 if both are \
         equal, positive if the right side is greater.",
    ),
    (
        "Strides left out",
        "Strides that the clip or the action cuts off, in which the other foot does not strike exactly once, \
         that take more than 2.5 s, or that are shorter than 0.4 leg lengths.",
    ),
    (
        "Joint angles",
        "Angles between lines through joint centres in the vertical plane of the stride, from heel to heel. Hip \
         flexion: thigh from the vertical, positive forward. Knee flexion: shank from the line of the thigh. \
         Ankle dorsiflexion: foot from a right angle between sole and shank, positive with the toes up; the \
         sole is flat in the second quarter of stance. These are not clinical angles, which are measured \
         between anatomical frames of the segments [5]. There are no norm bands.",
    ),
];

/// Sources of the definitions, in the order of their numbers.
pub(super) const SOURCES: &[&str] = &[
    "Perry J, Burnfield JM. Gait Analysis: Normal and Pathological Function. 2nd edition, 2010.",
    "Zeni JA, Richards JG, Higginson JS. Two simple methods for determining gait events during treadmill and \
     overground walking using kinematic data. Gait & Posture 27(4), 2008.",
    "Huxham F, Gong J, Baker R, Morris M, Iansek R. Defining spatial parameters for non-linear walking. Gait & \
     Posture 23(2), 2006.",
    "Robinson RO, Herzog W, Nigg BM. Use of force platform variables to quantify the effects of chiropractic \
     manipulation on gait symmetry. Journal of Manipulative and Physiological Therapeutics 10(4), 1987.",
    "Wu G et al. ISB recommendation on definitions of joint coordinate system of various joints for the \
     reporting of human joint motion, part I: ankle, hip, and spine. Journal of Biomechanics 35(4), 2002.",
];
