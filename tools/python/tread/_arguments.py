"""Arguments of Python as the command line has them."""

from __future__ import annotations

import difflib
import json
import math
import os
from typing import Any, Iterable, Mapping, Union

import numpy as np

PathLike = Union[str, "os.PathLike[str]"]
Settings = Union[Mapping[str, Any], Iterable[str], None]


def path_text(value: PathLike | None, what: str) -> str:
    """The file name; empty for None."""
    if value is None:
        return ""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{what}: found {type(value).__name__}, expected a file name")
    text = os.fspath(value)
    if not isinstance(text, str):
        raise TypeError(f"{what}: found bytes, expected a file name")
    return text


def _yaml(value: Any, path: str) -> str:
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else {"inf": ".inf", "-inf": "-.inf"}.get(repr(value), ".nan")
    if isinstance(value, int):
        return str(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_yaml(one, path) for one in value) + "]"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(str(key))}: {_yaml(one, path)}" for key, one in value.items()) + "}"
    raise TypeError(f"settings: {path}: found {type(value).__name__}, expected a number, a text, a list or a dict")


def settings_list(settings: Settings) -> list[str]:
    """Each setting as `path=value`."""
    if settings is None:
        return []
    if isinstance(settings, Mapping):
        return [f"{path}={_yaml(value, path)}" for path, value in settings.items()]
    if isinstance(settings, str) or not all(isinstance(one, str) for one in settings):
        raise TypeError('settings: expected a dict {path: value}, or a list of "path=value"')
    return list(settings)


def suggestion(name: Any, known: Iterable[str]) -> str:
    near = difflib.get_close_matches(str(name), list(known), 1, 0.6)
    return f"; did you mean {near[0]!r}?" if near else ""
