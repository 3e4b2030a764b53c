"""Failures and warnings."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Iterable, Sequence


@dataclass(frozen=True)
class Problem:
    """One fault of an input. Line and column count from 1; 0 where the fault has no place in a file."""

    file: str
    line: int
    column: int
    path: str
    text: str


class InputError(ValueError):
    """Something is wrong with a file, a setting or an argument. The message is that of the command line."""

    def __init__(self, message: str, problems: Iterable[Problem] = ()):
        super().__init__(message)
        self.problems: Sequence[Problem] = list(problems)  #: all faults that were found

    @property
    def file(self) -> str:
        """File of the first fault, or the argument that holds it; empty where there is none."""
        return self.problems[0].file if self.problems else ""

    @property
    def line(self) -> int:
        """Line of the first fault, from 1; 0 where there is none."""
        return self.problems[0].line if self.problems else 0

    @property
    def column(self) -> int:
        """Column of the first fault, from 1; 0 where there is none."""
        return self.problems[0].column if self.problems else 0


class FileError(InputError, OSError):
    """The operating system refuses to read or to write a file."""

    def __init__(self, message: str):
        InputError.__init__(self, message)

    def __str__(self) -> str:
        return str(self.args[0])


class SimulationError(RuntimeError):
    """A simulation could not go on."""

    def __init__(self, message: str, time: float = float("nan")):
        super().__init__(message)
        self.time = time  #: simulated time of the failure [s]; not a number where it is not known


class InputWarning(UserWarning):
    """A number that hardly any car has, or something that the result should be read with."""


def warn_of(texts: Iterable[str], depth: int = 3) -> None:
    for text in texts:
        warnings.warn(text, InputWarning, stacklevel=depth)
