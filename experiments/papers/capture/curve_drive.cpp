#include "experiments/papers/capture/curve_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "experiments/papers/capture/circle_fit.hpp"
#include "experiments/papers/capture/hall.hpp"
#include "fulbito/models.hpp"
#include "fulbito/world.hpp"

namespace fulbito::capture {
namespace {

constexpr Pose2 kStart{{0.0, 0.0}, math::kPi / 2};
constexpr double kLongest = 200.0;  // [s]

/// The stages of a drive.
enum class Stage : std::uint8_t { kFirst, kChange, kSecond, kDone };

/// The controller of a drive: it commands wheels by time and changes stages by pose.
class CurveDriver {
 public:
  explicit CurveDriver(const CurveDriveSetup& setup) : setup_(setup), curvature_(-1.0 / setup.radius) {}

  WheelSpeeds command(double time, double dt) {
    const double speed = setup_.from_rest ? std::min(setup_.acceleration * time, setup_.speed) : setup_.speed;
    full_speed_ = speed >= setup_.speed;
    if (stage_ == Stage::kChange) {
      // Each wheel changes by the acceleration in opposite directions, so their difference changes by twice
      // that.
      const double step = 2.0 * setup_.acceleration * dt / (setup_.robot.axle_track * setup_.speed);
      curvature_ =
          setup_.instant_change ? 1.0 / setup_.radius : std::min(curvature_ + step, 1.0 / setup_.radius);
      if (curvature_ == 1.0 / setup_.radius) stage_ = Stage::kSecond;
    }
    return inverseKinematics(setup_.robot, {speed, speed * curvature_});
  }

  void observe(const Pose2& before, const Pose2& now) {
    const Vec2 centre{setup_.radius, 0.0};
    const Vec2 ray = math::unit(math::kPi - setup_.turn);
    const Vec2 from = before.position - centre, to = now.position - centre;
    if (stage_ == Stage::kFirst && cross(ray, from) > 0.0 && cross(ray, to) <= 0.0 && dot(ray, to) > 0.0) {
      share_ = cross(ray, from) / (cross(ray, from) - cross(ray, to));
      stage_ = setup_.twice ? Stage::kChange : Stage::kDone;
    }
    const double left = math::wrapAngle(before.heading - kStart.heading);
    const double after = math::wrapAngle(now.heading - kStart.heading);
    if (stage_ == Stage::kSecond && left < 0.0 && after >= 0.0) {
      share_ = left / (left - after);
      stage_ = Stage::kDone;
    }
  }

  Stage stage() const { return stage_; }
  bool fullSpeed() const { return full_speed_; }
  double share() const { return share_; }  ///< share of the last tick that belongs to the drive

 private:
  const CurveDriveSetup& setup_;
  double curvature_;
  Stage stage_ = Stage::kFirst;
  bool full_speed_ = false;
  double share_ = 1.0;
};

/// Places of each curve at full speed, for the fit of circles.
using CurvePlaces = std::array<std::vector<Vec2>, 2>;

void keep(const CurveDriver& driver, Vec2 place, CurvePlaces& places) {
  if (!driver.fullSpeed()) return;
  if (driver.stage() == Stage::kFirst) places[0].push_back(place);
  if (driver.stage() == Stage::kSecond) places[1].push_back(place);
}

Result<World> worldOf(const CurveDriveSetup& setup) {
  WorldConfig config;
  config.field = hall();
  config.physics = hallPhysics();
  config.robots = {placed(setup.robot, kStart, setup.from_rest ? 0.0 : setup.speed)};
  return World::create(config);
}

CurveDriveResult measured(const CurveDriveSetup& setup, const CurveDriver& driver, double dt,
                          std::vector<Pose2> trace, const CurvePlaces& places) {
  CurveDriveResult result;
  result.radius1 = fitCircle(places[0]).radius;
  if (setup.twice) result.radius2 = fitCircle(places[1]).radius;
  const std::size_t last = trace.size() - 1;
  for (std::size_t i = 1; i <= last; ++i) {
    result.distance +=
        (i == last ? driver.share() : 1.0) * distance(trace[i - 1].position, trace[i].position);
  }
  result.time = (static_cast<double>(last) - 1.0 + driver.share()) * dt;
  const Vec2 end = trace[last - 1].position * (1.0 - driver.share()) + trace[last].position * driver.share();
  result.end_error = distance(end, idealEnd(setup));
  result.trace = std::move(trace);
  return result;
}

}  // namespace

Vec2 idealEnd(const CurveDriveSetup& setup) {
  const math::SinCos turn = math::sinCos(setup.turn);
  return Vec2{setup.radius * (1.0 - turn.cos), setup.radius * turn.sin} * (setup.twice ? 2.0 : 1.0);
}

Result<CurveDriveResult> driveCurve(const CurveDriveSetup& setup) {
  auto world = worldOf(setup);
  if (!world) return tl::unexpected<Error>(world.error());
  const double dt = hallPhysics().controlPeriod();
  CurveDriver driver(setup);
  CurvePlaces places;
  std::vector<Pose2> trace{kStart};
  while (driver.stage() != Stage::kDone) {
    const double time = static_cast<double>(trace.size()) * dt;
    if (time > kLongest) return fail(ErrorCode::kUsage, "capture: a curve does not end within 200 s");
    const WheelSpeeds command = driver.command(time, dt);
    world->step({&command, 1});
    trace.push_back(world->state().robots[0].pose);
    keep(driver, trace.back().position, places);
    driver.observe(trace[trace.size() - 2], trace.back());
  }
  return measured(setup, driver, dt, std::move(trace), places);
}

}  // namespace fulbito::capture
