#!/usr/bin/env python3
"""How much faster mien draws than Blender's Cycles, at equal error, on the same scene.

    tests/peers/compare_with_cycles.py BUILD [--frames 4] [--reference 1024] [--json]

BUILD is a build folder with MIEN_BENCHMARKS on. Needs `blender` (3.4 or later); says that it
skipped, with exit code 77, where there is none. Either renderer is measured against its own picture
of many samples, so what their shapes differ in does not count. Run it on an idle machine.
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
    """Seconds a frame at that error, along a line through the two nearest rows (log-log)."""
    rows = sorted(rows, key=lambda row: row["error"])
    for near, far in zip(rows, rows[1:]):
        if error <= far["error"] or far is rows[-1]:
            break
    slope = (math.log(far["seconds"]) - math.log(near["seconds"])) / (
        math.log(far["error"]) - math.log(near["error"]))
    return near["seconds"] * math.exp(slope * (math.log(error) - math.log(near["error"])))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--frames", type=int, default=4)
    parser.add_argument("--reference", type=int, default=1024)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    blender = shutil.which("blender")
    if blender is None:
        print("skipped: there is no blender on this machine")
        return 77
    program = os.path.join(options.build, "tests/peers/peer_scene")
    here = os.path.dirname(os.path.abspath(__file__))
    counts = [str(options.frames), str(options.reference)]
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "scene.json")
        result = os.path.join(folder, "cycles.json")
        subprocess.run([program, "write", scene], check=True)
        ours = json.loads(subprocess.run([program, "measure", *counts], check=True,
                                         stdout=subprocess.PIPE).stdout)
        done = subprocess.run([blender, "-b", "--factory-startup", "--python-exit-code", "1",
                               "--python", os.path.join(here, "cycles_scene.py"), "--", scene,
                               result, *counts], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            sys.stderr.write(done.stdout.decode())
            return 1
        theirs = json.load(open(result))
    if options.json:
        print(json.dumps({"mien": ours, "cycles": theirs}))
        return 0
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
    return 0


if __name__ == "__main__":
    sys.exit(main())
