// A navigator that was trained on fulbito/Navigate-v0 by examples/python/train_navigator.py, as a shared
// library:
//   cmake --build --preset release --target learnt_navigator
//   fulbito compare --suite corner --navigators bezier build/release/learnt.so:learnt
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "fulbito/detail/math.hpp"
#include "fulbito/team.hpp"
#include "python/environments/navigation/sight.hpp"

namespace {

namespace core = fulbito;
using namespace fulbito::team;

constexpr float kWeights[] = {
#include "python/environments/navigation/learnt/weights.inc"
};
constexpr std::size_t kSeen = 69, kHidden = 48, kOutputs = 2;
static_assert(std::size(kWeights) ==
              kSeen * kHidden + kHidden + kHidden * kHidden + kHidden + kHidden * kOutputs + kOutputs);

/// One dense layer. `next` points to its weights, then to those of the next layer.
template <std::size_t kIn, std::size_t kOut>
std::array<float, kOut> layer(std::span<const float, kIn> in, const float*& next) {
  std::array<float, kOut> out;
  std::copy_n(next + kIn * kOut, kOut, out.begin());
  for (std::size_t i = 0; i < kIn; ++i) {
    for (std::size_t j = 0; j < kOut; ++j) out[j] += in[i] * next[i * kOut + j];
  }
  next += kIn * kOut + kOut;
  return out;
}

float tanhOf(float x) {
  return static_cast<float>(1.0 - 2.0 / (core::math::exp(std::clamp(2.0 * double{x}, -40.0, 40.0)) + 1.0));
}

std::array<float, kOutputs> actionFor(std::span<const float, kSeen> seen) {
  const float* next = kWeights;
  auto first = layer<kSeen, kHidden>(seen, next);
  for (float& x : first) x = tanhOf(x);
  auto second = layer<kHidden, kHidden>(first, next);
  for (float& x : second) x = tanhOf(x);
  auto action = layer<kHidden, kOutputs>(second, next);
  for (float& x : action) x = std::clamp(x, -1.0f, 1.0f);
  return action;
}

core::Vec2 coreOf(Vec2 v) { return {v.x, v.y}; }

/// Drives as the network says: a direction, seen from that of the goal, and a speed.
class Learnt : public Navigator {
 public:
  Learnt()
      : Navigator("learnt", "a small network, trained by proximal policy optimisation",
                  "fulbito/Navigate-v0") {}
  void reset() override { sight_ = {}; }

  void plan(const NavigationScene& scene, Guidance& guidance) override {
    show(scene);
    sight_.write(scene_, seen_);
    const auto action = actionFor(std::span<const float, kSeen>(seen_.data(), kSeen));
    direction_ = core::math::angleOf(scene_.goal.position - scene_.self.pose.position) +
                 double{action[0]} * core::math::kPi;
    guidance.kind = Guidance::Kind::kField;
    guidance.speed_cap = robot_.maxSpeed() * (double{action[1]} + 1.0) / 2.0;
  }
  double heading(Vec2) const override { return direction_; }

 private:
  /// Takes what the sight needs of the scene.
  void show(const NavigationScene& scene) {
    field_.length = scene.field.length;
    field_.width = scene.field.width;
    field_.goal_width = scene.field.goal_width;
    field_.goal_depth = scene.field.goal_depth;
    field_.corner = scene.field.corner;
    robot_.wheel_radius = scene.robot.wheel_radius;
    robot_.axle_track = scene.robot.axle_track;
    robot_.max_wheel_speed = scene.robot.max_wheel_speed;
    scene_.field = &field_;
    scene_.robot = &robot_;
    scene_.self.pose = {coreOf(scene.self.position), scene.self.heading};
    scene_.self.velocity = coreOf(scene.self.velocity);
    scene_.self.angular_velocity = scene.self.angular_velocity;
    scene_.self.wheels = {scene.self.wheels.left, scene.self.wheels.right};
    scene_.goal.position = coreOf(scene.goal);
    scene_.goal.heading = scene.goal_heading;
    discs_.clear();
    for (const Disc& disc : scene.obstacles) {
      discs_.push_back({coreOf(disc.position), disc.radius, coreOf(disc.velocity)});
    }
    scene_.obstacles = discs_;
  }

  core::FieldGeometry field_;
  core::RobotModel robot_;
  core::NavigationScene scene_;
  std::vector<core::DiscObstacle> discs_;
  core::NavigationSight sight_;
  std::array<float, core::kNavigationSightNumbers> seen_{};
  double direction_ = 0.0;  ///< [rad]
};

}  // namespace

FULBITO_NAVIGATORS(Learnt)
