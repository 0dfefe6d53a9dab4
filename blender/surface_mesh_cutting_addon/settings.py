# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user chooses for a run."""

from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty


class UnwrapSettings:
    """The properties of the operator, and how they are laid out."""

    effort: EnumProperty(
        name="Effort", default='default', description="How hard to look for short seams",
        items=[('fast', "Fast", "Seams are not shortened"),
               ('default', "Default", "Seams are shortened"),
               ('best', "Best", "Several starts and many variants: takes several times as long")])
    has_bound: BoolProperty(
        name="Bound the Distortion", default=False,
        description="Add seams until the mean energy is at most the bound, and leave out those that it does not ask for")
    bound: FloatProperty(
        name="Bound", default=4.1, min=4.0001, soft_max=5, max=1e6, precision=3, step=1,
        description="Of the mean symmetric Dirichlet energy: 4 means no distortion, 4.1 is barely visible")
    may_overlap: BoolProperty(
        name="Allow Overlaps", default=False,
        description="Parts of the layout may overlap: faster, and a little less distortion")

    marked_seams: EnumProperty(
        name="Marked Seams", default='IGNORE', description="What becomes of the seams that are marked now",
        items=[('IGNORE', "Ignore", "Find new seams"),
               ('KEEP', "Keep", "Cut all of them, and what else is needed"),
               ('START', "Start From", "Connect, extend and shorten them; some may be left out")])
    sharp: BoolProperty(name="Prefer Creases", default=False,
                        description="Where faces meet at an angle, seams cost down to a fifth of their length")
    marked_sharp: BoolProperty(name="Prefer Edges Marked Sharp", default=False,
                               description="At edges marked as sharp, seams cost a fifth of their length")
    hidden: BoolProperty(name="Prefer Hidden Places", default=False,
                         description="Where the surface hides itself, seams cost down to a tenth of their length")
    straight: BoolProperty(name="Prefer Straight Lines", default=False,
                           description="Along and across the direction in which the surface bends most, seams cost down to a "
                                       "fifth of their length")
    vertex_group: StringProperty(name="Vertex Group", default="", options={'SKIP_SAVE'},  # other objects have others
                                 description="Vertex group that says where seams are not wanted, or wanted")
    group_use: EnumProperty(
        name="Group", default='AVOID', description="What the weights of the vertex group mean",
        items=[('AVOID', "Avoid", "Seams cost up to ten times their length where the weight is 1"),
               ('PREFER', "Prefer", "Seams cost down to a tenth of their length where the weight is 1"),
               ('NEVER', "Never", "No seam on an edge with a weight of at least 0.5 at both ends")])

    only_selected: BoolProperty(name="Only Selected Faces", default=True,
                                description="In edit mode: leave the coordinates of all other faces as they are")
    is_shared: BoolProperty(
        name="One Layout for All Objects", default=True,
        description="Several objects share the unit square, at the same scale; otherwise, each has a square of its own")
    scale: EnumProperty(
        name="Scale", default='unit', description="Size of the layout",
        items=[('unit', "Unit Square", "All charts in the unit square, as large as possible"),
               ('surface', "World", "A unit of the layout is a unit of the world")])
    texture_size: IntProperty(name="Texture Size", default=1024, min=1, soft_min=64, max=65536, subtype='PIXEL',
                              description="Pixels along a side of the texture, for the margin")
    margin: FloatProperty(name="Margin", default=2, min=0, soft_max=64, max=16384, precision=1,
                          description="Pixels between charts, and to the border of the square")

    target: EnumProperty(
        name="Write To", default='ACTIVE', description="Where the coordinates go",
        items=[('ACTIVE', "Active UV Map", "Replace coordinates in the active UV map; one is added where there is none"),
               ('NEW', "New UV Map", "Add a UV map and make it the active one")])
    mark_seams: BoolProperty(name="Mark Seams", default=True, description="Mark the edges along which is cut as seams")
    clear_seams: BoolProperty(name="Clear Old Seams", default=True,
                              description="Edges between unwrapped faces along which is not cut are no seams any more")
    time_limit: FloatProperty(
        name="Time Limit", default=0, min=0, soft_max=600, max=1e9, precision=1, subtype='TIME_ABSOLUTE', unit='TIME_ABSOLUTE',
        description="Seconds after which the best result so far is taken; 0 means none")

    def draw_settings(self, layout, context):
        """All properties, in groups."""
        layout.use_property_split = True
        layout.use_property_decorate = False
        column = layout.column()
        column.prop(self, "effort")
        column.prop(self, "time_limit")
        row = column.row(heading="Bound the Distortion")
        row.prop(self, "has_bound", text="")
        sub = row.row()
        sub.active = self.has_bound
        sub.prop(self, "bound", text="")
        column.prop(self, "may_overlap")

        column = layout.column(heading="Where to Cut")
        column.prop(self, "marked_seams")
        for name in ("sharp", "marked_sharp", "hidden", "straight"):
            column.prop(self, name)
        if context.object is not None:
            column.prop_search(self, "vertex_group", context.object, "vertex_groups")
        sub = column.column()
        sub.active = bool(self.vertex_group)
        sub.prop(self, "group_use", text="Seams There")

        column = layout.column(heading="Layout")
        if context.mode == 'EDIT_MESH':
            column.prop(self, "only_selected")
        column.prop(self, "is_shared")
        column.prop(self, "scale")
        column.prop(self, "texture_size")
        column.prop(self, "margin")

        column = layout.column(heading="Result")
        column.prop(self, "target")
        column.prop(self, "mark_seams")
        sub = column.column()
        sub.active = self.mark_seams
        sub.prop(self, "clear_seams")
