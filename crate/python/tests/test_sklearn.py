"""The estimator in the style of scikit-learn."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import plantigrade

pytest.importorskip("sklearn")

from sklearn.base import clone
from sklearn.utils.estimator_checks import check_estimator

from plantigrade.sklearn import FootContactDetector

#: Checks that do not apply, and why.
NOT_APPLICABLE = {
    "check_methods_sample_order_invariance": "samples are frames, whose order matters",
    "check_methods_subset_invariance": "the label of a frame depends on the others",
}


class AnyFeatures(FootContactDetector):
    """Detector that takes any features for the coordinates of two ankles, so that the checks can fit it."""

    def _positions(self, array: np.ndarray) -> np.ndarray:
        positions = np.zeros((len(array), 6))
        count = min(6, array.shape[1])
        positions[:, :count] = array[:, :count]
        positions[:, 3] += 1
        return positions.reshape(len(array), 2, 3)


@pytest.fixture
def detector(walk: plantigrade.Clip) -> FootContactDetector:
    return FootContactDetector(fps=walk.fps, roles=walk.skeleton.roles)


def test_labels_are_those_of_detect(walk: plantigrade.Clip, detector: FootContactDetector) -> None:
    expected = plantigrade.detect(walk.positions, fps=walk.fps, roles=walk.skeleton.roles)
    flat = walk.positions.reshape(len(walk), -1)
    assert np.array_equal(detector.fit_predict(flat), expected.contact)
    assert np.array_equal(detector.fit_predict(walk.positions), expected.contact)
    assert detector.n_features_in_ == 78
    assert np.array_equal(clone(detector).set_params(part="toe").fit(flat).labels_, expected.toe)


def test_features_are_three_per_joint(detector: FootContactDetector) -> None:
    with pytest.raises(plantigrade.PlantigradeError, match="three per joint"):
        detector.fit(np.zeros((9, 4)))


def test_estimator_checks() -> None:
    detector = AnyFeatures(roles={"left_ankle": 0, "right_ankle": 1}, up="y", unit=1.0)
    results: list[dict[str, Any]] = check_estimator(
        detector, expected_failed_checks=NOT_APPLICABLE, on_fail=None, on_skip=None
    )
    failed = {result["check_name"]: result["exception"] for result in results if result["status"] == "failed"}
    assert failed == {}
    assert sum(result["status"] == "passed" for result in results) >= 35


def test_checks_of_the_detector_itself() -> None:
    results: list[dict[str, Any]] = check_estimator(FootContactDetector(), on_fail=None, on_skip=None)
    # Checks that fit random samples fail because these have no feet, and for no other reason.
    reasons = ("which joint is which", "three per joint")
    for result in results:
        error = result["exception"]
        if result["status"] == "failed":
            causes = (error, error.__cause__, error.__context__)
            assert any(reason in str(cause) for cause in causes for reason in reasons), result
