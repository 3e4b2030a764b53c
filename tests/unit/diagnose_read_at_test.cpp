// Where the motion of a car with a load is read: at a place of the body, or at the centre of gravity that moved.

#include <gtest/gtest.h>

#include "recording/replay.h"
#include "shared/simple_car.h"

namespace tread::diagnose_read_at_test {
namespace {

TEST(ReadAt, TheCarIsReplayedWithItsLoadOrWithTheLoadAsPartOfIt) {
    simple_car::Case made = simple_car::recorded(15, 0.6, 1);
    const recording::RecordedDrive drive =
        recording::recordedDrive(made.file.recordings.front(), made.recorded.logs.front(), made.file);
    recording::Subject subject = made.nominal;
    subject.vehicle.load = {.mass = 200, .x = -1.2};
    VehicleParams driven;
    const recording::Replayer replayer{.nominal = made.nominal,
                                       .simulate = [&](const VehicleParams& car, const Scenario& scenario,
                                                       const Recorder& recorder, const Pushing& pushing) {
                                           driven = car;
                                           simple_car::drive(car, scenario, recorder, pushing);
                                       }};
    recording::replayed(drive, subject, replayer);
    EXPECT_NEAR(prepare(driven).reference_B.x(), 200 * 1.2 / (subject.vehicle.mass + 200), 1e-12)
        << "the place on the body is now before the centre of gravity";
    subject.instruments.read_at = recording::ReadAt::centre_of_gravity;
    recording::replayed(drive, subject, replayer);
    EXPECT_TRUE(prepare(driven).reference_B.isZero(0));
    EXPECT_EQ(driven.mass, subject.vehicle.mass + 200);
}

}  // namespace
}  // namespace tread::diagnose_read_at_test
