#pragma once

#include <span>
#include <vector>

namespace fulbito::capture {

/// A radius that a robot drove while its wheels were set for another radius.
struct DrivenRadius {
  double speed = 0.0;      ///< [m/s]
  double commanded = 0.0;  ///< [m]
  double driven = 0.0;     ///< [m]
};

/// A law of the radius under slip, fitted by least squares.
struct SlipFit {
  double tau0 = 0.0;   ///< [s]
  double tau1 = 0.0;   ///< [s^2/m]
  double rms = 0.0;    ///< [m] of the residuals, driven minus law
  double worst = 0.0;  ///< [m] largest residual
};

/// R = R0 + tau0 v + tau1 v^2, the law of the robot's keys `curve_widening` and `curve_widening_rise`.
SlipFit fitWidening(std::span<const DrivenRadius> radii);
/// R = R0 + tau0 v.
SlipFit fitLinearWidening(std::span<const DrivenRadius> radii);
/// R = R0 (1 + tau1 v^2): the understeer of a car, for comparison.
SlipFit fitUndersteer(std::span<const DrivenRadius> radii);

/// The driven radii of Choi & Lee (2005): the 5 of Table 5, the 10 of Table 6, and all 15.
std::vector<DrivenRadius> radiiOfTable5();
std::vector<DrivenRadius> radiiOfTable6();
std::vector<DrivenRadius> publishedRadii();

/// Applies a law R = R0 + tau0 v + tau1 v^2 to other radii: the same `tau0` and `tau1` with the residuals
/// there.
SlipFit judgedOn(const SlipFit& law, std::span<const DrivenRadius> radii);

}  // namespace fulbito::capture
