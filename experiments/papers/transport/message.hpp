#pragma once

#include <cstdint>

#include "experiments/papers/transport/rod_constraint.hpp"

namespace fulbito {

/// Kinds of messages between the robots (Lee, Lee & Lee, section III.4). The last two are additions.
enum class MessageKind : std::uint8_t {
  kStart,     ///< slave to master: my place; begin a step
  kVelocity,  ///< master to slave: my place and my speed
  kRuntime,   ///< slave to master: start and duration of the run
  kDone,      ///< master to slave: my run has ended
  kSwitch,    ///< slave to master: I cannot follow and become master; my place and my speed
  kBeat,      ///< either: I run in this step, or am about to
  kStop       ///< either: stop for good, with the reason
};

/// Why a slave cannot follow.
enum class SwitchCause : std::uint8_t { kNone, kSpeed, kPartEnd };

/// Why the robots stop for good.
enum class StopReason : std::uint8_t {
  kNone,
  kArrived,   ///< the lead is at the path's end
  kOffPath,   ///< a robot would leave the path at one of its ends
  kDeadlock,  ///< neither robot can be the slave
  kSilence,   ///< no message for a long time
};

/// One message. The pair (step, hop) is its sequence number; messages of earlier pairs are ignored.
struct Message {
  MessageKind kind = MessageKind::kBeat;
  std::uint32_t step = 0;                  ///< number of the step, from 1
  int hop = 0;                             ///< number of exchanges of roles in this step so far
  PartPlace place;                         ///< place of the sender
  double speed = 0.0;                      ///< [m/s] speed of the sender along the path
  double begin = 0.0;                      ///< [s] start of the run
  double duration = 0.0;                   ///< [s] duration of the run
  SwitchCause cause = SwitchCause::kNone;  ///< only for kSwitch
  StopReason reason = StopReason::kNone;   ///< only for kStop
};

}  // namespace fulbito
