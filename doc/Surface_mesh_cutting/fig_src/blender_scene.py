# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders the manual's picture of the add-on: Suzanne, unwrapped in Blender, with her seams and a checkerboard, and her
layout beside her: scripts/test_blender.sh --picture."""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[3] / "blender/test"))
sys.dont_write_bytecode = True

import bpy  # noqa: E402

import support  # noqa: E402

WIDTH, HEIGHT = 640, 280  # pixels
SAMPLES = 200
SQUARES = 32  # along a side of the unit square
SEAM_RADIUS = 0.012
LAYOUT_SIZE = 2.9


def checkerboard():
    material = bpy.data.materials.new("Checkerboard")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    checker = nodes.new("ShaderNodeTexChecker")
    checker.inputs["Scale"].default_value = SQUARES
    checker.inputs["Color1"].default_value = (0.9, 0.88, 0.82, 1)
    checker.inputs["Color2"].default_value = (0.12, 0.3, 0.55, 1)
    coordinates = nodes.new("ShaderNodeTexCoord")
    links.new(coordinates.outputs["UV"], checker.inputs["Vector"])
    shader = nodes["Principled BSDF"]
    shader.inputs["Roughness"].default_value = 0.6
    links.new(checker.outputs["Color"], shader.inputs["Base Color"])
    return material


def red():
    material = bpy.data.materials.new("Seams")
    material.diffuse_color = (0.8, 0.05, 0.02, 1)
    material.use_nodes = True
    material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.8, 0.05, 0.02, 1)
    return material


def add_tubes(lines, parent=None):
    """Each line is a list of points."""
    curve = bpy.data.curves.new("Seams", 'CURVE')
    curve.dimensions = '3D'
    curve.bevel_depth = SEAM_RADIUS
    for points in lines:
        spline = curve.splines.new('POLY')
        spline.points.add(len(points) - 1)
        for target, point in zip(spline.points, points):
            target.co = (*point, 1)
    tubes = bpy.data.objects.new("Seams", curve)
    tubes.data.materials.append(red())
    tubes.parent = parent
    bpy.context.collection.objects.link(tubes)


def add_layout(mesh, material):
    """The layout as a flat mesh that stands upright, with its border."""
    uvs = support.uvs_of(mesh)
    points = [((u - 0.5) * LAYOUT_SIZE, 0, (v - 0.5) * LAYOUT_SIZE) for u, v in uvs.tolist()]
    faces = [tuple(polygon.loop_indices) for polygon in mesh.polygons]
    layout = support.add_mesh("Layout", points, faces)
    layer = layout.data.uv_layers.new(name="UVMap")
    for corner in layout.data.loops:
        layer.data[corner.index].uv = uvs[corner.vertex_index]
    layout.data.materials.append(material)
    seams = support.seams_of(mesh)
    borders = []
    for polygon in mesh.polygons:
        corners = list(polygon.loop_indices)
        for a, b in zip(corners, corners[1:] + corners[:1]):
            if frozenset((mesh.loops[a].vertex_index, mesh.loops[b].vertex_index)) in seams:
                borders.append([points[a], points[b]])
    layout.location = (1.9, 0, 0)
    add_tubes(borders, layout)


def add_monkey(material):
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.object
    monkey.modifiers.new("Subdivision", 'SUBSURF').levels = 2
    bpy.ops.object.modifier_apply(modifier="Subdivision")
    bpy.ops.object.shade_smooth()
    support.unwrap(hidden=True)
    monkey.data.materials.append(material)
    add_tubes([[monkey.data.vertices[v].co for v in edge] for edge in support.seams_of(monkey.data)], monkey)
    monkey.location = (-1.75, 0, 0)
    monkey.rotation_euler = (math.radians(-15), 0, math.radians(-22))
    monkey.scale = (1.3, 1.3, 1.3)
    return monkey


def add_light_and_camera():
    sun = bpy.data.lights.new("Sun", 'SUN')
    sun.energy = 2
    sun.angle = 0.5
    light = bpy.data.objects.new("Sun", sun)
    light.rotation_euler = (math.radians(50), math.radians(-10), math.radians(-20))
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.type = 'ORTHO'
    camera.data.ortho_scale = 7.2
    camera.location = (0, -10, 0)
    camera.rotation_euler = (math.radians(90), 0, 0)
    for each in (light, camera):
        bpy.context.collection.objects.link(each)
    scene = bpy.context.scene
    scene.camera = camera
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    background.inputs["Strength"].default_value = 0.6


def render(path):
    scene = bpy.context.scene
    scene.render.engine = 'CYCLES'
    scene.cycles.samples = SAMPLES
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.render.film_transparent = True
    scene.render.image_settings.file_format = 'PNG'
    scene.render.image_settings.compression = 100
    scene.view_settings.view_transform = 'Standard'
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


support.install()
for each in list(bpy.data.objects):
    bpy.data.objects.remove(each)
material = checkerboard()
add_layout(add_monkey(material).data, material)
add_light_and_camera()
render(str(Path(support.WORDS[0]).resolve()))
