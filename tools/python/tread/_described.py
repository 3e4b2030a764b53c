"""What tread describes: files, channels, metrics; and the types that are made of those descriptions."""

from __future__ import annotations

from dataclasses import make_dataclass

from . import _tread


def describe(what: str = "") -> list[dict[str, str]]:
    """Every field of a file, of the log or of the metrics: path, unit, meaning, limits and default.

    what   "vehicle", "scenario", "tyre", "log", "metrics", ...; with "": a row for each of these words
    """
    if not what:
        return [{"path": name} for name in _tread.describables()]
    return _tread.describe(what)


_FIELDS = _tread.tyre_force_fields()

#: One attribute for each field of the description of a tyre's steady state.
TyreForces = make_dataclass("TyreForces", [name for name, _, _ in _FIELDS], frozen=True, eq=False)
TyreForces.__doc__ = (
    "Forces, moments and slips of a tyre in steady state, ISO 8855 axes: arrays of one shape. The numbers in brackets are\n"
    "those of the equations of the model.\n\n"
    + "\n".join(f"{name:<6} [{unit}] {meaning}" for name, unit, meaning in _FIELDS)
)

VehicleInput = _tread.VehicleInput
VehicleInput.__doc__ = (
    "What the driver does. VehicleInput(steering_wheel_angle=0.5, throttle=0.2); what is not named is 0.\n\n"
    + "\n".join(f"{name:<21} [{unit}] {meaning}" for name, unit, meaning in _tread.input_channels())
)
