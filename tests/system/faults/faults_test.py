#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lets one call to the system fail at a time, and judges what commands leave behind.

Usage: faults_test.py MOCAPRESS FAILING_CALLS.so [--short] [--only COMMAND] [--kind KIND]

Every command runs undisturbed first. Then, for every kind of call and every n, it runs on a fresh copy of the same
files with the n-th call failing (see failing_calls.c). Nothing may be lost in silence:

- Exit 0: every file is byte for byte what the undisturbed run wrote, but for times that were measured; or a warning is
  said that the undisturbed run did not say.
- Another exit code: one message. Every file is the old one or the new one, whole. Journals hold all whole rows that
  they held, and the same command, resumed without a fault, writes what the undisturbed run wrote.
- No signal ends the program, and it comes to an end. No temporary file is left.

`--short` tries of each kind the first calls, the last ones and some between; the test suite runs that.
"""
import argparse
import collections
import concurrent.futures
import csv
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

EIO, ENOMEM, ENOSPC, ENOLCK = "5", "12", "28", "37"
# The ways in which calls of a kind fail.
KINDS = {
    "open": [EIO],
    "read": [EIO, "short", "interrupted"],
    "write": [ENOSPC, "short", "interrupted"],
    "sync": [EIO, "interrupted"],
    "name": [EIO],
    "stat": [EIO],
    "map": [ENOMEM],
    "lock": [EIO, ENOLCK, "interrupted"],
    "list": [EIO],
    "make": [ENOSPC],
    "memory": [ENOMEM],
}
HARMLESS = ("short", "interrupted")  # whoever calls must go on
PATIENCE_S = 120
MOST_ALLOCATIONS = 400  # tried of each command, spread evenly: there are hundreds of thousands

Command = collections.namedtuple("Command", "name prepare words again")


def walk(seed, frames=48):
    """A small BVH: five joints, one leg that swings."""
    lines = [
        "HIERARCHY", "ROOT hips", "{", "OFFSET 0 0 0",
        "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation",
        "JOINT spine", "{", "OFFSET 0 20 0", "CHANNELS 3 Zrotation Xrotation Yrotation",
        "JOINT head", "{", "OFFSET 0 40 0", "CHANNELS 3 Zrotation Xrotation Yrotation",
        "End Site", "{", "OFFSET 0 18 0", "}", "}", "}",
        "JOINT leg", "{", "OFFSET 9 0 0", "CHANNELS 3 Zrotation Xrotation Yrotation",
        "JOINT foot", "{", "OFFSET 0 -82 0", "CHANNELS 3 Zrotation Xrotation Yrotation",
        "End Site", "{", "OFFSET 0 -6 12", "}", "}", "}", "}",
        "MOTION", f"Frames: {frames}", "Frame Time: 0.0333333",
    ]
    for t in range(frames):
        swing = [((t * (3 + c) + 7 * seed) % 29 - 14) / 7 + 12 * ((t + seed) % frames) / frames for c in range(12)]
        lines.append(" ".join(f"{v:.3f}" for v in [t * 1.5, 90, 0, *swing, 0, 0, 0]))
    return "\n".join(lines) + "\n"


TIMES = ("encode_seconds", "ms_per_frame", "newest_ns", "jobs")


def key_of(row):
    """The clip, and in a study the method and target, of which a row of a journal or table is."""
    return row.get("output") or tuple(str(row.get(key)) for key in ("clip", "method", "target", "target_value", "ik_ratio"))


def last_rows(data):
    """A journal's rows, the last of each clip. What follows the last end of a line does not count, nor that a study
    could not read a clip: it tries again. The process that holds a journal is another with every run."""
    rows = {}
    for line in data.split(b"\n")[:-1]:
        row = json.loads(line)
        row.pop("run", None)
        if row.get("fingerprint") != "":
            rows[key_of(row)] = row
    return rows


def mask(name, data):
    """The bytes of a file without times that were measured; a journal's last rows in a fixed order."""
    if name.endswith(".jsonl"):
        data = b"\n".join(sorted(json.dumps(row).encode() for row in last_rows(data).values()))
    if name.endswith("rows.csv"):
        rows = list(csv.DictReader(io.StringIO(data.decode())))
        return repr([{key: value for key, value in row.items() if key not in TIMES} for row in rows]).encode()
    data = re.sub(('"(%s)": ?[0-9.e+-]+' % "|".join(TIMES)).encode(), b"TIME", data)
    return re.sub(rb"[0-9.]+ (?:ms|s)\b", b"TIME", data)


def files_in(folder):
    return {
        str(path.relative_to(folder)): mask(path.name, path.read_bytes())
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


class Bench:
    """Runs commands in copies of a folder."""

    def __init__(self, program, library, scratch):
        self.program, self.library, self.scratch = program, library, scratch

    def mocapress(self, folder, words, fault=None):
        """The exit code (negative: a signal), standard error, and how many calls of the kind were made."""
        environment = dict(os.environ, LC_ALL="C.UTF-8", SOURCE_DATE_EPOCH="0")
        count = folder.with_name(folder.name + ".count")
        if fault:
            kind, how, number, *lasting = fault
            environment.update(LD_PRELOAD=str(self.library), FAULT_UNDER=str(folder), FAULT_KIND=kind, FAULT_HOW=how,
                               FAULT_AT=str(number), FAULT_COUNT=str(count))
            if lasting:
                environment["FAULT_LASTING"] = "1"
        try:
            run = subprocess.run([self.program, *words], cwd=folder, env=environment, timeout=PATIENCE_S,
                                 stdin=subprocess.DEVNULL, capture_output=True)
        except subprocess.TimeoutExpired:
            return None, "", 0
        calls = int(count.read_text()) if count.exists() else 0
        count.unlink(missing_ok=True)
        return run.returncode, run.stderr.decode(errors="replace"), calls

    def folder(self):
        return pathlib.Path(tempfile.mkdtemp(dir=self.scratch))

    def prepared(self, command):
        folder = self.folder()
        command.prepare(self, folder)
        return folder

    def must(self, folder, words):
        code, said, _ = self.mocapress(folder, words)
        if code != 0:
            sys.exit(f"undisturbed `{' '.join(words)}`: exit {code}\n{said}")

    def clips(self, folder, count=3):
        (folder / "in").mkdir()
        for i in range(count):
            (folder / f"in/walk{i}.bvh").write_text(walk(i))
        (folder / "in/walk0.tracks.csv").write_text("smile\n" + "".join(f"{t % 7 / 7:.3f}\n" for t in range(48)))


def with_clips(bench, folder):
    bench.clips(folder)


def with_old_output(name):
    def prepare(bench, folder):
        bench.clips(folder)
        (folder / name).write_text("old\n")
    return prepare


def with_compressed(bench, folder):
    bench.clips(folder)
    for i in range(3):
        bench.must(folder, ["compress", f"in/walk{i}.bvh", "-o", f"in/walk{i}.mcpr"])


def with_bank(*options):
    def prepare(bench, folder):
        with_compressed(bench, folder)
        bench.must(folder, ["bank", "make", "bank.mcpk", "in/walk0.mcpr", "in/walk1.mcpr", *options])
    return prepare


def with_half_a_batch(bench, folder):
    bench.clips(folder)
    (folder / "in/walk2.bvh").rename(folder / "walk2.bvh")
    bench.must(folder, BATCH)
    (folder / "walk2.bvh").rename(folder / "in/walk2.bvh")


def with_half_a_study(bench, folder):
    bench.clips(folder, 2)
    bench.must(folder, [*STUDY[:2], *STUDY[3:]])


BATCH = ["batch", "in", "-o", "out", "--jobs", "1", "--format", "mcpr,bvh", "--bank", "packed"]
STUDY = ["study", "in/walk0.bvh", "in/walk1.bvh", "-o", "out", "--jobs", "1", "--methods", "standard",
         "--ratios", "10,20"]

COMMANDS = [
    Command("compress", with_old_output("a.mcpr"), ["compress", "in/walk0.bvh", "-o", "a.mcpr"], None),
    Command("decompress", with_compressed, ["decompress", "in/walk0.mcpr", "-o", "a.bvh"], None),
    Command("bank make", with_compressed, ["bank", "make", "bank.mcpk", "in"], None),
    Command("bank make --cooked", with_compressed, ["bank", "make", "bank.mcpk", "in", "--cooked"], None),
    Command("bank add", with_bank(), ["bank", "add", "bank.mcpk", "in/walk2.mcpr"], None),
    Command("bank add to cooked", with_bank("--cooked"), ["bank", "add", "bank.mcpk", "in/walk2.mcpr"], None),
    Command("bank extract", with_bank(), ["bank", "extract", "bank.mcpk", "-o", "out/deep"], None),
    Command("batch", with_clips, BATCH, [*BATCH, "--resume"]),
    Command("batch --resume", with_half_a_batch, [*BATCH, "--resume"], [*BATCH, "--resume"]),
    Command("study", with_clips, STUDY, STUDY),
    Command("study gone on with", with_half_a_study, STUDY, STUDY),
    Command("contacts", with_compressed,
            ["contacts", "in/walk0.bvh", "in/walk0.mcpr", "-o", "contacts.json"], None),
]


def rows_in(folder):
    """The clips, and in a study methods and targets, of which journals have a row, be it that they failed."""
    return {key for path in folder.rglob("*.jsonl") for key in last_rows(path.read_bytes())}


def last_line(said):
    return "".join(said.splitlines()[-1:])


class Judge:
    """Knows what a command does undisturbed, and says what is wrong with a run that was disturbed."""

    def __init__(self, bench, command):
        self.bench, self.command = bench, command
        self.start = bench.prepared(command)
        self.before = files_in(self.start)
        self.rows_before = rows_in(self.start)
        self.calls = {}
        outcomes = []
        for kind in KINDS:
            folder = self.copy()
            code, said, self.calls[kind] = bench.mocapress(folder, command.words, (kind, EIO, 0))
            outcomes.append((code, files_in(folder), said))
            shutil.rmtree(folder)
        code, self.after, self.said = outcomes[0]
        if code != 0:
            sys.exit(f"undisturbed {command.name}: exit {code}\n{self.said}")
        for _, files, _ in outcomes:
            for name in files.keys() | self.after.keys():
                if files.get(name) != self.after.get(name):
                    sys.exit(f"undisturbed {command.name} writes {name} in two ways")

    def copy(self):
        folder = self.bench.folder()
        shutil.copytree(self.start, folder, dirs_exist_ok=True, symlinks=True)  # with times of files
        return folder

    def points(self, kind, is_short):
        calls = self.calls[kind]
        if kind == "memory":
            most = 12 if is_short else MOST_ALLOCATIONS
            return sorted({1 + i * calls // most for i in range(most)}) if calls else []
        if not is_short or calls <= 6:
            return range(1, calls + 1)
        return sorted({1, 2, calls - 1, calls, *(1 + i * calls // 4 for i in range(1, 4))})

    def run(self, fault):
        """The result in a word, and the fault; empty: none."""
        folder = self.copy()
        try:
            code, said, _ = self.bench.mocapress(folder, self.command.words, fault)
            return self.judged(folder, fault, code, said)
        finally:
            shutil.rmtree(folder)

    def judged(self, folder, fault, code, said):
        if code is None:
            return "hangs", "does not end"
        if code < 0:
            return "crashes", f"ended by signal {-code}: {last_line(said)}"
        try:
            files = files_in(folder)
        except ValueError:
            return "torn", f"exit {code}, and a journal has a line that is no row"
        left = [name for name in files if ".mocapress-" in name]
        if left:
            return "litter", f"left {left}"
        different = sorted(name for name in files.keys() | self.after.keys()
                           if files.get(name) != self.after.get(name))
        warned = [line for line in said.splitlines() if line.startswith("warning: ")
                  and line not in self.said.splitlines()]
        if code == 0:
            if not different:
                return "exit 0, the same" + (", warned" if warned else ""), ""
            return "exit 0, other files", "" if warned else f"differs silently: {different}"
        if fault[1] in HARMLESS and len(fault) == 3:
            return "gave up", f"exit {code} though a call was only {fault[1]}: {last_line(said)}"
        return f"exit {code}", self.wrong_after_failure(folder, fault, files, code, said)

    def wrong_after_failure(self, folder, fault, files, code, said):
        messages = [line for line in said.splitlines() if line.startswith("mocapress: ")]
        if code != 7 and len(messages) != 1:
            return f"exit {code} with {len(messages)} messages: {last_line(said)}"
        if code == 5 and not self.command.again and files == self.after and "is written, but" not in said:
            return f"a file that is in place is called unwritten: {last_line(said)}"
        if code == 1 and fault[0] != "memory":
            return f"an internal error: {last_line(said)}"
        for name, data in files.items():
            is_report = pathlib.Path(name).name.startswith("report")
            if name.endswith(".jsonl") or (code == 7 and (is_report or name.endswith((".csv", ".json", ".html", ".mcpk")))):
                continue
            if data not in (self.before.get(name), self.after.get(name)):
                return f"{name} is neither the old file nor the new one"
        gone = sorted(self.before.keys() - files.keys())
        if gone:
            return f"{gone} are gone"
        lost = sorted(self.rows_before - rows_in(folder))
        if lost:
            return f"a journal lost {lost}"
        if not self.command.again:
            return ""
        again, said_again, _ = self.bench.mocapress(folder, self.command.again)
        resumed = files_in(folder)
        different = sorted(name for name in resumed.keys() | self.after.keys()
                           if resumed.get(name) != self.after.get(name))
        if again != 0 or different:
            return f"resumed after exit {code}: exit {again}, {different} differ; {last_line(said)}; {last_line(said_again)}"
        return ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("library", type=pathlib.Path)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--only")
    parser.add_argument("--kind")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    asked = parser.parse_args()
    wrong = []
    with tempfile.TemporaryDirectory(prefix="faults-") as scratch, \
            concurrent.futures.ThreadPoolExecutor(asked.workers) as workers:
        bench = Bench(asked.program.resolve(), asked.library.resolve(), os.path.realpath(scratch))
        for command in COMMANDS:
            if asked.only and command.name != asked.only:
                continue
            judge = Judge(bench, command)
            for kind, ways in KINDS.items():
                if asked.kind and kind != asked.kind:
                    continue
                points = judge.points(kind, asked.short)
                faults = [(kind, how, n) for how in ways for n in points]
                if not asked.short and kind not in ("memory", "lock"):
                    faults += [(kind, ways[0], n, "lasting") for n in points]
                outcomes = collections.Counter()
                for fault, (outcome, problem) in zip(faults, workers.map(judge.run, faults)):
                    outcomes[outcome] += 1
                    if problem:
                        wrong.append((command.name, fault, problem))
                        print(f"WRONG {command.name} {fault}: {problem}", flush=True)
                if faults:
                    told = ", ".join(f"{count} {outcome}" for outcome, count in sorted(outcomes.items()))
                    print(f"{command.name}: {kind}: {judge.calls[kind]} calls, {len(faults)} faults: {told}", flush=True)
            shutil.rmtree(judge.start)
    print(f"{len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
