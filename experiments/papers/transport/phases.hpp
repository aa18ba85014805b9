#pragma once

#include <string>
#include <vector>

#include "experiments/papers/transport/carrying.hpp"

namespace fulbito {

/// A stretch of time in which roles and directions stay.
struct Phase {
  double from = 0.0;  ///< [s]
  CarrierId master = CarrierId::kLead;
  bool lead_back = false;      ///< the lead goes backward
  bool follower_back = false;  ///< the follower does

  bool sameDirections(const Phase& o) const {
    return lead_back == o.lead_back && follower_back == o.follower_back;
  }
  bool same(const Phase& o) const { return master == o.master && sameDirections(o); }
};

/// The phases of a work whose rows were kept.
std::vector<Phase> phasesOf(const Carrying& work);

/// One of the steps 1 to 8 of Table 1 of Lee, Lee & Lee in a work.
struct PaperStep {
  int number = 1;
  double time = 0.0;      ///< [s] a moment of it
  std::size_t phase = 0;  ///< index of the phase whose roles and directions are those of the table
};

/// The steps, as far as the phases have their roles and directions in the table's order. Steps of one row of
/// the table are spread evenly over its phase, those of the last one over the time in which the directions
/// stay; the first one is the start.
/// @param end  [s] of the work
std::vector<PaperStep> paperSteps(const std::vector<Phase>& phases, double end);

}  // namespace fulbito
