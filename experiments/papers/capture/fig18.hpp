#pragma once

#include "experiments/papers/capture/capture_plan.hpp"
#include "experiments/papers/capture/pursuit.hpp"
#include "fulbito/models.hpp"

namespace fulbito::capture {

/// The experiment of Choi & Lee (2005), section V.3: the robot's start and the object's motion.
Pose2 fig18Robot();
ObjectMotion fig18Object();

/// Limits with which the paper's plan follows: its two radii are given.
CaptureLimits fig18Limits();

/// The first turn [rad] after which a robot has a top speed [m/s]: a curve of 2.6 m at full acceleration.
double fig18Turn(double top_speed);

/// The plan of a first turn [rad], with the paper's two radii, the object known and no slip. Empty as
/// `capturePlan`.
std::optional<CapturePlan> fig18Plan(double turn);

/// The one of the top speed that the paper prints, 0.546 m/s.
std::optional<CapturePlan> printedPlan();

/// The capture of Fig. 18 with a wanted gap [m] of the middles.
PursuitSetup fig18Setup(const RobotModel& robot, double gap, const SightingNoise& noise, std::uint64_t seed);

/// [m] from the gap of the middles to the free one between the robot's front and the object's rear.
double halfLengths(const RobotModel& robot);

/// The limits of a capture of bodies that shall not touch before its end.
CaptureLimits limitsWithoutTouch(const RobotModel& robot);

}  // namespace fulbito::capture
