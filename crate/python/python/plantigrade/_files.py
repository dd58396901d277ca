"""Files of results: their format, and how they are written."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from ._errors import PlantigradeError

if TYPE_CHECKING:
    from ._clip import Path


def format_of(path: Path, formats: list[tuple[str, str, str, str]]) -> str:
    """Return the name of the format that the ending of a path determines."""
    name = os.path.basename(path).lower()
    for format, _, _, extension in formats:
        if name.endswith(f".{extension}"):
            return format
    # Of formats with the same last ending, the first one is meant.
    for format, _, _, extension in formats:
        if name.endswith("." + extension.rpartition(".")[2]):
            return format
    endings = ", ".join(f".{extension}" for _, _, _, extension in formats)
    raise PlantigradeError(
        f"the ending of {os.fspath(path)!r} does not name a format",
        hint=f"Use one of {endings}, or pass format",
    )


def write(path: Path, data: bytes) -> None:
    """Write a file as a whole or not at all."""
    path = os.fspath(path)
    temporary = f"{path}.{os.getpid()}.tmp"
    try:
        with open(temporary, "wb") as file:
            file.write(data)
        os.replace(temporary, path)
    except BaseException:
        if os.path.exists(temporary):
            os.remove(temporary)
        raise
