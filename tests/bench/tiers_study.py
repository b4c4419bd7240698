#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The error of a clip's first tiers, beside a clip of as many bytes that was coded by itself.

Usage: tiers_study.py MOCAPRESS FOLDER [OPTION ...]
       compresses each .amc of the folder with the options (--target-error 0.25 without any) in three tiers
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

TIERS = 3


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 4):  # 4: a target was missed
        sys.exit(done.stderr)
    return done.stdout


def mean(ratios):
    return math.exp(sum(map(math.log, ratios)) / len(ratios))


def main(program, folder, *options):
    options = options or ("--target-error", "0.25")
    more, errors = [], [[] for _ in range(TIERS - 1)]
    print("| clip | bytes | with tiers | tier | bytes | cm RMS | by itself, cm RMS | times |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for clip in sorted(pathlib.Path(folder).glob("*.amc")):
        with tempfile.TemporaryDirectory() as temporary:
            file = temporary + "/clip.mcpr"
            run(program, "compress", clip, "-o", file, *options)
            plain = pathlib.Path(file).stat().st_size
            run(program, "compress", clip, "-o", file, "--tiers", str(TIERS), *options)
            info = json.loads(run(program, "info", "--json", file))[0]
        more.append(info["file_bytes"] / plain)
        beside = info["file_bytes"] - info["motion_bytes"]
        for t, tier in enumerate(info["tiers"][:-1]):
            size = tier["file_bytes"] - beside
            alone = json.loads(run(program, "compress", clip, "--target-size", str(size), "--json"))
            own = alone["eps_x_cm"]
            errors[t].append(tier["eps_x_cm"] / own)
            print(f"| {clip.stem} | {plain} | {info['file_bytes']} | {t + 1} | {tier['file_bytes']} "
                  f"| {tier['eps_x_cm']:.3f} | {own:.3f} | {errors[t][-1]:.2f} |", flush=True)
    print(f"\nFiles are {100 * (mean(more) - 1):.2f} % larger (geometric mean), "
          f"{100 * (max(more) - 1):.2f} % at most.")
    for t, ratios in enumerate(errors):
        print(f"Tier {t + 1} has {mean(ratios):.2f} times the error of a clip of its own bytes.")


if __name__ == "__main__":
    main(*sys.argv[1:])
