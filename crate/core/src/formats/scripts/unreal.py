
import unreal

LIBRARY = unreal.AnimationLibrary


def notify_class(parent, name):
    """Return the class of a notify, or of a notify state; create its Blueprint if it does not exist."""
    path = "%s/%s_%s" % (FOLDER, parent.__name__, name)
    if not unreal.EditorAssetLibrary.does_asset_exist(path):
        factory = unreal.BlueprintFactory()
        factory.set_editor_property("parent_class", parent)
        tools = unreal.AssetToolsHelpers.get_asset_tools()
        tools.create_asset(path.rsplit("/", 1)[1], FOLDER, unreal.Blueprint, factory)
    return unreal.EditorAssetLibrary.load_blueprint_class(path)


def scale_of(animation):
    """Return the factor of times; an animation that was imported at another frame rate has another length."""
    length = LIBRARY.get_sequence_length(animation)
    if DURATION <= 0.0 or abs(length - DURATION) <= 1.5 / RATE:
        return 1.0
    unreal.log_warning(
        "%s lasts %.3f s and the clip %.3f s: times are scaled." % (animation.get_name(), length, DURATION)
    )
    return length / DURATION


def remove_track(animation):
    """Remove the notifies that an earlier run of the script has added."""
    if LIBRARY.is_valid_anim_notify_track_name(animation, TRACK):
        LIBRARY.remove_animation_notify_track(animation, TRACK)


def main(title, remove, add):
    """Remove what an earlier run has added to the selected animations, and add what the script has."""
    selected = unreal.EditorUtilityLibrary.get_selected_assets()
    animations = [asset for asset in selected if isinstance(asset, unreal.AnimSequence)]
    if not animations:
        raise RuntimeError("Select the animation sequence in the content browser first, then run this script.")
    for animation in animations:
        with unreal.ScopedEditorTransaction(title):
            animation.modify()
            remove(animation)
            if not REMOVE:
                LIBRARY.add_animation_notify_track(animation, TRACK, unreal.LinearColor(0.2, 0.6, 1.0, 1.0))
                add(animation)

