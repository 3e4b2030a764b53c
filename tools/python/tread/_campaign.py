"""Campaigns: many runs."""

from __future__ import annotations

import sqlite3
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _tread
from ._arguments import PathLike, Settings, path_text, settings_list, suggestion
from ._diagnose import Progress, _threads
from ._errors import InputError

if TYPE_CHECKING:
    import pandas


class CampaignResult(Mapping[str, npt.NDArray[Any]]):
    """The table of a campaign: a column by name, an array with one element for each run.

    Columns are run, vehicle, scenario, repetition, status, message and missed, then the factors and the metrics. Numbers
    are arrays of float, not a number where a run has none; the others are arrays of str.
    """

    def __init__(self, folder: PathLike, answer: str = ""):
        self.folder = Path(folder)  #: with results.csv, results.sqlite, report.html
        self.answer = answer  #: in one sentence
        file = self.folder / "results.sqlite"
        if not file.exists():
            raise InputError(f"{file}: found no such file, expected the folder of a campaign that is done")
        with sqlite3.connect(f"file:{file.absolute()}?mode=ro", uri=True) as data:
            described = data.execute("SELECT name, kind, unit, definition FROM columns").fetchall()
            table = data.execute("SELECT * FROM results ORDER BY run")
            names = [column[0] for column in table.description]
            rows = table.fetchall()
        data.close()
        short = _without_units(names)
        self.units = {short[name]: unit for name, _, unit, _ in described}  #: of factors and metrics
        self.definitions = {short[name]: text for name, _, _, text in described}  #: of factors and metrics
        self.factors = [short[name] for name, kind, _, _ in described if kind == "factor"]  #: what differs between runs
        self.metrics = [short[name] for name, kind, _, _ in described if kind == "metric"]  #: what was measured
        self._columns = {short[name]: _column([row[i] for row in rows]) for i, name in enumerate(names)}

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"no column {name!r}{suggestion(name, self._columns)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a DataFrame, the number of the run as its index."""
        try:
            import pandas
        except ImportError as error:
            raise ImportError("to_pandas() needs pandas (Debian: python3-pandas), which is not installed") from error
        return pandas.DataFrame(self._columns).set_index("run")

    def __repr__(self) -> str:
        runs = len(self["run"])
        return f"<tread.CampaignResult: {self.answer or f'{runs} runs'}; {len(self.metrics)} metrics in {str(self.folder)!r}>"


def _without_units(names: list[str]) -> dict[str, str]:
    """The name of a column, "load.mass [kg]", without its unit, as far as that tells it from the others."""
    short = {name: name.rsplit(" [", 1)[0] for name in names}
    counts = Counter(short.values())
    return {name: one if counts[one] == 1 else name for name, one in short.items()}


def _column(values: list[Any]) -> npt.NDArray[Any]:
    if all(value is None or isinstance(value, (int, float)) for value in values):
        return np.array([np.nan if value is None else value for value in values], dtype=np.float64)
    return np.array(["" if value is None else str(value) for value in values])


class Campaign:
    """Many runs: cars, scenarios, and what differs between them.

    file       campaign (YAML), or the folder of its results
    settings   {path: value} of the campaign's file, for example {"samples": 64}
    """

    def __init__(self, file: PathLike, settings: Settings = None):
        self._file = path_text(file, "file")
        self._plan = _tread.Plan(self._file, settings_list(settings))

    @property
    def title(self) -> str:
        """Title of the campaign."""
        return self._plan.title()

    @property
    def runs(self) -> int:
        """Number of runs."""
        return self._plan.runs()

    def run(
        self, output: PathLike | None = None, *, threads: int = 0, progress: Progress = None
    ) -> CampaignResult:
        """Computes what the folder lacks, on several threads, and returns the table of all runs.

        output     folder of the results; out/<campaign> unless given
        threads    0: one per core; the results do not depend on it
        progress   called now and then with the share that is done, from 0 to 1

        Ctrl-C ends it; the same call goes on later. Raises InputError, FileError.
        """
        return CampaignResult(*self._plan.run(self._file, path_text(output, "output"), _threads(threads), progress))

    def __repr__(self) -> str:
        return f"<tread.Campaign {self.title!r}: {self.runs} runs>"
