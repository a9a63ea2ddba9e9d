"""Run by Blender: imports an FBX file and writes where its joints are.

blender -b --factory-startup --python fbx_in_blender.py -- FILE.fbx REQUESTS.json RESULT.json

REQUESTS.json lists takes as {"take": name or null, "frames": count, "fps": number}. RESULT.json becomes
a list with, for each, {"joints": {name: [[x, y, z] for each frame]}} in metres with +Y up, frames
counted from the take's first key. If Blender cannot import the file, it is {"refusal": text}.
"""

import json
import sys

import bpy

fbx_file, requests_file, result_file = sys.argv[sys.argv.index("--") + 1:]


def y_up(v):
    return [v.x, v.z, -v.y]


def chosen_action(name, actions, take):
    """The action of an object in a take: the importer calls it "object|take|layer"."""
    own = [action for action in actions if action.name.split("|")[0] == name]
    if take is not None:
        own = [action for action in own if take in action.name.split("|")[1:]] or \
              [action for action in own if take.startswith(action.name.split("|", 1)[-1])]
    return own[0] if own else None


def use_take(take):
    """Gives every object its action of the take; the first key of all of them."""
    keys = []
    for thing in bpy.data.objects:
        action = chosen_action(thing.name, bpy.data.actions, take)
        if thing.animation_data is None and action is not None:
            thing.animation_data_create()
        if thing.animation_data is not None:
            thing.animation_data.action = action
        if action is not None:
            keys += [curve.keyframe_points[0].co.x for curve in action.fcurves if curve.keyframe_points]
    return min(keys, default=0.0)


def places():
    found = {}
    for thing in bpy.data.objects:
        if thing.type == "ARMATURE":
            for bone in thing.pose.bones:
                found[bone.name] = y_up(thing.matrix_world @ bone.head)
        found.setdefault(thing.name, y_up(thing.matrix_world.translation))
    return found


def joints_of(request):
    first = use_take(request["take"])
    scene = bpy.context.scene
    scene_fps = scene.render.fps / scene.render.fps_base
    joints = {}
    for f in range(request["frames"]):
        frame = first + f * scene_fps / request["fps"]
        scene.frame_set(int(frame // 1), subframe=frame % 1)
        for name, place in places().items():
            joints.setdefault(name, []).append(place)
    return {"joints": joints}


def result():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    try:
        bpy.ops.import_scene.fbx(filepath=fbx_file, anim_offset=0.0)
    except RuntimeError as error:
        return {"refusal": str(error).strip().splitlines()[-1]}
    return [joints_of(request) for request in json.load(open(requests_file))]


found = result()
with open(result_file, "w") as out:
    json.dump(found, out)
