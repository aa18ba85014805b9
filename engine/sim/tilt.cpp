#include "engine/sim/tilt.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]
// [s] contacts settle within a few parts; FIRASim has parts of 3.2 ms
constexpr double kLongestPart = 0.0034;
constexpr double kLevelPitch = 0.003;  // [rad] about the pitch of a robot that speeds up
constexpr double kLevelRate = 0.1;     // [rad/s]
constexpr double kLeastSink = 1e-5;    // [m]
constexpr double kLeastRim = 1e-3;     // share of the robot's mass
// Supports touch the floor at one point, wheels at the two edges of each, the body's edges at two corners.
constexpr std::array<double, 5> kPoints{1.0, 4.0, 1.0, 2.0, 2.0};
// shares of the weight: all points sink alike
constexpr double kOnWheels = 4.0 / 6.0, kOnSupports = 2.0 / 6.0;

}  // namespace

Tilt::Tilt(const RobotModel& robot, double dt)
    : dt_(dt / std::max(1.0, std::ceil(dt / kLongestPart))),
      parts_(static_cast<int>(std::max(1.0, std::ceil(dt / kLongestPart)))),
      motor_(robot.motorPull() * dt_),
      drag_(robot.rolling_drag * dt_),
      grip_(robot.longitudinal_grip * dt_),
      turn_(robot.turnShare()),
      edges_(robot.wheel_width / robot.axle_track),
      scrub_(turn_ * edges_ / 2.0),
      most_braking_(robot.motorPull() * dt * 0.05),
      mass_height_(robot.mass_height),
      inertia_((robot.length * robot.length + 4.0 * mass_height_ * mass_height_) / 12.0),
      wheel_radius_(robot.wheel_radius),
      rim_mass_(std::max(robot.rim_mass / robot.mass, kLeastRim)),
      stiffness_(kGravity / (6.0 * std::max(robot.support_sink, kLeastSink))),
      damping_(stiffness_ * std::max(robot.support_settling, 2.0 * dt_)),  // springs bounce below that
      friction_(robot.friction),
      damped_{},
      place_{robot.support_distance, 0.0, -robot.support_distance, robot.length / 2, -robot.length / 2},
      clearance_(robot.ground_clearance),
      rise_(-robot.support_sink) {
  for (std::size_t i = 0; i < kContacts; ++i) damped_[i] = kPoints[i] * damping_ * dt_;
}

// Whether the robot brakes harder than its supports bear while it is level, which lifts its wheels.
bool Tilt::brakes(double forward, RimSpeeds pulls) const {
  const double pull = (pulls.left + pulls.right) / 2;
  return pull * forward < 0.0 && std::abs(pull) > most_braking_ && std::abs(forward) > std::abs(pull);
}

// Adds a contact to the sums (`sign` 1) or removes it (-1).
void Tilt::change(Footing& footing, std::size_t contact, double sign) const {
  const double damped = sign * damped_[contact], spring = sign * footing.springs[contact] * dt_;
  const double place = place_[contact];
  footing.touches[contact] = sign > 0.0;
  footing.lift += damped;
  footing.both -= damped * place;
  footing.swing += damped * place * place;
  footing.up += spring;
  footing.down -= spring * place;
}

Tilt::Footing Tilt::footing() const {
  Footing result;
  result.swing = inertia_;
  for (std::size_t i = 0; i < kContacts; ++i) {
    const double depth = place_[i] * pitch_ - rise_ - (i < 3 ? 0.0 : clearance_);
    result.springs[i] = kPoints[i] * stiffness_ * depth;
    if (depth > 0.0) change(result, i, 1.0);
  }
  return result;
}

// Loads at the end of the part, with the springs at the present pose and the dampers at the resulting speed.
// Contacts only push: those that would pull are removed.
Tilt::Standing Tilt::stand(Footing footing, Rates rates) const {
  Standing result;
  for (std::size_t round = 0; round < kContacts; ++round) {
    const double up = rates.rise + footing.up, down = inertia_ * rates.pitch + footing.down;
    const double scale = 1.0 / (footing.lift * footing.swing - footing.both * footing.both);
    result.rates = {(up * footing.swing - down * footing.both) * scale,
                    (down * footing.lift - up * footing.both) * scale};
    result.yield = footing.lift * scale;
    bool pulls = false;
    for (std::size_t i = 0; i < kContacts; ++i) {
      if (!footing.touches[i]) continue;
      const double speed = result.rates.rise - place_[i] * result.rates.pitch;
      result.loads[i] = footing.springs[i] - kPoints[i] * damping_ * speed;
      if (result.loads[i] >= 0.0) continue;
      result.loads[i] = 0.0;
      change(footing, i, -1.0);
      pulls = true;
    }
    if (!pulls) break;
  }
  return result;
}

// Like DriveLaw::resistedPulls, but at the floor, where pulls also pitch the body: `yield` is the floor's
// change of speed per pull.
Tilt::Pulls Tilt::pull(RimSpeeds ground, RimSpeeds target, const Grips& grips, double yield) const {
  constexpr int kRounds = 6;
  constexpr double kSettled = 1e-6;  // [m/s]
  const double forward = (ground.left + ground.right) / 2, turn = (ground.right - ground.left) / 2;
  const double play = edges_ * std::abs(turn), own = (yield + turn_) / 2, felt = (yield - turn_) / 2;
  // A rim that is faster than the floor also adds its own momentum.
  const double left_ahead = 2.0 * rim_mass_ * (rims_.left - ground.left);
  const double right_ahead = 2.0 * rim_mass_ * (rims_.right - ground.right), lag = 2.0 * rim_mass_ * play;
  const auto towards = [&](double rim, double aim, double ahead) {
    const double least = std::clamp(ahead + lag - motor_, -grips.drive, grips.drive);
    const double most = std::clamp(ahead - lag + motor_, -grips.drive, grips.drive);
    return std::clamp((std::clamp(rim, aim - play, aim + play) - rim) / own, least, most);
  };
  Pulls result;
  RimSpeeds& wheels = result.wheels;
  for (int round = 0; round < kRounds; ++round) {
    const Pulls before = result;
    const double left_over =
        std::max(2.0 * grips.drive - (std::abs(wheels.left) + std::abs(wheels.right)), 0.0);
    result.braked = -std::clamp(turn, -scrub_ * left_over, scrub_ * left_over);
    const double dragged = forward + yield * result.drag;
    wheels.left =
        towards(dragged - turn - result.braked + felt * before.wheels.right, target.left, left_ahead);
    wheels.right =
        towards(dragged + turn + result.braked + felt * before.wheels.left, target.right, right_ahead);
    const double moved = forward / yield + (wheels.left + wheels.right) / 2;
    result.drag = -std::clamp(moved, -grips.slide, grips.slide);
    const double settles = std::abs(wheels.left - before.wheels.left) +
                           std::abs(wheels.right - before.wheels.right) + std::abs(result.drag - before.drag);
    if (settles < kSettled) break;
  }
  return result;
}

// The rim of a slipping wheel moves freely; otherwise one edge of the wheel rolls. Returns the rim's change.
double Tilt::spunUp(double& rim, double ground, double target, double pull, double play, double grip) const {
  const double before = rim;
  if (std::abs(pull) >= grip) {
    const double motor = std::clamp(2.0 * rim_mass_ * (target - rim) + pull, -motor_, motor_);
    rim += (motor - pull) / (2.0 * rim_mass_);
  } else if (pull != 0.0) {
    rim = ground + std::copysign(play, pull);
  } else {
    rim = std::clamp(target, ground - play, ground + play);
  }
  return rim - before;
}

void Tilt::part(RimSpeeds& ground, RimSpeeds target, double& lateral) {
  const auto torque = [&](double rim, double aim) {  // of a motor, as a pull over the mass [m/s]
    return std::clamp(rim_mass_ * (aim - rim), -motor_ / 2, motor_ / 2);
  };
  const double react =
      wheel_radius_ / inertia_ * (torque(rims_.left, target.left) + torque(rims_.right, target.right));
  const Rates falling{rates_.rise - kGravity * dt_, rates_.pitch};
  const Footing footing = this->footing();
  // loads that limit friction
  const Loads loads = stand(footing, {falling.rise, falling.pitch - react}).loads;
  const Standing free = stand(footing, falling);
  const double on_wheels = loads[1] / (kGravity * kOnWheels);
  const Grips grips{grip_ * on_wheels, drag_ * (loads[0] + loads[2]) / (kGravity * kOnSupports) +
                                           friction_ * (loads[3] + loads[4]) * dt_};
  lateral += on_wheels;
  const double swing =
      free.rates.pitch * mass_height_;  // the floor moves past the wheels as the body pitches
  const RimSpeeds floor{ground.left - swing, ground.right - swing};
  const double yield = 1.0 + mass_height_ * mass_height_ * free.yield;
  const Pulls pulls = pull(floor, target, grips, yield);
  const RimSpeeds& wheels = pulls.wheels;
  const double play = edges_ * std::abs(ground.right - ground.left) / 2;
  const double spun = spunUp(rims_.left, floor.left, target.left, wheels.left, play, grips.drive) +
                      spunUp(rims_.right, floor.right, target.right, wheels.right, play, grips.drive);
  const double forward = (wheels.left + wheels.right) / 2 + pulls.drag;
  const double turn = turn_ * (wheels.right - wheels.left) / 2 + pulls.braked;
  ground.left += forward - turn;
  ground.right += forward + turn;
  const double pitched = (mass_height_ * forward + wheel_radius_ * rim_mass_ * spun) / inertia_;
  rates_ = stand(footing, {falling.rise, falling.pitch - pitched}).rates;
  rise_ += rates_.rise * dt_;
  pitch_ += rates_.pitch * dt_;
}

Tilt::Change Tilt::step(RimSpeeds ground, RimSpeeds target) {
  if (!tilted_) rims_ = ground;
  tilted_ = true;
  RimSpeeds after = ground;
  double lateral = 0.0;
  for (int i = 0; i < parts_; ++i) part(after, target, lateral);
  if (std::abs(pitch_) < kLevelPitch && std::abs(rates_.pitch) < kLevelRate) {
    tilted_ = false;
    pitch_ = 0.0;
    rates_ = {};
  }
  const double left = after.left - ground.left, right = after.right - ground.right;
  return {(left + right) / 2, (right - left) / 2, lateral / parts_};
}

}  // namespace fulbito
