"""tread.run(), tread.run_series()"""

from __future__ import annotations

import math
from typing import Any, Callable, Optional

import numpy as np
import numpy.typing as npt

from . import _tread
from ._arguments import PathLike, Settings, path_text, settings_list
from ._errors import warn_of
from ._log import Log


def run(
    vehicle: PathLike,
    scenario: PathLike,
    settings: Settings = None,
    *,
    drive: PathLike | None = None,
    metrics: PathLike | None = None,
    accept: PathLike | None = None,
    strict: bool = False,
    progress: Optional[Callable[[float], object]] = None,
) -> Log:
    """Drives a car through a scenario and returns the log. As `tread run`, but nothing is written.

    vehicle, scenario   YAML files, or bare names of those that tread brings along: "compact", "step_steer_80"
    settings            {path: value}, as with `tread run --set`: a number in SI units, a text with a unit ("80 km/h"),
                        True, a list, a dict. Paths of the scenario begin with "scenario.".
    drive               log of a drive that the scenario repeats (`tread run --log`)
    metrics, accept     files with metrics of your own, and with conditions on metrics
    strict              numbers that hardly any car has are errors; otherwise they are warnings (InputWarning)
    progress            called now and then with the share that is done, from 0 to 1

    Metrics are computed when they are first asked for. A scenario that asks for several runs belongs to run_series().
    Raises InputError with every fault of files and settings, SimulationError with the time of the failure.
    """
    found = _tread.run(
        path_text(vehicle, "vehicle"),
        path_text(scenario, "scenario"),
        settings_list(settings),
        path_text(drive, "drive"),
        path_text(metrics, "metrics"),
        path_text(accept, "accept"),
        bool(strict),
        progress,
    )
    warn_of(found.warnings())
    return Log._of(found)


class Series:
    """Runs that differ in one number of the scenario, and their metrics."""

    def __init__(self, found: tuple[str, str, list[tuple[float, bool, str, dict[str, float]]], float, list[str]]):
        number, unit, runs, highest, _ = found
        self.number: str = number  #: path of the number, "start.speed"
        self.unit: str = unit  #: its SI unit
        self.values: npt.NDArray[np.float64] = np.array([run[0] for run in runs])  #: of the number, shape (runs,)
        self.passed: npt.NDArray[np.bool_] = np.array([run[1] for run in runs])  #: shape (runs,)
        self.failures: list[str] = [run[2] for run in runs]  #: why a run has no metrics; empty where it has
        self.highest: float = highest  #: value that passes; not a number: none, or not asked for
        names = next((list(run[3]) for run in runs if run[3]), [])
        #: By name, shape (runs,); not a number where a run has none.
        self.metrics: dict[str, npt.NDArray[Any]] = {
            name: np.array([run[3].get(name, math.nan) for run in runs]) for name in names
        }

    def __repr__(self) -> str:
        highest = "" if math.isnan(self.highest) else f", highest {self.highest:g} {self.unit}"
        return f"<tread.Series over {self.number}: {self.passed.sum()} of {self.values.size} runs pass{highest}>"


def run_series(
    vehicle: PathLike,
    scenario: PathLike,
    settings: Settings = None,
    *,
    metrics: PathLike | None = None,
    strict: bool = False,
) -> Series:
    """Drives the runs that a scenario asks for in its `series`: over values of a number, or up to the highest that passes.

    The arguments are those of tread.run(). Nothing is written; `tread run` writes each run into a folder.
    """
    found = _tread.run_series(
        path_text(vehicle, "vehicle"), path_text(scenario, "scenario"), settings_list(settings),
        path_text(metrics, "metrics"), bool(strict),
    )
    warn_of(found[4])
    return Series(found)
