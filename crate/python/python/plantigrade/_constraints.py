"""Corrected labels, which are applied to similar motion as well."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from . import _plantigrade
from ._errors import PlantigradeError

if TYPE_CHECKING:
    from ._clip import Clip
    from ._detect import EditTuple, Params

#: Parts that arrays of labels are named after.
PARTS = {"contact", "heel", "toe"}


class Constraints:
    """Corrections of a clip: edits, and the clip that they belong to; None for the clip that is labelled."""

    __slots__ = ("_detected", "_params", "clip", "labels")

    def __init__(self, labels: Any, clip: Clip | None) -> None:  # noqa: ANN401
        self.labels = labels
        self.clip = clip
        self._detected: _plantigrade.RawDetection | None = None
        self._params: Params | None = None

    def example(self, params: Params) -> _plantigrade.RawDetection | None:
        """Return the detection of the clip that the edits belong to; None for the clip that is labelled."""
        if self.clip is not None and (self._detected is None or self._params != params):
            self._detected, self._params = self.clip._raw.detect(params, None), params
        return self._detected

    def edits(self, detected: _plantigrade.RawDetection) -> list[EditTuple]:
        """Return the edits as those of the clip of a detection."""
        labels = self.labels
        if isinstance(labels, (str, os.PathLike)):
            with open(labels, "rb") as file:
                labels = file.read()
        if _is_document(labels):
            import json

            labels = json.dumps(labels).encode()
        if isinstance(labels, bytes):
            return detected.read_edits(labels)
        if _is_edits(labels):
            from ._detect import edit_tuples

            return edit_tuples(labels)
        from ._arrays import label_lists

        return detected.edits_of_labels(label_lists(labels, detected.frames()))

    def __reduce__(self) -> tuple[Any, ...]:
        return Constraints, (self.labels, self.clip)

    def __repr__(self) -> str:
        """Return a text that is the same for the same corrections."""
        import hashlib

        labels = self.labels
        if isinstance(labels, (str, os.PathLike)):
            with open(labels, "rb") as file:
                labels = file.read()
        content = labels if isinstance(labels, bytes) else repr(labels).encode()
        clip = b"" if self.clip is None else self.clip.to_bytes()
        return f"Constraints({hashlib.sha256(content + clip).hexdigest()})"


def constraints_of(labels: Any, clip: Clip | None) -> Constraints:  # noqa: ANN401
    """Return corrections of any source; `clip` is the clip that they belong to."""
    from ._detect import Detection

    if isinstance(labels, Constraints):
        return labels
    if isinstance(labels, Detection):
        if not labels.edits:
            raise PlantigradeError(
                "the detection of the constraints has no edits",
                hint="Correct its labels with detection.edit or in the viewer of detection.show",
            )
        return Constraints(labels.edits, labels.clip if clip is None else clip)
    return Constraints(labels, clip)


def corrected(
    detected: _plantigrade.RawDetection, clip: Clip, params: Params, constraints: Constraints
) -> tuple[_plantigrade.RawDetection, list[EditTuple], list[EditTuple]]:
    """Return a detection with corrections, its changes, and the edits of the clip itself."""
    example = None if constraints.clip is clip else constraints.example(params)
    return detected.corrected(example, constraints.edits(detected if example is None else example))


def _is_document(labels: Any) -> bool:  # noqa: ANN401
    return isinstance(labels, dict) and not set(labels) <= PARTS


def _is_edits(labels: Any) -> bool:  # noqa: ANN401
    return (
        isinstance(labels, (list, tuple))
        and len(labels) > 0
        and all(isinstance(edit, (list, tuple)) and len(edit) == 5 for edit in labels)
        and isinstance(labels[0][0], str)
    )
