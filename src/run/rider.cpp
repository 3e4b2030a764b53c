#include "run/rider.h"

#include <utility>

#include "base/math/turn.h"
#include "run/convoy.h"

namespace tread {
namespace {

Quaternion turnBy(const Vector3& rotation) {
    const double angle = rotation.norm();
    if (angle == 0) return Quaternion::Identity();
    return turnAbout(rotation / angle, angle);
}

}  // namespace

Rider::Rider(Vehicle vehicle, Road& road, const Equilibrium& start, double substep)
    : next(start.input),
      vehicle_(std::move(vehicle)),
      road_(road),
      motion_(start.motion),
      state_(start.state),
      input_(start.input) {
    substep_.limit(substep);
    Convoy* convoy = Convoy::ofThread();
    if (!convoy || !fitsInLane(vehicle_)) return;
    numbers_ = numbersOf(vehicle_);
    plane_ = planeOf(road);
    convoy->seat(*this);
}

Rider::~Rider() {
    if (convoy_) convoy_->leave(*this);
}

void Rider::setWind(const Vector3& velocity_W) {
    blown_ = blown_ || velocity_W != wind_W_;
    wind_W_ = velocity_W;
}

void Rider::move(double dt) {
    const StepInputs inputs(input_, next, substep_.within(dt));
    road_.beginStep();
    if (convoy_) convoy_->step(*this, inputs, dt);
    else moveAlone(inputs, dt);
    input_ = next;
}

void Rider::moveAlone(const StepInputs& inputs, double dt) {
    const Surroundings surroundings{road_, {0, 0, -kStandardGravity}, wind_W_};
    for (int k = 0; k < inputs.steps(); ++k) {
        advance(motion_, state_, vehicle_, inputs.after(k), inputs.after(k + 1), surroundings, dt / inputs.steps());
    }
}

void Rider::push(const Push& push_W, double dt) {
    const InertiaParams& i = vehicle_.params.inertia;
    const Quaternion& attitude = motion_.orientation;
    const Vector3 moment_B = attitude.conjugate() * push_W.moment;
    const Vector3 faster = dt / vehicle_.params.mass * push_W.force;
    const Vector3 spinning = attitude * (dt * moment_B.cwiseQuotient(Vector3(i.roll, i.pitch, i.yaw)));
    motion_.velocity_W += faster;
    motion_.position_W += dt * faster;
    motion_.angular_velocity_W += spinning;
    motion_.orientation = (turnBy(dt * spinning) * attitude).normalized();
    moved_ = true;
}

void Rider::put(const ChassisMotion& motion, const VehicleState& state) {
    motion_ = motion;
    state_ = state;
    moved_ = true;
}

const VehicleState& Rider::state() {
    if (!whole_) convoy_->fetch(*this);
    return state_;
}

}  // namespace tread
