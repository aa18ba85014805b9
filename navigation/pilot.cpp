#include "navigation/pilot.hpp"

#include "navigation/followers/limiter.hpp"

namespace fulbito {

Pilot::Pilot(std::unique_ptr<Navigator> navigator, std::unique_ptr<Follower> follower, bool wall_escape)
    : navigator_(std::move(navigator)), follower_(std::move(follower)), wall_escape_(wall_escape) {}

void Pilot::reset() {
  navigator_->reset();
  follower_->reset();
  escape_.reset();
  guidance_ = {};
}

WheelSpeeds Pilot::drive(const NavigationScene& scene) {
  guidance_ = navigator_->plan(scene);
  if (guidance_.kind == GuidanceKind::kWheels) return saturate(*scene.robot, guidance_.wheels);
  Twist wanted = follower_->follow(guidance_, scene);
  if (wall_escape_) wanted = escape_.apply(scene, wanted);
  const Twist limited = limitTwist(*scene.robot, bodyTwist(scene.self), wanted, scene.dt);
  return saturate(*scene.robot, inverseKinematics(*scene.robot, limited));
}

}  // namespace fulbito
