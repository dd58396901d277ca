"""Arguments that cannot be used get an error that says what to do."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import plantigrade
from plantigrade import PlantigradeError

ANKLES = {"left_ankle": 0, "right_ankle": 1}


def positions(frames: int = 40, joints: int = 4) -> np.ndarray:
    generator = np.random.default_rng(0)
    return generator.normal(size=(frames, joints, 3))


def with_value(value: float) -> np.ndarray:
    array = positions()
    array[7, 1, 2] = value
    return array


@pytest.mark.parametrize(
    ("array", "message"),
    [
        (with_value(np.nan), "point 1 (1) in frame 7 is NaN.*interpolation"),
        (with_value(np.inf), "point 1 (1) in frame 7 is inf"),
        (with_value(1e12), "beyond"),
        (np.ma.masked_invalid(with_value(np.nan)), "masked values.*interpolation"),
        (positions()[:0], "no frames"),
        (positions()[:, :0], "no joints"),
        (positions()[..., :2], "shape (40, 4, 2).*lift"),
        (np.zeros((40, 4, 4)), "shape (40, 4, 4).*positions[..., :3]"),
        (positions().reshape(40, 12), "reshape(40, 4, 3)"),
        (positions()[0], "newaxis"),
        (positions()[None], "each clip of a batch"),
        (np.moveaxis(positions(), 2, 0), "moveaxis(positions, 0, 2)"),
        (np.float64(3), "shape ()"),
        ([[[1, 2, 3]], [[1, 2]]], "not an array"),
        (positions().astype(object), "objects, not numbers"),
        (positions().astype(complex), "complex128.*real numbers"),
        (positions() > 0, "bool"),
        ([[["a", "b", "c"]]], "type <U1"),
        (None, "objects, not numbers"),
    ],
)
def test_bad_arrays(array: Any, message: str) -> None:
    with pytest.raises(PlantigradeError) as error:
        plantigrade.detect(array, fps=30, roles=ANKLES)
    for part in message.split(".*"):
        assert part in str(error.value)
    assert error.value.hint


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"fps": None, "roles": ANKLES}, "Pass fps"),
        ({"fps": 0, "roles": ANKLES}, "from 1 to 1000 Hz, not 0"),
        ({"fps": -30, "roles": ANKLES}, "from 1 to 1000 Hz, not -30"),
        ({"fps": np.nan, "roles": ANKLES}, "not NaN"),
        ({"fps": 1 / 120, "roles": ANKLES}, "did you mean fps=120?"),
        ({"fps": "fast", "roles": ANKLES}, "not a number"),
        ({"fps": 30}, "which joint is which"),
        ({"fps": 30, "roles": {"left_ankle": 0}}, "Both feet are required"),
        ({"fps": 30, "roles": {}}, "Both feet are required"),
        ({"fps": 30, "roles": {"left_foot": 0}}, "unknown role 'left_foot'. Use one of"),
        ({"fps": 30, "roles": {"left_ankle": 4, "right_ankle": 1}}, "there are 4 joints"),
        ({"fps": 30, "roles": {"left_ankle": -1, "right_ankle": 1}}, "has joint -1"),
        ({"fps": 30, "roles": {"left_ankle": "a", "right_ankle": 1}}, "the joints have no names"),
        ({"fps": 30, "roles": {"left_ankle": 0, "right_ankle": 0}}, "different joints"),
        ({"fps": 30, "names": ["a"] * 3}, "3 names for 4 joints"),
        ({"fps": 30, "names": "left right"}, "single text"),
        ({"fps": 30, "names": list("abcd")}, "no feet were detected"),
        (
            {"fps": 30, "names": list("abcd"), "roles": {"left_ankle": "e"}},
            "The joints are a, b, c, d",
        ),
        ({"fps": 30, "names": list("aacd"), "roles": {"left_ankle": "a"}}, "indices 0, 1"),
        ({"fps": 30, "names": plantigrade.presets.SMPL}, "24 names for 4 joints"),
        ({"fps": 30, "roles": ANKLES, "parents": [1, 0, -1, -1]}, "own ancestor"),
        ({"fps": 30, "roles": ANKLES, "parents": [9, -1, 0, 1]}, "there are 4 points"),
        ({"fps": 30, "roles": ANKLES, "parents": [-1]}, "1 parents for 4 points"),
        ({"fps": 30, "roles": ANKLES, "parents": [0.5] * 4}, "list of indices"),
        ({"fps": 30, "roles": ANKLES, "up": "w"}, "must be x, y or z"),
        ({"fps": 30, "roles": ANKLES, "unit": 0}, "unit must be a number from"),
        ({"fps": 30, "roles": ANKLES, "method": "best"}, 'unknown method "best"'),
        ({"fps": 30, "roles": ANKLES, "r": 0}, "r must be greater than 0"),
        ({"fps": 30, "roles": ANKLES, "w": 99}, "w must be at most 16"),
        ({"fps": 30, "roles": ANKLES, "w": -1}, "negative"),
        ({"fps": 30, "roles": ANKLES, "sigma": np.nan}, "sigma must be greater"),
    ],
)
def test_bad_arguments(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(PlantigradeError) as error:
        plantigrade.detect(positions(), **arguments)
    assert message in str(error.value)


def test_identical_feet_are_rejected_with_advice() -> None:
    with pytest.raises(PlantigradeError, match="length of the legs is 0"):
        plantigrade.detect(np.zeros((30, 3, 3)), fps=30, roles={"hips": 0, "left_ankle": 1, "right_ankle": 2})


def test_errors_of_files_have_their_position(tmp_path: Path) -> None:
    path = tmp_path / "broken.bvh"
    path.write_text("HIERARCHY\nROOT Hips\n{\n\tOFFSET 0 0 abc\n}\n")
    with pytest.raises(PlantigradeError) as caught:
        plantigrade.Clip.read(path)
    error = caught.value
    assert (error.file, error.line, error.column) == ("broken.bvh", 4, 13)
    assert error.hint
    assert error.excerpt is not None and error.excerpt[error.caret :] == "abc"
    assert str(error).startswith('broken.bvh:4:13: expected a number, found "abc". ')
    restored = pickle.loads(pickle.dumps(error))
    assert str(restored) == str(error)
    assert isinstance(error, ValueError)


def test_missing_files_raise_the_error_of_the_system() -> None:
    with pytest.raises(FileNotFoundError, match=r"missing\.bvh"):
        plantigrade.detect("missing.bvh")


def test_sources_of_other_types_are_rejected(walk: plantigrade.Clip, tmp_path: Path) -> None:
    with pytest.raises(PlantigradeError, match="int is not a clip"):
        plantigrade.Clip.read(3)  # type: ignore[arg-type]
    path = tmp_path / "walk.bvh"
    walk.write(path)
    with path.open() as file, pytest.raises(PlantigradeError, match='mode "rb"'):
        plantigrade.Clip.read(file)  # type: ignore[arg-type]
    with pytest.raises(PlantigradeError, match="names and parents already"):
        plantigrade.detect(walk, names=["a"])


def test_clips_without_motion_or_feet_are_rejected() -> None:
    text = b"HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n}\n"
    with pytest.raises(PlantigradeError, match="no motion"):
        plantigrade.detect(plantigrade.Clip.read(text))
    moving = text + b"MOTION\nFrames: 2\nFrame Time: 0.1\n1\n2\n"
    with pytest.raises(PlantigradeError, match="no feet were detected"):
        plantigrade.detect(plantigrade.Clip.read(moving))


def test_labels_of_another_shape_are_rejected(walk: plantigrade.Clip) -> None:
    detection = plantigrade.detect(walk)
    for labels, message in [
        (detection.contact.T, "transpose"),
        (detection.contact[:-1], r"\(244, 2\)"),
        (detection.contact.astype(int) + 5, "other values than 0 and 1"),
        ({"sole": detection.contact}, 'unknown part "sole"'),
        ({}, "no labels"),
        (b"hello", "the file has no plants"),
        (np.full((245, 2), "x"), "type <U1"),
    ]:
        with pytest.raises(PlantigradeError, match=message):
            plantigrade.score(detection, labels)


def test_positions_cannot_be_cleaned(walk: plantigrade.Clip) -> None:
    points = plantigrade.Clip.from_positions(walk.positions, fps=walk.fps, roles=walk.skeleton.roles)
    with pytest.raises(PlantigradeError, match="no rotations"):
        plantigrade.clean(points)


def test_parts_without_labels_are_named(walk: plantigrade.Clip) -> None:
    with pytest.raises(PlantigradeError, match=r"paper does not label contact.*labels toe"):
        _ = plantigrade.detect(walk, method="paper").contact
