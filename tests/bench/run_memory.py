#!/usr/bin/env python3
"""How much memory a run takes: run_memory.py [build/release/mien] [--films N] [--video KIND] …

Makes a study of many short films in a temporary folder and prints the most memory that the program and
what it started had at one time. From the repository's folder.
"""
import argparse
import os
import pathlib
import re
import subprocess
import tempfile
import threading
import time

HEAD = """mien: 1
study: memory
seed: 7
examples: {{set: builtin:walks-10, ratings: builtin}}
look: {{scene: studio, figure: {figure}, camera: three-quarter}}
output: {{size: [{size}], fps: {fps}, cycles: 1, quality: {quality}, video: [{video}]}}
stimuli:
"""


def manifest(options):
    """Films of walks that all differ, each from a camera of its own."""
    text = HEAD.format(**vars(options))
    for film in range(options.films):
        share = film / options.films
        text += (f"  - {{id: film-{film}, adjectives: {{quickness: {0.3 + 0.4 * (7 * share % 1):.3f}, "
                 f"largeness: {0.3 + 0.4 * share:.3f}}}}}\n")
    return text


def kilobytes(process, word):
    """What the system tells of a process under that word; 0 when it has ended."""
    try:
        told = pathlib.Path(f"/proc/{process}/status").read_text()
    except OSError:
        return 0
    found = re.search(rf"^{word}:\s+(\d+)", told, re.MULTILINE)
    return int(found[1]) if found else 0


def with_descendants(process):
    """The process and all that it started."""
    family = [process]
    for member in family:
        for tasks in pathlib.Path(f"/proc/{member}/task").glob("*/children"):
            try:
                family += [int(child) for child in tasks.read_text().split()]
            except OSError:
                pass
    return family


class Watch(threading.Thread):
    """Adds up what a process and its descendants have in memory, until it ends."""

    def __init__(self, process):
        super().__init__()
        self.process, self.most = process, 0

    def run(self):
        while self.process.poll() is None:
            family = with_descendants(self.process.pid)
            sizes = [kilobytes(member, "VmRSS") for member in family]
            # One alone: the system knows its peak, which may lie between two looks.
            self.most = max(self.most, sum(sizes), kilobytes(self.process.pid, "VmHWM"))
            time.sleep(0.02)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("mien", nargs="?", default="build/release/mien")
    parser.add_argument("--films", type=int, default=100)
    parser.add_argument("--jobs", default="2")
    parser.add_argument("--video", default="mp4", help="kind, mkv is FFV1")
    parser.add_argument("--figure", default="stick")
    parser.add_argument("--quality", default="standard")
    parser.add_argument("--size", default="1920, 1080")
    parser.add_argument("--fps", default="10", help="a film of 10 has 8 to 13 frames")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        study = pathlib.Path(folder, "memory.yaml")
        study.write_text(manifest(options), encoding="utf-8")
        start = time.perf_counter()
        command = [os.path.abspath(options.mien), "run", study, "--out", folder, "--jobs", options.jobs]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            watch = Watch(process)
            watch.start()
            watch.join()
        if process.returncode != 0:
            raise SystemExit("the run failed")
        frames = len(list(pathlib.Path(folder, "memory/frames").glob("*/*.png")))
        print(f"{options.films} films, {frames} frames of {options.size.replace(', ', ' x ')} in {options.video}: "
              f"{watch.most / 1024:.0f} MB at most, {time.perf_counter() - start:.0f} s")


main()
