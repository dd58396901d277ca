"""The page of the viewer: its state, and files and frames that contain it."""

from __future__ import annotations

import base64
import functools
import gzip
import hashlib
import html
import json
import os
from typing import TYPE_CHECKING, Any

from . import _plantigrade
from ._clip import Clip, file_clip
from ._errors import PlantigradeError

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ._detect import Detection, EditTuple, Params

    State = dict[str, Any]

#: What the frame of a viewer may do: it has an origin of its own, so that it cannot read the notebook.
SANDBOX = "allow-scripts allow-downloads allow-popups"
#: Settings of the page by parameter of a detection, with their default value.
DEFAULTS = {"method": "robust", "r": 0.001, "w": 1, "height": 0.05, "speed": 0.5}


def name_of(clip: Clip) -> str:
    """Return the name of a clip for display."""
    return clip.name or "clip.bvh"


def state_of(detection: Detection) -> State:
    """Return edits and settings with which the page shows the labels of a detection."""
    clip, params = detection.clip, detection._params
    method, r, w, sigma, height, speed, exact = params
    values = {"method": method, "r": r, "w": w, "height": height, "speed": speed}
    settings: dict[str, Any] = {key: value for key, value in values.items() if value != DEFAULTS[key]}
    roles, up, unit = clip._raw.overrides()
    if up is not None:
        settings["up"] = up
    if unit is not None:
        settings["unit"] = unit
    if roles:
        settings["joints"] = {role: -1 if joint is None else joint for role, joint in roles}
    _, changes, own = detection._corrected or (None, [], [])
    edits = [*own, *changes, *detection._edits]
    if detection._still is not None or sigma is not None or exact or not clip._raw.has_rotations():
        # The page has no such options, and reads positions from a file.
        file = Clip.read(clip.to_bytes(), lenient=True)
        plain = file_clip(file, settings)._raw.detect((method, r, w, None, height, speed, False), None)
        edits = [*differences(plain, detection._detected), *edits]
    return {"settings": settings, "edits": [dict_of(edit) for edit in edits], "names": []}


def detection_of(detection: Detection, before: State, after: State) -> Detection:
    """Return the detection with the edits and settings of a page that has shown another one before."""
    if after == before:
        return detection
    clip, params, still = detection.clip, detection._params, detection._still
    settings = after["settings"]
    if settings != before["settings"]:
        keys = ("rate", "up", "unit", "joints")
        if any(settings.get(key) != before["settings"].get(key) for key in keys):
            clip = file_clip(clip, settings)
        values = {**DEFAULTS, **{key: settings[key] for key in DEFAULTS if key in settings}}
        params, still = params_of(values), None
    # Edits of cuts have no side.
    edits = tuple(tuple_of(edit) for edit in after["edits"] if "side" in edit)
    is_same = clip is detection.clip and params == detection._params and still is detection._still
    if is_same and detection._constraints is None:
        return type(detection)(clip, params, still, edits, earlier=detection)
    return type(detection)(clip, params, still, edits)


def params_of(values: Mapping[str, Any]) -> Params:
    """Return the parameters of a detection with the settings of the page."""
    return (
        str(values["method"]),
        float(values["r"]),
        int(values["w"]),
        None,
        float(values["height"]),
        float(values["speed"]),
        False,
    )


def differences(before: _plantigrade.RawDetection, after: _plantigrade.RawDetection) -> list[EditTuple]:
    """Return edits by which the labels of one detection become those of another."""
    import numpy as np

    edits: list[EditTuple] = []
    for part in after.parts():
        old, new = before.planted(part), after.planted(part)
        for planted in (False, True):
            for foot, side in enumerate(("left", "right")):
                changed = (old != new) & (new == planted)
                steps = np.diff(changed[:, foot].astype(np.int8), prepend=0, append=0)
                starts, ends = np.flatnonzero(steps == 1), np.flatnonzero(steps == -1)
                for start, end in zip(starts.tolist(), ends.tolist(), strict=True):
                    edits.append((side, part, start, end, planted))
    return edits


def dict_of(edit: EditTuple) -> dict[str, Any]:
    """Return an edit as the page has it."""
    side, part, start, end, planted = edit
    return {"side": side, "part": part, "start": start, "end": end, "planted": planted}


def tuple_of(edit: Mapping[str, Any]) -> EditTuple:
    """Return an edit of the page."""
    return (edit["side"], edit["part"], int(edit["start"]), int(edit["end"]), bool(edit["planted"]))


@functools.lru_cache(maxsize=1)
def compressed_page() -> bytes:
    """Return the page of the viewer, which gets its clip from a host, compressed with gzip."""
    path = os.path.join(os.path.dirname(__file__), "_page.html.gz")
    try:
        with open(path, "rb") as file:
            return file.read()
    except FileNotFoundError:
        raise PlantigradeError(
            "this installation has no viewer", hint="Install a wheel that was built with npm run wheel"
        ) from None


def compressed_clip(clip: Clip) -> bytes:
    """Return a clip as a BVH file, compressed with gzip."""
    return gzip.compress(clip.to_bytes(), mtime=0)


def page(detection: Detection) -> str:
    """Return a page that contains the clip and its labels, and needs no network."""
    state = state_of(detection)
    data, name = detection.clip.to_bytes(), name_of(detection.clip)
    identity = hashlib.sha256(data + json.dumps(state, sort_keys=True).encode()).hexdigest()[:16]
    enclosed = {
        "version": 1,
        "id": identity,
        "name": name,
        "showing": link_text({**state["settings"], "lenient": "yes"}),
        "edits": state["edits"],
        "names": state["names"],
    }
    text = gzip.decompress(compressed_page()).decode()
    text = fill(text, "<title>", html.escape(f"{name} – Plantigrade", quote=False))
    text = fill(text, ' id="enclosed">', json.dumps(enclosed).replace("<", "\\u003c"))
    return fill(text, ' id="clip">', base64.b64encode(compressed_clip(detection.clip)).decode())


def fill(text: str, opening: str, content: str) -> str:
    """Return a page with another content of an element, up to its end tag."""
    head, _, rest = text.partition(opening)
    return head + opening + content + rest[rest.index("</") :]


def link_text(settings: Mapping[str, Any]) -> str:
    """Return settings as in a link of the app: ``method=paper&r=0.002``."""
    from urllib.parse import quote

    def value(item: Any) -> str:  # noqa: ANN401
        if isinstance(item, dict):
            item = ",".join(f"{key}:{joint}" for key, joint in item.items())
        return quote(str(item), safe=",:")

    return "&".join(f"{key}={value(item)}" for key, item in settings.items())


def frame(detection: Detection, height: int) -> str:
    """Return a frame with the page, for notebooks without widgets."""
    source = page(detection).replace("&", "&amp;").replace('"', "&quot;")
    title = html.escape(f"Viewer of {name_of(detection.clip)}")
    style = (
        f"display: block; box-sizing: border-box; width: 100%; height: {int(height)}px; "
        "border: 1px solid #8884; border-radius: 6px"
    )
    return f'<iframe title="{title}" style="{style}" sandbox="{SANDBOX}" srcdoc="{source}"></iframe>'


def picture(detection: Detection) -> str:
    """Return a drawing of the plants over time."""
    frames = max(1, len(detection.clip))
    colours = {"left": "#0b6fc2", "right": "#b35300"}
    bars = [
        f'<rect x="{interval.start / frames:.4%}" width="{(interval.end - interval.start) / frames:.4%}" '
        f'y="{20 if interval.side == "left" else 48}" height="20" rx="2" fill="{colours[interval.side]}"/>'
        for interval in detection.intervals
        if interval.part == detection.parts[0]
    ]
    name = html.escape(f"{name_of(detection.clip)}, {len(bars)} plants: left foot above, right foot below.")
    return (
        f'<svg width="100%" height="76" role="img" aria-label="{name}" font-family="sans-serif" '
        f'font-size="12"><text y="12" fill="currentColor">{name} Run the cell to see the motion.</text>'
        f"{''.join(bars)}</svg>"
    )
