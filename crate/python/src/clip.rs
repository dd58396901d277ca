//! Clips.

use std::ops::Range;
use std::sync::Arc;

use numpy::ndarray::Array3;
use numpy::{IntoPyArray, PyArray3, PyReadonlyArray3, PyUntypedArrayMethods};
use plantigrade::bvh::{self, FRAME_RATES, JointKind, Options, Parsed};
use plantigrade::foot::Side;
use plantigrade::kinematics::{self, Kinematics};
use plantigrade::plants::{self, Annotation};
use plantigrade::points::{PointClip, Points, PointsError};
use plantigrade::segments;
use plantigrade::skate::{self, CleanedPlant, Contacts};
use plantigrade::skeleton::{self, Overrides, Role, Skeleton};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;

use crate::clip_data::{ClipData, File};
use crate::detection::RawDetection;
use crate::failure::Failure;
use crate::params::{self, DetectParams, NoticeTuple, SegmentParams};
use crate::segmentation::RawSegmentation;

/// A role and its joint: an index, or `None` for no joint.
type RoleJoint = (String, Option<usize>);

/// Overrides: roles with their joint in the file, up axis and metres per unit.
type OverridesTuple = (Vec<(&'static str, Option<usize>)>, Option<String>, Option<f64>);

/// Result of the clean-up for a plant: side, first frame, end, slide before and after in metres, reason why
/// it was not corrected.
type CleanedTuple = (&'static str, usize, usize, f64, f64, Option<String>);

/// A clip of motion capture.
#[pyclass(frozen)]
pub struct RawClip(pub ClipData);

#[pymethods]
impl RawClip {
    /// Reads the bytes of a BVH file.
    #[staticmethod]
    fn read(py: Python<'_>, bytes: PyBackedBytes, name: String, lenient: bool) -> PyResult<RawClip> {
        Ok(py.detach(|| read(bytes, name, lenient))?)
    }

    /// Creates a clip of points.
    #[staticmethod]
    #[pyo3(signature = (positions, names, parents, fps, roles, up, unit))]
    #[expect(clippy::too_many_arguments, reason = "the package passes its arguments on")]
    fn from_points(
        py: Python<'_>,
        positions: PyReadonlyArray3<'_, f64>,
        names: Vec<String>,
        parents: Vec<i64>,
        fps: f64,
        roles: Vec<RoleJoint>,
        up: Option<&str>,
        unit: Option<f64>,
    ) -> PyResult<RawClip> {
        if positions.shape()[0] == 0 {
            return Err(Failure::from(PointsError::NoFrames).into());
        }
        let positions = positions.as_slice()?;
        let overrides = Overrides { roles: parse_roles(roles)?, up: params::up(up)?, metres_per_unit: unit };
        let parents: Vec<Option<usize>> =
            parents.iter().map(|&parent| usize::try_from(parent).ok()).collect();
        Ok(py.detach(|| {
            let points = Points { positions, names: &names, parents: &parents, rate: fps };
            let PointClip { clip, skeleton, joints } = points.clip(&overrides).map_err(Failure::from)?;
            let roles = overrides.roles.iter().map(|&(role, point)| (role, point.map(|point| joints[point])));
            let overrides = Overrides { roles: roles.collect(), ..overrides };
            Ok::<_, Failure>(RawClip(ClipData {
                clip: Arc::new(clip),
                skeleton,
                notices: Vec::new(),
                name: String::new(),
                file: None,
                points: Some(joints.into()),
                overrides,
                cleaned: Arc::default(),
            }))
        })?)
    }

    /// Returns the clip with overrides; absent ones stay as they are.
    fn overridden(
        &self,
        py: Python<'_>,
        fps: Option<f64>,
        roles: Vec<RoleJoint>,
        up: Option<&str>,
        unit: Option<f64>,
    ) -> PyResult<RawClip> {
        let (roles, up) = (parse_roles(roles)?, params::up(up)?);
        let mut data = self.0.clone();
        Ok(py.detach(|| {
            if let Some(rate) = fps {
                if !FRAME_RATES.contains(&rate) {
                    return Err(Failure::from(PointsError::Rate(rate)));
                }
                Arc::make_mut(&mut data.clip).set_frame_time(1.0 / rate);
            }
            if let Some(unit) = unit.filter(|unit| !skeleton::UNITS.contains(unit)) {
                return Err(Failure::from(PointsError::Unit(unit)));
            }
            for (role, joint) in roles {
                let joint = joint.map(|joint| data.joint(joint));
                data.overrides.roles.retain(|(other, _)| *other != role);
                data.overrides.roles.push((role, joint));
            }
            data.overrides.up = up.or(data.overrides.up);
            data.overrides.metres_per_unit = unit.or(data.overrides.metres_per_unit);
            data.skeleton = Skeleton::main(&data.clip, &data.overrides);
            Ok(RawClip(data))
        })?)
    }

    /// Returns the overrides: roles with their joint in the file, up axis and metres per unit.
    fn overrides(&self) -> OverridesTuple {
        let Overrides { roles, up, metres_per_unit, .. } = &self.0.overrides;
        let roles = roles.iter().map(|&(role, joint)| (role.name(), joint)).collect();
        (roles, up.map(|up| up.to_string()), *metres_per_unit)
    }

    /// Returns the clip with these overrides instead of its own; joints are those of the file.
    fn with_overrides(
        &self,
        py: Python<'_>,
        fps: f64,
        joints: Vec<RoleJoint>,
        up: Option<&str>,
        unit: Option<f64>,
    ) -> PyResult<RawClip> {
        let mut data = self.0.clone();
        data.overrides =
            Overrides { roles: parse_roles(joints)?, up: params::up(up)?, metres_per_unit: unit };
        RawClip(data).overridden(py, Some(fps), Vec::new(), None, None)
    }

    /// Names of the joints and end sites.
    fn names(&self) -> Vec<String> {
        let joints = self.0.clip.joints();
        self.0.joints().into_iter().map(|joint| joints[joint].name.clone()).collect()
    }

    /// Parents of the joints; −1 for a root.
    fn parents(&self) -> Vec<i64> {
        let joints = self.0.clip.joints();
        let parent = |joint: usize| joints[joint].parent.and_then(|parent| self.0.index(parent));
        self.0.joints().into_iter().map(|joint| parent(joint).map_or(-1, |parent| parent as i64)).collect()
    }

    /// Indices of the end sites.
    fn end_sites(&self) -> Vec<usize> {
        let joints = self.0.clip.joints();
        let is_end = |&joint: &usize| joints[joint].kind == JointKind::EndSite;
        (0..joints.len()).filter(is_end).filter(|_| self.0.points.is_none()).collect()
    }

    /// Number of frames.
    fn frames(&self) -> usize {
        self.0.clip.frame_count()
    }

    /// Frame rate, in Hz.
    fn fps(&self) -> f64 {
        self.0.clip.rate()
    }

    /// Name of the file.
    fn name(&self) -> &str {
        &self.0.name
    }

    /// True if the clip has rotations: it was read from a file.
    fn has_rotations(&self) -> bool {
        self.0.points.is_none()
    }

    /// Up axis, metres per unit, name of the unit, and leg length in units.
    fn scale(&self) -> (String, f64, Option<&'static str>, Option<f64>) {
        let Skeleton { up, metres_per_unit, leg, .. } = &self.0.skeleton;
        (up.to_string(), *metres_per_unit, skeleton::unit_name(*metres_per_unit), *leg)
    }

    /// Roles with their joint, confidence and reasons.
    fn roles(&self) -> Vec<(&'static str, usize, f64, Vec<&'static str>)> {
        let roles = &self.0.skeleton.roles;
        let entry = |role: Role| {
            let assignment = roles.assignment(role)?;
            let reasons = assignment.reasons.iter().map(|reason| reason.description()).collect();
            Some((role.name(), self.0.index(assignment.joint)?, assignment.confidence(), reasons))
        };
        Role::ALL.into_iter().filter_map(entry).collect()
    }

    /// Notices of the reader and of the skeleton.
    fn notices(&self) -> Vec<NoticeTuple> {
        params::notices(self.0.notices.iter().chain(&self.0.skeleton.notices))
    }

    /// Positions of all joints in file units and axes: frames (or one rest pose) × joints × 3.
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let positions = py.detach(|| {
            let clip = &*self.0.clip;
            let joints = self.0.joints();
            let frames = kinematics::pose_count(clip);
            let mut values = Vec::with_capacity(frames * joints.len() * 3);
            let mut kinematics = Kinematics::new(clip);
            for frame in 0..frames {
                let pose = kinematics.pose(frame);
                values.extend(joints.iter().flat_map(|&joint| <[f64; 3]>::from(pose[joint])));
            }
            Array3::from_shape_vec((frames, joints.len(), 3), values)
        });
        Ok(positions.map_err(crate::failure::display)?.into_pyarray(py))
    }

    /// Bytes of the clip as a BVH file.
    fn to_bytes(&self, py: Python<'_>) -> Vec<u8> {
        py.detach(|| bytes(&self.0))
    }

    /// Detects the plants; `still` is a standing clip of the same character.
    fn detect(
        &self,
        py: Python<'_>,
        params: DetectParams,
        still: Option<&RawClip>,
    ) -> PyResult<RawDetection> {
        let (data, still) = (&self.0, still.map(|clip| &clip.0));
        Ok(py.detach(|| {
            let params = params.check()?;
            let feet = data.feet()?;
            let detection = match still {
                Some(still) => plants::detect_with_standing(&feet, &still.feet()?, params),
                None => plants::detect(&feet, params),
            };
            Ok::<_, Failure>(RawDetection::new(data.clone(), detection))
        })?)
    }

    /// Segments the motion.
    fn segment(&self, py: Python<'_>, params: SegmentParams) -> PyResult<RawSegmentation> {
        let data = &self.0;
        Ok(py.detach(|| {
            let params = params.check()?;
            let segmentation = segments::segment(&data.clip, &data.skeleton, params, &mut |_| Ok(()))
                .map_err(|error| Failure::from(error).in_file(&data.name))?;
            Ok::<_, Failure>(RawSegmentation::new(data.clone(), segmentation))
        })?)
    }

    /// Returns the clip without foot skate, by labels.
    fn clean(
        &self,
        py: Python<'_>,
        labels: Vec<params::PartLabels>,
        keep_spikes: bool,
        only: Vec<(String, usize, usize)>,
    ) -> PyResult<RawClip> {
        let annotation = params::annotation(labels, self.0.clip.frame_count())?;
        let mut ranges = Vec::new();
        for (side, start, end) in only {
            ranges.push((params::side(&side)?, start..end));
        }
        Ok(py.detach(|| clean(&self.0, &annotation, keep_spikes, ranges))?)
    }

    /// Results of the clean-up.
    fn cleaned(&self) -> Vec<CleanedTuple> {
        let result = |plant: &CleanedPlant| {
            let Range { start, end } = plant.frames;
            let reason = plant.skip_reason.map(|reason| reason.to_string());
            (plant.side.name(), start, end, plant.before, plant.after, reason)
        };
        self.0.cleaned.iter().map(result).collect()
    }
}

fn read(bytes: PyBackedBytes, name: String, lenient: bool) -> Result<RawClip, Failure> {
    let parsed = bvh::parse(&bytes, Options { lenient, ..Options::default() });
    let Parsed { clip, notices, layout } = parsed.map_err(|error| Failure::from(error).in_file(&name))?;
    let overrides = Overrides::default();
    Ok(RawClip(ClipData {
        skeleton: Skeleton::main(&clip, &overrides),
        clip: Arc::new(clip),
        notices,
        name,
        file: Some(File { bytes: Arc::new(bytes), layout }),
        points: None,
        overrides,
        cleaned: Arc::default(),
    }))
}

/// Returns a clip as BVH: the text of its file with the numbers that differ, or a new file.
fn bytes(data: &ClipData) -> Vec<u8> {
    match &data.file {
        Some(File { bytes, layout }) => bvh::rewrite(bytes, layout, &data.clip, 0..data.clip.frame_count()),
        None => bvh::write(&data.clip).into_bytes(),
    }
}

/// Removes foot skate. The result is the clip that its file contains, with the rounding of the file.
fn clean(
    data: &ClipData,
    labels: &Annotation,
    keep_spikes: bool,
    only: Vec<(Side, Range<usize>)>,
) -> Result<RawClip, Failure> {
    if data.file.is_none() {
        return Err(Failure::new(
            "positions have no rotations, which the clean-up changes",
            "Read the motion from a BVH file to clean it.",
        ));
    }
    let options = skate::Options { repair_spikes: !keep_spikes, only, ..skate::Options::default() };
    let cleaned = skate::clean(&data.clip, &data.skeleton, &Contacts::from(labels), &options)
        .map_err(|error| Failure::from(error).in_file(&data.name))?;
    let written = bytes(&ClipData { clip: Arc::new(cleaned.clip), ..data.clone() });
    let (bytes, parsed) = Python::attach(|py| {
        let bytes = PyBackedBytes::from(pyo3::types::PyBytes::new(py, &written));
        let parsed = py.detach(|| bvh::parse(&written, Options::default()));
        (bytes, parsed)
    });
    let Parsed { mut clip, layout, .. } = parsed?;
    clip.set_frame_time(data.clip.frame_time());
    Ok(RawClip(ClipData {
        clip: Arc::new(clip),
        notices: [&data.notices[..], &cleaned.notices].concat(),
        file: Some(File { bytes: Arc::new(bytes), layout }),
        cleaned: cleaned.plants.into(),
        ..data.clone()
    }))
}

fn parse_roles(roles: Vec<RoleJoint>) -> Result<Vec<(Role, Option<usize>)>, Failure> {
    roles.into_iter().map(|(name, joint)| Ok((params::role(&name)?, joint))).collect()
}
