"""Clean-up of foot skate, gait measures and scores."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ._clip import cleaned_clip
from ._detect import Detection, detect, labels_of
from ._errors import PlantigradeError
from ._segment import Segmentation

if TYPE_CHECKING:
    from collections.abc import Iterable

    import pandas as pd

    from ._arrays import LabelsLike
    from ._clip import Clip, Path, Source

    Labels = Detection | LabelsLike | Path | bytes


def clean(
    source: Source,
    labels: Labels | None = None,
    *,
    keep_spikes: bool = False,
    only: Iterable[tuple[str, int, int]] = (),
    **options: Any,  # noqa: ANN401
) -> Clip:
    """Return a clip without foot skate.

    Heel and toe of each plant are constrained to a fixed position, and the hips move where a leg would not
    reach. Bone lengths do not change.

    Parameters
    ----------
    source : Clip or path
        A clip with rotations: one that was read from a BVH file.
    labels : Detection, array, dict of arrays, path or bytes, optional
        Labels to use: a detection, booleans of the shape (frames, 2), such arrays by part, or a file of
        plants. Detected by default.
    keep_spikes : bool
        If true, spikes of the hips, short jumps away and back, are not interpolated.
    only : iterable of (side, start, end)
        If not empty, only plants that overlap one of these frame ranges are corrected.
    **options
        Options of :func:`detect`.

    Returns
    -------
    Clip
        The corrected clip. Its :attr:`Clip.cleaned` has the slide of each plant before and after.

    Raises
    ------
    PlantigradeError
        If the clip has no rotations, no motion or no feet, or the labels are those of another clip.

    Examples
    --------
    >>> cleaned = plantigrade.clean("walk.bvh")
    >>> cleaned.write("clean.bvh")
    """
    detection = source if isinstance(source, Detection) else detect(source, **options)
    clip = detection.clip
    ranges = [(str(side), int(start), int(end)) for side, start, end in only]
    lists = labels_of(detection if labels is None else labels, detection)
    return cleaned_clip(clip, lists, bool(keep_spikes), ranges)


class Gait(dict[str, "float | None"]):
    """Gait measures by name: the result of :func:`gait`.

    Names state the unit, such as ``cadence_steps_per_min`` and ``left_stance_s``. The name of a mean with
    the suffix ``_sd`` is that of its standard deviation, with ``_count`` that of the number of values.
    Measures that the clip does not allow are None.
    """

    def to_pandas(self) -> pd.DataFrame:
        """Return a data frame with one row and a column per measure; requires pandas."""
        import pandas as pd

        return pd.DataFrame([dict(self)]).astype(float)


def gait(source: Source | Detection, **options: Any) -> Gait:  # noqa: ANN401
    """Measure gait: cadence, stance and swing, step length and width, symmetry.

    Parameters
    ----------
    source : Detection, Clip, path or array
        A detection, or what :func:`detect` accepts.
    **options
        Options of :func:`detect`.

    Returns
    -------
    Gait
        Measures by name, with :meth:`Gait.to_pandas`.

    Examples
    --------
    >>> measures = plantigrade.gait("walk.bvh")
    >>> round(measures["cadence_steps_per_min"])
    114
    """
    detection = source if isinstance(source, Detection) else detect(source, **options)
    return Gait(detection._raw.gait())


def score(
    source: Source | Detection | Segmentation,
    truth: Labels,
    **options: Any,  # noqa: ANN401
) -> dict[str, Any]:
    """Compare labels with a reference.

    Parameters
    ----------
    source : Detection, Segmentation, Clip, path or array
        A detection or segmentation, or what :func:`detect` accepts.
    truth : Detection, array, dict of arrays, path or bytes
        Reference of a detection: labels of the shape (frames, 2), with −1 or NaN for unknown, such arrays
        by part, or a file of plants. Reference of a segmentation: a file of segments.
    **options
        Options of :func:`detect`.

    Returns
    -------
    dict
        Of a detection: for each part that both have, ``rows`` with accuracies by fuzzy period, ``events``
        with precision, recall and errors of the edges, and ``disagreements``. Of a segmentation: ``cuts``
        with precision, recall and F1 by tolerance, and ``classes``, if the reference has them.

    Examples
    --------
    >>> scores = plantigrade.score("walk.bvh", "walk.json")
    >>> round(scores["contact"]["rows"][3]["lenient"], 2)
    1.0
    """
    if isinstance(source, Segmentation):
        return _segment_scores(source, truth)
    import json

    detection = source if isinstance(source, Detection) else detect(source, **options)
    scores = json.loads(detection._raw.score(labels_of(truth, detection)))
    return {score.pop("part"): score for score in scores}


def _segment_scores(segmentation: Segmentation, truth: Labels) -> dict[str, Any]:
    name = segmentation.clip.name
    if isinstance(truth, (str, os.PathLike)):
        with open(truth, "rb") as file:
            truth = file.read()
    if not isinstance(truth, bytes):
        raise PlantigradeError(
            "the reference of segments is not a file", hint="Pass a path or the bytes of a file"
        )
    cuts, classes = segmentation._raw.score(truth.decode("utf-8-sig"), name)
    scores: dict[str, Any] = {
        "cuts": [
            {"tolerance": tolerance, "precision": precision, "recall": recall, "f1": f1}
            for tolerance, precision, recall, f1 in cuts
        ]
    }
    if classes is not None:
        scores["classes"] = {"accuracy": classes[0], "adjusted_rand": classes[1]}
    return scores
