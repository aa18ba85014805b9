#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// What the robots of a scene are told.
enum class Load {
  kRandom,  ///< new random wheel speeds each tick
  kHold,    ///< random wheel speeds held for half a second: nearest to play
  kChase,   ///< all push at the ball: the most contacts
};

const char* nameOf(Load load);

/// Drives all robots of a scene.
class SceneDriver {
 public:
  SceneDriver(Load load, std::size_t robots, int control_rate, std::uint64_t seed);

  /// Commands for the next tick.
  /// @param robots  where they are now
  /// @param target  where kChase drives
  std::span<const WheelSpeeds> drive(std::span<const Pose2> robots, Vec2 target);
  /// The same, from a world's state and its first ball.
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

/// A world and how it is driven; always the same, whatever the presets become.
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

/// Runs a scene from its start; a hash over every tick's state and contacts.
std::uint64_t hashOfRun(const Scene& scene);

/// One hash over all fixed scenes: it changes when, and only when, the engine's behaviour does.
std::uint64_t sceneSignature();

}  // namespace fulbito
