#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "fulbito/models.hpp"

/// A robot that finds its place in a room of known size with ultrasonic sensors (Jeong et al.). In the room
/// frame the room is [0, x] x [0, y], and the origin is a corner.
namespace fulbito::localization {

/// A rectangular room.
struct Room {
  double x = 0.0;  ///< [m] extent along x
  double y = 0.0;  ///< [m] extent along y
};

/// The body of a robot with a sensor in the middle of its front, right and left faces.
struct Body {
  double length = 0.0;  ///< [m] along its heading
  double width = 0.0;   ///< [m]
};

/// The sensors, in the order of all lists of echoes.
enum class Beam { kFront, kRight, kLeft };
inline constexpr std::array kBeams{Beam::kFront, Beam::kRight, Beam::kLeft};
constexpr std::size_t indexOf(Beam beam) { return static_cast<std::size_t>(beam); }

/// Direction of a sensor [rad] relative to the robot's heading.
constexpr double directionOf(Beam beam) {
  constexpr std::array kDirections{0.0, -math::kPi / 2, math::kPi / 2};
  return kDirections[indexOf(beam)];
}

/// [m] from the robot's centre to the sensor along its direction.
constexpr double reachOf(const Body& body, Beam beam) {
  return (beam == Beam::kFront ? body.length : body.width) / 2;
}

/// Times [s] from each sensor to its wall and back; empty without an echo.
using EchoTimes = std::array<std::optional<double>, kBeams.size()>;

/// The pose in the frame whose origin is the opposite corner. Echoes cannot distinguish the two.
inline Pose2 halfTurned(const Pose2& pose, const Room& room) {
  return {{room.x - pose.position.x, room.y - pose.position.y}, math::wrapAngle(pose.heading + math::kPi)};
}

}  // namespace fulbito::localization
