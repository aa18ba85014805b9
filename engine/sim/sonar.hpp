#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "engine/core/math/random.hpp"
#include "engine/core/models/echo_scene.hpp"
#include "engine/core/models/sonar_model.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// Stands for "no robot of the world".
inline constexpr std::size_t kNoRobot = std::numeric_limits<std::size_t>::max();

/// Outlines of all walls and bodies of a world, for rays and cones.
class WorldOutlines {
 public:
  /// @param field  of the worlds to trace
  explicit WorldOutlines(const FieldGeometry& field);
  /// The world's outlines as its bodies stand now; valid until the next call.
  /// @param without  index of a robot that is left out, e.g. the one that looks
  const EchoScene& trace(const World& world, std::size_t without = kNoRobot);

 private:
  std::vector<Vec2> contour_;
  EchoScene scene_;
};

/// The first surface in the world on the way from `from` along the unit vector `direction` within `range`
/// [m]. For many rays at one tick, use `WorldOutlines::trace` and `EchoScene::castRay`.
/// @param without  index of a robot that is left out
RayHit castRay(const World& world, Vec2 from, Vec2 direction, double range, std::size_t without = kNoRobot);

/// The ultrasonic sensors of one robot. Each listens in its cone for the nearest surface that throws its call
/// back (see EchoScene::castCone). The robot's own body is no obstacle to them. Deterministic: the same world
/// and stream give the same readings. Allocates nothing once warm.
class SonarArray {
 public:
  /// @param field  of the worlds to measure in
  /// @param model  valid, see `validate`
  /// @param random  a stream of its own, e.g. Rng(seed, Stream::kSonar, trial)
  SonarArray(const FieldGeometry& field, SonarModel model, const Rng& random);

  /// Fires all sonars of the world's robot `robot` once. The readings stay valid until the next call.
  std::span<const SonarReading> measure(const World& world, std::size_t robot);
  /// The echoes of the last measurement without errors, in the world's frame.
  std::span<const Echo> echoes() const { return echoes_; }
  const SonarModel& model() const { return model_; }

 private:
  double heardRange(std::size_t sonar);
  double strayRange(std::size_t sonar, std::size_t neighbour) const;

  SonarModel model_;
  Rng random_;
  WorldOutlines outlines_;
  std::vector<Cone> cones_;
  std::vector<Echo> echoes_;
  std::vector<SonarReading> readings_;
};

}  // namespace fulbito
