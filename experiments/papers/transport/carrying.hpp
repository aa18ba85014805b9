#pragma once

#include <cstdint>
#include <vector>

#include "experiments/papers/transport/carrier.hpp"

namespace fulbito {

/// How two robots are set up, and what is kept of their work.
struct CarryPlan {
  double step = 0.05;  ///< [s] longest run: the paper's dt
  CarrierHabits habits;
  RadioModel radio;  ///< ideal: as the paper assumes
  std::uint64_t seed = 1;
  std::uint64_t index = 0;  ///< separates the radios of one seed
  bool keep_rows = false;
};

/// One exchange of roles.
struct RoleSwitch {
  double time = 0.0;  ///< [s]
  SwitchCause cause = SwitchCause::kNone;
  CarrierId master = CarrierId::kLead;  ///< the new one
  double direction = 1.0;               ///< of the new master along the path: +1 or -1
  double lead = 0.0;                    ///< [m] coordinates
  double follower = 0.0;                ///< [m]
};

/// Both robots at the beginning of a run.
struct CarryRow {
  double time = 0.0;  ///< [s]
  PartPlace lead, follower;
  double lead_speed = 0.0;      ///< [m/s] along the path
  double follower_speed = 0.0;  ///< [m/s]
  CarrierId master = CarrierId::kLead;
};

/// The work of two robots.
struct Carrying {
  StopReason end = StopReason::kNone;
  double seconds = 0.0;
  std::vector<RoleSwitch> switches;
  std::vector<CarryRow> rows;  ///< only if kept
  double rod_error = 0.0;      ///< [m] largest
  double peak_speed = 0.0;     ///< [m/s] of either robot
  double lead_way = 0.0;       ///< [m] driven, forward and backward
  double follower_way = 0.0;   ///< [m]
  double moving = 0.0;         ///< [s] of `seconds` in which they run
  double lead = 0.0;           ///< [m] coordinate at the end
  double follower = 0.0;       ///< [m]
  std::size_t messages = 0;    ///< sent
  std::size_t lost = 0;        ///< of them
  int steps = 0;
  int aborts = 0;            ///< runs that a robot broke off
  int timeouts = 0;          ///< losses of contact that a robot noticed
  double speed_share = 1.0;  ///< of the task's speeds: less over a slow radio
};

/// Speeds over the task's at which a robot that runs alone until it notices drives at most 0.6 mm.
double safeSpeedShare(const TransportTask& task, const CarrierTimes& times);

/// Lets two robots carry the rod until both have stopped. The same plan gives the same work.
Carrying carry(const TransportTask& task, const CarryPlan& plan);

}  // namespace fulbito
