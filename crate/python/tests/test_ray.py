"""Labels of many clips on a cluster."""

from __future__ import annotations

import io
import os
import re
import shutil
import signal
import sys
import tarfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import PROJECT, SAMPLES

import plantigrade

ray = pytest.importorskip("ray")
pytest.importorskip("pyarrow")

import pyarrow as pa
import pyarrow.parquet as pq

from plantigrade import ray as plantigrade_ray


@pytest.fixture(scope="module")
def cluster() -> Iterator[None]:
    ray.cloudpickle.register_pickle_by_value(sys.modules[__name__])
    # A cluster of its own, also if another one is running.
    ray.init(
        address="local", num_cpus=2, include_dashboard=False, log_to_driver=False, configure_logging=False
    )
    yield
    ray.shutdown()


@pytest.fixture
def clips(tmp_path: Path) -> Path:
    """Folder with clips of which one is broken, and an archive of clips."""
    folder = tmp_path / "clips"
    (folder / "more").mkdir(parents=True)
    samples = sorted(SAMPLES.glob("*.bvh"))
    for sample in samples[:9]:
        shutil.copy(sample, folder)
    shutil.copy(samples[9], folder / "more" / "other.BVH")
    (folder / "broken.bvh").write_text("HIERARCHY\nROOT a\n{\nOFFSET x\n")
    with tarfile.open(folder / "shard-000.tar", "w") as archive:
        for sample in samples[10:]:
            archive.add(sample, arcname=sample.name)
        content = b"no clip"
        member = tarfile.TarInfo("notes.txt")
        member.size = len(content)
        archive.addfile(member, io.BytesIO(content))
    return folder


def rows(out: Path) -> dict[str, dict[str, Any]]:
    """Return the rows by clip; each clip has one."""
    table = pq.read_table(out)
    assert table.schema.equals(plantigrade_ray.SCHEMA)
    found = table.to_pylist()
    assert len({row["clip"] for row in found}) == len(found)
    return {row["clip"]: row for row in found}


def test_each_clip_has_one_row(cluster: None, clips: Path, tmp_path: Path) -> None:
    out = tmp_path / "labels"
    missing = str(clips / "missing.bvh")
    summary = plantigrade_ray.run([str(clips), missing], str(out), clips_per_task=4)
    assert summary == (15, 13, 2, 0, summary.frames, 0)
    by_clip = rows(out)
    walk = by_clip[str(clips / "curved-walk.bvh")]
    detection = plantigrade.detect(clips / "curved-walk.bvh")
    assert np.array_equal(np.transpose([walk["left_contact"], walk["right_contact"]]), detection.contact)
    assert np.array_equal(np.transpose([walk["left_toe"], walk["right_toe"]]), detection.toe)
    assert walk["events"][0] == {
        name: value for name, value in detection.events[0]._asdict().items() if name != "title"
    }
    assert (walk["frames"], walk["schema_version"], walk["up"]) == (245, 1, "y")
    assert len(walk["sha256"]) == 64
    assert "expected a number" in by_clip[str(clips / "broken.bvh")]["error"]
    assert "cannot be read" in by_clip[missing]["error"]
    assert by_clip[f"{clips / 'shard-000.tar'}!straight-jog.bvh"]["error"] is None


def test_runs_are_continued(cluster: None, clips: Path, tmp_path: Path) -> None:
    out = tmp_path / "labels"
    first = plantigrade_ray.run(str(clips), str(out), clips_per_task=4)
    again = plantigrade_ray.run(str(clips), str(out), clips_per_task=4)
    assert again == (*first[:5], first.clips)
    # As a killed run leaves it: a file is missing, and another one is incomplete.
    files = sorted(out.glob("*.parquet"))
    files[0].unlink()
    files[1].write_bytes(files[1].read_bytes()[:100])
    continued = plantigrade_ray.run(str(clips), str(out), clips_per_task=4)
    assert continued[:5] == first[:5] and continued.skipped < first.clips
    assert len(rows(out)) == first.clips
    with pytest.raises(plantigrade.PlantigradeError, match="results of other options"):
        plantigrade_ray.run(str(clips), str(out), method="paper")


def killing_task(flag: str) -> Any:
    """Return a task whose worker is killed in the middle, once."""
    original = plantigrade_ray.label_task

    def label_task(task: pa.Table, options: dict[str, Any], rows_per_table: int) -> Iterator[pa.Table]:
        yield from original(task, options, rows_per_table)
        try:
            os.close(os.open(flag, os.O_CREAT | os.O_EXCL))
        except FileExistsError:
            return
        os.kill(os.getpid(), signal.SIGKILL)

    return label_task


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL")
def test_killed_workers_lose_nothing(
    cluster: None, clips: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    flag = tmp_path / "killed"
    monkeypatch.setattr(plantigrade_ray, "label_task", killing_task(str(flag)))
    summary = plantigrade_ray.run(str(clips), str(tmp_path / "labels"), clips_per_task=2)
    assert flag.exists()
    assert (summary.clips, summary.failures, summary.repeated) == (14, 1, 0)
    assert len(rows(tmp_path / "labels")) == 14


def test_the_command_prints_a_summary(
    cluster: None, clips: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = [str(clips / "*.bvh"), "--out", str(tmp_path / "labels"), "--method", "speed"]
    assert plantigrade_ray.main(arguments) == 1
    output = capsys.readouterr().out
    assert "10 clips: 9 labelled, 1 failed, 0 done before" in output
    assert plantigrade_ray.main([str(clips / "*.xyz"), "--out", str(tmp_path / "none")]) == 2


def test_the_schema_is_documented() -> None:
    page = (PROJECT / "docs" / "python.md").read_text(encoding="utf-8")
    table = page.partition("| column | type |")[2].partition("\n\n")[0]
    columns = [name for row in table.splitlines()[2:] for name in re.findall(r"`(\w+)`", row.split("|")[1])]
    # Columns of left and right have one row.
    assert sorted(columns) == sorted(plantigrade_ray.SCHEMA.names)
    assert f"Version {plantigrade_ray.SCHEMA_VERSION} of its columns" in page


def test_inputs_are_addresses_and_patterns(clips: Path) -> None:
    def names(*inputs: str) -> list[str]:
        return [Path(source).name for source in plantigrade_ray.list_inputs(inputs)]

    assert len(names(str(clips))) == 12
    assert names(f"{clips}/**/*.BVH") == ["other.BVH"]
    assert names(f"{clips}/b[a-l]*.bvh") == ["ballet.bvh"]
    assert names(f"{clips}/shard-???.tar", str(clips / "shard-000.tar")) == ["shard-000.tar"]
    assert len(names(f"file://{clips}")) == 12
    fsspec = pytest.importorskip("fsspec")
    memory = fsspec.filesystem("memory")
    memory.pipe("/clips/walk.bvh", (SAMPLES / "curved-walk.bvh").read_bytes())
    (source,) = plantigrade_ray.list_inputs(["memory://clips"])
    (row,) = plantigrade_ray.label_address(source)
    assert row["error"] is None and row["frames"] == 245


def test_broken_archives_are_rows(tmp_path: Path, clips: Path) -> None:
    archive = tmp_path / "cut.tar"
    archive.write_bytes((clips / "shard-000.tar").read_bytes()[:200_000])
    found = list(plantigrade_ray.label_address(str(archive)))
    assert found[-1]["clip"] == str(archive) and "cannot be read" in found[-1]["error"]
    skipped = list(plantigrade_ray.label_address(str(clips / "shard-000.tar"), ["straight-jog.bvh"]))
    assert len(skipped) == 2
