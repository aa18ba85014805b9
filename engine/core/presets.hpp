#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/ball_model.hpp"
#include "engine/core/field_geometry.hpp"
#include "engine/core/layout.hpp"
#include "engine/core/physics_profile.hpp"
#include "engine/core/result.hpp"
#include "engine/core/robot_model.hpp"

namespace fulbito {

/// A preset file that is part of the program.
struct EmbeddedFile {
  std::string_view kind;  ///< folder: robots, physics, fields
  std::string_view name;
  std::string_view text;
};

/// All presets of this library, in a fixed order.
std::span<const EmbeddedFile> embeddedPresets();

/// What a robot file describes: the robot and the ball that it plays with.
struct RobotPreset {
  RobotModel robot;
  BallModel ball;
};

/// @{ Each takes the name of a preset or the path of a TOML file. Errors: kUsage for an unknown name (with a
/// suggestion), kIo for a file that cannot be read, kBadInput with file, line, key and allowed range for what
/// is wrong inside.
Result<RobotPreset> loadRobot(const std::string& name_or_file);
Result<PhysicsProfile> loadPhysics(const std::string& name_or_file);
Result<FieldGeometry> loadField(const std::string& name_or_file);
Result<Layout> loadLayout(const std::string& file);
/// @}

/// Parses a layout from text; `origin` stands for the file name in errors.
Result<Layout> parseLayout(std::string_view text, const std::string& origin);
/// A layout as a TOML file that `parseLayout` reads back to the same bits.
std::string toToml(const Layout& layout);

/// Names of the presets of one kind ("robots", "physics", "fields").
std::vector<std::string> presetNames(std::string_view kind);
/// The text of a preset. Errors: kUsage, with a suggestion.
Result<std::string> presetText(std::string_view kind, const std::string& name);

}  // namespace fulbito
