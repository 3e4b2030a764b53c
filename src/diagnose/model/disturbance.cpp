#include "diagnose/model/disturbance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/threads/parallel.h"
#include "diagnose/model/sensitivities.h"
#include "diagnose/settings.h"
#include "inference/ornstein_uhlenbeck.h"
#include "log/resample.h"
#include "run/together.h"
#include "tread/tyre.h"

namespace tread::diagnose::model {
namespace {

constexpr double kHat = kSettings.correlation_time / 2;        // s, distance of the closest hats
constexpr double kErrorHat = kSettings.error_correlation / 2;  // s, the same of the errors of the model's forces
constexpr double kDriftHat = kSettings.drift_correlation / 2;  // s, the same of the errors of the readings
constexpr double kForgotten = 3;  // s, after which a car is taken to have forgotten a push except for the speed it lost
constexpr double kLeastSlope = 0.1;  // least share of the front tyres' cornering stiffness, left at the limit of grip
// Least share of a change of start speed that must be left to infer lost speed from it; less is numerical noise.
constexpr double kLeastKept = 0.02;
// Lateral slip velocity over forward speed at which the cornering stiffness is taken, within the linear range.
constexpr double kSlipVelocity = 0.005;
// Least denominator of the axle's slope with compliance steer: limits the slope to 20 times that of the tyres.
constexpr double kLightest = 0.05;

double hat(double t, double peak, double width) {
    return std::max(0.0, 1 - std::abs(t - peak) / width);
}

// Hats from one push to the next of the same replay. Each more costs one more replay per kind and drive.
Eigen::Index hatsBetween(const Hats& hats) {
    return std::lround(kForgotten / hats.apart);
}

// Pushes shaped like hat `first` and those every kForgotten after it.
Pushing pushes(const VehicleParams& car, Disturbed kind, const Hats& hats, Eigen::Index first) {
    const double usual = usualSize(kind, car), begins = hats.peak(first), apart = hats.apart;
    return PushingOverTime{[=](double time) {
        const double since = time - begins;
        const double near = std::max(0.0, std::round(since / kForgotten)) * kForgotten;
        const double size = hat(since, near, apart);
        switch (kind) {
            case Disturbed::longitudinal:
                return Push{.force = {size * usual, 0, 0}};
            case Disturbed::lateral:
                return Push{.force = {0, size * usual, 0}};
            case Disturbed::yaw:
                return Push{.moment = {0, 0, size * usual}};
            default:
                return Push{.moment = {size * usual, 0, 0}};
        }
    }};
}

// A drive as replayed without disturbances, about which it is linearised.
struct Course {
    const RecordedDrive& drive;
    Base base;
    Eigen::VectorXd by_start_speed;
    HatsOfKinds hats;
    const recording::ObservedChannel* speed = nullptr;  // a channel that shows the speed; null if there is none

    const Hats& of(Disturbed kind) const { return hats[placeOf(kind)]; }
    const std::vector<double>& time() const { return base.motion->channels.front().values; }
};

const recording::ObservedChannel* showsSpeed(const RecordedDrive& drive) {
    const auto shows = [](const recording::ObservedChannel& channel) {
        return !channel.times.empty() && (channel.name == "chassis.vx" || channel.name.ends_with(".spin"));
    };
    const auto found = std::find_if(drive.channels.begin(), drive.channels.end(), shows);
    return found == drive.channels.end() ? nullptr : &*found;
}

// Change of the start speed, m/s, that leaves the car as slow as a push that is over. `change`: change of the rows by
// the push. `over`: time, s, at which the push counts as forgotten.
double speedLost(const Course& course, const Eigen::VectorXd& change, double over) {
    if (!course.speed) return 0;
    const std::vector<double>& times = course.speed->times;
    const auto before = std::lower_bound(times.begin(), times.end(), over) - times.begin() - 1;
    const Eigen::Index first = course.speed->first_row, row = first + std::max<Eigen::Index>(before, 0);
    const double kept = course.by_start_speed(row);
    return kept > kLeastKept * course.by_start_speed(first) ? change(row) / kept : 0;
}

// A replay with pushes of one kind.
struct PushedReplay {
    std::size_t drive;
    Disturbed kind;
    Eigen::Index first;           // hat
    Eigen::VectorXd change = {};  // of the rows; empty when the simulation fails
};

constexpr std::array kPushed{Disturbed::longitudinal, Disturbed::lateral, Disturbed::yaw, Disturbed::roll};

// Those of each drive in turn, kind by kind.
std::vector<PushedReplay> pushedReplays(const Replays& replays, const std::vector<Course>& courses) {
    std::vector<PushedReplay> all;
    for (std::size_t d = 0; d < courses.size(); ++d) {
        if (!courses[d].base.motion) continue;
        for (const Disturbed kind : kPushed) {
            const Hats& hats = courses[d].of(kind);
            for (Eigen::Index first = 0; first < std::min(hatsBetween(hats), hats.count()); ++first)
                all.push_back({d, kind, first});
        }
    }
    drivenTogether(all.size(), replays.threads, [&](std::size_t i) {
        PushedReplay& one = all[i];
        const Course& course = courses[one.drive];
        const Subject& subject = course.base.subject;
        const std::optional<Log> motion =
            motionAt(replays, course.drive, subject,
                     {.pushing = pushes(subject.vehicle, one.kind, course.of(one.kind), one.first),
                      .coarse = course.base.coarse});
        if (motion) one.change = recording::readings(course.drive, *motion, subject.instruments) - course.base.rows;
    });
    return all;
}

// Change of the rows by a push of one kind at each hat; one column per hat. A replay contains a push every kForgotten:
// by the time the next one comes, a push is forgotten except for the speed it has cost, which goes on as a change of
// the start speed. `all`: replays of all drives.
Eigen::MatrixXd pushed(const std::vector<PushedReplay>& all, std::size_t drive, const Course& course, Disturbed kind) {
    const Hats& hats = course.of(kind);
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(course.drive.rows(), hats.count());
    for (const PushedReplay& replay : all) {
        if (replay.drive != drive || replay.kind != kind || replay.change.size() == 0) continue;
        Eigen::VectorXd change = replay.change;
        for (Eigen::Index which = replay.first; which < hats.count(); which += hatsBetween(hats)) {
            const double begins = hats.peak(which) - hats.apart, over = begins + kForgotten;
            auto column = columns.col(which);
            const double slower = speedLost(course, change, over);
            for (const recording::ObservedChannel& channel : course.drive.channels) {
                for (Eigen::Index i = 0; i < channel.rows(); ++i) {
                    const Eigen::Index row = channel.first_row + i;
                    if (channel.times[i] < begins) continue;
                    column(row) = channel.times[i] < over ? change(row) : slower * course.by_start_speed(row);
                }
            }
            change -= column;
        }
    }
    return columns;
}

// Front axle at static load: cornering stiffness of both tyres, N/rad, and lateral acceleration at the limit of grip,
// m/s2.
struct FrontAxle {
    double slope = 0, grip = 0;
};

FrontAxle frontAxle(const VehicleParams& car) {
    const double rear = car.wheelbase - car.front_axle_distance;
    const double load = car.mass * kStandardGravity * rear / (2 * car.wheelbase);
    const TyreSteadyState at =
        steadyState(car.front.tyre, {.Fz = load, .gamma = 0, .Vx = 1, .Vsx = 0, .Vsy = kSlipVelocity});
    const double slope = std::abs(at.Fy) / kSlipVelocity;
    const double compliant = 1 - slope * car.front.suspension.steer_by_lateral_force;
    return {2 * slope / std::max(kLightest, compliant), kStandardGravity * at.muy};
}

// Size of an error of the model's force at each hat, in usual sizes of the disturbance of its kind: in proportion to
// the acceleration of the car (D11a).
Eigen::VectorXd errorSizes(const Course& course, const VehicleParams& car, Disturbed kind) {
    const std::vector<double>& time = course.time();
    const Channel* acceleration =
        course.base.motion->find(kind == Disturbed::longitudinal ? "chassis.ax" : "chassis.ay");
    const double lever = kind == Disturbed::yaw
                             ? car.front_axle_distance * (1 - car.front_axle_distance / car.wheelbase)
                         : kind == Disturbed::roll ? car.centre_of_gravity_height
                                                   : 1;
    const Hats& hats = course.of(kind);
    Eigen::VectorXd sizes = Eigen::VectorXd::Zero(hats.count());
    for (Eigen::Index i = 0; acceleration && i < hats.count(); ++i) {
        const double at = std::min(hats.peak(i), time.back());
        const double force = car.mass * std::abs(valueAt(time, acceleration->values, at));
        sizes(i) = kSettings.force_error * force * lever / usualSize(kind, car);
    }
    return sizes;
}

// Heights of the hats by errors of the model's force, for impulses of a slower process of unit variance: hats x
// impulses.
Eigen::MatrixXd errorHeights(const Course& course, const VehicleParams& car, Disturbed kind) {
    const Eigen::VectorXd sizes = errorSizes(course, car, kind);
    const Hats& hats = course.of(kind);
    const Eigen::Index slow = std::lround(std::ceil(hats.peak(hats.count() - 1) / kErrorHat)) + 1;
    Eigen::MatrixXd between = Eigen::MatrixXd::Zero(hats.count(), slow);
    for (Eigen::Index i = 0; i < hats.count(); ++i) {
        const double place = hats.peak(i) / kErrorHat;
        const Eigen::Index before = std::min<Eigen::Index>(std::lround(std::floor(place)), slow - 2);
        const double after = place - static_cast<double>(before);
        between(i, before) = sizes(i) * (1 - after);
        between(i, before + 1) = sizes(i) * after;
    }
    return between * inference::correlationFactor(slow, kErrorHat, kSettings.error_correlation);
}

// Values of wider hats at the peaks of closer ones: closer x wider.
Eigen::MatrixXd valuesAt(const Hats& closer, const Hats& wider) {
    Eigen::MatrixXd values(closer.count(), wider.count());
    for (Eigen::Index i = 0; i < closer.count(); ++i)
        for (Eigen::Index k = 0; k < wider.count(); ++k) values(i, k) = hat(closer.peak(i), wider.peak(k), wider.apart);
    return values;
}

// Steering tremor as a side force at the front axle. Its stiffness falls with the square of the lateral acceleration as
// the turn uses up the grip (D14).
Eigen::MatrixXd trembling(const Course& course, const VehicleParams& car, const Eigen::MatrixXd& lateral,
                          const Eigen::MatrixXd& yaw) {
    const FrontAxle axle = frontAxle(car);
    const std::vector<double>& time = course.time();
    const Channel* ay = course.base.motion->find("chassis.ay");
    const Hats& hats = course.of(Disturbed::lateral);
    Eigen::MatrixXd columns(lateral.rows(), lateral.cols());
    for (Eigen::Index i = 0; i < lateral.cols(); ++i) {
        const double t = std::min(hats.peak(i), time.back());
        const double used = ay ? valueAt(time, ay->values, t) / axle.grip : 0;
        const double force = std::max(kLeastSlope, 1 - used * used) * axle.slope * kSettings.steering;
        columns.col(i) = force / usualSize(Disturbed::lateral, car) * lateral.col(i) +
                         force * car.front_axle_distance / usualSize(Disturbed::yaw, car) * yaw.col(i);
    }
    return columns * valuesAt(hats, course.of(Disturbed::steering));
}

// Change of the rows by the drift of one channel: rows x impulses (D11b).
Eigen::MatrixXd drifting(const RecordedDrive& drive, const recording::ObservedChannel& channel,
                         const VehicleParams& car) {
    const Eigen::Index hats = std::lround(std::ceil(drive.duration() / kDriftHat)) + 1;
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(drive.rows(), hats);
    for (Eigen::Index i = 0; i < channel.rows(); ++i)
        for (Eigen::Index h = 0; h < hats; ++h)
            columns(channel.first_row + i, h) = hat(channel.times[i], static_cast<double>(h) * kDriftHat, kDriftHat);
    return usualSize(readingErrorsOf(channel.name).drift, car) * columns *
           inference::correlationFactor(hats, kDriftHat, kSettings.drift_correlation);
}

// Change of the rows by an error of the scale of one channel in this drive (D11c).
Eigen::VectorXd misscaled(const Course& course, const recording::ObservedChannel& channel) {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(course.drive.rows());
    const auto rows = Eigen::seqN(channel.first_row, channel.rows());
    column(rows) = kSettings.scale_error * course.base.rows(rows);
    return column;
}

// Change of the rows by an error of the timing of one channel in this drive: readings that come later (D11c).
Eigen::VectorXd mistimed(const Course& course, const recording::ObservedChannel& channel) {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(course.drive.rows());
    if (channel.rows() < 2) return column;
    const Eigen::Index last = channel.rows() - 1;
    for (Eigen::Index i = 0; i <= last; ++i) {
        const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0), after = std::min(i + 1, last);
        const double change =
            course.base.rows(channel.first_row + after) - course.base.rows(channel.first_row + before);
        column(channel.first_row + i) =
            -kSettings.timing_error * change / (channel.times[after] - channel.times[before]);
    }
    return column;
}

// Adds the columns of errors of one kind, whose hats are `apart`, s; 0 for an error of the whole drive.
void append(Disturbances& result, Disturbed kind, const Eigen::MatrixXd& errors, double apart) {
    const Eigen::Index more = errors.cols();
    result.columns.conservativeResize(Eigen::NoChange, result.columns.cols() + more);
    result.columns.rightCols(more) = errors;
    for (Eigen::Index i = 0; i < more; ++i) {
        result.kinds.push_back(kind);
        result.times.push_back(static_cast<double>(i) * apart);
    }
}

Course courseOf(const Replays& replays, const RecordedDrive& drive, const Subject& subject, Resolution resolution) {
    Course course{.drive = drive,
                  .base = baseOf(replays, drive, subject),
                  .by_start_speed = Eigen::VectorXd::Zero(drive.rows()),
                  .hats = hatsOver(drive.duration(), resolution),
                  .speed = showsSpeed(drive)};
    if (course.base.motion) course.by_start_speed = startSpeedColumn(replays, drive, course.base);
    return course;
}

// Disturbances that change nothing but by the start speed.
Disturbances bare(const Course& course) {
    Disturbances result{.columns = {}, .kinds = {}, .times = {}, .hats = course.hats};
    for (const Disturbed kind : kDisturbedKinds) {
        for (Eigen::Index i = 0; i < result.of(kind).count(); ++i) {
            result.kinds.push_back(kind);
            result.times.push_back(result.of(kind).peak(i));
        }
    }
    result.columns = Eigen::MatrixXd::Zero(course.drive.rows(), result.random());
    result.by_start_speed = course.by_start_speed;
    return result;
}

void fill(Disturbances& result, const std::vector<PushedReplay>& replays, std::size_t drive, const Course& course) {
    const VehicleParams& car = course.base.subject.vehicle;
    std::vector<Eigen::MatrixXd> forces, errors;  // by each hat; by each impulse of an error
    for (const Disturbed kind : kPushed) {
        forces.push_back(pushed(replays, drive, course, kind));
        errors.emplace_back(forces.back() * errorHeights(course, car, kind));
    }
    forces.push_back(trembling(course, car, forces[placeOf(Disturbed::lateral)], forces[placeOf(Disturbed::yaw)]));
    for (std::size_t k = 0; k < forces.size(); ++k)
        result.columns.middleCols(course.hats[k].first, course.hats[k].count()) =
            forces[k] * course.hats[k].correlation_factor;
    for (std::size_t k = 0; k < errors.size(); ++k) append(result, kForceErrors[k], errors[k], kErrorHat);
    for (const recording::ObservedChannel& channel : course.drive.channels) {
        const ReadingErrors its = readingErrorsOf(channel.name);
        append(result, its.drift, drifting(course.drive, channel, car), kDriftHat);
        if (its.scale) append(result, *its.scale, misscaled(course, channel), 0);
        append(result, its.timing, mistimed(course, channel), 0);
    }
}

}  // namespace

HatsOfKinds hatsOver(double duration, Resolution resolution) {
    HatsOfKinds all;
    Eigen::Index first = 0;
    for (const Disturbed kind : kDisturbedKinds) {
        const bool close = kind != Disturbed::longitudinal && kind != Disturbed::steering;
        Hats& hats = all[placeOf(kind)];
        hats.apart = close && resolution == Resolution::fine ? kHat : 2 * kHat;
        hats.first = first;
        hats.correlation_factor = inference::correlationFactor(std::lround(std::ceil(duration / hats.apart)) + 1,
                                                               hats.apart, kSettings.correlation_time);
        first = hats.end();
    }
    return all;
}

ReadingErrors readingErrorsOf(std::string_view channel) {
    using enum Disturbed;
    const auto contains = [&](const char* part) { return channel.find(part) != std::string_view::npos; };
    if (contains("_rate")) return {rate_reading, rate_timing, rate_scale};
    if (contains(".spin")) return {wheel_speed_reading, wheel_speed_timing};
    if (contains(".ax") || contains(".ay")) return {acceleration_reading, acceleration_timing, acceleration_scale};
    if (contains(".vx") || contains(".vy")) return {speed_reading, speed_timing};
    return {angle_reading, angle_timing, angle_scale};
}

double usualSize(Disturbed kind, const VehicleParams& car) {
    switch (kind) {
        case Disturbed::longitudinal:
        case Disturbed::longitudinal_error:
            return kSettings.longitudinal * car.mass;
        case Disturbed::lateral:
        case Disturbed::lateral_error:
            return kSettings.lateral * car.mass;
        case Disturbed::yaw:
        case Disturbed::yaw_error:
            return kSettings.yaw / car.wheelbase * car.inertia.yaw;
        case Disturbed::roll:
        case Disturbed::roll_error:
            return kSettings.roll / car.wheelbase * car.inertia.roll;
        case Disturbed::steering:
            return kSettings.steering;
        case Disturbed::rate_reading:
            return kSettings.rate_drift;
        case Disturbed::acceleration_reading:
            return kSettings.acceleration_drift;
        case Disturbed::angle_reading:
            return kSettings.angle_drift;
        case Disturbed::speed_reading:
            return kSettings.speed_drift;
        case Disturbed::wheel_speed_reading:
            return kSettings.speed_drift / car.front.tyre.parameters.Re;
        case Disturbed::rate_scale:
        case Disturbed::acceleration_scale:
        case Disturbed::angle_scale:
            return kSettings.scale_error;
        case Disturbed::rate_timing:
        case Disturbed::acceleration_timing:
        case Disturbed::angle_timing:
        case Disturbed::speed_timing:
        case Disturbed::wheel_speed_timing:
            return kSettings.timing_error;
    }
    return 0;
}

Eigen::VectorXd Disturbances::heights(const Eigen::VectorXd& impulses) const {
    Eigen::VectorXd all(random());
    for (const Hats& one : hats)
        all.segment(one.first, one.count()) = one.correlation_factor * impulses.segment(one.first, one.count());
    return all;
}

Disturbances disturbances(const Replays& replays, const RecordedDrive& drive, const Subject& subject,
                          Resolution resolution) {
    return std::move(disturbances(replays, {&drive}, {subject}, resolution).front());
}

std::vector<Disturbances> disturbances(const Replays& replays, const std::vector<const RecordedDrive*>& drives,
                                       const std::vector<Subject>& subjects, Resolution resolution) {
    std::vector<std::optional<Course>> driven(drives.size());
    drivenTogether(drives.size(), replays.threads,
                   [&](std::size_t d) { driven[d].emplace(courseOf(replays, *drives[d], subjects[d], resolution)); });
    std::vector<Course> courses;
    for (std::optional<Course>& course : driven) courses.push_back(std::move(*course));
    const std::vector<PushedReplay> pushes = pushedReplays(replays, courses);
    std::vector<Disturbances> all(drives.size());
    inParallel(drives.size(), replays.threads, [&](std::size_t d) {
        all[d] = bare(courses[d]);
        if (courses[d].base.motion) fill(all[d], pushes, d, courses[d]);
    });
    return all;
}

}  // namespace tread::diagnose::model
