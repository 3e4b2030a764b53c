#include "run/mover.h"

#include "bullet/convert.h"
#include "run/rider.h"
#include "run/world.h"
#include "tread/bullet_vehicle.h"

namespace tread {
namespace {

class InBulletWorld final : public Mover {
public:
    InBulletWorld(const VehicleParams& params, Road& road, const Equilibrium& start, double substep)
        : world_(params), car_(params, world_.chassis(), road) {
        car_.setSubstep(substep);
        car_.restore(start.motion, start.state, start.input);
    }

    void setInput(const VehicleInput& input) override { car_.setInput(input); }
    void setWind(const Vector3& velocity_W) override { car_.setWind(velocity_W); }

    void move(double dt, const std::optional<Push>& push_W) override {
        car_.plan(dt);
        if (push_W) {
            world_.chassis().applyCentralForce(toBullet(push_W->force));
            world_.chassis().applyTorque(toBullet(push_W->moment));
        }
        world_.step(dt);
        car_.observe();
    }

    const Vehicle& vehicle() const override { return car_.vehicle(); }
    const ChassisMotion& motion() const override { return car_.motion(); }
    const VehicleState& state() override { return car_.state(); }
    const VehicleState& stateAtGlance() override { return car_.state(); }

private:
    World world_;
    BulletVehicle car_;
};

class ByItself final : public Mover {
public:
    ByItself(const VehicleParams& params, Road& road, const Equilibrium& start, double substep)
        : rider_(prepare(params), road, start, substep) {}

    void setInput(const VehicleInput& input) override { rider_.next = input; }
    void setWind(const Vector3& velocity_W) override { rider_.setWind(velocity_W); }
    void move(double dt, const std::optional<Push>& push_W) override {
        rider_.move(dt);
        if (push_W) rider_.push(*push_W, dt);
    }

    const Vehicle& vehicle() const override { return rider_.vehicle(); }
    const ChassisMotion& motion() const override { return rider_.motion(); }
    const VehicleState& state() override { return rider_.state(); }
    const VehicleState& stateAtGlance() override { return rider_.stateAtGlance(); }

private:
    Rider rider_;
};

// A car that settles beside others of its thread.
class SettlingTogether final : public Settling {
public:
    SettlingTogether(const Vehicle& vehicle, Road& road, const Vector3& wind_W)
        : rider_(vehicle, road, {}, Substep::kLongest) {
        rider_.setWind(wind_W);
    }

    void advance(ChassisMotion& motion, VehicleState& state, const VehicleInput& input, double dt) override {
        rider_.put(motion, state);
        rider_.hold(input);
        rider_.move(dt);
        motion = rider_.motion();
        state = rider_.stateAtGlance();
    }
    void complete(VehicleState& state) override { state = rider_.state(); }

private:
    Rider rider_;
};

}  // namespace

Settled settledBy(MovedBy by, const Vehicle& vehicle, Road& road, const Vector3& wind_W, const Start& start,
                  const Settled* from) {
    const Surroundings surroundings{road, kGravityOfRuns_W, wind_W};
    if (by == MovedBy::bullet) return settle(vehicle, surroundings, start, from);
    return settle(vehicle, surroundings, start, from,
                  [&](const Vehicle& settled) { return std::make_unique<SettlingTogether>(settled, road, wind_W); });
}

std::unique_ptr<Mover> mover(MovedBy by, const VehicleParams& params, Road& road, const Equilibrium& start,
                             double substep) {
    if (by == MovedBy::bullet) return std::make_unique<InBulletWorld>(params, road, start, substep);
    return std::make_unique<ByItself>(params, road, start, substep);
}

}  // namespace tread
