"""The package and the command line have the same results."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import PROJECT, SAMPLES, corpus_files

import plantigrade

RECORDED = corpus_files()


def documents(program: str, command: list[str], files: list[Path], out: Path) -> dict[Path, Any]:
    """Return the documents of the command line for each file that it can process."""
    results = {}
    # Files of equal names in different folders have different output folders.
    by_folder: dict[Path, list[Path]] = {}
    for file in files:
        by_folder.setdefault(file.parent, []).append(file)
    for number, members in enumerate(by_folder.values()):
        folder = out / str(number)
        arguments = [program, *command, *map(str, members), "--out", str(folder)]
        subprocess.run(arguments, capture_output=True, check=False)
        for file in members:
            for result in folder.glob(f"{glob_name(file)}.*.json"):
                results[file] = json.loads(result.read_text())
    return results


def glob_name(path: Path) -> str:
    return path.stem.replace("[", "[[]")


def of_root(document: Any, root: str | None) -> Any:
    """Return the document of a root joint, if the clip has several skeletons."""
    if isinstance(document, dict):
        return document
    return next(entry for entry in document if entry["root"] == root)


def compare(files: list[Path], program: str, out: Path) -> int:
    expected = documents(program, ["detect"], files, out)
    for path in files:
        clip = plantigrade.Clip.read(path)
        try:
            detection = plantigrade.detect(clip)
        except plantigrade.PlantigradeError:
            assert path not in expected, path
            continue
        own = detection.to_dict()
        document = of_root(expected[path], own.get("root"))
        several = [*clip.parents].count(-1) > 1
        if several:
            # The command line measures every skeleton, the package the first one with feet.
            own["notices"] = document["notices"]
        assert own == document, path
        skeleton = clip.skeleton
        points = plantigrade.detect(
            clip.positions, fps=clip.fps, roles=skeleton.roles, up=clip.up, unit=clip.unit
        )
        for part in detection.parts:
            assert np.array_equal(points.planted(part), detection.planted(part)), (path, part)
            assert np.array_equal(points.confidence_of(part), detection.confidence_of(part)), path
    return len(expected)


def test_samples_have_the_labels_of_the_command_line(program: str, tmp_path: Path) -> None:
    files = [*SAMPLES.glob("*.bvh"), *(PROJECT / "tests/files/good").glob("*.bvh")]
    assert compare(files, program, tmp_path) > 13


@pytest.mark.skipif(not RECORDED, reason="there is no recorded motion; see PLANTIGRADE_CORPUS")
def test_recorded_clips_have_the_labels_of_the_command_line(program: str, tmp_path: Path) -> None:
    assert compare(RECORDED, program, tmp_path) > len(RECORDED) / 2


def test_samples_have_the_segments_of_the_command_line(program: str, tmp_path: Path) -> None:
    for path in sorted(SAMPLES.glob("*.bvh")):
        # Names of actions are common to all clips of a call.
        expected = documents(program, ["segment"], [path], tmp_path / path.stem)[path]
        assert plantigrade.segment(path).to_dict() == expected


def test_cleaned_clips_are_those_of_the_command_line(program: str, tmp_path: Path) -> None:
    for name in ("curved-walk", "limp-to-run"):
        path, out = SAMPLES / f"{name}.bvh", tmp_path / f"{name}.bvh"
        subprocess.run([program, "clean", str(path), "-o", str(out)], check=True, capture_output=True)
        assert plantigrade.clean(path).to_bytes() == out.read_bytes()


def test_gait_is_that_of_the_command_line(program: str, walk_path: Path) -> None:
    command = [program, "gait", str(walk_path), "--format", "csv"]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    header, row = (line.split(",") for line in output.splitlines())
    expected = dict(zip(header, row, strict=True))
    measures = plantigrade.gait(walk_path)
    assert len(measures) > 40
    for name, value in measures.items():
        assert expected[name] == "" if value is None else float(expected[name]) == round(value, 6)


@pytest.mark.parametrize("format", ["csv", "intervals", "events", "part-events", "npz", "blender"])
def test_files_are_those_of_the_command_line(program: str, walk_path: Path, format: str) -> None:
    command = [program, "detect", str(walk_path), "--format", format]
    expected = subprocess.run(command, check=True, capture_output=True).stdout
    assert plantigrade.detect(walk_path).to_bytes(format) == expected
