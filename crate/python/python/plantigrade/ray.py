"""Labels of many clips on a cluster, with Ray Data; requires ``plantigrade[ray]``.

``run`` is a pipeline ``read → map_batches(label) → write_parquet``. It runs on the local machine or,
unchanged, on a cluster. The results are Parquet files with one row per clip, failures included;
:data:`SCHEMA` describes the columns.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import posixpath
import re
import sys
import tarfile
from typing import TYPE_CHECKING, Any, NamedTuple

import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.fs
import pyarrow.parquet as pq

from . import _plantigrade
from ._clip import Clip
from ._detect import detect
from ._errors import PlantigradeError

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

__all__ = ["SCHEMA", "SCHEMA_VERSION", "Summary", "label_address", "main", "run", "summarize"]

SCHEMA_VERSION = 1
"""Version of :data:`SCHEMA`; it changes if columns are removed or change their meaning."""

_LABELS = [
    pa.field(f"{side}_{part}", pa.list_(pa.bool_()))
    for part in ("contact", "heel", "toe")
    for side in ("left", "right")
]
_CONFIDENCE = [pa.field(f"{side}_confidence", pa.list_(pa.float32())) for side in ("left", "right")]
_EVENT = pa.struct(
    [
        ("time", pa.float64()),
        ("frame", pa.int32()),
        ("side", pa.string()),
        ("kind", pa.string()),
        ("uncertainty", pa.float64()),
    ]
)
_NOTICE = pa.struct([("code", pa.string()), ("text", pa.string())])

SCHEMA = pa.schema(
    [
        pa.field("clip", pa.string(), nullable=False),
        pa.field("error", pa.string()),
        pa.field("schema_version", pa.int32(), nullable=False),
        pa.field("package_version", pa.string(), nullable=False),
        pa.field("options", pa.string(), nullable=False),
        pa.field("sha256", pa.string()),
        pa.field("method", pa.string()),
        pa.field("frames", pa.int32()),
        pa.field("fps", pa.float64()),
        pa.field("up", pa.string()),
        pa.field("unit", pa.float64()),
        *_LABELS,
        *_CONFIDENCE,
        pa.field("events", pa.list_(_EVENT)),
        pa.field("notices", pa.list_(_NOTICE)),
    ],
    metadata={"plantigrade_schema_version": str(SCHEMA_VERSION)},
)
"""Columns of the results.

``clip`` is the address of the clip; for a member of an archive, ``address!member``. If ``error`` is not
null, the clip could not be labelled, and the columns from ``method`` on are null. ``options`` are those of
the detection, as JSON. Labels are one value per frame, and null for parts that the method does not label;
confidence is that of contact. Times and uncertainties of events are in seconds.
"""

#: Rows are collected as Python objects, which take more memory than the table.
_ROWS_PER_TABLE = 64

#: Names of the files of results, which Ray gives them.
_RESULT = re.compile(r"\w+_\d{6}[-\d]*\.parquet")


class Summary(NamedTuple):
    """Contents of a folder of results.

    Attributes
    ----------
    clips : int
        Number of clips with a row.
    labelled : int
        Number of clips that were labelled.
    failures : int
        Number of clips that could not be labelled.
    repeated : int
        Number of rows beyond one per clip: 0 unless a run was started twice at the same time.
    frames : int
        Number of labelled frames.
    skipped : int
        Number of clips that an earlier run had done.
    """

    clips: int
    labelled: int
    failures: int
    repeated: int
    frames: int
    skipped: int = 0


def run(
    inputs: str | Sequence[str],
    out: str,
    *,
    address: str | None = None,
    clips_per_task: int | None = None,
    concurrency: int | None = None,
    **options: Any,  # noqa: ANN401
) -> Summary:
    """Label all clips and write the results as Parquet.

    Each file of results has the rows of one task. If a worker is lost, Ray repeats its tasks, which replace
    incomplete files. If the whole run is interrupted, another call continues it: clips with a row are
    skipped, also those that could not be labelled.

    Parameters
    ----------
    inputs : str or sequence of str
        Addresses of BVH files, folders, patterns such as ``s3://bucket/**/*.bvh``, and archives (``.tar``,
        ``.tar.gz``) of BVH files, as in WebDataset. Addresses are paths, or those of pyarrow or fsspec.
    out : str
        Address of the folder for the results.
    address : str, optional
        Address of the cluster. By default, Ray that is running is used, or the local machine.
    clips_per_task : int, optional
        Number of clips per task; an archive is a task of its own. By default 256, or fewer if there would be
        fewer than four tasks per processor. Scheduling takes about 0.2 s per task.
    concurrency : int, optional
        Maximum number of tasks at the same time; one per processor by default.
    **options
        Options of :func:`plantigrade.detect`.

    Returns
    -------
    Summary
        Numbers of clips, failures and frames.
    """
    import ray
    import ray.data

    if not ray.is_initialized():
        ray.init(address=address, log_to_driver=False, include_dashboard=False)
    if "constraints" in options:
        raise PlantigradeError(
            "constraints are not supported on a cluster", hint="Use plantigrade.batch on one machine"
        )
    encoded = json.dumps(options, sort_keys=True)
    done = _done(out, encoded)
    sources = list_inputs([inputs] if isinstance(inputs, str) else inputs)
    todo = [source for source in sources if source not in done]
    plain = [source for source in todo if not _is_archive(source)]
    if clips_per_task is None:
        processors = int(ray.cluster_resources().get("CPU", 1))
        clips_per_task = min(256, max(1, len(plain) // (4 * processors)))
    items = [
        {"sources": plain[start : start + clips_per_task], "done": [""]}
        for start in range(0, len(plain), clips_per_task)
    ]
    members: dict[str, list[str]] = {}
    for clip in done:
        archive, separator, member = clip.partition("!")
        if separator:
            members.setdefault(archive, []).append(member)
    archives = [source for source in todo if _is_archive(source)]
    items += [{"sources": [source], "done": ["", *members.get(source, [])]} for source in archives]
    if items:
        blocks = ray.data.from_items(items, override_num_blocks=len(items))
        labelled = blocks.map_batches(
            label_task,
            batch_size=1,
            batch_format="pyarrow",
            fn_args=(options, _ROWS_PER_TABLE),
            concurrency=concurrency,
        )
        filesystem, path = _filesystem(out)
        labelled.write_parquet(path, filesystem=filesystem)
    return summarize(out)._replace(skipped=len(done))


def label_task(task: pa.Table, options: dict[str, Any], rows_per_table: int) -> Iterator[pa.Table]:
    """Label the clips of a task; yields tables with the columns of :data:`SCHEMA`."""
    rows: list[dict[str, Any]] = []
    for sources, done in zip(task["sources"].to_pylist(), task["done"].to_pylist(), strict=True):
        known = set(done)
        for source in sources:
            for row in label_address(source, known, options):
                rows.append(row)
                if len(rows) == rows_per_table:
                    yield pa.Table.from_pylist(rows, SCHEMA)
                    rows = []
    if rows or not task.num_rows:
        yield pa.Table.from_pylist(rows, SCHEMA)


def label_address(
    source: str, done: Iterable[str] = (), options: dict[str, Any] | None = None
) -> Iterator[dict[str, Any]]:
    """Yield a row for a clip, or one for each clip of an archive.

    Parameters
    ----------
    source : str
        Address of a BVH file or an archive.
    done : iterable of str
        Members of the archive that are skipped.
    options : dict, optional
        Options of :func:`plantigrade.detect`.
    """
    options = options or {}
    skipped = set(done)
    try:
        filesystem, path = _filesystem(source)
        with filesystem.open_input_stream(path, compression=None) as stream:
            if not _is_archive(source):
                yield _row(source, stream.read(), options)
                return
            with tarfile.open(fileobj=stream, mode="r|*") as archive:
                for member in archive:
                    if not member.isfile() or not member.name.lower().endswith(".bvh"):
                        continue
                    if member.name in skipped or posixpath.basename(member.name).startswith("._"):
                        continue
                    content = archive.extractfile(member)
                    yield _row(f"{source}!{member.name}", content.read() if content else b"", options)
    except (OSError, EOFError, ValueError, tarfile.TarError, pa.ArrowException) as error:
        yield {**_head(source, options), "error": f"{source} cannot be read: {error}"}


def _head(clip: str, options: dict[str, Any]) -> dict[str, Any]:
    return {
        "clip": clip,
        "error": None,
        "schema_version": SCHEMA_VERSION,
        "package_version": _plantigrade.VERSION,
        "options": json.dumps(options, sort_keys=True),
    }


def _row(clip: str, data: bytes, options: dict[str, Any]) -> dict[str, Any]:
    """Return the row of a clip."""
    row = {**_head(clip, options), "sha256": hashlib.sha256(data).hexdigest()}
    try:
        detection = detect(Clip.read(data), **options)
    except (PlantigradeError, TypeError) as error:
        return {**row, "error": str(error)}
    for part in detection.parts:
        labels = detection.planted(part)  # type: ignore[arg-type]
        row[f"left_{part}"], row[f"right_{part}"] = labels[:, 0], labels[:, 1]
    confidence = detection.confidence
    return {
        **row,
        "method": detection.method,
        "frames": len(detection.clip),
        "fps": detection.fps,
        "up": detection.clip.up,
        "unit": detection.clip.unit,
        "left_confidence": confidence[:, 0],
        "right_confidence": confidence[:, 1],
        "events": [
            {name: value for name, value in event._asdict().items() if name != "title"}
            for event in detection.events
        ],
        "notices": [{"code": notice.code, "text": notice.text} for notice in detection.notices],
    }


def list_inputs(inputs: Iterable[str]) -> list[str]:
    """Return the addresses of clips and archives that inputs name, each once.

    Parameters
    ----------
    inputs : iterable of str
        Addresses of files, folders and patterns.
    """
    sources: dict[str, None] = {}
    for entry in inputs:
        filesystem, path = _filesystem(entry)
        scheme = entry[: entry.index("://") + 3] if "://" in entry else ""
        if _has_magic(path):
            folder = path
            while _has_magic(folder):
                folder = posixpath.dirname(folder)
            matches = re.compile(_pattern(path)).fullmatch
            found = [name for name in _files_below(filesystem, folder) if matches(name)]
        elif filesystem.get_file_info(path).type == pa.fs.FileType.Directory:
            found = [name for name in _files_below(filesystem, path) if _is_clip(name) or _is_archive(name)]
        else:
            found = [path]
        sources.update(dict.fromkeys(scheme + name if scheme else name for name in found))
    if not sources:
        raise PlantigradeError(f"there are no clips in {inputs!r}", hint="Name files, folders or patterns")
    return list(sources)


def _files_below(filesystem: pa.fs.FileSystem, folder: str) -> list[str]:
    selector = pa.fs.FileSelector(folder or ".", recursive=True, allow_not_found=True)
    files = filesystem.get_file_info(selector)
    return sorted(
        info.path
        for info in files
        if info.type == pa.fs.FileType.File and not posixpath.basename(info.path).startswith("._")
    )


def _has_magic(path: str) -> bool:
    return any(character in path for character in "*?[")


def _pattern(path: str) -> str:
    """Return a pattern of paths as a regular expression; ``**`` stands for any number of folders."""
    text = ""
    for piece in re.split(r"(\*\*/|\*\*|\*|\?|\[[^]]*\])", path):
        if piece == "**/":
            text += "(?:.*/)?"
        elif piece == "**":
            text += ".*"
        elif piece == "*":
            text += "[^/]*"
        elif piece == "?":
            text += "[^/]"
        elif piece.startswith("["):
            text += piece.replace("[!", "[^")
        else:
            text += re.escape(piece)
    return text


def _is_clip(path: str) -> bool:
    return path.lower().endswith(".bvh")


def _is_archive(path: str) -> bool:
    return path.lower().endswith((".tar", ".tar.gz", ".tgz"))


def _filesystem(address: str) -> tuple[pa.fs.FileSystem, str]:
    """Return the file system of an address, and the path in it."""
    if "://" not in address:
        return pa.fs.LocalFileSystem(), os.path.abspath(address)
    try:
        filesystem, path = pa.fs.FileSystem.from_uri(address)
    except pa.ArrowInvalid:
        import fsspec

        scheme, _, path = address.partition("://")
        handler = pa.fs.FSSpecHandler(fsspec.filesystem(scheme))
        filesystem = pa.fs.PyFileSystem(handler)
    return filesystem, path


def _result_files(out: str) -> tuple[pa.fs.FileSystem, list[str]]:
    filesystem, path = _filesystem(out)
    names = _files_below(filesystem, path)
    return filesystem, [name for name in names if _RESULT.fullmatch(posixpath.basename(name))]


def _done(out: str, options: str) -> set[str]:
    """Return the clips that have a row. Removes files that a killed run has left incomplete."""
    filesystem, files = _result_files(out)
    done: set[str] = set()
    for name in files:
        try:
            with filesystem.open_input_file(name) as file:
                table = pq.read_table(file, columns=["clip", "options"])
        except (pa.ArrowInvalid, EOFError):
            filesystem.delete_file(name)
            continue
        others = set(table["options"].unique().to_pylist()) - {options}
        if others:
            raise PlantigradeError(
                f"{out} has results of other options: {others.pop()}", hint="Choose another folder"
            )
        done.update(table["clip"].to_pylist())
    return done


def summarize(out: str) -> Summary:
    """Return the numbers of clips, failures and frames in a folder of results.

    Parameters
    ----------
    out : str
        Address of the folder.
    """
    filesystem, files = _result_files(out)
    clips: set[str] = set()
    rows = failures = frames = 0
    for name in files:
        with filesystem.open_input_file(name) as file:
            table = pq.read_table(file, columns=["clip", "error", "frames"])
        clips.update(table["clip"].to_pylist())
        rows += table.num_rows
        failures += table.num_rows - table["error"].null_count
        frames += pc.sum(table["frames"]).as_py() or 0
    return Summary(len(clips), rows - failures, failures, rows - len(clips), frames)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command ``plantigrade-ray``. Returns its exit code: 1 if a clip could not be labelled.

    Parameters
    ----------
    arguments : sequence of str, optional
        Arguments of the command line.
    """
    parser = argparse.ArgumentParser(
        prog="plantigrade-ray", description="Labels foot plants in many BVH files on a Ray cluster."
    )
    parser.add_argument("inputs", nargs="+", help="BVH files, folders, patterns, archives (.tar)")
    parser.add_argument("--out", required=True, help="folder for the Parquet files")
    parser.add_argument("--address", help="address of the cluster, or auto; default: this machine")
    parser.add_argument("--clips-per-task", type=int, metavar="N", help="default: 256 or fewer")
    parser.add_argument("--concurrency", type=int, metavar="N", help="default: one task per processor")
    parser.add_argument("--method", default="robust", help="detection method; default: robust")
    parser.add_argument("--fps", type=float, help="frame rate, instead of that of the files")
    parser.add_argument("--up", help="up axis, instead of the detected one")
    parser.add_argument("--unit", type=float, help="metres per unit, instead of the detected ones")
    given = parser.parse_args(arguments)
    options = {name: getattr(given, name) for name in ("method", "fps", "up", "unit")}
    try:
        summary = run(
            given.inputs,
            given.out,
            address=given.address,
            clips_per_task=given.clips_per_task,
            concurrency=given.concurrency,
            **{name: value for name, value in options.items() if value is not None},
        )
    except PlantigradeError as error:
        print(f"plantigrade-ray: error: {error}", file=sys.stderr)
        return 2
    print(
        f"{summary.clips} clips: {summary.labelled} labelled, {summary.failures} failed, "
        f"{summary.skipped} done before; {summary.frames} frames"
    )
    return 1 if summary.failures else 0


if __name__ == "__main__":
    sys.exit(main())
