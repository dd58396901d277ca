
import bpy


def channels(action):
    """Return the lists of curves of an action, which are in layers since Blender 4.4."""
    if hasattr(action, "fcurves"):
        return [action.fcurves]
    return [bag.fcurves for layer in action.layers for strip in layer.strips for bag in strip.channelbags]


def curves_of(armature, path):
    """Return the curves of a property, each with the list that contains it."""
    data = armature.animation_data
    action = data.action if data else None
    lists = channels(action) if action else []
    return [(curves, curve) for curves in lists for curve in list(curves) if curve.data_path == path]


def main():
    scene = bpy.context.scene
    armature = bpy.context.object
    if armature is None or armature.type != "ARMATURE":
        raise RuntimeError("Select the imported armature first, then run this script.")
    scale = scene.render.fps / scene.render.fps_base / RATE if SCALED else 1.0

    def at(frame):
        return FRAME_START + round(frame * scale)

    existing = {(marker.name, marker.frame) for marker in scene.timeline_markers}
    for frame, name in EVENTS:
        if (name, at(frame)) not in existing:
            scene.timeline_markers.new(name, frame=at(frame))

    for name, plants in PLANTS:
        path = '["%s"]' % bpy.utils.escape_identifier(name)
        # Running the script again replaces the keys.
        for curves, curve in curves_of(armature, path):
            curves.remove(curve)
        keys = {0: 0}
        for start, end in plants:
            keys[start] = 1
            keys[end] = 0
        for frame in sorted(keys):
            if frame < FRAMES:
                armature[name] = keys[frame]
                armature.keyframe_insert(data_path=path, frame=at(frame))
        for _, curve in curves_of(armature, path):
            for key in curve.keyframe_points:
                key.interpolation = "CONSTANT"


main()
