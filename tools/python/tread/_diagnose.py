"""Diagnosis and identification."""

from __future__ import annotations

import json
from dataclasses import dataclass, fields
from typing import Any, Callable, Iterable, Optional

import numpy as np
import numpy.typing as npt

from . import _tread
from ._arguments import PathLike, path_text
from ._errors import InputError, warn_of


@dataclass(frozen=True)
class Estimate:
    """Estimate of one parameter, in SI units. `low` and `high` are the ends of the 90 % interval."""

    value: float
    sd: float
    low: float
    high: float
    neutral: float  #: value of the nominal car
    at_bound: bool  #: the estimate is at the end of its plausible range


@dataclass(frozen=True)
class Effect:
    """A possible cause, with the probability that it is one of the causes, and its parameters by path."""

    name: str
    probability: float
    log_evidence: float  #: nat, relative to that of no effect
    parameters: dict[str, Estimate]
    against: str  #: why the effect alone is not the answer although it has evidence


@dataclass(frozen=True)
class Decomposition:
    """Shares of the squared gap between the recordings and the nominal car; they add up to 1."""

    tolerances: float
    causes: float
    remainder: float  #: what no cause explains
    noise: float


class _Answer:
    _kind = ""

    def __init__(self, found: tuple[bool, str, str, str, str, list[str]]):
        self.answered: bool = found[0]  #: the exit status of the command: True for 0
        self.text: str = found[1]  #: what the command prints
        self.json: dict[str, Any] = json.loads(found[2])  #: what the command prints with --json
        self.vehicle: str = found[3]  #: the car that was found, as the text of a vehicle file (YAML)
        self._report = found[4]
        self.warnings: list[str] = found[5]  #: about the data

    @property
    def answer(self) -> str:
        """The result in words."""
        return self.json["answer"]

    def report(self, file: PathLike) -> None:
        """Writes the page."""
        _tread.write_text(path_text(file, "file"), self._report)

    def __repr__(self) -> str:
        return f"<tread.{self._kind}: {self.answer}>"


class Diagnosis(_Answer):
    """Why a car and its model differ."""

    _kind = "Diagnosis"

    @property
    def verdict(self) -> str:
        """explained, partly_explained, ambiguous, unknown, nothing or not_testable."""
        return self.json["verdict"]

    @property
    def causes(self) -> list[str]:
        """Names of the effects that are the answer."""
        return self.json["causes"]

    @property
    def effects(self) -> list[Effect]:
        """Effects with evidence, the most probable first."""
        return [
            Effect(**{**one, "parameters": {path: Estimate(**e) for path, e in one["parameters"].items()}})
            for one in self.json["effects"]
        ]

    @property
    def shares(self) -> Decomposition:
        """Shares of the gap: in held-out drives, or in the fitted ones if none was held out."""
        gap = self.json["held_out"] if self.json["held_out"]["gap"] > 0 else self.json["training"]
        return Decomposition(*(gap[field.name]["share"] for field in fields(Decomposition)))

    @property
    def remaining(self) -> float:
        """Share of the gap that stays unexplained [-]."""
        return self.shares.remainder


@dataclass(frozen=True)
class FittedNumber:
    """A number of the car as the drives determine it, in SI units."""

    path: str
    value: float
    sd: float
    nominal: float
    determined: bool  #: by the drives; otherwise it is known no better than before


class Identification(_Answer):
    """Numbers of a car fitted to recordings."""

    _kind = "Identification"

    @property
    def numbers(self) -> list[FittedNumber]:
        """The fitted numbers."""
        numbers, names = self.json["numbers"], [field.name for field in fields(FittedNumber)][1:]
        return [FittedNumber(path, *(numbers[path][name] for name in names)) for path in self.json["paths"]]

    @property
    def correlation(self) -> npt.NDArray[np.float64]:
        """Correlation of the numbers in their order, shape (numbers, numbers)."""
        return np.array(self.json["correlation"], dtype=np.float64)


Progress = Optional[Callable[[float], object]]


def _threads(threads: int) -> int:
    if not isinstance(threads, int) or threads < 0:
        raise InputError(f"threads: found {threads!r}, expected a whole number, 0 for one per core")
    return threads


def diagnose(
    file: PathLike,
    *,
    data: PathLike | None = None,
    vehicle: PathLike | None = None,
    threads: int = 0,
    output: PathLike | None = None,
    progress: Progress = None,
) -> Diagnosis:
    """Diagnoses why recorded drives and their simulation differ. As `tread diagnose`.

    file       diagnosis.yaml: car, recordings, tolerances
    data       folder of the logs; that of the file unless given
    vehicle    nominal car in place of the file's
    threads    0: one per core; the answer does not depend on it
    output     folder for diagnosis.json, report.html, the drives of each stage; None: nothing is written
    progress   called now and then with the share that is done, from 0 to 1

    Takes a minute or more. Raises InputError, SimulationError.
    """
    found = Diagnosis(
        _tread.diagnose(
            path_text(file, "file"), path_text(data, "data"), path_text(vehicle, "vehicle"), _threads(threads),
            path_text(output, "output"), progress,
        )
    )
    warn_of(found.warnings)
    return found


def identify(
    file: PathLike,
    fit: Iterable[str] | None = None,
    *,
    without: Iterable[str] = (),
    data: PathLike | None = None,
    vehicle: PathLike | None = None,
    threads: int = 0,
    output: PathLike | None = None,
    progress: Progress = None,
) -> Identification:
    """Fits numbers of a car to recorded drives. As `tread identify`.

    file       diagnosis.yaml: car, recordings, tolerances
    fit        paths of the numbers, for example ["front.roll_stiffness"]; those of the file unless given
    without    recordings to hold out, by name
    The others are those of tread.diagnose().
    """
    if isinstance(fit, str) or isinstance(without, str):
        raise TypeError("fit, without: found a str, expected a list of str")
    found = Identification(
        _tread.identify(
            path_text(file, "file"), list(fit or []), list(without), path_text(data, "data"),
            path_text(vehicle, "vehicle"), _threads(threads), path_text(output, "output"), progress,
        )
    )
    warn_of(found.warnings)
    return found
