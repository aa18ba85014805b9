#pragma once

#include <array>

namespace fulbito::capture {

/// Values of Choi & Lee (2005) as printed.
struct PaperTables {
  static constexpr double kAcceleration = 0.05;                             ///< [m/s^2] section V.2
  static constexpr double kTurn = 1.913718;                                 ///< [rad] 109.65 degrees, Table 1
  static constexpr double kDistance = 7.18;                                 ///< [m] Table 1
  static constexpr double kSingleRadius = 3.75;                             ///< [m] Table 1
  static constexpr double kDoubleRadius = 1.875;                            ///< [m] section III.2
  static constexpr std::array<double, 5> kSpeeds{0.1, 0.2, 0.3, 0.4, 0.5};  ///< [m/s]

  /// Table 4: time [s] and wheel speeds [m/s].
  struct Computed {
    double time, single_left, single_right, double_left, double_right;
  };
  static constexpr std::array<Computed, 5> kComputed{{{72.8, 0.105, 0.095, 0.089, 0.111},
                                                      {37.9, 0.211, 0.189, 0.179, 0.221},
                                                      {26.9, 0.316, 0.284, 0.268, 0.332},
                                                      {21.9, 0.421, 0.379, 0.357, 0.443},
                                                      {19.3, 0.527, 0.473, 0.447, 0.553}}};
  /// Table 5.
  struct Single {
    double radius, error, time, distance;
  };
  static constexpr std::array<Single, 5> kSingle{{{3.88, 0.13, 74.0, 7.31},
                                                  {4.13, 0.38, 39.5, 7.54},
                                                  {4.37, 0.62, 28.8, 7.75},
                                                  {4.61, 0.86, 24.0, 7.98},
                                                  {4.98, 1.23, 21.5, 8.32}}};
  /// Table 6.
  struct Double {
    double radius1, radius2, error, time, distance;
  };
  static constexpr std::array<Double, 5> kDouble{{{2.02, 2.06, 0.51, 77.2, 7.67},
                                                  {2.25, 2.25, 1.02, 41.6, 8.08},
                                                  {2.47, 2.38, 1.44, 32.1, 8.12},
                                                  {2.85, 2.89, 2.43, 28.8, 8.80},
                                                  {3.12, 3.15, 3.01, 26.2, 9.33}}};
};

}  // namespace fulbito::capture
