#pragma once

#include <string_view>

#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"
#include "fulbito/team.h"

/// Conversions of shared values to the C interface and back.
namespace fulbito {

/// Copies a text with its zero byte; longer ones are cut at the end of a character.
void copyName(std::string_view text, char (&to)[FULBITO_NAME_SIZE]);

/// @{ To the C interface.
inline fulbito_vec2 toAbi(Vec2 v) { return {v.x, v.y}; }
inline fulbito_pose toAbi(const Pose2& pose) { return {toAbi(pose.position), pose.heading}; }
inline fulbito_wheels toAbi(WheelSpeeds wheels) { return {wheels.left, wheels.right}; }
fulbito_robot toAbi(const RobotState& robot);  ///< a robot that is present
fulbito_field toAbi(const FieldGeometry& field);
fulbito_robot_model toAbi(const RobotModel& robot);
fulbito_curve_widening wideningToAbi(const RobotModel& robot);
/// @}

/// @{ From the C interface.
inline Vec2 fromAbi(fulbito_vec2 v) { return {v.x, v.y}; }
inline Pose2 fromAbi(const fulbito_pose& pose) { return {fromAbi(pose.position), pose.heading}; }
inline WheelSpeeds fromAbi(fulbito_wheels wheels) { return {wheels.left, wheels.right}; }
inline Twist fromAbi(fulbito_twist twist) { return {twist.linear, twist.angular}; }
/// @}

}  // namespace fulbito
