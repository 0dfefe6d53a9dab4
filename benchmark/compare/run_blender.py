"""Unwraps a mesh in Blender, and tells the processor seconds without Blender's start, reading and writing:

    blender --background --factory-startup --python-exit-code 1 --python run_blender.py -- smart INPUT.obj OUTPUT.obj
    blender ... -- seams MAPPED.obj OUTPUT.obj

`smart` is its Smart UV Project; `seams` unwraps and packs along the seams of MAPPED's texture coordinates."""

import pathlib
import sys
import time

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from surface_files import read_obj  # noqa: E402


def make_object(points, faces):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(points, [], faces)
    # Blender may drop a face in edit mode.
    mesh.attributes.new("number", "INT", "FACE").data.foreach_set("value", range(len(faces)))
    shape = bpy.data.objects.new("shape", mesh)
    bpy.context.collection.objects.link(shape)
    bpy.context.view_layer.objects.active = shape
    shape.select_set(True)
    return shape


def mark_seams(mesh, uvs, faces, uv_faces):
    sides = {}
    for face, uv_face in zip(faces, uv_faces):
        for k in range(3):
            ends = sorted((v, uvs[t]) for v, t in zip((face[k], face[k - 1]), (uv_face[k], uv_face[k - 1])))
            sides.setdefault((ends[0][0], ends[1][0]), set()).add((ends[0][1], ends[1][1]))
    for edge in mesh.edges:
        edge.use_seam = len(sides[tuple(sorted(edge.vertices))]) > 1


def main():
    way, source, output = sys.argv[sys.argv.index("--") + 1:]
    points, faces, uvs, uv_faces = read_obj(source)
    shape = make_object(points, faces)
    if way == "seams":
        mark_seams(shape.data, uvs, faces, uv_faces)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    start = time.process_time()
    if way == "smart":
        bpy.ops.uv.smart_project()
    else:
        bpy.ops.uv.unwrap()
    print(f"seconds {time.process_time() - start}")
    bpy.ops.object.mode_set(mode="OBJECT")
    mesh = shape.data
    uvs = [loop.uv for loop in mesh.uv_layers.active.data]
    numbers = {mesh.attributes["number"].data[polygon.index].value: polygon for polygon in mesh.polygons}
    if len(numbers) != len(faces):
        sys.exit(f"{len(faces) - len(numbers)} faces were dropped")
    with open(output, "w", encoding="ascii") as file:
        file.writelines("v %r %r %r\n" % point for point in points)
        file.writelines("vt %r %r\n" % tuple(uv) for uv in uvs)
        for _, polygon in sorted(numbers.items()):
            file.write("f " + " ".join(f"{mesh.loops[i].vertex_index + 1}/{i + 1}" for i in polygon.loop_indices) + "\n")


main()
