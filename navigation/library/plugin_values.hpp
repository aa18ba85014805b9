#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>

#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"
#include "fulbito/team.h"

/// Conversions of shared values to the C interface and back. Those for structures are generated from
/// sdk/values/values.toml.
namespace fulbito {

/// @{ To the C interface.
inline void toAbi(double from, double& to) { to = from; }
inline void toAbi(bool from, std::uint8_t& to) { to = from ? 1 : 0; }
inline void toAbi(bool from, std::uint32_t& to) { to = from ? 1 : 0; }
inline void toAbi(std::uint8_t from, std::uint8_t& to) { to = from; }
/// Clamped to 8 bits.
inline void toAbi(int from, std::int8_t& to) { to = static_cast<std::int8_t>(std::clamp(from, -128, 127)); }
inline void toAbi(int from, std::int32_t& to) { to = from; }
inline void toAbi(std::int64_t from, std::int64_t& to) { to = from; }
inline void toAbi(std::uint64_t from, std::uint64_t& to) { to = from; }
inline void toAbi(Vec2 from, fulbito_vec2& to) { to = {from.x, from.y}; }
inline void toAbi(const Pose2& from, fulbito_pose& to) {
  to = {{from.position.x, from.position.y}, from.heading};
}
inline void toAbi(WheelSpeeds from, fulbito_wheels& to) { to = {from.left, from.right}; }
/// A text with its zero byte. A text that is too long is cut at the end of a character.
void toAbi(std::string_view text, char (&to)[FULBITO_NAME_SIZE]);
template <typename Enum, typename Number>
  requires std::is_enum_v<Enum>
void toAbi(Enum from, Number& to) {
  to = static_cast<Number>(from);
}
/// An empty value becomes -1.
template <typename T>
void toAbi(const std::optional<T>& from, std::int32_t& to) {
  to = from ? static_cast<std::int32_t>(*from) : -1;
}
void toAbi(const RobotState& v, fulbito_robot& to);  ///< for a robot that is present
void toAbi(const FieldGeometry& v, fulbito_field& to);
void toAbi(const RobotModel& v, fulbito_robot_model& to);
inline fulbito_curve_widening wideningToAbi(const RobotModel& robot) {
  return {robot.curve_widening, robot.curve_widening_rise};
}

/// Converts `value` to the C structure `C`.
template <typename C, typename T>
C abiOf(const T& value) {
  C structure{};
  toAbi(value, structure);
  return structure;
}
/// @}

/// @{ From the C interface.
inline Vec2 fromAbi(fulbito_vec2 v) { return {v.x, v.y}; }
inline Pose2 fromAbi(const fulbito_pose& pose) { return {fromAbi(pose.position), pose.heading}; }
inline WheelSpeeds fromAbi(fulbito_wheels wheels) { return {wheels.left, wheels.right}; }
inline Twist fromAbi(fulbito_twist twist) { return {twist.linear, twist.angular}; }
/// @}

}  // namespace fulbito
