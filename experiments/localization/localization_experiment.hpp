#pragma once

#include "fulbito/report.hpp"

namespace fulbito::localization {

/// The experiment `localization`: Jeong et al., absolute position by ultrasonic sensors and a map.
PaperExperiment localizationExperiment();

}  // namespace fulbito::localization
