#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/papers/capture/motion_profile.hpp"
#include "experiments/papers/capture/sightings.hpp"

namespace fulbito::capture {

/// Limits of the motion of a capture: Choi & Lee (2005), section IV.
struct CaptureLimits {
  double track = 0.4;             ///< [m] between the wheels
  double acceleration = 0.042;    ///< [m/s^2] of a wheel, (16)
  double speed = 0.588;           ///< [m/s] of a wheel, (15)
  double straighten = 1.0;        ///< [s] longest time from the curve to the line; (23) does not include it
  double least_radius1 = 1.2;     ///< [m] of the first curve; the largest radius follows from the wheels
  double least_radius3 = 1.2;     ///< [m] of the last curve
  double greatest_radius3 = 2.4;  ///< [m] of the last curve
  double longest = 60.0;          ///< [s] longest duration of a capture
  double half_hall = 9.3;         ///< [m] greatest |x| and |y| of the robot's centre
  double clearance = 0.0;         ///< [m] least distance between the centres during the capture

  /// [m] The largest first radius, for which the limits of speed and straightening are equal: 2.6 in the
  /// paper.
  double largestFirstRadius() const;
  /// [rad] The largest turn of a first curve with `radius` [m].
  double largestTurn(double radius) const;
};

/// A robot at rest that should arrive behind an object.
struct CaptureTask {
  Pose2 robot;
  ObjectMotion object;  ///< given at any time, such as time 0 of the capture
  double gap = 0.0;     ///< [m] wanted distance from the robot's centre to the object's at the end
};

/// A plan has three parts: a curve at full wheel acceleration, a line on which the robot brakes to the
/// object's speed, and a curve onto the object's line.
struct CapturePlan {
  double side = 1.0;                               ///< 1: the first curve turns left, -1: right
  double radius1 = 0.0, turn1 = 0.0, time1 = 0.0;  ///< [m], [rad], [s] of the first curve
  double radius3 = 0.0, turn3 = 0.0;  ///< [m], [rad] of the last curve; its turn is positive to the left
  double line = 0.0;                  ///< [m] length of the middle part
  double top_speed = 0.0;             ///< [m/s] at the end of the first curve
  double straight_from = 0.0;         ///< [s] at which the line begins
  double gap = 0.0;                   ///< [m] at the end
  MotionProfile motion;
};

/// The first curve and the straightening after it, by the wheels' rules of section IV.2.1.
struct CaptureStart {
  double time = 0.0;       ///< [s] duration of the curve
  double top_speed = 0.0;  ///< [m/s] at its end
  MotionProfile motion;    ///< motion of both parts
};
CaptureStart captureStart(const CaptureLimits& limits, const Pose2& robot, double side, double radius,
                          double turn);

/// The line and the last curve from a robot that drives straight. Empty if the line to the object's line is
/// too short for braking, or meets it at an angle below 0.25 rad, or if the object is faster than the robot.
/// @param motion  the motion so far; the object's time counts from its start
/// @param early   share of the line's spare length that is driven at the higher speed before braking; the
///   paper's robot brakes at once
std::optional<CapturePlan> captureEnd(const CaptureLimits& limits, const MotionProfile& motion, double speed,
                                      const ObjectMotion& object, double radius, double early = 0.0);

/// The plan for one first curve and one last radius; empty under the conditions of `captureEnd`.
std::optional<CapturePlan> capturePlan(const CaptureLimits& limits, const CaptureTask& task, double side,
                                       double radius1, double turn1, double radius3);

/// Why there is no plan.
enum class CaptureRefusal : std::uint8_t {
  kTooFast,   ///< the object is at rest, or at least as fast as the robot's top speed
  kNoLine,    ///< no first curve leads to a line that meets the object's line
  kTooEarly,  ///< every path ends nearer to the object than wanted, or ahead of it
  kTooLate,   ///< some or all paths end farther behind than wanted, and none as wanted
  kTooLong,   ///< there is a path, but it takes too long or leaves the hall
  kCollides,  ///< there is a path, but it comes too near to the object
};
/// Name for tables.
std::string nameOf(CaptureRefusal refusal);

/// The fastest plan with the wanted gap. For both sides and several first and last radii, the search finds
/// the first turns with this gap, for a robot that brakes at the start of the line. If there is none, it
/// takes the fastest for a robot that brakes later. If the plan is empty, `refusal` says why.
struct CaptureAnswer {
  std::optional<CapturePlan> plan;
  CaptureRefusal refusal = CaptureRefusal::kNoLine;
};
CaptureAnswer planCapture(const CaptureLimits& limits, const CaptureTask& task);

/// The line and the last curve with the wanted gap, or nearest to it, for a robot that drives straight. It
/// chooses where to brake, and a last radius as near to `radius` as possible. Empty if `captureEnd` is empty
/// for every radius.
std::optional<CapturePlan> replanEnd(const CaptureLimits& limits, const MotionProfile& motion, double speed,
                                     const ObjectMotion& object, double radius, double gap);

}  // namespace fulbito::capture
