"""What follows from a study: the effect of each parameter, and a surface through all points."""
import math
import warnings
from dataclasses import dataclass

import numpy


@dataclass
class Bar:
    """A parameter's reach in the response: at its low and high value, the others where they are at the base."""
    parameter: object
    low: float
    high: float
    low_error: float = math.nan
    high_error: float = math.nan
    low_value: object = None
    high_value: object = None


def main_effects(study, points):
    """{name: [(value, mean response, error, number of points)]} over the levels of each parameter; of a design without
    levels, over fifths of its range."""
    effects = {}
    filled = study.design in ("latin_hypercube", "sobol")
    for parameter in study.parameters:
        groups = {}
        for one in points:
            value = study.points[one["point"]][parameter.name]
            if study.design == "one_at_a_time" and one["point"] != study.base_point:
                base = study.points[study.base_point]
                if any(study.points[one["point"]][other.name] != base[other.name] for other in study.parameters
                       if other is not parameter):
                    continue
            if filled:
                share = (parameter.number(value) - parameter.low) / (parameter.high - parameter.low)
                value = parameter.at((min(4, int(5 * share)) + 0.5) / 5)
            groups.setdefault(parameter.number(value), (value, []))[1].append(one[study.response])
        effects[parameter.name] = []
        for _, (value, responses) in sorted(groups.items()):
            values, errors = (numpy.array(column) for column in zip(*responses))
            error = errors[0] if len(values) == 1 else values.std(ddof=1) / math.sqrt(len(values))
            effects[parameter.name].append((value, values.mean(), error, len(values)))
    return effects


def tornado(study, points, surface):
    """Bars, the longest first, and the response at the base: of one_at_a_time the runs themselves, else the surface with
    the other parameters in the middle, or without one the least and most of the main effects."""
    bars = []
    effects = main_effects(study, points)
    numeric = [one for one in study.parameters if one.unit is not None]
    if surface and study.design != "one_at_a_time" and len(numeric) == len(study.parameters):
        middle = numpy.full(len(numeric), 0.5)
        base = surface.predict(middle[None])[0][0]
        for k, parameter in enumerate(numeric):
            ends = numpy.array([middle, middle])
            ends[:, k] = 0, 1
            value, error = surface.predict(ends)
            bars.append(Bar(parameter, *value, *error, parameter.at(0), parameter.at(1)))
    else:
        if study.design == "one_at_a_time":
            base = next((one[study.response][0] for one in points if one["point"] == study.base_point), math.nan)
        else:
            base = numpy.mean([one[study.response][0] for one in points])
        for parameter in study.parameters:
            levels = effects[parameter.name]
            if len(levels) > 1:
                low, high = ((levels[0], levels[-1]) if parameter.unit is not None else
                             (min(levels, key=lambda one: one[1]), max(levels, key=lambda one: one[1])))
                bars.append(Bar(parameter, low[1], high[1], low[2], high[2], low[0], high[0]))
    return sorted(bars, key=lambda bar: -abs(bar.high - bar.low)), base


class Quadratic:
    """Second order with products, by least squares."""
    name = "quadratic"

    @staticmethod
    def terms(x):
        count = x.shape[1]
        columns = [numpy.ones(len(x)), *x.T] + [x[:, i] * x[:, j] for i in range(count) for j in range(i, count)]
        return numpy.array(columns).T

    @staticmethod
    def size(count):
        return 1 + count + count * (count + 1) // 2

    def fit(self, x, y, errors):
        a = self.terms(x)
        self.coefficients, *_ = numpy.linalg.lstsq(a, y, rcond=None)
        left = y - a @ self.coefficients
        over = len(y) - a.shape[1]
        self.covariance = numpy.linalg.pinv(a.T @ a) * (left @ left / over if over > 0 else math.nan)
        return self

    def predict(self, x):
        a = self.terms(x)
        return a @ self.coefficients, numpy.sqrt(numpy.einsum("ij,jk,ik->i", a, self.covariance, a))


class GaussianProcess:
    """Of scikit-learn, a length for each parameter, the noise found with them."""
    name = "Gaussian process"

    def fit(self, x, y, errors):
        from sklearn.gaussian_process import GaussianProcessRegressor
        from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel
        kernel = ConstantKernel() * RBF(numpy.ones(x.shape[1]), (0.05, 50)) + WhiteKernel(1e-2, (1e-6, 1))
        self.model = GaussianProcessRegressor(kernel, normalize_y=True, n_restarts_optimizer=3, random_state=0)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a length or noise at its bound: a response without that part
            self.model.fit(x, y)
        return self

    def predict(self, x):
        return self.model.predict(x, return_std=True)


@dataclass
class Surface:
    model: object
    x: numpy.ndarray          # 0 to 1 from low to high
    y: numpy.ndarray
    left_out: numpy.ndarray   # each point predicted by the others

    def predict(self, x):
        return self.model.predict(x)

    @property
    def error(self):
        """Root mean square of what the surface says wrong of points that it has not seen."""
        return math.sqrt(((self.left_out - self.y)**2).mean())


def fit_surface(study, points):
    """(Surface or None, why not). Of numbers only, and with points to spare."""
    if study.surface == "none":
        return None, "not asked for"
    if study.design == "one_at_a_time":
        return None, "one_at_a_time sees no two parameters together: use grid, latin_hypercube or sobol"
    if any(one.unit is None for one in study.parameters):
        return None, "a parameter is a word"
    kind = GaussianProcess if study.surface == "gaussian_process" else Quadratic
    if kind is GaussianProcess:
        try:
            import sklearn  # noqa: F401
        except ImportError:
            return None, "gaussian_process needs scikit-learn (Debian: python3-sklearn)"
    needed = Quadratic.size(len(study.parameters)) + 1 if kind is Quadratic else 2 * len(study.parameters) + 2
    if len(points) < needed:
        return None, f"a {kind.name} surface of {len(study.parameters)} parameters needs {needed} points, " \
            f"{len(points)} are there"
    x = numpy.array([[(one.number(study.points[point["point"]][one.name]) - one.low) / (one.high - one.low)
                      for one in study.parameters] for point in points])
    y, errors = (numpy.array(column) for column in zip(*(point[study.response] for point in points)))
    if kind is Quadratic and numpy.linalg.matrix_rank(Quadratic.terms(x)) < Quadratic.size(x.shape[1]):
        return None, "a quadratic surface needs three levels of each parameter"
    left_out = []
    for k in range(len(y)):
        others = numpy.arange(len(y)) != k
        left_out.append(kind().fit(x[others], y[others], errors[others]).predict(x[k:k + 1])[0][0])
    return Surface(kind().fit(x, y, errors), x, y, numpy.array(left_out)), ""
