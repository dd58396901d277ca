//! A recipe for a clip, and the cooking of it.

use plantigrade::bvh::Clip;
use plantigrade::foot::Side;
use plantigrade::formats::Document;

use crate::character::{Bone, Build, Character, character};
use crate::feet::{FootPath, FootPose};
use crate::grid::Grid;
use crate::maths::Vec3;
use crate::motion::Motion;
use crate::pelvis::{self, PelvisPose};
use crate::plan::Plan;
use crate::pose::{self, Pose, Restlessness};
use crate::random::Random;
use crate::setting::Setting;
use crate::{bake, truth};

/// What makes a clip.
#[derive(Clone, Debug)]
pub struct Recipe {
    /// The clip's name: the file's, without extension.
    pub name: String,
    /// Who moves.
    pub character: Character,
    /// What they do.
    pub motion: Motion,
    /// Frames of the file.
    pub frames: usize,
    /// Frames per second: a divisor of 240.
    pub rate: usize,
    /// Whether frame 0 is a T-pose over the origin, as in many conversions.
    pub leading_t_pose: bool,
    /// What becomes of the motion as a whole.
    pub setting: Setting,
    /// Strength of the noise: 1 is the character's own, 0 none.
    pub noise_level: f64,
}

/// A clip with its truth.
#[derive(Clone, Debug, PartialEq)]
pub struct Generated {
    /// The motion.
    pub clip: Clip,
    /// What each foot does in each frame.
    pub truth: Document,
}

impl Recipe {
    /// A clip of the performer called `performer` on level ground.
    ///
    /// # Panics
    /// If there is no such performer.
    pub fn new(
        name: &str,
        performer: &str,
        motion: Motion,
        frames: usize,
        rate: usize,
        noise_level: f64,
    ) -> Recipe {
        Recipe {
            name: name.into(),
            character: character(performer),
            motion,
            frames,
            rate,
            leading_t_pose: false,
            setting: Setting::Level,
            noise_level,
        }
    }
}

/// Sway of the pelvis that goes with each degree of restlessness, in metres.
const SWAY: f64 = 0.004;

/// Seconds that are worked out beyond the clip's end.
const MARGIN: f64 = 1.0;

impl Recipe {
    /// Frames without a T-pose before them: the first is at time 0.
    fn moving(&self) -> usize {
        self.frames - usize::from(self.leading_t_pose)
    }

    /// Seconds that the motion lasts.
    pub fn seconds(&self) -> f64 {
        self.moving() as f64 / self.rate as f64
    }

    /// The plan of the clip that [`generate`] makes of the same `seed`.
    pub fn plan(&self, seed: u64) -> Plan {
        self.motion.plan(&self.character.build, self.seconds(), &mut stream(&self.name, seed, "motion"))
    }
}

/// The clip of `recipe`; another `seed` gives other steps and other noise.
pub fn generate(recipe: &Recipe, seed: u64) -> Generated {
    let Recipe { name, character, frames, rate, .. } = recipe;
    let build = &character.build;
    let (moving, seconds) = (recipe.moving(), recipe.seconds());
    let stream = |purpose: &str| stream(name, seed, purpose);

    let plan = recipe.plan(seed);
    let grid = Grid::new(plan.start, seconds + MARGIN);
    let paths = Side::BOTH.map(|side| FootPath::new(side, &plan.feet[side as usize], build));
    let mut feet = paths.each_ref().map(|path| grid.times().map(|time| path.at(time)).collect::<Vec<_>>());
    let mut pelvis = pelvis::track(&plan, build, &grid, &paths, &feet);
    pelvis::sway(&mut pelvis, SWAY * plan.body.sway, &mut stream("sway"));
    let noise = character.noise.times(recipe.noise_level);
    let moved = Side::BOTH.map(|side| {
        let (path, feet) = (&paths[side as usize], &mut feet[side as usize]);
        hold(feet, &pelvis, path, &grid, side, build);
        noise.disturb(feet, path, &grid, &mut stream(side.name()))
    });
    pelvis::lift(&mut pelvis, &moved);

    let rest = Restlessness::new(&grid, &mut stream("unrest"));
    let points: Vec<usize> = (0..moving).map(|frame| grid.of_frame(frame, *rate)).collect();
    let mut poses: Vec<Pose> = Vec::with_capacity(*frames);
    let mut labels = paths
        .each_ref()
        .map(|path| points.iter().map(|&point| truth::parts(path, grid.time(point))).collect::<Vec<_>>());
    if recipe.leading_t_pose {
        // A single still pose: it stands as the motion will begin.
        poses.push(Pose::rest(Vec3::new(0.0, build.ankle + build.leg() + build.pelvis_rise(), 0.0)));
        labels.iter_mut().for_each(|labels| labels.insert(0, labels[0]));
    }
    for &point in &points {
        let mut pose = Pose::rest(pelvis[point].position);
        pose.set(Bone::Hips, pelvis[point].rotation);
        for side in Side::BOTH {
            pose::leg(&mut pose, &pelvis[point], &feet[side as usize][point], side, build);
        }
        pose::upper(&mut pose, &pelvis, point, &grid, &plan.body, character.spine_joints, &rest);
        poses.push(pose);
    }

    recipe.setting.apply(&mut poses, 1.0 / *rate as f64);
    let clip = bake::clip(character, &poses, frame_time(*rate));
    let truth = truth::document(name, character, clip.rate(), recipe.setting.floor(), &labels);
    Generated { clip, truth }
}

/// The random numbers of the clip called `name` for `purpose`.
pub(crate) fn stream(name: &str, seed: u64, purpose: &str) -> Random {
    Random::new(seed, &format!("{name} {purpose}"))
}

/// Seconds from frame to frame, with the seven decimals that files have.
fn frame_time(rate: usize) -> f64 {
    (1e7 / rate as f64).round() / 1e7
}

/// Poses the legs that are held in the air.
fn hold(
    feet: &mut [FootPose],
    pelvis: &[PelvisPose],
    path: &FootPath,
    grid: &Grid,
    side: Side,
    build: &Build,
) {
    for (n, foot) in feet.iter_mut().enumerate() {
        let time = grid.time(n);
        if let Some((pose, share)) = path.step(time).and_then(|step| step.held(time)) {
            pose::hold(foot, &pelvis[n], pose, share, side, build);
        }
        foot.clear_floor(build);
    }
}
