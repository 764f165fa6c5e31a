"""The results of a study: the hash of all bits, statistics with intervals, a plot."""

import hashlib

import numpy as np
import pyarrow.parquet

from .chunks import part_path


def read(study, folder):
    """Returns a dict of arrays with one entry for each sample, in their order."""
    tables = [pyarrow.parquet.read_table(part_path(folder, number)) for number in range(study.chunks)]
    names = tables[0].column_names
    values = {name: np.concatenate([table[name].to_numpy() for table in tables]) for name in names}
    if not np.array_equal(values["sample"], np.arange(study.samples)):
        raise ValueError("parts are missing or have other samples")
    return values


def digest(values):
    """Returns the SHA-256 of all names and all bits."""
    text = hashlib.sha256()
    for name in sorted(values):
        text.update(name.encode())
        text.update(np.ascontiguousarray(values[name]).astype(values[name].dtype.newbyteorder("<")).tobytes())
    return text.hexdigest()


# The 0.975 quantile of the normal distribution.
Z = 1.959963984540054


def summary(values, names):
    """Returns a row for each name: mean with its 95 % interval, standard deviation, median and 95 % quantile.

    The interval of a mean is that of the normal distribution. Results of only 0 and 1 are events: the interval of their
    probability is Wilson's. Results that are NaN are counted and left out.
    """
    rows = []
    for name in names:
        known = values[name][np.isfinite(values[name])]
        count, failed = len(known), len(values[name]) - len(known)
        if count == 0:
            rows.append({"name": name, "count": 0, "failed": failed})
            continue
        mean = known.mean()
        if np.isin(known, (0.0, 1.0)).all():
            centre = (mean + Z**2 / (2 * count)) / (1 + Z**2 / count)
            half = Z * np.sqrt(mean * (1 - mean) / count + Z**2 / (4 * count**2)) / (1 + Z**2 / count)
            low, high = centre - half, centre + half
        else:
            half = Z * known.std(ddof=1) / np.sqrt(count) if count > 1 else np.inf
            low, high = mean - half, mean + half
        rows.append({
            "name": name, "count": count, "failed": failed, "mean": mean, "low": low, "high": high,
            "deviation": known.std(ddof=1) if count > 1 else np.nan,
            "median": np.median(known), "q95": np.quantile(known, 0.95),
        })
    return rows


def plot(values, names, path):
    """Writes histograms of results, with the mean, its interval and the 95 % quantile."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    columns = min(3, len(names))
    rows = -(-len(names) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(5 * columns, 3.5 * rows), squeeze=False)
    for axis in axes.flat[len(names) :]:
        axis.remove()
    for axis, row in zip(axes.flat, summary(values, names)):
        known = values[row["name"]]
        axis.hist(known[np.isfinite(known)], bins=50, color="#9ab8d8")
        if row["count"]:
            axis.axvspan(row["low"], row["high"], color="#d04040", alpha=0.4, label="95 % interval of the mean")
            axis.axvline(row["mean"], color="#d04040")
            axis.axvline(row["q95"], color="#404040", linestyle="--", label="95 % quantile")
        axis.set_xlabel(row["name"])
        axis.set_ylabel("samples")
        axis.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path)
    plt.close(figure)
