"""Notices: what was assumed, repaired or left out."""

from __future__ import annotations

from typing import NamedTuple


class Notice(NamedTuple):
    """An assumption, a repair or a doubt.

    Attributes
    ----------
    code : str
        Subject in kebab case, such as ``"up-axis"``.
    text : str
        What was found and what was done.
    line, column : int or None
        Position in the file, from 1.
    """

    code: str
    text: str
    line: int | None = None
    column: int | None = None

    def __str__(self) -> str:
        position = "" if self.line is None else f"{self.line}:{self.column}: "
        return position + self.text
