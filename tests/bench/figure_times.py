#!/usr/bin/env python3
"""Whole commands that make a film of each kind of figure:
figure_times.py [--runs 3] [--qualities draft,standard] [--figures stick,mannequin,FILE] [--triangles 30000]
                [--shutter 180] [MIEN ...]

Frames per second and processor milliseconds per frame of `mien render`, 1280 x 720, of a walk of about
190 frames: the median of the runs. With several programs (from before and after a change) the runs
alternate between them, and the last line of each figure gives the times of the first program divided by
those of the last. From the repository's folder; program: build/release/mien.
"""
import argparse
import pathlib
import resource
import statistics
import subprocess
import tempfile
import time

from subdivided_character import write_subdivided


def processor_seconds():
    """Of all commands that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def timed(command):
    """Wall and processor seconds of one run, and the last line that it prints."""
    before, start = processor_seconds(), time.perf_counter()
    printed = subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL).stdout
    return time.perf_counter() - start, processor_seconds() - before, printed.strip().splitlines()[-1]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("programs", nargs="*", default=["build/release/mien"])
    options.add_argument("--runs", type=int, default=3)
    options.add_argument("--qualities", default="draft,standard")
    options.add_argument("--figures", default="stick,mannequin")
    options.add_argument("--triangles", type=int, help="subdivide characters (.gltf) to so many triangles")
    options.add_argument("--shutter", default="0", help="motion blur, degrees")
    given = options.parse_args()
    programs = [str(pathlib.Path(program).resolve()) for program in given.programs]
    with tempfile.TemporaryDirectory() as folder:
        motion, film = f"{folder}/walk.bvh", f"{folder}/walk.mp4"
        subprocess.run([programs[0], "motion", "blend", "--examples", "builtin:walks-10", "--weights",
                        "normal=1", "--cycles", "6", "-o", motion], check=True, stdout=subprocess.DEVNULL)
        print("quality   figure                 program  frames/s  processor ms/frame")
        for quality in given.qualities.split(","):
            for figure in given.figures.split(","):
                name = pathlib.PurePath(figure).name
                if given.triangles and pathlib.Path(figure).exists():
                    larger = f"{folder}/{name}"
                    write_subdivided(figure, given.triangles, larger)
                    figure = larger
                times = [[] for _ in programs]
                for _ in range(given.runs):
                    for number, program in enumerate(programs):
                        wall, spent, line = timed([program, "render", motion, "-o", film, "--size", "1280x720",
                                                   "--quality", quality, "--figure", figure,
                                                   "--shutter", given.shutter])
                        frames = int(line.split(": ")[1].split(" frames")[0])
                        times[number].append((wall, spent))
                medians = [[statistics.median(column) for column in zip(*runs)] for runs in times]
                for number, (wall, spent) in enumerate(medians):
                    print(f"{quality:9} {name:22} {number + 1:7}  {frames / wall:8.1f}  {1000 * spent / frames:18.1f}")
                if len(medians) > 1:
                    first, last = medians[0], medians[-1]
                    print(f"{quality:9} {name:22}   ratio  {first[0] / last[0]:8.2f}  {first[1] / last[1]:18.2f}")


main()
