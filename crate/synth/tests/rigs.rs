//! Roles, up axis and unit of generated skeletons of every kind.

use plantigrade::foot::Side;
use plantigrade::notice::Code;
use plantigrade::skeleton::{LegRoles, Overrides, Role, Skeleton};
use plantigrade_synth::rigs::{BodyKind, NAMINGS, Posture, Rig, generate};

/// Number of skeletons.
const RIGS: u64 = 10_000;

/// Counts of what was found.
#[derive(Debug, Default)]
struct Counts {
    with_feet: usize,
    found: usize,
    refused_or_doubtful: usize,
    without_feet: usize,
    refused: usize,
    up_right: usize,
    up_silent: usize,
    unit_right: usize,
    roles: usize,
    wrong_roles: usize,
}

#[test]
fn roles_and_axes_of_generated_skeletons_are_found() {
    let mut counts = Counts::default();
    // Rigs of one posture, and those whose up axis is right.
    let mut postures = [[0_usize; 2]; Posture::ALL.len()];
    let mut failures: Vec<String> = Vec::new();
    for seed in 0..RIGS {
        let rig = Rig::random(seed);
        let generated = generate(&rig, seed);
        let clip = &generated.clip;
        let skeleton = Skeleton::main(clip, &Overrides::default());
        let name = |joint: usize| clip.joints()[joint].name.as_str();
        let has_notice = |code| skeleton.notices.iter().any(|notice| notice.code == code);
        let mut fail = |text: String| failures.push(format!("seed {seed}: {text} in {rig:?}"));
        let has_feet = !matches!(rig.kind, BodyKind::UpperBody | BodyKind::OneLeg);
        for side in Side::BOTH {
            let leg = LegRoles::for_side(side);
            for role in [leg.thigh, leg.shank, leg.ankle, leg.toe] {
                let Some(joint) = skeleton.roles.get(role) else { continue };
                assert!(
                    !generated.no_legs.contains(&joint),
                    "seed {seed}: {} is no {role:?}: {rig:?}",
                    name(joint)
                );
            }
        }
        if has_feet {
            counts.with_feet += 1;
            let is_right =
                generated.roles.iter().filter(|(role, _)| is_ankle(*role)).all(|(role, joints)| {
                    skeleton.roles.get(*role).is_some_and(|joint| joints.contains(&joint))
                });
            if is_right {
                counts.found += 1;
            } else if !skeleton.roles.has_feet() || has_notice(Code::DoubtfulRole) {
                counts.refused_or_doubtful += 1;
            } else {
                fail("wrong ankles".into());
            }
            for (role, joints) in generated.roles.iter().filter(|_| skeleton.roles.has_feet()) {
                let Some(joint) = skeleton.roles.get(*role) else { continue };
                counts.roles += 1;
                if !(joints.contains(&joint) || joints.is_empty() && rig.naming.is_none()) {
                    counts.wrong_roles += 1;
                    if !has_notice(Code::DoubtfulRole) {
                        fail(format!("{role:?} is {}", name(joint)));
                    }
                }
            }
        } else {
            counts.without_feet += 1;
            if skeleton.roles.has_feet() {
                fail("feet without legs".into());
            } else {
                counts.refused += 1;
            }
        }
        if let [posture] = rig.postures[..] {
            postures[posture as usize][0] += 1;
            postures[posture as usize][1] += usize::from(skeleton.up == rig.up);
        }
        if skeleton.up == rig.up {
            counts.up_right += 1;
        } else if !has_notice(Code::UpAxis) {
            counts.up_silent += 1;
            fail(format!("up is {}", skeleton.up));
        }
        if has_feet {
            counts.unit_right += usize::from(skeleton.metres_per_unit == rig.metres_per_unit);
        }
    }
    println!("{counts:?}");
    for failure in failures.iter().take(40) {
        println!("{failure}");
    }
    let fraction = |part: usize, of: usize| part as f64 / of as f64;
    assert!(fraction(counts.found, counts.with_feet) >= 0.995, "{counts:?}");
    assert_eq!(counts.refused, counts.without_feet, "{counts:?}");
    assert_eq!(counts.found + counts.refused_or_doubtful, counts.with_feet, "{counts:?}");
    assert!(fraction(counts.up_silent, RIGS as usize) <= 0.001, "{counts:?}");
    assert!(fraction(counts.up_right, RIGS as usize) >= 0.995, "{counts:?}");
    for (posture, [count, right]) in Posture::ALL.into_iter().zip(postures) {
        assert!(count > 300 && fraction(right, count) >= 0.99, "{posture:?}: {right} of {count}");
    }
    assert!(fraction(counts.unit_right, counts.with_feet) >= 0.99, "{counts:?}");
    assert!(fraction(counts.wrong_roles, counts.roles) <= 0.005, "{counts:?}");
}

fn is_ankle(role: Role) -> bool {
    matches!(role, Role::LeftAnkle | Role::RightAnkle)
}

#[test]
fn all_kinds_of_rigs_are_generated() {
    let rigs: Vec<Rig> = (0..1000).map(Rig::random).collect();
    for kind in
        [BodyKind::Human, BodyKind::SpareLimbs, BodyKind::UpperBody, BodyKind::OneLeg, BodyKind::Quadruped]
    {
        assert!(rigs.iter().any(|rig| rig.kind == kind), "{kind:?}");
    }
    for naming in 0..NAMINGS.len() {
        assert!(rigs.iter().any(|rig| rig.naming == Some(naming)), "{naming}");
    }
}
