#pragma once

#include "fulbito/report.hpp"

namespace fulbito {

/// @{ Streams of random numbers of the experiments. The numbers are part of the determinism contract.
inline constexpr Stream kLayoutStream{1};        ///< placement of obstacles, starts and goals
inline constexpr Stream kSonarStream{16};        ///< errors of ultrasonic sensors
inline constexpr Stream kCaptureTaskStream{17};  ///< starts of captures
inline constexpr Stream kSightingStream{18};     ///< noise of the camera that watches the object
inline constexpr Stream kTransportStream{19};    ///< random paths of the rod, and messages that get lost
inline constexpr Stream kEncoderStream{20};      ///< slip of wheels as their encoders see it
inline constexpr Stream kGyroStream{21};         ///< noise and drift of a gyro
inline constexpr Stream kRoomStream{22};         ///< rooms, poses and sensors
/// @}

}  // namespace fulbito
