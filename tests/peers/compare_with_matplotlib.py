#!/usr/bin/env python3
"""Frames per second of `mien render --quality draft` and of matplotlib's 3-D line animation.

    tests/peers/compare_with_matplotlib.py MIEN [--frames 96]

MIEN is the program. Both make a 1280 x 720 H.264 video of the same skeleton, encoding included.
Needs matplotlib and ffmpeg; says that it skipped, with exit code 77, without. Run it on an idle
machine.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mien")
    parser.add_argument("--frames", type=int, default=96)
    options = parser.parse_args()
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import animation, pyplot
        import numpy
    except ImportError:
        print("skipped: there is no matplotlib on this machine")
        return 77
    if shutil.which("ffmpeg") is None:
        print("skipped: there is no ffmpeg on this machine")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        walk = os.path.join(folder, "walk.bvh")
        cycles = max(1, round(options.frames / 32))
        subprocess.run([options.mien, "motion", "blend", "--examples", "builtin:walks-10",
                        "--weights", "normal=1", "--cycles", str(cycles), "-o", walk], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        frames = sum(1 for _ in open(walk)) - next(
            i for i, line in enumerate(open(walk)) if line.startswith("Frame Time")) - 1
        start = time.perf_counter()
        subprocess.run([options.mien, "render", walk, "-o", os.path.join(folder, "mien.mp4"),
                        "--size", "1280x720", "--quality", "draft"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        ours = frames / (time.perf_counter() - start)

        # 22 joints that swing: what is drawn does not matter to the time that drawing takes.
        count = 22
        times = numpy.arange(frames) / 30.0
        phase = numpy.arange(count)
        x = 0.3 * numpy.sin(times[:, None] * 6.0 + phase)
        y = 0.3 * numpy.cos(times[:, None] * 6.0 + phase)
        z = numpy.broadcast_to(phase / count * 1.7, x.shape)
        start = time.perf_counter()
        figure = pyplot.figure(figsize=(12.8, 7.2), dpi=100)
        axes = figure.add_subplot(projection="3d")
        axes.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(0, 2))
        lines = [axes.plot([], [], [], "-o")[0] for _ in range(count - 1)]

        def draw(frame):
            for j, line in enumerate(lines):
                line.set_data(x[frame, j:j + 2], y[frame, j:j + 2])
                line.set_3d_properties(z[frame, j:j + 2])
            return lines

        film = animation.FuncAnimation(figure, draw, frames=frames)
        film.save(os.path.join(folder, "lines.mp4"), writer="ffmpeg", fps=30)
        theirs = frames / (time.perf_counter() - start)
    print(f"mien draft {ours:.1f} frames/s, matplotlib {matplotlib.__version__} {theirs:.1f} "
          f"frames/s, ratio {ours / theirs:.1f} ({frames} frames, {os.cpu_count()} processors)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
