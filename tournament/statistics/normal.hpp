#pragma once

namespace fulbito {

/// Cumulative distribution function of the standard normal distribution, to 1e-7 (Abramowitz & Stegun
/// 26.2.17).
double normalShareBelow(double z);

}  // namespace fulbito
