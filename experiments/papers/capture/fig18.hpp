#pragma once

#include "experiments/papers/capture/capture_plan.hpp"
#include "experiments/papers/capture/pursuit.hpp"
#include "fulbito/models.hpp"

namespace fulbito::capture {

/// The experiment of Choi & Lee (2005), section V.3: the robot's start and the object's motion.
Pose2 fig18Robot();
ObjectMotion fig18Object();

/// Limits that lead to the paper's plan: they fix its two radii.
CaptureLimits fig18Limits();

/// The first turn [rad] after which a robot has `top_speed` [m/s], on a curve of 2.6 m at full acceleration.
double fig18Turn(double top_speed);

/// The plan with the first turn `turn` [rad], for the paper's two radii, a known object and no slip. Empty
/// under the conditions of `capturePlan`.
std::optional<CapturePlan> fig18Plan(double turn);

/// The plan with the top speed that the paper prints, 0.546 m/s.
std::optional<CapturePlan> printedPlan();

/// The capture of Fig. 18 with a wanted gap [m] between the centres.
PursuitSetup fig18Setup(const RobotModel& robot, double gap, const SightingNoise& noise, std::uint64_t seed);

/// [m] difference between the gap of the centres and the free space from the robot's front to the object's
/// rear.
double halfLengths(const RobotModel& robot);

/// Limits of a capture in which the bodies must not touch before the end.
CaptureLimits limitsWithoutTouch(const RobotModel& robot);

}  // namespace fulbito::capture
