"""The viewer and timeline of the app in notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._errors import PlantigradeError

if TYPE_CHECKING:
    from ._detect import Detection
    from ._widget import Widget


#: Below a viewer that is static because anywidget is missing.
HINT = (
    "Edits in this viewer do not reach Python. For that, install anywidget: "
    "<code>pip install plantigrade[notebook]</code>"
)


class Viewer:
    """The viewer and timeline of the app in a notebook: the result of :meth:`Detection.show`.

    A notebook displays it as the last value of a cell. Edits of plants and settings that are made in it
    change :attr:`detection`.
    """

    __slots__ = ("_detection", "_height", "_hint", "_shown", "_shown_state", "_state", "_widget")

    def __init__(
        self, detection: Detection, height: int, widget: type[Widget] | None, hint: str = ""
    ) -> None:
        from . import _page

        #: What Python has shown last, from which changes start, and what is known of the page.
        self._shown = self._detection = detection
        self._shown_state = self._state = _page.state_of(detection)
        self._height = height
        #: What is below a static viewer.
        self._hint = hint
        self._widget = None
        if widget is not None:
            self._widget = widget(
                page=_page.compressed_page(),
                clip=_page.compressed_clip(detection.clip),
                name=_page.name_of(detection.clip),
                state=self._state,
                height=height,
            )

    @property
    def detection(self) -> Detection:
        """The labels with the edits and settings of the viewer; those of a static viewer never change.

        Assign a detection of the same clip to show its edits and settings.
        """
        if self._widget is not None and self._widget.state != self._state:
            from ._page import detection_of

            self._state = self._widget.state
            self._detection = detection_of(self._shown, self._shown_state, self._state)
        return self._detection

    @detection.setter
    def detection(self, detection: Detection) -> None:
        from ._page import state_of

        if self._widget is None:
            raise PlantigradeError(
                "a static viewer cannot change", hint="Use detection.show() to show another detection"
            )
        own = self._shown.clip
        if detection.clip is not own and detection.clip.to_bytes() != own.to_bytes():
            raise PlantigradeError(
                "the detection is that of another clip", hint="Use detection.show() to show another clip"
            )
        self._shown = self._detection = detection
        self._shown_state = self._state = state_of(detection)
        self._widget.state = self._state

    @property
    def widget(self) -> Any:  # noqa: ANN401
        """The widget, for layouts of ipywidgets; None if the viewer is static."""
        return self._widget

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:  # noqa: ANN401
        from ._page import frame, picture

        if self._widget is None:
            hint = f"<p>{self._hint}</p>" if self._hint else ""
            return {"text/html": frame(self._detection, self._height) + hint, "text/plain": repr(self)}
        bundle = self._widget._repr_mimebundle_()
        data = bundle[0] if isinstance(bundle, tuple) else bundle
        # For readers of the notebook without a kernel.
        return {**data, "text/html": picture(self._detection), "text/plain": repr(self)}

    def __repr__(self) -> str:
        return f"Viewer({self._detection!r})"


def show(detection: Detection, height: int, static: bool) -> Viewer:
    """Return a viewer; a static one without anywidget."""
    if static:
        return Viewer(detection, height, None)
    try:
        from ._widget import Widget
    except ImportError:
        return Viewer(detection, height, None, HINT)
    return Viewer(detection, height, Widget)
