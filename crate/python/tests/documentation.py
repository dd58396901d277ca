"""The page ``docs/python.md``: its part about the interface is made from the docstrings.

Run as a script, it updates the page. Everything above the marker is written by hand.
"""

from __future__ import annotations

import inspect
import re
from pathlib import Path
from typing import Any

import plantigrade

PAGE = Path(__file__).resolve().parents[3] / "docs" / "python.md"
MARKER = "<!-- Made from the docstrings by crate/python/tests/documentation.py. -->"
SECTIONS = ("Parameters", "Attributes", "Returns", "Raises", "Examples")


def page(interface: str) -> str:
    """Return the page with a new part about the interface."""
    text = PAGE.read_text(encoding="utf-8")
    head, marker, _ = text.partition(MARKER)
    assert marker, f"{PAGE} has no marker"
    return f"{head}{MARKER}\n\n{interface}"


def interface() -> str:
    """Return the documentation of everything that the package exports."""
    items = [(name, getattr(plantigrade, name)) for name in plantigrade.__all__]
    functions = [(name, item) for name, item in items if inspect.isfunction(item)]
    classes = [(name, item) for name, item in items if inspect.isclass(item)]
    parts = ["## Functions", ""]
    for name, function in functions:
        parts += entry(f"plantigrade.{name}", function, 3)
    parts += ["## Classes", ""]
    for name, cls in classes:
        parts += of_class(name, cls)
    parts += ["## Presets", "", markdown(inspect.getdoc(plantigrade.presets) or ""), ""]
    parts += of_class("presets.Preset", plantigrade.presets.Preset)
    parts += ["| preset | joints | |", "|---|---|---|"]
    parts += [f"| `presets.{name}` | {count} | {text} |" for name, count, text in presets()]
    return "\n".join(parts) + "\n"


def presets() -> list[tuple[str, int, str]]:
    """Return name, number of joints and description of each preset."""
    source = inspect.getsource(plantigrade.presets)
    descriptions = re.findall(
        r'^([A-Z0-9_]+) = Preset\((?:[^\n]+|\n.*?^)\)\n"""(.*?)"""', source, re.DOTALL | re.MULTILINE
    )
    return [
        (name, len(getattr(plantigrade.presets, name).names), markdown(text)) for name, text in descriptions
    ]


def of_class(name: str, cls: type) -> list[str]:
    """Return the documentation of a class."""
    parts = [f"### {name}", "", *docstring(cls)]
    inherited = set(dir(tuple)) | set(dir(ValueError)) | set(dir(dict))
    fields = getattr(cls, "_fields", ())
    for member, value in vars(cls).items():
        if member.startswith("_") or member in fields or member in inherited:
            continue
        if isinstance(value, property):
            parts += [f"#### {name}.{member}", "", *docstring(value)]
        elif isinstance(value, (classmethod, staticmethod)):
            parts += entry(f"{name}.{member}", value.__func__, 4)
        elif inspect.isfunction(value):
            parts += entry(f"{name}.{member}", value, 4)
    return parts


def entry(name: str, function: Any, level: int) -> list[str]:
    """Return the documentation of a function."""
    parameters = []
    is_keyword_only = False
    for parameter in inspect.signature(function).parameters.values():
        if parameter.name in ("self", "cls"):
            continue
        if parameter.kind is parameter.KEYWORD_ONLY and not is_keyword_only:
            is_keyword_only = True
            parameters.append("*")
        text = parameter.name
        if parameter.kind is parameter.VAR_KEYWORD:
            text = f"**{text}"
        if parameter.default is not parameter.empty:
            text += f"={parameter.default!r}"
        parameters.append(text)
    return [
        f"{'#' * level} {name}",
        "",
        f"```text\n{name}({', '.join(parameters)})\n```",
        "",
        *docstring(function),
    ]


def docstring(item: Any) -> list[str]:
    """Return a docstring in the NumPy style as lines of Markdown."""
    text = inspect.getdoc(item)
    assert text, f"{item} has no docstring"
    parts: list[str] = []
    for title, body in sections(text):
        if title == "Examples":
            parts += [f"```pycon\n{body}\n```", ""]
        elif title:
            parts += [f"*{title}*", "", *definitions(body), ""]
        else:
            parts += [markdown(body), ""]
    return parts


def sections(text: str) -> list[tuple[str, str]]:
    """Return titles and bodies; the first title is empty."""
    pattern = rf"^({'|'.join(SECTIONS)})\n-+\n"
    pieces = re.split(pattern, text, flags=re.MULTILINE)
    titles = ["", *pieces[1::2]]
    return [(title, body.strip()) for title, body in zip(titles, pieces[::2], strict=True)]


def definitions(body: str) -> list[str]:
    """Return a list of parameters, attributes, results or exceptions."""
    items: list[tuple[str, list[str]]] = []
    for line in body.split("\n"):
        if line.startswith(" "):
            items[-1][1].append(line.strip())
        elif line.strip():
            items.append((line.strip(), []))
    lines = []
    for head, text in items:
        names, colon, kind = head.partition(" : ")
        title = f"`{names}`" + (f": {kind}" if colon else "")
        lines.append(f"- {title}. {markdown(' '.join(text))}".rstrip().removesuffix(" ."))
    return lines


def markdown(text: str) -> str:
    """Return text with roles and literals of reStructuredText as code."""
    text = re.sub(r":\w+:`~?(.+?)`", r"`\1`", text)
    text = re.sub(r"``(.+?)``", r"`\1`", text)
    # An indented example after two colons.
    return re.sub(r"::\n\n((?:    .*\n?)+)", lambda match: f":\n\n{fenced(match[1])}", text)


def fenced(code: str) -> str:
    """Return indented code as a block."""
    lines = "\n".join(line.removeprefix("    ") for line in code.strip("\n").split("\n"))
    return f"```text\n{lines}\n```\n"


if __name__ == "__main__":
    PAGE.write_text(page(interface()), encoding="utf-8")
