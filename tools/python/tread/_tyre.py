"""Tyres."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from . import _tread
from ._arguments import PathLike, Settings, path_text, settings_list
from ._described import TyreForces
from ._errors import InputError


class Tyre:
    """A tyre: a YAML file, a .tir file, or the bare name of one that tread brings along ("car_205_60R15").

    settings   {path: value}, for example {"lambda.muy": 0.8}; tread.describe("tyre") lists the paths
    """

    def __init__(self, file: PathLike, settings: Settings = None):
        self._tyre = _tread.Tyre(path_text(file, "file"), settings_list(settings))

    @property
    def name(self) -> str:
        """Name of the tyre."""
        return self._tyre.name

    @property
    def notes(self) -> list[str]:
        """What was dropped, derived or guessed when a .tir file was read."""
        return self._tyre.notes

    def forces(
        self,
        Fz: npt.ArrayLike,
        alpha: npt.ArrayLike = 0.0,
        kappa: npt.ArrayLike = 0.0,
        gamma: npt.ArrayLike = 0.0,
        V: npt.ArrayLike = 20.0,
    ) -> TyreForces:
        """Steady-state forces and moments, Delft Tyre 97 (Pacejka & Besselink 1997), ISO 8855 axes.

        Fz      normal load [N]
        alpha   slip angle [rad], positive when the contact centre moves to the left: then Fy is negative
        kappa   longitudinal slip [-], positive when driven, -1 when locked
        gamma   camber [rad], positive with the top to the right
        V       forward speed of the contact centre [m/s]

        Numbers or arrays, which are broadcast against each other; the result has arrays of the common shape.
        Raises InputError for arrays that do not fit together and for numbers that are not finite.
        """
        given = {"Fz": Fz, "alpha": alpha, "kappa": kappa, "gamma": gamma, "V": V}
        arrays = {name: _numbers(name, value) for name, value in given.items()}
        try:
            shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
        except ValueError:
            text = ", ".join(f"{name} {array.shape}" for name, array in arrays.items() if array.ndim)
            raise InputError(f"found the shapes {text}, which cannot be broadcast against each other") from None
        points = int(np.prod(shape))
        flat = [
            array.reshape(1) if array.size == 1 else np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(points)
            for array in arrays.values()
        ]
        return TyreForces(*(row.reshape(shape)[()] for row in self._tyre.forces(flat, points)))

    def __repr__(self) -> str:
        return f"<tread.Tyre {self.name!r}>"


def _numbers(name: str, value: npt.ArrayLike) -> npt.NDArray[np.float64]:
    try:
        array = np.asarray(value)
        if array.dtype.kind not in "iuf":
            raise TypeError
        return array.astype(np.float64, copy=False)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: found {type(value).__name__}, expected a number or an array of numbers") from None
