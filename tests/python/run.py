# SPDX-License-Identifier: MIT
"""Runs the tests of the Python package. Exit code 77: numpy or pytest is missing."""
import pathlib
import sys

sys.dont_write_bytecode = True
try:
    import numpy  # noqa: F401
    import pytest
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

HERE = pathlib.Path(__file__).parent
sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", "--rootdir", str(HERE), str(HERE), *sys.argv[1:]]))
