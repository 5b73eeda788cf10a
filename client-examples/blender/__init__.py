"""What Blender 4.2 and later load of this folder as an extension; older ones install tuftwave_hair.py alone."""

from .tuftwave_hair import bl_info, register, unregister

__all__ = ["bl_info", "register", "unregister"]
