#!/usr/bin/env python3
"""What more processors bring: cores_bench.py [build/release/mien] [--threads 1,2] [--quality draft] …

Makes one long film, then many short ones, on so many processors each, in a temporary folder. Tells the
frames a second of a whole run, start, pictures, encoding and checks included; how many times that is
what one processor makes; what share of the work is not done side by side, by Amdahl's law; processor
time a frame, which grows where threads get in each other's way; and the run's memory. From the
repository's folder, on a machine that does nothing else.
"""
import argparse
import csv
import os
import pathlib
import subprocess
import tempfile
import time

HEAD = """mien: 1
study: cores
seed: 7
examples: {{set: builtin:walks-10, ratings: builtin}}
look: {{scene: studio, figure: stick, camera: three-quarter}}
output: {{size: [{size}], fps: 30, cycles: {cycles}, quality: {quality}, video: [mp4], frames: none}}
stimuli:
"""


def manifest(options, films, cycles):
    text = HEAD.format(size=options.size, quality=options.quality, cycles=cycles)
    for film in range(films):
        text += f"  - {{id: film-{film}, adjectives: {{quickness: {0.4 + 0.3 * film / films:.3f}}}}}\n"
    return text


def run(options, threads, films, cycles):
    """Frames, seconds, CPU seconds and megabytes of a run."""
    with tempfile.TemporaryDirectory() as folder:
        study = pathlib.Path(folder, "cores.yaml")
        study.write_text(manifest(options, films, cycles), encoding="utf-8")
        command = ["taskset", "--cpu-list", f"0-{threads - 1}", os.path.abspath(options.mien), "run",
                   study, "--out", folder, "--jobs", str(threads)]
        start = time.perf_counter()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            raise SystemExit("the run failed")
        with open(pathlib.Path(folder, "cores/metrics/videos.csv"), encoding="utf-8") as table:
            frames = sum(int(row["frames"]) for row in csv.DictReader(table))
    return frames, seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def serial_share(threads, times):
    """What Amdahl's law makes of a run that is so many times as fast on so many processors."""
    return (threads / times - 1) / (threads - 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("mien", nargs="?", default="build/release/mien")
    parser.add_argument("--threads", help="numbers of processors; 1, 2, 4 … 16 or all without")
    parser.add_argument("--quality", default="draft")
    parser.add_argument("--size", default="1280, 720")
    parser.add_argument("--films", type=int, default=16)
    options = parser.parse_args()
    here = len(os.sched_getaffinity(0))
    counts = ([int(word) for word in options.threads.split(",")] if options.threads
              else [n for n in (1, 2, 4, 8, 16) if n <= here])
    print(f"{options.size}, {options.quality}, {here} processors")
    for name, films, cycles in (("one long film", 1, options.films), ("short films", options.films, 1)):
        print(f"{name:14}  threads  frames/s  times  serial        CPU ms/frame    MB")
        alone = None
        for threads in counts:
            frames, seconds, spent, memory = run(options, threads, films, cycles)
            rate = frames / seconds
            alone = alone or rate
            share = f"{100 * serial_share(threads, rate / alone):4.0f} %" if threads > 1 else "      "
            print(f"{frames:7} frames  {threads:7}  {rate:8.1f}  {rate / alone:5.2f}  {share}"
                  f"  {1000 * spent / frames:18.1f}  {memory:4.0f}")


main()
