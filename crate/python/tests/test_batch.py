"""Labels of many clips on one machine."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from conftest import SAMPLES

import plantigrade
from plantigrade import _batch


@pytest.fixture
def clips(tmp_path: Path) -> Path:
    """Folder with clips, one of them in a subfolder and one broken."""
    folder = tmp_path / "clips"
    (folder / "more").mkdir(parents=True)
    shutil.copy(SAMPLES / "curved-walk.bvh", folder)
    shutil.copy(SAMPLES / "frog-jumps.bvh", folder / "more" / "jump.BVH")
    (folder / "broken.bvh").write_text("HIERARCHY\nROOT a\n{\nOFFSET x\n")
    (folder / "._curved-walk.bvh").write_text("companion file")
    (folder / "notes.txt").write_text("no clip")
    return folder


def names(folder: Path) -> list[str]:
    return sorted(
        str(path.relative_to(folder))
        for path in folder.rglob("*")
        if path.is_file() and not path.name.startswith(".")
    )


def test_all_clips_are_labelled_and_failures_recorded(clips: Path, tmp_path: Path) -> None:
    out = tmp_path / "labels"
    result = plantigrade.batch(clips, out=out, progress=False)
    assert names(out) == ["curved-walk.plants.json", "more/jump.plants.json"]
    labels = json.loads((out / "curved-walk.plants.json").read_text())
    assert labels == plantigrade.detect(clips / "curved-walk.bvh").to_dict()
    assert len(result) == 3
    (failure,) = result.failures
    assert failure.path.endswith("broken.bvh") and failure.result is None
    assert failure.error is not None and "expected a number" in failure.error
    walk = next(record for record in result if record.path.endswith("curved-walk.bvh"))
    assert walk.frames == 245 and walk.confidence is not None and walk.confidence > 0.9


def test_batches_are_continued(clips: Path, tmp_path: Path) -> None:
    out = tmp_path / "labels"
    plantigrade.batch(clips, out=out, progress=False)
    again = plantigrade.batch(clips, out=out, progress=False)
    assert [record.is_new for record in again] == [False] * 3
    assert len(again.failures) == 1
    # As an interrupted batch leaves it: no result, and half a record.
    (out / "curved-walk.plants.json").unlink()
    records = out / _batch.RECORDS
    records.write_text(records.read_text() + '{"path": "')
    continued = plantigrade.batch(clips, out=out, progress=False)
    assert [record.path for record in continued if record.is_new] == [str(clips / "curved-walk.bvh")]
    shutil.copy(SAMPLES / "one-leg-hop.bvh", clips / "curved-walk.bvh")
    changed = plantigrade.batch(clips, out=out, progress=False)
    assert sum(record.is_new for record in changed) == 1
    other = plantigrade.batch(clips, out=out, progress=False, method="paper")
    assert all(record.is_new for record in other)
    forced = plantigrade.batch(clips, out=out, progress=False, method="paper", force=True)
    assert all(record.is_new for record in forced)


def test_inputs_are_files_folders_and_patterns(clips: Path, tmp_path: Path) -> None:
    pattern = str(clips / "**" / "*.BVH")
    result = plantigrade.batch(
        [pattern, clips / "curved-walk.bvh"], out=tmp_path / "a", format="npz", workers=1, progress=False
    )
    assert names(tmp_path / "a") == ["curved-walk.contacts.npz", "more/jump.contacts.npz"]
    assert not result.failures
    missing = plantigrade.batch([clips / "missing.bvh"], out=tmp_path / "b", progress=False)
    assert missing[0].error is not None and "No such file" in missing[0].error
    with pytest.raises(plantigrade.PlantigradeError, match="no clips"):
        plantigrade.batch(str(clips / "*.txt2"), out=tmp_path / "c")
    with pytest.raises(plantigrade.PlantigradeError, match="same result"):
        plantigrade.batch([clips / "curved-walk.bvh", SAMPLES / "curved-walk.bvh"], out=tmp_path / "d")
    with pytest.raises(plantigrade.PlantigradeError, match="unknown format"):
        plantigrade.batch(clips, out=tmp_path / "e", format="xml")


def test_unknown_options_end_the_batch(clips: Path, tmp_path: Path) -> None:
    with pytest.raises(TypeError, match="colour"):
        plantigrade.batch(clips, out=tmp_path / "labels", progress=False, colour="red")


def test_records_become_a_data_frame(clips: Path, tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    frame = plantigrade.batch(clips, out=tmp_path / "labels", progress=False).to_pandas()
    assert frame["error"].notna().sum() == 1
