"""A car that is stepped."""

from __future__ import annotations

import math
import numbers
from typing import Any, Callable, Mapping, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _tread
from ._arguments import PathLike, Settings, path_text, settings_list
from ._described import VehicleInput
from ._errors import InputError

#: What a ground function answers: None where there is no ground, its height [m], or height, normal and friction.
GroundAnswer = Union[None, float, Tuple[float, Sequence[float]], Tuple[float, Sequence[float], float]]


def number(value: Any, what: str) -> float:
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{what}: found {type(value).__name__}, expected a number")
    if not math.isfinite(value):
        raise InputError(f"{what}: found {value}, expected a finite number")
    return float(value)


def input_of(value: VehicleInput | Mapping[str, float] | None) -> VehicleInput:
    if value is None:
        return VehicleInput()
    return value if isinstance(value, VehicleInput) else VehicleInput(**value)


class Vehicle:
    """A car that Python steps.

        car = tread.Vehicle("compact")
        car.start(speed=20)
        for _ in range(200):
            car.advance(0.01, steering_wheel_angle=0.3, throttle=0.2)
            car["chassis.yaw_rate"]

    vehicle    YAML file, or the bare name of a car that tread brings along
    settings   {path: value}, as in tread.run()
    road       {path: value} of the road, for example {"friction": 0.4}; a level plane unless given. set_ground() has
               any other.
    step       inner time step [s]

    Inputs are the fields of tread.VehicleInput, outputs the channels of a log (Vehicle.units). World axes: x and y
    level, z up.
    """

    #: Unit of each output by name.
    units: dict[str, str] = {name: unit for name, unit, _ in _tread.output_channels()}
    #: Meaning of each output by name.
    meanings: dict[str, str] = {name: meaning for name, _, meaning in _tread.output_channels()}

    def __init__(self, vehicle: PathLike, settings: Settings = None, *, road: Settings = None, step: float = 0.001):
        self._car = _tread.Vehicle(
            path_text(vehicle, "vehicle"), settings_list(settings), settings_list(road), number(step, "step")
        )

    def set_ground(self, ground: Callable[[float, float, float, int], GroundAnswer]) -> None:
        """A function of the ground below a wheel centre: ground(x, y, z, wheel), in m, wheels 0 to 3 (front left, front
        right, rear left, rear right). It answers with the height [m] there, with (height, normal, friction), or with
        None where there is no ground. To be set before start()."""
        if not callable(ground):
            raise TypeError(f"ground: found {type(ground).__name__}, expected a function")
        self._car.set_ground(ground)

    def set_wind(self, velocity: Sequence[float]) -> None:
        """Velocity of the air [m/s] in the world, shape (3,)."""
        self._car.set_wind(velocity)

    def start(
        self,
        speed: float = 0.0,
        *,
        x: float = 0.0,
        y: float = 0.0,
        heading: float = 0.0,
        input: VehicleInput | Mapping[str, float] | None = None,
    ) -> None:
        """Puts the car on its ground in equilibrium, at time 0: at a speed [m/s], a place [m] and a heading [rad].

        input   brakes and clutch as they are held. The input is then the one that keeps the car there.
        """
        self._car.start(
            number(speed, "speed"), number(x, "x"), number(y, "y"), number(heading, "heading"), input_of(input)
        )

    def advance(
        self,
        duration: float,
        input: VehicleInput | Mapping[str, float] | None = None,
        *,
        ramp: bool = False,
        **fields: float,
    ) -> None:
        """Advances the car by a duration [s].

        input, fields   what the driver does from now on: a VehicleInput, or its fields that change
        ramp            the input changes evenly over the duration; otherwise at once

        Raises SimulationError when the car breaks down.
        """
        if input is not None or fields:
            new = self._car.input() if input is None else input_of(input)
            for name, value in fields.items():
                if not hasattr(VehicleInput, name):
                    raise TypeError(f"advance() has no argument {name!r}, nor has VehicleInput such a field")
                setattr(new, name, number(value, name))
            self._car.set_input(new, bool(ramp))
        self._car.advance(number(duration, "duration"), bool(ramp))

    @property
    def input(self) -> VehicleInput:
        """A copy of the input that holds now. Assign to change it."""
        return self._car.input()

    @input.setter
    def input(self, value: VehicleInput | Mapping[str, float]) -> None:
        self._car.set_input(input_of(value), False)

    @property
    def time(self) -> float:
        """Time since start() [s]."""
        return self._car.time()

    def __getitem__(self, name: str) -> float:
        """An output by name, for example car["chassis.yaw_rate"]."""
        return self._car.output(name)

    @property
    def outputs(self) -> dict[str, float]:
        """All outputs by name."""
        return dict(zip(self.units, self._car.outputs().tolist()))

    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Centre of gravity [m] in the world, shape (3,)."""
        return self._car.position()

    @property
    def velocity(self) -> npt.NDArray[np.float64]:
        """Of the centre of gravity [m/s] in the world, shape (3,)."""
        return self._car.velocity()

    @property
    def angular_velocity(self) -> npt.NDArray[np.float64]:
        """Of the body [rad/s] in the world, shape (3,)."""
        return self._car.angular_velocity()

    @property
    def orientation(self) -> npt.NDArray[np.float64]:
        """Of the body: unit quaternion (w, x, y, z), shape (4,)."""
        return self._car.orientation()

    def snapshot(self) -> bytes:
        """All that the car remembers."""
        return self._car.snapshot()

    def restore(self, snapshot: bytes) -> None:
        """Goes back to a snapshot of the same car: from there it goes on to the last bit."""
        self._car.restore(snapshot)
