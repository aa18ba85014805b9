#pragma once

#include "experiments/papers/transport/message.hpp"
#include "experiments/papers/transport/radio.hpp"
#include "experiments/papers/transport/transport_task.hpp"

namespace fulbito {

/// What a slave knows when it plans a step.
struct StepQuestion {
  CarrierId slave = CarrierId::kFollower;
  PartPlace own;
  PartPlace master;
  double master_speed = 0.0;  ///< [m/s] along the path; 0: it waits until the rod's length is right again
  double step = 0.05;         ///< [s] longest duration
  bool project = true;        ///< whether it ends at a rod's length from where the master ends
};

/// A slave's plan (steps 3 to 7 of section III.3).
struct StepPlan {
  SwitchCause cause = SwitchCause::kNone;  ///< kNone: it can follow
  double speed = 0.0;                      ///< [m/s] from the speed relation
  double target = 0.0;                     ///< [m] where the slave ends
  double duration = 0.0;                   ///< [s]
};

/// Plans it. The duration ends where the master reaches the end of its part, or the lead that of the path.
/// The slave cannot follow where it would be faster than permitted, or leave its part.
StepPlan planStep(const TransportTask& task, const StepQuestion& question);

}  // namespace fulbito
