# SPDX-License-Identifier: GPL-3.0-or-later
"""What needs a window: the dialog, the progress in the status bar, Esc, and undo. Events are simulated:

    blender --factory-startup --enable-event-simulate --python window.py -- ARCHIVE PROGRAM"""

import os
import sys
import tempfile
import time
import traceback
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
sys.dont_write_bytecode = True

import bpy  # noqa: E402

import support  # noqa: E402

PATIENCE = 60  # seconds
STEP = 0.1  # between two looks
texts = []  # what the status bar has shown
cancelled = []  # for each call of cancel(), the error or None


def window():
    return bpy.context.window_manager.windows[0]


def in_view():
    """A context as when the mouse is over the 3D view."""
    area = next(area for area in window().screen.areas if area.type == 'VIEW_3D')
    region = next(region for region in area.regions if region.type == 'WINDOW')
    return bpy.context.temp_override(window=window(), area=area, region=region)


def press(key, **modifiers):
    """In the middle of the 3D view, where the mouse has to be."""
    area = next(area for area in window().screen.areas if area.type == 'VIEW_3D')
    x, y = area.x + area.width // 2, area.y + area.height // 2
    window().event_simulate('MOUSEMOVE', 'NOTHING', x=x, y=y)
    for value in ('PRESS', 'RELEASE'):
        window().event_simulate(key, value, x=x, y=y, **modifiers)


def start(**settings):
    """As the menu does, and then Return in the dialog."""
    texts.clear()
    with in_view():
        bpy.ops.uv.unwrap_with_shortest_cuts('INVOKE_DEFAULT', True, **settings)
    yield
    yield
    press('RET')
    yield


def undo():
    """One step."""
    with in_view():
        bpy.ops.ed.undo()


def is_running():
    return any(name.startswith("unwrap_") for name in os.listdir(bpy.app.tempdir))


def wait(condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, "waited in vain"
        yield


def shown(percent=""):
    return any(percent + " %" in text for text in texts)


# Unwraps, and then waits for Ctrl-C as if it looked for something better.
WAITING_PROGRAM = """#!/usr/bin/env python3
import signal, subprocess, sys
signal.signal(signal.SIGINT, lambda *_: sys.exit(6))
subprocess.run([{program!r}, *sys.argv[1:]], check=True)
while True:
    print("99 waiting", file=sys.stderr, flush=True)
    signal.pause()
"""


def use_waiting_program():
    handle, path = tempfile.mkstemp(dir=bpy.app.tempdir)
    with open(handle, "w") as file:
        file.write(WAITING_PROGRAM.format(program=support.PROGRAM))
    os.chmod(path, 0o755)
    support.preferences().program = path


def layers():
    return len(bpy.context.view_layer.objects.active.data.uv_layers)


def add_large_sphere():
    bpy.ops.object.select_all(action='SELECT')
    bpy.ops.object.delete()
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=6, calc_uvs=False)
    bpy.ops.ed.undo_push(message="Sphere")


def check_result_and_undo():
    """Finishes; one Ctrl-Z takes it back."""
    yield from start()
    yield from wait(lambda: layers() == 1)
    assert support.seams_of(bpy.context.object.data)
    assert not is_running()
    undo()
    yield from wait(lambda: layers() == 0)
    assert not support.seams_of(bpy.context.object.data)
    assert len(bpy.context.object.data.polygons) == 20 * 4 ** 5


def check_repetition():
    """As Adjust Last Operation does: without the dialog, and done when the call returns."""
    yield from start(effort='fast')
    yield from wait(lambda: layers() == 1)
    support.mark_seams(bpy.context.object.data, set())
    with in_view():
        bpy.ops.screen.repeat_last()
    assert not is_running()
    assert support.seams_of(bpy.context.object.data)
    undo()  # the repetition is no step of its own when a script calls it
    yield from wait(lambda: layers() == 0)


def check_escape_in_the_dialog():
    """Nothing begins, and nothing fails."""
    with in_view():
        bpy.ops.uv.unwrap_with_shortest_cuts('INVOKE_DEFAULT', True)
    yield
    yield
    press('ESC')
    yield from wait(lambda: cancelled)
    assert cancelled == [None], cancelled
    assert not is_running() and layers() == 0


def check_escape_keeps_nothing():
    use_waiting_program()
    support.preferences().on_escape = 'NOTHING'
    yield from start(effort='fast')
    yield from wait(lambda: shown("99"))
    assert is_running()
    press('ESC')
    yield from wait(lambda: not is_running())
    assert layers() == 0


def check_escape_keeps_the_best():
    use_waiting_program()
    support.preferences().on_escape = 'BEST'
    yield from start(effort='fast')
    yield from wait(lambda: shown("99"))
    press('ESC')
    yield from wait(lambda: not is_running())
    assert layers() == 1
    undo()
    yield from wait(lambda: layers() == 0)


def steps():
    for check in (check_escape_in_the_dialog, check_result_and_undo, check_repetition, check_escape_keeps_nothing,
                  check_escape_keeps_the_best):
        begin = time.monotonic()
        yield from check()
        print(f"{check.__name__}: {time.monotonic() - begin:.1f} s", flush=True)


def tick(running):
    """A step of the checks; Blender handles events between them."""
    try:
        next(running)
    except StopIteration:
        os._exit(0)
    except BaseException:
        traceback.print_exc()
        os._exit(1)
    return STEP


def note_status_texts():
    """The status bar has no property to read what it shows."""
    operator = sys.modules[support.ADDON + ".operator"].UV_OT_unwrap_with_shortest_cuts
    show = operator._show_progress

    def noting(self, context):
        texts.append(self._task.progress())
        show(self, context)
    operator._show_progress = noting


def note_errors_of_cancel():
    """Blender prints them, and goes on."""
    operator = sys.modules[support.ADDON + ".operator"].UV_OT_unwrap_with_shortest_cuts
    cancel = operator.cancel

    def noting(self, context):
        error = None
        try:
            cancel(self, context)
        except Exception as caught:
            error = caught
            raise
        finally:
            cancelled.append(error)
    operator.cancel = noting


support.install()
note_status_texts()
note_errors_of_cancel()
add_large_sphere()
running = steps()
bpy.app.timers.register(lambda: tick(running), first_interval=1)
