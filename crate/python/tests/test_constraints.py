"""Corrected labels are applied to similar motion, as by the command line."""

from __future__ import annotations

import json
import pickle
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import SAMPLES

import plantigrade
from plantigrade import Detection, PlantigradeError

JOG, OTHER = SAMPLES / "straight-jog.bvh", SAMPLES / "ballet.bvh"


@pytest.fixture(scope="module")
def edited() -> Detection:
    """A detection in which a plant ends three frames earlier."""
    detection = plantigrade.detect(JOG)
    plants = [plant for plant in detection.intervals if (plant.side, plant.part) == ("left", "contact")]
    plant = plants[3]
    return detection.edit(
        [
            ("left", "contact", plant.start, plant.end - 3, True),
            ("left", "contact", plant.end - 3, plant.end, False),
        ]
    )


def test_constraints_change_similar_plants(edited: Detection) -> None:
    corrected = plantigrade.detect(JOG, constraints=edited)
    assert "similar plants" in corrected.notices[-1].text
    changed = corrected.contact != edited.contact
    assert changed.any()
    assert corrected.edits == edited.edits


def test_all_sources_of_constraints_are_equal(edited: Detection, tmp_path: Path) -> None:
    path = tmp_path / "edits.json"
    edited.save(path)
    labels = np.full(edited.contact.shape, -1)
    for edit in edited.edits:
        labels[edit.start : edit.end, 0] = edit.planted
    expected = plantigrade.detect(JOG, constraints=edited)
    for constraints in (
        path,
        str(path),
        path.read_bytes(),
        edited.to_dict(),
        edited.edits,
        list(map(tuple, edited.edits)),
        labels,
        np.where(labels < 0, np.nan, labels),
        {"contact": labels},
    ):
        assert np.array_equal(plantigrade.detect(JOG, constraints=constraints).contact, expected.contact)
    restored = pickle.loads(pickle.dumps(expected))
    assert restored.to_dict() == expected.to_dict()


def test_further_edits_are_added_to_corrections(edited: Detection) -> None:
    corrected = plantigrade.detect(JOG, constraints=edited)
    further = corrected.edit([("right", "contact", 0, 4, True)])
    assert further.contact[:4, 1].all()
    assert np.array_equal(further.contact[4:, 0], corrected.contact[4:, 0])
    assert len(further.edits) == len(edited.edits) + 1
    again = plantigrade.detect(JOG, constraints=further)
    assert np.array_equal(again.contact[:, 0], corrected.contact[:, 0])


@pytest.mark.parametrize("clip", [None, JOG, OTHER])
def test_results_are_those_of_the_command_line(
    program: str, edited: Detection, tmp_path: Path, clip: Path | None
) -> None:
    path = tmp_path / "edits.json"
    edited.save(path)
    for source in [JOG, *([OTHER, SAMPLES / "limp-to-run.bvh"] if clip == JOG else [])]:
        command = [program, "detect", str(source), "--constraints", str(path)]
        arguments: dict[str, Any] = {"constraints": path}
        if clip is not None:
            command += ["--constraints-clip", str(clip)]
            arguments["constraints_clip"] = clip
        output = subprocess.run(command, check=False, capture_output=True, text=True)
        if output.returncode:
            with pytest.raises(PlantigradeError) as error:
                plantigrade.detect(source, **arguments)
            assert error.value.message in output.stderr
        else:
            assert plantigrade.detect(source, **arguments).to_dict() == json.loads(output.stdout)


def test_a_detection_brings_its_clip(edited: Detection) -> None:
    with_clip = plantigrade.detect(OTHER, constraints=edited.edits, constraints_clip=JOG)
    assert plantigrade.detect(OTHER, constraints=edited).to_dict() == with_clip.to_dict()
    # Other motion retains its labels.
    assert np.array_equal(with_clip.contact, plantigrade.detect(OTHER).contact)


def test_positions_are_corrected_like_files(edited: Detection) -> None:
    clip = edited.clip
    options: dict[str, Any] = {
        "fps": clip.fps,
        "roles": clip.skeleton.roles,
        "up": clip.up,
        "unit": clip.unit,
    }
    expected = plantigrade.detect(JOG, constraints=edited)
    same = plantigrade.detect(clip.positions, constraints=edited.edits, **options)
    assert np.array_equal(same.contact, expected.contact)
    other = plantigrade.detect(
        clip.positions, constraints=edited.edits, constraints_clip=clip.positions, **options
    )
    assert np.array_equal(other.contact, expected.contact)


def test_batches_use_the_corrections_of_a_clip(edited: Detection, tmp_path: Path) -> None:
    files = [JOG, OTHER]
    with pytest.raises(PlantigradeError, match=r"belong to one clip, but there are 2.*constraints_clip"):
        plantigrade.batch(files, out=tmp_path, progress=False, constraints=edited.edits)
    for constraints in ({"constraints": edited}, {"constraints": edited.edits, "constraints_clip": JOG}):
        result = plantigrade.batch(files, out=tmp_path, progress=False, force=True, **constraints)
        assert not result.failures and result[0].is_new
        document = json.loads((tmp_path / "straight-jog.plants.json").read_text())
        assert document == plantigrade.detect(JOG, constraints=edited).to_dict()
    repeated = plantigrade.batch(files, out=tmp_path, progress=False, **constraints)
    assert not repeated[0].is_new


def test_unusable_constraints_are_rejected(edited: Detection) -> None:
    plain = plantigrade.detect(JOG)
    for arguments, message in [
        ({"constraints": plain}, r"has no edits.*detection\.edit"),
        ({"constraints": plain.to_bytes()}, "no edits"),
        ({"constraints": edited.to_bytes(), "constraints_clip": OTHER}, "frames, but the clip has"),
        ({"constraints": np.ones((3, 2))}, r"shape \(3, 2\)"),
        ({"constraints": [("left", "sole", 0, 3, True)]}, 'unknown part "sole"'),
        ({"constraints": [("left", "contact", -1, 3, True)]}, "negative"),
        ({"constraints_clip": JOG}, "has no constraints"),
    ]:
        with pytest.raises(PlantigradeError, match=message):
            plantigrade.detect(JOG, **arguments)
    with pytest.raises(FileNotFoundError):
        plantigrade.detect(JOG, constraints="missing.json")
