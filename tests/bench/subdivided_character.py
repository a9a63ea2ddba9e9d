#!/usr/bin/env python3
"""Writes a skinned glTF character with more triangles, of the same shape, for benchmarks:
subdivided_character.py character.gltf 30000 larger.gltf

Triangles are divided into four at the middles of their edges, and new vertices have the mean weights of two.
The file must contain its buffers (data URIs).
"""
import base64
import json
import struct
import sys

COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
FORMATS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}  # glTF's component types


def values_of(gltf, number):
    """The elements of an accessor, as tuples."""
    accessor = gltf["accessors"][number]
    view = gltf["bufferViews"][accessor["bufferView"]]
    buffer = base64.b64decode(gltf["buffers"][view["buffer"]]["uri"].split(",", 1)[1])
    element = struct.Struct("<" + COMPONENTS[accessor["type"]] * FORMATS[accessor["componentType"]])
    begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    step = view.get("byteStride", element.size)
    return [element.unpack_from(buffer, begin + i * step) for i in range(accessor["count"])]


def append(gltf, elements, component_type, kind):
    """Adds an accessor with a buffer of its own; returns its number."""
    content = struct.pack(f"<{sum(map(len, elements))}{FORMATS[component_type]}",
                          *(value for element in elements for value in element))
    uri = "data:application/octet-stream;base64," + base64.b64encode(content).decode()
    gltf["buffers"].append({"byteLength": len(content), "uri": uri})
    gltf["bufferViews"].append({"buffer": len(gltf["buffers"]) - 1, "byteLength": len(content)})
    accessor = {"bufferView": len(gltf["bufferViews"]) - 1, "componentType": component_type,
                "count": len(elements), "type": kind}
    columns = list(zip(*elements))
    accessor["min"], accessor["max"] = [min(c) for c in columns], [max(c) for c in columns]
    gltf["accessors"].append(accessor)
    return len(gltf["accessors"]) - 1


def mean_influences(vertex, other):
    """The four largest of the mean weights of two vertices: joints and weights."""
    weights = {}
    for joints, shares in (vertex, other):
        for joint, share in zip(joints, shares):
            weights[joint] = weights.get(joint, 0.0) + share
    largest = sorted(weights.items(), key=lambda pair: -pair[1])[:4]
    largest += [(0, 0.0)] * (4 - len(largest))
    total = sum(share for _, share in largest) or 1.0
    return tuple(joint for joint, _ in largest), tuple(share / total for _, share in largest)


def divide(triangles, columns, influences, count):
    """Divides the first `count` triangles, and adds the vertices that they need."""
    middles = {}

    def middle(a, b):
        edge = (min(a, b), max(a, b))
        if edge not in middles:
            middles[edge] = len(influences)
            for values in columns.values():
                values.append(tuple((x + y) / 2 for x, y in zip(values[a], values[b])))
            influences.append(mean_influences(influences[a], influences[b]))
        return middles[edge]

    result = []
    for a, b, c in triangles[:count]:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        result += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return result + triangles[count:]


def subdivided(gltf, wanted):
    """Subdivides the character's first mesh, in place, to `wanted` triangles or up to two more."""
    primitive = gltf["meshes"][0]["primitives"][0]
    attributes = primitive["attributes"]
    indices = [value for value, in values_of(gltf, primitive["indices"])]
    triangles = list(zip(indices[0::3], indices[1::3], indices[2::3]))
    influences = list(zip(values_of(gltf, attributes["JOINTS_0"]), values_of(gltf, attributes["WEIGHTS_0"])))
    columns = {name: values_of(gltf, attributes[name])
               for name in ("POSITION", "NORMAL", "TEXCOORD_0") if name in attributes}
    while len(triangles) < wanted:
        missing = (wanted - len(triangles) + 2) // 3
        triangles = divide(triangles, columns, influences, min(missing, len(triangles)))
    primitive["indices"] = append(gltf, [(i,) for triangle in triangles for i in triangle], 5125, "SCALAR")
    for name, values in columns.items():
        attributes[name] = append(gltf, values, 5126, f"VEC{len(values[0])}")
    attributes["JOINTS_0"] = append(gltf, [joints for joints, _ in influences], 5123, "VEC4")
    attributes["WEIGHTS_0"] = append(gltf, [weights for _, weights in influences], 5126, "VEC4")
    return len(triangles)


def write_subdivided(source, wanted, target):
    with open(source, encoding="utf-8") as file:
        gltf = json.load(file)
    count = subdivided(gltf, wanted)
    with open(target, "w", encoding="utf-8") as file:
        json.dump(gltf, file)
    return count


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__.strip())
    print(write_subdivided(sys.argv[1], int(sys.argv[2]), sys.argv[3]), "triangles")
