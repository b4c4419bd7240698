# SPDX-License-Identifier: MIT
import os
import subprocess
import sys

import pytest
from conftest import ROOT, SAMPLES

EXAMPLE = ROOT / "core/mocapress/python/example/rate_distortion.py"


def test_the_example_plots_a_curve(tmp_path):
    pytest.importorskip("matplotlib")
    picture = tmp_path / "curve.png"
    told = subprocess.run([sys.executable, EXAMPLE, SAMPLES / "human_walk.amc", picture], check=True,
                          capture_output=True, text=True,
                          env={**os.environ, "MPLCONFIGDIR": str(tmp_path)}).stdout.splitlines()
    assert picture.read_bytes().startswith(b"\x89PNG")
    sizes = [int(line.split(", ")[1].split()[0]) for line in told if line.startswith("closed-loop")]
    assert len(sizes) == 5 and sizes == sorted(sizes, reverse=True)
