"""Detection of foot plants."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from . import _plantigrade
from ._clip import Clip, as_clip
from ._errors import PlantigradeError
from ._files import format_of, write
from ._notice import Notice

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence
    from typing import TypeAlias

    import numpy as np
    import pandas as pd
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray

    from ._arrays import LabelsLike
    from ._clip import Names, Path, Roles, Source
    from ._constraints import Constraints
    from ._viewer import Viewer

    Params = tuple[str, float, int, float | None, float, float, bool]
    EditTuple = tuple[str, str, int, int, bool]
    Part = Literal["contact", "heel", "toe"]
    Side = Literal["left", "right"]
    ConstraintsLike: TypeAlias = "Detection | LabelsLike | Mapping[str, Any] | Sequence[Edit] | Path | bytes"


class Interval(NamedTuple):
    """A plant: an interval of contact of one foot or part.

    Attributes
    ----------
    side : str
        ``"left"`` or ``"right"``.
    part : str
        ``"contact"``, ``"heel"`` or ``"toe"``.
    start, end : int
        First frame, and first frame after the plant.
    start_time, end_time : float
        Instants at which the plant begins and ends, in seconds from the first frame: those of foot strike
        and foot off if they are known, and otherwise those of ``start`` and ``end``.
    start_uncertainty, end_uncertainty : float or None
        Standard deviations of the instants, in seconds; None if they are known to the frame only.
    """

    side: str
    part: str
    start: int
    end: int
    start_time: float
    end_time: float
    start_uncertainty: float | None
    end_uncertainty: float | None


class Event(NamedTuple):
    """A foot strike, foot off, or event of heel or toe.

    Attributes
    ----------
    time : float
        Seconds from the first frame.
    frame : int
        First frame after the event.
    side : str
        ``"left"`` or ``"right"``.
    kind : str
        ``"strike"`` or ``"off"``; ``"heel_strike"``, ``"toe_strike"``, ``"foot_flat"``, ``"heel_off"`` or
        ``"toe_off"`` of the parts.
    title : str
        Name of the event in gait analysis, such as ``"Foot Strike"``.
    uncertainty : float or None
        Standard deviation of the time, in seconds; None if the event is known to the frame only.
    """

    time: float
    frame: int
    side: str
    kind: str
    title: str
    uncertainty: float | None


class Edit(NamedTuple):
    """A frame range in which a person states whether a part of a foot is planted.

    Attributes
    ----------
    side : str
        ``"left"`` or ``"right"``.
    part : str
        ``"contact"``, ``"heel"`` or ``"toe"``.
    start, end : int
        First frame, and first frame after the range.
    planted : bool
        True if the part is planted.
    """

    side: str
    part: str
    start: int
    end: int
    planted: bool


class Ground(NamedTuple):
    """Ground on which the feet stand, in metres and the axes of the clip.

    Attributes
    ----------
    height : float
        Height of the ground along the up axis.
    normal : tuple of float
        Unit normal of the plane.
    origin : tuple of float
        Point of the plane.
    levels : tuple of float
        Heights of levels above the plane; stairs have several.
    belt : tuple of float or None
        Velocity of a treadmill belt, per second.
    """

    height: float
    normal: tuple[float, ...]
    origin: tuple[float, ...]
    levels: tuple[float, ...]
    belt: tuple[float, ...] | None


class Noise(NamedTuple):
    """Noise of planted feet.

    Attributes
    ----------
    position : float
        Standard deviation of each coordinate of planted toes, in metres.
    speed : float
        Median speed of planted feet, in metres per second.
    """

    position: float
    speed: float


class Slide(NamedTuple):
    """Slide of one plant.

    Attributes
    ----------
    side : str
        ``"left"`` or ``"right"``.
    start, end : int
        First frame, and first frame after the plant.
    distance : float
        Largest horizontal distance of the planted part from its mean position, in metres.
    frame : int
        Frame of that distance.
    """

    side: str
    start: int
    end: int
    distance: float
    frame: int


class Detection:
    """Labels of a clip: the result of :func:`detect`.

    The first column of each array is the left foot, the second one the right foot. Arrays are new in each
    call and may be changed.
    """

    __slots__ = ("_clip", "_constraints", "_corrected", "_detected", "_edits", "_params", "_raw", "_still")

    def __init__(
        self,
        clip: Clip,
        params: Params,
        still: Clip | None,
        edits: tuple[EditTuple, ...] = (),
        constraints: Constraints | None = None,
        *,
        earlier: Detection | None = None,
    ) -> None:
        """Detect the plants, unless an earlier detection with other edits has done so."""
        self._clip = clip
        self._params = params
        self._still = still
        self._edits = edits
        self._constraints = constraints
        #: Labels with corrections, their changes of similar motion, and the edits of this clip.
        self._corrected: tuple[_plantigrade.RawDetection, list[EditTuple], list[EditTuple]] | None = None
        self._detected: _plantigrade.RawDetection
        if earlier is not None:
            self._detected, self._corrected = earlier._detected, earlier._corrected
        else:
            self._detected = clip._raw.detect(params, None if still is None else still._raw)
            if constraints is not None:
                from ._constraints import corrected

                self._corrected = corrected(self._detected, clip, params, constraints)
        base, _, own = self._corrected or (self._detected, [], [])
        self._raw = base.edited([*own, *edits]) if edits else base

    @property
    def clip(self) -> Clip:
        """The clip that was labelled."""
        return self._clip

    @property
    def contact(self) -> NDArray[np.bool_]:
        """True while any part of the foot bears on the ground, shape (frames, 2).

        Raises PlantigradeError if the method labels the toe only.
        """
        return self._raw.planted("contact")

    @property
    def heel(self) -> NDArray[np.bool_]:
        """True while the heel is on the ground and still, shape (frames, 2)."""
        return self._raw.planted("heel")

    @property
    def toe(self) -> NDArray[np.bool_]:
        """True while the toe is on the ground and still, shape (frames, 2)."""
        return self._raw.planted("toe")

    @property
    def confidence(self) -> NDArray[np.float32]:
        """Probability that each label of the first of :attr:`parts` is right, 0.5 to 1, shape (frames, 2)."""
        return self._raw.confidence(self._raw.parts()[0])

    @property
    def parts(self) -> tuple[str, ...]:
        """Parts that the method labels; the first one defines the plants."""
        return tuple(self._raw.parts())

    def planted(self, part: Part) -> NDArray[np.bool_]:
        """Return the labels of a part, shape (frames, 2)."""
        return self._raw.planted(part)

    def confidence_of(self, part: Part) -> NDArray[np.float32]:
        """Return the probability that each label of a part is right, 0.5 to 1, shape (frames, 2)."""
        return self._raw.confidence(part)

    def height(self, part: Part = "toe") -> NDArray[np.float32]:
        """Return the height of a part above the ground, in metres, shape (frames, 2)."""
        return self._raw.height(part)

    def speed(self, part: Part = "toe") -> NDArray[np.float32]:
        """Return the speed of a part, in metres per second, shape (frames, 2)."""
        return self._raw.speed(part)

    @property
    def intervals(self) -> tuple[Interval, ...]:
        """Plants of all parts: those of contact first, the left foot first, in order of time."""
        fps = self._raw.fps()

        def interval(
            side: str,
            part: str,
            start: int,
            end: int,
            strike: list[float] | None,
            off: list[float] | None,
        ) -> Interval:
            start_time, start_uncertainty = strike or (start / fps, None)
            end_time, end_uncertainty = off or (end / fps, None)
            return Interval(side, part, start, end, start_time, end_time, start_uncertainty, end_uncertainty)

        return tuple(interval(*plant) for plant in self._raw.intervals())

    @property
    def events(self) -> tuple[Event, ...]:
        """Foot strikes and foot offs in order of time.

        Contact that begins or ends with the clip is not an event.
        """
        return tuple(Event(*event) for event in self._raw.events(False))

    @property
    def part_events(self) -> tuple[Event, ...]:
        """Foot strikes, foot offs, and events of heel and toe, in order of time."""
        return tuple(Event(*event) for event in self._raw.events(True))

    @property
    def method(self) -> str:
        """Name of the method."""
        return self._raw.method()

    @property
    def fps(self) -> float:
        """Frame rate of the clip, in Hz."""
        return self._raw.fps()

    @property
    def ground(self) -> Ground:
        """Ground on which the feet stand."""
        height, normal, origin, levels, belt = self._raw.ground()
        return Ground(
            height,
            tuple(normal),
            tuple(origin),
            tuple(levels),
            None if belt is None else tuple(belt),
        )

    @property
    def noise(self) -> Noise | None:
        """Noise of planted feet; None if no foot is planted."""
        noise = self._raw.noise()
        return None if noise is None else Noise(*noise)

    @property
    def notices(self) -> tuple[Notice, ...]:
        """What was assumed, repaired or left out, by reader and method."""
        return tuple(Notice(*notice) for notice in self._raw.notices())

    @property
    def edits(self) -> tuple[Edit, ...]:
        """Edits that were applied, the newest last."""
        own = self._corrected[2] if self._corrected else []
        return tuple(Edit(*edit) for edit in (*own, *self._edits))

    def edit(self, edits: Iterable[Edit | tuple[str, str, int, int, bool]]) -> Detection:
        """Return the detection with corrected labels.

        Parameters
        ----------
        edits : iterable of Edit
            Frame ranges with their label; later ones take precedence, also over those of earlier calls.
        """
        all_edits = (*self._edits, *edit_tuples(edits))
        return Detection(self._clip, self._params, self._still, all_edits, self._constraints, earlier=self)

    def slides(self) -> tuple[Slide, ...]:
        """Return the slide of each plant: those of the left foot, then those of the right."""
        return tuple(Slide(*slide) for slide in self._raw.slides())

    def to_bytes(self, format: str = "json") -> bytes:
        """Return the labels as the bytes of a file.

        Parameters
        ----------
        format : str
            ``"json"``, ``"csv"``, ``"intervals"``, ``"events"``, ``"part-events"``, ``"npz"``,
            ``"blender"``, ``"unreal"`` or ``"unity"``, as in ``plantigrade detect --format``.
        """
        return self._raw.to_bytes(format)

    def to_dict(self) -> dict[str, Any]:
        """Return the labels as the document that :meth:`save` writes as JSON."""
        import json

        document: dict[str, Any] = json.loads(self._raw.to_bytes("json"))
        return document

    def to_pandas(
        self, table: Literal["frames", "intervals", "events", "part-events"] = "frames"
    ) -> pd.DataFrame:
        """Return a table as a data frame; requires pandas.

        Parameters
        ----------
        table : str
            ``"frames"``: a row per frame with ``time`` and a boolean column per foot and part.
            ``"intervals"``: a row per plant. ``"events"``: a row per foot strike and foot off.
            ``"part-events"``: these, and the events of heel and toe. The columns are those of the files
            of the same name.
        """
        import io

        import pandas as pd

        format = "csv" if table == "frames" else table
        if format not in ("csv", "intervals", "events", "part-events"):
            raise PlantigradeError(
                f"unknown table {table!r}", hint="Use frames, intervals, events or part-events"
            )
        frame = pd.read_csv(io.BytesIO(self._raw.to_bytes(format)))
        if table == "frames":
            frame = frame.set_index("frame")
            labels = [name for name in frame.columns if name != "time"]
            frame = frame.astype(dict.fromkeys(labels, bool))
        return frame

    def plot(self, axes: Axes | None = None) -> Axes:
        """Draw the plants over time; requires matplotlib.

        A row per foot and part; whiskers at foot strikes and foot offs show their standard deviation, dots
        mark frames whose confidence is below 0.75.

        Parameters
        ----------
        axes : matplotlib.axes.Axes, optional
            Axes to draw on. By default, a new figure is made.

        Returns
        -------
        matplotlib.axes.Axes
            The axes.
        """
        from ._plot import plot

        return plot(self, axes)

    def show(self, *, height: int = 560, static: bool = False) -> Viewer:
        """Show the clip with its labels in the viewer and timeline of the app, in a notebook.

        The viewer is the value of the cell. It works without a network connection. If anywidget is
        installed (``pip install plantigrade[notebook]``), edits that are made in the viewer are those of
        :attr:`Viewer.detection` in the next cell::

            viewer = detection.show()
            viewer

        Parameters
        ----------
        height : int
            Height in pixels.
        static : bool
            If true, the viewer is a part of the notebook, about 2.3 MB, which also works when the notebook
            is exported as HTML; its edits do not reach Python. Without anywidget, the viewer is static.

        Returns
        -------
        Viewer
            The viewer.
        """
        from ._viewer import show

        return show(self, height, static)

    def save_html(self, path: Path) -> None:
        """Write a page with the viewer, the clip and its labels.

        The page is a single file, which works without Python and without a network connection.

        Parameters
        ----------
        path : path
            File to write.
        """
        from ._page import page

        write(path, page(self).encode())

    def save(self, path: Path, format: str | None = None) -> None:
        """Write the labels as a file.

        Parameters
        ----------
        path : path
            File to write. Its ending determines the format: ``.plants.json`` or ``.json``,
            ``.frames.csv`` or ``.csv``, ``.intervals.csv``, ``.events.csv``, ``.part-events.csv``,
            ``.contacts.npz`` or ``.npz``, ``.blender.py`` or ``.py``, ``.unreal.py``, ``.unity.cs`` or
            ``.cs``.
        format : str, optional
            Format, if the ending does not determine it; see :meth:`to_bytes`.
        """
        name = format or format_of(path, _plantigrade.plant_formats())
        write(path, self._raw.to_bytes(name))

    def __reduce__(self) -> tuple[Any, ...]:
        return Detection, (self._clip, self._params, self._still, self._edits, self._constraints)

    def __repr__(self) -> str:
        plants = sum(interval.part == self.parts[0] for interval in self.intervals)
        return f"Detection({self._raw.frames()} frames, {plants} plants, method {self.method!r})"


def detect(
    source: Source,
    *,
    fps: float | None = None,
    names: Names | None = None,
    roles: Roles | None = None,
    parents: ArrayLike | None = None,
    up: str | None = None,
    unit: float | None = None,
    lenient: bool = False,
    still: Source | None = None,
    method: str = "robust",
    r: float = 0.001,
    w: int = 1,
    sigma: float | None = None,
    height: float = 0.05,
    speed: float = 0.5,
    exact: bool = False,
    constraints: ConstraintsLike | None = None,
    constraints_clip: Source | None = None,
) -> Detection:
    """Detect when each foot is planted.

    Parameters
    ----------
    source : Clip, path or array, shape (frames, joints, 3)
        A clip, the path of a BVH file, or positions of joints in any unit and axes.
    fps : float, optional
        Frame rate in Hz. Required for positions; otherwise overrides that of the clip.
    names, parents : optional
        Names of the joints of positions, or a preset, and their parents; see
        :meth:`Clip.from_positions`.
    roles : dict, optional
        Joints of roles, by name or index, such as ``{"left_ankle": 7, "right_ankle": 8}``.
    up : str, optional
        Up axis, such as ``"y"`` or ``"-z"``; found from the motion by default.
    unit : float, optional
        Metres per unit; found from the length of the legs by default. The labels of spectral methods do
        not depend on it.
    lenient : bool
        If true, values of a file that are not numbers are replaced by those of the previous frame.
    still : Clip, path or array, optional
        Clip of the same character standing still, clustered together with the motion (spectral toe
        methods).
    method : str
        Detection method, as listed by :func:`methods`.
    r : float
        Threshold on the running variance of the sorted norms; a larger value gives longer plants.
    w : int
        Half-width of the smoothing window, in frames.
    sigma : float, optional
        Kernel bandwidth; at the knee of the norms by default.
    height, speed : float
        Thresholds of the methods that have them, in metres and metres per second.
    exact : bool
        If true, all pairs of frames are compared in long clips too; slow, and labels rarely change.
    constraints : Detection, path, bytes, dict, sequence of Edit or array, optional
        Corrected labels, which are applied to similar motion as well: a detection with edits, a document
        with edits or labels as ``--constraints`` of the command line accepts them, edits, or labels of the
        shape (frames, 2) with −1 or NaN for frames that were not judged, or such arrays by part.
    constraints_clip : Clip, path or array, optional
        Clip of the same character that the corrected labels belong to; by default that of a detection, and
        otherwise the clip that is labelled.

    Returns
    -------
    Detection
        Labels of contact, heel and toe, with confidence and events.

    Raises
    ------
    PlantigradeError
        If the clip has no motion or no feet, or an argument is invalid.

    Examples
    --------
    >>> detection = plantigrade.detect("walk.bvh")
    >>> detection.contact[60]
    array([ True,  True])
    >>> detection.events[0].kind, detection.events[0].side
    ('strike', 'right')
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

    def other(source: Source | None) -> Clip | None:
        if source is None:
            return None
        is_clip = isinstance(source, (Clip, str, bytes, os.PathLike))
        return as_clip(
            source,
            fps=None if is_clip else clip.fps,
            names=None if is_clip else names,
            roles=roles,
            parents=None if is_clip else parents,
            up=up,
            unit=unit,
            lenient=lenient,
        )

    params = (
        str(method),
        float(r),
        _frame(w),
        None if sigma is None else float(sigma),
        float(height),
        float(speed),
        bool(exact),
    )
    corrections = None
    if constraints is not None:
        from ._constraints import constraints_of

        corrections = constraints_of(constraints, other(constraints_clip))
    elif constraints_clip is not None:
        raise PlantigradeError(
            "constraints_clip has no constraints", hint="Pass corrected labels as constraints"
        )
    return Detection(clip, params, other(still), (), corrections)


def edit_tuples(edits: Iterable[Edit | EditTuple]) -> list[EditTuple]:
    """Return edits with checked types."""
    return [
        (str(side), str(part), _frame(start), _frame(end), bool(planted))
        for side, part, start, end, planted in edits
    ]


def _frame(value: int) -> int:
    import operator

    number = operator.index(value)
    if number < 0:
        raise PlantigradeError(f"frames count from 0; {number} is negative")
    return number


def labels_of(labels: Detection | LabelsLike | Path | bytes, detection: Detection) -> Any:  # noqa: ANN401
    """Return labels of any source as lists with 1, 0, or −1 for unknown."""
    from ._arrays import label_lists

    if isinstance(labels, Detection):
        labels = {part: labels.planted(part) for part in labels.parts}  # type: ignore[arg-type]
    if isinstance(labels, (str, os.PathLike)):
        with open(labels, "rb") as file:
            labels = file.read()
    if isinstance(labels, bytes):
        return detection._raw.read_labels(labels)
    return label_lists(labels, len(detection.clip))
