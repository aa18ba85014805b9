#include "fulbito/navigation.hpp"
#include "navigation/followers/limiter.hpp"
#include "navigation/followers/preview_follower.hpp"
#include "navigation/followers/wall_escape.hpp"
#include "navigation/followers/wall_zones.hpp"

namespace fulbito {

struct Pilot::Impl {
  std::unique_ptr<Navigator> navigator;
  std::unique_ptr<Follower> follower;
  WallRule wall_rule = WallRule::kEscape;
  WallEscape escape;
  WallZones zones;
  Guidance guidance;
};

Pilot::Pilot(std::unique_ptr<Navigator> navigator, std::unique_ptr<Follower> follower, WallRule wall_rule)
    : impl_(std::make_unique<Impl>()) {
  impl_->navigator = std::move(navigator);
  impl_->follower = follower ? std::move(follower) : std::make_unique<PreviewFollower>();
  impl_->wall_rule = wall_rule;
}

Pilot::Pilot(Pilot&&) noexcept = default;
Pilot& Pilot::operator=(Pilot&&) noexcept = default;
Pilot::~Pilot() = default;

void Pilot::reset() {
  impl_->navigator->reset();
  impl_->follower->reset();
  impl_->escape.reset();
  impl_->zones.reset();
  impl_->guidance = {};
}

WheelSpeeds Pilot::drive(const NavigationScene& scene) {
  impl_->guidance = impl_->navigator->plan(scene);
  if (impl_->guidance.kind == GuidanceKind::kWheels) return saturate(*scene.robot, impl_->guidance.wheels);
  Twist wanted = impl_->follower->follow(impl_->guidance, scene);
  if (impl_->wall_rule == WallRule::kEscape) wanted = impl_->escape.apply(scene, wanted);
  if (impl_->wall_rule == WallRule::kZones) wanted = impl_->zones.apply(scene, wanted);
  const Twist limited = limitTwist(*scene.robot, bodyTwist(scene.self), wanted, scene.dt);
  return saturate(*scene.robot, inverseKinematics(*scene.robot, limited));
}

const Guidance& Pilot::guidance() const { return impl_->guidance; }

}  // namespace fulbito
