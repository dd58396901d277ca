"""Runs the gait event detectors of gaitkit on tracks of the legs.

Usage: gaitkit_events.py TRACKS.json EVENTS.json

TRACKS.json: a list of trials, each with `rate` in Hz and `joints`: positions in metres by joint
name (left_hip, left_knee, left_ankle, left_toe and the right ones), third axis up.
EVENTS.json: `version` of gaitkit and `detectors`, each with its `title` and the `events` of every
trial as [side, "strike" | "off", seconds since the first frame].
"""

import importlib.metadata
import json
import os
import sys

import numpy as np

# Detectors whose models are not part of the package must not be installed.
os.environ["GAITKIT_AUTO_INSTALL_DEPS"] = "0"
import gaitkit  # noqa: E402

DETECTORS = {
    "zeni": "Zeni 2008",
    "oconnor": "O'Connor 2007",
    "hreljac": "Hreljac 2000",
    "mickelborough": "Mickelborough 2000",
    "ghoussayni": "Ghoussayni 2004",
    "vancanneyt": "Vancanneyt 2025",
    "dgei": "DGEI 2024",
    "bike": "BIKE",
    "intellevent": "IntellEvent 2023 (LSTM)",
}


def aligned(joints):
    """Returns the tracks in millimetres, centred on the path, with the path along the first axis."""
    hips = (joints["left_hip"] + joints["right_hip"]) / 2
    ahead = hips[-1, :2] - hips[0, :2]
    cosine, sine = ahead / max(np.linalg.norm(ahead), 1e-9)
    turn = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
    centre = np.append((hips[:, :2].max(axis=0) + hips[:, :2].min(axis=0)) / 2, 0)
    return {name: 1000 * (track - centre) @ turn for name, track in joints.items()}


def knee_flexion(joints, side):
    """Returns the flexion of a knee, in degrees."""
    thigh = joints[f"{side}_knee"] - joints[f"{side}_hip"]
    shank = joints[f"{side}_ankle"] - joints[f"{side}_knee"]
    cosine = (thigh * shank).sum(axis=1)
    cosine /= np.linalg.norm(thigh, axis=1) * np.linalg.norm(shank, axis=1)
    return np.degrees(np.arccos(np.clip(cosine, -1, 1)))


def frames(trial):
    """Returns the frames of a trial as gaitkit reads them. The ankle stands for the heel."""
    joints = aligned({name: np.array(track) for name, track in trial["joints"].items()})
    for side in ("left", "right"):
        joints[f"{side}_heel"] = joints[f"{side}_ankle"]
        joints[f"{side}_foot_index"] = joints[f"{side}_toe"]
    knees = {side: knee_flexion(joints, side) for side in ("left", "right")}
    return [
        {
            "frame_index": index,
            "left_knee_angle": knees["left"][index],
            "right_knee_angle": knees["right"][index],
            "landmark_positions": {name: track[index] for name, track in joints.items()},
        }
        for index in range(len(knees["left"]))
    ]


def events(method, trial):
    """Returns the events of one trial; none if the detector cannot process it."""
    try:
        result = gaitkit.detect(
            frames(trial), method=method, fps=trial["rate"], auto_install_deps=False
        )
    except Exception as error:  # Detectors fail in many ways on motion that is not a walk.
        print(f"{method}: {error}", file=sys.stderr)
        return []
    kinds = [
        ("left", "strike", result.left_hs),
        ("right", "strike", result.right_hs),
        ("left", "off", result.left_to),
        ("right", "off", result.right_to),
    ]
    return [[side, kind, event["time"]] for side, kind, found in kinds for event in found]


def main():
    """Reads the tracks and writes the events."""
    source, target = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        trials = json.load(file)
    detectors = [
        {"title": title, "events": [events(method, trial) for trial in trials]}
        for method, title in DETECTORS.items()
    ]
    output = {"version": importlib.metadata.version("gaitkit"), "detectors": detectors}
    with open(target, "w", encoding="utf-8") as file:
        json.dump(output, file)


main()
