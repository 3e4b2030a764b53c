"""tread.run()"""

from __future__ import annotations

from typing import Callable, Optional

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
