#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/base/result.hpp"
#include "engine/core/models/ball_model.hpp"
#include "engine/core/models/field_geometry.hpp"
#include "engine/core/models/layout.hpp"
#include "engine/core/models/physics_profile.hpp"
#include "engine/core/models/robot_model.hpp"

namespace fulbito {

/// A preset file embedded in the program.
struct EmbeddedFile {
  std::string_view kind;  ///< folder: robots, physics, fields
  std::string_view name;
  std::string_view text;
};

/// All presets of this library, in a fixed order.
std::span<const EmbeddedFile> embeddedPresets();

/// The content of a robot file: the robot and its ball.
struct RobotPreset {
  RobotModel robot;
  BallModel ball;
};

/// Whether `name_or_file` is always a file, never a preset: it contains a '/' or ends in ".toml".
bool isFileName(std::string_view name_or_file);

/// @{ Each takes the name of a preset or the path of a TOML file (`isFileName`, or an existing file that is
/// not also a preset's name). Missing keys keep the struct's defaults; a missing `name` becomes the file's.
/// Errors: kUsage for an unknown name (with a suggestion), kIo for an unreadable file, kBadInput as
/// `file:line: table.key ...` with the allowed range.
Result<RobotPreset> loadRobot(const std::string& name_or_file);       ///< tables [robot] and [ball]
Result<PhysicsProfile> loadPhysics(const std::string& name_or_file);  ///< table [physics]
Result<FieldGeometry> loadField(const std::string& name_or_file);     ///< table [field]
/// @}

/// @{ The same from text; `origin` stands for the file name in errors.
Result<RobotPreset> parseRobot(std::string_view text, const std::string& origin);
Result<PhysicsProfile> parsePhysics(std::string_view text, const std::string& origin);
Result<FieldGeometry> parseField(std::string_view text, const std::string& origin);
/// @}

/// Reads a layout file (format: `parseLayout`). A relative path of a field file counts from the layout's
/// folder and is returned joined with it. The field must load; start, goal and obstacles must lie inside it.
/// Errors: as above.
Result<Layout> loadLayout(const std::string& file);

/// Parses a layout from text; `origin` stands for the file name in errors. Unlike `loadLayout` it opens no
/// field. Tables: [layout] name, field; [start] position (required), heading; [goal] position (required),
/// heading, tolerance, heading_tolerance; any number of [[obstacle]] with the members of `ObstacleSpec`.
/// Angles: `heading = radians` or `heading_deg = degrees`, not both. Headings are brought into [-pi, pi).
/// An obstacle on a path needs no position: it starts at the first waypoint.
Result<Layout> parseLayout(std::string_view text, const std::string& origin);

/// A valid layout as a TOML file that `parseLayout` reads back to the same bits.
std::string toToml(const Layout& layout);
/// @{ All keys with units and meanings, as a TOML file that the loader reads back to the same bits.
std::string toToml(const RobotPreset& preset);
std::string toToml(const PhysicsProfile& physics);
std::string toToml(const FieldGeometry& field);
/// @}

/// Names of the presets of one kind ("robots", "physics", "fields").
std::vector<std::string> presetNames(std::string_view kind);
/// The text of a preset. Errors: kUsage, with a suggestion.
Result<std::string> presetText(std::string_view kind, const std::string& name);

}  // namespace fulbito
