"""A car that is stepped."""

import unittest

import numpy as np

import tread


class Vehicles(unittest.TestCase):
    def car(self, speed=20, **more):
        car = tread.Vehicle("compact", **more)
        car.start(speed)
        return car

    def test_a_step_steer(self):
        car = self.car()
        x = car.position[0]
        for _ in range(100):
            car.advance(0.01, steering_wheel_angle=0.5)
        self.assertAlmostEqual(car.time, 1)
        self.assertGreater(car["chassis.yaw_rate"], 0.1)
        self.assertAlmostEqual(car.position[0] - x, 20, delta=0.5)
        self.assertEqual(set(car.outputs), set(tread.Vehicle.units))
        self.assertEqual(car.outputs["chassis.vx"], car["chassis.vx"])
        self.assertEqual((car.velocity.shape, car.angular_velocity.shape), ((3,), (3,)))
        self.assertAlmostEqual(np.linalg.norm(car.orientation), 1)
        self.assertEqual(car.input.steering_wheel_angle, 0.5)

    def test_how_time_is_divided_does_not_matter(self):
        one, other = self.car(), self.car()
        one.advance(2.5, steering_wheel_angle=0.4)
        for _ in range(250):
            other.advance(0.01, tread.VehicleInput(steering_wheel_angle=0.4, throttle=one.input.throttle))
        self.assertEqual(one["chassis.x"], other["chassis.x"])

    def test_a_ground_of_ones_own(self):
        asked = set()

        def slope(x, y, z, wheel):
            asked.add(wheel)
            return 0.1 * x, (-0.1, 0, 1) / np.sqrt(1.01), 0.9

        car = tread.Vehicle("compact")
        car.set_ground(slope)
        car.start(0, input={"brake": 1})
        car.advance(0.5)
        self.assertEqual(asked, {0, 1, 2, 3})
        self.assertAlmostEqual(car["chassis.pitch"], -np.arctan(0.1), delta=0.01)
        self.assertLess(abs(car["chassis.vx"]), 1e-3)

    def test_the_friction_of_a_road(self):
        stops = []
        for friction in (1.0, 0.3):
            car = self.car(10, road={"friction": friction})
            car.advance(0.7, brake=1.0, clutch=1.0)
            stops.append(car["chassis.vx"])
        self.assertLess(stops[0] + 2, stops[1])

    def test_faults_of_a_ground_reach_the_caller(self):
        def fails(x, y, z, wheel):
            raise LookupError("no map here")

        for ground, error, words in ((fails, LookupError, "no map here"), (lambda *_: "low", TypeError, "ground"),
                                     (lambda *_: (0.0, (0, 0, 0)), tread.InputError, "plane|normal|ground")):
            car = tread.Vehicle("compact")
            car.set_ground(ground)
            with self.assertRaisesRegex(error, words):
                car.start(10)
                car.advance(0.1)
        with self.assertRaisesRegex(TypeError, "expected a function"):
            car.set_ground(0.0)

    def test_a_snapshot_goes_on_to_the_last_bit(self):
        car = self.car()
        car.advance(0.5, steering_wheel_angle=1)
        kept = car.snapshot()
        car.advance(0.5)
        first = car.outputs
        car.restore(kept)
        car.advance(0.5)
        self.assertEqual(car.outputs, first)
        other = tread.Vehicle("rear_drive_sedan")
        other.start(10)
        for bad in (b"", kept[:-1], other.snapshot()):
            with self.assertRaises(tread.InputError):
                car.restore(bad)

    def test_a_ramp_and_the_wind(self):
        held, ramped, blown = self.car(), self.car(), self.car()
        blown.set_wind((0, 20, 0))
        held.advance(0.1, steering_wheel_angle=1)
        ramped.advance(0.1, steering_wheel_angle=1, ramp=True)
        blown.advance(0.1)
        self.assertLess(ramped["chassis.yaw_rate"], held["chassis.yaw_rate"])
        self.assertGreater(blown["chassis.vy"], 0)

    def test_bad_input(self):
        car = self.car()
        for call, error, words in (
            (lambda: car.advance(float("nan")), tread.InputError, "duration: found nan"),
            (lambda: car.advance("1"), TypeError, "duration: found str"),
            (lambda: car.advance(0.1, throttle=float("inf")), tread.InputError, "throttle: found inf"),
            (lambda: car.advance(0.1, throtle=1), TypeError, "throtle"),
            (lambda: car.advance(0.1, {"throtle": 1}), TypeError, "throtle"),
            (lambda: tread.VehicleInput(throtle=1), TypeError, "throttle"),
            (lambda: car["chassis.yawrate"], KeyError, "chassis.yaw_rate"),
            (lambda: car.start(-1), tread.InputError, "at least 0"),
            (lambda: car.set_wind((0, float("nan"), 0)), tread.InputError, "wind"),
            (lambda: tread.Vehicle("compact", step=1), tread.InputError, "inner step"),
            (lambda: tread.Vehicle("compact", {"mas": 1}), tread.InputError, "did you mean"),
            (lambda: tread.Vehicle("compact", road={"fricton": 1}), tread.InputError, "did you mean"),
            (lambda: tread.Vehicle("compact").advance(0.1), tread.InputError, "start"),
        ):
            with self.assertRaisesRegex(error, words):
                call()

    def test_a_car_that_breaks_down_says_when(self):
        car = tread.Vehicle("compact")
        car.set_ground(lambda x, y, z, wheel: 0.0 if x < 10 else None)
        car.start(20)
        with self.assertRaises(tread.SimulationError) as caught:
            car.advance(600)
        self.assertGreater(caught.exception.time, 1)

    def test_the_fields_are_those_of_the_description(self):
        rows = {row["path"]: row for row in tread.describe("log")}
        inputs = [path.split(".", 1)[1] for path in rows if path.startswith("driver.")]
        for name in inputs:
            doc = getattr(tread.VehicleInput, name).__doc__
            self.assertIn(rows[f"driver.{name}"]["meaning"], doc)
            self.assertTrue(doc.startswith(f"[{rows[f'driver.{name}']['unit']}]"))
        self.assertEqual(tread.Vehicle.units["chassis.yaw_rate"], "rad/s")
        self.assertEqual(repr(tread.VehicleInput(throttle=0.5)), "VehicleInput(throttle=0.5)")


if __name__ == "__main__":
    unittest.main()
