#pragma once

#include <functional>

#include "tests/second_referee/moment.hpp"

/// The laws, each read once more: from docs/rules.md and the profile, not from `referee/`.
namespace fulbito::second {

/// @{ What the laws have in common: who touches, who is near, who keeps. Robots by index of `players`.
bool isPlayer(const Moment& moment, BodyId body);
bool touchesBall(const Moment& moment, std::size_t robot);
/// The first moment of the play that is at most so many ticks before moment `at`.
std::size_t ticksBefore(std::size_t at, Tick ticks);
/// In this tick or at most so many seconds before it.
bool touchedBall(const Play& play, std::size_t at, std::size_t robot, double seconds);
/// A robot of the team has its centre within so many robot lengths of the ball.
bool nearBall(const Play& play, const Moment& moment, TeamId team, double lengths);
/// The robot is its team's keeper and inside its own goal area.
bool keepsGoal(const Play& play, const Moment& moment, std::size_t robot);
/// The robot is in the goal area at this end; in the big one.
bool inGoalArea(const Moment& moment, std::size_t robot, int end);
bool inBigArea(const Moment& moment, std::size_t robot, int end);

/// How one tick counts for something that lasts.
enum class Beat { kYes, kPause, kEnd };
/// Something that has lasted up to now, with breaks of at most `release` ticks. `beat(i)`: how tick i of the
/// play counts.
Tick lasted(const Play& play, Tick release, const std::function<Beat(std::size_t)>& beat);
/// @}

/// Whether as much of the body as counts is in the area of the goal at this end.
bool bodyIn(const Marking& area, const Play& play, const Pose2& pose, int end, BodyPart part);

/// Fills in what follows from the moments before: who is inside since when, keepers, excuses, waiting fouls,
/// the standstill.
void noteAreas(Play& play);
void noteCrowds(Play& play);
void noteStandstill(Play& play);

/// @{ Each law's own call in this tick.
std::optional<Call> goal(const Play& play);           // 7.1, voided by 8.2
std::optional<Call> areaFoul(const Play& play);       // 8.2, 8.3
std::optional<Call> keeperCharged(const Play& play);  // 8.1, 13
std::optional<Call> keeperHolds(const Play& play);    // 8.1
std::optional<Call> pinnedToWall(const Play& play);   // 8.1
std::optional<Call> pushedAway(const Play& play);     // 8.1
std::optional<Call> stuckBall(const Play& play);      // 13, 14
/// @}

/// Of a kick of the shoot-out (7.2): a value once it is over, whether it is a goal.
std::optional<bool> kickOver(const Play& play);

/// The keeper of the team in whose area the ball is has it for itself: law 8.1's undisputed control. kPause:
/// it has lost the ball, and nothing has ended its count.
Beat undisputedControl(const Play& play, std::size_t at);
/// The attackers' foul waits at this end, and the defenders' does not count before it.
bool attackCounts(const Play& play, int end);
/// The call of the attackers' waiting foul.
Call attackersCall(const Play& play);

}  // namespace fulbito::second
