#pragma once

namespace fulbito::libero {

/// Settings of the team, such as `libero:aggression=0.7`.
struct Settings {
  double aggression = 0.5;  ///< 0: the support stays goal-side; 1: it goes forward with the striker
};

}  // namespace fulbito::libero
