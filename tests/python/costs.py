# SPDX-License-Identifier: MIT
"""Prints the table of the README: what an import and copies cost.

Usage: PYTHONPATH=build/dev/core/mocapress/python /usr/bin/python3 tests/python/costs.py
"""
import time

FRAMES, JOINTS = 20000, 60


def least(call, times=5):
    """Milliseconds of processor time, of all threads together."""
    spent = []
    for _ in range(times):
        begun = time.process_time()
        call()
        spent.append(time.process_time() - begun)
    return 1000 * min(spent)


def import_both():
    begun = time.process_time()
    import mocapress
    between = time.process_time()
    import numpy
    ended = time.process_time()
    print(f"| `import mocapress` | {1000 * (between - begun):.0f} ms |")
    print(f"| `import numpy`, which the first array does | {1000 * (ended - between):.0f} ms |")
    return mocapress, numpy


def main():
    mocapress, np = import_both()
    names = [f"joint {index}" for index in range(JOINTS)]
    given = names, list(range(-1, JOINTS - 1)), np.ones((JOINTS, 3)), np.tile(
        [1.0, 0, 0, 0], (FRAMES, JOINTS, 1))
    motion = mocapress.Motion.from_numpy(*given, rate=60)
    channels = motion.channels
    in_c_order = np.ascontiguousarray(channels)
    print(f"| `motion.channels`, {channels.nbytes / 1e6:.0f} MB | "
          f"{least(lambda: [motion.channels for _ in range(1000)]) / 1000:.4f} ms |")
    for what, call in (
            ("`motion.channels.copy()`, for comparison", lambda: channels.copy(order="F")),
            ("`motion.with_channels(motion.channels)`", lambda: motion.with_channels(channels)),
            ("the same in C order", lambda: motion.with_channels(in_c_order)),
            ("`Motion.from_numpy()`", lambda: mocapress.Motion.from_numpy(*given, rate=60)),
            ("`motion.local_rotations()`", motion.local_rotations),
            ("`motion.world_positions()`", motion.world_positions)):
        print(f"| {what} | {least(call):.0f} ms |")


main()
