# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user chooses for a run."""

import math

from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

# A setting that a preset does not mention has the value of "Balanced".
BALANCED = {"limits_stretch": False, "stretch": 12.0, "cut_sharp": False, "hidden": False, "straight": False}
PRESETS = {
    'BALANCED': {},
    'FEW_SEAMS': {"limits_stretch": True, "stretch": 25.0},
    'LITTLE_STRETCH': {"limits_stretch": True, "stretch": 8.0},
    'CHARACTER': {"limits_stretch": True, "hidden": True},
    'HARD_SURFACE': {"cut_sharp": True, "straight": True},
}


def apply_preset(settings, _context=None):
    for name, value in {**BALANCED, **PRESETS[settings.preset]}.items():
        setattr(settings, name, value)


class UnwrapSettings:
    """The properties of the operator, and how they are laid out."""

    preset: EnumProperty(
        name="Preset", default='BALANCED', update=apply_preset, description="A starting point, which fills in the settings below",
        items=[('BALANCED', "Balanced", "Short seams and moderate stretch"),
               ('FEW_SEAMS', "Few Seams", "As little seam as a stretch of 25 % allows"),
               ('LITTLE_STRETCH', "Little Stretch", "More seams, so that lengths differ by 8 %"),
               ('CHARACTER', "Character", "Seams where they are hard to see, and little stretch"),
               ('HARD_SURFACE', "Hard Surface", "Seams along all hard edges and otherwise in straight lines")])
    effort: EnumProperty(
        name="Effort", default='default', description="How long to look for shorter seams",
        items=[('fast', "Fast", "For a first impression"),
               ('default', "Normal", "For most models"),
               ('best', "Thorough", "Takes several times as long; seams may be a little shorter")])
    limits_stretch: BoolProperty(
        name="Limit Stretch", default=BALANCED["limits_stretch"],
        description="Add seams until the mean stretch is below the limit, and remove those that it does not require")
    stretch: FloatProperty(
        name="Limit", default=BALANCED["stretch"], min=0.1, soft_min=2, soft_max=50, max=1e4, precision=1, subtype='PERCENTAGE',
        description="How much longer or shorter lengths in the layout are than on the model, on average. "
                    "12 % is barely visible on a checkerboard")
    limits_island_stretch: BoolProperty(
        name="Limit Stretch of Islands", default=False, description="The same for the mean stretch of each island by itself")
    island_stretch: FloatProperty(
        name="Limit", default=12, min=0.1, soft_min=2, soft_max=50, max=1e4, precision=1, subtype='PERCENTAGE',
        description="How much longer or shorter lengths of an island are than on the model, on average")
    limits_face_stretch: BoolProperty(
        name="Limit Stretch of Faces", default=False, description="Add seams until single faces are stretched less than the limit")
    face_stretch: FloatProperty(
        name="Limit", default=75, min=0.1, soft_min=10, soft_max=200, max=1e4, precision=1, subtype='PERCENTAGE',
        description="How much longer or shorter lengths of a face may be than on the model")
    face_share: FloatProperty(
        name="Share of Faces", default=100, min=0.1, soft_min=90, max=100, precision=1, subtype='PERCENTAGE',
        description="How much of the area has to keep the limit of faces; the rest may be stretched more")
    may_overlap: BoolProperty(
        name="Allow Overlaps", default=False,
        description="Parts of an island may lie on top of each other: faster, and slightly less stretch")

    symmetry: EnumProperty(
        name="Symmetry", default='off', description="Mirror the seams of symmetric models",
        items=[('off', "Off", "Seams are as short as possible on each side"),
               ('auto', "Automatic", "At the best plane of symmetry, wherever it lies"),
               ('x', "X", "Between left and right in the world, wherever the plane lies"),
               ('y', "Y", "Between front and back in the world"),
               ('z', "Z", "Between above and below in the world")])
    seam_smoothness: FloatProperty(
        name="Straighten", default=1, min=0, soft_max=10, max=100, precision=1, subtype='PERCENTAGE',
        description="How much longer seams may become to be straighter")
    marked_seams: EnumProperty(
        name="Marked Seams", default='KEEP', description="What to do with seams that are already marked",
        items=[('KEEP', "Keep", "Every marked seam stays a seam; more are added where they are needed"),
               ('START', "Improve", "Use them as a starting point: they are connected, shortened and completed"),
               ('IGNORE', "Ignore", "Find new seams without regard to them")])
    cut_sharp: BoolProperty(name="Seams at Hard Edges", default=BALANCED["cut_sharp"],
                            description="Make every edge a seam where faces meet at the angle below or a larger one")
    sharp_angle: FloatProperty(name="Angle", default=math.radians(45), min=math.radians(1), max=math.pi, subtype='ANGLE',
                               description="The smallest angle between faces that makes their edge a hard one")
    cut_marked_sharp: BoolProperty(name="Seams at Edges Marked Sharp", default=False,
                                   description="Make every edge that is marked as sharp a seam")
    cut_materials: BoolProperty(name="Seams between Materials", default=False,
                                description="Make every edge a seam where faces of different materials meet")
    hard_surface: BoolProperty(name="Prefer Hard Edges", default=False,
                               description="Seams follow edges where faces meet at 60 degrees or more, and otherwise straight lines")
    sharp: BoolProperty(name="Prefer Creases", default=False,
                        description="Seams follow folds of the surface where they can")
    marked_sharp: BoolProperty(name="Prefer Edges Marked Sharp", default=False,
                               description="Seams follow edges that are marked as sharp where they can")
    hidden: BoolProperty(name="Prefer Hidden Places", default=BALANCED["hidden"],
                         description="Seams go where they are hard to see, such as under arms and between legs")
    straight: BoolProperty(name="Prefer Straight Lines", default=BALANCED["straight"],
                           description="Seams run along or across the model rather than at odd angles")
    vertex_group: StringProperty(name="Vertex Group", default="", options={'SKIP_SAVE'},  # other objects have others
                                 description="The vertex group that says where seams are wanted or not")
    group_use: EnumProperty(
        name="Group", default='AVOID', description="What the painted weights mean",
        items=[('AVOID', "Avoid", "Few seams where the weight is high"),
               ('PREFER', "Prefer", "Seams rather where the weight is high"),
               ('NEVER', "Never", "No seam on edges with a weight of at least 0.5 at both ends")])

    only_selected: BoolProperty(name="Only Selected Faces", default=True,
                                description="In edit mode, leave all other faces as they are")
    is_shared: BoolProperty(
        name="One Layout for All Objects", default=True,
        description="Pack the islands of all objects into one square, at the same scale. Otherwise each object has its own")
    scale: EnumProperty(
        name="Scale", default='unit', description="Size of the layout",
        items=[('unit', "Fill the Square", "All islands in the square, as large as possible"),
               ('surface', "World", "A unit of the layout is a unit of the world")])
    texture_size: IntProperty(name="Texture Size", default=1024, min=1, soft_min=64, max=65536, subtype='PIXEL',
                              description="Pixels along a side of the texture, in which the margin is measured")
    margin: FloatProperty(name="Margin", default=4, min=0, soft_max=64, max=16384, precision=1,
                          description="Pixels between islands, and to the border of the square")

    limits_density: BoolProperty(
        name="Set Texel Density", default=False,
        description="Scale islands to a number of pixels per unit, on as many UDIM tiles as that takes, rather than fill tiles")
    density: FloatProperty(name="Pixels per Unit", default=256, min=1e-3, soft_max=4096, max=1e9, precision=1,
                           description="Pixels of the texture for a unit of the world")
    pages: IntProperty(name="UDIM Tiles", default=1, min=1, soft_max=20, max=1000,
                       description="How many tiles the islands fill, all at the same scale")
    stacks: BoolProperty(
        name="Stack Equal Parts", default=False,
        description="Parts that have the same shape, or are mirror images, share one place in the layout")
    limits_fill: BoolProperty(name="Divide Long Islands", default=False,
                              description="Cut islands that are so long that most of the square stays empty")
    fill: FloatProperty(name="Filled Share", default=50, min=0, max=100, precision=0, subtype='PERCENTAGE',
                        description="How much of the square is to be filled, if that is worth the seams")

    turn: EnumProperty(
        name="Turn Islands", default='automatic', description="How islands may be turned to fit into the square",
        items=[('automatic', "Aligned", "Straight with the texture, unless that costs much room"),
               ('quarter', "Straight", "Always straight with the texture"),
               ('upright', "Upright", "Straight, with vertical axes of symmetric islands"),
               ('any', "Freely", "By any angle, so that islands are as large as possible"),
               ('none', "Not at All", "Islands keep the direction in which they were flattened")])

    target: EnumProperty(
        name="Write To", default='ACTIVE', description="Where the layout goes",
        items=[('ACTIVE', "Active UV Map", "Replace the active UV map; one is added if there is none"),
               ('NEW', "New UV Map", "Add a UV map and make it the active one"),
               ('NAMED', "UV Map by Name", "Replace the UV map of the name below, or add it; other UV maps stay"),
               ('LIGHT_MAP', "Light Map by Name", "The same for light: with the margin that mipmaps need, and nothing stacked"),
               ('SEAMS', "Seams Only", "Mark seams, and leave all UV maps as they are")])
    uv_map: StringProperty(name="Name", default="Lightmap", maxlen=63, description="The UV map to replace or to add")
    mark_seams: BoolProperty(name="Mark Seams", default=True, description="Mark the edges between islands as seams")
    clear_seams: BoolProperty(name="Clear Other Seams", default=False,
                              description="Remove the marks of seams that this layout does not need")
    time_limit: FloatProperty(
        name="Time Limit", default=0, min=0, soft_max=600, max=1e9, precision=1, subtype='TIME_ABSOLUTE', unit='TIME_ABSOLUTE',
        description="Seconds after which the best layout found so far is used; 0 for no limit")

    def draw_settings(self, layout, context):
        """All properties, in groups."""
        layout.use_property_split = True
        layout.use_property_decorate = False
        self._draw_quality(layout)
        self._draw_seams(_group(layout, "Seams"), context)
        self._draw_layout(_group(layout, "Islands"), context)
        self._draw_result(_group(layout, "Result"))

    def _draw_quality(self, column):
        column.prop(self, "preset")
        self._draw_limit(column, "Limit Stretch", "limits_stretch", "stretch")
        self._draw_limit(column, "Of Islands", "limits_island_stretch", "island_stretch")
        self._draw_limit(column, "Of Faces", "limits_face_stretch", "face_stretch")
        sub = column.row()
        sub.active = self.limits_face_stretch
        sub.prop(self, "face_share")
        column.prop(self, "effort")
        column.prop(self, "time_limit")

    def _draw_seams(self, column, context):
        column.prop(self, "marked_seams")
        column.prop(self, "symmetry")
        column.prop(self, "seam_smoothness")
        self._draw_limit(column, "At Hard Edges", "cut_sharp", "sharp_angle")
        for name in ("cut_marked_sharp", "cut_materials", "hard_surface", "sharp", "marked_sharp", "hidden", "straight"):
            column.prop(self, name)
        if context.object is not None:
            column.prop_search(self, "vertex_group", context.object, "vertex_groups")
        sub = column.column()
        sub.active = bool(self.vertex_group)
        sub.prop(self, "group_use", text="Seams There")

    def _draw_layout(self, column, context):
        if context.mode == 'EDIT_MESH':
            column.prop(self, "only_selected")
        for name in ("is_shared", "scale", "texture_size", "margin", "turn", "may_overlap", "stacks"):
            row = column.row()
            row.active = name != "margin" or self.target != 'LIGHT_MAP'
            row.prop(self, name)
        row = self._draw_limit(column, "Set Texel Density", "limits_density", "density")
        row.active = self.scale == 'unit'
        row = column.row()
        row.active = self.scale == 'unit' and not self.limits_density
        row.prop(self, "pages")
        row = self._draw_limit(column, "Divide Long Islands", "limits_fill", "fill")
        row.active = self.scale == 'unit' and not self.limits_density

    def _draw_limit(self, column, heading, switch, value):
        """A switch, and the value that it makes count."""
        row = column.row(heading=heading)
        row.prop(self, switch, text="")
        sub = row.row()
        sub.active = getattr(self, switch)
        sub.prop(self, value, text="")
        return row

    def _draw_result(self, column):
        column.prop(self, "target")
        if self.target in ('NAMED', 'LIGHT_MAP'):
            column.prop(self, "uv_map")
        sub = column.column()
        sub.active = self.target != 'SEAMS'
        sub.prop(self, "mark_seams")
        sub = column.column()
        sub.active = self.mark_seams or self.target == 'SEAMS'
        sub.prop(self, "clear_seams")


def _group(layout, title):
    box = layout.box()
    box.label(text=title)
    return box.column()
