#pragma once

namespace fulbito::libero {

/// What a user may set: `libero:aggression=0.7`.
struct Settings {
  double aggression = 0.5;  ///< 0: the support stays goal-side; 1: it goes forward with the striker
};

}  // namespace fulbito::libero
