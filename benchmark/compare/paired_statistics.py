"""How two programs differ on the same meshes. A run without a result counts as worse than any with one."""

import dataclasses
import warnings

import numpy as np
from scipy.stats import wilcoxon

RESAMPLES = 10_000
CONFIDENCE = 0.95
PRECISION = 1e-6  # relative, of coordinates in single precision: values that differ by less are equal


@dataclasses.dataclass
class Paired:
    meshes: int
    better: int  # how often the first value is smaller
    equal: int
    median: float  # of second minus first
    low: float  # confidence interval of the median
    high: float
    p: float  # of Wilcoxon's signed rank test, two-sided


def differences(first, second):
    """Second minus first; None is infinite, and equal to None."""
    first, second = (np.array([np.inf if value is None else value for value in values], float) for values in (first, second))
    with np.errstate(invalid="ignore"):
        return np.where(np.isclose(first, second, rtol=PRECISION, atol=0), 0.0, second - first)


def interval(values, seed=0):
    """The interval of the median, by the percentiles of resampled ones."""
    numbers = np.random.default_rng(seed).integers(len(values), size=(RESAMPLES, len(values)))
    with np.errstate(invalid="ignore"):  # the middle between both infinities is no number, and sorted last
        medians = np.sort(np.median(values[numbers], axis=1))
    tail = int(RESAMPLES * (1 - CONFIDENCE) / 2)
    return float(medians[tail]), float(medians[-1 - tail])


def signed_rank(values):
    if not np.any(values):
        return 1.0
    # Only the order of the sizes counts, and infinity is the largest.
    sizes = np.abs(values)
    finite = np.where(np.isinf(sizes), 2 * np.max(sizes[np.isfinite(sizes)], initial=1.0), sizes)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of few or equal values
        return float(wilcoxon(np.copysign(finite, values)).pvalue)


def compare(first, second):
    """Two lists of values, of which smaller ones are better, mesh by mesh; None for a run without a result."""
    values = differences(first, second)
    with np.errstate(invalid="ignore"):
        median = float(np.median(values))
    return Paired(len(values), int((values > 0).sum()), int((values == 0).sum()), median, *interval(values), signed_rank(values))


def summary(values):
    """Median and mean of the runs with a result, and the number of the others."""
    found = [value for value in values if value is not None]
    return (float(np.median(found)), float(np.mean(found)), len(values) - len(found)) if found else (None, None, len(values))
