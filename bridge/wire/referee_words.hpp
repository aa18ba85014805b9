#pragma once

#include "bridge/wire/messages.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito::wire {

/// The foul that names a restart. `RestartKind::kGiven` has none: kStop.
Foul foulOf(RestartKind kind);
/// The restart that a foul names; kGiven for kStop, kGameOn and kHalt.
RestartKind restartOf(Foul foul);
/// Whether robots are placed after the command.
inline bool isRestart(Foul foul) { return restartOf(foul) != RestartKind::kGiven; }

/// The half of a period of the match.
/// @param overtime_part  part of overtime: 1, 2 ...; the wire has two, so later ones count as the second
Half halfOf(int period, int overtime_part);
/// The period of the match in a half; before the match the first.
int periodOf(Half half);
/// The part of overtime in a half: 2 in kOvertimeSecond, else 1.
inline int overtimePartOf(Half half) { return half == Half::kOvertimeSecond ? 2 : 1; }

/// The quadrant of a ball, as of `RefereeCommand::quadrant`.
int quadrantOf(Vec2 ball);

/// Whether two commands say the same. Their times may differ.
bool sameCommand(const RefereeCommand& a, const RefereeCommand& b);

}  // namespace fulbito::wire
