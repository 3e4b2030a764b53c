"""64 cars at random speeds hold their lane, each with another gain; the best one is printed.

    vector_env.py [SECONDS]
"""

import sys

import numpy as np

import tread

seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 5.0
observed = ["chassis.y", "chassis.yaw", "chassis.vx"]


def reward(observations, actions):
    """Closeness to the middle of the lane, less what the driver works."""
    return -np.square(observations[:, 0]) - 0.01 * np.square(actions[:, 0])


with tread.VectorEnv(64, "compact", observations=observed, actions=["steering_wheel_angle"], reward=reward,
                     start={"speed": (20, 30), "y": (-1, 1)}) as env:
    gains = np.linspace(0.02, 1.0, env.num_envs)  # rad of steering wheel per m
    observations, _ = env.reset(seed=1)
    total = np.zeros(env.num_envs)
    for _ in range(round(seconds / 0.02)):
        y, yaw, vx = observations.T
        actions = -gains * (y + vx * yaw)  # where the car will be in a second
        observations, rewards, terminations, truncations, _ = env.step(actions[:, None])
        total += rewards
    best = int(total.argmax())
    print(f"best gain {gains[best]:.2f} rad/m, {abs(observations[best, 0]):.3f} m beside the middle after {seconds:g} s")
