#pragma once

#include <optional>
#include <span>

#include "navigation/registry.hpp"
#include "referee/state/game_event.hpp"
#include "strategies/interface/observation.hpp"
#include "strategies/interface/team_command.hpp"

namespace fulbito {

/// Poses of a team's robots at a restart, in the team's frame; empty: the referee's default stays.
using TeamPlacement = std::array<std::optional<Pose2>, kMaxTeamSize>;

/// What a team wants at a restart, in its own frame. Made from poses alone the ball is left to the rules.
struct TeamProposal {
  TeamProposal() = default;
  TeamProposal(const TeamPlacement& poses) : robots(poses) {}  // NOLINT(google-explicit-constructor)

  TeamPlacement robots;
  /// Where the ball shall lie [m]: at an own goal kick, where the rules leave it free.
  std::optional<Vec2> ball;
};

/// What a team is told when it may propose a placement.
struct PlacementRequest {
  RestartKind kind = RestartKind::kKickOff;
  bool ours = false;  ///< the team takes the restart
  Vec2 ball;  ///< where the ball will lie, team frame; the other team is told where the taker wants it
  TeamPlacement defaults;
  /// Where the other team stands, when the rule lets it place first.
  std::optional<TeamPlacement> opponents;
  /// The call that stopped play, its place in the team's frame; without a clause at the match's beginning.
  GameEvent cause{};
  double delay = 0.0;  ///< [s] from the placement to the signal; 0: play begins at once
  /// How the match stands: tick, period, score, and where all were when play stopped, in the frame of the
  /// play to come. At the match's beginning nobody is present. `restart` and `since_restart` are of the
  /// restart that is asked for.
  Observation now{};
};

/// Play was stopped.
struct PlayStop {
  GameEvent cause;  ///< the call, its place in the team's frame
  Observation now;  ///< as `PlacementRequest::now`, with the score after the call
};

/// The match is over.
struct MatchEnd {
  enum class Reason : std::uint8_t {
    kPlayed,       ///< by the rules
    kAbandoned,    ///< a restart's state was no possible world
    kInterrupted,  ///< by whoever ran it
  };
  Reason reason = Reason::kPlayed;
  GameEvent cause;  ///< the call that ended it, its place in the team's frame; no clause when interrupted
  Tick tick = 0;
  int own_score = 0;
  int opponent_score = 0;
  std::optional<TeamId> winner;  ///< empty after a draw, and of a match that was not played to its end
};

/// A task of a drill, which asks for one skill of the team's first robot instead of a whole game.
struct Exercise {
  enum class Kind : std::uint8_t {
    kReachPose,    ///< come to rest at `target` with `heading`
    kTurn,         ///< turn to `heading` in place
    kReachBall,    ///< be behind the resting ball at `heading`, moving on through it at `speed`
    kPush,         ///< push the ball along `heading` at `speed`
    kPredictBall,  ///< say where the ball will be `horizon` seconds from now (see `answer`)
  };
  Kind kind = Kind::kReachPose;
  Vec2 target;
  double heading = 0.0;  ///< [rad]
  double speed = 0.0;    ///< [m/s]
  double horizon = 0.0;  ///< [s]
};

/// What a team does in an exercise.
struct ExerciseReply {
  TeamCommand command;
  Vec2 answer;  ///< of kPredictBall
};

/// A team. Values in, values out: nothing here needs the team to live in this process. The match calls begin,
/// then for each play: place, ready, decide once a tick, stopped; at last ended. No function keeps references
/// to its argument. `decide` reads no clock, and allocates nothing once warm.
class Strategy {
 public:
  virtual ~Strategy() = default;
  /// A new match begins: forget everything.
  virtual void begin(const MatchInfo& info) = 0;
  /// The navigators that `GoTo::navigator` counts, each robot gets its own of every one.
  virtual std::span<const NavigatorChoice> navigators() const { return {}; }
  /// One decision a control tick.
  virtual TeamCommand decide(const Observation& observation) = 0;
  /// Where the robots shall stand at a restart; the referee repairs what is not allowed.
  virtual std::optional<TeamProposal> place(const PlacementRequest&) { return std::nullopt; }
  /// @{ What happens between the decisions. Nothing in the match depends on what a team does here.
  /// Play was stopped; before the placements of the restart are asked for.
  virtual void stopped(const PlayStop&) {}
  /// All stand at their new places: exactly seen, before the first decision of the play. `since_restart` says
  /// how long the signal takes, `restart` is kGiven after a user's edit.
  virtual void ready(const Observation&) {}
  /// The match is over; nothing follows.
  virtual void ended(const MatchEnd&) {}
  /// @}
  /// One tick of an exercise; empty when the team knows no such skill.
  virtual std::optional<ExerciseReply> exercise(const Observation&, const Exercise&) { return std::nullopt; }
};

}  // namespace fulbito
