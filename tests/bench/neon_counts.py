#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Instructions of a pose beside ACL's at equal shell RMS: by NEON on aarch64, and by SSE2.

Qemu logs a line for each instruction. More poses less a few give the instructions of a pose.
Usage: neon_counts.py MOCAPRESS_PEER_STUDY CORPUS/study PEERS
       PEERS: where the headers of ACL and RTM are
"""
import concurrent.futures
import math
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MACHINES = {"NEON": ["aarch64-linux-gnu-g++", "qemu-aarch64", "-cpu", "cortex-a72"],
            "SSE2": ["g++", "qemu-x86_64", "-cpu", "Nehalem"]}
FEW, MANY = 20, 220  # poses


def build(folder, peers):
    """The program for each machine. The runtime is compiled without contraction, as always."""
    joined = folder / "runtime"
    commands = [["cmake", "-S", ROOT / "core/runtime", "-B", folder],
                ["cmake", "--build", folder, "--target", "mocapress-joined-runtime"]]
    for machine, (compiler, *_) in MACHINES.items():
        common = [compiler, "-std=c++20", "-O2", "-I", ROOT, "-isystem", joined]
        commands += [
            [*common, "-ffp-contract=off", "-fno-exceptions", "-fno-rtti",
             "-c", joined / "mocapress_runtime.cpp", "-o", folder / "runtime.o"],
            [*common, "-static", "-isystem", f"{peers}/acl", "-isystem", f"{peers}/rtm",
             ROOT / "tests/bench/pose_counts.cpp", folder / "runtime.o", "-o", folder / machine]]
    for command in commands:
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def run(machine, folder, *arguments):
    """The number of instructions, and the sum that the program prints."""
    command = [*MACHINES[machine][1:], "-singlestep", "-d", "exec,nochain", "-D", "/dev/stderr",
               folder / machine, *map(str, arguments)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as program:
        parts = iter(lambda: program.stderr.read(1 << 20), b"")
        count = sum(part.count(b"\n") for part in parts)
        total = program.stdout.read()
    if program.returncode != 0:
        sys.exit(f"{machine}: pose_counts failed on {arguments[0]}")
    return count, float(total)


def of_a_pose(folder, clip, motion):
    """Instructions on each machine, all of which must decode the same pose."""
    counts, sums = {}, []
    for machine in MACHINES:
        few, _ = run(machine, folder, clip, motion, FEW)
        many, total = run(machine, folder, clip, motion, MANY)
        counts[machine] = (many - few) / (MANY - FEW)
        sums.append(total)
    if max(sums) - min(sums) > 1e-3:
        sys.exit(f"{clip}: other poses on another machine")
    return counts


def share(ours, theirs):
    """The geometric mean, and the worst clip's."""
    shares = [a / b for a, b in zip(ours, theirs)]
    return f"{math.exp(sum(map(math.log, shares)) / len(shares)):.3f} ({max(shares):.2f})"


def main(study, clips, peers):
    processors = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    with tempfile.TemporaryDirectory() as temporary, processors:
        folder = pathlib.Path(temporary)
        subprocess.run([study, clips, "--write", folder], check=True)
        build(folder, peers)
        theirs = sorted(folder.glob("*.acl"))
        counts = {(form, motion): list(processors.map(
                      lambda clip: of_a_pose(folder, clip.with_suffix(form), motion), theirs))
                  for form in (".acl", ".cooked", ".two_bands") for motion in ("random", "play")}
        print(f"Of ACL's instructions a pose, {len(theirs)} clips: geometric mean (worst clip)\n"
              f"| | {' | '.join(MACHINES)} |\n| --- |{' --- |' * len(MACHINES)}")
        for (form, motion), ours in counts.items():
            if form != ".acl":
                cells = [share([clip[machine] for clip in ours],
                               [clip[machine] for clip in counts[".acl", motion]])
                         for machine in MACHINES]
                print(f"| {motion}, {form[1:]} | {' | '.join(cells)} |")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
