"""Memory and time that the module itself takes."""

import ctypes
import gc
import subprocess
import sys
import weakref

import numpy as np

import meshes
import surface_mesh_cutting as smc


class Malloc_information(ctypes.Structure):
    """`struct mallinfo2` of the GNU C library."""
    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")]


def allocated_kilobytes():
    """By all threads. What is resident tells less: heaps of threads grow and shrink by megabytes at any time."""
    mallinfo2 = ctypes.CDLL(None).mallinfo2
    mallinfo2.restype = Malloc_information
    information = mallinfo2()
    return (information.uordblks + information.hblkhd) / 1024


def call_all(points, faces):
    result = smc.unwrap(points, faces, effort="fast", threads=1, progress=lambda phase, fraction: None)
    smc.certify_unwrap(points, faces, result.corner_uv)
    smc.steiner_tree(result.cut_edges, np.ones(len(result.cut_edges)), result.cut_edges[0])
    for wrong in (dict(terminals=[10**6]), dict(time_limit=1e-9), dict(forbidden_edges=meshes.edges(faces))):
        try:
            smc.unwrap(points, faces, **wrong)
        except smc.Error:
            pass


def test_no_leak_over_1000_calls():
    points, faces = meshes.sphere(2)
    for _ in range(100):
        call_all(points, faces)
    growths, objects = [], []
    for _ in range(4):
        gc.collect()
        kilobytes, blocks = allocated_kilobytes(), sys.getallocatedblocks()
        for _ in range(250):
            call_all(points, faces)
        gc.collect()
        growths.append(allocated_kilobytes() - kilobytes)
        objects.append(sys.getallocatedblocks() - blocks)
    # A kept array of UVs would be 2 kilobytes in each call. Threads that start late have memory of their own, but once.
    assert sum(sorted(growths)[:-1]) < 100
    assert sum(sorted(objects)[:-1]) < 100


def test_results_are_freed():
    result = smc.unwrap(*meshes.sphere(2))
    freed = []
    for array in (result.uv, result.uv_points, result.cut_edges, result.trade_offs):
        weakref.finalize(array, freed.append, 1)
    del array, result
    gc.collect()
    assert len(freed) == 4


def test_arguments_are_freed():
    points, faces = meshes.sphere(2)
    counts = sys.getrefcount(points), sys.getrefcount(faces)
    smc.unwrap(points, faces)
    assert counts == (sys.getrefcount(points), sys.getrefcount(faces))


def test_import_time():
    code = """
import time, resource
def used(): u = resource.getrusage(resource.RUSAGE_SELF); return u.ru_utime + u.ru_stime
start = used()
import numpy
after_numpy = used()
import surface_mesh_cutting
print(used() - start, used() - after_numpy)
"""
    runs = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
            for _ in range(5)]
    total, own = (min(map(float, column)) for column in zip(*runs))
    assert own < 0.1, f"{total} s of processor time with NumPy, {own} s without"
