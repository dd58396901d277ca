"""Compares the speed of the Python package with other software: labels with the command line, with thresholds in
NumPy and with the detectors of gaitkit; reading BVH with other packages.

Usage: python scripts/bench/python.py PROGRAM CLIPS_FOLDER [OUT]

PROGRAM is the command line, CLIPS_FOLDER has BVH files. Prints rows as JSON, or writes them to OUT:

- ``name``: what is compared, and with what.
- ``ours``, ``reference``: median of the package and of the other software, in ``unit``.
- ``ratio``: how many times as fast the package is: ``median``, and its 95 % confidence interval, ``low`` and
  ``high``. Each run of the package is compared with the run of the other software next to it, so that the load of
  the machine affects both.
- ``note``: why there is no reference, or what differs.

The other packages are those that are installed::

    pip install numpy gaitkit pybvh bvh bvhio
    pip install --no-deps fairmotion

fairmotion requires a version of torch that can no longer be installed, but its reader works without it.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

# Detectors of gaitkit whose models are not part of the package must not be installed.
os.environ["GAITKIT_AUTO_INSTALL_DEPS"] = "0"

import numpy as np

import plantigrade

#: Least number of pairs of runs. Slow pairs have fewer, but at least three.
RUNS = 9
#: Half the width of the confidence interval of a ratio, relative to it, at which a measurement ends.
PRECISION = 0.03
#: Time after which no further pair is measured, in seconds.
LIMIT = 20
#: Number of files and least number of frames of a clip that is labelled as arrays.
FILES = 70

Row = dict[str, Any]
Task = Callable[[], object]


def seconds(task: Task) -> float:
    """Return the time of a call."""
    start = time.perf_counter()
    task()
    return time.perf_counter() - start


def median_interval(values: list[float]) -> tuple[float, float]:
    """Return the 95 % confidence interval of the median by order statistics; the range of few values."""
    count = len(values)
    rank, probability = 0, 0.5**count
    below = probability
    while below <= 0.025:
        rank += 1
        probability *= (count - rank + 1) / rank
        below += probability
    ordered = sorted(values)
    return ordered[max(rank, 1) - 1], ordered[count - max(rank, 1)]


def is_precise(pairs: list[tuple[float, float]]) -> bool:
    """Return whether the confidence interval of the ratio of pairs is narrow."""
    ratios = [reference / ours for ours, reference in pairs]
    low, high = median_interval(ratios)
    return high - low <= 2 * PRECISION * statistics.median(ratios)


def compare(name: str, unit: str, amount: float, ours: Task, reference: Task, note: str = "") -> Row:
    """Return a row. `amount` is the number of frames of a rate; 0 if the unit is ms."""
    try:
        reference()
    except Exception as error:
        return {**missing(name, unit, amount, ours), "note": f"fails: {type(error).__name__}: {error}"[:200]}
    ours()
    pairs: list[tuple[float, float]] = []
    end = time.perf_counter() + LIMIT
    while len(pairs) < 3 or (time.perf_counter() < end and not (len(pairs) >= RUNS and is_precise(pairs))):
        # The order alternates, too.
        if len(pairs) % 2:
            other = seconds(reference)
            pairs.append((seconds(ours), other))
        else:
            own = seconds(ours)
            pairs.append((own, seconds(reference)))
    ratios = [other / own for own, other in pairs]
    low, high = median_interval(ratios)
    ratio = {"median": statistics.median(ratios), "low": low, "high": high}
    return {
        "name": name,
        "unit": unit,
        "ours": value(statistics.median(own for own, _ in pairs), amount),
        "reference": value(statistics.median(other for _, other in pairs), amount),
        "ratio": {key: round(number, 4) for key, number in ratio.items()},
        "runs": len(pairs),
        "note": note,
    }


def value(time: float, amount: float) -> float:
    """Return a time as a rate, or in milliseconds."""
    return round(amount / time) if amount else round(1000 * time, 2)


def missing(name: str, unit: str, amount: float, ours: Task) -> Row:
    """Return a row without reference."""
    ours()
    own = statistics.median(seconds(ours) for _ in range(3))
    return {"name": name, "unit": unit, "ours": value(own, amount), "reference": None, "ratio": None}


def module(name: str) -> tuple[Any, str]:
    """Return a module, or None, and its title with its version."""
    try:
        found = importlib.import_module(name)
    except ImportError:
        return None, name.partition(".")[0]
    package = name.partition(".")[0]
    return found, f"{package} {importlib.metadata.version(package)}"


def not_installed(package: str) -> dict[str, str]:
    """Return a note."""
    return {"note": f"{package} is not installed, or cannot be installed with this version of Python"}


def thresholds(positions: np.ndarray, fps: float, feet: list[int], up: int, unit: float) -> np.ndarray:
    """Return labels by height below 5 cm and speed below 0.5 m/s, the usual rule."""
    feet_positions = positions[:, feet] * unit
    heights = feet_positions[..., up] - feet_positions[..., up].min()
    speeds = np.linalg.norm(np.gradient(feet_positions, axis=0), axis=-1) * fps
    return (heights < 0.05) & (speeds < 0.5)


def labels(program: str, files: list[Path]) -> list[Row]:
    """Return rows of labelling files with one processor, and of labelling arrays."""
    clips = [plantigrade.Clip.read(path) for path in files]
    frames = sum(len(clip) for clip in clips)
    arrays = [(clip.positions, clip.fps, clip.skeleton.roles, clip.up, clip.unit) for clip in clips]
    unit = "frames per second"

    def detect_arrays() -> None:
        for positions, fps, roles, up, unit in arrays:
            plantigrade.detect(positions, fps=fps, roles=roles, up=up, unit=unit)

    def threshold_arrays() -> None:
        for positions, fps, roles, up, unit in arrays:
            feet = [roles.get("left_toe", roles["left_ankle"]), roles.get("right_toe", roles["right_ankle"])]
            thresholds(positions, fps, feet, "xyz".index(up[-1]), unit)

    with tempfile.TemporaryDirectory() as folder:

        def command_line() -> None:
            command = [program, "detect", *map(str, files), "--jobs", "1", "--force", "--out", folder]
            subprocess.run(command, check=True, capture_output=True)

        def package() -> None:
            plantigrade.batch(files, out=folder, workers=1, force=True, progress=False)

        return [
            compare("labels of files: plantigrade detect", unit, frames, package, command_line),
            compare(
                "labels of arrays: thresholds of height and speed in NumPy",
                unit,
                frames,
                detect_arrays,
                threshold_arrays,
                "two fixed thresholds, without heel, toe, confidence and events",
            ),
        ]


def gaitkit_rows(path: Path) -> list[Row]:
    """Return a row for each detector of gaitkit, on a clip of walking."""
    clip = plantigrade.Clip.read(path)
    positions, roles = clip.positions, clip.skeleton.roles
    unit, frames = "frames per second", len(clip)

    def ours() -> None:
        plantigrade.detect(positions, fps=clip.fps, roles=roles, up=clip.up, unit=clip.unit)

    gaitkit, title = module("gaitkit")
    if gaitkit is None:
        return [{**missing("labels of arrays: gaitkit", unit, frames, ours), **not_installed("gaitkit")}]
    records = gaitkit_frames(clip)

    def detector(method: str) -> Task:
        return lambda: gaitkit.detect(records, method=method, fps=clip.fps, auto_install_deps=False)

    methods = ["zeni", "oconnor", "hreljac", "mickelborough", "ghoussayni", "vancanneyt", "dgei", "bike"]
    note = "foot strikes and foot offs of walking; records of landmarks are made before"
    return [
        compare(f"labels of arrays: {title}, {method}", unit, frames, ours, detector(method), note)
        for method in methods
    ]


def gaitkit_frames(clip: plantigrade.Clip) -> list[dict[str, Any]]:
    """Return the records of a clip that gaitkit reads: millimetres, the path along the first axis."""
    order = {"x": [1, 2, 0], "y": [2, 0, 1], "z": [0, 1, 2]}[clip.up[-1]]
    points = 1000 * clip.unit * clip.positions[..., order]
    roles = clip.skeleton.roles
    joints = {}
    for side in ("left", "right"):
        for name, role in (("hip", "thigh"), ("knee", "shank"), ("ankle", "ankle"), ("foot_index", "toe")):
            joints[f"{side}_{name}"] = points[:, roles[f"{side}_{role}"]]
        joints[f"{side}_heel"] = joints[f"{side}_ankle"]
    hips = (joints["left_hip"] + joints["right_hip"]) / 2
    ahead = hips[-1, :2] - hips[0, :2]
    cosine, sine = ahead / max(float(np.linalg.norm(ahead)), 1e-9)
    turn = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
    centre = np.append((hips[:, :2].max(axis=0) + hips[:, :2].min(axis=0)) / 2, 0)
    joints = {name: (track - centre) @ turn for name, track in joints.items()}

    def flexion(side: str) -> np.ndarray:
        thigh = joints[f"{side}_knee"] - joints[f"{side}_hip"]
        shank = joints[f"{side}_ankle"] - joints[f"{side}_knee"]
        lengths = np.linalg.norm(thigh, axis=1) * np.linalg.norm(shank, axis=1)
        return np.degrees(np.arccos(np.clip((thigh * shank).sum(axis=1) / lengths, -1, 1)))

    left, right = flexion("left"), flexion("right")
    return [
        {
            "frame_index": index,
            "left_knee_angle": left[index],
            "right_knee_angle": right[index],
            "landmark_positions": {name: track[index] for name, track in joints.items()},
        }
        for index in range(len(clip))
    ]


def readers(path: Path) -> list[Row]:
    """Return rows of reading a file."""
    size = f"{path.stat().st_size / 1e6:.1f} MB"

    def read() -> object:
        return plantigrade.Clip.read(path)

    def read_positions() -> object:
        return plantigrade.Clip.read(path).positions

    def bvh(module: Any) -> Task:
        return lambda: np.array(module.Bvh(path.read_text()).frames, dtype=float)

    def fairmotion_positions(module: Any) -> Task:
        return lambda: module.load(str(path)).positions(local=False)

    candidates: list[tuple[str, str, Task, Callable[[Any], Task], str]] = [
        ("reading", "pybvh", read, lambda module: lambda: module.read_bvh_file(str(path)), ""),
        ("reading", "bvh", read, bvh, "with the numbers as an array"),
        ("reading", "bvhio", read, lambda module: lambda: module.readAsBvh(str(path)), ""),
        ("reading", "fairmotion.data.bvh", read, lambda module: lambda: module.load(str(path)), ""),
        (
            "reading, and positions of all joints",
            "fairmotion.data.bvh",
            read_positions,
            fairmotion_positions,
            "",
        ),
    ]
    rows = []
    for what, name, ours, reference, note in candidates:
        found, title = module(name)
        label = f"{what}, {size}: {title}"
        if found is None:
            rows.append({**missing(label, "ms", 0, ours), **not_installed(name.partition(".")[0])})
        else:
            rows.append(compare(label, "ms", 0, ours, reference(found), note))
    return rows


def main() -> None:
    """Run the measurements."""
    program, folder = sys.argv[1], Path(sys.argv[2])
    if hasattr(os, "sched_setaffinity"):
        # One processor, also for the command line.
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    files = sorted(folder.glob("*.bvh"))[:FILES]
    if not files:
        sys.exit(f"{folder} has no BVH files.")
    largest = max(files, key=lambda path: path.stat().st_size)
    walks = [path for path in files if "walk" in path.name] or files
    walk = max(walks, key=lambda path: path.stat().st_size)
    rows = [*labels(program, files), *gaitkit_rows(walk), *readers(largest)]
    document = {
        "python": sys.version.split()[0],
        "numpy": np.__version__,
        "files": len(files),
        "load": round(os.getloadavg()[0], 1),
        "rows": rows,
    }
    text = json.dumps(document, indent=2)
    if len(sys.argv) > 3:
        Path(sys.argv[3]).write_text(text + "\n", encoding="utf-8")
    else:
        print(text)


if __name__ == "__main__":
    main()
