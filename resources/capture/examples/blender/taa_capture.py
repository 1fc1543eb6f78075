"""Renders frames of a Blender file as a capture that TAA Inspector opens.

    blender -b [FILE.blend] -P taa_capture.py -- FOLDER [--frames A..B] [--size WxH] [--reference SAMPLES]

Every frame is one sample a pixel at the pixel's center, as a rasterizer draws it, with the camera shifted by a
Halton (2, 3) jitter. Without a file a small scene is made. With --reference each frame is also rendered without
jitter with so many samples: the picture to compare with.
"""
import argparse
import json
import os
import sys
from math import cos, sin

import bpy


def arguments():
    parser = argparse.ArgumentParser(prog="taa_capture.py")
    parser.add_argument("folder")
    parser.add_argument("--frames", default="1..8", help="A..B")
    parser.add_argument("--size", default="480x270", help="WxH")
    parser.add_argument("--reference", type=int, default=0, help="samples of the reference; 0: none")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:])


def halton(index, base):
    result, share = 0.0, 1.0
    while index > 0:
        share /= base
        result += share * (index % base)
        index //= base
    return result


def make_example(first, last):
    """A floor, a bar that turns and a ball that rolls, seen by a camera that moves: one thing for each cause of motion."""
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    scene = bpy.context.scene

    def colored(name, color):
        thing = bpy.context.object
        thing.name = name
        material = bpy.data.materials.new(name)
        material.use_nodes = True
        material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (*color, 1)
        thing.data.materials.append(material)
        return thing

    bpy.ops.mesh.primitive_plane_add(size=12)
    floor = colored("floor", (0.6, 0.6, 0.6))
    checker = floor.data.materials[0].node_tree
    texture = checker.nodes.new("ShaderNodeTexChecker")
    texture.inputs["Scale"].default_value = 24
    checker.links.new(texture.outputs["Color"], checker.nodes["Principled BSDF"].inputs["Base Color"])
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0.8, 0, 0.9))
    bar = colored("bar", (0.1, 0.2, 0.8))
    bar.scale = (1.8, 0.15, 0.15)
    bpy.ops.mesh.primitive_uv_sphere_add(radius=0.4, location=(-1, 0, 0.4))
    ball = colored("ball", (0.8, 0.15, 0.1))
    bpy.ops.object.camera_add()
    scene.camera = bpy.context.object
    scene.camera.data.lens = 35
    bpy.ops.object.light_add(type="SUN", rotation=(0.6, 0.3, 0))
    bpy.context.object.data.energy = 3
    bpy.context.object.data.angle = 0
    for frame in (first - 1, *range(first, last + 2)):
        time = frame / 24
        bar.rotation_euler = (0, 3 * time, 0)
        ball.location.x = -1 + 1.5 * time
        scene.camera.location = (0.5 + 0.6 * sin(time), -4.5, 1.6)
        scene.camera.rotation_euler = (1.35, 0, 0.05 * cos(time))
        bar.keyframe_insert("rotation_euler", frame=frame)
        ball.keyframe_insert("location", frame=frame)
        scene.camera.keyframe_insert("location", frame=frame)
        scene.camera.keyframe_insert("rotation_euler", frame=frame)
    for thing in (bar, ball, scene.camera):
        for curve in thing.animation_data.action.fcurves:
            for point in curve.keyframe_points:
                point.interpolation = "LINEAR"


def set_up(width, height):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.pixel_aspect_x = scene.render.pixel_aspect_y = 1
    scene.render.use_border = False  # all of the picture
    scene.render.use_motion_blur = False  # with it the vector pass is all zero
    layer = bpy.context.view_layer
    layer.use_pass_z = layer.use_pass_vector = layer.use_pass_object_index = True
    for index, thing in enumerate(scene.objects, start=1):  # curves and texts are drawn as well
        thing.pass_index = index
    image = scene.render.image_settings
    image.file_format, image.color_depth, image.exr_codec = "OPEN_EXR_MULTILAYER", "32", "ZIP"
    return scene


def numbers(matrix):
    return [value for row in matrix for value in row]


def frame_facts(scene, number, jitter):
    """What is true of the frame without jitter; the camera is not shifted yet."""
    graph = bpy.context.evaluated_depsgraph_get()
    size = scene.render.resolution_x, scene.render.resolution_y
    return {"number": number, "jitter": list(jitter),
            # A camera's own scale is no part of what it sees.
            "view": numbers(scene.camera.matrix_world.normalized().inverted()),
            "projection": numbers(scene.camera.calc_matrix_camera(graph, x=size[0], y=size[1]))}


def shifted_side(scene):
    """The side of the picture, in pixels, that a camera's shift is a share of; pixels are square."""
    width, height = scene.render.resolution_x, scene.render.resolution_y
    return {"HORIZONTAL": width, "VERTICAL": height}.get(scene.camera.data.sensor_fit, max(width, height))


def render(scene, samples, filter_type, filter_width, file):
    scene.cycles.samples = samples
    scene.cycles.use_adaptive_sampling = scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = filter_type, filter_width
    scene.render.filepath = file
    bpy.ops.render.render(write_still=True)


def main():
    wanted = arguments()
    first, last = (int(part) for part in wanted.frames.split(".."))
    if not 0 <= first <= last:
        sys.exit(f"--frames {wanted.frames}: numbers of frames are 0 and above, the first one first")
    width, height = (int(part) for part in wanted.size.split("x"))
    if not bpy.data.filepath:
        make_example(first, last)
    scene = set_up(width, height)
    if scene.camera is None:
        sys.exit("the scene has no camera: add one and make it the active one")
    folder = os.path.abspath(wanted.folder)
    os.makedirs(folder, exist_ok=True)
    frames = []
    for number in range(first, last + 1):
        scene.frame_set(number)
        shift = scene.camera.data.shift_x, scene.camera.data.shift_y
        jitter = halton(number, 2) - 0.5, halton(number, 3) - 0.5
        frames.append(frame_facts(scene, number, jitter))
        side = shifted_side(scene)  # up is positive
        scene.camera.data.shift_x = shift[0] + jitter[0] / side
        scene.camera.data.shift_y = shift[1] - jitter[1] / side
        render(scene, 1, "GAUSSIAN", 0.01, os.path.join(folder, f"frame.{number:04}.exr"))
        scene.camera.data.shift_x, scene.camera.data.shift_y = shift
        if wanted.reference:
            render(scene, wanted.reference, "BOX", 1.0, os.path.join(folder, f"reference.{number:04}.exr"))
    layer = bpy.context.view_layer.name
    file = "frame.{frame:4}.exr"
    planes = {"color": {"file": file, "channels": [f"{layer}.Combined.{c}" for c in "RGB"]},
              "motion": {"file": file, "channels": [f"{layer}.Vector.X", f"{layer}.Vector.Y"]},
              "depth": {"file": file, "channels": [f"{layer}.Depth.Z"]},
              "objectId": {"file": file, "channels": [f"{layer}.IndexOB.X"]}}
    if wanted.reference:
        planes["reference"] = {"file": "reference.{frame:4}.exr", "channels": planes["color"]["channels"]}
    manifest = {"format": 1, "name": os.path.basename(bpy.data.filepath) or "Blender example",
                "engine": f"Blender {bpy.app.version_string}, Cycles", "like": "blender", "size": [width, height],
                "framesPerSecond": scene.render.fps / scene.render.fps_base,
                "objects": {str(each.pass_index): each.name for each in scene.objects if each.pass_index},
                "planes": planes, "frames": frames}
    # Last, so that a folder with one is whole.
    with open(os.path.join(folder, "capture.json.part"), "w", encoding="utf-8") as out:
        json.dump(manifest, out, indent=1)
    os.replace(os.path.join(folder, "capture.json.part"), os.path.join(folder, "capture.json"))
    print(f"{folder}: {len(frames)} frames")


main()
