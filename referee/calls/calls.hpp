#pragma once

#include "referee/calls/detectors.hpp"

/// What the referee may call, one function per call, each in a file of its own: `detectGoal` in goal.cpp.
namespace fulbito {

/// Law 7.1: the whole ball (or its centre) is past the goal line.
std::optional<Finding> detectGoal(const DetectorInput& input, const TouchMemory& touches);

/// Laws 13 and 14: the ball is stuck. In a goal area: a goal kick where robots of both teams dispute it, else
/// what `StuckRules::undisputed` says; elsewhere a free ball. `keepers` of this tick: the count stands while
/// a keeper has undisputed control.
std::optional<Finding> detectStuckBall(const DetectorInput& input, const KeeperMemory& keepers,
                                       StuckMemory& memory);

/// Law 8.2: more attackers than allowed in the opponents' goal area (or big area), where the rules say so
/// only if one beyond the first takes part: it touched the ball or the keeper within `part_seconds`.
std::optional<AreaFoul> detectAttackers(const DetectorInput& input, const TouchMemory& touches,
                                        const PresenceMemory& presence);

/// Law 8.3: more defenders than allowed in their own goal area (or big area) with the ball inside, where the
/// rules say so only if one beyond the first takes part: it touched the ball or an opponent within
/// `part_seconds`.
std::optional<AreaFoul> detectDefenders(const DetectorInput& input, const TouchMemory& touches,
                                        const PresenceMemory& presence);

/// Laws 8.1 and 13: an opponent charges or blocks the keeper in its goal area. Robot presses on robot (with
/// the ball between them the two do not touch) at a point in the area, the keeper being inside, for
/// `charge_seconds` with `charge_impulse` in all, by an opponent that does not dispute the ball: it has not
/// touched it for `part_seconds`.
std::optional<Finding> detectKeeperCharged(const DetectorInput& input, const TouchMemory& touches,
                                           const PresenceMemory& presence, KeeperMemory& memory);

/// Law 8.1: the keeper keeps the ball. It is in its goal area with the ball there, at most `control_gap` from
/// its body, for `hold_seconds`; breaks up to `release_seconds` do not end the count. An opponent within
/// `dispute_lengths` of the ball challenges: the count begins anew.
std::optional<Finding> detectKeeperHolding(const DetectorInput& input, const PresenceMemory& presence,
                                           KeeperMemory& memory);

/// A robot that does not keep its goal holds the ball: it pins it to a wall. It presses the ball, the ball
/// presses a wall, both hardly move and no opponent disputes it, for longer than `pinned_seconds`. A free
/// kick, in its own goal area a penalty (law 8.1). What the law itself forbids, to hide more than 30 % of the
/// ball (2.2.3), takes a hollow body: a rectangle that the ball cannot enter hides nothing of it.
std::optional<Finding> detectHolding(const DetectorInput& input, const PresenceMemory& presence,
                                     FoulMemory& memory);

/// Law 8.1: an opponent is pushed, away from the ball. The two press on each other, the one pushed moves away
/// from the pusher at `push_speed` or more, for `push_seconds` with `push_impulse` in all, both centres are
/// farther than `push_distance` from the ball, and neither touched it for `part_seconds`.
std::optional<Finding> detectPush(const DetectorInput& input, const TouchMemory& touches, FoulMemory& memory);

}  // namespace fulbito
