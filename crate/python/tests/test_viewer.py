"""The viewer in notebooks: its state, its fallbacks, and the page."""

from __future__ import annotations

import copy
import gzip
import html
import json
import pickle
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import plantigrade
from plantigrade import PlantigradeError, _page

EDIT = {"side": "left", "part": "contact", "start": 0, "end": 62, "planted": False}


def block(page: str, id: str) -> str:
    match = re.search(rf' id="{id}">(.*?)</', page, re.DOTALL)
    assert match
    return match[1]


def test_a_page_has_the_clip_with_its_edits(folder: Path) -> None:
    detection = plantigrade.detect("walk.bvh", method="height-speed", height=0.08)
    detection.edit([("left", "contact", 0, 5, True)]).save_html("walk.html")
    page = Path("walk.html").read_text(encoding="utf-8")
    enclosed = json.loads(block(page, "enclosed"))
    assert enclosed["name"] == "walk.bvh"
    assert enclosed["showing"] == "method=height-speed&height=0.08&lenient=yes"
    assert enclosed["edits"] == [{**EDIT, "end": 5, "planted": True}]
    assert block(page, "clip") and block(page, "core")
    assert "<title>walk.bvh – Plantigrade</title>" in page
    # The page loads nothing from elsewhere.
    assert not re.search(r"(src|href)=.https?:", page)


def test_a_static_viewer_is_a_frame_with_the_page(walk: plantigrade.Clip) -> None:
    detection = plantigrade.detect(walk)
    viewer = detection.show(static=True, height=400)
    assert viewer.widget is None and viewer.detection is detection
    frame = viewer._repr_mimebundle_()["text/html"]
    match = re.fullmatch(r'<iframe title="(.*?)" .*height: 400px.* srcdoc="(.*)"></iframe>', frame, re.DOTALL)
    assert match
    assert html.unescape(match[2]) == _page.page(detection)
    with pytest.raises(PlantigradeError, match=r"static viewer.*detection\.show"):
        viewer.detection = detection


def test_without_anywidget_the_viewer_is_static(walk_path: Path) -> None:
    code = (
        "import sys; sys.modules['anywidget'] = None; import plantigrade; "
        f"viewer = plantigrade.detect({str(walk_path)!r}).show(); print(viewer.widget, viewer); "
        "print(viewer._repr_mimebundle_()['text/html'].rpartition('</iframe>')[2])"
    )
    command = [sys.executable, "-I", "-c", code]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    first, hint = output.splitlines()
    assert first == "None Viewer(Detection(245 frames, 5 plants, method 'robust'))"
    assert "pip install plantigrade[notebook]" in hint


def test_state_has_what_differs_from_the_defaults(walk: plantigrade.Clip) -> None:
    state = _page.state_of(plantigrade.detect(walk))
    assert state == {"settings": {}, "edits": [], "names": []}
    clip = walk.override(fps=60, up="-z", unit=0.01, roles={"left_toe": None})
    settings = _page.state_of(plantigrade.detect(clip, r=0.01, w=2))["settings"]
    # The frame rate is that of the file.
    assert round(plantigrade.Clip.read(clip.to_bytes()).fps, 3) == 60
    assert settings == {"r": 0.01, "w": 2, "up": "-z", "unit": 0.01, "joints": {"left_toe": -1}}


def test_the_page_shows_labels_of_positions(walk: plantigrade.Clip) -> None:
    points = plantigrade.detect(walk.positions, fps=walk.fps, roles=walk.skeleton.roles)
    state = _page.state_of(points)
    # The page labels the positions of the file, with the same joints.
    assert state["edits"] == []
    shown = plantigrade.detect(
        _page.file_clip(plantigrade.Clip.read(points.clip.to_bytes()), state["settings"])
    )
    assert np.array_equal(shown.contact, points.contact)


def test_labels_that_the_page_cannot_compute_are_edits(walk: plantigrade.Clip) -> None:
    detection = plantigrade.detect(walk, method="sigma", sigma=3.0)
    state = _page.state_of(detection)
    plain = plantigrade.detect(walk, method="sigma").edit(_page.tuple_of(edit) for edit in state["edits"])
    assert state["edits"]
    assert np.array_equal(plain.toe, detection.toe)


def test_edits_and_settings_of_the_page_are_those_of_the_detection(walk: plantigrade.Clip) -> None:
    detection = plantigrade.detect(walk)
    before = _page.state_of(detection)
    after = {**copy.deepcopy(before), "edits": [EDIT, {"cut": 100, "present": True}]}
    edited = _page.detection_of(detection, before, after)
    assert not edited.contact[:62, 0].any() and detection.contact[:62, 0].all()
    assert edited.edits == (plantigrade.Edit("left", "contact", 0, 62, False),)
    assert edited.clip is walk

    settings = {"method": "height", "height": 0.1, "rate": 60, "joints": {"left_toe": -1}}
    changed = _page.detection_of(detection, before, {**after, "settings": settings})
    assert changed.method == "height"
    assert round(changed.fps) == 60 and "left_toe" not in changed.clip.skeleton.roles
    expected = plantigrade.detect(walk, method="height", height=0.1, fps=60, roles={"left_toe": None}).edit(
        changed.edits
    )
    assert np.array_equal(changed.toe, expected.toe)
    assert np.array_equal(pickle.loads(pickle.dumps(changed)).toe, changed.toe)

    assert _page.detection_of(detection, before, before) is detection


def test_corrections_are_shown_as_edits(folder: Path) -> None:
    detection = plantigrade.detect("walk.bvh")
    edits = [("left", "contact", 112, 185, True), ("left", "contact", 185, 191, False)]
    corrected = plantigrade.detect("walk.bvh", constraints=detection.edit(edits))
    state = _page.state_of(corrected)
    shown = detection.edit(_page.tuple_of(edit) for edit in state["edits"])
    assert np.array_equal(shown.contact, corrected.contact)


@pytest.fixture
def widget_class() -> Any:
    pytest.importorskip("anywidget", reason="anywidget is not installed")
    from plantigrade._widget import Widget

    return Widget


def test_import_and_detection_load_no_widgets(widget_class: Any, walk_path: Path) -> None:
    code = f"import sys, plantigrade; plantigrade.detect({str(walk_path)!r}).contact; print(*sys.modules)"
    command = [sys.executable, "-I", "-c", code]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    loaded = {name.split(".")[0] for name in output.split()}
    assert not loaded & {"anywidget", "ipywidgets", "traitlets", "IPython", "gzip"}


def test_the_widget_has_page_and_clip(widget_class: Any, walk: plantigrade.Clip) -> None:
    viewer = plantigrade.detect(walk).show()
    widget = viewer.widget
    assert isinstance(widget, widget_class)
    assert gzip.decompress(widget.clip) == walk.to_bytes()
    assert block(gzip.decompress(widget.page).decode(), "enclosed") == '{"version":1,"host":true}'
    bundle = viewer._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in bundle
    assert bundle["text/html"].startswith("<svg")


def test_the_widget_changes_the_detection_and_the_reverse(widget_class: Any, walk: plantigrade.Clip) -> None:
    detection = plantigrade.detect(walk)
    viewer = detection.show()
    assert viewer.detection is detection
    viewer.widget.state = {**viewer.widget.state, "edits": [EDIT]}
    assert not viewer.detection.contact[:62, 0].any()
    assert viewer.detection is viewer.detection
    viewer.detection = detection.edit([("right", "contact", 0, 10, True)])
    assert [edit["side"] for edit in viewer.widget.state["edits"]] == ["right"]
    assert viewer.detection.contact[:10, 1].all()
    with pytest.raises(PlantigradeError, match="another clip"):
        viewer.detection = plantigrade.detect(walk.positions, fps=30, roles=walk.skeleton.roles)
