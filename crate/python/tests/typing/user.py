"""Code of a user, which mypy checks in strict mode."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from typing_extensions import assert_type

import plantigrade
from plantigrade import Clip, Detection, Edit, Event, Segmentation, presets


def label(path: Path) -> NDArray[np.bool_]:
    clip = Clip.read(path, fps=120, roles={"left_ankle": "LFoot", "right_toe": None})
    assert_type(clip.positions, NDArray[np.float64])
    detection = plantigrade.detect(clip, method="robust", r=0.002)
    assert_type(detection, Detection)
    assert_type(detection.events, tuple[Event, ...])
    assert_type(detection.events[0].uncertainty, float | None)
    edited = detection.edit([Edit("left", "toe", 0, 3, True)])
    edited.save(path.with_suffix(".plants.json"))
    return edited.contact


def positions(array: NDArray[np.float32]) -> Segmentation:
    plantigrade.detect(array, fps=30, names=presets.SMPL)
    plantigrade.detect(array, fps=30, roles={"left_ankle": 7, "right_ankle": 8}, up="z", unit=0.01)
    cleaned = plantigrade.clean("walk.bvh", keep_spikes=True)
    cleaned.write("clean.bvh")
    cadence = plantigrade.gait(cleaned)["cadence_steps_per_min"]
    assert_type(cadence, float | None)
    plantigrade.score(cleaned, "walk.json")["contact"]
    return plantigrade.segment(cleaned)
