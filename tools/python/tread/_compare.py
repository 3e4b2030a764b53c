"""tread.compare()"""

from __future__ import annotations

import json
from typing import Any, Sequence, Union

from . import _tread
from ._arguments import PathLike, path_text
from ._log import Log, read_log

LogOrFile = Union[Log, PathLike]


class Comparison:
    """Whether two logs agree, and where they do not. True in a condition when they agree."""

    def __init__(self, found: tuple[bool, str, str, str]):
        self.same: bool = found[0]  #: the logs agree
        self.text: str = found[1]  #: what `tread compare` prints
        self.json: dict[str, Any] = json.loads(found[2])  #: what `tread compare --json` prints
        self._report = found[3]

    @property
    def answer(self) -> str:
        """The result in one sentence."""
        return self.text.split("\n", 1)[0]

    @property
    def channels(self) -> list[dict[str, Any]]:
        """What was found for each channel."""
        return self.json.get("channels", [])

    def report(self, file: PathLike) -> None:
        """Writes the page that shows both logs over each other. Of a comparison with report=True."""
        if not self._report:
            raise ValueError("there is no page: call tread.compare(..., report=True)")
        _tread.write_text(path_text(file, "file"), self._report)

    def __bool__(self) -> bool:
        return self.same

    def __repr__(self) -> str:
        return self.text.rstrip()


def _run_of(log: LogOrFile, what: str) -> Any:
    if isinstance(log, Log):
        return log._run
    return read_log(path_text(log, what))._run


def compare(
    reference: LogOrFile,
    candidate: LogOrFile,
    *,
    tolerances: PathLike | None = None,
    score: PathLike | None = None,
    envelope: PathLike | None = None,
    repeats: Sequence[LogOrFile] = (),
    report: bool = False,
) -> Comparison:
    """Compares two logs, or files of logs: the candidate with the reference.

    tolerances   file of allowed differences; the defaults are those of `tread compare`
    score        "iso18571" or a file: rates how well the candidate, a simulation, agrees with the reference
    envelope     "iso19364" or a file: whether measured points lie within the limits around the simulation
    repeats      further measurements, for score and envelope
    report       also makes the page: Comparison.report(file) writes it

    Raises InputError, also where the logs have nothing that could be compared.
    """
    if score is not None and envelope is not None:
        raise ValueError("found both score and envelope, expected one of them")
    first, second = _run_of(reference, "reference"), _run_of(candidate, "candidate")
    if score is None and envelope is None:
        if repeats:
            raise ValueError("found repeats, which belong to score and envelope")
        return Comparison(_tread.compare(first, second, path_text(tolerances, "tolerances"), bool(report)))
    if tolerances is not None or report:
        raise ValueError("found tolerances or report, which belong to the plain comparison, not to score and envelope")
    measured = [first] + [_run_of(log, "repeats") for log in repeats]
    if score is not None:
        return Comparison(_tread.score(measured, second, path_text(score, "score")))
    return Comparison(_tread.envelope(measured, second, path_text(envelope, "envelope")))
