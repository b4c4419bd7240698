# SPDX-License-Identifier: GPL-3.0-or-later
"""Mocapress clips (.mcpr) in Blender, through the Python package `mocapress` or the program."""
import bpy
from bpy.props import IntProperty, StringProperty

from . import operators, package, program

bl_info = {
    "name": "Mocapress",
    "description": "Import and export compressed motion capture clips (.mcpr)",
    "author": "The Mocapress authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "File > Import, File > Export",
    "warning": "",
    "doc_url": "",
    "category": "Import-Export",
}


class MocapressPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: StringProperty(
        name="Program", subtype="FILE_PATH",
        description="The program mocapress. Empty: the Python package mocapress where Blender's "
                    "Python has it, else the program on the PATH, or where packages install it")
    timeout: IntProperty(
        name="Longest Run (s)", default=600, min=1,
        description="Seconds after which a run is stopped")

    def draw(self, context):
        self.layout.prop(self, "program")
        self.layout.prop(self, "timeout")
        if package.is_used():
            self.layout.label(text=f"Uses the Python package {package.library.__version__}",
                              icon="CHECKMARK")
            return
        try:
            self.layout.label(text=f"Uses {program.find()}", icon="CHECKMARK")
        except program.Failure:
            self.layout.label(text="mocapress was not found: install it, or name its path above",
                              icon="ERROR")


CLASSES = (MocapressPreferences, operators.MOCAPRESS_OT_import, operators.MOCAPRESS_OT_export)


def import_entry(menu, context):
    menu.layout.operator(operators.MOCAPRESS_OT_import.bl_idname, text="Mocapress (.mcpr)")


def export_entry(menu, context):
    menu.layout.operator(operators.MOCAPRESS_OT_export.bl_idname, text="Mocapress (.mcpr)")


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.TOPBAR_MT_file_import.append(import_entry)
    bpy.types.TOPBAR_MT_file_export.append(export_entry)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(export_entry)
    bpy.types.TOPBAR_MT_file_import.remove(import_entry)
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
