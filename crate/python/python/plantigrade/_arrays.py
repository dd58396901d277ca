"""Checks of arrays: what they must be, and what to do if they are not."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._errors import PlantigradeError

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    LabelsLike = ArrayLike | Mapping[str, ArrayLike]

SHAPE = "Positions have the shape (frames, joints, 3)"


def positions_array(positions: ArrayLike) -> NDArray[np.float64]:
    """Return positions as a contiguous array of 64-bit floats, without a copy if they are one."""
    import numpy as np

    if isinstance(positions, np.ma.MaskedArray) and np.ma.is_masked(positions):
        raise PlantigradeError(
            "the positions have masked values",
            hint="Fill gaps before the detection, for example by interpolation over time",
        )
    try:
        array = np.asarray(positions)
    except ValueError as error:
        raise PlantigradeError(
            f"the positions are not an array: {error}", hint=f"{SHAPE}; each frame has all joints"
        ) from error
    if array.dtype == object:
        raise PlantigradeError(
            "the positions are objects, not numbers",
            hint=f"{SHAPE}; each frame has all joints. Convert them with numpy.asarray(x, dtype=float)",
        )
    if array.dtype.kind not in "iuf":
        raise PlantigradeError(
            f"the positions have the type {array.dtype}", hint="Pass real numbers, such as float64"
        )
    _check_shape(array.shape)
    return np.ascontiguousarray(array, dtype=np.float64)


def _check_shape(shape: tuple[int, ...]) -> None:
    found = f"the positions have the shape {shape}"
    if len(shape) == 2 and shape[1] % 3 == 0 and shape[1] > 3:
        count = shape[1] // 3
        hint = f"{SHAPE}: use positions.reshape({shape[0]}, {count}, 3)"
    elif len(shape) == 2:
        hint = f"{SHAPE}. For a single frame, use positions[numpy.newaxis]"
    elif len(shape) == 4:
        hint = f"{SHAPE}. Detect in each clip of a batch by itself"
    elif len(shape) != 3:
        hint = SHAPE
    elif shape[2] == 3:
        if 0 not in shape[:2]:
            return
        raise PlantigradeError(
            f"the positions have no {'frames' if shape[0] == 0 else 'joints'}: shape {shape}",
            hint=SHAPE,
        )
    elif shape[0] == 3:
        hint = f"{SHAPE}: use numpy.moveaxis(positions, 0, 2)"
    elif shape[2] == 2:
        hint = f"{SHAPE}. Two coordinates are not sufficient: lift the poses to three dimensions first"
    elif shape[2] == 4:
        hint = f"{SHAPE}. Remove the fourth column: positions[..., :3]"
    elif shape[1] == 3:
        hint = f"{SHAPE}: use numpy.moveaxis(positions, 1, 2)"
    else:
        hint = SHAPE
    raise PlantigradeError(found, hint=hint)


def label_lists(labels: LabelsLike, frames: int) -> list[tuple[str, list[int], list[int]]]:
    """Return labels of the parts as lists with 1, 0, or −1 for unknown."""
    from collections.abc import Mapping

    by_part = labels if isinstance(labels, Mapping) else {"contact": labels}
    if not by_part:
        raise PlantigradeError("there are no labels", hint="Pass labels of contact, heel or toe")
    lists = []
    for part, values in by_part.items():
        left, right = _known(part, values, frames)
        lists.append((part, left, right))
    return lists


def _known(part: str, values: Any, frames: int) -> tuple[list[int], list[int]]:  # noqa: ANN401
    import numpy as np

    hint = "Labels have the shape (frames, 2): left foot, right foot"
    array = np.asarray(values)
    if array.shape != (frames, 2):
        if array.shape == (2, frames):
            hint += "; transpose them with labels.T"
        raise PlantigradeError(
            f"the labels of {part} have the shape {array.shape}, but the clip has {frames} frames",
            hint=hint,
        )
    if array.dtype.kind not in "biuf":
        raise PlantigradeError(
            f"the labels of {part} have the type {array.dtype}",
            hint="Pass booleans, or 1, 0 and -1 for unknown",
        )
    if array.dtype.kind == "f":
        array = np.where(np.isnan(array), -1, array)
    if array.dtype.kind != "b" and not np.isin(array, (-1, 0, 1)).all():
        raise PlantigradeError(
            f"the labels of {part} have other values than 0 and 1",
            hint="Pass booleans, or 1, 0 and -1 for unknown",
        )
    left, right = array.astype(np.int8).T
    return left.tolist(), right.tolist()
