"""Logs, metrics, comparisons."""

import gc
import unittest
from unittest import mock

import numpy as np
from places import STOP, WithScratch, program

import tread

try:
    import pandas
except ImportError:
    pandas = None


class Logs(WithScratch):
    @classmethod
    def setUpClass(cls):
        cls.log = tread.run("compact", "step_steer_80", {"scenario.log.rate": 50})

    def test_channels_are_read_only_views_without_a_copy(self):
        yaw = self.log["chassis.yaw_rate"]
        self.assertEqual((yaw.dtype, yaw.shape), (np.float64, (self.log.samples,)))
        self.assertEqual(yaw.ctypes.data, self.log["chassis.yaw_rate"].ctypes.data)
        self.assertFalse(yaw.flags.writeable)
        self.assertTrue(yaw.flags.c_contiguous)
        with self.assertRaises(ValueError):
            yaw[0] = 1

    def test_a_view_keeps_its_log_alive(self):
        log = tread.run("compact", self.file("stop.yaml", STOP))
        speed = log["chassis.vx"]
        copy = speed.copy()
        del log
        gc.collect()
        np.testing.assert_array_equal(speed, copy)

    def test_names_units_and_time(self):
        self.assertEqual(next(iter(self.log)), "time")
        self.assertEqual(self.log.units["chassis.yaw_rate"], "rad/s")
        self.assertIn("wheel.front_left.load", self.log)
        self.assertEqual(len(self.log), len(self.log.units))
        np.testing.assert_allclose(np.diff(self.log.time), 0.02)
        with self.assertRaisesRegex(KeyError, "did you mean 'chassis.yaw_rate'"):
            self.log["chassis.yawrate"]

    def test_a_log_is_equal_to_itself_alone(self):
        self.assertEqual(self.log, self.log)
        self.assertNotEqual(self.log, tread.Log(dict(self.log.items()), self.log.units))
        self.assertEqual(len({self.log, self.log}), 1)

    def test_metrics_have_values_units_titles(self):
        metrics = self.log.metrics
        metric = metrics.metric("yaw_rate_response_time")
        self.assertEqual((metric.unit, metric.value), ("s", metrics["yaw_rate_response_time"]))
        self.assertEqual(metrics.units["yaw_rate_response_time"], "s")
        self.assertIn("response", metrics.titles["yaw_rate_response_time"])
        self.assertIn("steer", metrics.definitions["yaw_rate_response_time"])
        self.assertIn("yaw_rate_response_time", repr(metrics))
        self.assertIn("<table>", metrics._repr_html_())
        with self.assertRaisesRegex(KeyError, "no metric 'yaw_rate_overshot'; did you mean 'yaw_rate_overshoot'"):
            metrics["yaw_rate_overshot"]

    def test_how_a_log_shows_itself(self):
        self.assertRegex(repr(self.log), r"^<tread.Log 'Step steer at 80 km/h .*': \d+ channels, \d+ samples, 0 to 6 s>$")
        self.assertIn(self.log.answer.split(":")[0], self.log._repr_html_())

    def test_files_are_read_back_to_the_last_bit(self):
        for name in ("log.csv", "log.tlog"):
            self.log.save(self.scratch / name)
            back = tread.read_log(self.scratch / name)
            self.assertEqual(back.units, self.log.units)
            for channel in self.log:
                np.testing.assert_array_equal(back[channel], self.log[channel])
            self.assertEqual(back.metrics["yaw_rate_response_time"], self.log.metrics["yaw_rate_response_time"])
            self.assertEqual((back.answer, back.inputs, back.accepted), ("", "", None))
        self.assertEqual(program("metrics", self.scratch / "log.csv").count("\n"),
                         program("metrics", self.scratch / "log.tlog").count("\n"))

    def test_the_page_is_that_of_the_program_and_of_a_log_alone(self):
        self.log.report(self.scratch / "run.html")
        self.log.save(self.scratch / "log.csv")
        tread.read_log(self.scratch / "log.csv").report(self.scratch / "log.html")
        for name in ("run.html", "log.html"):
            self.assertTrue((self.scratch / name).read_text().startswith("<!DOCTYPE html>"))

    def test_files_that_are_faulty_or_missing(self):
        with self.assertRaisesRegex(tread.FileError, "cannot read") as caught:
            tread.read_log(self.scratch / "none.csv")
        self.assertIsInstance(caught.exception, OSError)
        self.assertIsInstance(caught.exception, tread.InputError)
        for text in ("", "time [s]\n", "time [s],a [-]\n0,1\n0,2\n", "time [s],a [-]\n0,x\n"):
            with self.assertRaises(tread.InputError, msg=repr(text)) as caught:
                tread.read_log(self.file("bad.csv", text))
            self.assertEqual(caught.exception.file, str(self.scratch / "bad.csv"))
        with self.assertRaisesRegex(tread.InputError, "expected .csv or .tlog"):
            self.log.save(self.scratch / "log.xlsx")
        with self.assertRaises(tread.FileError):
            self.log.report(self.scratch / "none/report.html")
        with self.assertRaises(TypeError):
            tread.read_log(3)

    def test_a_log_of_arrays(self):
        time = np.linspace(0, 1, 11)
        log = tread.Log({"time": time, "chassis.yaw_rate": np.sin(time), "own": time}, {"own": "V"})
        self.assertEqual(log.units, {"time": "s", "chassis.yaw_rate": "rad/s", "own": "V"})
        log.save(self.scratch / "own.csv")
        np.testing.assert_array_equal(tread.read_log(self.scratch / "own.csv")["own"], time)
        with self.assertRaisesRegex(tread.InputError, "contains none of the known manoeuvres"):
            log.metrics
        with self.assertRaisesRegex(tread.InputError, "expected one of tread.run"):
            log.save_run(self.scratch / "run")

    def test_arrays_that_are_no_log(self):
        for channels in ({}, {"a": [1]}, {"time": []}, {"time": [0, 1], "a": [1, 2, 3]}, {"time": [[0, 1]]},
                         {"time": [0, 0]}, {"time": [0, np.nan]}):
            with self.assertRaises(tread.InputError, msg=str(channels)):
                tread.Log(channels)
        with self.assertRaises(TypeError):
            tread.Log({1: [0]})
        with self.assertRaisesRegex(tread.InputError, "chassis.yaw_rate"):
            tread.Log({"time": [0, 1], "chassis.yaw_rate": [0, 1]}, {"chassis.yaw_rate": "deg/s"})

    @unittest.skipUnless(pandas, "pandas is not installed")
    def test_to_pandas(self):
        frame = self.log.to_pandas()
        self.assertEqual(frame.shape, (self.log.samples, len(self.log) - 1))
        self.assertEqual(frame.index.name, "time")

    def test_to_pandas_without_pandas_says_what_is_missing(self):
        with mock.patch.dict("sys.modules", pandas=None), self.assertRaisesRegex(ImportError, "needs pandas"):
            self.log.to_pandas()


class Comparisons(WithScratch):
    def setUp(self):
        super().setUp()
        scenario = self.file("stop.yaml", STOP)
        self.first = tread.run("compact", scenario)
        self.second = tread.run("compact", scenario, {"mass": 1600})

    def test_equal_and_different_logs(self):
        self.first.save(self.scratch / "first.csv")
        same = tread.compare(self.first, self.scratch / "first.csv")
        self.assertTrue(same)
        self.assertTrue(same.same and same.answer.startswith("Same"))
        other = tread.compare(self.first, self.second, report=True)
        self.assertFalse(other)
        self.assertGreater(sum(not channel["same"] for channel in other.channels), 3)
        other.report(self.scratch / "compare.html")
        self.assertIn("[changed: mass 1600 kg", (self.scratch / "compare.html").read_text())

    def test_the_json_is_that_of_the_program(self):
        import json
        import subprocess

        from places import PROGRAM

        for log, name in ((self.first, "a.csv"), (self.second, "b.csv")):
            log.save(self.scratch / name)
        words = [PROGRAM, "compare", self.scratch / "a.csv", self.scratch / "b.csv", "--json"]
        theirs = subprocess.run(words, capture_output=True, text=True).stdout
        self.assertEqual(tread.compare(self.first, self.second).json, json.loads(theirs))

    def test_tolerances_and_scores(self):
        wide = self.file("wide.yaml", "relative: 1000\n")
        self.assertTrue(tread.compare(self.first, self.second, tolerances=wide))
        self.assertTrue(tread.compare(self.first, self.first, score="iso18571"))
        with self.assertRaisesRegex(tread.InputError, "iso18571 or the name of a file"):
            tread.compare(self.first, self.first, score="iso")
        with self.assertRaises(ValueError):
            tread.compare(self.first, self.second, score="iso18571", envelope="iso19364")

    def test_nothing_in_common(self):
        mine, yours = (tread.Log({"time": [0, 1], name: [1, 2]}) for name in "ab")
        with self.assertRaisesRegex(tread.InputError, "nothing was compared"):
            tread.compare(mine, yours)


if __name__ == "__main__":
    unittest.main()
