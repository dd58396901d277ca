"""Segmentation into actions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from . import _plantigrade
from ._clip import Clip, as_clip
from ._files import format_of, write
from ._notice import Notice

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd
    from numpy.typing import ArrayLike, NDArray

    from ._clip import Names, Path, Roles, Source


class Segment(NamedTuple):
    """An interval with one action.

    Attributes
    ----------
    start, end : int
        First frame, and first frame after the segment.
    kind : str
        ``"action"``, ``"periodic"`` or ``"aperiodic"``.
    label : str
        Label of the method; empty if it has none.
    action : str
        Name of the action, which all segments share in which the same is done: A, B, …; empty if
        unknown.
    period : float or None
        Period of the cycles in seconds, if the action repeats.
    cycles : float or None
        Number of cycles, if the action repeats.
    """

    start: int
    end: int
    kind: str
    label: str
    action: str
    period: float | None
    cycles: float | None


class Motif(NamedTuple):
    """Motion between two turning points.

    Attributes
    ----------
    start, end : int
        First frame, and first frame after the motif.
    cls : int
        Class of similar motifs, from 1.
    amplitude : float
        Change of the curve of the method over the motif.
    """

    start: int
    end: int
    cls: int
    amplitude: float


class Segmentation:
    """Segments of a clip: the result of :func:`segment`."""

    __slots__ = ("_clip", "_params", "_raw")

    def __init__(self, clip: Clip, params: tuple[str, int | None, str, str, bool]) -> None:
        self._raw = clip._raw.segment(params)
        self._clip = clip
        self._params = params

    @property
    def clip(self) -> Clip:
        """The clip that was segmented."""
        return self._clip

    @property
    def segments(self) -> tuple[Segment, ...]:
        """Segments in order; they cover the clip without gaps."""
        return tuple(Segment(*segment) for segment in self._raw.segments())

    @property
    def cuts(self) -> NDArray[np.int64]:
        """First frame of each segment except the first."""
        import numpy as np

        return np.array([segment[0] for segment in self._raw.segments()[1:]], dtype=np.int64)

    @property
    def transitions(self) -> tuple[tuple[int, int], ...]:
        """Frame ranges in which one action changes into the next, if the method detects them."""
        return tuple(self._raw.transitions())

    @property
    def motifs(self) -> tuple[Motif, ...]:
        """Motifs, if the method detects them."""
        return tuple(Motif(*motif) for motif in self._raw.motifs())

    @property
    def labels(self) -> NDArray[np.int64]:
        """Index of the segment of each frame, shape (frames,)."""
        import numpy as np

        labels = np.zeros(self._raw.frames(), dtype=np.int64)
        labels[self.cuts] = 1
        return np.cumsum(labels)

    @property
    def method(self) -> str:
        """Name of the method."""
        return self._raw.method()

    @property
    def notices(self) -> tuple[Notice, ...]:
        """What was assumed, repaired or left out, by reader and method."""
        return tuple(Notice(*notice) for notice in self._raw.notices())

    def to_bytes(self, format: str = "json") -> bytes:
        """Return the segments as the bytes of a file.

        Parameters
        ----------
        format : str
            ``"json"``, ``"csv"``, ``"babel"``, ``"audacity"``, ``"elan"``, ``"npz"``, ``"unreal"`` or
            ``"unity"``, as in ``plantigrade segment --format``.
        """
        return self._raw.to_bytes(format)

    def to_dict(self) -> dict[str, Any]:
        """Return the segments as the document that :meth:`save` writes as JSON."""
        import json

        document: dict[str, Any] = json.loads(self._raw.to_bytes("json"))
        return document

    def to_pandas(self) -> pd.DataFrame:
        """Return a data frame with a row per segment; requires pandas."""
        import io

        import pandas as pd

        return pd.read_csv(io.BytesIO(self._raw.to_bytes("csv")))

    def save(self, path: Path, format: str | None = None) -> None:
        """Write the segments as a file.

        Parameters
        ----------
        path : path
            File to write. Its ending determines the format: ``.segments.json`` or ``.json``,
            ``.segments.csv`` or ``.csv``, ``.babel.json``, ``.audacity.txt`` or ``.txt``, ``.elan.txt``,
            ``.segments.npz`` or ``.npz``, ``.segments.unreal.py`` or ``.py``, ``.segments.unity.cs``
            or ``.cs``.
        format : str, optional
            Format, if the ending does not determine it; see :meth:`to_bytes`.
        """
        name = format or format_of(path, _plantigrade.segment_formats())
        write(path, self._raw.to_bytes(name))

    def __reduce__(self) -> tuple[Any, ...]:
        return Segmentation, (self._clip, self._params)

    def __repr__(self) -> str:
        count = len(self._raw.segments())
        return f"Segmentation({self._raw.frames()} frames, {count} segments, method {self.method!r})"


def segment(
    source: Source,
    *,
    fps: float | None = None,
    names: Names | None = None,
    roles: Roles | None = None,
    parents: ArrayLike | None = None,
    up: str | None = None,
    unit: float | None = None,
    lenient: bool = False,
    method: str = "auto",
    dims: int | None = None,
    residual: str = "absolute",
    template: str = "mean",
    published: bool = False,
) -> Segmentation:
    """Segment motion into actions.

    Parameters
    ----------
    source, fps, names, roles, parents, up, unit, lenient
        As in :func:`detect`.
    method : str
        Segmentation method, as listed by :func:`segment_methods`.
    dims : int, optional
        Number of dimensions excluded from the residual (``mvu``, ``pca-tail``).
    residual : str
        ``"absolute"`` or ``"ratio"`` (``mvu``).
    template : str
        Template pose of ``lsd``: ``"mean"``, ``"tpose"`` or a frame number.
    published : bool
        If true, the method follows its publication exactly.

    Returns
    -------
    Segmentation
        The segments.

    Raises
    ------
    PlantigradeError
        If the clip has no motion, too few joints are known, or an argument is invalid.

    Examples
    --------
    >>> segmentation = plantigrade.segment("walk.bvh")
    >>> [(segment.start, segment.end) for segment in segmentation.segments]
    [(0, 245)]
    """
    clip = as_clip(
        source,
        fps=fps,
        names=names,
        roles=roles,
        parents=parents,
        up=up,
        unit=unit,
        lenient=lenient,
    )
    params = (str(method), dims, str(residual), str(template), bool(published))
    return Segmentation(clip, params)
