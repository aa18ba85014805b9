#pragma once

#include "engine/core/models/drive_law.hpp"
#include "experiments/capture/motion_profile.hpp"

namespace fulbito::capture {

/// Wheel speeds that move a robot as its plan says, over the ground: by the slip that its model is known for,
/// the wheels turn for a tighter curve.
WheelSpeeds wheelsOverGround(const RobotModel& robot, const DriveLaw& law, Twist twist);

/// The twist that brings a robot onto a moving reference: Kanayama et al. (1990). Across the way the error
/// falls as that of a damped oscillator over the distance driven.
Twist trackingTwist(const MotionState& reference, const Pose2& robot);

}  // namespace fulbito::capture
