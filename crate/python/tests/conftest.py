"""Shared fixtures: sample clips, recorded motion, and the command line."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

import plantigrade

PROJECT = Path(__file__).resolve().parents[3]
SAMPLES = PROJECT / "samples"


def corpus_files() -> list[Path]:
    """Return all recorded clips, if the folder of recorded motion exists."""
    default = PROJECT.parent / "shared" / "corpus"
    corpus = Path(os.environ.get("PLANTIGRADE_CORPUS", default))
    return sorted([*corpus.rglob("*.bvh"), *(corpus.parent / "plates").rglob("*.bvh")])


@pytest.fixture(scope="session")
def walk() -> plantigrade.Clip:
    return plantigrade.Clip.read(SAMPLES / "curved-walk.bvh")


@pytest.fixture(scope="session")
def walk_path() -> Path:
    return SAMPLES / "curved-walk.bvh"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Working folder with the clip ``walk.bvh`` and its truth."""
    shutil.copy(SAMPLES / "curved-walk.bvh", tmp_path / "walk.bvh")
    shutil.copy(SAMPLES / "curved-walk.json", tmp_path / "walk.json")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(scope="session")
def program() -> str:
    """Path of the command line; tests that require it are skipped without it."""
    path = os.environ.get("PLANTIGRADE_PROGRAM", "")
    if not Path(path).is_file():
        pytest.skip("PLANTIGRADE_PROGRAM does not name the command line")
    return path
