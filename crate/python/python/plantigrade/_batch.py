"""Labels of many clips on one machine."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _plantigrade
from ._clip import as_clip
from ._detect import detect
from ._errors import PlantigradeError
from ._files import write

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from concurrent.futures import Future

    import pandas as pd

    from ._clip import Path

#: Name of the file in the folder of results that records what each result was made from.
RECORDS = ".plantigrade-batch.jsonl"


class BatchRecord(NamedTuple):
    """Result for one clip of a batch.

    Attributes
    ----------
    path : str
        Path of the clip.
    result : str or None
        Path of the labels; None if the clip could not be labelled.
    error : str or None
        Why the clip could not be labelled.
    frames : int or None
        Number of frames.
    confidence : float or None
        Mean confidence of the labels, 0.5 to 1.
    is_new : bool
        False if the record is one of an earlier run.
    """

    path: str
    result: str | None
    error: str | None
    frames: int | None
    confidence: float | None
    is_new: bool


class BatchResult(tuple[BatchRecord, ...]):
    """Records of all clips of a batch, in the order of the inputs."""

    __slots__ = ()

    @property
    def failures(self) -> tuple[BatchRecord, ...]:
        """Records of the clips that could not be labelled."""
        return tuple(record for record in self if record.error is not None)

    def to_pandas(self) -> pd.DataFrame:
        """Return a data frame with a row per clip; requires pandas."""
        import pandas as pd

        return pd.DataFrame(list(self), columns=list(BatchRecord._fields))


def batch(
    paths: Path | Iterable[Path],
    *,
    out: Path,
    workers: int | None = None,
    format: str = "json",
    force: bool = False,
    progress: bool = True,
    **options: Any,  # noqa: ANN401
) -> BatchResult:
    """Label many clips, on all processors of this machine.

    Writes one file per clip to a folder, with the names of the command line. A clip that cannot be
    labelled is recorded, and the others are labelled. If the batch is interrupted, another call continues
    it: clips that have not changed since they were labelled with the same options are not labelled again.

    Parameters
    ----------
    paths : path or iterable of paths
        BVH files, folders, which are searched recursively, or patterns such as ``"clips/**/*.bvh"``.
    out : path
        Folder for the results.
    workers : int, optional
        Number of clips that are labelled at the same time; one per processor by default.
    format : str
        Format of the results; see :meth:`Detection.to_bytes`.
    force : bool
        If true, results that are up to date are made again.
    progress : bool
        If true, a progress bar is shown if tqdm is installed.
    **options
        Options of :func:`detect`.

    Returns
    -------
    BatchResult
        A record per clip. :attr:`BatchResult.failures` are those of clips that could not be labelled.

    Raises
    ------
    PlantigradeError
        If no clip is found, an option is unknown, or two clips have the same result.

    Examples
    --------
    >>> result = plantigrade.batch(".", out="labels", progress=False)
    >>> [(record.result, record.error) for record in result]
    [('labels/walk.plants.json', None)]
    """
    import json

    extension = _extension(format)
    clips = _inputs(paths)
    folder = os.fspath(out)
    os.makedirs(folder, exist_ok=True)
    results = [os.path.join(folder, f"{stem}.{extension}") for _, stem in clips]
    _check_unique(results, [path for path, _ in clips])
    options = _with_constraints(options, len(clips))
    key = json.dumps(
        {"format": format, "version": _plantigrade.VERSION, **options}, sort_keys=True, default=repr
    )
    earlier = {} if force else _records(folder)
    records: list[BatchRecord | None] = [None] * len(clips)
    todo: list[int] = []
    for index, (path, _) in enumerate(clips):
        known = earlier.get(path)
        is_current = known is not None and known["key"] == key and known["state"] == _state(path)
        if known and is_current and (known["error"] is not None or os.path.exists(results[index])):
            records[index] = _from_entry(known, path, results[index])
        else:
            todo.append(index)

    def label(index: int) -> tuple[int, dict[str, Any]]:
        path = clips[index][0]
        entry: dict[str, Any] = {"path": path, "key": key, "state": _state(path)}
        try:
            detection = detect(path, **options)
            os.makedirs(os.path.dirname(results[index]) or ".", exist_ok=True)
            write(results[index], detection.to_bytes(format))
        except (PlantigradeError, OSError) as error:
            return index, {**entry, "error": str(error), "frames": None, "confidence": None}
        confidence = round(float(detection.confidence.mean()), 6)
        return index, {**entry, "error": None, "frames": len(detection.clip), "confidence": confidence}

    count = workers or _processors()
    with open(os.path.join(folder, RECORDS), "a", encoding="utf-8") as file:
        for index, entry in _progress(_in_parallel(label, todo, count), len(todo), progress):
            file.write(json.dumps(entry) + "\n")
            file.flush()
            records[index] = _from_entry(entry, clips[index][0], results[index], is_new=True)
    return BatchResult(record for record in records if record is not None)


def _with_constraints(options: dict[str, Any], clips: int) -> dict[str, Any]:
    """Return options of a detection in which corrections are prepared for many clips."""
    if options.get("constraints") is None:
        return options
    from ._constraints import constraints_of

    options = dict(options)
    source = options.pop("constraints_clip", None)
    reading = {name: options[name] for name in ("roles", "up", "unit", "lenient") if name in options}
    clip = None if source is None else as_clip(source, **reading)
    constraints = constraints_of(options["constraints"], clip)
    if constraints.clip is None and clips > 1:
        raise PlantigradeError(
            f"the constraints belong to one clip, but there are {clips} clips",
            hint="Name the clip that they belong to with constraints_clip",
        )
    return {**options, "constraints": constraints}


def _from_entry(entry: dict[str, Any], path: str, result: str, is_new: bool = False) -> BatchRecord:
    error = entry["error"]
    return BatchRecord(
        path, result if error is None else None, error, entry["frames"], entry["confidence"], is_new
    )


def _in_parallel(function: Any, items: list[int], workers: int) -> Iterator[Any]:  # noqa: ANN401
    """Yield results as they arrive. Few items wait, so that memory does not grow with their number."""
    from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait

    with ThreadPoolExecutor(workers) as pool:
        waiting: set[Future[Any]] = set()
        rest = iter(items)
        try:
            while True:
                while len(waiting) < 2 * workers and (item := next(rest, None)) is not None:
                    waiting.add(pool.submit(function, item))
                if not waiting:
                    return
                done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                yield from (future.result() for future in done)
        finally:
            for future in waiting:
                future.cancel()


def _progress(results: Iterator[Any], total: int, is_shown: bool) -> Iterator[Any]:
    if is_shown:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            return results
        return iter(tqdm(results, total=total, unit="clip"))
    return results


def _processors() -> int:
    """Return the number of processors that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _extension(format: str) -> str:
    formats = _plantigrade.plant_formats()
    for name, _, _, extension in formats:
        if name == format:
            return extension
    raise PlantigradeError(
        f"unknown format {format!r}", hint=f"Use one of {', '.join(name for name, *_ in formats)}"
    )


def _inputs(paths: Path | Iterable[Path]) -> list[tuple[str, str]]:
    """Return the path of each clip, and that of its result without extension."""
    import glob

    clips: list[tuple[str, str]] = []
    for path in [paths] if isinstance(paths, (str, os.PathLike)) else paths:
        name = os.fspath(path)
        if os.path.isdir(name):
            found = _below(name)
            clips += [(file, os.path.splitext(os.path.relpath(file, name))[0]) for file in found]
        elif not os.path.exists(name) and glob.has_magic(name):
            root = _fixed_part(name)
            found = sorted(file for file in glob.glob(name, recursive=True) if os.path.isfile(file))
            clips += [(file, os.path.splitext(os.path.relpath(file, root))[0]) for file in found]
        else:
            clips.append((name, os.path.splitext(os.path.basename(name))[0]))
    if not clips:
        raise PlantigradeError(f"there are no clips in {paths!r}", hint="Name files, folders or patterns")
    return clips


def _below(folder: str) -> list[str]:
    """Return the BVH files below a folder, without the companion files of macOS."""
    files = []
    for parent, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name != "__MACOSX" and not name.startswith("._"))
        files += [
            os.path.join(parent, name)
            for name in sorted(names)
            if name.lower().endswith(".bvh") and not name.startswith("._")
        ]
    return files


def _fixed_part(pattern: str) -> str:
    """Return the folder of a pattern up to the first part with wildcards."""
    import glob

    folder = pattern
    while glob.has_magic(folder):
        folder = os.path.dirname(folder)
    return folder or "."


def _check_unique(results: list[str], paths: list[str]) -> None:
    owners: dict[str, str] = {}
    for result, path in zip(results, paths, strict=True):
        other = owners.setdefault(result, path)
        if other != path:
            raise PlantigradeError(
                f"{other} and {path} have the same result, {result}", hint="Label them in different folders"
            )


def _records(folder: str) -> dict[str, dict[str, Any]]:
    """Return the last record of each clip. A line that was cut off is left out."""
    import json

    records = {}
    try:
        with open(os.path.join(folder, RECORDS), encoding="utf-8") as file:
            for line in file:
                try:
                    entry = json.loads(line)
                    records[entry["path"]] = entry
                except (ValueError, KeyError, TypeError):
                    continue
    except FileNotFoundError:
        pass
    return records


def _state(path: str) -> list[int] | None:
    """Return size and time of change of a file."""
    try:
        status = os.stat(path)
    except OSError:
        return None
    return [status.st_size, status.st_mtime_ns]
