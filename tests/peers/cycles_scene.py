"""Run by Blender: draws the peers' scene with Cycles and writes seconds a frame and errors.

blender -b --factory-startup --python cycles_scene.py -- SCENE.json RESULT.json FRAMES REFERENCE PICTURE.npy

PICTURE becomes the last frame before the standing camera with REFERENCE samples, its first row at the
top. With FRAMES 0 it is the first frame, and nothing else is drawn.
Direct light only, no denoiser, persistent data, all cores. The axes are turned: mien's +Y is up,
Blender's +Z.
"""

import json
import os
import sys
import tempfile
import time

import bpy
import numpy
from mathutils import Matrix, Vector

scene_file, result_file, frames, reference, picture_file = sys.argv[sys.argv.index("--") + 1:]
frames, reference = int(frames), int(reference)
told = json.load(open(scene_file))


def turned(v):
    return Vector((v[0], -v[2], v[1]))


def diffuse(name, colour):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    shader = nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (*colour, 1.0)
    output = nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(shader.outputs[0], output.inputs["Surface"])
    return material


bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.render.resolution_x, scene.render.resolution_y = 1280, 720
scene.render.resolution_percentage = 100
scene.render.use_persistent_data = True
scene.render.threads_mode = "AUTO"
scene.view_settings.view_transform = "Raw"
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
cycles = scene.cycles
cycles.device = "CPU"
cycles.use_denoising = False
cycles.use_adaptive_sampling = False
cycles.max_bounces = 0
cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 0
cycles.pixel_filter_type = "BLACKMAN_HARRIS"
cycles.filter_width = 2.0

world = bpy.data.worlds.new("sky")
scene.world = world
world.use_nodes = True
world.node_tree.nodes["Background"].inputs["Color"].default_value = (told["sky"],) * 3 + (1.0,)

bpy.ops.mesh.primitive_plane_add(size=2000.0)
bpy.context.object.data.materials.append(diffuse("floor", (told["floor_albedo"],) * 3))

light = told["light"]
half_u, half_v = turned(light["half_u"]), turned(light["half_v"])
width, height = 2.0 * half_u.length, 2.0 * half_v.length
lamp = bpy.data.lights.new("key", "AREA")
lamp.shape = "RECTANGLE"
lamp.size, lamp.size_y = width, height
# Of rectangles, Blender makes radiance = power / (4 area).
lamp.energy = light["radiance"] * 4.0 * width * height
key = bpy.data.objects.new("key", lamp)
x, y = half_u.normalized(), half_v.normalized()
z = x.cross(y)  # it shines along −z
away = turned(light["centre"]) - turned([0.0, 1.0, 0.0])
if z.dot(away) < 0:
    x, z = -x, -z
key.matrix_world = Matrix.Translation(turned(light["centre"])) @ Matrix((x, y, z)).transposed().to_4x4()
key.visible_camera = False
scene.collection.objects.link(key)

body = diffuse("body", told["albedo"])
bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=told["joint_radius"])
ball = bpy.context.object.data
bpy.ops.object.shade_smooth()
ball.materials.append(body)
bpy.data.objects.remove(bpy.context.object)
# Without caps, which lie inside the balls: smooth shading would bend the normals at the rims to them.
bpy.ops.mesh.primitive_cylinder_add(vertices=64, radius=told["bone_radius"], depth=1.0,
                                    end_fill_type="NOTHING")
stick = bpy.context.object.data
bpy.ops.object.shade_smooth()
stick.materials.append(body)
bpy.data.objects.remove(bpy.context.object)

parents = told["parents"]
balls = [bpy.data.objects.new(f"joint{j}", ball) for j in range(len(parents))]
sticks = {j: bpy.data.objects.new(f"bone{j}", stick) for j in range(len(parents)) if parents[j] >= 0}
for each in [*balls, *sticks.values()]:
    scene.collection.objects.link(each)

camera_data = bpy.data.cameras.new("camera")
camera_data.sensor_fit = "VERTICAL"
camera_data.angle_y = told["vertical_field_of_view"]
camera_data.clip_end = 10000.0
camera = bpy.data.objects.new("camera", camera_data)
scene.collection.objects.link(camera)
scene.camera = camera


def pose(number, way):
    frame = told["frames"][number]
    places = [turned(p) for p in frame["joints"]]
    for each, place in zip(balls, places):
        each.location = place
    for j, each in sticks.items():
        start, end = places[parents[j]], places[j]
        span = end - start
        each.matrix_world = (Matrix.Translation(0.5 * (start + end))
                             @ span.to_track_quat("Z", "Y").to_matrix().to_4x4()
                             @ Matrix.Diagonal((1.0, 1.0, span.length, 1.0)))
    camera.location = turned(frame[way]["position"])
    towards = turned(frame[way]["target"]) - camera.location
    camera.rotation_euler = towards.to_track_quat("-Z", "Y").to_euler()


folder = tempfile.mkdtemp()


def render(samples, seed):
    """Seconds, without those for the file, and the file's pixels."""
    cycles.samples = samples
    cycles.seed = seed
    scene.render.filepath = os.path.join(folder, "picture.exr")
    start = time.perf_counter()
    bpy.ops.render.render()
    taken = time.perf_counter() - start
    bpy.data.images["Render Result"].save_render(scene.render.filepath)
    image = bpy.data.images.load(scene.render.filepath)
    pixels = numpy.empty(len(image.pixels), dtype=numpy.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return taken, pixels.reshape(-1, 4)[:, :3].astype(numpy.float64)


def save_picture(pixels):
    numpy.save(picture_file, pixels.reshape(720, 1280, 3)[::-1])


result = {"version": bpy.app.version_string}
if frames == 0:
    pose(0, "standing")
    save_picture(render(reference, 99)[1])
for way in ("standing", "moving") if frames > 0 else ():
    pose(frames - 1, way)
    truth = render(reference, 99)[1]
    if way == "standing":
        save_picture(truth)
    result[way] = []
    for samples in (1, 4, 16, 64):
        seconds = []
        picture = None
        for number in range(frames):
            pose(number, way)
            taken, picture = render(samples, number)
            if number > 0 or frames == 1:  # the first builds what persists
                seconds.append(taken)
        error = float(numpy.sqrt(numpy.mean((picture - truth) ** 2)))
        result[way].append({"samples": samples, "seconds": sum(seconds) / len(seconds),
                            "error": error})
        print("mien-peer", way, result[way][-1], flush=True)
json.dump(result, open(result_file, "w"))
