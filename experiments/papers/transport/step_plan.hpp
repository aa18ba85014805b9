#pragma once

#include "experiments/papers/transport/message.hpp"
#include "experiments/papers/transport/radio.hpp"
#include "experiments/papers/transport/transport_task.hpp"

namespace fulbito {

/// The input of a slave's plan for a step.
struct StepQuestion {
  CarrierId slave = CarrierId::kFollower;
  PartPlace own;
  PartPlace master;
  double master_speed = 0.0;  ///< [m/s] along the path; 0: waits until the rod's length is right
  double step = 0.05;         ///< [s] greatest duration
  bool project = true;        ///< whether the slave ends at a rod's length from the master's end
};

/// A slave's plan (steps 3 to 7 of section III.3).
struct StepPlan {
  SwitchCause cause = SwitchCause::kNone;  ///< kNone: the slave can follow
  double speed = 0.0;                      ///< [m/s] by the speed relation
  double target = 0.0;                     ///< [m] coordinate at which the slave ends
  double duration = 0.0;                   ///< [s]
};

/// Plans a step. It ends at the latest where the master reaches the end of its part or the lead reaches the
/// path's end. The slave cannot follow if it would be too fast or leave its part.
StepPlan planStep(const TransportTask& task, const StepQuestion& question);

}  // namespace fulbito
