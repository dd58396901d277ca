"""An estimator in the style of scikit-learn; requires scikit-learn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from sklearn.base import BaseEstimator
from sklearn.utils.validation import validate_data

from ._detect import detect
from ._errors import PlantigradeError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._clip import Names, Roles
    from ._detect import Detection, Part

__all__ = ["FootContactDetector"]


class FootContactDetector(BaseEstimator):  # type: ignore[misc]
    """Detects foot contact in positions of joints, as an estimator of scikit-learn.

    Like a clustering, the detector labels the frames that it is fitted to; there is no ``predict`` for
    others. A sample is a frame, and its features are the coordinates x, y, z of all joints in turn.

    Parameters
    ----------
    fps : float
        Frame rate in Hz.
    names, roles, parents, up, unit : optional
        Which joint is which, up axis and metres per unit, as in :func:`plantigrade.detect`.
    part : str
        Part of the foot to label: ``"contact"``, ``"heel"`` or ``"toe"``.
    method, r, w, sigma, height, speed, exact : optional
        Method and parameters, as in :func:`plantigrade.detect`.

    Attributes
    ----------
    labels_ : array of bool, shape (frames, 2)
        True while the part of the left foot and of the right foot is planted.
    detection_ : Detection
        The detection, with confidence and events.
    n_features_in_ : int
        Number of coordinates of a frame.

    Examples
    --------
    >>> from plantigrade.sklearn import FootContactDetector
    >>> clip = plantigrade.Clip.read("walk.bvh")
    >>> X = clip.positions.reshape(len(clip), -1)
    >>> detector = FootContactDetector(fps=clip.fps, roles=clip.skeleton.roles)
    >>> detector.fit_predict(X).shape
    (245, 2)
    """

    def __init__(
        self,
        *,
        fps: float = 30.0,
        names: Names | None = None,
        roles: Roles | None = None,
        parents: ArrayLike | None = None,
        up: str | None = None,
        unit: float | None = None,
        part: Part = "contact",
        method: str = "robust",
        r: float = 0.001,
        w: int = 1,
        sigma: float | None = None,
        height: float = 0.05,
        speed: float = 0.5,
        exact: bool = False,
    ) -> None:
        self.fps = fps
        self.names = names
        self.roles = roles
        self.parents = parents
        self.up = up
        self.unit = unit
        self.part = part
        self.method = method
        self.r = r
        self.w = w
        self.sigma = sigma
        self.height = height
        self.speed = speed
        self.exact = exact

    detection_: Detection
    labels_: NDArray[np.bool_]

    def fit(self, X: ArrayLike, y: object = None) -> FootContactDetector:
        """Label frames.

        Parameters
        ----------
        X : array, shape (frames, 3 × joints) or (frames, joints, 3)
            Coordinates of all joints.
        y : ignored
            Present for the interface of scikit-learn.
        """
        array = np.asarray(X) if not hasattr(X, "columns") and not _is_sparse(X) else X
        if getattr(array, "ndim", 2) == 3 and array.shape[2:] == (3,):  # type: ignore[union-attr]
            array = np.asarray(array).reshape(len(array), -1)  # type: ignore[arg-type]
        array = validate_data(self, array, dtype=np.float64)
        options = {name: value for name, value in self.get_params(deep=False).items() if name != "part"}
        self.detection_ = detect(self._positions(array), **options)
        self.labels_ = self.detection_.planted(self.part)
        return self

    def _positions(self, array: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return samples as positions, shape (frames, joints, 3)."""
        frames, features = array.shape
        if features % 3:
            raise PlantigradeError(
                f"X has {features} features, which is not three per joint",
                hint="A sample is a frame, with the coordinates x, y, z of all joints in turn",
            )
        return array.reshape(frames, -1, 3)

    def fit_predict(self, X: ArrayLike, y: object = None) -> NDArray[np.bool_]:
        """Label frames and return the labels, shape (frames, 2); see :meth:`fit`."""
        return self.fit(X, y).labels_


def _is_sparse(X: Any) -> bool:  # noqa: ANN401
    return hasattr(X, "nnz")
