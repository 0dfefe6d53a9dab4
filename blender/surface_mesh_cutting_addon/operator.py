# SPDX-License-Identifier: GPL-3.0-or-later
"""The operator: reads the meshes, lets the program run, and writes its results."""

import time

import bpy

from . import messages, preferences, write_back
from .command import Refusal
from .settings import UnwrapSettings
from .surface import Surface, read_part
from .task import POLLING_TIME, Task

# The view may be turned and moved during a run.
_NAVIGATION = {'MIDDLEMOUSE', 'WHEELUPMOUSE', 'WHEELDOWNMOUSE', 'TRACKPADPAN', 'TRACKPADZOOM', 'NDOF_MOTION'}


def _objects(context):
    """One object for each mesh."""
    chosen = context.objects_in_mode if context.mode == 'EDIT_MESH' else context.selected_objects
    by_mesh = {each.data: each for each in reversed(chosen) if each.type == 'MESH' and each.data.library is None}
    return list(reversed(by_mesh.values()))


def _read_surfaces(context, settings):
    """The surfaces to unwrap, each by itself. Raises `Refusal` if there is none."""
    only_selected = context.mode == 'EDIT_MESH' and settings.only_selected
    parts = [read_part(each, only_selected) for each in _objects(context)]
    parts = [part for part in parts if len(part.faces) > 0]
    if not parts:
        raise Refusal("No face is selected" if only_selected else "The selected objects have no faces")
    if settings.target in write_back.NAMED_TARGETS and not settings.uv_map:
        raise Refusal("The UV map needs a name")
    for part in parts:
        if not write_back.has_place(part.object.data, settings):
            raise Refusal(f'"{part.name}" has {write_back.MAXIMUM_LAYERS} UV maps: remove one')
    return [Surface(parts)] if settings.is_shared else [Surface([part]) for part in parts]


class UV_OT_unwrap_with_shortest_cuts(UnwrapSettings, bpy.types.Operator):
    """Find short seams that let the mesh unwrap with little stretch, and unwrap it along them"""

    bl_idname = "uv.unwrap_with_shortest_cuts"
    bl_label = "Unwrap with Shortest Cuts"
    bl_options = {'REGISTER', 'UNDO'}

    _is_from_dialog = False
    _task = None  # until the dialog is confirmed
    _timer = None
    _is_stopping = False

    @classmethod
    def poll(cls, context):
        return context.mode in {'OBJECT', 'EDIT_MESH'} and bool(_objects(context))

    def draw(self, context):
        self.draw_settings(self.layout, context)

    def invoke(self, context, _event):
        """Asks for the settings. What follows can be watched and ended, unlike a call from a script or a redo."""
        self._is_from_dialog = True
        texts = {"confirm_text": "Unwrap"} if bpy.app.version >= (4, 1) else {}
        return context.window_manager.invoke_props_dialog(self, width=400, **texts)

    def execute(self, context):
        is_from_dialog, self._is_from_dialog = self._is_from_dialog, False
        try:
            self._task = self._start(context)
        except Refusal as refusal:
            self.report({'ERROR'}, str(refusal))
            return {'CANCELLED'}
        if is_from_dialog:
            return self._watch(context)
        manager = context.window_manager
        manager.progress_begin(0, 1)
        try:
            while self._task.advance():
                time.sleep(POLLING_TIME)
            return self._finish(context)
        finally:
            manager.progress_end()
            self._task.close()

    def _start(self, context):
        settings = preferences.of(context)
        program = settings.find_program()
        if program is None:
            raise Refusal(messages.NO_PROGRAM)
        try:
            return Task(_read_surfaces(context, self), self, program, settings.threads, bpy.app.tempdir)
        except OSError as error:
            raise Refusal(f"The program cannot run: {error}") from error

    # ------------------------------------------------------------------------------ while the user can go on looking

    def _watch(self, context):
        manager = context.window_manager
        self._is_stopping = False
        self._timer = manager.event_timer_add(2 * POLLING_TIME, window=context.window)
        manager.modal_handler_add(self)
        self._show_progress(context)
        return {'RUNNING_MODAL'}

    def _show_progress(self, context):
        hint = "ending" if self._is_stopping else "Esc: end"
        context.workspace.status_text_set(f"{self.bl_label}: {self._task.progress()}   ({hint})")

    def modal(self, context, event):
        if event.type == 'ESC' and event.value == 'PRESS':
            if self._is_stopping or preferences.of(context).on_escape == 'NOTHING':
                self.cancel(context)
                self.report({'INFO'}, "Ended: nothing has changed")
                return {'CANCELLED'}
            self._is_stopping = True
            self._task.stop()
        if event.type in _NAVIGATION:
            return {'PASS_THROUGH'}
        if event.type != 'TIMER':
            return {'RUNNING_MODAL'}
        is_running = False
        try:
            is_running = self._task.advance()
            return {'RUNNING_MODAL'} if is_running else self._finish(context)
        finally:
            if is_running:
                self._show_progress(context)
            else:
                self.cancel(context)

    def cancel(self, context):
        """Leaves nothing behind. Blender calls this too when it ends."""
        if self._timer is not None:
            context.window_manager.event_timer_remove(self._timer)
            self._timer = None
            context.workspace.status_text_set(None)
        if self._task is not None:
            self._task.close()

    # ------------------------------------------------------------------------------------------------- at the end

    def _finish(self, context):
        results = self._task.results
        if not all(part.is_up_to_date() for result in results for part in result.surface.parts):
            self.report({'ERROR'}, "A mesh has changed in the meantime: unwrap again")
            return {'CANCELLED'}
        done = [result for result in results if result.corner_uvs is not None]
        failed = [result for result in results if result.corner_uvs is None]
        for result in done:
            write_back.write_result(result, self)
            for text in messages.warnings(result):
                self.report({'WARNING'}, text)
        if done:
            self.report({'INFO'}, messages.summary(done))
        if failed:
            self._tell_failure(context, failed[0], is_all=not done)
        return {'FINISHED'} if done else {'CANCELLED'}

    def _tell_failure(self, context, result, is_all):
        if result.report["witness"]:
            write_back.select_witness(context, result.surface, result.report["witness"])
            if is_all:  # Blender makes no step for what is cancelled
                bpy.ops.ed.undo_push(message="Select What Cannot Be Unwrapped")
        self.report({'ERROR'} if is_all else {'WARNING'}, messages.failure(result))


def draw_menu_item(menu, _context):
    """An entry of a menu. It opens the dialog."""
    menu.layout.separator()
    menu.layout.operator_context = 'INVOKE_DEFAULT'
    menu.layout.operator(UV_OT_unwrap_with_shortest_cuts.bl_idname)
