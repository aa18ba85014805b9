#pragma once

#include <cstdint>

#include "experiments/papers/transport/rod_constraint.hpp"

namespace fulbito {

/// What the robots tell each other (Lee, Lee & Lee, section III.4). The last two are ours.
enum class MessageKind : std::uint8_t {
  kStart,     ///< slave to master: where I stand; begin a step
  kVelocity,  ///< master to slave: where I stand and how fast I go
  kRuntime,   ///< slave to master: when we run, and for how long
  kDone,      ///< master to slave: I have run
  kSwitch,    ///< slave to master: I cannot follow, so I am master: where I stand and how fast I go
  kBeat,      ///< either: I am about to run, or running, this step
  kStop       ///< either: we stop for good, and why
};

/// Why a slave cannot follow.
enum class SwitchCause : std::uint8_t { kNone, kSpeed, kPartEnd };

/// Why robots stop for good.
enum class StopReason : std::uint8_t {
  kNone,
  kArrived,   ///< the lead is at the path's end
  kOffPath,   ///< a robot would leave the path over one of its ends
  kDeadlock,  ///< neither can be the slave
  kSilence,   ///< no message for a long time
};

/// One message. The sequence number is the pair (step, hop): messages of an earlier one are ignored.
struct Message {
  MessageKind kind = MessageKind::kBeat;
  std::uint32_t step = 0;                  ///< number of the step, from 1
  int hop = 0;                             ///< exchanges of roles in this step so far
  PartPlace place;                         ///< of the sender
  double speed = 0.0;                      ///< [m/s] of the sender, along the path
  double begin = 0.0;                      ///< [s] of the run
  double duration = 0.0;                   ///< [s] of the run
  SwitchCause cause = SwitchCause::kNone;  ///< of a kSwitch
  StopReason reason = StopReason::kNone;   ///< of a kStop
};

}  // namespace fulbito
