
# Everything that the script adds is on this track.
TRACK = "Plantigrade segments"


def add(animation):
    """Add a notify state for each segment at the times of the clip."""
    length, scale = LIBRARY.get_sequence_length(animation), scale_of(animation)
    for start, end, name in SEGMENTS:
        start, end = (min(time * scale, length) for time in (start, end))
        state = notify_class(unreal.AnimNotifyState, name)
        LIBRARY.add_animation_notify_state_event(animation, TRACK, start, end - start, state)


main("Plantigrade segments", remove_track, add)
