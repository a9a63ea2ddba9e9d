#!/usr/bin/env python3
"""Frames per second of `mien render --quality draft` and of VTK with shadow maps, in software.

    tests/peers/compare_with_vtk.py MIEN [--frames 96]

MIEN is the program. Both make a 1280 x 720 H.264 video of a figure of 22 spheres and 21 capsules on a
floor under one light, encoding included. Needs VTK 9 for Python, ffmpeg and, without a display,
xvfb-run (Debian: python3-vtk9, ffmpeg, xvfb); says that it skipped, with exit code 77, without. VTK
draws with OpenGL: software rendering is chosen by LIBGL_ALWAYS_SOFTWARE. Run it on an idle machine.
"""

import argparse
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time

width, height = 1280, 720


def joints_at(seconds):
    """22 joints that swing about a vertical line: what is drawn hardly matters to the time."""
    return [(0.3 * math.sin(6.0 * seconds + j), 0.1 + 0.08 * j, 0.3 * math.cos(6.0 * seconds + j))
            for j in range(22)]


class Figure:
    """Spheres at the joints and cylinders between neighbours."""

    def __init__(self, vtk, renderer):
        self.vtk = vtk
        sphere = vtk.vtkSphereSource()
        sphere.SetRadius(0.05)
        sphere.SetThetaResolution(24)
        sphere.SetPhiResolution(24)
        cylinder = vtk.vtkCylinderSource()
        cylinder.SetRadius(0.04)
        cylinder.SetResolution(24)
        self.balls = [self.actor(renderer, sphere) for _ in range(22)]
        self.limbs = [self.actor(renderer, cylinder) for _ in range(21)]

    def actor(self, renderer, source):
        mapper = self.vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = self.vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.3, 0.4, 0.6)
        renderer.AddActor(actor)
        return actor

    def pose(self, joints):
        for ball, place in zip(self.balls, joints):
            ball.SetPosition(*place)
        for limb, a, b in zip(self.limbs, joints, joints[1:]):
            along = [q - p for p, q in zip(a, b)]
            length = math.sqrt(sum(c * c for c in along))
            turn = self.vtk.vtkTransform()
            turn.Translate(*[(p + q) / 2 for p, q in zip(a, b)])
            # The shortest turn from +Y, the axis of a cylinder.
            turn.RotateWXYZ(math.degrees(math.acos(along[1] / length)), along[2], 0.0, -along[0])
            turn.Scale(1.0, length, 1.0)
            limb.SetUserTransform(turn)


def scene(vtk):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.8, 0.8, 0.8)
    figure = Figure(vtk, renderer)
    floor = vtk.vtkPlaneSource()
    floor.SetOrigin(-10, 0, -10)
    floor.SetPoint1(-10, 0, 10)
    floor.SetPoint2(10, 0, -10)
    figure.actor(renderer, floor).GetProperty().SetColor(0.7, 0.7, 0.7)
    light = vtk.vtkLight()
    light.SetPositional(True)
    light.SetPosition(2.0, 4.0, 3.0)
    light.SetFocalPoint(0.0, 1.0, 0.0)
    light.SetConeAngle(40.0)
    renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2.5, 1.6, 4.5)
    camera.SetFocalPoint(0.0, 0.9, 0.0)
    renderer.ResetCameraClippingRange()
    # Depth from the light first, then opaque surfaces with shadows.
    shadows = vtk.vtkShadowMapPass()
    shadows.GetShadowMapBakerPass().SetResolution(1024)
    passes = vtk.vtkRenderPassCollection()
    passes.AddItem(shadows.GetShadowMapBakerPass())
    passes.AddItem(shadows)
    sequence = vtk.vtkSequencePass()
    sequence.SetPasses(passes)
    whole = vtk.vtkCameraPass()
    whole.SetDelegatePass(sequence)
    renderer.SetPass(whole)
    return renderer, figure


def draw_with_vtk(vtk, frames, video):
    """Seconds for a whole video."""
    from vtk.util.numpy_support import vtk_to_numpy
    start = time.perf_counter()
    renderer, figure = scene(vtk)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    encoder = subprocess.Popen(
        ["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
         f"{width}x{height}", "-r", "30", "-i", "-", "-vf", "vflip", "-pix_fmt", "yuv420p", video],
        stdin=subprocess.PIPE)
    pixels = vtk.vtkUnsignedCharArray()
    for frame in range(frames):
        figure.pose(joints_at(frame / 30.0))
        window.Render()
        window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
        encoder.stdin.write(vtk_to_numpy(pixels).tobytes())
    encoder.stdin.close()
    if encoder.wait() != 0:
        raise RuntimeError("ffmpeg failed")
    return time.perf_counter() - start


def draw_with_mien(program, frames, folder):
    """Seconds and frames of a whole command."""
    walk = os.path.join(folder, "walk.bvh")
    subprocess.run([program, "motion", "blend", "--examples", "builtin:walks-10", "--weights",
                    "normal=1", "--cycles", str(max(1, round(frames / 32))), "-o", walk],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    start = time.perf_counter()
    done = subprocess.run([program, "render", walk, "-o", os.path.join(folder, "mien.mp4"), "--size",
                           f"{width}x{height}", "--quality", "draft"], check=True, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    seconds = time.perf_counter() - start
    return seconds, int(done.stdout.strip().splitlines()[-1].split(": ")[1].split(" frames")[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mien")
    parser.add_argument("--frames", type=int, default=96)
    options = parser.parse_args()
    os.environ["LIBGL_ALWAYS_SOFTWARE"] = "1"
    try:
        import vtk
    except ImportError:
        print("skipped: there is no VTK for Python on this machine")
        return 77
    if shutil.which("ffmpeg") is None:
        print("skipped: there is no ffmpeg on this machine")
        return 77
    if "DISPLAY" not in os.environ:
        if shutil.which("xvfb-run") is None:
            print("skipped: there is neither a display nor xvfb-run on this machine")
            return 77
        return subprocess.run(["xvfb-run", "-a", sys.executable, *sys.argv]).returncode
    with tempfile.TemporaryDirectory() as folder:
        seconds, frames = draw_with_mien(options.mien, options.frames, folder)
        ours = frames / seconds
        theirs = frames / draw_with_vtk(vtk, frames, os.path.join(folder, "vtk.mp4"))
    version = vtk.vtkVersion.GetVTKVersion()
    print(f"mien draft {ours:.1f} frames/s, VTK {version} {theirs:.1f} frames/s, ratio "
          f"{ours / theirs:.1f} ({frames} frames, {os.cpu_count()} processors)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
