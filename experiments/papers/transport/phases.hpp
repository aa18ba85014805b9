#pragma once

#include <string>
#include <vector>

#include "experiments/papers/transport/carrying.hpp"

namespace fulbito {

/// A period of constant roles and directions.
struct Phase {
  double from = 0.0;  ///< [s]
  CarrierId master = CarrierId::kLead;
  bool lead_back = false;      ///< whether the lead drives backward
  bool follower_back = false;  ///< whether the follower drives backward

  bool sameDirections(const Phase& o) const {
    return lead_back == o.lead_back && follower_back == o.follower_back;
  }
  bool same(const Phase& o) const { return master == o.master && sameDirections(o); }
};

/// The phases of a simulation with stored rows.
std::vector<Phase> phasesOf(const Carrying& work);

/// One of the steps 1 to 8 of Table 1 of Lee, Lee & Lee in a simulation.
struct PaperStep {
  int number = 1;
  double time = 0.0;      ///< [s] a time in the step
  std::size_t phase = 0;  ///< index of the phase with the roles and directions of the table
};

/// The steps, as far as the phases have their roles and directions in the order of the table. The steps of
/// one row of the table are spread evenly over its phase, and those of the last row over the time of constant
/// directions. The first step is the start.
/// @param end  [s] duration of the simulation
std::vector<PaperStep> paperSteps(const std::vector<Phase>& phases, double end);

}  // namespace fulbito
