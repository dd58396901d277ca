"""Plot of a detection with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._detect import Detection

#: Colours of the left foot and of the right foot, as in the app: distinct for all kinds of colour vision.
COLOURS = {"left": "#2f7de1", "right": "#e8710a"}
#: Confidence below which contact is drawn as uncertain.
UNCERTAIN = 0.75


def plot(detection: Detection, axes: Axes | None = None) -> Axes:
    """Draw the plants of a detection over time; see :meth:`Detection.plot`."""
    import numpy as np

    if axes is None:
        from matplotlib import pyplot

        _, axes = pyplot.subplots(figsize=(10, 0.45 * 2 * len(detection.parts) + 1), layout="constrained")
    parts = [part for part in ("contact", "heel", "toe") if part in detection.parts]
    rows: list[tuple[str, str]] = [(side, part) for side in ("left", "right") for part in parts]
    for interval in detection.intervals:
        row = rows.index((interval.side, interval.part))
        is_principal = interval.part == detection.parts[0]
        axes.broken_barh(
            [(interval.start_time, interval.end_time - interval.start_time)],
            (row - 0.38, 0.76),
            facecolors=COLOURS[interval.side],
            alpha=1.0 if is_principal else 0.45,
        )
    for event in detection.events:
        if event.uncertainty is not None:
            row = rows.index((event.side, detection.parts[0]))
            axes.errorbar(
                event.time, row, xerr=event.uncertainty, color="black", capsize=3, linewidth=1, zorder=3
            )
    confidence = detection.confidence
    for column, side in enumerate(("left", "right")):
        frames = np.flatnonzero(confidence[:, column] < UNCERTAIN)
        row = rows.index((side, detection.parts[0]))
        axes.plot(frames / detection.fps, np.full(len(frames), row + 0.38), ".", color="black", markersize=2)
    axes.set_yticks(range(len(rows)), [f"{side} {part}" for side, part in rows])
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_xlim(0, max(len(detection.clip), 1) / detection.fps)
    axes.set_xlabel("time in s")
    return axes
