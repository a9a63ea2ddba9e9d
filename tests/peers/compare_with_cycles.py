#!/usr/bin/env python3
"""How much faster mien draws than Blender's Cycles, at equal error, on the same scene, and whether the
two draw the same light.

    tests/peers/compare_with_cycles.py BUILD [--frames 4] [--reference 1024] [--json] [--agreement]

BUILD is a build folder with MIEN_BENCHMARKS on. Needs `blender` (3.4 or later); says that it
skipped, with exit code 77, where there is none. Either renderer is measured against its own picture
of many samples, so what their shapes differ in does not count. Run it on an idle machine.

Means of blocks of 16 x 16 pixels away from edges have to agree within 0.5 %, else the exit code is 1.
--agreement checks nothing else, and may run on a busy machine.
"""

import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile


def seconds_for(rows, error):
    """Seconds a frame at that error, along a line through the two nearest rows (log-log). No frame
    takes less than one of a draft (two samples), however large the error may be."""
    rows = sorted(rows, key=lambda row: row["error"])
    if error >= rows[-1]["error"]:
        return rows[-1]["seconds"]
    for near, far in zip(rows, rows[1:]):
        if error <= far["error"] or far is rows[-1]:
            break
    slope = (math.log(far["seconds"]) - math.log(near["seconds"])) / (
        math.log(far["error"]) - math.log(near["error"]))
    return near["seconds"] * math.exp(slope * (math.log(error) - math.log(near["error"])))


BLOCK = 16
MARGIN = 3  # pixels: edges reach so far by the filter
LARGEST_DIFFERENCE = 0.005


def disagreement(ours_file, theirs_file):
    """Of the blocks away from edges, on the floor and on the figure: how many, and how far the means of
    their luminances differ, as shares: root mean square, and the largest."""
    import numpy  # comes with Blender
    beauty, albedo, normal = numpy.fromfile(ours_file, dtype=numpy.float32).reshape(3, 720, 1280, 3)
    theirs = numpy.load(theirs_file)
    found = {"floor": [], "figure": []}
    for y in range(BLOCK, 720 - 2 * BLOCK, BLOCK):
        for x in range(BLOCK, 1280 - 2 * BLOCK, BLOCK):
            around = (slice(y - MARGIN, y + BLOCK + MARGIN), slice(x - MARGIN, x + BLOCK + MARGIN))
            if numpy.ptp(albedo[around], axis=(0, 1)).max() > 1e-4 or albedo[y, x].max() == 0.0:
                continue
            steps = max(numpy.abs(numpy.diff(normal[around], axis=axis)).max() for axis in (0, 1))
            if steps > 0.25:  # where two limbs meet
                continue
            inside = (slice(y, y + BLOCK), slice(x, x + BLOCK))
            mean = theirs[inside].mean()
            name = "figure" if numpy.ptp(albedo[y, x]) > 0.01 else "floor"
            found[name].append(float(beauty[inside].mean() / mean - 1.0))
    return {name: {"blocks": len(shares),
                   "rms": math.sqrt(sum(s * s for s in shares) / max(len(shares), 1)),
                   "largest": max((abs(s) for s in shares), default=0.0)}
            for name, shares in found.items()}


def report_agreement(agreement):
    """Prints it; whether the renderers agree."""
    print("\nblocks of 16 x 16 away from edges, mien by Cycles")
    for name, row in agreement.items():
        print(f"  {name:7s} {row['blocks']:5d} blocks, differ by {100 * row['rms']:.3f} % (RMS), "
              f"{100 * row['largest']:.3f} % at most")
    agree = agreement["floor"]["blocks"] > 0 and all(
        row["largest"] <= LARGEST_DIFFERENCE for row in agreement.values())
    print("  they agree" if agree else f"  they differ by more than {100 * LARGEST_DIFFERENCE} %")
    return agree


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--frames", type=int, default=4)
    parser.add_argument("--reference", type=int, default=1024)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--agreement", action="store_true")
    options = parser.parse_args()
    blender = shutil.which("blender")
    if blender is None:
        print("skipped: there is no blender on this machine")
        return 77
    program = os.path.join(options.build, "tests/peers/peer_scene")
    here = os.path.dirname(os.path.abspath(__file__))
    frames = 0 if options.agreement else options.frames
    counts = [str(frames), str(options.reference)]
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "scene.json")
        result = os.path.join(folder, "cycles.json")
        picture = os.path.join(folder, "mien.floats")
        their_picture = os.path.join(folder, "cycles.npy")
        subprocess.run([program, "write", scene], check=True)
        subprocess.run([program, "picture", str(max(frames - 1, 0)), str(options.reference), picture],
                       check=True)
        ours = None
        if not options.agreement:
            ours = json.loads(subprocess.run([program, "measure", *counts], check=True,
                                             stdout=subprocess.PIPE).stdout)
        done = subprocess.run([blender, "-b", "--factory-startup", "--python-exit-code", "1",
                               "--python", os.path.join(here, "cycles_scene.py"), "--", scene,
                               result, *counts, their_picture], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            sys.stderr.write(done.stdout.decode())
            return 1
        theirs = json.load(open(result))
        agreement = disagreement(picture, their_picture)
    if options.json:
        print(json.dumps({"mien": ours, "cycles": theirs, "agreement": agreement}))
        return 0
    if options.agreement:
        return 0 if report_agreement(agreement) else 1
    print(f"Blender {theirs['version']}, {os.cpu_count()} processors, 1280 x 720")
    for way in ("standing", "moving"):
        print(f"\ncamera {way}\n  Cycles  samples  s/frame  RMS error   mien s/frame   ratio")
        for row in theirs[way]:
            mine = seconds_for(ours[way], row["error"])
            print(f"          {row['samples']:7d}  {row['seconds']:7.3f}  {row['error']:9.5f}"
                  f"   {mine:12.4f}  {row['seconds'] / mine:6.0f}")
        print("  mien    samples  s/frame  RMS error")
        for row in ours[way]:
            print(f"          {row['samples']:7d}  {row['seconds']:7.4f}  {row['error']:9.5f}")
    return 0 if report_agreement(agreement) else 1


if __name__ == "__main__":
    sys.exit(main())
