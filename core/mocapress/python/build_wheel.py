# SPDX-License-Identifier: MIT
"""The build backend (PEP 517): CMake builds the package, and this makes a wheel of it."""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PROJECT = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
VERSION = re.search(r"project\(mocapress VERSION ([\d.]+)", PROJECT)[1]
METADATA = f"""Metadata-Version: 2.1
Name: mocapress
Version: {VERSION}
Summary: Wavelet compression of human motion capture clips
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
Description-Content-Type: text/markdown

""" + (HERE / "README.md").read_text(encoding="utf-8")


def build_package(folder):
    """The built package: a folder mocapress."""
    settings = {"CMAKE_BUILD_TYPE": "Release", "MOCAPRESS_GUI": "OFF", "MOCAPRESS_TESTS": "OFF",
                "MOCAPRESS_PYTHON_PACKAGE": "ON", "Python_EXECUTABLE": sys.executable,
                "CMAKE_REQUIRE_FIND_PACKAGE_Python": "ON", "CMAKE_REQUIRE_FIND_PACKAGE_pybind11": "ON"}
    # pip asks by another path for each wheel: with a folder of its own, a build goes on from the last.
    build = pathlib.Path(os.environ.get("MOCAPRESS_WHEEL_BUILD", folder))
    subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja",
                    *(f"-D{key}={value}" for key, value in settings.items())], check=True)
    subprocess.run(["cmake", "--build", build, "--target", "mocapress-python-package"], check=True)
    return build / "core/mocapress/python/mocapress"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-" + re.sub(r"[-.]", "_", sysconfig.get_platform())
    info = f"mocapress-{VERSION}.dist-info"
    name = f"mocapress-{VERSION}-{tag}.whl"
    record = []
    with tempfile.TemporaryDirectory() as folder, \
            zipfile.ZipFile(pathlib.Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:

        def add(place, data):
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{place},sha256={digest},{len(data)}\n")
            wheel.writestr(place, data)

        package = build_package(folder)
        for path in sorted(package.iterdir()):
            if path.suffix in (".py", ".pyi", ".so", ".typed"):
                if path.suffix == ".so":
                    subprocess.run(["strip", "--strip-unneeded", "-o", f"{folder}/stripped", path],
                                   check=True)
                    path, place = pathlib.Path(folder, "stripped"), f"mocapress/{path.name}"
                else:
                    place = f"mocapress/{path.name}"
                add(place, path.read_bytes())
        add(f"{info}/LICENSE", (ROOT / "LICENSE").read_bytes())
        add(f"{info}/METADATA", METADATA.encode())
        add(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: mocapress\n"
                             f"Root-Is-Purelib: false\nTag: {tag}\n".encode())
        wheel.writestr(f"{info}/RECORD", "".join(record) + f"{info}/RECORD,,\n")
    return name
