#!/usr/bin/env python3
"""How far the joints that mien reads from FBX files are from those of Blender's FBX importer.

    tests/peers/compare_with_blender_import.py BUILD [FILE.fbx ...]

BUILD is a build folder with the program mien. Without files, those of $MIEN_DATA/recordings/fbx are
compared. Needs `blender` (3.4 or later) and numpy; says that it skipped, with exit code 77, where there
is no Blender. Prints, for each take of each file, the largest distance over all joints that both have
and all frames, and where it is. The exit code is 1 if a file cannot be compared though both read it.

Blender refuses text files and versions before 7.1. It places bones by their bind pose and does not
follow every pivot and scale, so that files with these differ: distances are printed, and none is a
failure.
"""

import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile


def glb_parts(data):
    """The JSON and the binary chunk of a .glb file."""
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


def accessor(document, binary, index):
    import numpy
    told = document["accessors"][index]
    view = document["bufferViews"][told["bufferView"]]
    width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[told["type"]]
    start = view.get("byteOffset", 0) + told.get("byteOffset", 0)
    return numpy.frombuffer(binary, "<f4", told["count"] * width, start).reshape(-1, width).astype(float)


def turned(q, v):
    """Vectors turned by unit quaternions x y z w."""
    import numpy
    across = 2.0 * numpy.cross(q[:, :3], v)
    return v + q[:, 3:] * across + numpy.cross(q[:, :3], across)


def product(a, b):
    import numpy
    xyz = a[:, 3:] * b[:, :3] + b[:, 3:] * a[:, :3] + numpy.cross(a[:, :3], b[:, :3])
    w = a[:, 3:] * b[:, 3:] - (a[:, :3] * b[:, :3]).sum(axis=1, keepdims=True)
    return numpy.hstack([xyz, w])


def places_in_glb(file):
    """Of each joint of a .glb file that mien wrote, its places in all frames, and the frame rate."""
    import numpy
    document, binary = glb_parts(pathlib.Path(file).read_bytes())
    nodes = document["nodes"]
    tracks, times = {}, None
    animation = document["animations"][0]
    for channel in animation["channels"]:
        sampler = animation["samplers"][channel["sampler"]]
        times = accessor(document, binary, sampler["input"])[:, 0]
        tracks[channel["target"]["node"], channel["target"]["path"]] = accessor(
            document, binary, sampler["output"])
    frames = len(times)
    places = {}

    def follow(node, position, rotation):
        own = nodes[node]
        offset = tracks.get((node, "translation"))
        if offset is None:
            offset = numpy.tile(own.get("translation", [0.0, 0.0, 0.0]), (frames, 1))
        turn = tracks.get((node, "rotation"))
        if turn is None:
            turn = numpy.tile(own.get("rotation", [0.0, 0.0, 0.0, 1.0]), (frames, 1))
        position = position + turned(rotation, offset)
        rotation = product(rotation, turn)
        if (node, "rotation") in tracks:  # ends of bones have none
            places[own["name"]] = position
        for child in own.get("children", []):
            follow(child, position, rotation)

    children = {child for node in nodes for child in node.get("children", [])}
    unturned = numpy.tile([0.0, 0.0, 0.0, 1.0], (frames, 1))
    for root in (n for n in range(len(nodes)) if n not in children and (n, "rotation") in tracks):
        follow(root, numpy.zeros((frames, 3)), unturned)
    rate = (frames - 1) / (times[-1] - times[0]) if frames > 1 else 30.0
    return places, rate


def run(command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


def ours(mien, file, take, folder):
    """The places as mien reads them, and the frame rate. Raises RuntimeError with what mien says."""
    glb = os.path.join(folder, "ours.glb")
    options = ["--take", take] if take is not None else []
    done = run([mien, "motion", "convert", file, glb, *options])
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip().splitlines()[-1])
    return places_in_glb(glb)


def theirs(file, requests, folder):
    names = [os.path.join(folder, name) for name in ("requests.json", "result.json")]
    pathlib.Path(names[0]).write_text(json.dumps(requests))
    script = pathlib.Path(__file__).with_name("fbx_in_blender.py")
    done = run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python",
                str(script), "--", file, *names])
    if done.returncode != 0:
        raise RuntimeError("Blender failed: " + (done.stderr or done.stdout).strip().splitlines()[-1])
    return json.loads(pathlib.Path(names[1]).read_text())


def report(label, own, other):
    """Prints the largest distance; whether there was any joint to compare."""
    import numpy
    common = [name for name in own if name in other]
    if not common:
        print(f"{label}: no joint has the same name in both")
        return False
    apart = {name: numpy.linalg.norm(own[name] - numpy.array(other[name]), axis=1) for name in common}
    worst = max(common, key=lambda name: apart[name].max())
    print(f"{label}: {len(common)} of {len(own)} joints, {len(own[worst])} frames, at most "
          f"{1000.0 * apart[worst].max():.4f} mm apart ({worst}, frame {int(apart[worst].argmax())}), "
          f"median {1000.0 * float(numpy.median(numpy.concatenate(list(apart.values())))):.4f} mm")
    return True


def compare(mien, file, folder):
    """Prints the distances of a file's takes; whether it could be compared."""
    name = os.path.basename(file)
    told = run([mien, "motion", "info", file, "--json"])
    if told.returncode != 0:
        print(f"{name}: mien refuses it: {told.stderr.strip().splitlines()[-1]}")
        return True
    takes = json.loads(told.stdout).get("takes") or [None]
    read = [(take, *ours(mien, file, take, folder)) for take in takes]
    requests = [{"take": take, "frames": len(next(iter(places.values()))), "fps": rate}
                for take, places, rate in read]
    found = theirs(file, requests, folder)
    if "refusal" in found:
        print(f"{name}: Blender refuses it: {found['refusal']}")
        return True
    results = [report(name if take is None else f"{name}#{take}", places, one["joints"])
               for (take, places, _), one in zip(read, found)]
    return all(results)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if shutil.which("blender") is None:
        print("skipped: there is no blender here")
        sys.exit(77)
    mien = os.path.join(sys.argv[1], "mien")
    files = sys.argv[2:]
    if not files:
        data = os.environ.get("MIEN_DATA")
        if not data:
            sys.exit("name FBX files, or set MIEN_DATA to the folder of real data")
        files = sorted(str(file) for file in pathlib.Path(data, "recordings/fbx").glob("*.fbx"))
    is_compared = True
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            try:
                is_compared = compare(mien, file, folder) and is_compared
            except RuntimeError as error:
                print(f"{os.path.basename(file)}: {error}")
                is_compared = False
    sys.exit(0 if is_compared else 1)


if __name__ == "__main__":
    main()
