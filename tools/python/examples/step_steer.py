"""A step steer of two cars, and what the standard asks of it.

    step_steer.py [PICTURE]     with a picture (PNG, SVG, PDF): needs matplotlib
"""

import sys

import numpy as np

import tread

logs = [
    tread.run("compact", "step_steer_80"),
    tread.run("compact", "step_steer_80", {"load.mass": 200, "load.x": -1.2}),  # 200 kg in the boot
]
for log in logs:
    print(log.answer)
empty, loaded = (log.metrics for log in logs)
for name in ("yaw_rate_response_time", "yaw_rate_overshoot", "yaw_rate_gain", "roll_gradient"):
    metric = empty.metric(name)
    print(f"{metric.title:<32} {metric.value:8.4g} -> {loaded[name]:8.4g} {metric.unit}")

if len(sys.argv) > 1:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(2, sharex=True, figsize=(7, 5), layout="constrained")
    for log, label in zip(logs, ("driver only", "200 kg in the boot")):
        axes[0].plot(log.time, np.degrees(log["chassis.yaw_rate"]), label=label)
        axes[1].plot(log.time, log["chassis.ay"], label=label)
    axes[0].set(ylabel="yaw rate [deg/s]", title=logs[0].name)
    axes[1].set(ylabel="lateral acceleration [m/s²]", xlabel="time [s]")
    for axis in axes:
        axis.grid(alpha=0.3)
        axis.legend(loc="lower right")
    figure.savefig(sys.argv[1], dpi=110)
    print("picture:", sys.argv[1])
