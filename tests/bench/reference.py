"""How long others take to cluster the toes of clips, which come as JSON, by frames: heights and
speeds of both toes, and the scale. Prints milliseconds as JSON; what is not installed is left out."""

import json
import statistics
import sys
import time

results = {}
try:
    import numpy
except ImportError:
    print(json.dumps(results))
    sys.exit()


def samples(toes):
    """Windows of three frames, as the paper has them: both toes one after the other."""
    columns = []
    for signals in (toes["heights"], toes["speeds"]):
        signals = numpy.array(signals)
        signals = signals / (numpy.ptp(signals) or 1)
        columns.append(numpy.pad(numpy.minimum(signals, 1), ((0, 0), (1, 1)), "edge"))
    count = len(toes["heights"][0])
    windows = [column[:, ahead : ahead + count] for ahead in range(3) for column in columns]
    return numpy.stack(windows, axis=2).reshape(2 * count, 6)


def measured(work, runs):
    """The middle one and the least: threads get into each other's way, more or less of the time."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(1000 * (time.perf_counter() - start))
    return {"middle": statistics.median(times), "least": min(times)}


def dense(points, gamma):
    squares = ((points[:, None] - points[None]) ** 2).sum(2)
    affinity = numpy.exp(-gamma * squares)
    degree = affinity.sum(1)
    numpy.linalg.eigh(affinity / numpy.sqrt(degree[:, None] * degree[None]))


for frames, toes in json.load(sys.stdin).items():
    points = samples(toes)
    gamma = 1 / toes["sigma"] ** 2
    runs = 3 if int(frames) > 300 else 21
    results.setdefault("dense", {})[frames] = measured(lambda: dense(points, gamma), runs)
    try:
        from sklearn.cluster import SpectralClustering
    except ImportError:
        continue
    model = SpectralClustering(2, gamma=gamma, random_state=0)
    results.setdefault("sklearn", {})[frames] = measured(lambda: model.fit(points), runs)
print(json.dumps(results))
