
# Everything that the script adds is on this track, or is a curve of CURVES.
TRACK = "Plantigrade"
FLOAT = unreal.RawCurveTrackTypes.RCT_FLOAT


def remove(animation):
    """Remove notifies, sync markers and curves."""
    LIBRARY.remove_animation_sync_markers_by_track(animation, TRACK)
    remove_track(animation)
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
    length, scale = LIBRARY.get_sequence_length(animation), scale_of(animation)
    for time, name, is_marker in EVENTS:
        at = min(time * scale, length)
        LIBRARY.add_animation_notify_event(animation, TRACK, at, notify_class(unreal.AnimNotify, name))
        if is_marker:
            LIBRARY.add_animation_sync_marker(animation, name, at, TRACK)
    for name, plants in CURVES:
        times, values = curve_keys([(start * scale, end * scale) for start, end in plants], length)
        LIBRARY.add_curve(animation, name, FLOAT, False)
        LIBRARY.add_float_curve_keys(animation, name, times, values)


main("Plantigrade foot events", remove, add)
