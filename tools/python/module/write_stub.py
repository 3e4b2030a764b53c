"""Writes tread/_described.pyi: the types that tread makes of its descriptions.

    write_stub.py FILE
"""

import sys

from tread import _tread


def fields(rows, type_name):
    for name, unit, meaning in rows:
        yield f"    {name}: {type_name}\n"
        yield f'    """[{unit}] {meaning}"""\n'


def main(file):
    lines = ["from dataclasses import dataclass\n\n", "import numpy as np\nimport numpy.typing as npt\n\n"]
    lines += ["@dataclass(frozen=True, eq=False)\nclass TyreForces:\n", *fields(_tread.tyre_force_fields(), "npt.NDArray[np.float64]")]
    lines += ["\nclass VehicleInput:\n", *fields(_tread.input_channels(), "float")]
    arguments = "".join(f", {name}: float = ..." for name, _, _ in _tread.input_channels())
    lines.append(f"    def __init__(self, *{arguments}) -> None: ...\n")
    lines.append("\ndef describe(what: str = ...) -> list[dict[str, str]]: ...\n")
    with open(file, "w", encoding="utf-8") as out:
        out.writelines(lines)


main(sys.argv[1])
