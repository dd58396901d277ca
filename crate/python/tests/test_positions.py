"""Detection in arrays of positions."""

from __future__ import annotations

import ast
import importlib.util
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import plantigrade
from plantigrade import Clip, presets

LEGS = ("hips", "left_thigh", "left_shank", "left_ankle", "left_toe")
ROLES = (*LEGS, *(role.replace("left", "right") for role in LEGS[1:]))


@pytest.fixture(scope="module")
def expected(walk: Clip) -> np.ndarray:
    return plantigrade.detect(walk).contact


def legs(walk: Clip, roles: tuple[str, ...] = ROLES) -> tuple[np.ndarray, dict[str, int]]:
    """Return the positions of some joints, and their roles."""
    joints = [walk.skeleton.roles[role] for role in roles]
    return walk.positions[:, joints], {role: index for index, role in enumerate(roles)}


def agreement(detection: plantigrade.Detection, expected: np.ndarray) -> float:
    return float((detection.contact == expected).mean())


def test_other_types_of_numbers_are_converted(walk: Clip, expected: np.ndarray) -> None:
    array, roles = legs(walk)
    options: dict[str, Any] = {"fps": walk.fps, "roles": roles, "up": "y", "unit": walk.unit}
    exact = plantigrade.detect(array, **options)
    fortran = np.asfortranarray(array)
    strided = np.repeat(array, 2, axis=1)[:, ::2]
    read_only = array.copy()
    read_only.flags.writeable = False
    swapped = array.astype(">f8")
    for same in (fortran, strided, read_only, swapped, array.tolist(), np.longdouble(array)):
        assert np.array_equal(plantigrade.detect(same, **options).contact, exact.contact)
    assert agreement(plantigrade.detect(array.astype(np.float32), **options), expected) > 0.99
    millimetres = np.round(array * walk.unit * 1000).astype(np.int32)
    detection = plantigrade.detect(millimetres, **{**options, "unit": 0.001})
    assert agreement(detection, expected) > 0.97


def test_arrays_are_not_changed(walk: Clip) -> None:
    array, roles = legs(walk)
    before = array.copy()
    plantigrade.detect(array, fps=walk.fps, roles=roles)
    assert np.array_equal(array, before)


def test_units_and_axes_are_found(walk: Clip, expected: np.ndarray) -> None:
    array, roles = legs(walk)
    rotated = array[..., [2, 0, 1]] * walk.unit * 100
    detection = plantigrade.detect(rotated, fps=walk.fps, roles=roles)
    assert (detection.clip.up, detection.clip.skeleton.unit_name) == ("z", "cm")
    assert agreement(detection, expected) > 0.99


def test_names_are_sufficient(walk: Clip, expected: np.ndarray) -> None:
    array, _ = legs(walk)
    names = [walk.names[walk.skeleton.roles[role]] for role in ROLES]
    detection = plantigrade.detect(array, fps=walk.fps, names=names)
    assert agreement(detection, expected) > 0.99
    assert detection.clip.skeleton.roles["left_ankle"] == 3


def test_parents_are_sufficient(walk: Clip, expected: np.ndarray) -> None:
    detection = plantigrade.detect(walk.positions, fps=walk.fps, parents=walk.parents)
    roles = detection.clip.skeleton.roles
    found = {roles[role] for role in ("left_ankle", "right_ankle")}
    assert found == {walk.skeleton.roles[role] for role in ("left_ankle", "right_ankle")}
    assert any(notice.code == "doubtful-role" for notice in detection.notices)


def test_what_is_missing_is_assumed_with_a_notice(walk: Clip, expected: np.ndarray) -> None:
    def texts(roles: tuple[str, ...], **options: Any) -> str:
        array, indices = legs(walk, roles)
        detection = plantigrade.detect(array, fps=walk.fps, roles=indices, **options)
        assert agreement(detection, expected) > 0.85
        return " ".join(notice.text for notice in detection.notices)

    no_toes = tuple(role for role in ROLES if "toe" not in role)
    assert "no toe joints" in texts(no_toes)
    assert "middle of both hip joints" in texts(ROLES[1:])
    ankles = texts(("left_ankle", "right_ankle"), unit=walk.unit, up="y")
    assert "mean of all points" in ankles
    assert "legs of 0.9 m are assumed" in ankles


def test_clips_of_positions_keep_their_order(walk: Clip) -> None:
    array, roles = legs(walk)
    parents = [-1, 0, 1, 2, 3, 0, 5, 6, 7]
    order = np.random.default_rng(0).permutation(9)
    shuffled_parents = [
        -1 if parents[joint] < 0 else int(np.where(order == parents[joint])[0][0]) for joint in order
    ]
    clip = Clip.from_positions(
        array[:, order],
        fps=walk.fps,
        names=[ROLES[joint] for joint in order],
        parents=shuffled_parents,
    )
    assert np.array_equal(clip.positions, array[:, order])
    assert list(clip.parents) == shuffled_parents
    assert clip.names == tuple(ROLES[joint] for joint in order)
    assert clip.skeleton.roles["left_ankle"] == list(order).index(roles["left_ankle"])
    assert clip.end_sites == ()
    read = Clip.read(clip.to_bytes())
    assert np.allclose(read.positions[:, [read.names.index(name) for name in clip.names]], clip.positions)


def test_unconnected_points_have_no_parents(walk: Clip) -> None:
    array, roles = legs(walk)
    clip = Clip.from_positions(array, fps=walk.fps, roles=roles)
    assert clip.parents == (-1,) * 9
    assert clip.names == tuple(map(str, range(9)))


def test_roles_can_be_overridden(walk: Clip) -> None:
    array, roles = legs(walk)
    clip = Clip.from_positions(array, fps=walk.fps, roles=roles)
    other = clip.override(roles={"left_toe": None}, fps=60)
    assert "left_toe" not in other.skeleton.roles and other.fps == 60
    assert clip.skeleton.roles["left_toe"] == 4


@pytest.mark.parametrize("name", sorted(set(presets.__all__) - {"Preset"}))
def test_presets_label_a_walk(walk: Clip, expected: np.ndarray, name: str) -> None:
    preset: presets.Preset = getattr(presets, name)
    roles = walk.skeleton.roles
    metres = walk.positions * walk.unit
    array = np.zeros((len(walk), len(preset.names), 3))
    array[:] = metres[:, [roles["hips"]]]
    for role, joint in preset.roles.items():
        array[:, joint] = metres[:, roles[role]]
    if preset.up == "z":
        array = array[..., [2, 0, 1]]
    if preset.up == "-y":
        array = array * [1, -1, -1]
    detection = plantigrade.detect(array, fps=walk.fps, names=preset)
    assert agreement(detection, expected) > (0.97 if "left_toe" in preset.roles else 0.85)
    assert detection.clip.skeleton.roles.keys() >= preset.roles.keys()
    assert set(preset.roles) <= set(plantigrade.roles())
    assert not preset.parents or len(preset.parents) == len(preset.names)


def package_file(package: str, path: str) -> Path:
    """Return a file of an installed package, which is not imported."""
    spec = importlib.util.find_spec(package)
    if spec is None or not spec.submodule_search_locations:
        pytest.skip(f"{package} is not installed")
    return Path(next(iter(spec.submodule_search_locations))) / path


def test_presets_are_those_of_mediapipe() -> None:
    source = package_file("mediapipe", "tasks/python/vision/pose_landmarker.py").read_text()
    landmarks = next(
        node
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.ClassDef) and node.name == "PoseLandmark"
    )
    names = [
        (ast.literal_eval(node.value), node.targets[0].id.lower())  # type: ignore[attr-defined]
        for node in landmarks.body
        if isinstance(node, ast.Assign)
    ]
    assert list(presets.MEDIAPIPE.names) == [name for _, name in sorted(names)]


def test_presets_are_those_of_smplx() -> None:
    path = package_file("smplx", "joint_names.py")
    spec = importlib.util.spec_from_file_location("joint_names", path)
    assert spec is not None and spec.loader is not None
    smplx = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(smplx)
    assert list(presets.SMPL.names[:22]) == list(smplx.JOINT_NAMES[:22])
    assert list(presets.SMPLH.names) == list(smplx.SMPLH_JOINT_NAMES[:52])
    assert list(presets.SMPLX.names) == list(smplx.JOINT_NAMES[:55])
    assert list(presets.AMASS.names) == list(presets.HUMANML3D.names) == list(smplx.JOINT_NAMES[:22])
