#!/usr/bin/env python3
"""How soon the command line answers: start_times.py [build/release/mien] [runs].

Medians of wall and processor milliseconds of commands that draw nothing, and how many shared libraries
each loads. From the repository's folder.
"""
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time


def processor_seconds():
    """Of all commands that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def timed(command):
    """Wall and processor milliseconds of one run."""
    before, start = processor_seconds(), time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    wall = time.perf_counter() - start
    return 1000 * wall, 1000 * (processor_seconds() - before)


def libraries(command):
    """How many shared libraries were initialised."""
    told = subprocess.run(command, check=True, env={**os.environ, "LD_DEBUG": "files"}, text=True,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE).stderr
    return told.count("calling init:")


def main():
    mien = str(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build/release/mien").resolve())
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    with tempfile.TemporaryDirectory() as folder:
        motion = f"{folder}/sad.bvh"
        subprocess.run([mien, "motion", "blend", "--examples", "builtin:walks-10", "--weights", "sad=1",
                        "-o", motion], check=True, stdout=subprocess.DEVNULL)
        manifest = "manifests/quickstart.yaml"
        print("wall ms  processor ms  libraries")
        for words in (["version"], ["check", manifest], ["plan", manifest], ["motion", "info", motion]):
            times = [timed([mien, *words]) for _ in range(runs)]
            wall, spent = (statistics.median(column) for column in zip(*times))
            name = " ".join(pathlib.PurePath(word).name for word in words)
            print(f"{wall:7.0f}  {spent:12.0f}  {libraries([mien, *words]):9}  mien {name}")


main()
