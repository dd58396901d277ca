"""The package imports what it needs, when it needs it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path


def run(code: str) -> str:
    command = [sys.executable, "-I", "-c", code]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def test_import_is_fast() -> None:
    # The time of the processor does not depend on the load of the machine.
    code = "import time; t = time.process_time(); import plantigrade; print(time.process_time() - t)"
    assert min(float(run(code)) for _ in range(5)) < 0.1


def test_import_loads_no_other_packages() -> None:
    code = "import sys, plantigrade; print(*sorted({name.split('.')[0] for name in sys.modules}))"
    loaded = set(run(code).split())
    assert not loaded & {"numpy", "pandas", "matplotlib", "sklearn", "ray", "tqdm", "pyarrow"}


def test_detection_requires_numpy_alone(walk_path: Path) -> None:
    code = f"import sys, plantigrade; plantigrade.detect({str(walk_path)!r}).contact; print(*sys.modules)"
    loaded = {name.split(".")[0] for name in run(code).split()}
    assert "numpy" in loaded
    assert not loaded & {"pandas", "matplotlib", "sklearn", "ray", "tqdm", "pyarrow", "scipy"}
