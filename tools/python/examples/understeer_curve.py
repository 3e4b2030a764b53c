"""Understeer curves of three cars: by how much the front axle slips more than the rear axle, over the lateral
acceleration. In a steady turn that is the steer angle beyond the one of slow driving.

    understeer_curve.py [PICTURE]     with a picture (PNG, SVG, PDF): needs matplotlib
"""

import sys

import numpy as np

import tread


def slip(log, axle):
    """Mean slip angle of an axle [rad], positive for a force to the left."""
    return -0.5 * (log[f"wheel.{axle}_left.slip_angle"] + log[f"wheel.{axle}_right.slip_angle"])


curves = {}
for car in ("compact", "rear_drive_sedan", "sports_car"):
    log = tread.run(car, "slowly_increasing_steer")
    rising = slice(0, int(np.argmax(log["chassis.ay"])))  # up to the limit
    ay = log["chassis.ay"][rising]
    understeer = np.degrees(slip(log, "front") - slip(log, "rear"))[rising]
    linear = ay < 4  # m/s2
    gradient = np.polyfit(ay[linear], understeer[linear], 1)[0]
    curves[car] = ay, understeer
    print(f"{car:<17} understeer {gradient:6.3f} deg per m/s2 below 4 m/s2, {ay.max():5.2f} m/s2 at most")

if len(sys.argv) > 1:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axis = pyplot.subplots(figsize=(7, 4.5), layout="constrained")
    for car, (ay, understeer) in curves.items():
        axis.plot(ay, understeer, label=car.replace("_", " "))
    axis.set(xlabel="lateral acceleration [m/s²]", ylabel="understeer angle [deg]", title="Slowly increasing steer")
    axis.grid(alpha=0.3)
    axis.legend()
    figure.savefig(sys.argv[1], dpi=110)
    print("picture:", sys.argv[1])
