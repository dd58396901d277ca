
import unreal

LIBRARY = unreal.AnimationLibrary
# Everything that the script adds is on this track, or is a curve of CURVES.
TRACK = "Plantigrade"
FLOAT = unreal.RawCurveTrackTypes.RCT_FLOAT


def notify_class(name):
    """Return the class of a notify; create its Blueprint if it does not exist."""
    path = "%s/AnimNotify_%s" % (FOLDER, name)
    if not unreal.EditorAssetLibrary.does_asset_exist(path):
        factory = unreal.BlueprintFactory()
        factory.set_editor_property("parent_class", unreal.AnimNotify)
        tools = unreal.AssetToolsHelpers.get_asset_tools()
        tools.create_asset("AnimNotify_" + name, FOLDER, unreal.Blueprint, factory)
    return unreal.EditorAssetLibrary.load_blueprint_class(path)


def remove(animation):
    """Remove what an earlier run of the script has added."""
    LIBRARY.remove_animation_sync_markers_by_track(animation, TRACK)
    if LIBRARY.is_valid_anim_notify_track_name(animation, TRACK):
        LIBRARY.remove_animation_notify_track(animation, TRACK)
    for name, _ in CURVES:
        if LIBRARY.does_curve_exist(animation, name, FLOAT):
            LIBRARY.remove_curve(animation, name)


def curve_keys(plants, end):
    """Return times and values of a curve that is 1 during plants; each step takes a millisecond."""
    keys = {0.0: 0.0, end: 0.0}
    for start, stop in plants:
        if start > 0.0:
            keys[max(0.0, start - 0.0005)] = 0.0
        keys[min(end, start + 0.0005) if start > 0.0 else 0.0] = 1.0
        if stop < end:
            keys[stop - 0.0005] = 1.0
            keys[min(end, stop + 0.0005)] = 0.0
        else:
            keys[end] = 1.0
    times = sorted(keys)
    return times, [keys[time] for time in times]


def add(animation):
    """Add notifies, sync markers and curves at the times of the clip."""
    length = LIBRARY.get_sequence_length(animation)
    # An animation that was imported at another frame rate has another length.
    scale = length / DURATION if DURATION > 0.0 else 1.0
    if abs(scale - 1.0) * DURATION > 1.5 / RATE:
        unreal.log_warning(
            "%s lasts %.3f s and the clip %.3f s: times are scaled." % (animation.get_name(), length, DURATION)
        )
    else:
        scale = 1.0
    LIBRARY.add_animation_notify_track(animation, TRACK, unreal.LinearColor(0.2, 0.6, 1.0, 1.0))
    for time, name, is_marker in EVENTS:
        at = min(time * scale, length)
        LIBRARY.add_animation_notify_event(animation, TRACK, at, notify_class(name))
        if is_marker:
            LIBRARY.add_animation_sync_marker(animation, name, at, TRACK)
    for name, plants in CURVES:
        times, values = curve_keys([(start * scale, end * scale) for start, end in plants], length)
        LIBRARY.add_curve(animation, name, FLOAT, False)
        LIBRARY.add_float_curve_keys(animation, name, times, values)


def main():
    selected = unreal.EditorUtilityLibrary.get_selected_assets()
    animations = [asset for asset in selected if isinstance(asset, unreal.AnimSequence)]
    if not animations:
        raise RuntimeError("Select the animation sequence in the content browser first, then run this script.")
    for animation in animations:
        with unreal.ScopedEditorTransaction("Plantigrade foot events"):
            animation.modify()
            remove(animation)
            if not REMOVE:
                add(animation)


main()
