"""Clips of motion capture."""

from __future__ import annotations

import os
from typing import IO, TYPE_CHECKING, NamedTuple

from . import _plantigrade
from ._errors import PlantigradeError
from ._notice import Notice
from .presets import Preset

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from typing import Any, TypeAlias

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Joint = int | str
    Roles = Mapping[str, Joint | None]
    Path = str | os.PathLike[str]
    Names = Sequence[str] | Preset
    #: How a clip was made: a function and its arguments, for pickle.
    Recipe = tuple[Callable[..., "Clip"], tuple[Any, ...]]
    Source: TypeAlias = "Clip | Path | ArrayLike"


class Skeleton(NamedTuple):
    """Roles of joints, up axis and scale of a clip.

    Attributes
    ----------
    roles : dict of str to int
        Joint of each role that was found, such as ``{"left_ankle": 4}``.
    confidence : dict of str to float
        Probability that the joint of a role is right, from 0 to 1.
    reasons : dict of str to tuple of str
        Evidence for the joint of a role, such as ``("name", "connected bones")``.
    up : str
        Up axis: ``"x"``, ``"y"``, ``"z"``, ``"-x"``, ``"-y"`` or ``"-z"``.
    unit : float
        Metres per unit of the positions.
    unit_name : str or None
        Name of the unit, such as ``"cm"``, if it is a known one.
    leg : float or None
        Leg length, thigh plus shank, in metres; None without legs.
    """

    roles: dict[str, int]
    confidence: dict[str, float]
    reasons: dict[str, tuple[str, ...]]
    up: str
    unit: float
    unit_name: str | None
    leg: float | None


class CleanedPlant(NamedTuple):
    """Result of the clean-up for one plant.

    Attributes
    ----------
    side : str
        ``"left"`` or ``"right"``.
    start, end : int
        First frame, and first frame after the plant.
    before, after : float
        Slide before and after the clean-up, in metres.
    skip_reason : str or None
        Why the plant was not corrected; None if it was.
    """

    side: str
    start: int
    end: int
    before: float
    after: float
    skip_reason: str | None


class Clip:
    """A clip of motion capture: a BVH file, or positions of joints.

    Use :meth:`read` or :meth:`from_positions` to create one. Clips do not change; methods return new
    ones.

    Examples
    --------
    >>> clip = plantigrade.Clip.read("walk.bvh")
    >>> clip.positions.shape
    (245, 26, 3)
    >>> round(clip.fps), clip.skeleton.up, clip.skeleton.unit_name
    (120, 'y', 'in')
    """

    __slots__ = ("_raw", "_recipe")

    def __init__(self, raw: _plantigrade.RawClip, recipe: Recipe) -> None:
        self._raw = raw
        self._recipe = recipe

    @classmethod
    def read(
        cls,
        source: Path | bytes | bytearray | memoryview | IO[bytes],
        *,
        lenient: bool = False,
        fps: float | None = None,
        roles: Roles | None = None,
        up: str | None = None,
        unit: float | None = None,
    ) -> Clip:
        """Read a BVH file.

        Parameters
        ----------
        source : path, bytes or binary file
            Path of the file, its bytes, or an open file.
        lenient : bool
            If true, values that are not numbers are replaced by those of the previous frame.
        fps : float, optional
            Frame rate in Hz, from 1 to 1000, instead of that of the file.
        roles : dict, optional
            Joints of roles, by name or index, instead of those that were found; None for no joint.
        up : str, optional
            Up axis, such as ``"y"`` or ``"-z"``, instead of the one that was found.
        unit : float, optional
            Metres per unit of the file, instead of the unit that was found.

        Raises
        ------
        PlantigradeError
            If the file cannot be read as BVH. The exception has line, column and a hint.
        OSError
            If the file cannot be opened.
        """
        name = ""
        if isinstance(source, (str, os.PathLike)):
            name = os.path.basename(source)
            with open(source, "rb") as file:
                data = file.read()
        elif isinstance(source, (bytes, bytearray, memoryview)):
            data = bytes(source)
        elif hasattr(source, "read"):
            content = source.read()
            if not isinstance(content, (bytes, bytearray, memoryview)):
                raise PlantigradeError("the file is open as text", hint='Open it with mode "rb"')
            data = bytes(content)
            name = os.path.basename(str(getattr(source, "name", "")))
        else:
            raise PlantigradeError(
                f"{type(source).__name__} is not a clip",
                hint="Pass a path, the bytes of a BVH file, or a file that is open in binary mode",
            )
        clip = _read(data, name, bool(lenient))
        return clip.override(fps=fps, roles=roles, up=up, unit=unit)

    @classmethod
    def from_positions(
        cls,
        positions: ArrayLike,
        *,
        fps: float | None,
        names: Names | None = None,
        roles: Roles | None = None,
        parents: ArrayLike | None = None,
        up: str | None = None,
        unit: float | None = None,
    ) -> Clip:
        """Create a clip of joint positions or markers of any source.

        Parameters
        ----------
        positions : array, shape (frames, joints, 3)
            Coordinates in any unit and axes. Integers and 32-bit floats are converted.
        fps : float
            Frame rate in Hz, from 1 to 1000.
        names : sequence of str or Preset, optional
            Name of each joint, by which the feet are found, or a preset of ``plantigrade.presets``.
        roles : dict, optional
            Joints of roles, by index or name, such as ``{"left_ankle": 7, "right_ankle": 8}``.
            Without names, other roles have no joint.
        parents : sequence of int, optional
            Parent of each joint, −1 for a root. Not required.
        up : str, optional
            Up axis; found from the motion by default.
        unit : float, optional
            Metres per unit; found from the length of the legs by default.

        Raises
        ------
        PlantigradeError
            If the array has another shape, values that are not finite, or no frames; if the frame rate
            is missing; if names, roles or parents do not belong to the joints.
        """
        from ._arrays import positions_array

        array = positions_array(positions)
        count = array.shape[1]
        if fps is None:
            raise PlantigradeError(
                "the frame rate of the positions is unknown", hint="Pass fps, frames per second"
            )
        fps = _rate(fps)
        given = None if parents is None else _parent_list(parents)
        if isinstance(names, Preset):
            preset = names
            names = preset.names
            given = list(preset.parents) if given is None and preset.parents else given
            roles = {**preset.roles, **(roles or {})}
            up = preset.up if up is None else up
            unit = preset.unit if unit is None else unit
        if names is None and roles is None and given is None:
            raise PlantigradeError(
                "which joint is which is unknown",
                hint="Pass names of the joints, roles={'left_ankle': …, 'right_ankle': …}, or "
                "names=plantigrade.presets.… for a common order of joints",
            )
        name_list = [str(index) for index in range(count)] if names is None else _name_list(names)
        if len(name_list) != count:
            raise PlantigradeError(
                f"there are {len(name_list)} names for {count} joints",
                hint="Pass one name for each joint on the second axis of the positions",
            )
        pairs = _role_indices(roles, name_list, has_names=names is not None)
        if names is None and roles is not None:
            listed = {role for role, _ in pairs}
            pairs += [(role, None) for role in _plantigrade.role_names() if role not in listed]
        metres = None if unit is None else float(unit)
        return _from_points(array, name_list, given or [], fps, pairs, up, metres)

    def override(
        self,
        *,
        fps: float | None = None,
        roles: Roles | None = None,
        up: str | None = None,
        unit: float | None = None,
    ) -> Clip:
        """Return the clip with another frame rate, roles, up axis or unit.

        Parameters are those of :meth:`read`; absent ones stay as they are.
        """
        if fps is None and roles is None and up is None and unit is None:
            return self
        rate = None if fps is None else _rate(fps)
        pairs = _role_indices(roles, self.names, has_names=True)
        return _overridden(self, rate, pairs, up, None if unit is None else float(unit))

    @property
    def positions(self) -> NDArray[np.float64]:
        """Positions of all joints in each frame, in the units and axes of the file.

        The shape is (frames, joints, 3); a clip without motion has one row, its rest pose. Multiply by
        :attr:`unit` for metres.
        """
        return self._raw.positions()

    @property
    def names(self) -> tuple[str, ...]:
        """Name of each joint. End sites are called ``"End Site"``."""
        return tuple(self._raw.names())

    @property
    def parents(self) -> tuple[int, ...]:
        """Index of the parent of each joint; −1 for a root."""
        return tuple(self._raw.parents())

    @property
    def end_sites(self) -> tuple[int, ...]:
        """Indices of the joints that are tips of bones, without channels."""
        return tuple(self._raw.end_sites())

    @property
    def fps(self) -> float:
        """Frame rate, in Hz."""
        return self._raw.fps()

    @property
    def up(self) -> str:
        """Up axis, such as ``"y"``."""
        return self._raw.scale()[0]

    @property
    def unit(self) -> float:
        """Metres per unit of the positions."""
        return self._raw.scale()[1]

    @property
    def name(self) -> str:
        """Name of the file without folders; empty if unknown."""
        return self._raw.name()

    @property
    def skeleton(self) -> Skeleton:
        """Roles of joints with their confidence, up axis, unit and leg length."""
        up, unit, unit_name, leg = self._raw.scale()
        roles = self._raw.roles()
        return Skeleton(
            roles={role: joint for role, joint, _, _ in roles},
            confidence={role: confidence for role, _, confidence, _ in roles},
            reasons={role: tuple(reasons) for role, _, _, reasons in roles},
            up=up,
            unit=unit,
            unit_name=unit_name,
            leg=None if leg is None else leg * unit,
        )

    @property
    def notices(self) -> tuple[Notice, ...]:
        """What was assumed, repaired or left out in reading the clip."""
        return tuple(Notice(*notice) for notice in self._raw.notices())

    @property
    def cleaned(self) -> tuple[CleanedPlant, ...]:
        """Result for each plant, if the clip is one of :func:`plantigrade.clean`; empty otherwise."""
        return tuple(CleanedPlant(*plant) for plant in self._raw.cleaned())

    def to_bytes(self) -> bytes:
        """Return the clip as the bytes of a BVH file.

        A clip that was read retains the text of its file, except for numbers that changed. Positions are
        written as joints with position channels and without rotations.
        """
        return self._raw.to_bytes()

    def write(self, path: Path) -> None:
        """Write the clip as a BVH file; see :meth:`to_bytes`."""
        with open(path, "wb") as file:
            file.write(self.to_bytes())

    def __len__(self) -> int:
        """Return the number of frames; 0 if the clip is a rest pose."""
        return self._raw.frames()

    def __reduce__(self) -> tuple[Callable[..., Clip], tuple[Any, ...]]:
        function, arguments = self._recipe
        # Positions are not part of the recipe, so that they are in memory once.
        return function, (self.positions, *arguments) if function is _from_points else arguments

    def __repr__(self) -> str:
        name = f"{self.name!r}, " if self.name else ""
        return f"Clip({name}{len(self)} frames, {len(self._raw.names())} joints, {self.fps:g} Hz)"


def _read(data: bytes, name: str, lenient: bool) -> Clip:
    return Clip(_plantigrade.RawClip.read(data, name, lenient), (_read, (data, name, lenient)))


def _from_points(
    positions: NDArray[np.float64],
    names: list[str],
    parents: list[int],
    fps: float,
    roles: list[tuple[str, int | None]],
    up: str | None,
    unit: float | None,
) -> Clip:
    raw = _plantigrade.RawClip.from_points(positions, names, parents, fps, roles, up, unit)
    return Clip(raw, (_from_points, (names, parents, fps, roles, up, unit)))


def _overridden(
    clip: Clip,
    fps: float | None,
    roles: list[tuple[str, int | None]],
    up: str | None,
    unit: float | None,
) -> Clip:
    raw = clip._raw.overridden(fps, roles, up, unit)
    return Clip(raw, (_overridden, (clip, fps, roles, up, unit)))


def file_clip(clip: Clip, settings: Mapping[str, Any]) -> Clip:
    """Return a clip read from its file, with the settings of the app instead of its overrides.

    Joints of settings are those of the file, −1 for none; a clip of positions remains one.
    """
    joints = [
        (str(role), None if joint < 0 else int(joint)) for role, joint in settings.get("joints", {}).items()
    ]
    rate = settings.get("rate") or Clip.read(clip.to_bytes(), lenient=True).fps
    unit = settings.get("unit")
    return _with_overrides(
        clip, float(rate), joints, settings.get("up"), None if unit is None else float(unit)
    )


def _with_overrides(
    clip: Clip,
    fps: float,
    joints: list[tuple[str, int | None]],
    up: str | None,
    unit: float | None,
) -> Clip:
    raw = clip._raw.with_overrides(fps, joints, up, unit)
    return Clip(raw, (_with_overrides, (clip, fps, joints, up, unit)))


def cleaned_clip(
    clip: Clip,
    labels: list[tuple[str, list[int], list[int]]],
    keep_spikes: bool,
    only: list[tuple[str, int, int]],
) -> Clip:
    """Return a clip without foot skate; see :func:`plantigrade.clean`."""
    raw = clip._raw.clean(labels, keep_spikes, only)
    return Clip(raw, (cleaned_clip, (clip, labels, keep_spikes, only)))


def as_clip(
    source: Source,
    *,
    fps: float | None = None,
    names: Names | None = None,
    roles: Roles | None = None,
    parents: ArrayLike | None = None,
    up: str | None = None,
    unit: float | None = None,
    lenient: bool = False,
) -> Clip:
    """Return a clip, a BVH file or positions as a clip."""
    is_file = isinstance(source, (str, os.PathLike, bytes, bytearray)) or hasattr(source, "read")
    if not isinstance(source, Clip) and not is_file:
        return Clip.from_positions(
            source,  # type: ignore[arg-type]
            fps=fps,
            names=names,
            roles=roles,
            parents=parents,
            up=up,
            unit=unit,
        )
    if names is not None or parents is not None:
        raise PlantigradeError(
            "a clip has names and parents already", hint="Pass roles to choose other joints"
        )
    if isinstance(source, Clip):
        return source.override(fps=fps, roles=roles, up=up, unit=unit)
    return Clip.read(source, lenient=lenient, fps=fps, roles=roles, up=up, unit=unit)  # type: ignore[arg-type]


def _rate(fps: float) -> float:
    try:
        rate = float(fps)
    except (TypeError, ValueError):
        raise PlantigradeError(
            f"fps is {fps!r}, which is not a number", hint="Pass frames per second, such as fps=30"
        ) from None
    if 0.001 <= rate < 1:
        raise PlantigradeError(
            f"fps must be from 1 to 1000, not {rate:g}",
            hint=f"{rate:g} looks like the time between frames: did you mean fps={round(1 / rate, 2):g}?",
        )
    return rate


def _name_list(names: Sequence[str]) -> list[str]:
    if isinstance(names, str):
        raise PlantigradeError("names is a single text", hint="Pass a list with one name per joint")
    return [str(name) for name in names]


def _parent_list(parents: ArrayLike) -> list[int]:
    import numpy as np

    array = np.asarray([-1 if parent is None else parent for parent in parents])  # type: ignore[union-attr]
    if array.ndim != 1 or array.dtype.kind not in "iu":
        raise PlantigradeError(
            "parents must be a list of indices", hint="Pass the parent of each joint, -1 for a root"
        )
    return [int(parent) for parent in array]


def _role_indices(
    roles: Roles | None, names: Sequence[str], *, has_names: bool
) -> list[tuple[str, int | None]]:
    """Return roles with joint indices."""
    pairs: list[tuple[str, int | None]] = []
    known = _plantigrade.role_names()
    for role, joint in (roles or {}).items():
        if role not in known:
            raise PlantigradeError(f"unknown role {role!r}", hint=f"Use one of {', '.join(known)}")
        if joint is None:
            pairs.append((role, None))
        elif isinstance(joint, str):
            pairs.append((role, _joint_index(role, joint, names, has_names=has_names)))
        else:
            index = int(joint)
            if not 0 <= index < len(names):
                raise PlantigradeError(
                    f"the role {role} has joint {index}, but there are {len(names)} joints",
                    hint="Joints are indices on the second axis of the positions, from 0",
                )
            pairs.append((role, index))
    joints = dict(pairs)
    if joints.get("left_ankle") is not None and joints["left_ankle"] == joints.get("right_ankle"):
        raise PlantigradeError(
            f"both ankles have joint {joints['left_ankle']}",
            hint="Pass different joints for both feet",
        )
    return pairs


def _joint_index(role: str, joint: str, names: Sequence[str], *, has_names: bool) -> int:
    if not has_names:
        raise PlantigradeError(
            f"the role {role} has the joint {joint!r}, but the joints have no names",
            hint="Pass names, or the index of the joint",
        )
    found = [index for index, name in enumerate(names) if name == joint]
    if len(found) == 1:
        return found[0]
    if not found:
        raise PlantigradeError(f"no joint is called {joint!r}", hint=f"The joints are {', '.join(names)}")
    raise PlantigradeError(
        f"several joints are called {joint!r}",
        hint=f"Pass one of the indices {', '.join(map(str, found))}",
    )
