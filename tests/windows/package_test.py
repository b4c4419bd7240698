#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The zip for Windows, unpacked into a Windows under wine that has nothing else.

Usage: package_test.py ZIP MOCAPRESS SAMPLES

MOCAPRESS is the same tree's program for Linux.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

ZIP, LINUX, SAMPLES = map(os.path.abspath, sys.argv[1:4])
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "core/runtime/example"
WINE = shutil.which("wine64")
PATIENCE_S = 300


def run(words, **more):
    outcome = subprocess.run(list(map(str, words)), capture_output=True, timeout=PATIENCE_S, **more)
    assert outcome.returncode == 0, (words, outcome.stdout, outcome.stderr)
    return outcome.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="mocapress-package-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        with zipfile.ZipFile(ZIP) as packed:
            cls.names = packed.namelist()
            packed.extractall(cls.folder)
        cls.package = cls.folder / pathlib.Path(ZIP).stem
        cls.readme = (cls.package / "README.txt").read_text("utf-8")

    def test_lies_in_a_folder_of_its_own_name(self):
        self.assertEqual({name.split("/")[0] for name in self.names}, {self.package.name})

    def test_has_program_runtime_add_on_and_licences(self):
        found = {str(file.relative_to(self.package)) for file in self.package.rglob("*") if file.is_file()}
        version = self.package.name.split("-")[1]
        self.assertEqual({name for name in found if not name.startswith("licences/")}, {
            "README.txt", "mocapress.exe", "sbom.cdx.json", f"blender/mocapress-blender-{version}.zip",
            "runtime/mocapress_runtime.h", "runtime/mocapress_runtime.hpp", "runtime/mocapress_runtime.cpp",
            "runtime/README.md", "runtime/SAMPLING.md"})
        with zipfile.ZipFile(self.package / f"blender/mocapress-blender-{version}.zip") as add_on:
            self.assertIn("io_mocapress/__init__.py", add_on.namelist())

    def test_has_a_licence_for_each_library_that_is_linked(self):
        packages = {"Eigen3": "libeigen3-dev", "ZLIB": "libz-mingw-w64-dev", "TBB": "onetbb", "CLI11": "libcli11-dev",
                    "nlohmann_json": "nlohmann-json3-dev", "meshoptimizer": "meshoptimizer", "draco": "draco"}
        linked = {part["name"] for part in json.loads((self.package / "sbom.cdx.json").read_text())["components"]}
        self.assertEqual(linked, set(packages))
        own = ["mocapress", "mocapress-core-and-runtime", "gcc-mingw-w64-base", "mingw-w64-common"]
        for name in own + [packages[library] for library in linked]:
            text = (self.package / "licences" / f"{name}.txt").read_text("utf-8")
            self.assertRegex(text, "(?i)licen[cs]e", name)
            for licence in re.findall(r"/usr/share/common-licenses/([\w.-]*\w)", text):
                self.assertTrue((self.package / "licences/common-licenses" / f"{licence}.txt").exists(), licence)

    def test_readme_names_all_that_lies_beside_it(self):
        described = {line.split()[0] for line in self.readme.splitlines()
                     if line[:1].strip() and line[18:20] == "  " and line[20:21].strip()}
        self.assertEqual(described, {file.name for file in self.package.iterdir()} - {"README.txt"})

    def test_readme_shows_commands_that_work(self):
        prefix = self.folder / "wine"
        more = {"env": {**os.environ, "WINEPREFIX": str(prefix), "SOURCE_DATE_EPOCH": "1700000000"}}
        run([WINE, "wineboot", "--init"], **more)
        motion = prefix / "drive_c" / "motion"
        motion.mkdir()
        run([LINUX, "compress", f"{SAMPLES}/human_walk.amc", "--max-error", "0.01", "-o", self.folder / "walk.mcpr"])
        run([LINUX, "decompress", self.folder / "walk.mcpr", "-o", motion / "walk.bvh"])
        commands = [line.strip() for line in self.readme.splitlines() if line.startswith("    .\\")]
        self.assertEqual(len(commands), 5)
        for command in commands:
            run([WINE, "cmd", "/c", command], cwd=self.package, **more)
        run([LINUX, "compress", motion / "walk.bvh", "--target-error", "0.2", "-o", self.folder / "linux.mcpr"])
        self.assertEqual((motion / "walk.mcpr").read_bytes(), (self.folder / "linux.mcpr").read_bytes())
        self.assertTrue((motion / "again.glb").read_bytes().startswith(b"glTF"))
        made = {file.name for file in (prefix / "drive_c" / "compressed").rglob("*") if file.is_file()}
        self.assertLessEqual({"walk.mcpr", "report.html", "report.csv"}, made)

    def test_runtime_plays_in_the_examples_as_on_linux(self):
        runtime, compiled = self.package / "runtime", self.folder / "runtime.o"
        clip, bank = EXAMPLES / "walk.mcpr", self.folder / "walk.mcpk"
        run([LINUX, "bank", "make", bank, clip, "--cooked"])
        said = []
        for compilers, launcher in ((["x86_64-w64-mingw32-g++-posix", "x86_64-w64-mingw32-gcc-posix"], [WINE]),
                                    (["g++", "gcc"], [])):
            run([compilers[0], "-std=c++20", "-O0", "-ffp-contract=off", "-c", runtime / "mocapress_runtime.cpp", "-o", compiled])
            for name, arguments in (("play", [clip]), ("crowd", [bank, 5])):
                program = self.folder / f"{name}.exe"
                run([compilers[1], "-std=c11", "-Wall", "-Wextra", "-Wconversion", "-Werror", f"-I{runtime}",
                     EXAMPLES / f"{name}.c", compiled, "-static", "-lstdc++", "-lm", "-o", program])
                said.append(run([*launcher, program, *arguments]).replace(b"\r\n", b"\n"))
        self.assertIn(b"2 s: 4 plays walk at ", said[1])
        self.assertEqual(said[:2], said[2:])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
