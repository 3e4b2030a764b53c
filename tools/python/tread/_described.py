"""What tread describes: files, channels, metrics; and the types that are made of those descriptions."""

from __future__ import annotations

from collections import namedtuple

from . import _tread


def describe(what: str = "") -> list[dict[str, str]]:
    """Every field of a file, of the log or of the metrics: path, unit, meaning, limits and default.

    what   "vehicle", "scenario", "tyre", "log", "metrics", ...; with "": a row for each of these words
    """
    if not what:
        return [{"path": name} for name in _tread.describables()]
    return _tread.describe(what)


_FIELDS = _tread.tyre_force_fields()

TyreForces = namedtuple("TyreForces", [name for name, _, _ in _FIELDS])  # type: ignore[misc]
TyreForces.__doc__ = "Forces, moments and slips of a tyre in steady state, ISO 8855 axes: arrays of one shape.\n\n" + "\n".join(
    f"{name:<6} [{unit}] {meaning}" for name, unit, meaning in _FIELDS
)
for _name, _unit, _meaning in _FIELDS:
    getattr(TyreForces, _name).__doc__ = f"[{_unit}] {_meaning}"

VehicleInput = _tread.VehicleInput
