#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/papers/capture/motion_profile.hpp"
#include "experiments/papers/capture/sightings.hpp"

namespace fulbito::capture {

/// What bounds the motion of a capture: Choi & Lee (2005), section IV.
struct CaptureLimits {
  double track = 0.4;             ///< [m] between the wheels
  double acceleration = 0.042;    ///< [m/s^2] of a wheel, (16)
  double speed = 0.588;           ///< [m/s] of a wheel, (15)
  double straighten = 1.0;        ///< [s] longest time from the curve to the line: what (23) lacks
  double least_radius1 = 1.2;     ///< [m] of the first curve; the largest follows from the wheels
  double least_radius3 = 1.2;     ///< [m] of the last curve
  double greatest_radius3 = 2.4;  ///< [m] of the last curve
  double longest = 60.0;          ///< [s] of a capture
  double half_hall = 9.3;         ///< [m] the robot's middle stays within it, along both axes
  double clearance = 0.0;         ///< [m] least distance of both middles on the way

  /// [m] The largest first radius for which speed and straightening bind at once: 2.6 in the paper.
  double largestFirstRadius() const;
  /// [rad] The largest turn of the first curve of a radius.
  double largestTurn(double radius) const;
};

/// A robot at rest that is to come behind an object.
struct CaptureTask {
  Pose2 robot;
  ObjectMotion object;  ///< at time 0 of the capture or any other
  double gap = 0.0;     ///< [m] wanted distance of the object's middle ahead of the robot's at the end
};

/// Three parts: a curve at full wheel acceleration, a line on which it slows down to the object's speed, a
/// curve onto the object's line.
struct CapturePlan {
  double side = 1.0;                               ///< 1: the first curve turns left, -1: right
  double radius1 = 0.0, turn1 = 0.0, time1 = 0.0;  ///< [m], [rad], [s] of the first curve
  double radius3 = 0.0, turn3 = 0.0;  ///< [m], [rad] of the last one; its turn is positive to the left
  double line = 0.0;                  ///< [m] length of the middle part
  double top_speed = 0.0;             ///< [m/s] at the end of the first curve
  double straight_from = 0.0;         ///< [s] when the line begins
  double gap = 0.0;                   ///< [m] at the end
  MotionProfile motion;
};

/// The first curve and the straightening: the wheels' rules of section IV.2.1.
struct CaptureStart {
  double time = 0.0;       ///< [s] of the curve
  double top_speed = 0.0;  ///< [m/s] at its end
  MotionProfile motion;    ///< of both
};
CaptureStart captureStart(const CaptureLimits& limits, const Pose2& robot, double side, double radius,
                          double turn);

/// Line and last curve from a robot that drives straight.
/// @param motion  so far; the object's time counts from its start
/// @param early   share of the line's spare length that is driven before slowing down, at the higher speed;
///   the paper's robot slows down at once
/// Empty if the line to the object's is shorter than the robot needs to slow down, or does not meet it at an
/// angle of 0.25 rad or more, or if the object is faster.
std::optional<CapturePlan> captureEnd(const CaptureLimits& limits, const MotionProfile& motion, double speed,
                                      const ObjectMotion& object, double radius, double early = 0.0);

/// The plan for one first curve and one last radius; empty as `captureEnd`.
std::optional<CapturePlan> capturePlan(const CaptureLimits& limits, const CaptureTask& task, double side,
                                       double radius1, double turn1, double radius3);

/// Why there is no plan.
enum class CaptureRefusal : std::uint8_t {
  kTooFast,   ///< the object is at rest, or at least as fast as the robot ever gets
  kNoLine,    ///< no first curve leads to a line that meets the object's
  kTooEarly,  ///< every way ends nearer to the object than wanted, or ahead of it
  kTooLate,   ///< some or all ways end farther behind than wanted, and none as wanted
  kTooLong,   ///< a way exists, but takes too long or leaves the hall
  kCollides,  ///< a way exists, but comes too near to the object
};
/// Name as in tables.
std::string nameOf(CaptureRefusal refusal);

/// The fastest plan with the wanted gap: for each side, first and last radius, the roots of the gap over the
/// first turn, for a robot that slows down at once on the line. If there is none, the fastest for a robot
/// that slows down later. Empty plan: `refusal` says why.
struct CaptureAnswer {
  std::optional<CapturePlan> plan;
  CaptureRefusal refusal = CaptureRefusal::kNoLine;
};
CaptureAnswer planCapture(const CaptureLimits& limits, const CaptureTask& task);

/// Line and last curve that end with the wanted gap, or nearest to it, for a robot that drives straight:
/// where it slows down, and a last radius as near to `radius` as possible. Empty as `captureEnd` for every
/// radius.
std::optional<CapturePlan> replanEnd(const CaptureLimits& limits, const MotionProfile& motion, double speed,
                                     const ObjectMotion& object, double radius, double gap);

}  // namespace fulbito::capture
