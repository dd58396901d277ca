"""The exception of the package."""

from __future__ import annotations


class PlantigradeError(ValueError):
    """A file, an array or an argument that cannot be used.

    The text of the exception has all that is known: file, line, column, message and hint.

    Parameters
    ----------
    message : str
        What is wrong.
    file : str, optional
        Name of the file.
    line, column : int, optional
        Position in the file, from 1.
    hint : str, optional
        What to do.
    excerpt : str, optional
        The line at the position, shortened.
    caret : int, optional
        Position in the excerpt, from 0.
    """

    def __init__(
        self,
        message: str,
        *,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
        hint: str | None = None,
        excerpt: str | None = None,
        caret: int | None = None,
    ) -> None:
        super().__init__(message)
        self.message = message
        self.file = file
        self.line = line
        self.column = column
        self.hint = hint
        self.excerpt = excerpt
        self.caret = caret

    def __str__(self) -> str:
        position = [str(part) for part in (self.file, self.line, self.column) if part is not None]
        text = f"{':'.join(position)}: {self.message}" if position else self.message
        if not self.hint:
            return text
        end = "" if self.hint.endswith((".", "?")) else "."
        return f"{text}. {self.hint}{end}"

    def __reduce__(self) -> tuple[object, ...]:
        details = {
            name: getattr(self, name) for name in ("file", "line", "column", "hint", "excerpt", "caret")
        }
        return (_restored, (self.message, details))


def _restored(message: str, details: dict[str, object]) -> PlantigradeError:
    return PlantigradeError(message, **details)  # type: ignore[arg-type]
