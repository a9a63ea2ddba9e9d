"""Run by Blender: draws the peers' scene with Cycles and writes seconds a frame and errors.

blender -b --factory-startup --python cycles_scene.py -- SCENE.json RESULT.json FRAMES REFERENCE \\
    SURFACE PICTURE [LEFT TOP WIDTH HEIGHT]

PICTURE.standing.npy and PICTURE.close.npy become the first frame before these cameras with REFERENCE
samples, its first row at the top; SURFACE (matte or sheen) says whether materials have their specular
lobe there. With a part, in pixels, only that of the close-up is drawn. With FRAMES 0 nothing else is
drawn.
Direct light only, no denoiser, persistent data, all cores. The axes are turned: mien's +Y is up,
Blender's +Z.
"""

import json
import math
import os
import sys
import tempfile
import time

import bpy
import numpy
from mathutils import Matrix, Vector

words = sys.argv[sys.argv.index("--") + 1:]
scene_file, result_file, frames, reference, surface, picture_file, *part = words
frames, reference, part = int(frames), int(reference), [int(pixels) for pixels in part]
told = json.load(open(scene_file))


def turned(v):
    return Vector((v[0], -v[2], v[1]))


class Material:
    """A Lambert surface, and the specular lobe of a mesh, if it has one."""

    def __init__(self, name):
        self.material = bpy.data.materials.new(name)
        self.material.use_nodes = True
        self.tree = self.material.node_tree
        self.tree.nodes.clear()
        self.shader = self.tree.nodes.new("ShaderNodeBsdfDiffuse")
        self.output = self.tree.nodes.new("ShaderNodeOutputMaterial")
        self.sum = None
        self.show_sheen(False)

    def show_sheen(self, shown):
        source = self.sum if shown and self.sum is not None else self.shader
        self.tree.links.new(source.outputs[0], self.output.inputs["Surface"])


def diffuse(name, colour):
    made = Material(name)
    made.shader.inputs["Color"].default_value = (*colour, 1.0)
    return made.material


def painted(mesh):
    """The material of a mesh. Cycles has no Schlick term: its dielectric of index 1.25 rises most like
    one, and the colour of its metal says where it begins. It masks a little less than mien (Smith's
    term, not Schlick's approximation)."""
    made = Material("skin")
    paint = mesh["paint"]
    image = bpy.data.images.new("paint", paint["width"], paint["height"], float_buffer=True, is_data=True)
    texels = numpy.ones((len(paint["texels"]), 4), dtype=numpy.float32)
    texels[:, :3] = paint["texels"]
    image.pixels.foreach_set(texels.ravel())
    image.update()
    texture = made.tree.nodes.new("ShaderNodeTexImage")
    texture.image = image
    made.tree.links.new(texture.outputs["Color"], made.shader.inputs["Color"])
    lobe = made.tree.nodes.new("ShaderNodeBsdfPrincipled")
    lobe.distribution = "GGX"
    lobe.inputs["Metallic"].default_value = 1.0
    lobe.inputs["Base Color"].default_value = (mesh["specular_f0"],) * 3 + (1.0,)
    lobe.inputs["Specular"].default_value = (0.25 / 2.25) ** 2 / 0.08
    lobe.inputs["Roughness"].default_value = mesh["roughness"]
    made.sum = made.tree.nodes.new("ShaderNodeAddShader")
    made.tree.links.new(made.shader.outputs[0], made.sum.inputs[0])
    made.tree.links.new(lobe.outputs[0], made.sum.inputs[1])
    return made


class Sticks:
    """Balls at the joints and sticks between them."""

    def __init__(self, told):
        body = diffuse("body", told["albedo"])
        bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=told["joint_radius"])
        ball = bpy.context.object.data
        bpy.ops.object.shade_smooth()
        ball.materials.append(body)
        bpy.data.objects.remove(bpy.context.object)
        # Without caps, which lie inside the balls: smooth shading would bend the normals at the rims
        # to them.
        bpy.ops.mesh.primitive_cylinder_add(vertices=64, radius=told["bone_radius"], depth=1.0,
                                            end_fill_type="NOTHING")
        stick = bpy.context.object.data
        bpy.ops.object.shade_smooth()
        stick.materials.append(body)
        bpy.data.objects.remove(bpy.context.object)
        self.parents = told["parents"]
        self.joints = told["joints"]
        count = len(self.parents)
        self.balls = [bpy.data.objects.new(f"joint{j}", ball) for j in range(count)]
        self.sticks = {j: bpy.data.objects.new(f"bone{j}", stick)
                       for j in range(count) if self.parents[j] >= 0}
        for each in [*self.balls, *self.sticks.values()]:
            scene.collection.objects.link(each)

    def show_sheen(self, shown):
        pass

    def pose(self, number):
        places = [turned(p) for p in self.joints[number]]
        for each, place in zip(self.balls, places):
            each.location = place
        for j, each in self.sticks.items():
            start, end = places[self.parents[j]], places[j]
            span = end - start
            each.matrix_world = (Matrix.Translation(0.5 * (start + end))
                                 @ span.to_track_quat("Z", "Y").to_matrix().to_4x4()
                                 @ Matrix.Diagonal((1.0, 1.0, span.length, 1.0)))


class SkinnedMesh:
    """The same triangles and normals as mien's in each frame."""

    def __init__(self, told, vertex_file):
        vertices = numpy.fromfile(vertex_file, dtype=numpy.float32).reshape(-1, 2, told["vertices"], 3)
        self.vertices = numpy.stack([vertices[..., 0], -vertices[..., 2], vertices[..., 1]], axis=-1)
        self.mesh = bpy.data.meshes.new("skin")
        self.mesh.from_pydata(self.vertices[0, 0].tolist(), [], told["triangles"])
        corners = numpy.array(told["triangles"]).ravel()
        self.mesh.uv_layers.new().data.foreach_set(
            "uv", numpy.array(told["uv"], dtype=numpy.float32)[corners].ravel())
        self.mesh.polygons.foreach_set("use_smooth", [True] * len(told["triangles"]))
        self.mesh.use_auto_smooth = True  # else Cycles makes normals of its own
        self.mesh.auto_smooth_angle = math.pi
        self.skin = painted(told)
        self.mesh.materials.append(self.skin.material)
        figure = bpy.data.objects.new("skin", self.mesh)
        # Shadow rays leave from the curved surface, as mien's do (Hanika 2021); by default only those
        # at the terminator do.
        figure.cycles.shadow_terminator_geometry_offset = 1.0
        scene.collection.objects.link(figure)

    def show_sheen(self, shown):
        self.skin.show_sheen(shown)

    def pose(self, number):
        positions, normals = self.vertices[number]
        self.mesh.vertices.foreach_set("co", positions.ravel())
        self.mesh.normals_split_custom_set_from_vertices(normals.tolist())
        self.mesh.update()


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

# In mien only area lights are reflected by specular lobes.
world.cycles_visibility.glossy = False
figure = (SkinnedMesh(told["mesh"], scene_file + ".vertices") if "mesh" in told
          else Sticks(told["sticks"]))

camera_data = bpy.data.cameras.new("camera")
camera_data.sensor_fit = "VERTICAL"
camera_data.angle_y = told["vertical_field_of_view"]
camera_data.clip_end = 10000.0
camera = bpy.data.objects.new("camera", camera_data)
scene.collection.objects.link(camera)
scene.camera = camera


def pose(number, view):
    figure.pose(number)
    place = told["cameras"][view][number]
    camera.location = turned(place["position"])
    towards = turned(place["target"]) - camera.location
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


result = {"version": bpy.app.version_string}
figure.show_sheen(surface == "sheen")
columns, rows = part[2:] or (1280, 720)
if part:
    left, top, border = part[0], part[1], scene.render
    border.use_border = border.use_crop_to_border = True
    border.border_min_x, border.border_max_x = left / 1280, (left + columns) / 1280
    border.border_min_y, border.border_max_y = 1 - (top + rows) / 720, 1 - top / 720
for view in ("close",) if part else ("standing", "close"):
    pose(0, view)
    drawn = render(reference, 99)[1].reshape(rows, columns, 3)
    numpy.save(f"{picture_file}.{view}.npy", drawn[::-1])
scene.render.use_border = False
figure.show_sheen(True)
for way in ("standing", "moving") if frames > 0 else ():
    pose(frames - 1, way)
    truth = render(reference, 99)[1]
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
