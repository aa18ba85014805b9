// Teams: observations, decisions, and the built-in teams by name. A team of your own implements `Strategy`.
// Component `strategy`.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fulbito/detail/decision_time.hpp"
#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"
#include "fulbito/navigation.hpp"
#include "fulbito/referee.hpp"

namespace fulbito {

/// A place to drive to, in the team's frame. The navigation stage plans the path among the other robots.
struct GoTo {
  Vec2 position;                  ///< [m] target of the robot's centre
  std::optional<double> heading;  ///< [rad] on arrival; empty: any
  bool stop = false;              ///< stop at the target; otherwise pass it at speed
  double speed_limit = std::numeric_limits<double>::infinity();  ///< [m/s] largest speed
  bool avoid_ball = false;                                       ///< the ball is an obstacle too
  bool avoid_mates = true;                                       ///< the team's own robots are obstacles
  bool avoid_opponents = true;                                   ///< the opponents are obstacles
  double tolerance = 0.03;                                       ///< [m] distance that counts as arrival
  /// True: either end of the robot may lead, and `heading` is the direction of travel. False: the front
  /// leads.
  bool either_front = true;
  std::uint8_t navigator = 0;  ///< index in `Strategy::navigators`
};

/// One robot's command until the next decision.
struct RobotCommand {
  /// The form of a command.
  enum class Kind : std::uint8_t {
    kWheels,  ///< `wheels` as given
    kTwist,   ///< `twist`, limited so that the robot can always steer
    kGoTo     ///< `go_to` by a navigator
  };
  Kind kind = Kind::kWheels;  ///< selects one of the members below
  WheelSpeeds wheels;         ///< [rad/s] for kWheels
  Twist twist;                ///< for kTwist
  GoTo go_to;                 ///< for kGoTo

  /// Wheel speeds [rad/s] as given.
  static RobotCommand byWheels(WheelSpeeds wheels) { return {Kind::kWheels, wheels, {}, {}}; }
  /// A forward speed and a yaw rate.
  static RobotCommand byTwist(Twist twist) { return {Kind::kTwist, {}, twist, {}}; }
  /// A place to drive to.
  static RobotCommand drivingTo(GoTo go_to) { return {Kind::kGoTo, {}, {}, go_to}; }
};

/// A drawing of a strategy's intentions for viewers, in the team's frame.
struct DebugDrawing {
  /// The kinds of drawings.
  enum class Kind : std::uint8_t { kLine, kCircle, kText };
  Kind kind = Kind::kLine;  ///< line, circle or text
  Vec2 from;                ///< [m] start of a line; centre of a circle or a text
  Vec2 to;                  ///< [m] end of a line
  double radius = 0.0;      ///< [m] of a circle
  std::string text;         ///< for kText
};

/// A team's decision for one tick: a plain value.
struct TeamCommand {
  std::array<RobotCommand, kMaxTeamSize> robots;  ///< by robot number; commands of absent robots are ignored
  /// Empty unless `Observation::wants_drawings`. Drawings do not affect the match.
  std::vector<DebugDrawing> drawings;
  /// Role of each robot: a number from 1 that the team chooses; 0: unknown. Roles do not affect the match;
  /// drills count how often they change hands.
  std::array<std::uint8_t, kMaxTeamSize> roles{};
};

/// A team's knowledge before the match. Plain values, so that a team in another process can receive them.
struct MatchInfo {
  TeamId team = TeamId::kBlue;                ///< the team's colour, and so its seat
  Side side = Side::kLeft;                    ///< the goal that it defends at the start of the match
  FieldGeometry field;                        ///< field of the match
  RobotModel robot;                           ///< robots of both teams
  BallModel ball;                             ///< ball of the match
  PhysicsProfile physics;                     ///< time steps and accuracy of the physics
  Rules rules;                                ///< team size, length of the periods, and the calls
  double observation_age = 0.0;               ///< [s] nominal age of each observation
  double position_noise = 0.0;                ///< [m] standard deviation of observed positions
  double heading_noise = 0.0;                 ///< [rad] standard deviation of observed headings
  double dropout = 0.0;                       ///< probability per tick that a body is not seen
  std::optional<DecisionTime> decision_time;  ///< limit of its decision time; empty: unlimited
  std::uint64_t seed = 0;                     ///< for the team's own random stream

  /// [s] Control period, with one decision per period.
  double dt() const { return physics.controlPeriod(); }
};

/// A robot as the team sees it.
struct ObservedRobot {
  bool present = false;  ///< false: not on the field (sent off, or the team has fewer robots)
  RobotState state;      ///< team frame; an opponent's wheels are not observed and stay 0
};

// clang-format off: generated by sdk/values/generate.py: of-simulator Observation
/// A team's knowledge at one control tick, in its own frame.
struct Observation {
  Tick tick = 0;                                      ///< tick of the match that it shows; never reset
  double dt = 1.0 / 60.0;                             ///< [s] control period
  int period = 1;                                     ///< 1, 2: halves; 3: overtime; 4: shoot-out
  int overtime_part = 0;                              ///< part of overtime: 1, 2 ...; 0 outside overtime
  /// [s] play left in the period, or in the part of overtime
  double remaining = 0.0;
  bool playing = true;                                ///< play is on, and no restart waits for its signal
  RestartKind restart = RestartKind::kKickOff;        ///< the restart that began the present play
  /// the team takes it (a free ball: it attacks that half)
  bool restart_is_ours = false;
  double since_restart = 0.0;                         ///< [s] play since the signal; negative before it
  int own_score = 0;                                  ///< goals of the team
  int opponent_score = 0;                             ///< goals against it
  /// goals ahead in the shoot-out, which the score does not count; negative: behind
  int shoot_out_lead = 0;
  bool wants_drawings = false;                        ///< an observer keeps the drawings of this tick
  BallState ball;                                     ///< the ball, without its spin
  int team_size = 3;                                  ///< robots per team, present or not: 1 ... 11
  std::array<ObservedRobot, kMaxTeamSize> own;        ///< the team's robots, by number
  std::array<ObservedRobot, kMaxTeamSize> opponents;  ///< the other team's robots, by number
  /// [rad/s] commands applied to the team's robots in the previous tick, however old the observation; 0 at a
  /// restart
  std::array<WheelSpeeds, kMaxTeamSize> sent;
};
// clang-format on: end of what is generated

/// Poses of a team's robots at a restart, in the team's frame; empty: the referee's default stays.
using TeamPlacement = std::array<std::optional<Pose2>, kMaxTeamSize>;

/// A team's wishes at a restart, in its own frame. Without a `ball`, the rules place the ball.
struct TeamProposal {
  /// No wishes: the placement of the rules stays.
  TeamProposal() = default;
  /// Poses only; the rules place the ball.
  TeamProposal(const TeamPlacement& poses) : robots(poses) {}  // NOLINT(google-explicit-constructor)

  TeamPlacement robots;  ///< poses by robot number
  /// [m] Ball position, for the team's own goal kick if the rules leave it free.
  std::optional<Vec2> ball;
};

/// The request for a team's placement at a restart.
struct PlacementRequest {
  RestartKind kind = RestartKind::kKickOff;  ///< the kind of restart
  bool ours = false;                         ///< the team takes the restart
  Vec2 ball;               ///< [m] ball position, team frame; for the other team, after the taker's choice
  TeamPlacement defaults;  ///< placement by the rules
  /// The other team's placement, if the rule lets it place first.
  std::optional<TeamPlacement> opponents;
  /// The call that stopped play, with its place in the team's frame; without a clause at the start of the
  /// match.
  GameEvent cause{};
  double delay = 0.0;  ///< [s] from the placement to the signal; 0: play begins at once
  /// The state of the match: tick, period, score, and all poses when play stopped, in the frame of the next
  /// play. No robots are present at the start of the match. `restart` and `since_restart` belong to the
  /// requested restart.
  Observation now{};
};

/// The notice that play is stopped.
struct PlayStop {
  GameEvent cause;  ///< the call, with its place in the team's frame
  Observation now;  ///< as `PlacementRequest::now`, with the score after the call
};

/// The notice that the match is over.
struct MatchEnd {
  /// Why a match ends.
  enum class Reason : std::uint8_t {
    kPlayed,       ///< its regular end by the rules
    kAbandoned,    ///< it cannot go on: the machine failed, or a restart was not a valid world
    kInterrupted,  ///< the caller ended it
  };
  Reason reason = Reason::kPlayed;  ///< why this match ends
  GameEvent cause;  ///< the call that ended it, with its place in the team's frame; no clause if interrupted
  Tick tick = 0;    ///< last tick of the match
  int own_score = 0;             ///< goals of the team
  int opponent_score = 0;        ///< goals against it
  std::optional<TeamId> winner;  ///< empty after a draw or an unfinished match
};

/// A task of a drill: one skill of the team's first robot instead of a whole match.
struct Exercise {
  /// The kinds of tasks.
  enum class Kind : std::uint8_t {
    kReachPose,    ///< stop at `target` with `heading`
    kTurn,         ///< turn to `heading` in place
    kReachBall,    ///< be behind the resting ball at `heading`, moving on through it at `speed`
    kPush,         ///< push the ball along `heading` at `speed`
    kPredictBall,  ///< predict the ball's position `horizon` seconds from now (see `answer`)
  };
  Kind kind = Kind::kReachPose;  ///< selects the members below
  Vec2 target;                   ///< [m] for kReachPose
  double heading = 0.0;          ///< [rad]
  double speed = 0.0;            ///< [m/s]
  double horizon = 0.0;          ///< [s] for kPredictBall
};

/// A team's reply in an exercise.
struct ExerciseReply {
  TeamCommand command;  ///< command of its robot
  Vec2 answer;          ///< [m] predicted ball position, for kPredictBall
};

/// The condition of a team after a call. Teams that are no files or programs are always well.
struct TeamCondition {
  /// Whether the last call has an answer.
  enum class State : std::uint8_t {
    kWell,  ///< there is an answer
    kLate,  ///< no answer within the allowed time
    kDown,  ///< the team failed and starts again
    kLost,  ///< the team failed too often: it forfeits
    kCut,   ///< the machine failed, not the team: the match cannot go on
  };
  State state = State::kWell;     ///< the answer of the last call
  bool stands = false;            ///< a late decision counts all the same: commands of the team stay in force
  std::optional<double> seconds;  ///< [s] wall time of that call; empty: the caller measures it
  int failures = 0;               ///< failures so far: ends of its program, broken messages, late starts
  std::int64_t stale = 0;         ///< replies so far to requests that no longer wait; they are ignored
  std::string reason;             ///< reason of the last failure, such as "signal 11 (Segmentation fault)"
};

/// A team. Arguments and results are plain values, so a team may run in another process. The match calls
/// `begin` first and `ended` last. For each play it calls `place`, `ready`, `decide` once per tick, and
/// `stopped`. No function keeps references to its argument. `decide` reads no clock and allocates nothing
/// once warm.
class Strategy {
 public:
  virtual ~Strategy() = default;
  /// A new match begins: reset all memory.
  virtual void begin(const MatchInfo& info) = 0;
  /// The navigators that `GoTo::navigator` indexes. Each robot has its own instance of each.
  virtual std::span<const NavigatorChoice> navigators() const { return {}; }
  /// The decision for one control tick; called once per tick.
  virtual TeamCommand decide(const Observation& observation) = 0;
  /// @{ For a team in another process.
  /// Wall time that the next `ask` and `decide`, `place` or `exercise` may take [s]; infinite: unlimited.
  virtual void allow(double) {}
  /// Both teams are asked before either decides, so that they think at the same time. `decide` follows with
  /// the same observation.
  virtual void ask(const Observation&) {}
  /// The condition after the last call.
  virtual const TeamCondition& condition() const;
  /// Where the team comes from, for recordings: `version`, `hash`, `containment` ... Fixed after `begin`.
  virtual std::vector<Setting> origin() const { return {}; }
  /// @}
  /// The team's placement at a restart; empty: no wishes. The referee repairs poses that are not allowed.
  virtual std::optional<TeamProposal> place(const PlacementRequest&) { return std::nullopt; }
  /// @{ Notices between decisions. They do not affect the match.
  /// Play is stopped. Called before the placement requests of the restart.
  virtual void stopped(const PlayStop&) {}
  /// The new play is placed. Called before its first decision, with exact poses. `-since_restart` is the time
  /// to the signal; `restart` is kGiven after a user's edit.
  virtual void ready(const Observation&) {}
  /// The match is over; no call follows.
  virtual void ended(const MatchEnd&) {}
  /// @}
  /// One tick of an exercise; empty if the team lacks the skill.
  virtual std::optional<ExerciseReply> exercise(const Observation&, const Exercise&) { return std::nullopt; }
};

/// A skill of a team's play book. The setting `without=NAME+NAME` leaves skills out, to measure what they are
/// worth.
struct SkillInfo {
  std::string role;     ///< whose table it is in: "keeper", "striker" ...
  std::string name;     ///< as in `without`
  std::string summary;  ///< one line: "when it is used: what the robot does"
};

/// The entry of one kind of team in a catalogue, built in or a user's own.
struct TeamInfo {
  std::string name;                       ///< as in specifications
  std::string summary;                    ///< one line
  std::vector<ParameterSpec> parameters;  ///< the team's own parameters
  bool takes_navigator = false;           ///< also takes `navigator=NAME`
  std::string default_navigator;          ///< default of `navigator`; empty if the team takes none
  /// Creates the team from settings, `navigator` included. Errors: kUsage.
  std::function<Result<std::unique_ptr<Strategy>>(const std::vector<Setting>&)> make;
  bool outside = false;  ///< a file or a program: the rules limit its time unless the match does
  /// The play book: role by role, in the order of priority. Empty: the team has none and takes no `without`.
  std::vector<SkillInfo> skills = {};
  /// What a sparring team is for. "training": other teams are tuned against it. "validation": they are judged
  /// against it, but never tuned. Empty: it is no sparring team.
  std::string purpose = {};
};

/// A team and its settings, for a seat of a match. The entry lives as long as any choice of it.
struct TeamChoice {
  std::shared_ptr<const TeamInfo> info;  ///< the catalogue's entry
  std::string text;                      ///< the specification: the team's name in recordings and reports
  std::vector<Setting> settings;         ///< the settings of the specification
  std::vector<Setting> origin;           ///< `Strategy::origin`, in the configuration of a created match

  /// A user's own team, without a catalogue. `make` creates a new one for each match, also from several
  /// threads at once.
  static TeamChoice own(std::string name, std::function<std::unique_ptr<Strategy>()> make);
};

/// The teams that a specification may name: a value. Copies share their entries, which never change.
class TeamCatalogue {
 public:
  /// All built-in teams, in the order in which tables list them.
  static TeamCatalogue builtIn();

  /// Adds a team at the end. Errors: kUsage if the name is empty, taken or contains ':' or ',', or if the
  /// entry has no `make`.
  Result<void> add(TeamInfo info);
  /// The entries, in order.
  const std::vector<std::shared_ptr<const TeamInfo>>& teams() const& { return teams_; }
  /// The entries of a temporary, moved out, so that a loop over `builtIn().teams()` is safe.
  std::vector<std::shared_ptr<const TeamInfo>> teams() && { return std::move(teams_); }

  /// A source of teams that are no entries, such as files. Empty: the specification is not for this source.
  using Source = std::function<std::optional<Result<TeamChoice>>(const std::string& specification)>;
  /// Adds a source. `parse` asks the sources in order before it looks for a name.
  void addSource(Source source) { sources_.push_back(std::move(source)); }

  /// Parses and checks a specification such as `libero:navigator=bezier,aggression=0.7`. A navigator's own
  /// parameters follow with `+`: `classic:navigator=bezier:clearance=0.03+follower=classic`. Errors: kUsage
  /// naming the unknown team, parameter or navigator, with a suggestion, or the allowed range.
  Result<TeamChoice> parse(const std::string& specification) const;

 private:
  std::vector<std::shared_ptr<const TeamInfo>> teams_;
  std::vector<Source> sources_;
};

/// `TeamCatalogue::parse` of the built-in teams.
Result<TeamChoice> parseTeam(const std::string& specification);

/// Creates a new team from a choice. Errors: kUsage.
Result<std::unique_ptr<Strategy>> makeTeam(const TeamChoice& choice);

}  // namespace fulbito
