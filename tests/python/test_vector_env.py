"""Many cars at a time."""

import inspect
import unittest

import numpy as np

import tread

NAMES = ["chassis.x", "chassis.vx", "chassis.yaw_rate"]
START = {"speed": (10, 30), "y": (-2, 2)}


def env(n=5, **more):
    return tread.VectorEnv(n, "compact", observations=NAMES, **{"start": START, "threads": 2, **more})


class VectorEnvs(unittest.TestCase):
    def test_the_interface_is_that_of_gymnasium(self):
        # gymnasium.vector.VectorEnv, version 1: names, order and kinds of the parameters.
        reset, step = inspect.signature(tread.VectorEnv.reset), inspect.signature(tread.VectorEnv.step)
        self.assertEqual(list(reset.parameters), ["self", "seed", "options"])
        self.assertTrue(all(reset.parameters[name].kind is inspect.Parameter.KEYWORD_ONLY for name in ("seed", "options")))
        self.assertTrue(all(reset.parameters[name].default is None for name in ("seed", "options")))
        self.assertEqual(list(step.parameters), ["self", "actions"])
        one = env()
        observations, infos = one.reset(seed=1, options=None)
        self.assertEqual((observations.shape, observations.dtype), ((5, 3), np.float64))
        self.assertIsInstance(infos, dict)
        observations, rewards, terminations, truncations, infos = one.step(one.action_space.sample())
        self.assertEqual((rewards.shape, rewards.dtype), ((5,), np.float64))
        for flags in (terminations, truncations):
            self.assertEqual((flags.shape, flags.dtype), ((5,), bool))
        self.assertEqual(one.num_envs, 5)
        self.assertEqual((one.action_space.shape, one.single_action_space.shape), ((5, 3), (3,)))
        self.assertEqual((one.observation_space.shape, one.single_observation_space.shape), ((5, 3), (3,)))
        self.assertIn(observations, one.observation_space)
        np.testing.assert_array_equal(one.single_action_space.low, [-np.pi, 0, 0])
        np.testing.assert_array_equal(one.single_action_space.high, [np.pi, 1, 1])
        self.assertIs(one.unwrapped, one)
        one.close()

    def test_each_car_is_bit_for_bit_a_single_car(self):
        random = np.random.default_rng(2)
        actions = random.uniform((-1, 0, 0), (1, 0.5, 0.1), (20, 5, 3))
        many, single_thread = env(), env(threads=1)
        for one in (many, single_thread):
            one.reset(seed=7)
        speeds, places = many.output("chassis.vx"), many.output("chassis.y")
        starts = [np.random.default_rng(7 + i) for i in range(5)]
        cars = [tread.Vehicle("compact") for _ in range(5)]
        for car, draw in zip(cars, starts):
            speed, y = draw.uniform(10, 30), draw.uniform(-2, 2)
            car.start(speed, y=y)
        for now in actions:
            a, b = many.step(now)[0], single_thread.step(now)[0]
            np.testing.assert_array_equal(a, b)
        for i, car in enumerate(cars):
            for now in actions:
                car.advance(0.02, dict(zip(("steering_wheel_angle", "throttle", "brake"), now[i])))
            self.assertEqual([car[name] for name in NAMES], a[i].tolist())
        self.assertTrue((speeds > 9).all() and np.unique(places).size == 5)

    def test_seeds(self):
        one, two = env(), env()
        first, _ = one.reset(seed=3)
        np.testing.assert_array_equal(first, two.reset(seed=[3, 4, 5, 6, 7])[0])
        again, _ = one.reset()
        self.assertFalse(np.array_equal(first, again))
        np.testing.assert_array_equal(again, two.reset()[0])

    def test_a_reset_by_mask_leaves_the_others(self):
        one = env()
        one.reset(seed=1)
        for _ in range(5):
            before = one.step(np.zeros((5, 3)))[0]
        mask = np.array([False, True, False, True, False])
        after, infos = one.reset(options={"reset_mask": mask})
        np.testing.assert_array_equal(after[~mask], before[~mask])
        self.assertTrue((np.abs(after[mask, 0]) < np.abs(before[mask, 0])).all())
        np.testing.assert_allclose(infos["time"], np.where(mask, 0, 0.1))

    def test_rewards_terminations_truncations(self):
        one = env(reward=lambda obs, actions: obs[:, 1] + actions[:, 0], termination=lambda obs: obs[:, 1] > 20,
                  time_limit=0.06)
        one.reset(seed=1)
        observations, rewards, terminations, truncations, _ = one.step(np.full((5, 3), 0.25))
        np.testing.assert_array_equal(rewards, observations[:, 1] + 0.25)
        fast = observations[:, 1] > 20
        np.testing.assert_array_equal(terminations, fast)
        self.assertTrue(fast.any() and not fast.all() and not truncations.any())
        _, rewards, terminations, truncations, infos = one.step(np.zeros((5, 3)))  # the next step resets those
        np.testing.assert_array_equal(infos["time"] == 0, fast)
        self.assertTrue((rewards[fast] == 0).all() and not terminations[fast].any())
        truncations = one.step(np.zeros((5, 3)))[3]
        np.testing.assert_array_equal(truncations, ~fast)  # after 0.06 s

    def test_a_car_on_its_roof_is_done(self):
        tall = {"centre_of_gravity_height": 1.6}
        one = tread.VectorEnv(2, "compact", settings=[tall, {}], start={"speed": 30}, autoreset=False)
        one.reset()
        for _ in range(300):
            terminations = one.step([[np.pi, 0, 0]] * 2)[2]
            if terminations.any():
                break
        self.assertEqual(terminations.tolist(), [True, False])
        observations, _ = one.reset(options={"reset_mask": terminations})
        self.assertAlmostEqual(observations[0, 0], 30, delta=0.1)

    def test_bad_input(self):
        one = env()
        for call, error, words in (
            (lambda: one.step(np.zeros((5, 3))), tread.InputError, "before the first reset"),
            (lambda: one.reset(options={"reset_mask": np.eye(5, dtype=bool)[0]}), tread.InputError, "reset of all"),
            (lambda: one.reset() and one.step(np.zeros((5, 2))), tread.InputError, r"found the shape \(5, 2\)"),
            (lambda: one.step(np.full((5, 3), np.nan)), tread.InputError, "for car 0, expected finite numbers"),
            (lambda: one.step([["a"] * 3] * 5), TypeError, "expected numbers"),
            (lambda: one.reset(options={"reset_mask": [1, 0]}), tread.InputError, "reset_mask"),
            (lambda: one.reset(seed=[1]), tread.InputError, "found 1 seeds"),
            (lambda: env(0), tread.InputError, "num_envs"),
            (lambda: env(2.5), tread.InputError, "num_envs"),
            (lambda: env(dt=0.0015), tread.InputError, "whole number of inner steps"),
            (lambda: env(step=1.0, dt=1.0), tread.InputError, "step"),
            (lambda: env(start={"sped": 1}), tread.InputError, "expected one of speed"),
            (lambda: env(start={"speed": (30, 10)}), tread.InputError, "speed"),
            (lambda: env(settings=[{}, {}]), tread.InputError, "found 2 of them"),
            (lambda: env(actions=["throtle"]), tread.InputError, "throttle"),
            (lambda: env(actions=["longitudinal_force"]), tread.InputError, "found no limits"),
            (lambda: tread.VectorEnv(2, observations=["chassis.v"]), tread.InputError, "chassis.v"),
            (lambda: env(reward=lambda *_: 1).reset() and None, None, ""),
        ):
            if error is None:
                call()
                continue
            with self.assertRaisesRegex(error, words):
                call()
        wrong = env(reward=lambda *_: np.zeros(3))
        wrong.reset()
        with self.assertRaisesRegex(tread.InputError, r"reward: found the shape \(3,\), expected \(5,\)"):
            wrong.step(np.zeros((5, 3)))
        one.close()
        with self.assertRaisesRegex(tread.InputError, "closed"):
            one.step(np.zeros((5, 3)))
        with self.assertRaisesRegex(tread.InputError, "closed"):
            one.reset()


if __name__ == "__main__":
    unittest.main()
