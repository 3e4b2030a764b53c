"""Full-vehicle simulation on realistic tyres.

    import tread
    log = tread.run("compact", "step_steer_80", {"mass": 1500})
    log["chassis.yaw_rate"]                # rad/s, a NumPy array over log.time
    log.metrics                            # what the standard asks of the manoeuvre
    log.report("step_steer.html")          # the page that `tread run` writes

Cars and manoeuvres are YAML files, or the bare names of those that tread brings along. Settings have the paths of
`tread run --set`; tread.describe("vehicle") and tread.describe("scenario") list them with unit, limits and default.
All numbers are in SI units, angles in radians; axes follow ISO 8855: x forward, y to the left, z up.

A run, a diagnosis or a campaign lets other threads of Python work meanwhile, and ends on Ctrl-C. What is wrong with an
input is an InputError, with file, line and column; a simulation that cannot go on is a SimulationError, with the time.
"""

try:
    from . import _tread
except ImportError as _error:
    raise ImportError(
        "the package tread has no module _tread for this Python here: it is in <build>/python, where CMake builds it, "
        f"or where it is installed; {_error}"
    ) from _error

from ._campaign import Campaign, CampaignResult
from ._compare import Comparison, compare
from ._described import TyreForces, VehicleInput, describe
from ._diagnose import Decomposition, Diagnosis, Effect, Estimate, FittedNumber, Identification, diagnose, identify
from ._errors import FileError, InputError, InputWarning, Problem, SimulationError
from ._log import Log, Metric, Metrics, read_log
from ._run import Series, run, run_series
from ._tyre import Tyre
from ._vector_env import VectorEnv
from ._vehicle import Vehicle

__version__: str = _tread.__version__

__all__ = [
    "run", "run_series", "Series", "read_log", "Log", "Metrics", "Metric",
    "compare", "Comparison",
    "Tyre", "TyreForces",
    "Vehicle", "VehicleInput", "VectorEnv",
    "diagnose", "Diagnosis", "Effect", "Estimate", "Decomposition",
    "identify", "Identification", "FittedNumber",
    "Campaign", "CampaignResult",
    "describe",
    "InputError", "FileError", "SimulationError", "InputWarning", "Problem",
]

# As users import them: so they are named in messages, in help() and in pickles.
for _name in __all__:
    globals()[_name].__module__ = __name__
del _name
