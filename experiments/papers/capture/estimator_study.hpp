#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/papers/capture/sightings.hpp"

namespace fulbito::capture {

/// Accuracy of a method that estimates the motion of the paper's object from noisy sightings.
struct EstimatorRow {
  SightingNoise noise;
  std::string method;
  int sightings = 2;
  double position = 0.0;  ///< [m] rms
  double speed = 0.0;     ///< [m/s] rms
  double heading = 0.0;   ///< [rad] rms
};

/// Tries each method on `draws` noisy sequences of the object of Fig. 18, at three levels of noise.
std::vector<EstimatorRow> studyEstimators(std::uint64_t seed, int draws);

}  // namespace fulbito::capture
