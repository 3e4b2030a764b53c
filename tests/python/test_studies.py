"""Diagnosis, identification, campaigns."""

import os
import signal
import threading
import unittest

import numpy as np
from places import SOURCE, STOP, WithScratch

import tread

CHANNELS = ["time", "driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate", "chassis.ay"]
CAMPAIGN = """title: Stops
vehicles: [{vehicle}]
scenarios: [stop.yaml]
factors:
  - {{path: scenario.road.friction, uniform: {{from: 0.6, to: 1}}}}
  - {{path: load.mass, list: [0, 100 kg]}}
samples: 4
runs_per_piece: 2
"""


class Diagnoses(WithScratch):
    """A car whose steering ratio is 19 in place of 16.5, in two seconds of a step steer."""

    def setUp(self):
        super().setUp()
        log = tread.run("compact", "step_steer_80", {"steering.ratio": 19, "scenario.log.rate": 50,
                                                     "scenario.phases.1.until.duration": 1})
        tread.Log({name: log[name] for name in CHANNELS}).save(self.scratch / "a.csv")
        self.diagnosis = self.file("diagnosis.yaml", f"""vehicle: {SOURCE / 'vehicles/compact.yaml'}
recordings:
  - {{log: a.csv, speed: followed}}
effects: [steering_ratio]
fit: [steering.ratio]
""")

    def test_a_diagnosis(self):
        shares = []
        found = tread.diagnose(self.diagnosis, progress=shares.append, output=self.scratch / "out")
        self.assertEqual((found.verdict, found.causes), (found.json["verdict"], found.json["causes"]))
        effect = found.effects[0]
        self.assertEqual((effect.name, found.answered), ("steering_ratio", True))
        self.assertGreater(effect.probability, 0.9)
        estimate = effect.parameters["steering.ratio"]
        self.assertTrue(estimate.low < 19 < estimate.high and estimate.neutral == 16.5)
        self.assertAlmostEqual(sum(getattr(found.shares, name) for name in ("tolerances", "causes", "remainder", "noise")), 1)
        self.assertEqual(found.remaining, found.shares.remainder)
        self.assertIn("steering", found.vehicle)
        self.assertTrue(found.text.startswith(found.answer.split(";")[0][:10]))
        self.assertTrue((self.scratch / "out/diagnosis.json").exists())
        found.report(self.scratch / "page.html")
        self.assertEqual((self.scratch / "page.html").read_bytes(), (self.scratch / "out/report.html").read_bytes())
        self.assertEqual(shares, sorted(shares))

    def test_ctrl_c_ends_a_diagnosis(self):
        threading.Timer(0.15, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            for _ in range(100):  # on whatever machine
                tread.diagnose(self.diagnosis)

    def test_an_identification(self):
        found = tread.identify(self.diagnosis)
        number = found.numbers[0]
        self.assertEqual((number.path, number.nominal, number.determined), ("steering.ratio", 16.5, True))
        self.assertGreater(number.value, number.nominal + 2 * number.sd)
        self.assertEqual(found.correlation.shape, (1, 1))

    def test_bad_input(self):
        for call in (tread.diagnose, tread.identify):
            with self.assertRaisesRegex(tread.InputError, "found no file of this name"):
                call(self.scratch / "none.yaml")
            with self.assertRaisesRegex(tread.InputError, "threads"):
                call(self.diagnosis, threads=-1)
        with self.assertRaisesRegex(tread.InputError, "^fit: .*steering.ration"):
            tread.identify(self.diagnosis, ["steering.ration"])
        with self.assertRaises(TypeError):
            tread.identify(self.diagnosis, "steering.ratio")
        (self.scratch / "a.csv").unlink()
        with self.assertRaises(tread.InputError) as caught:
            tread.diagnose(self.diagnosis)
        self.assertEqual((caught.exception.file, caught.exception.line), (str(self.diagnosis), 3))


class Campaigns(WithScratch):
    def setUp(self):
        super().setUp()
        self.file("stop.yaml", STOP)
        self.campaign = self.file("campaign.yaml", CAMPAIGN.format(vehicle=SOURCE / "vehicles/compact.yaml"))

    def test_the_table(self):
        campaign = tread.Campaign(self.campaign)
        self.assertEqual((campaign.title, campaign.runs), ("Stops", 8))
        result = campaign.run(self.scratch / "out", threads=2)
        self.assertEqual(result["run"].tolist(), list(range(8)))
        self.assertEqual(set(result.factors), {"scenario.road.friction", "load.mass"})
        self.assertTrue((result["stopping_distance"] > 0).all())
        self.assertIn("stopping_distance", result.metrics)
        self.assertEqual(set(result["status"]), {"ok"})
        self.assertEqual(result.units["load.mass"], "kg")
        self.assertTrue(((result["scenario.road.friction"] >= 0.6) & (result["scenario.road.friction"] <= 1)).all())
        self.assertTrue((result.folder / "report.html").exists())
        again = tread.CampaignResult(result.folder)
        np.testing.assert_array_equal(again["load.mass"], result["load.mass"])
        self.assertEqual(tread.Campaign(result.folder).run()["run"].size, 8)
        with self.assertRaisesRegex(KeyError, "did you mean 'load.mass'"):
            result["load.mas"]

    def test_settings_and_bad_input(self):
        self.assertEqual(tread.Campaign(self.campaign, {"samples": 2}).runs, 4)
        with self.assertRaisesRegex(tread.InputError, "did you mean"):
            tread.Campaign(self.campaign, {"sample": 2})
        with self.assertRaises(tread.InputError):
            tread.Campaign(self.scratch / "none.yaml")
        with self.assertRaisesRegex(tread.InputError, "expected the folder of a campaign that is done"):
            tread.CampaignResult(self.scratch)

    def test_ctrl_c_ends_it_and_the_same_call_goes_on(self):
        campaign = tread.Campaign(self.campaign, {"samples": 20000})
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            campaign.run(self.scratch / "long")


if __name__ == "__main__":
    unittest.main()
