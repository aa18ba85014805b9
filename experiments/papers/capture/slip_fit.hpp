#pragma once

#include <span>
#include <vector>

namespace fulbito::capture {

/// A radius that a robot drove where its wheels were set for another.
struct DrivenRadius {
  double speed = 0.0;      ///< [m/s]
  double commanded = 0.0;  ///< [m]
  double driven = 0.0;     ///< [m]
};

/// A law of the radius under slip, fitted by least squares.
struct SlipFit {
  double tau0 = 0.0;   ///< [s]
  double tau1 = 0.0;   ///< [s^2/m]
  double rms = 0.0;    ///< [m] of driven minus law
  double worst = 0.0;  ///< [m] the largest of them
};

/// R = R0 + tau0 v + tau1 v^2: what the robot's keys `curve_widening` and `curve_widening_rise` are.
SlipFit fitWidening(std::span<const DrivenRadius> radii);
/// R = R0 + tau0 v.
SlipFit fitLinearWidening(std::span<const DrivenRadius> radii);
/// R = R0 (1 + tau1 v^2): the understeer of a car, for comparison.
SlipFit fitUndersteer(std::span<const DrivenRadius> radii);

/// The 5 radii of Choi & Lee (2005), Table 5; the 10 of Table 6; all 15.
std::vector<DrivenRadius> radiiOfTable5();
std::vector<DrivenRadius> radiiOfTable6();
std::vector<DrivenRadius> publishedRadii();

/// What a law R = R0 + tau0 v + tau1 v^2 says of radii: the same `tau0` and `tau1`, with the errors there.
SlipFit judgedOn(const SlipFit& law, std::span<const DrivenRadius> radii);

}  // namespace fulbito::capture
