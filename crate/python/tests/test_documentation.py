"""The documentation is complete and its examples run."""

from __future__ import annotations

import doctest
import importlib
import pkgutil
import re
from pathlib import Path

import documentation
import pytest
from conftest import PROJECT

import plantigrade

MODULES = [f"plantigrade.{module.name}" for module in pkgutil.iter_modules(plantigrade.__path__)]
#: Modules that require packages which need not be installed.
OPTIONAL = {"plantigrade.ray", "plantigrade.sklearn", "plantigrade._widget"}


def test_the_page_is_that_of_the_docstrings() -> None:
    expected = documentation.page(documentation.interface())
    assert documentation.PAGE.read_text(encoding="utf-8") == expected, (
        "update it: python crate/python/tests/documentation.py"
    )


@pytest.mark.parametrize("name", ["plantigrade", *MODULES])
def test_examples_in_docstrings_run(name: str, folder: Path) -> None:
    if name in OPTIONAL:
        pytest.importorskip(name)
    module = importlib.import_module(name)
    names = {"plantigrade": plantigrade}
    for test in doctest.DocTestFinder().find(module, globs=names):
        result = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test)
        assert result.failed == 0, test.name


@pytest.mark.parametrize("page", ["README.md", "docs/python.md", "crate/python/README.md"])
def test_examples_of_pages_run(page: str, folder: Path) -> None:
    text = (PROJECT / page).read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert blocks
    names: dict[str, object] = {}
    for block in blocks:
        exec(compile(block, page, "exec"), names)
