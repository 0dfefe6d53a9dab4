# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the program is, and how it runs."""

import shutil

import bpy
from bpy.props import EnumProperty, IntProperty, StringProperty

from . import messages


class SurfaceMeshCuttingPreferences(bpy.types.AddonPreferences):
    """Preferences of the add-on."""

    bl_idname = __package__

    program: StringProperty(name="Program", default="unwrap", subtype='FILE_PATH',
                            description="The program unwrap: its path, or a name that is found on PATH")
    threads: IntProperty(name="Threads", default=0, min=0, max=1024,
                         description="Number of threads, 0 for all cores. The result does not depend on it")
    on_escape: EnumProperty(
        name="Esc Keeps", default='NOTHING', description="What a run leaves that is ended by Esc",
        items=[('NOTHING', "Nothing", "The mesh stays as it is"),
               ('BEST', "The Best So Far", "The best layout found by then, if there is one; Esc again keeps nothing")])

    def find_program(self):
        """The path of the program, or None."""
        return shutil.which(bpy.path.abspath(self.program) if self.program.startswith("//") else self.program)

    def draw(self, _context):
        self.layout.prop(self, "program")
        if self.find_program() is None:
            self.layout.label(text=messages.NO_PROGRAM, icon='ERROR')
        self.layout.prop(self, "threads")
        self.layout.prop(self, "on_escape")


def of(context):
    """The preferences of this add-on."""
    return context.preferences.addons[__package__].preferences
