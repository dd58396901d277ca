"""Orders of joints in common use, with the role of each joint.

Pass a preset as ``names`` to :func:`plantigrade.detect` or :meth:`plantigrade.Clip.from_positions`::

    plantigrade.detect(joints[:, :24], fps=30, names=plantigrade.presets.SMPL)

A preset states the up axis and the unit only if the data always has them; both can be overridden.
"""

from __future__ import annotations

from typing import NamedTuple

__all__ = [
    "AMASS",
    "BODY_25",
    "COCO",
    "H36M",
    "HUMANML3D",
    "LAFAN1",
    "MEDIAPIPE",
    "SMPL",
    "SMPLH",
    "SMPLX",
    "Preset",
]


class Preset(NamedTuple):
    """An order of joints.

    Attributes
    ----------
    names : tuple of str
        Name of each joint in the library that defines the order.
    roles : dict of str to int
        Joint of each role.
    parents : tuple of int
        Parent of each joint, −1 for a root; empty if the order has none.
    up : str or None
        Up axis, if all data in this order has the same.
    unit : float or None
        Metres per unit, if all data in this order has the same.
    """

    names: tuple[str, ...]
    roles: dict[str, int]
    parents: tuple[int, ...] = ()
    up: str | None = None
    unit: float | None = None


_BODY = [
    "pelvis",
    "left_hip",
    "right_hip",
    "spine1",
    "left_knee",
    "right_knee",
    "spine2",
    "left_ankle",
    "right_ankle",
    "spine3",
    "left_foot",
    "right_foot",
    "neck",
    "left_collar",
    "right_collar",
    "head",
    "left_shoulder",
    "right_shoulder",
    "left_elbow",
    "right_elbow",
    "left_wrist",
    "right_wrist",
]
_BODY_PARENTS = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)
_BODY_ROLES = {
    "hips": 0,
    "spine": 3,
    "chest": 9,
    "neck": 12,
    "head": 15,
    "left_shoulder": 13,
    "left_arm": 16,
    "left_forearm": 18,
    "left_hand": 20,
    "right_shoulder": 14,
    "right_arm": 17,
    "right_forearm": 19,
    "right_hand": 21,
    "left_thigh": 1,
    "left_shank": 4,
    "left_ankle": 7,
    "left_toe": 10,
    "right_thigh": 2,
    "right_shank": 5,
    "right_ankle": 8,
    "right_toe": 11,
}


def _hands(wrists: tuple[int, int], first: int) -> tuple[list[str], list[int]]:
    """Return names and parents of the fingers of both hands."""
    names: list[str] = []
    parents: list[int] = []
    for side, wrist in zip(("left", "right"), wrists, strict=True):
        for finger in ("index", "middle", "pinky", "ring", "thumb"):
            for joint in (1, 2, 3):
                parents.append(wrist if joint == 1 else first + len(names) - 1)
                names.append(f"{side}_{finger}{joint}")
    return names, parents


_SMPLH_HANDS = _hands((20, 21), 22)
_SMPLX_HANDS = _hands((20, 21), 25)

SMPL = Preset(
    names=(*_BODY, "left_hand", "right_hand"),
    roles=_BODY_ROLES,
    parents=(*_BODY_PARENTS, 20, 21),
    unit=1.0,
)
"""The 24 joints of SMPL, in metres. Of a longer output of the model, use the first 24 joints."""

SMPLH = Preset(
    names=(*_BODY, *_SMPLH_HANDS[0]),
    roles=_BODY_ROLES,
    parents=(*_BODY_PARENTS, *_SMPLH_HANDS[1]),
    unit=1.0,
)
"""The 52 joints of SMPL+H, in metres."""

SMPLX = Preset(
    names=(*_BODY, "jaw", "left_eye_smplhf", "right_eye_smplhf", *_SMPLX_HANDS[0]),
    roles=_BODY_ROLES,
    parents=(*_BODY_PARENTS, 15, 15, 15, *_SMPLX_HANDS[1]),
    unit=1.0,
)
"""The 55 joints of SMPL-X, in metres. Of a longer output of the model, use the first 55 joints."""

AMASS = Preset(names=tuple(_BODY), roles=_BODY_ROLES, parents=_BODY_PARENTS, up="z", unit=1.0)
"""The 22 body joints of sequences of AMASS in their own coordinates: metres, Z up."""

HUMANML3D = Preset(names=tuple(_BODY), roles=_BODY_ROLES, parents=_BODY_PARENTS, up="y", unit=1.0)
"""The 22 joints of HumanML3D: metres, Y up."""

MEDIAPIPE = Preset(
    names=(
        "nose",
        "left_eye_inner",
        "left_eye",
        "left_eye_outer",
        "right_eye_inner",
        "right_eye",
        "right_eye_outer",
        "left_ear",
        "right_ear",
        "mouth_left",
        "mouth_right",
        "left_shoulder",
        "right_shoulder",
        "left_elbow",
        "right_elbow",
        "left_wrist",
        "right_wrist",
        "left_pinky",
        "right_pinky",
        "left_index",
        "right_index",
        "left_thumb",
        "right_thumb",
        "left_hip",
        "right_hip",
        "left_knee",
        "right_knee",
        "left_ankle",
        "right_ankle",
        "left_heel",
        "right_heel",
        "left_foot_index",
        "right_foot_index",
    ),
    roles={
        "head": 0,
        "left_arm": 11,
        "left_forearm": 13,
        "left_hand": 15,
        "right_arm": 12,
        "right_forearm": 14,
        "right_hand": 16,
        "left_thigh": 23,
        "left_shank": 25,
        "left_ankle": 27,
        "left_toe": 31,
        "right_thigh": 24,
        "right_shank": 26,
        "right_ankle": 28,
        "right_toe": 32,
    },
    up="-y",
    unit=1.0,
)
"""The 33 world landmarks of MediaPipe Pose: metres, Y down, relative to the hips."""

COCO = Preset(
    names=(
        "nose",
        "left_eye",
        "right_eye",
        "left_ear",
        "right_ear",
        "left_shoulder",
        "right_shoulder",
        "left_elbow",
        "right_elbow",
        "left_wrist",
        "right_wrist",
        "left_hip",
        "right_hip",
        "left_knee",
        "right_knee",
        "left_ankle",
        "right_ankle",
    ),
    roles={
        "head": 0,
        "left_arm": 5,
        "left_forearm": 7,
        "left_hand": 9,
        "right_arm": 6,
        "right_forearm": 8,
        "right_hand": 10,
        "left_thigh": 11,
        "left_shank": 13,
        "left_ankle": 15,
        "right_thigh": 12,
        "right_shank": 14,
        "right_ankle": 16,
    },
)
"""The 17 keypoints of COCO in three dimensions. There are no toes; the ankles are used."""

BODY_25 = Preset(
    names=(
        "Nose",
        "Neck",
        "RShoulder",
        "RElbow",
        "RWrist",
        "LShoulder",
        "LElbow",
        "LWrist",
        "MidHip",
        "RHip",
        "RKnee",
        "RAnkle",
        "LHip",
        "LKnee",
        "LAnkle",
        "REye",
        "LEye",
        "REar",
        "LEar",
        "LBigToe",
        "LSmallToe",
        "LHeel",
        "RBigToe",
        "RSmallToe",
        "RHeel",
    ),
    roles={
        "hips": 8,
        "neck": 1,
        "head": 0,
        "left_arm": 5,
        "left_forearm": 6,
        "left_hand": 7,
        "right_arm": 2,
        "right_forearm": 3,
        "right_hand": 4,
        "left_thigh": 12,
        "left_shank": 13,
        "left_ankle": 14,
        "left_toe": 19,
        "right_thigh": 9,
        "right_shank": 10,
        "right_ankle": 11,
        "right_toe": 22,
    },
)
"""The 25 keypoints of OpenPose's BODY_25 in three dimensions."""

H36M = Preset(
    names=(
        "Hip",
        "RHip",
        "RKnee",
        "RFoot",
        "LHip",
        "LKnee",
        "LFoot",
        "Spine",
        "Thorax",
        "Nose",
        "Head",
        "LShoulder",
        "LElbow",
        "LWrist",
        "RShoulder",
        "RElbow",
        "RWrist",
    ),
    roles={
        "hips": 0,
        "spine": 7,
        "chest": 8,
        "neck": 9,
        "head": 10,
        "left_arm": 11,
        "left_forearm": 12,
        "left_hand": 13,
        "right_arm": 14,
        "right_forearm": 15,
        "right_hand": 16,
        "left_thigh": 4,
        "left_shank": 5,
        "left_ankle": 6,
        "right_thigh": 1,
        "right_shank": 2,
        "right_ankle": 3,
    },
    parents=(-1, 0, 1, 2, 0, 4, 5, 0, 7, 8, 9, 8, 11, 12, 8, 14, 15),
)
"""The 17 joints of Human3.6M in common use. There are no toes; the ankles are used."""

LAFAN1 = Preset(
    names=(
        "Hips",
        "LeftUpLeg",
        "LeftLeg",
        "LeftFoot",
        "LeftToe",
        "RightUpLeg",
        "RightLeg",
        "RightFoot",
        "RightToe",
        "Spine",
        "Spine1",
        "Spine2",
        "Neck",
        "Head",
        "LeftShoulder",
        "LeftArm",
        "LeftForeArm",
        "LeftHand",
        "RightShoulder",
        "RightArm",
        "RightForeArm",
        "RightHand",
    ),
    roles={
        "hips": 0,
        "spine": 9,
        "chest": 11,
        "neck": 12,
        "head": 13,
        "left_shoulder": 14,
        "left_arm": 15,
        "left_forearm": 16,
        "left_hand": 17,
        "right_shoulder": 18,
        "right_arm": 19,
        "right_forearm": 20,
        "right_hand": 21,
        "left_thigh": 1,
        "left_shank": 2,
        "left_ankle": 3,
        "left_toe": 4,
        "right_thigh": 5,
        "right_shank": 6,
        "right_ankle": 7,
        "right_toe": 8,
    },
    parents=(-1, 0, 1, 2, 3, 0, 5, 6, 7, 0, 9, 10, 11, 12, 11, 14, 15, 16, 11, 18, 19, 20),
)
"""The 22 joints of LAFAN1."""
