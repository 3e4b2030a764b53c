"""Spaces of actions and observations: those of Gymnasium where it is installed."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt


class _Box:
    """A box of numbers, with the names that gymnasium.spaces.Box has."""

    def __init__(self, low: Any, high: Any, shape: tuple[int, ...] | None = None, dtype: Any = np.float64):
        self.dtype = np.dtype(dtype)
        self.shape = tuple(shape) if shape is not None else np.broadcast_shapes(np.shape(low), np.shape(high))
        self.low = np.broadcast_to(np.asarray(low, self.dtype), self.shape).copy()
        self.high = np.broadcast_to(np.asarray(high, self.dtype), self.shape).copy()
        self._random = np.random.default_rng()

    def seed(self, seed: int | None = None) -> None:
        self._random = np.random.default_rng(seed)

    def sample(self) -> npt.NDArray[Any]:
        """Uniform where both ends are finite, else normal."""
        low, high = np.where(np.isfinite(self.low), self.low, 0), np.where(np.isfinite(self.high), self.high, 1)
        bounded = np.isfinite(self.low) & np.isfinite(self.high)
        uniform = self._random.uniform(low, np.maximum(high, low))
        return np.where(bounded, uniform, self._random.normal(size=self.shape)).astype(self.dtype)

    def contains(self, x: Any) -> bool:
        x = np.asarray(x)
        return x.shape == self.shape and bool(np.all(x >= self.low) and np.all(x <= self.high))

    def __contains__(self, x: Any) -> bool:
        return self.contains(x)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, _Box) and self.shape == other.shape and self.dtype == other.dtype
            and bool(np.array_equal(self.low, other.low) and np.array_equal(self.high, other.high))
        )

    def __repr__(self) -> str:
        return f"Box({self.low.min() if self.low.size else ''}, {self.high.max() if self.high.size else ''}, {self.shape}, {self.dtype})"


try:
    from gymnasium.spaces import Box
except ImportError:
    Box = _Box  # type: ignore[assignment,misc]
