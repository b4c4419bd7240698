#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The command line for Windows under wine, beside the one for Linux.

Usage: command_line_test.py MOCAPRESS.exe MOCAPRESS HOLD_FILE.exe SAMPLES [CORPUS]

MOCAPRESS is the same tree's program for Linux: both must write the same bytes. Wine stands for Windows in all of this;
it keeps files on a Linux file system, where names differ by case.
"""
import base64
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, LINUX, HOLD_FILE, SAMPLES = map(os.path.abspath, sys.argv[1:5])
CORPUS = sys.argv[5] if len(sys.argv) > 5 else None
WINE = shutil.which("wine64")
ANY_LETTERS = "動き 🕺 Łódź é"
PATIENCE_S = 300
CLIPS = ["human_walk.amc", "human_jump.amc", "character.glb", "character.fbx"]
FROM_CORPUS = ["study/02_01.amc", "study/86_01.amc", "gltf/character_meshopt.glb", "gltf/character_draco.glb"]


def windows_path(path):
    """Wine shows the whole of Linux as drive Z."""
    return "Z:" + str(path).replace("/", "\\")


def run(words, **more):
    return subprocess.run(words, capture_output=True, timeout=PATIENCE_S, **more)


def windows(*words, **more):
    return run([WINE, PROGRAM, *map(str, words)], **more)


def linux(*words, **more):
    return run([LINUX, *map(str, words)], **more)


def hashes(folder, names=("*.mcpr", "*.mcpk", "*.csv", "*.bvh", "*.glb")):
    found = [file for pattern in names for file in pathlib.Path(folder).rglob(pattern)]
    return {str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest() for file in sorted(found)}


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="mocapress-windows-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def clip(self, name="walk.amc", sample="human_walk.amc"):
        """A sample under another name, with its skeleton."""
        place = self.folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(pathlib.Path(SAMPLES) / sample, place)
        shutil.copy(pathlib.Path(SAMPLES) / "human.asf", place.with_suffix(".asf"))
        return place

    def done(self, outcome, code=0):
        self.assertEqual(outcome.returncode, code, outcome.stderr.decode("utf-8", "replace"))
        return outcome.stdout.decode("utf-8")

    def refused(self, outcome, code, *words):
        said = outcome.stderr.decode("utf-8")
        self.assertEqual(outcome.returncode, code, said)
        for word in words:
            self.assertIn(word, said)

    def leaves_nothing(self):
        self.assertEqual([str(file) for file in self.folder.rglob(".mocapress-*")], [])


class Program(unittest.TestCase):
    def test_needs_no_library_that_windows_has_not(self):
        # Wine brings libraries, such as zlib1.dll, that are no part of Windows.
        listed = run(["x86_64-w64-mingw32-objdump", "-p", PROGRAM]).stdout.decode()
        needed = {line.split()[-1].lower() for line in listed.splitlines() if "DLL Name:" in line}
        self.assertIn("kernel32.dll", needed)
        self.assertEqual(needed - {"kernel32.dll", "msvcrt.dll", "advapi32.dll", "shell32.dll", "user32.dll"}, set())


class SameBytes(CommandLine):
    def sources(self):
        yield from (pathlib.Path(SAMPLES) / name for name in CLIPS)
        for name in FROM_CORPUS if CORPUS else []:
            if (pathlib.Path(CORPUS) / name).exists():
                yield pathlib.Path(CORPUS) / name

    def both(self, *words):
        """Runs both programs with an output of the same name in a folder each."""
        for program, name in ((windows, "windows"), (linux, "linux")):
            (self.folder / name).mkdir(exist_ok=True)
            self.done(program(*words, cwd=self.folder / name))

    def test_of_encoded_clips_and_of_what_is_decoded(self):
        compared = 0
        for source in self.sources():
            for options in (["--ratio", "30"], ["--target-error", "0.2", "--ik", "auto"], ["--target", "not-visible"]):
                name = f"{source.name}{'_'.join(options)}".replace("-", "").replace(".", "_")
                with self.subTest(source=source.name, options=options):
                    self.both("compress", source, *options, "-o", f"{name}.mcpr")
                    self.both("decompress", f"{name}.mcpr", "-o", f"{name}.csv")
                    self.both("decompress", f"{name}.mcpr", "-o", f"{name}.glb")
                    compared += 1
        of_windows, of_linux = hashes(self.folder / "windows"), hashes(self.folder / "linux")
        different = [name for name in of_linux if of_windows.get(name) != of_linux[name]]
        print(f"{len(of_linux) - len(different)} of {len(of_linux)} files equal Linux's", file=sys.stderr)
        self.assertGreater(compared, 0)
        self.assertEqual(different, [])

    def test_of_what_linux_encoded_when_it_is_decoded(self):
        self.done(linux("compress", pathlib.Path(SAMPLES) / "human_walk.amc", "--ratio", "30", "-o",
                        self.folder / "walk.mcpr"))
        for output in ("walk.csv", "walk.bvh", "walk.glb"):
            self.both("decompress", self.folder / "walk.mcpr", "-o", output)
        self.assertEqual(hashes(self.folder / "windows"), hashes(self.folder / "linux"))

    def test_of_banks(self):
        self.done(linux("compress", pathlib.Path(SAMPLES) / "human_walk.amc", "--ratio", "30", "-o",
                        self.folder / "walk.mcpr"))
        self.both("bank", "make", "packed.mcpk", self.folder / "walk.mcpr")
        self.both("bank", "make", "cooked.mcpk", self.folder / "walk.mcpr", "--cooked")
        self.assertEqual(hashes(self.folder / "windows"), hashes(self.folder / "linux"))

    def test_whatever_ends_the_lines(self):
        clip = self.clip()
        for file in (clip, clip.with_suffix(".asf")):
            file.write_bytes(file.read_bytes().replace(b"\r\n", b"\n").replace(b"\n", b"\r\n"))
        self.done(windows("compress", clip, "--ratio", "30", "-o", self.folder / "crlf.mcpr"))
        self.done(linux("compress", self.clip(), "--ratio", "30", "-o", self.folder / "lf.mcpr"))
        self.assertEqual((self.folder / "crlf.mcpr").read_bytes(), (self.folder / "lf.mcpr").read_bytes())
        self.assertNotIn(b"\r", windows("info", clip, "--json").stdout)


class Names(CommandLine):
    def test_have_any_letters(self):
        clip = self.clip(f"{ANY_LETTERS}/{ANY_LETTERS}.amc")
        mcpr = clip.with_suffix(".mcpr")
        self.done(windows("compress", clip, "--ratio", "30", "-o", mcpr))
        self.assertTrue(mcpr.exists())
        self.assertEqual(json.loads(self.done(windows("info", mcpr, "--json")))[0]["input"], str(mcpr))
        self.done(windows("batch", clip.parent, "-o", self.folder / "out"))
        self.assertIn(f"{ANY_LETTERS}/{ANY_LETTERS}.mcpr", hashes(self.folder / "out"))
        self.done(windows("decompress", mcpr, "-o", clip.with_suffix(".bvh")))
        self.assertTrue(clip.with_suffix(".bvh").exists())
        self.done(windows("bank", "make", self.folder / "all.mcpk", mcpr))
        self.assertIn(ANY_LETTERS, self.done(windows("bank", "list", self.folder / "all.mcpk", "--json")))
        self.refused(windows("info", self.folder / f"no {ANY_LETTERS}.bvh"), 3, f"no {ANY_LETTERS}.bvh")

    def test_may_be_longer_than_260_characters(self):
        deep = "/".join(letter * 60 for letter in "abcdef")
        clip = self.clip(f"{deep}/walk.amc")
        mcpr = self.folder / deep / "made" / "walk.mcpr"
        self.done(windows("batch", clip, "-o", mcpr.parent, "--name", "{stem}"))
        self.assertTrue(mcpr.exists())
        self.done(windows("decompress", mcpr, "-o", mcpr.with_suffix(".csv")))
        self.assertTrue(mcpr.with_suffix(".csv").exists())
        self.done(windows("batch", clip.parent, "-o", self.folder / "out"))
        self.done(windows("bank", "make", self.folder / "deep.mcpk", mcpr.parent))
        self.done(windows("bank", "extract", self.folder / "deep.mcpk", "-o", clip.parent / "again"))
        self.refused(windows("bank", "extract", self.folder / "deep.mcpk", "-o", clip.parent / "again"), 5, "exists")
        for made in (next((self.folder / "out").rglob("walk.mcpr")), clip.parent / "again" / "walk.mcpr"):
            self.assertEqual(made.read_bytes(), mcpr.read_bytes())

    def test_of_gltf_buffers_are_found_beside_their_file(self):
        clip = self.clip(f"{ANY_LETTERS}/walk.amc")
        self.done(linux("compress", clip, "--ratio", "30", "-o", clip.with_suffix(".mcpr")))
        gltf = clip.with_suffix(".gltf")
        self.done(windows("decompress", clip.with_suffix(".mcpr"), "-o", gltf))
        parts = json.loads(gltf.read_text())
        data = base64.b64decode(parts["buffers"][0]["uri"].split(",")[1])
        for name in ("beside.bin", f"below/{ANY_LETTERS}.bin"):
            (clip.parent / name).parent.mkdir(exist_ok=True)
            (clip.parent / name).write_bytes(data)
            parts["buffers"][0]["uri"] = name
            gltf.write_text(json.dumps(parts))
            self.done(windows("info", gltf))
        shutil.copy(clip.parent / "beside.bin", self.folder)
        parts["buffers"][0]["uri"] = "../beside.bin"
        gltf.write_text(json.dumps(parts))
        self.refused(windows("info", gltf), 3, "only files in its own folder are read")

    def test_that_differ_only_in_case_are_one(self):
        clip = self.clip()
        self.done(linux("compress", clip, "--ratio", "30", "-o", self.folder / "walk.mcpr"))
        clips = self.folder / "clips"
        for place in ("Łódź/walk.mcpr", "łódź/Walk.mcpr"):
            (clips / place).parent.mkdir(parents=True)
            shutil.copy(self.folder / "walk.mcpr", clips / place)
        self.done(linux("bank", "make", self.folder / "all.mcpk", clips))
        for options in ([], ["--overwrite"]):
            self.refused(windows("bank", "extract", self.folder / "all.mcpk", "-o", self.folder / "out", *options), 3,
                         "would take another's place")
            self.assertFalse((self.folder / "out").exists())
        self.clip("a/walk.amc")
        self.clip("b/WALK.amc")
        self.refused(windows("batch", self.folder / "a", self.folder / "b", "-o", self.folder / "out", "--name",
                             "{stem}"), 7, "would be written to")

    def test_with_drive_letters_and_backslashes(self):
        clip = self.clip()
        self.done(windows("compress", windows_path(clip), "--ratio", "30", "-o", windows_path(self.folder) + "\\a.mcpr"))
        self.assertTrue((self.folder / "a.mcpr").exists())
        # A drive of its own, whose root is a folder of clips and of results.
        drive = pathlib.Path(os.environ["WINEPREFIX"]) / "dosdevices" / "q:"
        drive.unlink(missing_ok=True)
        drive.symlink_to(self.folder)
        self.addCleanup(drive.unlink)
        self.done(windows("compress", "Q:\\walk.amc", "--ratio", "30", "-o", "Q:\\b.mcpr"))
        self.assertEqual((self.folder / "a.mcpr").read_bytes(), (self.folder / "b.mcpr").read_bytes())
        self.done(windows("batch", "Q:\\walk.amc", "-o", "Q:\\", "--name", "made/{stem}"))
        self.assertTrue((self.folder / "made" / "walk.mcpr").exists())
        self.refused(windows("compress", "Q:\\walk.amc", "--ratio", "30", "-o", "Q:\\"), 2)
        self.refused(windows("info", "X:\\none.bvh"), 3, "none.bvh")

    def test_of_devices_are_refused(self):
        self.refused(windows("info", "NUL.bvh"), 3, "NUL.bvh")
        self.refused(windows("compress", self.clip(), "--ratio", "30", "-o", self.folder / "NUL.mcpr"), 5)

    def test_in_banks_and_patterns_do_not_leave_their_folder(self):
        clip = self.clip()
        self.done(linux("compress", clip, "--ratio", "30", "-o", self.folder / "walk.mcpr"))
        for number, name in enumerate(("C:evil", "\\evil", "..\\evil")):
            clips = self.folder / f"clips{number}"
            clips.mkdir()
            shutil.copy(self.folder / "walk.mcpr", clips / f"{name}.mcpr")
            self.done(linux("bank", "make", self.folder / f"{number}.mcpk", clips))
            self.refused(windows("bank", "extract", self.folder / f"{number}.mcpk", "-o", self.folder / "out"), 3,
                         "leaves the folder")
            self.assertFalse((self.folder / "out").exists())
            self.refused(windows("batch", clip, "-o", self.folder / "out", "--name", name), 2)


class Files(CommandLine):
    def test_held_by_another_program_stay_and_are_named(self):
        clip, mcpr = self.clip(), self.folder / "walk.mcpr"
        mcpr.write_text("old")
        holder = subprocess.Popen([WINE, HOLD_FILE, str(mcpr)], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.addCleanup(holder.stdout.close)
        self.assertEqual(holder.stdout.readline().strip(), b"held")
        self.refused(windows("compress", clip, "--ratio", "30", "-o", mcpr), 5, "is open in another program")
        self.assertEqual(mcpr.read_text(), "old")
        holder.stdin.close()
        self.assertEqual(holder.wait(PATIENCE_S), 0)
        self.done(windows("compress", clip, "--ratio", "30", "-o", mcpr))
        self.assertNotEqual(mcpr.read_bytes(), b"old")
        self.leaves_nothing()

    def test_that_are_held_can_be_read(self):
        clip = self.clip()
        with subprocess.Popen([WINE, HOLD_FILE, str(clip)], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as holder:
            self.assertEqual(holder.stdout.readline().strip(), b"held")
            self.done(windows("info", clip))

    def test_that_are_read_only_stay(self):
        clip, mcpr = self.clip(), self.folder / "walk.mcpr"
        mcpr.write_text("old")
        mcpr.chmod(0o444)
        self.refused(windows("compress", clip, "--ratio", "30", "-o", mcpr), 5, "is write-protected")
        self.assertEqual(mcpr.read_text(), "old")
        self.leaves_nothing()

    def test_are_not_written_onto_their_source_by_another_name(self):
        clip = self.clip("walk.bvh", "human_walk.amc")
        self.refused(windows("contacts", clip, "-o", self.folder / "WALK.BVH"), 5, "one of the inputs")


class Batch(CommandLine):
    COUNT = 8

    def clips(self):
        for number in range(self.COUNT):
            self.clip(f"in/clip{number}.amc", ("human_walk.amc", "human_jump.amc", "human_run.amc")[number % 3])
        return self.folder / "in"

    def start(self, *words):
        return subprocess.Popen([WINE, PROGRAM, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    def wait_for_a_clip(self, folder, process):
        while not list(folder.rglob("*.mcpr")) and process.poll() is None:
            time.sleep(0.02)  # no time is measured: this only asks again

    def test_is_resumed_after_a_kill_to_the_same_bytes(self):
        clips, out = self.clips(), self.folder / "out"
        self.done(linux("batch", clips, "-o", self.folder / "whole"))
        whole = hashes(self.folder / "whole", ["*.mcpr"])
        process = self.start("batch", clips, "-o", out, "--jobs", "1")
        self.wait_for_a_clip(out, process)
        process.kill()
        process.communicate()
        left = hashes(out, ["*.mcpr"])
        self.assertLess(len(left), self.COUNT, "was killed too late")
        self.assertEqual(left, {name: whole[name] for name in left}, "every file that is there is whole")
        self.leaves_nothing()
        self.done(windows("batch", clips, "-o", out, "--resume"))
        self.assertEqual(hashes(out, ["*.mcpr"]), whole)

    def test_stops_when_asked_to(self):
        clips, out = self.clips(), self.folder / "out"
        process = self.start("batch", clips, "-o", out, "--jobs", "1")
        self.wait_for_a_clip(out, process)
        process.send_signal(signal.SIGINT)  # wine makes Ctrl+C of it
        said = process.communicate()[1].decode("utf-8")
        self.assertEqual(process.returncode, 128 + signal.SIGINT, said)
        self.assertIn("--resume", said)
        self.leaves_nothing()

    def test_has_its_folder_to_itself(self):
        clips, out = self.clips(), self.folder / "out"
        process = self.start("batch", clips, "-o", out, "--jobs", "1")
        self.wait_for_a_clip(out, process)
        self.refused(windows("batch", clips, "-o", out, "--resume"), 5, "another run is using it")
        process.kill()
        process.communicate()  # reads its errors to the end


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
