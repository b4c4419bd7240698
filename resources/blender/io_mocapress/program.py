# SPDX-License-Identifier: GPL-3.0-or-later
"""The program `mocapress`: where it is, and running it without waiting blindly."""
import os
import shutil
import subprocess
import time

import bpy

PLACES = ("/usr/bin", "/usr/local/bin", "/opt/homebrew/bin")


class Failure(Exception):
    """One sentence for the user."""


def settings():
    return bpy.context.preferences.addons[__package__].preferences


def find():
    """The path of the program; Failure where there is none."""
    chosen = settings().program
    if chosen:
        path = shutil.which(bpy.path.abspath(chosen))
    else:
        path = shutil.which("mocapress") or shutil.which("mocapress", path=os.pathsep.join(PLACES))
    if path:
        return path
    lost = f"There is no program at {chosen}" if chosen else "The program mocapress was not found"
    raise Failure(f"{lost}: install Mocapress, or set where it is in Edit > Preferences > Add-ons > "
                  "Import-Export: Mocapress")


def run(arguments, folder, warnings):
    """Runs the program, and yields each line that it prints, or "" every 50 ms until it does.

    The process ends with this generator. Failure has the program's own sentence; `warnings` gets
    those that it does not stop at. What it prints is kept in `folder` meanwhile."""
    path = find()
    seconds = settings().timeout
    out = os.path.join(folder, "out.txt")
    errors = os.path.join(folder, "errors.txt")
    with open(out, "wb") as to_out, open(errors, "wb") as to_errors:
        try:
            process = subprocess.Popen(
                [path, *arguments], stdin=subprocess.DEVNULL, stdout=to_out, stderr=to_errors,
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0))
        except OSError as error:
            raise Failure(f"{path} does not start: {error.strerror}") from error
    deadline = time.monotonic() + seconds
    try:
        with open(out, "rb") as lines:
            running = True
            begun = b""
            while running:
                try:
                    process.wait(0.05)
                    running = False
                except subprocess.TimeoutExpired:
                    if time.monotonic() > deadline:
                        raise Failure(f"mocapress took longer than {seconds} s and was stopped: "
                                      "the add-on's preferences say how long it may") from None
                *whole, begun = (begun + lines.read()).split(b"\n")
                yield from (line.decode("utf-8", "replace") for line in whole or [b""])
    finally:
        process.kill()
        process.wait()
    with open(errors, encoding="utf-8", errors="replace") as lines:
        said = [line.strip() for line in lines if line.strip()]
    warnings.extend(line[len("warning: "):] for line in said if line.startswith("warning: "))
    if process.returncode != 0:
        raise Failure(sentence(said) or f"mocapress stopped with exit code {process.returncode}")


def sentence(said):
    """The program's message: the last line of its error output that is no warning."""
    last = next((line for line in reversed(said) if not line.startswith("warning: ")), "")
    return last[len("mocapress: "):] if last.startswith("mocapress: ") else last
