"""Puts the scripts of scenes, and what they need, into a folder."""
import os
from . import assets, hostile, lua, pov, runs, scenes


def put(folder, name):
    """Writes the scene called `name`. -> its script"""
    os.makedirs(folder, exist_ok=True)
    script = os.path.join(folder, name + ".lua")
    if name in hostile.SCENES:
        runs.write_if_changed(script, hostile.SCENES[name](folder))
        return script
    scene = scenes.SCENES[name]()
    for o in scene["objects"]:
        if o["type"] == "mesh" and not os.path.exists(os.path.join(folder, "mesh_%s.inc" % o["size"])):
            assets.write_blob(folder, o["size"])
        if o["type"] == "tiles":
            assets.floor_texture(os.path.join(folder, o["file"]))
            assets.rectangle(os.path.join(folder, name + "_tiles.obj"), o["min"], o["max"], o["y"], o["scale"])
    runs.write_if_changed(script, lua.script(scene))
    runs.write_if_changed(os.path.join(folder, name + ".pov"), pov.script(scene))
    return script
