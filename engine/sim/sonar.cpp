#include <algorithm>
#include <utility>

#include "engine/core/models/shapes.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/sensors.hpp"

namespace fulbito {
namespace {

constexpr double kSilence = std::numeric_limits<double>::infinity();

Cone coneOf(const SonarSpec& sonar, const Pose2& robot) {
  const Vec2 ahead = math::unit(robot.heading);
  return {robot.position + outOfFrame(ahead, sonar.mount.position),
          outOfFrame(ahead, math::unit(sonar.mount.heading)), sonar.half_cone, sonar.greatest};
}

void outlineObstacle(const ObstacleSpec& spec, const Pose2& pose, EchoScene& scene) {
  if (spec.shape == ObstacleShape::kDisc) return scene.addDisc(pose.position, spec.radius);
  scene.addBody(cornersOf({pose, spec.length, spec.width}));
}

}  // namespace

WorldOutlines::WorldOutlines(const FieldGeometry& field) : contour_(innerContour(field)) {}

const EchoScene& WorldOutlines::trace(const World& world, std::size_t without) {
  const WorldConfig& config = world.config();
  const WorldState& state = world.state();
  scene_.clear();
  scene_.addRoom(contour_);
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    if (i != without) scene_.addBody(cornersOf(bodyOf(config.robots[i].model, state.robots[i].pose)));
  }
  for (std::size_t i = 0; i < state.balls.size(); ++i)
    scene_.addDisc(state.balls[i].position, config.balls[i].model.radius);
  for (std::size_t i = 0; i < state.obstacles.size(); ++i)
    outlineObstacle(config.obstacles[i], state.obstacles[i].pose, scene_);
  return scene_;
}

RayHit castRay(const World& world, Vec2 from, Vec2 direction, double range, std::size_t without) {
  return WorldOutlines(world.config().field).trace(world, without).castRay(from, direction, range);
}

SonarArray::SonarArray(const FieldGeometry& field, SonarModel model, const Rng& random)
    : model_(std::move(model)),
      random_(random),
      outlines_(field),
      cones_(model_.sonars.size()),
      echoes_(model_.sonars.size()),
      readings_(model_.sonars.size()) {}

std::span<const SonarReading> SonarArray::measure(const World& world, std::size_t robot) {
  const EchoScene& scene = outlines_.trace(world, robot);
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    cones_[i] = coneOf(model_.sonars[i], world.state().robots[robot].pose);
    echoes_[i] = scene.castCone(cones_[i], model_.specular_limit);
  }
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    const SonarSpec& sonar = model_.sonars[i];
    const double range = heardRange(i);
    const bool heard = range <= sonar.greatest;
    readings_[i] = {heard, heard ? std::max(range, sonar.least) : sonar.greatest};
  }
  return readings_;
}

double SonarArray::heardRange(std::size_t sonar) {
  double range = echoes_[sonar].distance;
  if (model_.cross_talk > 0.0 && random_.uniform() < model_.cross_talk) {
    if (sonar > 0) range = std::min(range, strayRange(sonar, sonar - 1));
    if (sonar + 1 < cones_.size()) range = std::min(range, strayRange(sonar, sonar + 1));
  }
  if (model_.dropout > 0.0 && random_.uniform() < model_.dropout) return kSilence;
  if (model_.noise > 0.0) range += random_.normal(0.0, model_.noise);
  return range;
}

/// The range that a sonar computes from its neighbour's echo: half the length of the sound's path.
double SonarArray::strayRange(std::size_t sonar, std::size_t neighbour) const {
  const Echo& echo = echoes_[neighbour];
  if (!echo.isHeard()) return kSilence;
  return (echo.distance + distance(echo.point, cones_[sonar].apex)) / 2;
}

}  // namespace fulbito
