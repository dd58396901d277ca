"""Clips and detections: properties, files, edits."""

from __future__ import annotations

import io
import json
import pickle
import threading
from pathlib import Path

import numpy as np
import pytest

import plantigrade
from plantigrade import Clip, Edit, _plantigrade


def test_clips_are_read_from_paths_bytes_and_files(walk_path: Path, walk: Clip) -> None:
    data = walk_path.read_bytes()
    sources = [walk_path, str(walk_path), data, bytearray(data), memoryview(data), io.BytesIO(data)]
    for source in sources:
        assert np.array_equal(Clip.read(source).positions, walk.positions)
    with walk_path.open("rb") as file:
        assert Clip.read(file).name == "curved-walk.bvh"


def test_clips_have_positions_names_and_skeleton(walk: Clip) -> None:
    assert walk.positions.shape == (245, 26, 3)
    assert walk.positions.dtype == np.float64
    assert len(walk) == 245
    assert walk.fps == pytest.approx(120, rel=1e-5)
    assert len(walk.names) == len(walk.parents) == 26
    assert walk.parents[0] == -1 and all(parent < joint for joint, parent in enumerate(walk.parents))
    assert all(walk.names[joint] == "End Site" for joint in walk.end_sites)
    skeleton = walk.skeleton
    assert skeleton.confidence["left_ankle"] > 0.9
    assert "name" in skeleton.reasons["left_ankle"]
    assert skeleton.leg == pytest.approx(0.9, abs=0.05)
    assert (skeleton.up, skeleton.unit_name) == (walk.up, "in")


def test_unchanged_clips_keep_the_bytes_of_their_file(walk_path: Path, tmp_path: Path) -> None:
    out = tmp_path / "copy.bvh"
    Clip.read(walk_path).write(out)
    assert out.read_bytes() == walk_path.read_bytes()


def test_overrides_return_new_clips(walk: Clip) -> None:
    other = walk.override(fps=60, up="z", unit=0.01, roles={"left_toe": None, "right_ankle": "Bip01 R Foot"})
    assert (other.fps, other.up, other.unit) == (60, "z", 0.01)
    assert "left_toe" not in other.skeleton.roles
    assert walk.up == "y" and "left_toe" in walk.skeleton.roles
    assert other.override().skeleton == other.skeleton
    # Later overrides keep earlier ones.
    assert other.override(fps=30).up == "z"


def test_detections_have_arrays_of_both_feet(walk: Clip) -> None:
    detection = plantigrade.detect(walk)
    for part in ("contact", "heel", "toe"):
        array = getattr(detection, part)
        assert array.shape == (245, 2) and array.dtype == np.bool_
        assert np.array_equal(array, detection.planted(part))
    assert detection.confidence.shape == (245, 2)
    assert detection.confidence.min() >= 0.5 and detection.confidence.max() <= 1
    assert detection.height("heel").min() >= 0
    assert detection.parts == ("contact", "toe", "heel")
    contact = detection.contact
    for interval in detection.intervals:
        column = 0 if interval.side == "left" else 1
        assert detection.planted(interval.part)[interval.start : interval.end, column].all()
    contact[:] = False
    assert detection.contact.any(), "arrays are copies"


def test_events_state_their_uncertainty(walk: Clip) -> None:
    events = plantigrade.detect(walk).events
    assert [event.kind for event in events][:2] == ["strike", "off"]
    assert all(event.uncertainty is None or 0 < event.uncertainty < 0.1 for event in events)
    assert len(plantigrade.detect(walk).part_events) > len(events)


def test_edits_change_labels(walk: Clip) -> None:
    detection = plantigrade.detect(walk)
    edited = detection.edit([Edit("left", "contact", 70, 80, True), ("right", "contact", 0, 245, False)])
    assert edited.contact[70:80, 0].all() and not edited.contact[:, 1].any()
    assert not detection.contact[70:80, 0].any()
    assert edited.to_dict()["left"]["contact"][1]["source"] == "edited"


def test_endings_determine_the_format(walk: Clip, tmp_path: Path) -> None:
    detection = plantigrade.detect(walk)
    for name, format in [
        ("a.plants.json", "json"),
        ("a.json", "json"),
        ("a.csv", "csv"),
        ("a.events.csv", "events"),
        ("a.part-events.csv", "part-events"),
        ("a.intervals.csv", "intervals"),
        ("a.NPZ", "npz"),
        ("a.py", "blender"),
    ]:
        detection.save(tmp_path / name)
        assert (tmp_path / name).read_bytes() == detection.to_bytes(format)
    detection.save(tmp_path / "labels", "csv")
    with pytest.raises(plantigrade.PlantigradeError, match="pass format"):
        detection.save(tmp_path / "labels")
    with pytest.raises(plantigrade.PlantigradeError, match="unknown format"):
        detection.save(tmp_path / "labels", "xml")
    segmentation = plantigrade.segment(walk)
    segmentation.save(tmp_path / "a.elan.txt")
    assert (tmp_path / "a.elan.txt").read_bytes() == segmentation.to_bytes("elan")
    with np.load(tmp_path / "a.NPZ") as archive:
        assert np.array_equal(archive["contact"], detection.contact)


def test_documents_are_dictionaries(walk_path: Path) -> None:
    document = plantigrade.detect(walk_path).to_dict()
    assert document["format"] == "plantigrade-labels"
    assert len(document["source"]["sha256"]) == 64
    assert json.dumps(document)
    assert plantigrade.segment(walk_path).to_dict()["segments"]


def test_pandas_tables_have_the_labels(walk: Clip) -> None:
    pytest.importorskip("pandas")
    detection = plantigrade.detect(walk)
    frames = detection.to_pandas()
    assert np.array_equal(frames[["left_contact", "right_contact"]].to_numpy(), detection.contact)
    assert len(detection.to_pandas("events")) == len(detection.events)
    assert len(detection.to_pandas("intervals")) == len(detection.intervals)
    assert len(plantigrade.gait(detection).to_pandas()) == 1
    assert len(plantigrade.segment(walk).to_pandas()) == 1
    with pytest.raises(plantigrade.PlantigradeError, match="unknown table"):
        detection.to_pandas("plants")  # type: ignore[arg-type]


def test_plots_have_a_row_per_foot_and_part(walk: Clip) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    detection = plantigrade.detect(walk)
    axes = detection.plot()
    labels = [label.get_text() for label in axes.get_yticklabels()]
    parts = ("contact", "heel", "toe")
    assert labels == [f"{side} {part}" for side in ("left", "right") for part in parts]
    bars = [collection for collection in axes.collections if len(collection.get_paths()) == 1]
    assert len(bars) >= len(detection.intervals)
    assert len(plantigrade.detect(walk, method="paper").plot(axes).get_yticklabels()) == 2
    matplotlib.pyplot.close("all")


def test_segments_cover_the_clip(walk: Clip) -> None:
    segmentation = plantigrade.segment(walk)
    segments = segmentation.segments
    assert segments[0].start == 0 and segments[-1].end == 245
    assert len(segmentation.cuts) == len(segments) - 1
    assert segmentation.labels.shape == (245,)
    for method in plantigrade.segment_methods():
        assert plantigrade.segment(walk, method=method.name).segments


def test_segments_of_positions_are_those_of_the_clip(walk: Clip) -> None:
    points = Clip.from_positions(
        walk.positions,
        fps=walk.fps,
        parents=walk.parents,
        roles=walk.skeleton.roles,
        up=walk.up,
        unit=walk.unit,
    )
    assert plantigrade.segment(points).segments == plantigrade.segment(walk).segments


def test_all_methods_label_the_walk(walk: Clip) -> None:
    for method in plantigrade.methods():
        detection = plantigrade.detect(walk, method=method.name)
        assert detection.planted(detection.parts[0]).any()  # type: ignore[arg-type]


def test_clean_up_removes_slides(walk: Clip) -> None:
    detection = plantigrade.detect(walk)
    cleaned = plantigrade.clean(walk)
    assert cleaned.cleaned and all(plant.after < 0.001 for plant in cleaned.cleaned)
    assert max(slide.distance for slide in detection.slides()) > 0.01
    assert walk.cleaned == ()
    by_array = plantigrade.clean(walk, {part: detection.planted(part) for part in detection.parts})  # type: ignore[arg-type]
    assert by_array.to_bytes() == cleaned.to_bytes()
    first = plantigrade.clean(walk, only=[("left", 0, 10)])
    reasons = [plant.skip_reason for plant in first.cleaned]
    assert reasons[0] is None and reasons[1:] == ["it was not selected"] * (len(reasons) - 1)


def test_scores_compare_with_any_reference(walk: Clip, walk_path: Path) -> None:
    detection = plantigrade.detect(walk)
    truth = walk_path.with_suffix(".json")
    scores = plantigrade.score(detection, truth)
    assert set(scores) == {"contact", "heel", "toe"}
    assert scores == plantigrade.score(walk, truth.read_bytes())
    assert scores["contact"]["rows"][3]["lenient"] > 0.99
    same = plantigrade.score(detection, detection)
    assert all(score["rows"][0]["strict"] == 1 for score in same.values())
    unknown = np.where(detection.contact, 1.0, np.nan)
    assert plantigrade.score(detection, unknown)["contact"]["rows"][0]["lenient"] == 1
    segmentation = plantigrade.segment(walk)
    cuts = plantigrade.score(segmentation, segmentation.to_bytes("json"))
    assert cuts["cuts"][0]["f1"] == 1


def test_defaults_are_those_of_the_core() -> None:
    import inspect

    defaults = _plantigrade.defaults()
    for function in (plantigrade.detect, plantigrade.segment):
        parameters = inspect.signature(function).parameters
        for name, value in defaults[function.__name__].items():
            assert parameters[name].default == value, name


def test_objects_can_be_pickled(walk: Clip) -> None:
    changed = walk.override(fps=60, roles={"left_toe": None})
    points = Clip.from_positions(walk.positions, fps=120, roles=walk.skeleton.roles, up="y")
    for clip in (walk, changed, points, plantigrade.clean(walk, only=[("left", 0, 10)])):
        restored = pickle.loads(pickle.dumps(clip))
        assert np.array_equal(restored.positions, clip.positions)
        assert (restored.skeleton, restored.fps, restored.cleaned) == (clip.skeleton, clip.fps, clip.cleaned)
        edited = plantigrade.detect(clip, r=0.002).edit([("left", "contact", 0, 9, False)])
        again = pickle.loads(pickle.dumps(edited.edit([("left", "contact", 3, 5, True)])))
        assert list(again.contact[:9, 0]) == [False] * 3 + [True] * 2 + [False] * 4
        assert np.array_equal(again.toe[9:], edited.toe[9:])
    segmentation = plantigrade.segment(walk, method="lsd")
    assert pickle.loads(pickle.dumps(segmentation)).segments == segmentation.segments


def test_threads_share_clips(walk: Clip) -> None:
    expected = plantigrade.detect(walk).contact
    results: list[np.ndarray] = []
    threads = [
        threading.Thread(target=lambda: results.append(plantigrade.detect(walk).contact)) for _ in range(8)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 8 and all(np.array_equal(result, expected) for result in results)


def test_detection_releases_the_interpreter(walk_path: Path) -> None:
    clip = Clip.read(walk_path)
    long = Clip.from_positions(np.tile(clip.positions, (200, 1, 1)), fps=clip.fps, roles=clip.skeleton.roles)
    is_done = threading.Event()

    def label() -> None:
        plantigrade.detect(long)
        is_done.set()

    thread = threading.Thread(target=label)
    thread.start()
    steps = 0
    while not is_done.is_set():
        steps += 1
        is_done.wait(0.001)
    thread.join()
    assert steps > 3
