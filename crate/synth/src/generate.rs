//! Clip specification and clip generation.

use plantigrade::bvh::Clip;
use plantigrade::foot::Side;
use plantigrade::formats::PlantsDocument;

use crate::character::{Bone, Character, Proportions, character};
use crate::environment::Environment;
use crate::foot_path::{FootPath, FootPose};
use crate::math::Random;
use crate::math::TimeGrid;
use crate::math::Vec3;
use crate::motion::Motion;
use crate::pelvis::{self, PelvisPose};
use crate::plan::Plan;
use crate::pose::{self, IdleNoise, Pose};
use crate::{export, truth};

/// Specification of a generated clip.
#[derive(Clone, Debug)]
pub struct ClipSpec {
    /// Name of the clip; also the file name without extension.
    pub name: String,
    /// Character that performs the motion.
    pub character: Character,
    /// Motion to perform.
    pub motion: Motion,
    /// Number of frames in the file, including the leading T-pose.
    pub frames: usize,
    /// Frame rate, in Hz; must divide 240.
    pub rate: usize,
    /// True if frame 0 is a T-pose above the origin, as in many converted files.
    pub leading_t_pose: bool,
    /// Ground the motion takes place on, or the recording artefact applied to it.
    pub environment: Environment,
    /// Factor on the character's foot noise; 0 disables it.
    pub noise_level: f64,
}

/// A generated clip with its ground truth.
#[derive(Clone, Debug, PartialEq)]
pub struct Generated {
    /// The clip.
    pub clip: Clip,
    /// Contact of each foot in each frame.
    pub truth: PlantsDocument,
}

impl ClipSpec {
    /// Creates the specification of a clip on level ground, without a leading T-pose.
    ///
    /// # Panics
    /// If no character has the name `character`.
    pub fn new(
        name: &str,
        character_name: &str,
        motion: Motion,
        frames: usize,
        rate: usize,
        noise_level: f64,
    ) -> ClipSpec {
        ClipSpec {
            name: name.into(),
            character: character(character_name),
            motion,
            frames,
            rate,
            leading_t_pose: false,
            environment: Environment::Level,
            noise_level,
        }
    }
}

/// Pelvis sway, in metres per degree of upper-body sway.
const PELVIS_SWAY: f64 = 0.004;

/// Simulated time after the end of the clip, in seconds.
const MARGIN: f64 = 1.0;

impl ClipSpec {
    /// Number of frames that contain motion; the first is at time 0.
    fn motion_frames(&self) -> usize {
        self.frames - usize::from(self.leading_t_pose)
    }

    /// Duration of the motion, in seconds.
    pub fn seconds(&self) -> f64 {
        self.motion_frames() as f64 / self.rate as f64
    }

    /// Returns the plan of the clip that [`generate`] creates for the same `seed`.
    pub fn plan(&self, seed: u64) -> Plan {
        self.motion.plan(&self.character.proportions, self.seconds(), &mut stream(&self.name, seed, "motion"))
    }
}

/// Generates the clip of a specification. The seed determines the variation of the steps and the
/// noise.
pub fn generate(spec: &ClipSpec, seed: u64) -> Generated {
    let ClipSpec { name, character, frames, rate, .. } = spec;
    let proportions = &character.proportions;
    let (motion_frames, seconds) = (spec.motion_frames(), spec.seconds());
    let stream = |purpose: &str| stream(name, seed, purpose);

    let plan = spec.plan(seed);
    let grid = TimeGrid::new(plan.start, seconds + MARGIN);
    let paths = Side::BOTH.map(|side| FootPath::new(side, &plan.feet[side as usize], proportions));
    let mut feet = paths.each_ref().map(|path| grid.times().map(|time| path.at(time)).collect::<Vec<_>>());
    let mut pelvis = pelvis::track(&plan, proportions, &grid, &paths, &feet);
    pelvis::add_sway(&mut pelvis, PELVIS_SWAY * plan.body.sway, &mut stream("sway"));
    let noise = character.noise.scaled(spec.noise_level);
    let noise_heights = Side::BOTH.map(|side| {
        let (path, feet) = (&paths[side as usize], &mut feet[side as usize]);
        apply_leg_poses(feet, &pelvis, path, &grid, side, proportions);
        noise.apply(feet, path, &grid, &mut stream(side.name()))
    });
    pelvis::follow_foot_noise(&mut pelvis, &noise_heights);

    let idle_noise = IdleNoise::new(&grid, &mut stream("unrest"));
    let points: Vec<usize> = (0..motion_frames).map(|frame| grid.frame_point(frame, *rate)).collect();
    let mut poses: Vec<Pose> = Vec::with_capacity(*frames);
    let mut labels = paths.each_ref().map(|path| {
        points.iter().map(|&point| truth::contact_at(path, grid.time(point))).collect::<Vec<_>>()
    });
    if spec.leading_t_pose {
        // The T-pose frame carries the labels of the first motion frame.
        poses.push(Pose::t_pose(Vec3::new(
            0.0,
            proportions.ankle + proportions.leg_length() + proportions.pelvis_above_hips(),
            0.0,
        )));
        labels.iter_mut().for_each(|labels| labels.insert(0, labels[0]));
    }
    for &point in &points {
        let mut pose = Pose::t_pose(pelvis[point].position);
        pose.set_rotation(Bone::Hips, pelvis[point].rotation);
        for side in Side::BOTH {
            pose::solve_leg(&mut pose, &pelvis[point], &feet[side as usize][point], side, proportions);
        }
        pose::solve_upper_body(
            &mut pose,
            &pelvis,
            point,
            &grid,
            &plan.body,
            character.spine_joints,
            &idle_noise,
        );
        poses.push(pose);
    }

    spec.environment.apply(&mut poses, 1.0 / *rate as f64);
    let clip = export::to_clip(character, &poses, frame_time(*rate));
    let truth = truth::document(name, character, clip.rate(), spec.environment.ground_height(), &labels);
    Generated { clip, truth }
}

/// Returns the random stream of the clip `name` for one `purpose`.
pub(crate) fn stream(name: &str, seed: u64, purpose: &str) -> Random {
    Random::new(seed, &format!("{name} {purpose}"))
}

/// Returns the frame time in seconds, rounded to seven decimals as in BVH files.
fn frame_time(rate: usize) -> f64 {
    (1e7 / rate as f64).round() / 1e7
}

/// Applies the leg poses of the plan to the feet of one side and raises feet above the floor.
fn apply_leg_poses(
    feet: &mut [FootPose],
    pelvis: &[PelvisPose],
    path: &FootPath,
    grid: &TimeGrid,
    side: Side,
    proportions: &Proportions,
) {
    for (n, foot) in feet.iter_mut().enumerate() {
        let time = grid.time(n);
        if let Some((pose, weight)) = path.step(time).and_then(|step| step.leg_pose(time)) {
            pose::apply_leg_pose(foot, &pelvis[n], pose, weight, side, proportions);
        }
        foot.clear_floor(proportions);
    }
}
