#pragma once

namespace fulbito {

/// The share of a standard normal distribution below `z`, to 1e-7 (Abramowitz & Stegun 26.2.17).
double normalShareBelow(double z);

}  // namespace fulbito
