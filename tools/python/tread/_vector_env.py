"""Many cars at a time, in the shape of Gymnasium's vector interface."""

from __future__ import annotations

import math
from typing import Any, Callable, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _tread
from ._arguments import PathLike, Settings, path_text, settings_list
from ._errors import InputError
from ._spaces import Box
from ._vehicle import number

Array = npt.NDArray[Any]
Range = Union[float, "tuple[float, float]"]

_HALF_TURN = math.pi  # rad: of a steering wheel, to either side; a range of actions has to end somewhere [guess]
_STARTS = ("speed", "x", "y", "heading")


class VectorEnv:
    """Cars that do not meet, stepped together by threads in C++: for those who train controllers.

        env = tread.VectorEnv(64, "compact", start={"speed": (10, 30)}, reward=lambda obs, actions: -abs(obs[:, 2]))
        observations, infos = env.reset(seed=1)
        observations, rewards, terminations, truncations, infos = env.step(env.action_space.sample())

    num_envs      number of cars
    vehicle       YAML file, or the bare name of a car that tread brings along
    settings      {path: value} for all cars, or a list with one such dict for each car
    road          {path: value} of the road, for example {"friction": 0.4}
    actions       inputs by name (fields of tread.VehicleInput), or {name: (lowest, highest)}
    observations  outputs by name (tread.Vehicle.units)
    start         speed [m/s], x [m], y [m], heading [rad]: a number each, or (lowest, highest), from which each reset
                  draws
    dt            time of a step() [s]: a whole number of inner steps
    step          inner time step [s], at most 0.002
    reward        function(observations, actions) -> shape (num_envs,); zero unless given
    termination   function(observations) -> bool, shape (num_envs,); unless given, a car is done that lies on its side. One
                  whose motion is not finite is done in any case.
    time_limit    time after which an episode is truncated [s]
    autoreset     a car that is done is reset by the next step(), which ignores its action, as is usual in Gymnasium
                  (AutoresetMode.NEXT_STEP). Otherwise reset(options={"reset_mask": mask}) does it.
    threads       0: one per core. The results do not depend on it: each car does what it does alone, to the last bit.

    Arrays are of float64; observations have the shape (num_envs, len(observations)), actions (num_envs, len(actions)).
    """

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode = None
    spec = None

    def __init__(
        self,
        num_envs: int,
        vehicle: PathLike = "compact",
        *,
        settings: Settings | Sequence[Mapping[str, Any]] = None,
        road: Settings = None,
        actions: Sequence[str] | Mapping[str, tuple[float, float]] = ("steering_wheel_angle", "throttle", "brake"),
        observations: Sequence[str] = ("chassis.vx", "chassis.vy", "chassis.yaw_rate", "chassis.ay", "steering.angle"),
        start: Mapping[str, Range] | None = None,
        dt: float = 0.02,
        step: float = 0.001,
        reward: Callable[[Array, Array], Array] | None = None,
        termination: Callable[[Array], Array] | None = None,
        time_limit: float | None = None,
        autoreset: bool = True,
        threads: int = 0,
    ):
        if isinstance(num_envs, bool) or not isinstance(num_envs, (int, np.integer)) or num_envs < 1:
            raise InputError(f"num_envs: found {num_envs!r}, expected a whole number above 0")
        if isinstance(actions, str) or isinstance(observations, str):
            raise TypeError("actions, observations: found a str, expected a list of names")
        self.num_envs = int(num_envs)
        self._ranges = self._starts_of(start or {})
        self._steps = self._steps_of(number(dt, "dt"), number(step, "step"))
        self._dt = self._steps * step
        self._reward, self._termination = reward, termination
        self._limit = math.inf if time_limit is None else number(time_limit, "time_limit")
        self._autoreset = bool(autoreset)
        self._fleet: Any = _tread.Fleet(
            self.num_envs, path_text(vehicle, "vehicle"), self._settings_of(settings), settings_list(road), step,
            int(threads), list(observations), list(actions),
        )
        low, high = self._action_range(actions)
        count = (self.num_envs, 1)
        self.single_action_space = Box(low, high, dtype=np.float64)
        self.action_space = Box(np.tile(low, count), np.tile(high, count), dtype=np.float64)
        self.single_observation_space = Box(-np.inf, np.inf, (len(observations),), np.float64)
        self.observation_space = Box(-np.inf, np.inf, (self.num_envs, len(observations)), np.float64)
        self._low, self._high = low, high
        self._time = np.zeros(self.num_envs)
        self._done = np.zeros(self.num_envs, dtype=bool)
        self._random = [np.random.default_rng() for _ in range(self.num_envs)]
        self._started = False

    # ---- Gymnasium's interface ----

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """Puts cars at a start: (observations, infos).

        seed      of what the starts are drawn from: one for each car, or a number to which that of the car is added
        options   {"reset_mask": bool array of shape (num_envs,)}: only these cars; they all unless given
        """
        self._expect_open()
        which = np.ones(self.num_envs, dtype=bool)
        if options and "reset_mask" in options:
            which = np.asarray(options["reset_mask"])
            if which.shape != (self.num_envs,) or which.dtype != bool:
                raise InputError(
                    f"reset_mask: found {which.dtype} of shape {which.shape}, expected bool of shape ({self.num_envs},)"
                )
            if not self._started and not which.all():
                raise InputError("reset_mask: found cars that have not started, expected a reset of all of them first")
        if seed is not None:
            self._seed(seed, which)
        self._restart(which)
        self._started = True
        return self._fleet.observations(), self._infos()

    def step(self, actions: npt.ArrayLike) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """Advances all cars by dt: (observations, rewards, terminations, truncations, infos). infos["time"] is the time of
        each car since its start [s].

        actions   shape (num_envs, number of actions); what lies beyond the action space is at its limit
        """
        self._expect_open()
        if not self._started:
            raise InputError("found a step() before the first reset(), expected reset() first")
        given = self._actions_of(actions)
        restarted = self._done & self._autoreset
        self._fleet.step(given, self._steps)
        self._time += self._dt
        if restarted.any():
            self._restart(restarted)
        observations = self._fleet.observations()
        broken, rolled = self._fleet.lost()
        rewards = np.zeros(self.num_envs)
        if self._reward is not None:
            rewards = self._checked(self._reward(observations, given), "reward", np.float64)
        done = rolled
        if self._termination is not None:
            done = self._checked(self._termination(observations), "termination", bool)
        terminations = (done | broken) & ~restarted
        # Half a step: the sum of steps is not exact.
        truncations = (self._time > self._limit - 0.5 * self._dt) & ~terminations & ~restarted
        rewards[restarted] = 0.0
        self._done = terminations | truncations
        return observations, rewards, terminations, truncations, self._infos()

    def close(self) -> None:
        """Frees the cars."""
        self._fleet = None

    # ---- Besides ----

    def output(self, name: str) -> Array:
        """An output of all cars by name, also one that is not among the observations; shape (num_envs,)."""
        self._expect_open()
        return self._fleet.output(name)

    @property
    def unwrapped(self) -> VectorEnv:
        return self

    def __enter__(self) -> VectorEnv:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<tread.VectorEnv: {self.num_envs} cars, {'closed' if self._fleet is None else f'dt {self._dt:g} s'}>"

    # ---- Inside ----

    def _expect_open(self) -> None:
        if self._fleet is None:
            raise InputError("found a VectorEnv that is closed")

    def _infos(self) -> dict[str, Any]:
        return {"time": self._time.copy()}

    def _restart(self, which: Array) -> None:
        starts = np.zeros((self.num_envs, len(_STARTS)))
        for i in np.flatnonzero(which):
            starts[i] = [low if low == high else self._random[i].uniform(low, high) for low, high in self._ranges]
        self._fleet.reset(which, starts)
        self._time[which] = 0.0
        self._done[which] = False

    def _seed(self, seed: int | Sequence[int | None], which: Array) -> None:
        seeds = [seed + i for i in range(self.num_envs)] if isinstance(seed, (int, np.integer)) else list(seed)
        if len(seeds) != self.num_envs:
            raise InputError(f"seed: found {len(seeds)} seeds, expected one, or one for each of {self.num_envs} cars")
        for i, own in enumerate(seeds):
            if which[i] and own is not None:
                self._random[i] = np.random.default_rng(own)

    def _actions_of(self, actions: npt.ArrayLike) -> Array:
        given = np.asarray(actions)
        shape = (self.num_envs, len(self._low))
        if given.dtype.kind not in "iuf":
            raise TypeError(f"actions: found {given.dtype}, expected numbers")
        if given.shape != shape:
            raise InputError(f"actions: found the shape {given.shape}, expected {shape}")
        if not np.isfinite(given).all():
            car = int(np.flatnonzero(~np.isfinite(given).all(axis=1))[0])
            raise InputError(f"actions: found {given[car].tolist()} for car {car}, expected finite numbers")
        return np.ascontiguousarray(np.clip(given, self._low, self._high), dtype=np.float64)

    def _checked(self, value: Any, what: str, kind: Any) -> Array:
        array = np.asarray(value)
        if array.shape != (self.num_envs,):
            raise InputError(f"{what}: found the shape {array.shape}, expected ({self.num_envs},)")
        return array.astype(kind, copy=True)

    def _settings_of(self, settings: Any) -> list[list[str]]:
        several = isinstance(settings, (list, tuple)) and any(isinstance(one, Mapping) for one in settings)
        if not several:
            return [settings_list(settings)]
        if len(settings) != self.num_envs:
            raise InputError(f"settings: found {len(settings)} of them, expected one, or one for each of {self.num_envs} cars")
        return [settings_list(one) for one in settings]

    @staticmethod
    def _steps_of(dt: float, step: float) -> int:
        steps = round(dt / step) if step > 0 else 0
        if steps < 1 or abs(dt / step - steps) > 1e-6:
            raise InputError(f"dt: found {dt} s, expected a whole number of inner steps of {step} s")
        return steps

    @staticmethod
    def _starts_of(start: Mapping[str, Range]) -> list[tuple[float, float]]:
        for name in start:
            if name not in _STARTS:
                raise InputError(f"start: found {name!r}, expected one of {', '.join(_STARTS)}")
        ranges = []
        for name in _STARTS:
            value = start.get(name, 0.0)
            low, high = value if isinstance(value, (tuple, list)) else (value, value)
            low, high = number(low, f"start: {name}"), number(high, f"start: {name}")
            if low > high or (name == "speed" and low < 0):
                raise InputError(f"start: {name}: found {value!r}, expected a number or (lowest, highest)")
            ranges.append((low, high))
        return ranges

    @staticmethod
    def _action_range(actions: Sequence[str] | Mapping[str, tuple[float, float]]) -> tuple[Array, Array]:
        low, high = [], []
        for name, (_, lowest, highest) in zip(actions, _tread.input_limits(list(actions))):
            if isinstance(actions, Mapping):
                own = actions[name]
                lowest, highest = max(lowest, number(own[0], name)), min(highest, number(own[1], name))
            elif not math.isfinite(lowest + highest):
                if name != "steering_wheel_angle":
                    raise InputError(f"actions: {name}: found no limits, expected {{{name!r}: (lowest, highest)}}")
                lowest, highest = -_HALF_TURN, _HALF_TURN
            if not lowest <= highest:
                raise InputError(f"actions: {name}: found a lowest value above the highest")
            low.append(lowest)
            high.append(highest)
        return np.array(low, dtype=np.float64), np.array(high, dtype=np.float64)
