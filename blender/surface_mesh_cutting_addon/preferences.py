# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the program is, and how it runs."""

import os
import platform
import shutil
import sys
from pathlib import Path

import bpy
from bpy.props import EnumProperty, IntProperty, StringProperty

from . import messages


# In the archive, one folder for each kind of computer.
BUNDLED = Path(__file__).parent / "bin" / f"{sys.platform}-{platform.machine()}" / "unwrap"


def _bundled_program():
    """The path of the program that came with the add-on, or None. Installing an archive takes the right to run it away."""
    if BUNDLED.is_file() and not os.access(BUNDLED, os.X_OK):
        try:
            BUNDLED.chmod(0o755)
        except OSError:
            return None
    return str(BUNDLED) if BUNDLED.is_file() else None


class SurfaceMeshCuttingPreferences(bpy.types.AddonPreferences):
    """Preferences of the add-on."""

    bl_idname = __package__

    program: StringProperty(name="Program", default="", subtype='FILE_PATH',
                            description="The program unwrap: its path, or a name that is found on PATH. Empty: the one that came "
                                        "with the add-on, or else the one on PATH")
    threads: IntProperty(name="Threads", default=0, min=0, max=1024,
                         description="Number of threads, 0 for as many as there are cores. The result does not depend on it")
    on_escape: EnumProperty(
        name="Esc Keeps", default='NOTHING', description="What remains of a run that Esc ends",
        items=[('NOTHING', "Nothing", "The mesh stays as it is"),
               ('BEST', "The Best So Far", "The best layout found by then, if there is one; Esc again keeps nothing")])

    def find_program(self):
        """The path of the program, or None."""
        if not self.program:
            return _bundled_program() or shutil.which("unwrap")
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
