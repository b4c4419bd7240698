# SPDX-License-Identifier: MIT
import ast
import pathlib
import re
import shutil
import subprocess

import pytest
from conftest import ROOT

import mocapress
from mocapress import _core


EXAMPLE = ROOT / "core/mocapress/python/example/rate_distortion.py"
USE = pathlib.Path(__file__).with_name("typed_use.py")


def declared(body):
    return {node.name for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef))} | {
        node.target.id for node in body if isinstance(node, ast.AnnAssign)
        and not node.target.id.startswith("_")}


def offered(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def test_types_name_all_that_there_is_and_nothing_else():
    folder = pathlib.Path(mocapress.__file__).parent
    assert (folder / "py.typed").exists()
    stub = ast.parse((folder / "_core.pyi").read_text()).body
    assert declared(stub) == offered(_core)
    for one in stub:
        if isinstance(one, ast.ClassDef):
            found = {name for name in declared(one.body) if not name.startswith("_")}
            assert found == offered(getattr(_core, one.name)), one.name


def test_a_strict_type_checker_takes_the_package_and_scripts_that_use_it(tmp_path):
    mypy = shutil.which("mypy")
    if not mypy:
        pytest.skip("mypy is not installed")
    # A copy, for a checker leaves out what lies among a Python's installed packages. matplotlib has no types.
    shutil.copytree(pathlib.Path(mocapress.__file__).parent, tmp_path / "mocapress",
                    ignore=shutil.ignore_patterns("*.so"))
    (tmp_path / "mypy.ini").write_text("[mypy]\n[mypy-matplotlib.*]\nignore_missing_imports = true\n")
    outcome = subprocess.run([mypy, "--strict", "--python-executable", "/usr/bin/python3", "mocapress", EXAMPLE, USE],
                             cwd=tmp_path, capture_output=True, text=True)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr


def test_the_version_is_that_of_the_project():
    project = (ROOT / "CMakeLists.txt").read_text()
    assert f"project(mocapress VERSION {mocapress.__version__} " in project


def test_everything_public_has_a_text_to_read():
    assert set(mocapress.__all__) <= set(dir(mocapress))
    for name in mocapress.__all__:
        thing = getattr(mocapress, name)
        assert thing.__doc__, name
        for member, value in vars(thing).items() if isinstance(thing, type) else ():
            # pybind11 puts the signature of a function first.
            assert member.startswith("_") or re.sub(r"^.* -> .*\n", "", value.__doc__ or "").strip(), f"{name}.{member}"
