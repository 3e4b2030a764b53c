"""Where the tests find the project and its program."""

import os
import subprocess
import tempfile
import unittest
import warnings
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("TREAD_PROGRAM", "tread")


def program(*words):
    """Runs the program; its standard output."""
    return subprocess.run([PROGRAM, *map(str, words)], cwd=SOURCE, check=True, capture_output=True,
                          text=True).stdout


class WithScratch(unittest.TestCase):
    """A test with a folder of its own. Warnings of inputs are not shown."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.scratch = Path(folder.name)
        caught = warnings.catch_warnings()
        caught.__enter__()
        self.addCleanup(caught.__exit__, None, None, None)
        warnings.simplefilter("ignore")

    def file(self, name, text):
        path = self.scratch / name
        path.write_text(text)
        return path


#: A stop from low speed: a run of a few milliseconds that has metrics.
STOP = """title: A short stop
manoeuvre: straight_braking
start: {speed: 15 km/h}
phases:
  - {name: straight, until: {duration: 0.1 s}}
  - name: brake
    throttle: {constant: {value: 0}}
    clutch: {constant: {value: 1}}
    brake: {ramp: {to: 1, rate: 20}}
    until: {speed_below: 0.02, duration: 5 s}
"""

#: Nothing happens for as long as the time limit allows.
CRUISE = """title: A long drive
start: {speed: 20}
time_limit: 4e5
log: {rate: 1}
phases:
  - {name: drive, until: {duration: 3e5}}
"""
