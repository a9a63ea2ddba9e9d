#!/usr/bin/env python3
"""How much faster mien draws than Blender's Cycles, at equal error, on the same scene, and whether the
two draw the same light.

    tests/peers/compare_with_cycles.py BUILD [--figure sticks|mannequin|flat-mannequin]
        [--frames 4] [--reference 1024] [--json] [--agreement [--close-up]] [--sheen]

BUILD is a build folder with MIEN_BENCHMARKS on. Needs `blender` (3.4 or later); says that it
skipped, with exit code 77, where there is none. Either renderer is measured against its own picture
of many samples, so what their shapes differ in does not count. Run it on an idle machine.

Means of blocks of 16 x 16 pixels away from edges have to agree within 0.5 %, from afar and near, else
the exit code is 1. --agreement checks nothing else, and may run on a busy machine; with --close-up
only where the figure is, from near, so that more samples (--reference 2048) take no longer. Either
renderer then draws matte surfaces, because their specular lobes have other formulas; --sheen shows how far
those differ.

For smoothly shaded triangles the two solve different equations: shading normals that lean away from the
triangle see light from below its plane, which mien adds and Cycles leaves out. Of the mannequin the
folds, where that happens (light_from_below), are therefore listed by themselves and judged by 2 %; the
flat-mannequin has the same triangles without smooth shading, and is judged by 0.5 % everywhere.
"""

import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile


QUALITIES = {2: "draft", 16: "standard", 128: "final"}  # by their samples a pixel


def fastest_quality(rows, error):
    """The row of the fastest quality with at most that error; none if no quality was so good."""
    able = [row for row in rows if row["samples"] in QUALITIES and row["error"] <= error]
    return min(able, key=lambda row: row["seconds"], default=None)


BLOCK = 16
MARGIN = 3  # pixels: edges reach so far by the filter
LARGEST_DIFFERENCE = 0.005
LARGEST_IN_FOLDS = 0.02
NOISE = 4.0  # standard errors: one of 15,000 blocks is farther off
BELOW = 0.001  # share of a surface's light, from below its triangles, from which a block is a fold
VIEWS = ("standing", "close")
WIDTH, HEIGHT = 1280, 720


def layers_in(file, part):
    """mien's beauty, albedo, normals and positions of a part of the picture."""
    import numpy  # comes with Blender
    return numpy.fromfile(file, dtype=numpy.float32).reshape(4, part[3], part[2], 3)


def figure_in(file):
    """The part of a whole picture where its figure is, in whole blocks: left, top, width, height."""
    import numpy
    _, albedo, normal, _ = layers_in(file, (0, 0, WIDTH, HEIGHT))
    is_level = numpy.abs(normal - (0.0, 1.0, 0.0)).max(axis=2) < 0.01
    rows, columns = numpy.nonzero(~is_level & (albedo.max(axis=2) > 0.0))
    left, top = (int(least) // BLOCK * BLOCK for least in (columns.min(), rows.min()))
    right, bottom = (min(-(-int(most + 1) // BLOCK) * BLOCK, end)
                     for most, end in ((columns.max(), WIDTH), (rows.max(), HEIGHT)))
    return left, top, right - left, bottom - top


def light_from_below(normal, position):
    """Of each pixel, the share of an even light that a surface with the smooth normal gets from below
    the plane of its triangle. mien adds that light, since shadow rays leave from the curved surface;
    Cycles has none, since what a surface reflects has to be above both."""
    import numpy
    across, down = numpy.zeros_like(position), numpy.zeros_like(position)
    across[:, :-1] = numpy.diff(position, axis=1)
    down[:-1] = numpy.diff(position, axis=0)
    flat = numpy.cross(down, across)
    lengths = numpy.linalg.norm(flat, axis=2) * numpy.linalg.norm(normal, axis=2)
    cosine = (flat * normal).sum(axis=2) / numpy.maximum(lengths, 1e-20)
    return 0.5 * (1.0 - numpy.clip(cosine, 0.0, 1.0))


def disagreement(ours_file, theirs_file, part, is_smooth):
    """Of the blocks away from edges, on the floor, on the figure and in its folds: how many, and how far
    their means differ, as shares: mean, root mean square, that of the standard errors, and two blocks
    as (difference, standard error, x, y): that which differs most, and that which is farthest beyond
    noise. Pixels have noise of their own, so the spread of a block's differences gives the standard
    error of their mean."""
    import numpy
    beauty, albedo, normal, position = layers_in(ours_file, part)
    theirs = numpy.load(theirs_file)
    below = light_from_below(normal, position)
    found = {"floor": [], "figure": [], "folds": []}
    for y in range(BLOCK, part[3] - 2 * BLOCK, BLOCK):
        for x in range(BLOCK, part[2] - 2 * BLOCK, BLOCK):
            around = (slice(y - MARGIN, y + BLOCK + MARGIN), slice(x - MARGIN, x + BLOCK + MARGIN))
            if numpy.ptp(albedo[around], axis=(0, 1)).max() > 1e-4 or albedo[y, x].max() == 0.0:
                continue
            steps = max(numpy.abs(numpy.diff(normal[around], axis=axis)).max() for axis in (0, 1))
            if steps > 0.25:  # where two limbs meet
                continue
            inside = (slice(y, y + BLOCK), slice(x, x + BLOCK))
            mean = theirs[inside].mean()
            name = "floor"
            if numpy.ptp(normal[inside], axis=(0, 1)).max() > 1e-3:
                is_fold = is_smooth and below[inside].mean() > BELOW
                name = "folds" if is_fold else "figure"
            differences = beauty[inside].mean(axis=2) - theirs[inside].mean(axis=2)
            found[name].append((float(differences.mean() / mean),
                                float(differences.std() / BLOCK / mean),
                                part[0] + x, part[1] + y))
    return {name: summary(blocks) for name, blocks in found.items()}


def beyond_noise(block):
    difference, standard_error, _, _ = block
    return abs(difference) - NOISE * standard_error


def summary(blocks):
    count = max(len(blocks), 1)
    none = (0.0, 0.0, 0, 0)
    return {"blocks": len(blocks),
            "mean": sum(block[0] for block in blocks) / count,
            "rms": math.sqrt(sum(block[0] ** 2 for block in blocks) / count),
            "standard_error": math.sqrt(sum(block[1] ** 2 for block in blocks) / count),
            "largest": max(blocks, key=lambda block: abs(block[0]), default=none),
            "farthest": max(blocks, key=beyond_noise, default=none)}


def report_agreement(agreement):
    """Prints it; whether the renderers agree."""
    print("\nblocks of 16 x 16 away from edges, mien by Cycles")
    agree = True
    for view, subjects in agreement.items():
        for name, row in subjects.items():
            if name == "folds" and row["blocks"] == 0:
                continue
            largest, standard_error, x, y = row["largest"]
            print(f"  {view:9s} {name:7s} {row['blocks']:5d} blocks, mean {100 * row['mean']:+.3f} %, "
                  f"RMS {100 * row['rms']:.3f} % (noise {100 * row['standard_error']:.3f} %), "
                  f"at most {100 * largest:+.2f} ± {100 * standard_error:.2f} % at {x}, {y}; "
                  f"{100 * max(beyond_noise(row['farthest']), 0.0):.2f} % beyond noise")
            limit = LARGEST_IN_FOLDS if name == "folds" else LARGEST_DIFFERENCE
            agree = agree and row["blocks"] > 0 and abs(largest) <= limit
    print("  they agree" if agree else f"  they differ by more than {100 * LARGEST_DIFFERENCE} % "
                                      f"(folds: {100 * LARGEST_IN_FOLDS} %)")
    return agree


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--figure", choices=("sticks", "mannequin", "flat-mannequin"),
                        default="sticks")
    parser.add_argument("--frames", type=int, default=4)
    parser.add_argument("--reference", type=int, default=1024)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--agreement", action="store_true")
    parser.add_argument("--close-up", action="store_true")
    parser.add_argument("--sheen", action="store_true")
    options = parser.parse_args()
    if options.close_up and not options.agreement:
        parser.error("--close-up goes with --agreement")
    blender = shutil.which("blender")
    if blender is None:
        print("skipped: there is no blender on this machine")
        return 77
    program = [os.path.join(options.build, "tests/peers/peer_scene")]
    if options.figure != "sticks":
        program.append("--figure=" + options.figure)
    surface = "sheen" if options.sheen else "matte"
    here = os.path.dirname(os.path.abspath(__file__))
    frames = 0 if options.agreement else options.frames
    counts = [str(frames), str(options.reference)]
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "scene.json")
        result = os.path.join(folder, "cycles.json")
        picture = os.path.join(folder, "picture")
        subprocess.run([*program, "write", scene], check=True)
        views, part = VIEWS, (0, 0, WIDTH, HEIGHT)
        chosen = []  # the part, for both programs
        if options.close_up:
            views = ("close",)
            subprocess.run([*program, "picture", "0", "2", "close", surface, f"{picture}.floats"],
                           check=True)
            part = figure_in(f"{picture}.floats")
            chosen = [str(pixels) for pixels in part]
        for view in views:
            subprocess.run([*program, "picture", "0", str(options.reference), view, surface,
                            f"{picture}.{view}.floats", *chosen], check=True)
        ours = None
        if not options.agreement:
            ours = json.loads(subprocess.run([*program, "measure", *counts], check=True,
                                             stdout=subprocess.PIPE).stdout)
        done = subprocess.run([blender, "-b", "--factory-startup", "--python-exit-code", "1",
                               "--python", os.path.join(here, "cycles_scene.py"), "--", scene,
                               result, *counts, surface, picture, *chosen],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            sys.stderr.write(done.stdout.decode())
            return 1
        theirs = json.load(open(result))
        agreement = {view: disagreement(f"{picture}.{view}.floats", f"{picture}.{view}.npy", part,
                                        options.figure == "mannequin")
                     for view in views}
    if options.json:
        print(json.dumps({"mien": ours, "cycles": theirs, "agreement": agreement}))
        return 0
    if options.agreement:
        return 0 if report_agreement(agreement) else 1
    print(f"Blender {theirs['version']}, {os.cpu_count()} processors, {options.figure}, 1280 x 720")
    for way in ("standing", "moving"):
        print(f"\ncamera {way}\n  Cycles  samples  s/frame  RMS error   mien's quality  s/frame   ratio")
        for row in theirs[way]:
            line = f"          {row['samples']:7d}  {row['seconds']:7.3f}  {row['error']:9.5f}"
            mine = fastest_quality(ours[way], row["error"])
            if mine is not None:
                line += (f"   {QUALITIES[mine['samples']]:14s}  {mine['seconds']:7.4f}"
                         f"  {row['seconds'] / mine['seconds']:6.0f}")
            print(line)
        print("  mien    samples  s/frame  RMS error")
        for row in ours[way]:
            print(f"          {row['samples']:7d}  {row['seconds']:7.4f}  {row['error']:9.5f}")
    return 0 if report_agreement(agreement) else 1


if __name__ == "__main__":
    sys.exit(main())
