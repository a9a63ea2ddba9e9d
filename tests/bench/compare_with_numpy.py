#!/usr/bin/env python3
"""How fast .npz files are read beside numpy.load: compare_with_numpy.py [read_recordings_bench].

Saves the rotations of a long recording with NumPy in AMASS' layout, stored and deflated, reads all
arrays with numpy.load and with mien, in turn, and prints processor milliseconds and their ratios:
above 1, mien is faster. "Arrays" is the same work as NumPy's; "motion" also turns them into the poses
of a skeleton. From the repository's folder.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy

ROUNDS = 5


def numpy_milliseconds(file):
    """Processor time of numpy.load with all arrays."""
    start = time.process_time()
    with numpy.load(file) as archive:
        arrays = {name: archive[name] for name in archive}
    assert arrays["poses"].shape[1] == 156
    return 1000 * (time.process_time() - start)


def mien_milliseconds(bench, file):
    """Processor time of the motion and of the arrays alone."""
    told = subprocess.run([bench, f"--benchmark_filter=^{file}", "--benchmark_format=json",
                           "--benchmark_min_time=0.2", file], check=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True).stdout
    motion, arrays = json.loads(told)["benchmarks"]
    return motion["cpu_time"], arrays["cpu_time"]


def main():
    bench = sys.argv[1] if len(sys.argv) > 1 else "build/release/tests/bench/read_recordings_bench"
    frames = 16_000
    waves = 0.6 * numpy.sin(0.013 * numpy.arange(frames * 156)).reshape(frames, 156)
    arrays = {"poses": waves, "trans": waves[:, :3].copy(), "betas": numpy.zeros(16),
              "mocap_framerate": numpy.array(120.0)}
    with tempfile.TemporaryDirectory() as folder:
        for save in (numpy.savez, numpy.savez_compressed):
            file = str(pathlib.Path(folder, save.__name__ + ".npz"))
            save(file, **arrays)
            theirs, motion, ours = [], [], []
            for _ in range(ROUNDS):
                theirs.append(min(numpy_milliseconds(file) for _ in range(3)))
                whole, alone = mien_milliseconds(bench, file)
                motion.append(whole)
                ours.append(alone)
            best = min(theirs)
            print(f"{save.__name__:16} numpy.load {best:6.1f} ms   "
                  f"arrays {min(ours):6.1f} ms ({best / min(ours):.2f})   "
                  f"motion {min(motion):6.1f} ms ({best / min(motion):.2f})")


main()
