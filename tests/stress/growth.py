#!/usr/bin/env python3
"""Growth of noise, as a section of docs/stability.md:  growth.py CAPSELLA SCENE FOLDER

Each scene runs twice, from the sphere and from the sphere with noise of 1e-7; what stands in the table is the root mean
square over the nodes of the difference between the two, over that at the start.  Both runs sum in double precision
throughout and use no symmetry, so that nothing but the noise tells them apart.  Needs h5py.
"""
import math
import subprocess
import sys

import h5py

capsella, scene, folder = sys.argv[1:]
NOISE = 1e-7
TIMES = [0.5, 1.0, 1.5, 2.0]
CASES = [(Ca, subdivisions, axis) for Ca, axis in [(0.1, 1), (0.3, 1), (0.5, 1), (1.0, 1), (0.3, 1.1)]
         for subdivisions in (1, 2, 3)]


def positions(Ca, subdivisions, axis, noise):
    """Nodes at t = 0 and at TIMES."""
    name = f"{folder}/growth_{noise}"
    sets = {"flow.capillary_number": Ca, "capsule.mesh.subdivisions": subdivisions, "time.end": TIMES[-1],
            "start.axes": [axis] * 3, "start.noise": noise, "output.snapshot_every": 0.5, "fluid.coarse_stages": "false",
            "symmetry": "off"}
    command = [capsella, "run", scene, "--quiet", "--threads", "1", "-o", name]
    for key, value in sets.items():
        command += ["--set", f"{key}={value}"]
    subprocess.run(command, check=True)
    nodes = []
    for t in [0.0] + TIMES:
        with h5py.File(f"{name}/snapshot_{round(t / 0.5):06d}.vtkhdf") as file:
            nodes.append(file["VTKHDF/Points"][:])
    return nodes


def distance(x, y):
    return math.sqrt(((x - y) ** 2).sum() / len(x))


print("""
## Growth of noise

How noise of 1e-7 at the start has grown by a time (root mean square over the nodes), and the mean rate of its growth up
to t = 1, ln(growth)/t.  A membrane that is compressed lets noise grow; one that is inflated by 10 % is tense all over and
does not.

| Ca | start | elements |""" + "".join(f" t = {t:g} |" for t in TIMES) + " rate |")
print("|---|---|---|" + "---|" * (len(TIMES) + 1))
for Ca, subdivisions, axis in CASES:
    clean, noisy = (positions(Ca, subdivisions, axis, noise) for noise in (0, NOISE))
    apart = [distance(x, y) for x, y in zip(clean, noisy)]
    growth = [a / apart[0] for a in apart]
    rate = math.log(growth[2]) / TIMES[1]
    start = "at rest" if axis == 1 else f"inflated by {100 * (axis - 1):.0f} %"
    print(f"| {Ca:g} | {start} | {20 * 4 ** subdivisions} |" + "".join(f" {g:.2g} |" for g in growth[1:])
          + f" {rate:.1f} |", flush=True)
