#pragma once

#include <cstdint>
#include <vector>

#include "experiments/papers/transport/carrier.hpp"

namespace fulbito {

/// Settings of a simulation of both robots.
struct CarryPlan {
  double step = 0.05;  ///< [s] greatest duration of a run: the paper's dt
  CarrierHabits habits;
  RadioModel radio;  ///< ideal by default, as the paper assumes
  std::uint64_t seed = 1;
  std::uint64_t index = 0;  ///< distinguishes the radios of one seed
  bool keep_rows = false;
};

/// One exchange of roles.
struct RoleSwitch {
  double time = 0.0;  ///< [s]
  SwitchCause cause = SwitchCause::kNone;
  CarrierId master = CarrierId::kLead;  ///< new master
  double direction = 1.0;               ///< direction of the new master along the path: +1 or -1
  double lead = 0.0;                    ///< [m] coordinate on the path
  double follower = 0.0;                ///< [m] coordinate on the path
};

/// Both robots at the start of a run.
struct CarryRow {
  double time = 0.0;  ///< [s]
  PartPlace lead, follower;
  double lead_speed = 0.0;      ///< [m/s] along the path
  double follower_speed = 0.0;  ///< [m/s]
  CarrierId master = CarrierId::kLead;
};

/// The result of a simulation of both robots.
struct Carrying {
  StopReason end = StopReason::kNone;
  double seconds = 0.0;
  std::vector<RoleSwitch> switches;
  std::vector<CarryRow> rows;  ///< only if requested
  double rod_error = 0.0;      ///< [m] largest error of the rod's length
  double peak_speed = 0.0;     ///< [m/s] of either robot
  double lead_way = 0.0;       ///< [m] distance driven, forward and backward
  double follower_way = 0.0;   ///< [m]
  double moving = 0.0;         ///< [s] part of `seconds` in which the robots run
  double lead = 0.0;           ///< [m] coordinate at the end
  double follower = 0.0;       ///< [m]
  std::size_t messages = 0;    ///< number of messages sent
  std::size_t lost = 0;        ///< number of lost messages
  int steps = 0;
  int aborts = 0;            ///< runs that a robot broke off
  int timeouts = 0;          ///< losses of contact that a robot noticed
  double speed_share = 1.0;  ///< factor of the task's speeds; below 1 with a slow radio
};

/// Factor of the task's speeds with which a robot that runs alone drives at most 0.6 mm before it notices.
double safeSpeedShare(const TransportTask& task, const CarrierTimes& times);

/// Simulates two robots that carry the rod until both have stopped. The same plan gives the same result.
Carrying carry(const TransportTask& task, const CarryPlan& plan);

}  // namespace fulbito
