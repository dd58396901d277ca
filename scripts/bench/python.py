"""Measures the Python package: labels against the command line and against thresholds in NumPy, and reading BVH
against other packages.

Usage: python scripts/bench/python.py PROGRAM CLIPS_FOLDER

Runs of the candidates alternate, so that the load of the machine affects all of them. Prints medians as JSON.
Packages that are not installed are left out.
"""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

import plantigrade

RUNS = 7


def alternate(candidates: dict[str, Callable[[], object]]) -> dict[str, float]:
    """Return the median time of each candidate, in seconds."""
    times: dict[str, list[float]] = {name: [] for name in candidates}
    for _ in range(RUNS):
        for name, candidate in candidates.items():
            start = time.perf_counter()
            candidate()
            times[name].append(time.perf_counter() - start)
    return {name: statistics.median(values) for name, values in times.items()}


def thresholds(positions: np.ndarray, fps: float, feet: list[int], up: int, unit: float) -> np.ndarray:
    """Return labels by height below 5 cm and speed below 0.5 m/s, the usual rule."""
    feet_positions = positions[:, feet] * unit
    heights = feet_positions[..., up] - feet_positions[..., up].min()
    speeds = np.linalg.norm(np.gradient(feet_positions, axis=0), axis=-1) * fps
    return (heights < 0.05) & (speeds < 0.5)


def labels(program: str, files: list[Path]) -> dict[str, float]:
    """Return frames per second of labelling files with one processor, and of labelling arrays."""
    clips = [plantigrade.Clip.read(path) for path in files]
    frames = sum(len(clip) for clip in clips)
    arrays = [
        (clip.positions, clip.fps, clip.skeleton.roles, clip.up, clip.unit) for clip in clips
    ]
    with tempfile.TemporaryDirectory() as folder:

        def command_line() -> None:
            command = [program, "detect", *map(str, files), "--jobs", "1", "--force", "--out", folder]
            subprocess.run(command, check=True, capture_output=True)

        def package() -> None:
            plantigrade.batch(files, out=folder, workers=1, force=True, progress=False)

        def detect_arrays() -> None:
            for positions, fps, roles, up, unit in arrays:
                plantigrade.detect(positions, fps=fps, roles=roles, up=up, unit=unit)

        def threshold_arrays() -> None:
            for positions, fps, roles, up, unit in arrays:
                feet = [roles["left_toe"], roles["right_toe"]]
                thresholds(positions, fps, feet, "xyz".index(up[-1]), unit)

        times = alternate(
            {
                "command line, files": command_line,
                "package, files": package,
                "package, arrays": detect_arrays,
                "thresholds in NumPy, arrays": threshold_arrays,
            }
        )
    return {name: round(frames / seconds) for name, seconds in times.items()}


def readers(path: Path) -> dict[str, float]:
    """Return the time of reading a file by package, in milliseconds."""
    candidates: dict[str, Callable[[], object]] = {
        "plantigrade.Clip.read": lambda: plantigrade.Clip.read(path),
        "plantigrade.Clip.read and positions": lambda: plantigrade.Clip.read(path).positions,
    }
    try:
        import bvh

        def read_bvh() -> object:
            motion = bvh.Bvh(path.read_text())
            return np.array(motion.frames, dtype=float)

        candidates["bvh"] = read_bvh
    except ImportError:
        pass
    try:
        import pybvh

        candidates["pybvh"] = lambda: pybvh.read_bvh_file(str(path))
    except ImportError:
        pass
    try:
        import bvhio

        candidates["bvhio"] = lambda: bvhio.readAsBvh(str(path))
    except ImportError:
        pass
    return {name: round(1000 * seconds, 2) for name, seconds in alternate(candidates).items()}


def main() -> None:
    """Run the measurements."""
    program, folder = sys.argv[1], Path(sys.argv[2])
    files = sorted(folder.glob("*.bvh"))[:70]
    largest = max(files, key=lambda path: path.stat().st_size)
    results = {
        "frames per second": labels(program, files),
        f"reading {largest.stat().st_size / 1e6:.1f} MB, ms": readers(largest),
        "load average": round(os.getloadavg()[0], 1),
    }
    print(json.dumps(results, indent=2))


if __name__ == "__main__":
    main()
