"""Stub of the functions of Unreal Engine that the exported script calls, with their documented parameters.

Runs `clip.unreal.py` three times, the last time to remove, and prints what is in the animation after each run
as JSON. `LENGTH` is the duration of the animation in seconds.
"""

import json
import sys
import types


class AnimNotify:
    pass


class AnimNotifyState:
    pass


class Blueprint:
    pass


class AnimSequence:
    def __init__(self, length):
        self.length = length
        self.tracks, self.notifies, self.markers, self.curves = ["Other"], [], [], {"Other": []}
        self.notifies.append(("Other", 0.1, "Other"))
        self.markers.append(("Other", 0.1, "Other"))

    def get_name(self):
        return "walk"

    def modify(self, always_mark_dirty=True):
        return True


class AnimationLibrary:
    @staticmethod
    def get_sequence_length(animation_sequence_base):
        return animation_sequence_base.length

    @staticmethod
    def is_valid_anim_notify_track_name(animation_sequence_base, notify_track_name):
        return notify_track_name in animation_sequence_base.tracks

    @staticmethod
    def add_animation_notify_track(animation_sequence_base, notify_track_name, track_color):
        assert isinstance(track_color, LinearColor)
        assert notify_track_name not in animation_sequence_base.tracks
        animation_sequence_base.tracks.append(notify_track_name)

    @staticmethod
    def remove_animation_notify_track(animation_sequence_base, notify_track_name):
        animation = animation_sequence_base
        animation.tracks.remove(notify_track_name)
        animation.notifies = [notify for notify in animation.notifies if notify[2] != notify_track_name]

    @staticmethod
    def add_animation_notify_event(animation_sequence_base, notify_track_name, start_time, notify_class):
        animation = animation_sequence_base
        assert notify_track_name in animation.tracks and 0.0 <= start_time <= animation.length
        assert notify_class.startswith("AnimNotify_")
        animation.notifies.append((notify_class[len("AnimNotify_"):], start_time, notify_track_name))
        return AnimNotify()

    @staticmethod
    def add_animation_notify_state_event(
        animation_sequence_base, notify_track_name, start_time, duration, notify_state_class
    ):
        animation = animation_sequence_base
        assert notify_track_name in animation.tracks and 0.0 <= start_time <= start_time + duration
        assert start_time + duration <= animation.length + 1e-6
        assert notify_state_class.startswith("AnimNotifyState_")
        name = notify_state_class[len("AnimNotifyState_"):]
        animation.notifies.append((name, start_time, notify_track_name, duration))
        return AnimNotifyState()

    @staticmethod
    def add_animation_sync_marker(animation_sequence, marker_name, time, notify_track_name):
        assert notify_track_name in animation_sequence.tracks and 0.0 <= time <= animation_sequence.length
        animation_sequence.markers.append((marker_name, time, notify_track_name))

    @staticmethod
    def remove_animation_sync_markers_by_track(animation_sequence, notify_track_name):
        markers = animation_sequence.markers
        animation_sequence.markers = [marker for marker in markers if marker[2] != notify_track_name]

    @staticmethod
    def does_curve_exist(animation_sequence_base, curve_name, curve_type):
        return curve_name in animation_sequence_base.curves

    @staticmethod
    def add_curve(animation_sequence_base, curve_name, curve_type=None, meta_data_curve=False):
        assert curve_name not in animation_sequence_base.curves
        animation_sequence_base.curves[curve_name] = []

    @staticmethod
    def add_float_curve_keys(animation_sequence_base, curve_name, times, values):
        assert len(times) == len(values) and times == sorted(set(times))
        assert 0.0 <= times[0] and times[-1] <= animation_sequence_base.length
        animation_sequence_base.curves[curve_name] = list(zip(times, values))

    @staticmethod
    def remove_curve(animation_sequence_base, curve_name, remove_name_from_skeleton=False):
        del animation_sequence_base.curves[curve_name]


class LinearColor:
    def __init__(self, r=0.0, g=0.0, b=0.0, a=0.0):
        pass


class BlueprintFactory:
    def set_editor_property(self, name, value):
        assert name == "parent_class"
        self.parent = value


ASSETS = set()


class AssetTools:
    def create_asset(self, asset_name, package_path, asset_class, factory):
        assert asset_class is Blueprint and asset_name.startswith(factory.parent.__name__ + "_")
        ASSETS.add(package_path + "/" + asset_name)


class EditorAssetLibrary:
    @staticmethod
    def does_asset_exist(asset_path):
        return asset_path in ASSETS

    @staticmethod
    def load_blueprint_class(asset_path):
        assert asset_path in ASSETS
        return asset_path.rsplit("/", 1)[1]


class ScopedEditorTransaction:
    def __init__(self, desc):
        pass

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        return False


animation = AnimSequence(float(sys.argv[1]))
unreal = types.ModuleType("unreal")
for item in (
    AnimNotify, AnimNotifyState, Blueprint, AnimSequence, AnimationLibrary, LinearColor, BlueprintFactory, EditorAssetLibrary,
    ScopedEditorTransaction,
):
    setattr(unreal, item.__name__, item)
unreal.RawCurveTrackTypes = types.SimpleNamespace(RCT_FLOAT=0)
unreal.AssetToolsHelpers = types.SimpleNamespace(get_asset_tools=AssetTools)
unreal.EditorUtilityLibrary = types.SimpleNamespace(get_selected_assets=lambda: [animation, object()])
warnings = []
unreal.log_warning = warnings.append
sys.modules["unreal"] = unreal

script = open("clip.unreal.py", encoding="utf-8").read()
runs = []
for source in (script, script, script.replace("REMOVE = False", "REMOVE = True")):
    exec(source, {})
    state = {"notifies": animation.notifies, "markers": animation.markers, "curves": animation.curves}
    runs.append(json.loads(json.dumps(state)))
print(json.dumps({"runs": runs, "warnings": warnings}))
