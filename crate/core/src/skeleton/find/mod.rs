//! Roles by the evidence of names, structure and motion.

mod leg;
mod named_legs;
mod tree;
mod trunk;
mod unnamed_legs;

use crate::bvh::Clip;
use crate::foot::Side;
use crate::skeleton::names::{BodyPart, LimbPair};
use crate::skeleton::{LegRoles, Reason, Role, Roles};
use leg::Leg;
use tree::Tree;

/// Result of the search for roles.
pub(crate) struct RoleSearch {
    /// The roles.
    pub roles: Roles,
    /// True if the skeleton has fore limbs that stand on the ground.
    pub is_quadruped: bool,
}

/// Assigns the roles in the skeleton below `root`.
pub(crate) fn assign_roles(clip: &Clip, root: usize) -> RoleSearch {
    let tree = Tree::new(clip, root);
    let mut roles = Roles::default();
    let legs = match named_legs::find(&tree) {
        [Some(left), Some(right)] => [Some(left), Some(right)],
        [None, None] => unnamed_legs::find(&tree).map_or([None, None], |legs| legs.map(Some)),
        one_leg => one_leg,
    };
    for (index, side) in Side::BOTH.into_iter().enumerate() {
        if let Some(leg) = legs[index] {
            assign_leg(&tree, side, &leg, legs[1 - index].as_ref(), &mut roles);
        }
    }
    trunk::assign(&tree, &mut roles);
    // A single joint may be named after the front of the body.
    let is_fore = |joint: usize| tree.name(joint).limb_pair == Some(LimbPair::Fore);
    let has_fore_limbs =
        tree.members().any(|joint| is_fore(joint) && tree.parent(joint).is_some_and(is_fore));
    // A body with arms may wear a skirt with a front.
    let has_arms = [Role::LeftForearm, Role::RightForearm, Role::LeftHand, Role::RightHand]
        .iter()
        .any(|&role| roles.get(role).is_some_and(|joint| !is_fore(joint)));
    let is_quadruped = roles.has_feet() && (has_fore_limbs && !has_arms || trunk::hands_stand(&tree, &roles));
    RoleSearch { roles, is_quadruped }
}

/// Assigns the roles of one leg with their evidence.
fn assign_leg(tree: &Tree, side: Side, leg: &Leg, other: Option<&Leg>, roles: &mut Roles) {
    let joints = |leg: &Leg| [leg.thigh, leg.shank, leg.ankle, leg.toe, leg.tip];
    let LegRoles { thigh, shank, ankle, toe, tip } = LegRoles::for_side(side);
    let named: [&[BodyPart]; 5] = [
        &[BodyPart::Thigh, BodyPart::Hip, BodyPart::Leg],
        &[BodyPart::Shank, BodyPart::Leg],
        &[BodyPart::Ankle, BodyPart::Foot],
        &[BodyPart::Toe],
        &[BodyPart::Toe],
    ];
    let others = other.map(joints).unwrap_or_default();
    let own = joints(leg);
    let is_named =
        |index: usize, joint: usize| tree.name(joint).part.is_some_and(|part| named[index].contains(&part));
    for (index, role) in [thigh, shank, ankle, toe, tip].into_iter().enumerate() {
        let Some(joint) = own[index] else { continue };
        let name = tree.name(joint);
        let mut reasons = Vec::new();
        if is_named(index, joint) {
            reasons.push(if name.unknown_words == 0 { Reason::Name } else { Reason::PartOfName });
        } else {
            reasons.push(Reason::Structure);
        }
        let above = index.checked_sub(1).and_then(|above| own[above]);
        let below = own.get(index + 1).copied().flatten();
        let is_in_chain = above
            .is_some_and(|above| tree.is_within(joint, above) && is_named(index - 1, above))
            || below.is_some_and(|below| tree.is_within(below, joint) && is_named(index + 1, below));
        if is_in_chain {
            reasons.push(Reason::Chain);
        }
        if others[index].is_some_and(|other| tree.is_mirrored(joint, other)) {
            reasons.push(Reason::Mirrored);
        }
        roles.assign(role, joint, reasons);
    }
}

#[cfg(test)]
mod tests {
    use crate::bvh;
    use crate::skeleton::{Overrides, Role, Skeleton};

    /// A body of nameless limbs, each with three bones and a tip, at the given offsets.
    fn body(limbs: &[&str]) -> String {
        let mut text = String::from("HIERARCHY\nROOT q\n{\nOFFSET 0 0 0\n");
        for (limb, offset) in limbs.iter().enumerate() {
            text += &format!(
                "JOINT a{limb}\n{{\nOFFSET {offset}\nJOINT b{limb}\n{{\nOFFSET 0 -4 0\nJOINT c{limb}\n{{\n\
                 OFFSET 0 -4 0\nEnd Site\n{{\nOFFSET 0 0 1\n}}\n}}\n}}\n}}\n"
            );
        }
        text + "}\n"
    }

    /// Returns the ankles of a skeleton of two legs, each a chain of names and lengths of bones.
    fn ankles(bones: &[(&str, f64)]) -> [Option<String>; 2] {
        let mut text = String::from("HIERARCHY\nROOT hips\n{\nOFFSET 0 0 0\n");
        for (side, x) in [("Left", 10.0), ("Right", -10.0)] {
            for (index, (name, length)) in bones.iter().enumerate() {
                let x = if index == 0 { x } else { 0.0 };
                text += &format!("JOINT {side}{name}\n{{\nOFFSET {x} -{length} 0\n");
            }
            text += "End Site\n{\nOFFSET 0 0 9\n}\n";
            text += &"}\n".repeat(bones.len());
        }
        let clip = bvh::parse((text + "}\n").as_bytes(), bvh::Options::default()).expect("legs").clip;
        let roles = Skeleton::main(&clip, &Overrides::default()).roles;
        [Role::LeftAnkle, Role::RightAnkle]
            .map(|role| roles.get(role).map(|joint| clip.joints()[joint].name.clone()))
    }

    #[test]
    fn ankles_without_a_name_are_at_the_end_of_the_shank() {
        let found = |name: &str| [Some(format!("Left{name}")), Some(format!("Right{name}"))];
        assert_eq!(ankles(&[("Leg1", 5.0), ("Leg2", 40.0), ("Leg3", 40.0)]), found("Leg3"));
        assert_eq!(ankles(&[("UpLeg", 5.0), ("LowLeg", 40.0), ("Bone3", 40.0)]), found("Bone3"));
        assert_eq!(ankles(&[("Thigh", 5.0), ("Shin", 40.0), ("Heel", 40.0), ("Toe", 8.0)]), found("Heel"));
        assert_eq!(ankles(&[("Hip", 5.0), ("Knee", 40.0), ("ANK", 40.0), ("TOE", 8.0)]), found("ANK"));
        assert_eq!(ankles(&[("太もも", 5.0), ("すね", 40.0), ("足", 40.0), ("足指", 8.0)]), found("足"));
        assert_eq!(ankles(&[("UpLeg", 5.0), ("Leg", 9.0)]), found("").map(|_| Some("End Site".into())));
    }

    #[test]
    fn toes_in_a_list_of_points_may_be_named_foot() {
        let names = ["l_foot", "r_foot", "l_ankle", "r_ankle", "l_knee", "r_knee", "l_hip", "r_hip", "head"];
        for names in [names.to_vec(), names.iter().rev().copied().collect()] {
            let joint = |name: &&str| {
                format!("JOINT {name}\n{{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n}}\n")
            };
            let joints: String = names.iter().map(joint).collect();
            let text = format!("HIERARCHY\nROOT body\n{{\nOFFSET 0 0 0\n{joints}}}\n");
            let clip = bvh::parse(text.as_bytes(), bvh::Options::default()).expect("points").clip;
            let roles = Skeleton::main(&clip, &Overrides::default()).roles;
            let name = |role| roles.get(role).map(|joint| clip.joints()[joint].name.as_str());
            assert_eq!(name(Role::LeftAnkle), Some("l_ankle"));
            assert_eq!(name(Role::RightToe), Some("r_foot"));
        }
    }

    fn has_feet(limbs: &[&str]) -> bool {
        let clip = bvh::parse(body(limbs).as_bytes(), bvh::Options::default()).expect("a body").clip;
        Skeleton::main(&clip, &Overrides::default()).roles.has_feet()
    }

    #[test]
    fn quadrupeds_have_no_unique_pair_of_feet() {
        assert!(has_feet(&["1 0 0", "-1 0 0"]));
        assert!(!has_feet(&["1 0 0", "-1 0 0", "1 0 -6", "-1 0 -6"]));
        assert!(!has_feet(&["1 0 0"]));
    }

    #[test]
    fn a_body_with_arms_and_a_skirt_is_no_quadruped() {
        let joint = |name: &str| format!("JOINT {name}\n{{\nOFFSET 0 -9 0\n");
        let is_quadruped = |names: &[&str]| {
            let limbs = [["LeftUpLeg", "LeftLeg", "LeftFoot"], ["RightUpLeg", "RightLeg", "RightFoot"]];
            let limbs = limbs.map(|limb| limb.map(joint).concat() + "}\n}\n}\n").concat();
            let others: String = names.iter().map(|name| joint(name)).collect();
            let ends = "}\n".repeat(names.len() + 1);
            let text = format!("HIERARCHY\nROOT hips\n{{\nOFFSET 0 0 0\n{limbs}{others}{ends}");
            let clip = bvh::parse(text.as_bytes(), bvh::Options::default()).expect("a body").clip;
            super::assign_roles(&clip, 0).is_quadruped
        };
        assert!(is_quadruped(&["FrontA", "FrontB"]));
        assert!(is_quadruped(&["FrontA", "FrontB", "LeftFrontHand"]));
        assert!(!is_quadruped(&["FrontA", "FrontB", "LeftHand"]));
        assert!(!is_quadruped(&["SkirtFront1", "SkirtFront2"]));
    }
}
