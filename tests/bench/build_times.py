#!/usr/bin/env python3
"""What a build spent its time on: build_times.py [build/release] [how many].

Reads ninja's log; seconds are those between start and end of each step, others beside it, so sums of
two builds compare only on a machine that did nothing else.
"""
import collections
import pathlib
import re
import sys


def steps(build):
    """Seconds of the last time that each output was made."""
    seconds = {}
    for line in (build / ".ninja_log").read_text().splitlines():
        if line.startswith("#"):
            continue
        start, end, _, output, _ = line.split("\t")
        # Outputs of files that are gone stay in the log.
        if (build / output).exists():
            seconds[output] = (int(end) - int(start)) / 1000
    return seconds


def room(output):
    """motion/CMakeFiles/mien_motion.dir/Unity/unity_room_gait_1_cxx.cxx.o -> motion/gait."""
    parts = re.match(r"(\w+)/CMakeFiles/mien_(\w+)\.dir/(.*)", output)
    if not parts:
        return "other"
    tested = parts[2].removesuffix("_tests")
    module = f"tests/{tested}" if parts[1] == "tests" else parts[1]
    united = re.match(r"Unity/unity_room_(\w+?)_\d+_cxx", parts[3])
    folder = united[1].removeprefix(f"{tested}_") if united else str(pathlib.PurePosixPath(parts[3]).parent)
    return f"{module}/{folder.removeprefix(f'{tested}/')}".removesuffix("/.")


def main():
    build = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build/release")
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    seconds = steps(build)
    print(f"{sum(seconds.values()):8.1f} s in {len(seconds)} steps; the slowest:")
    for output in sorted(seconds, key=seconds.get, reverse=True)[:count]:
        print(f"{seconds[output]:8.1f} {output}")
    rooms = collections.Counter()
    for output, spent in seconds.items():
        rooms[room(output)] += spent
    print("by room:")
    for name, spent in rooms.most_common():
        print(f"{spent:8.1f} {name}")


if __name__ == "__main__":
    main()
