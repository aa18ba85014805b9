#pragma once

#include <array>

namespace fulbito {

/// One of the results of Jung & Lee (2015): the savings of the Bezier method over the vector field, as ratios
/// (-0.256 is 25.6 % less) and as printed in the units of its figure.
struct PaperTarget {
  const char* name;  ///< name in the paper
  double length;     ///< @{ relative to that of the vector field
  double time;       ///< @}
  const char* figure = "";
  double length_saved = 0.0;  ///< saved length in units of `length_unit`
  double time_saved = 0.0;    ///< [s]
  const char* length_unit = "";
};
/// The results of section 5, simulation and experiment.
inline constexpr std::array<PaperTarget, 2> kPaperTargets{
    {{"simulation", -0.256, -0.193, "Fig. 28", 95.3, 4.81, "px"},
     {"experiment", -0.273, -0.235, "Fig. 29", 25.87, 0.38, "cm"}}};

}  // namespace fulbito
