"""tread.run(): the same as the program, settings, failures, Ctrl-C, threads."""

import json
import os
import signal
import threading
import time
import unittest
import warnings

import numpy as np
from places import CRUISE, SOURCE, STOP, WithScratch, program

import tread


class Run(WithScratch):
    def setUp(self):
        super().setUp()
        self.scenario = self.file("stop.yaml", STOP)

    def stop(self, settings=None, **more):
        return tread.run("compact", self.scenario, settings, **more)

    def test_the_log_and_the_metrics_are_those_of_the_program(self):
        settings = {"mass": 1500, "scenario.road.friction": 0.7, "brakes.anti_lock.enabled": True}
        log = tread.run(SOURCE / "vehicles/compact.yaml", SOURCE / "scenarios/step_steer_80.yaml", settings)
        words = [word for path, value in settings.items() for word in ("--set", f"{path}={str(value).lower()}")]
        program("run", SOURCE / "vehicles/compact.yaml", SOURCE / "scenarios/step_steer_80.yaml", *words, "-o",
                self.scratch / "program")
        log.save_run(self.scratch / "python")
        for name in ("log.csv", "metrics.json", "run.yaml"):
            there, here = (self.scratch / who / name for who in ("program", "python"))
            self.assertEqual(here.read_bytes(), there.read_bytes(), name)
        log.save(self.scratch / "alone.csv")
        self.assertEqual((self.scratch / "alone.csv").read_bytes(), (self.scratch / "program/log.csv").read_bytes())
        self.assertFalse((self.scratch / "python/INCOMPLETE").exists())
        metrics = json.loads((self.scratch / "program/metrics.json").read_text())
        self.assertEqual(log.answer, metrics["answer"])
        self.assertEqual(set(log.metrics), {metric["name"] for metric in metrics["metrics"]})

    def test_bare_names_are_the_shipped_files_for_the_program_too(self):
        log = tread.run("compact", "step_steer_80", {"scenario.phases.1.until.duration": 0.1})
        program("run", "compact", "step_steer_80", "--set", "scenario.phases.1.until.duration=0.1", "-o", self.scratch)
        self.assertEqual(log.samples, tread.read_log(self.scratch / "log.csv").samples)

    def test_settings_are_numbers_texts_lists_and_arrays(self):
        plain = self.stop({"mass": 1400, "scenario.start.speed": 5.0})
        for settings in ({"mass": "1400 kg", "scenario.start.speed": "18 km/h"}, ["mass=1400", "scenario.start.speed=5"],
                         {"mass": np.float64(1400), "scenario.start.speed": np.int64(5)}):
            np.testing.assert_array_equal(self.stop(settings)["chassis.vx"], plain["chassis.vx"])
        curve = {"aero.drag_area": 0.7, "scenario.log.channels": ["chassis.*"]}
        self.assertEqual([name for name in self.stop(curve) if name.startswith("wheel")], [])

    def test_conditions_and_metrics_of_ones_own(self):
        accept = self.file("accept.yaml", "accept:\n  stopping_distance: < 1 m\n")
        own = self.file("own.yaml", "metrics:\n  - {name: top, unit: m/s, value: max(chassis.vx)}\n")
        log = self.stop(accept=accept, metrics=own)
        self.assertIs(log.accepted, False)
        self.assertIsNone(self.stop().accepted)
        self.assertAlmostEqual(log.metrics["top"], 15 / 3.6, places=2)

    def test_faults_of_files_have_file_line_and_column(self):
        bad = self.file("bad.yaml", STOP.replace("speed: 15 km/h", "sped: 15 km/h"))
        with self.assertRaises(tread.InputError) as caught:
            tread.run("compact", bad)
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column), (str(bad), 3, 9))
        self.assertIn('did you mean "speed"?', str(error))
        self.assertIsInstance(error, ValueError)
        self.assertEqual(error.problems[0].path, "start")

    def test_faults_of_settings(self):
        for settings, words in (
            ({"mas": 1}, 'settings: mas: found the unknown path "mas", expected the path of a field; did you mean "mass"?'),
            ({"mass": "heavy"}, "settings: mass: found \"heavy\", which is not a number"),
            ({"mass": float("nan")}, "which is not a number"),
            ({"mass": -1}, "settings: mass: "),
        ):
            with self.assertRaises(tread.InputError) as caught:
                self.stop(settings)
            self.assertIn(words, str(caught.exception))
        for settings in ("mass=1", {"mass": object()}, [1], 5):
            with self.assertRaises(TypeError):
                self.stop(settings)

    def test_wrong_types_and_missing_files(self):
        with self.assertRaisesRegex(TypeError, "vehicle: found int, expected a file name"):
            tread.run(5, "step_steer_80")
        with self.assertRaisesRegex(tread.InputError, "nowhere.yaml: found no file of this name"):
            tread.run("nowhere.yaml", "step_steer_80")
        with self.assertRaisesRegex(tread.InputError, "expected a vehicle"):
            tread.run(SOURCE / "scenarios/step_steer_80.yaml", "step_steer_80")

    def test_a_series_is_that_of_the_program(self):
        several = self.file("several.yaml", STOP + "series: {vary: {number: start.speed, values: [10 km/h, 15 km/h]}}\n")
        with self.assertRaisesRegex(tread.InputError, "found a series of runs, expected a single run; tread.run_series"):
            tread.run("compact", several)
        series = tread.run_series("compact", several)
        program("run", SOURCE / "vehicles/compact.yaml", several, "-o", self.scratch / "out")
        table = np.genfromtxt(self.scratch / "out/series.csv", delimiter=",", names=True, deletechars="")
        self.assertEqual((series.number, series.unit), ("start.speed", "m/s"))
        np.testing.assert_array_equal(series.values, table[table.dtype.names[0]])
        np.testing.assert_array_equal(series.passed, table[table.dtype.names[1]])
        name = "stopping_distance"
        column = next(one for one in table.dtype.names if one.startswith(name))
        np.testing.assert_array_equal(series.metrics[name], table[column])
        self.assertTrue(np.isnan(series.highest))
        with self.assertRaisesRegex(tread.InputError, "expected a series of runs"):
            tread.run_series("compact", self.scenario)

    def test_a_simulation_that_fails_tells_its_time(self):
        with self.assertRaises(tread.SimulationError) as caught:
            self.stop({"scenario.time_limit": 0.25})
        self.assertAlmostEqual(caught.exception.time, 0.25, places=2)
        self.assertIsInstance(caught.exception, RuntimeError)

    def test_implausible_numbers_are_warnings_or_errors(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            log = self.stop({"scenario.log.rate": 25000})
        self.assertEqual([one.category for one in caught][:1], [tread.InputWarning])
        self.assertEqual(caught[0].filename, __file__)
        self.assertTrue(log.warnings)
        with self.assertRaises(tread.InputError):
            self.stop({"scenario.log.rate": 25000}, strict=True)

    def test_ctrl_c_ends_a_run_and_other_threads_work_meanwhile(self):
        counted = 0
        ended = threading.Event()

        def count():
            nonlocal counted
            while not ended.is_set():
                counted += 1
                time.sleep(0.001)

        worker = threading.Thread(target=count)
        worker.start()
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        begun = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            tread.run("compact", self.file("cruise.yaml", CRUISE))
        self.assertLess(time.monotonic() - begun, 60)
        ended.set()
        worker.join()
        self.assertGreater(counted, 3)

    def test_progress_is_told_and_may_end_the_run(self):
        shares = []

        def tell(share):
            shares.append(share)
            if len(shares) == 3:
                raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            tread.run("compact", self.file("cruise.yaml", CRUISE), progress=tell)
        self.assertEqual(shares, sorted(shares))

    def test_runs_in_several_threads_are_the_same(self):
        logs = [None] * 4

        def drive(i):
            logs[i] = self.stop()

        threads = [threading.Thread(target=drive, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for log in logs[1:]:
            np.testing.assert_array_equal(log["chassis.vx"], logs[0]["chassis.vx"])


if __name__ == "__main__":
    unittest.main()
