"""Foot plants in motion capture, detected with nothing to tune.

>>> detection = plantigrade.detect("walk.bvh")
>>> detection.contact.shape
(245, 2)

Positions are in the unit and axes of their source, times in seconds; frames count from 0 and frame ranges
are half-open. The left foot comes before the right foot. Arrays are NumPy arrays; pandas and other packages
are imported by the functions that require them.
"""

from __future__ import annotations

from typing import NamedTuple

from . import _plantigrade, presets
from ._batch import BatchRecord, BatchResult, batch
from ._clip import CleanedPlant, Clip, Skeleton
from ._detect import Detection, Edit, Event, Ground, Interval, Noise, Slide, detect
from ._errors import PlantigradeError
from ._measure import Gait, clean, gait, score
from ._notice import Notice
from ._segment import Motif, Segment, Segmentation, segment
from ._viewer import Viewer

__version__ = _plantigrade.VERSION

__all__ = [
    "BatchRecord",
    "BatchResult",
    "CleanedPlant",
    "Clip",
    "Detection",
    "Edit",
    "Event",
    "Gait",
    "Ground",
    "Interval",
    "Method",
    "Motif",
    "Noise",
    "Notice",
    "PlantigradeError",
    "Segment",
    "Segmentation",
    "Skeleton",
    "Slide",
    "Viewer",
    "batch",
    "clean",
    "detect",
    "gait",
    "methods",
    "presets",
    "roles",
    "score",
    "segment",
    "segment_methods",
]


class Method(NamedTuple):
    """A method of detection or segmentation.

    Attributes
    ----------
    name : str
        Name for ``method``.
    title : str
        Display name.
    description : str
        Description in a sentence.
    """

    name: str
    title: str
    description: str


def methods() -> tuple[Method, ...]:
    """Return all detection methods, the default first.

    Examples
    --------
    >>> plantigrade.methods()[0].name
    'robust'
    """
    return tuple(Method(*method[:3]) for method in _plantigrade.detection_methods())


def segment_methods() -> tuple[Method, ...]:
    """Return all segmentation methods, the default first.

    Examples
    --------
    >>> plantigrade.segment_methods()[0].name
    'auto'
    """
    return tuple(Method(*method) for method in _plantigrade.segmentation_methods())


def roles() -> tuple[str, ...]:
    """Return the names of all roles of joints: trunk, arms, legs.

    Examples
    --------
    >>> plantigrade.roles()[13:18]
    ('left_thigh', 'left_shank', 'left_ankle', 'left_toe', 'left_tip')
    """
    return tuple(_plantigrade.role_names())
