#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""rate_distortion.py CLIP PICTURE.png: plots the size of a clip against its error.

Editors that know cells ("# %%") run it cell by cell, as a notebook.
"""
# %% A motion, and an encoder that computes once what all encodings share
import sys

import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator

import mocapress

if len(sys.argv) != 3:
    sys.exit(__doc__)
source, picture = sys.argv[1:]
motion = mocapress.read(source)
encoder = mocapress.Encoder(motion)

# %% Encode it at several errors (cm) by two methods, and measure what comes out
errors = (0.05, 0.1, 0.2, 0.4, 0.8)
curves: dict[str, list[tuple[float, float]]] = {}
for method in ("closed-loop", "standard"):
    curves[method] = []
    for error in errors:
        found = encoder.encode(error=error, method=method).measurement
        curves[method].append((found["eps_x_cm"], found["motion_bytes"] / 1000))
        print(f"{method}: {found['eps_x_cm']:.3f} cm, {found['motion_bytes']} bytes, {found['ratio']:.0f}:1")

# %% Plot size against error
figure, axes = plt.subplots(figsize=(6, 4))
for method, points in curves.items():
    axes.plot(*zip(*points), marker="o", label=method)
axes.set(xscale="log", yscale="log", xlabel="mean error on the surface, cm", ylabel="motion, kB",
         title=f"{len(motion.names)} joints, {motion.seconds:.1f} s")
axes.minorticks_off()
axes.set_xticks(errors, errors)
axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
axes.yaxis.set_major_formatter("{x:g}")
axes.legend()
figure.tight_layout()
figure.savefig(picture, dpi=150)
