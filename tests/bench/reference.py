"""Measures the time that reference libraries take to cluster toe signals.

Reads heights, speeds and the bandwidth by number of frames, as JSON from standard input. Prints
milliseconds of each run by library and number of frames as JSON. Missing libraries are left out.
"""

import json
import sys
import time

results = {}
try:
    import numpy
except ImportError:
    print(json.dumps(results))
    sys.exit()


def samples(signals):
    """Returns the samples of the paper: windows of three frames, the left toe before the right."""
    columns = []
    for values in (signals["heights"], signals["speeds"]):
        values = numpy.array(values)
        values = values / (numpy.ptp(values) or 1)
        columns.append(numpy.pad(numpy.minimum(values, 1), ((0, 0), (1, 1)), "edge"))
    count = len(signals["heights"][0])
    windows = [column[:, offset : offset + count] for offset in range(3) for column in columns]
    return numpy.stack(windows, axis=2).reshape(2 * count, 6)


def measure(function, runs):
    """Returns the times of all runs."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        function()
        times.append(1000 * (time.perf_counter() - start))
    return times


def dense_eigensolver(points, gamma):
    """Computes all eigenvectors of the normalised affinity matrix."""
    squared_distances = ((points[:, None] - points[None]) ** 2).sum(2)
    affinity = numpy.exp(-gamma * squared_distances)
    degree = affinity.sum(1)
    numpy.linalg.eigh(affinity / numpy.sqrt(degree[:, None] * degree[None]))


for frames, signals in json.load(sys.stdin).items():
    points = samples(signals)
    gamma = 1 / signals["sigma"] ** 2
    runs = 5 if int(frames) > 300 else 61
    results.setdefault("dense", {})[frames] = measure(lambda: dense_eigensolver(points, gamma), runs)
    try:
        from sklearn.cluster import SpectralClustering
    except ImportError:
        continue
    model = SpectralClustering(2, gamma=gamma, random_state=0)
    results.setdefault("sklearn", {})[frames] = measure(lambda: model.fit(points), runs)
print(json.dumps(results))
