"""Logs and metrics."""

from __future__ import annotations

import html
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _tread
from ._arguments import PathLike, path_text, suggestion
from ._errors import InputError, warn_of

if TYPE_CHECKING:
    import pandas

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Metric:
    """One number that answers a question about a run."""

    name: str
    value: float
    unit: str
    title: str
    definition: str

    def __str__(self) -> str:
        value = "undefined" if np.isnan(self.value) else f"{self.value:.5g} {'' if self.unit == '-' else self.unit}"
        return f"{self.title}: {value.rstrip()}"


class Metrics(Mapping[str, float]):
    """Metrics of a run: their values by name, in the units that the standards use (deg, km/h, ...).

    Not a number: the metric is not defined for this log. `definitions` say when.
    """

    def __init__(self, metrics: Sequence[Metric]):
        self._metrics = {metric.name: metric for metric in metrics}

    def __getitem__(self, name: str) -> float:
        return self.metric(name).value

    def __iter__(self) -> Iterator[str]:
        return iter(self._metrics)

    def __len__(self) -> int:
        return len(self._metrics)

    def metric(self, name: str) -> Metric:
        """The metric with its unit, title and definition."""
        try:
            return self._metrics[name]
        except KeyError:
            raise KeyError(f"no metric {name!r}{suggestion(name, self._metrics)}") from None

    @property
    def units(self) -> dict[str, str]:
        """Unit by name; "-" for pure numbers."""
        return {name: metric.unit for name, metric in self._metrics.items()}

    @property
    def titles(self) -> dict[str, str]:
        """Title for people by name."""
        return {name: metric.title for name, metric in self._metrics.items()}

    @property
    def definitions(self) -> dict[str, str]:
        """Definition by name, one sentence each."""
        return {name: metric.definition for name, metric in self._metrics.items()}

    def __repr__(self) -> str:
        if not self._metrics:
            return "<Metrics: none>"
        width = max(len(metric.title) for metric in self._metrics.values())
        rows = [
            f"{m.title:<{width}}  {'undefined' if np.isnan(m.value) else format(m.value, '.5g'):>12} {m.unit:<10} {m.name}"
            for m in self._metrics.values()
        ]
        return "\n".join(rows)

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td style='text-align:left' title='{html.escape(m.definition, True)}'>{html.escape(m.title)}</td>"
            f"<td>{'undefined' if np.isnan(m.value) else format(m.value, '.5g')}</td>"
            f"<td style='text-align:left'>{html.escape(m.unit)}</td>"
            f"<td style='text-align:left'><code>{html.escape(m.name)}</code></td></tr>"
            for m in self._metrics.values()
        )
        return f"<table>{rows}</table>"


class Log(Mapping[str, Array]):
    """A log: channels of one length over one time base.

    `log["chassis.yaw_rate"]` is a NumPy array of shape (samples,), in SI units: a view of the log's memory, which it
    keeps alive, and read-only. Names and units are those of `tread describe log`; `log.units` has them too.

    tread.run() and tread.read_log() return logs. Log(channels) makes one of arrays: the first channel is "time" [s],
    strictly increasing. Units that `units` does not name are those that tread has for the channel, or "-".
    """

    def __init__(self, channels: Mapping[str, npt.ArrayLike], units: Mapping[str, str] | None = None):
        units = units or {}
        arrays = {}
        for name, values in channels.items():
            if not isinstance(name, str):
                raise TypeError(f"channels: found a name of type {type(name).__name__}, expected a str")
            arrays[name] = np.asarray(values, dtype=np.float64)
        shapes = {array.shape for array in arrays.values()}
        if not arrays or next(iter(arrays)) != "time":
            raise InputError('channels: found no "time" in the first place, expected the time [s] there')
        if len(shapes) != 1 or len(arrays["time"].shape) != 1:
            text = ", ".join(f"{name} {array.shape}" for name, array in list(arrays.items())[:4])
            raise InputError(f"channels: found arrays of the shapes {text}, expected one shape (samples,)")
        if arrays["time"].size == 0:
            raise InputError("channels: found no sample, expected at least one")
        time = arrays["time"]
        if not np.isfinite(time).all() or (np.diff(time) <= 0).any():
            raise InputError("channels: found a time that does not increase, expected finite, increasing values")
        self._told = True
        self._run = _tread.make_log([(name, units.get(name, ""), array) for name, array in arrays.items()])
        self._units = self._run.units()

    @classmethod
    def _of(cls, run: object) -> Log:
        log = cls.__new__(cls)
        log._run = run
        log._told = False
        log._units = run.units()  # type: ignore[attr-defined]
        return log

    # ---- Channels ----

    def __getitem__(self, name: str) -> Array:
        if name not in self._units:
            raise KeyError(f"no channel {name!r} in the log{suggestion(name, self._units)}")
        return self._run.view(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._units)

    def __len__(self) -> int:
        return len(self._units)

    # Whether two logs agree is what tread.compare() says.
    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def __contains__(self, name: object) -> bool:
        return name in self._units

    @property
    def time(self) -> Array:
        """Time [s], shape (samples,)."""
        return self["time"]

    @property
    def units(self) -> dict[str, str]:
        """SI unit of each channel by name; "-" for pure numbers."""
        return dict(self._units)

    @property
    def samples(self) -> int:
        """Number of samples."""
        return self._run.samples()

    # ---- What the run answers ----

    @property
    def name(self) -> str:
        """Title of the scenario, or name of the file that was read."""
        return self._run.name()

    def _evaluated(self) -> Any:
        """The run, and at the first time what its metrics should be read with as warnings."""
        if not self._told:
            self._told = True
            warn_of(self._run.further_warnings(), 4)
        return self._run

    @property
    def answer(self) -> str:
        """The result of the run in one sentence; empty for a log that was read."""
        return self._evaluated().answer()

    @property
    def metrics(self) -> Metrics:
        """Metrics of the manoeuvre; for a log that was read those of the manoeuvre that it contains.

        Raises InputError when such a log contains none that tread knows.
        """
        return Metrics([Metric(*metric) for metric in self._evaluated().metrics("")])

    def metrics_of(self, manoeuvre: str) -> Metrics:
        """Metrics of a manoeuvre by name, as in `tread describe metrics`; "": as `metrics`."""
        return Metrics([Metric(*metric) for metric in self._run.metrics(manoeuvre)])

    @property
    def accepted(self) -> bool | None:
        """Whether all conditions on the metrics are met; None where there are no conditions."""
        return self._evaluated().accepted()

    @property
    def warnings(self) -> list[str]:
        """Numbers that are hardly plausible, and what else the results should be read with."""
        return [*self._run.warnings(), *self._run.further_warnings()]

    @property
    def inputs(self) -> str:
        """Car and scenario as YAML, all settings resolved: what `tread run` writes into run.yaml. Empty if unknown."""
        return self._run.inputs()

    # ---- Files ----

    def save(self, file: PathLike) -> None:
        """Writes the log as .csv, or as compact .tlog."""
        self._run.save(path_text(file, "file"))

    def report(self, file: PathLike) -> None:
        """Writes the page: metrics, figures of the manoeuvre, time histories, replay. One HTML file, works offline."""
        _tread.write_text(path_text(file, "file"), self._run.report())

    def save_run(self, folder: PathLike) -> None:
        """Writes what `tread run -o folder` writes: log.csv, run.yaml, metrics.json, report.html."""
        self._run.save_run(path_text(folder, "folder"))

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the time [s] as its index and a column for each channel."""
        try:
            import pandas
        except ImportError as error:
            raise ImportError("to_pandas() needs pandas (Debian: python3-pandas), which is not installed") from error
        columns = {name: self[name] for name in self if name != "time"}
        return pandas.DataFrame(columns, index=pandas.Index(self.time, name="time"))

    def __repr__(self) -> str:
        time = self.time
        span = f"{time[0]:g} to {time[-1]:g} s" if time.size else "empty"
        return f"<tread.Log {self.name!r}: {len(self)} channels, {self.samples} samples, {span}>"

    def _repr_html_(self) -> str:
        head = f"<p><b>{html.escape(self.answer or self.name)}</b><br>{html.escape(repr(self)[11:-1])}</p>"
        try:
            return head + self.metrics._repr_html_()
        except InputError:
            return head


def read_log(file: PathLike) -> Log:
    """Reads a log file of tread, .csv or .tlog. `tread import` converts logs of other programs.

    Raises InputError with line and column for every fault, FileError when the file cannot be read.
    """
    return Log._of(_tread.read_log(path_text(file, "file")))
