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
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

PROGRAM, LINUX, HOLD_FILE, SAMPLES = map(os.path.abspath, sys.argv[1:5])
CORPUS = sys.argv[5] if len(sys.argv) > 5 else None
WINE = shutil.which("wine64")
ANY_LETTERS = "動き 🕺 Łódź é"
PATIENCE_S = 300
os.environ["SOURCE_DATE_EPOCH"] = "1700000000"  # the date that both write into reports
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


def named_in_help(pattern, command, between=","):
    """The names that Linux's help lists, so that none is forgotten here."""
    text = " ".join(linux(command, "--help").stdout.decode().split())
    return re.search(pattern, text)[1].split(between)


def alike(text):
    """Texts with measured figures as both programs must write them: figures to 12 digits, for functions such as hypot() of
    the two C libraries differ in the last bit, and paths with slashes."""
    text = text.replace("\\\\", "/").replace("\\", "/")
    return re.sub(r"-?\d+\.\d+(e-?\d+)?", lambda number: f"{float(number[0]):.12g}", text)


def fbx_parts(file):
    """The joints of an FBX file, and its curves' values to 12 decimals. An angle of 3.6e-15 degrees, all that rounding left
    of none, was 2.2e-16 degrees less: sin(), cos() and atan2() of the two C libraries differ in the last bit."""
    data = file.read_bytes()
    joints = data[:data.index(b"AnimStack")]
    yield re.sub(b".{4}(?=.{8}\x07Objects)", b"", joints, flags=re.DOTALL)  # without where packed curves end
    for found in re.finditer(b"KeyValueFloatf(.{12})", data, re.DOTALL):
        values, is_packed, size = struct.unpack("<3I", found[1])
        curve = data[found.end():found.end() + size]
        curve = zlib.decompress(curve) if is_packed else curve
        yield [round(value, 12) for value in struct.unpack(f"<{values}f", curve)]


def contents(file):
    """What both programs must write alike."""
    if file.suffix == ".fbx":
        return list(fbx_parts(file))
    if file.suffix == ".json" or file.stem == "report":
        return alike(file.read_text("utf-8"))
    return hashlib.sha256(file.read_bytes()).hexdigest()


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
    def setUp(self):
        super().setUp()
        # Both programs work in folders of their own, where files have the same relative names.
        for name in ("windows", "linux"):
            clips = self.folder / name / "in"
            clips.mkdir(parents=True)
            for sample in ("human.asf", *CLIPS):
                shutil.copy(pathlib.Path(SAMPLES) / sample, clips)

    def sources(self):
        yield from (pathlib.Path(SAMPLES) / name for name in CLIPS)
        for name in FROM_CORPUS if CORPUS else []:
            if (pathlib.Path(CORPUS) / name).exists():
                yield pathlib.Path(CORPUS) / name

    def both(self, *words):
        """Runs both programs; what they say is returned."""
        return [self.done(program(*words, cwd=self.folder / name))
                for program, name in ((windows, "windows"), (linux, "linux"))]

    def written(self, folder):
        """All files that were made, but journals, which have times."""
        made = {}
        for file in (self.folder / folder).rglob("*.*"):
            name = file.relative_to(self.folder / folder)
            if name.parts[0] != "in" and file.is_file() and file.suffix != ".jsonl":
                made[str(name)] = contents(file)
        return made

    def same_files(self, least):
        of_windows, of_linux = self.written("windows"), self.written("linux")
        self.assertEqual(sorted(of_windows), sorted(of_linux))
        different = [name for name in of_linux if of_windows[name] != of_linux[name]]
        print(f"{len(of_linux) - len(different)} of {len(of_linux)} files equal Linux's", file=sys.stderr)
        self.assertEqual(different, [])
        self.assertGreaterEqual(len(of_linux), least)

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
        self.same_files(least=3 * compared)
        self.assertGreater(compared, 0)

    def test_of_every_method_and_option(self):
        methods = named_in_help(r"--method \S*\{(.*?)\}", "compress")
        self.assertIn("closed-loop", methods)
        codings = named_in_help(r"--coding \S*:(\S+)", "compress", "|")
        weightings = [name for name in named_in_help(r"--weighting \S*:(\S+)", "compress", "|") if name != "skin"]
        choices = [["--method", method] for method in methods]
        choices += [["--method", "standard", "--coding", coding] for coding in codings]
        choices += [["--weighting", weighting] for weighting in weightings]
        choices += [["--tiers", "3"], ["--ends", "exact"], ["--effort", "best"], ["--importance", "feet=4"],
                    ["--importance-range", "10-60=5"], ["--additive", "in/human_walk.amc"], ["--ik", "20"],
                    ["--method", "annealed", "--seed", "7", "--ik", "auto"]]
        for number, options in enumerate(choices):
            with self.subTest(options=options):
                self.both("compress", "in/human_jump.amc", "--ratio", "25", *options, "-o", f"{number}.mcpr")
        with self.subTest(options="a mesh"):
            self.both("compress", "in/character.glb", "--weighting", "skin", "--target-error", "0.3", "-o", "skin.mcpr")
        self.same_files(least=len(choices) + 1)

    def test_of_batches_in_every_format_with_reports_and_banks(self):
        presets = [preset.strip() for preset in named_in_help(r"Preset: (.*?), or a preset file", "batch")]
        self.assertIn("gameplay", presets)
        for number, preset in enumerate(presets):
            with self.subTest(preset=preset):
                self.both("batch", "in/human_walk.amc", "in/character.glb", "-o", preset, "--preset", preset, "--format",
                          "mcpr,bvh,csv,glb,fbx", "--bank", ("packed", "cooked")[number % 2])
        self.same_files(least=14 * len(presets))

    def test_of_projects(self):
        project = {"format": "mocapress-project", "version": 1, "clips": [
            {"path": "in/human_walk.amc", "verdict": "approved", "reviewer": "ana", "settings": {
                "name": "Mine", "target": {"kind": "error", "value": 0.5}}},
            {"path": "in/human_jump.amc", "notes": [{"frame": 3, "text": "lands hard"}]}]}
        for name in ("windows", "linux"):
            (self.folder / name / "hero.mocapress").write_text(json.dumps(project))
        self.both("batch", "hero.mocapress", "-o", "out")
        self.assertIn(b"in\\human_walk.amc", (self.folder / "windows/out/report.csv").read_bytes())
        self.same_files(least=5)
        self.assertIn("in/human_jump.mcpr", hashes(self.folder / "windows/out"))

    def test_of_what_is_measured(self):
        self.both("compress", "in/human_walk.amc", "--ratio", "30", "--tiers", "2", "-o", "walk.mcpr")
        self.both("contacts", "in/human_walk.amc", "-o", "walk.contacts.json")
        for words in (["info", "walk.mcpr", "--bytes", "--json"], ["info", "in/character.fbx", "--json"],
                      ["measure", "in/human_walk.amc", "walk.mcpr", "--json"],
                      ["contacts", "in/human_walk.amc", "walk.mcpr", "--json"]):
            with self.subTest(words=words):
                of_windows, of_linux = map(alike, self.both(*words))
                self.assertEqual(of_windows, of_linux)
                self.assertGreater(len(of_linux), 100)
        self.same_files(least=2)

    def test_of_what_linux_encoded_when_it_is_decoded(self):
        self.done(linux("compress", pathlib.Path(SAMPLES) / "human_walk.amc", "--ratio", "30", "-o",
                        self.folder / "walk.mcpr"))
        outputs = ("walk.csv", "walk.bvh", "walk.amc", "walk.glb", "walk.fbx")
        for output in outputs:
            self.both("decompress", self.folder / "walk.mcpr", "-o", output)
        self.same_files(least=len(outputs))

    def test_of_banks(self):
        for name in ("walk", "jump"):
            self.done(linux("compress", pathlib.Path(SAMPLES) / f"human_{name}.amc", "--ratio", "30", "--tiers", "2",
                            "-o", self.folder / f"{name}.mcpr"))
        walk, jump = self.folder / "walk.mcpr", self.folder / "jump.mcpr"
        for bank, options in (("packed.mcpk", []), ("learned.mcpk", ["--learn"]), ("cooked.mcpk", ["--cooked"]),
                              ("wide.mcpk", ["--cooked", "--detail-bands", "2"])):
            self.both("bank", "make", bank, walk, *options, "--tag", "walks", "--meta", "by=ana")
            self.both("bank", "add", bank, jump)
            of_windows, of_linux = self.both("bank", "list", bank, "--json")
            self.assertEqual(of_windows, of_linux)
            self.both("bank", "verify", bank)
        self.both("bank", "strip", "packed.mcpk", "-o", "coarse.mcpk")
        self.both("bank", "extract", "packed.mcpk", "-o", "again")
        self.both("bank", "remove", "cooked.mcpk", "walk")
        self.same_files(least=7)

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
        self.done(windows("batch", "Q:\\", "-o", "Q:\\whole"))
        self.assertEqual(list(hashes(self.folder / "whole", ["*.mcpr"])), ["walk.mcpr"])
        self.done(windows("batch", "Q:/", "-o", "Q:\\whole", "--resume"))
        self.done(windows("info", "Q:walk.amc", cwd=self.folder))
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

    def test_of_a_batch_that_are_held_are_written_when_it_is_resumed(self):
        clip, out = self.clip(), self.folder / "out"
        self.done(windows("batch", clip, "-o", out))
        report = (out / "report.csv").read_bytes()
        made = hashes(out)
        self.clip("jump.amc", "human_jump.amc")
        with subprocess.Popen([WINE, HOLD_FILE, str(out / "report.csv")], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE) as holder:
            self.assertEqual(holder.stdout.readline().strip(), b"held")
            self.refused(windows("batch", clip, self.folder / "jump.amc", "-o", out, "--resume"), 5,
                         "report.csv", "is open in another program")
        self.assertEqual((out / "report.csv").read_bytes(), report)
        self.assertIn("jump.mcpr", hashes(out))
        self.done(windows("batch", clip, self.folder / "jump.amc", "-o", out, "--resume"))
        self.assertIn(b"jump.amc", (out / "report.csv").read_bytes())
        self.assertEqual(hashes(out)["walk.mcpr"], made["walk.mcpr"])
        self.leaves_nothing()

    def test_of_banks_that_are_held_stay(self):
        self.done(linux("compress", self.clip(), "--ratio", "30", "-o", self.folder / "walk.mcpr"))
        bank = self.folder / "all.mcpk"
        self.done(windows("bank", "make", bank, self.folder / "walk.mcpr"))
        before = bank.read_bytes()
        with subprocess.Popen([WINE, HOLD_FILE, str(bank)], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as holder:
            self.assertEqual(holder.stdout.readline().strip(), b"held")
            self.done(windows("bank", "verify", bank))
            self.refused(windows("bank", "add", bank, self.folder / "walk.mcpr", "--tag", "new"), 5,
                         "is open in another program")
        self.assertEqual(bank.read_bytes(), before)
        self.done(windows("bank", "add", bank, self.folder / "walk.mcpr", "--tag", "new"))
        self.assertNotEqual(bank.read_bytes(), before)
        self.leaves_nothing()

    def test_that_are_read_only_can_be_read(self):
        clip = self.clip()
        for file in (clip, clip.with_suffix(".asf")):
            file.chmod(0o444)
        self.done(windows("compress", clip, "--ratio", "30", "-o", self.folder / "walk.mcpr"))
        self.done(windows("decompress", self.folder / "walk.mcpr", "-o", self.folder / "again.bvh"))

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
        # Background processes of a shell ignore Ctrl+C, and so would their children.
        return subprocess.Popen([WINE, PROGRAM, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))

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
