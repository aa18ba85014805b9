#pragma once

#include "fulbito/report.hpp"

namespace fulbito {

/// @{ Random streams of the experiments. Their numbers are part of the determinism contract.
inline constexpr Stream kLayoutStream{1};        ///< placement of obstacles, starts and goals
inline constexpr Stream kSonarStream{16};        ///< errors of ultrasonic sensors
inline constexpr Stream kCaptureTaskStream{17};  ///< starts of captures
inline constexpr Stream kSightingStream{18};     ///< noise of the camera that observes the object
inline constexpr Stream kTransportStream{19};    ///< random paths of the rod, and lost messages
inline constexpr Stream kEncoderStream{20};      ///< wheel slip seen by encoders
inline constexpr Stream kGyroStream{21};         ///< noise and drift of a gyro
inline constexpr Stream kRoomStream{22};         ///< rooms, poses and sensors
/// @}

}  // namespace fulbito
