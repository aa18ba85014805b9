#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// The commands that the robots of a scene get.
enum class Load {
  kRandom,  ///< new random wheel speeds each tick
  kHold,    ///< random wheel speeds held for half a second; the most similar to play
  kChase,   ///< all robots push toward the ball, which gives the most contacts
};

const char* nameOf(Load load);

/// Computes the commands of all robots of a scene.
class SceneDriver {
 public:
  SceneDriver(Load load, std::size_t robots, int control_rate, std::uint64_t seed);

  /// Commands for the next tick.
  /// @param robots  present poses
  /// @param target  the place that robots drive to with kChase
  std::span<const WheelSpeeds> drive(std::span<const Pose2> robots, Vec2 target);
  /// The same for a world's state, with its first ball as target.
  std::span<const WheelSpeeds> drive(const WorldState& state);

 private:
  void drawWheels();

  Load load_;
  int hold_ticks_;
  int ticks_ = 0;
  Rng rng_;
  std::vector<WheelSpeeds> commands_;
  std::vector<Pose2> poses_;
};

/// A world and its load. It does not depend on presets, so it stays the same when these change.
struct Scene {
  std::string name;
  WorldConfig config;
  Load load = Load::kRandom;
  int ticks = 600;
};

/// Two teams of `per_team` robots and a ball on the 3v3 field (the 5v5 field from 4 robots on).
WorldConfig matchScene(int per_team, const PhysicsProfile& physics);

/// The scenes of the determinism check and the signature.
std::vector<Scene> fixedScenes();

/// Runs a scene from its start. Returns a hash over state and contacts of every tick.
std::uint64_t hashOfRun(const Scene& scene);

/// One hash over all fixed scenes. It changes if and only if the engine's behaviour changes.
std::uint64_t sceneSignature();

}  // namespace fulbito
