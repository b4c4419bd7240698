# SPDX-License-Identifier: MIT
import ast
import pathlib

from conftest import ROOT

import mocapress
from mocapress import _core


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


def test_the_version_is_that_of_the_project():
    project = (ROOT / "CMakeLists.txt").read_text()
    assert f"project(mocapress VERSION {mocapress.__version__} " in project


def test_everything_public_has_a_text_to_read():
    assert set(mocapress.__all__) <= set(dir(mocapress))
    for name in mocapress.__all__:
        assert getattr(mocapress, name).__doc__, name
