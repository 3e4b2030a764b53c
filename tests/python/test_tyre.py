"""Steady-state tyre forces."""

import unittest

import numpy as np
from places import SOURCE, WithScratch, program

import tread


class Tyres(WithScratch):
    def setUp(self):
        super().setUp()
        self.tyre = tread.Tyre("car_205_60R15")

    def test_forces_are_those_of_the_program(self):
        random = np.random.default_rng(1)
        Fz, alpha, kappa, gamma, V = random.uniform([0, -0.3, -0.5, -0.1, 1], [8000, 0.3, 0.5, 0.1, 50], (20, 5)).T
        forces = self.tyre.forces(Fz, alpha, kappa, gamma, V)
        # The program takes slip velocities, ISO 8855.
        rows = np.column_stack([Fz, gamma, V, -kappa * V, np.tan(alpha) * V])
        lines = ["Fz,gamma,Vx,Vsx,Vsy", *(",".join(map(repr, row)) for row in rows.tolist())]
        self.file("points.csv", "\n".join(lines) + "\n")
        program("tyre", SOURCE / "vehicles/tyres/car_205_60R15.yaml", "--table", self.scratch / "points.csv", "-o",
                self.scratch / "forces.csv")
        table = np.genfromtxt(self.scratch / "forces.csv", delimiter=",", names=True)
        for name in ("Fx", "Fy", "Mx", "My", "Mz", "Ky", "alpha"):
            np.testing.assert_allclose(getattr(forces, name), table[name], rtol=1e-9, atol=1e-9, err_msg=name)

    def test_shapes_are_broadcast(self):
        forces = self.tyre.forces([[2000], [4000]], [-0.1, -0.05, 0, 0.05, 0.1])
        self.assertEqual(forces.Fy.shape, (2, 5))
        self.assertEqual(forces.Fy[1, 3], self.tyre.forces(4000, 0.05).Fy)
        self.assertIsInstance(self.tyre.forces(4000).Fx, float)
        self.assertEqual(self.tyre.forces([], 0.1).Fy.shape, (0,))
        many = self.tyre.forces(4000, np.linspace(-0.2, 0.2, 20001)).Fy  # by another thread
        self.assertEqual(many[12500], self.tyre.forces(4000, np.linspace(-0.2, 0.2, 20001)[12500]).Fy)

    def test_signs(self):
        forces = self.tyre.forces(4000, 0.05, 0.0)
        self.assertLess(forces.Fy, 0)
        self.assertGreater(forces.Mz, 0)
        self.assertGreater(self.tyre.forces(4000, 0, 0.05).Fx, 0)

    def test_settings_scale(self):
        weak = tread.Tyre("car_205_60R15", {"lambda.muy": 0.5})
        self.assertAlmostEqual(weak.forces(4000, 0.3).muy / self.tyre.forces(4000, 0.3).muy, 0.5)

    def test_bad_input(self):
        for given, words in (
            ({"Fz": [1, 2], "alpha": [1, 2, 3]}, r"Fz \(2,\), alpha \(3,\), which cannot be broadcast"),
            ({"Fz": 4000, "alpha": [0, np.nan]}, "alpha: found nan at point 1, expected finite numbers"),
            ({"Fz": np.inf}, "Fz: found inf at point 0"),
        ):
            with self.assertRaisesRegex(tread.InputError, words):
                self.tyre.forces(**given)
        for given in ("heavy", None, [1, "a"], 1j):
            with self.assertRaisesRegex(TypeError, "Fz: found"):
                self.tyre.forces(given)
        with self.assertRaisesRegex(tread.InputError, "none.tir"):
            tread.Tyre(self.scratch / "none.tir")
        with self.assertRaisesRegex(tread.InputError, "expected a tyre"):
            tread.Tyre(SOURCE / "vehicles/compact.yaml")


if __name__ == "__main__":
    unittest.main()
