"""The widget of the viewer; requires anywidget."""

from __future__ import annotations

from pathlib import Path

import anywidget
import traitlets


class Widget(anywidget.AnyWidget):  # type: ignore[misc]
    """A frame with the page of the viewer.

    The page has the clip, edits and settings of this widget, and reports changes of ``state``.
    """

    _esm = Path(__file__).parent / "_widget.js"

    #: The page, and the clip as a BVH file; both compressed with gzip.
    page = traitlets.Bytes().tag(sync=True)
    clip = traitlets.Bytes().tag(sync=True)
    #: Name of the clip.
    name = traitlets.Unicode().tag(sync=True)
    #: Settings, edits and names of segments.
    state = traitlets.Dict().tag(sync=True)
    #: Height in pixels.
    height = traitlets.Int(560).tag(sync=True)
