#pragma once

#include "experiments/papers/paper_experiment.hpp"

namespace fulbito::localization {

/// The experiment `localization`: Jeong et al., absolute position by ultrasonic sensors and a map.
PaperExperiment localizationExperiment();

}  // namespace fulbito::localization
