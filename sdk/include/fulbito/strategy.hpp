// Teams: what a team sees and decides, and the built-in teams by name. A team of your own implements
// `Strategy`. Component `strategy`.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/models.hpp"
#include "fulbito/navigation.hpp"
#include "fulbito/referee.hpp"
#include "fulbito/values.hpp"

namespace fulbito {

/// How long a team may think, in wall time. What a decision takes beyond `decision` is paid from the bank;
/// when the bank cannot pay, the decision is late: it is not carried out, and the one before holds. A match
/// with such a limit depends on the speed of the machine; only its recording repeats it.
struct DecisionTime {
  double decision = 0.02;  ///< [s] that every decision may take, 0 ... 60
  double bank = 2.0;       ///< [s] beyond it, in all, in each period, 0 ... 3600
  /// Late decisions in a row for which the last command holds, 0 ... 3600; from the next one on the robots
  /// stand. Half a second at 60 Hz: about what the radio of a real robot waits before it stops the motors.
  int held = 30;
};

/// A place to drive to, in the team's frame. The navigation stage plans the way among the other robots.
struct GoTo {
  Vec2 position;                  ///< [m] where its centre shall get to
  std::optional<double> heading;  ///< [rad] wanted on arrival
  bool stop = false;              ///< come to rest there; otherwise pass at speed
  double speed_limit = std::numeric_limits<double>::infinity();  ///< [m/s]
  bool avoid_ball = false;                                       ///< the ball is an obstacle too
  bool avoid_mates = true;                                       ///< the own robots are obstacles
  bool avoid_opponents = true;                                   ///< the opponents are obstacles
  double tolerance = 0.03;                                       ///< [m]
  /// Either end of the robot may lead; `heading` is the direction of travel. False: the front leads.
  bool either_front = true;
  std::uint8_t navigator = 0;  ///< which of the strategy's navigators drives
};

/// What one robot shall do until the next decision.
struct RobotCommand {
  /// In which form the command is given.
  enum class Kind : std::uint8_t {
    kWheels,  ///< `wheels` as they are
    kTwist,   ///< `twist`, limited so that the robot can always steer
    kGoTo     ///< `go_to` by a navigator
  };
  Kind kind = Kind::kWheels;  ///< which of the members below counts
  WheelSpeeds wheels;         ///< [rad/s]
  Twist twist;                ///< of kTwist
  GoTo go_to;                 ///< of kGoTo

  /// Wheel speeds [rad/s] as they are.
  static RobotCommand byWheels(WheelSpeeds wheels) { return {Kind::kWheels, wheels, {}, {}}; }
  /// A forward speed and a yaw rate.
  static RobotCommand byTwist(Twist twist) { return {Kind::kTwist, {}, twist, {}}; }
  /// A place to drive to.
  static RobotCommand drivingTo(GoTo go_to) { return {Kind::kGoTo, {}, {}, go_to}; }
};

/// Something that a strategy wants to show a viewer, in the team's frame.
struct DebugDrawing {
  /// What is drawn.
  enum class Kind : std::uint8_t { kLine, kCircle, kText };
  Kind kind = Kind::kLine;  ///< what is drawn
  Vec2 from;                ///< centre of a circle or a text
  Vec2 to;                  ///< end of a line
  double radius = 0.0;      ///< [m] of a circle
  std::string text;         ///< of kText
};

/// A team's decision for one tick: a plain value.
struct TeamCommand {
  std::array<RobotCommand, kMaxTeamSize>
      robots;  ///< by the robots' numbers; those of absent robots count for nothing
  /// Left empty unless `Observation::wants_drawings`; nothing in a match depends on it.
  std::vector<DebugDrawing> drawings;
  /// What each robot plays, as the team numbers its roles from 1; 0: not told. Nothing in a match depends on
  /// it: drills count how often roles change hands.
  std::array<std::uint8_t, kMaxTeamSize> roles{};
};

/// What a team knows before the match. Plain values: what a team in another process would be sent.
struct MatchInfo {
  TeamId team = TeamId::kBlue;                ///< the colour that it plays in, and so its seat
  Side side = Side::kLeft;                    ///< the goal that it defends when the match begins
  FieldGeometry field;                        ///< that the match is played on
  RobotModel robot;                           ///< of both teams
  BallModel ball;                             ///< as the preset has it
  PhysicsProfile physics;                     ///< how finely time is stepped
  Rules rules;                                ///< team size, length of the periods, and what is called
  double observation_age = 0.0;               ///< [s] nominal age of every observation
  double position_noise = 0.0;                ///< [m] standard deviation of observed positions
  double heading_noise = 0.0;                 ///< [rad] standard deviation of observed headings
  double dropout = 0.0;                       ///< chance that a body is not seen in a tick
  std::optional<DecisionTime> decision_time;  ///< how long it may think; empty: as long as it likes
  std::uint64_t seed = 0;                     ///< for the team's own random stream

  /// [s] Control period: one decision for each.
  double dt() const { return physics.controlPeriod(); }
};

/// A robot as the team sees it.
struct ObservedRobot {
  bool present = false;  ///< false: not on the field (sent off, or fewer robots play)
  RobotState state;      ///< team frame; an opponent's wheels are not observed and stay 0
};

/// All that a team may know at one control tick: a plain value in the team's frame (own goal at -x).
struct Observation {
  Tick tick = 0;                                      ///< of the picture; never reset during a match
  double dt = 1.0 / 60.0;                             ///< [s] control period
  int team_size = 3;                                  ///< robots of each team, present or not
  std::array<ObservedRobot, kMaxTeamSize> own;        ///< by their numbers
  std::array<ObservedRobot, kMaxTeamSize> opponents;  ///< by their numbers
  BallState ball;                                     ///< spin is not observed and stays 0
  /// What the own robots were told in the tick before, whatever the picture's age [rad/s]; 0 at a restart.
  std::array<WheelSpeeds, kMaxTeamSize> sent;
  bool playing = true;                          ///< false while a restart waits for its signal
  RestartKind restart = RestartKind::kKickOff;  ///< how the present play was begun
  bool restart_is_ours = false;                 ///< the team takes it (a free ball: it attacks that half)
  double since_restart = 0.0;                   ///< [s] of play; negative before the signal
  int period = 1;                               ///< 1, 2: halves; 3: overtime; 4: shoot-out
  double remaining = 0.0;                       ///< [s] of play left in the period
  int own_score = 0;                            ///< goals of the team
  int opponent_score = 0;                       ///< goals against it
  bool wants_drawings = false;                  ///< debug drawings of this tick will be kept
};

/// Poses of a team's robots at a restart, in the team's frame; empty: the referee's default stays.
using TeamPlacement = std::array<std::optional<Pose2>, kMaxTeamSize>;

/// What a team wants at a restart, in its own frame. Made from poses alone the ball is left to the rules.
struct TeamProposal {
  /// Nothing proposed: all stays as the rules have it.
  TeamProposal() = default;
  TeamProposal(const TeamPlacement& poses) : robots(poses) {}  // NOLINT(google-explicit-constructor)

  TeamPlacement robots;  ///< by their numbers
  /// Where the ball shall lie [m]: at an own goal kick, where the rules leave it free.
  std::optional<Vec2> ball;
};

/// What a team is told when it may propose a placement.
struct PlacementRequest {
  RestartKind kind = RestartKind::kKickOff;  ///< how play will begin
  bool ours = false;                         ///< the team takes the restart
  Vec2 ball;  ///< where the ball will lie, team frame; the other team is told where the taker wants it
  TeamPlacement defaults;  ///< the rules' own places
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
  GameEvent cause;    ///< the call that ended it, its place in the team's frame; no clause when interrupted
  Tick tick = 0;      ///< of the match
  int own_score = 0;  ///< goals of the team
  int opponent_score = 0;        ///< goals against it
  std::optional<TeamId> winner;  ///< empty after a draw, and of a match that was not played to its end
};

/// A task of a drill, which asks for one skill of the team's first robot instead of a whole game.
struct Exercise {
  /// What is asked for.
  enum class Kind : std::uint8_t {
    kReachPose,    ///< come to rest at `target` with `heading`
    kTurn,         ///< turn to `heading` in place
    kReachBall,    ///< be behind the resting ball at `heading`, moving on through it at `speed`
    kPush,         ///< push the ball along `heading` at `speed`
    kPredictBall,  ///< say where the ball will be `horizon` seconds from now (see `answer`)
  };
  Kind kind = Kind::kReachPose;  ///< which of the members below count
  Vec2 target;                   ///< [m] of kReachPose
  double heading = 0.0;          ///< [rad]
  double speed = 0.0;            ///< [m/s]
  double horizon = 0.0;          ///< [s]
};

/// What a team does in an exercise.
struct ExerciseReply {
  TeamCommand command;  ///< what its robot does
  Vec2 answer;          ///< of kPredictBall
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

/// What a catalogue knows of one kind of team, built in or a user's own.
struct TeamInfo {
  std::string name;                       ///< as in specifications
  std::string summary;                    ///< one line
  std::vector<ParameterSpec> parameters;  ///< its own
  bool takes_navigator = false;           ///< also takes `navigator=NAME`
  std::string default_navigator;          ///< where none is named; empty when the team takes none
  /// Makes the team from settings (`navigator` among them); errors: kUsage.
  std::function<Result<std::unique_ptr<Strategy>>(const std::vector<Setting>&)> make;
};

/// A team and its settings: what a seat of a match is given. The entry lives as long as any choice of it.
struct TeamChoice {
  std::shared_ptr<const TeamInfo> info;
  std::string text;               ///< the specification, as recordings and reports name the team
  std::vector<Setting> settings;  ///< the specification's, taken apart

  /// A team of one's own, without a catalogue. `make` gives a fresh one for every match, also from several
  /// threads at once.
  static TeamChoice own(std::string name, std::function<std::unique_ptr<Strategy>()> make);
};

/// The teams that a specification may name: a value. Copies share their entries, which never change.
class TeamCatalogue {
 public:
  /// All built-in teams, in the order in which tables list them.
  static TeamCatalogue builtIn();

  /// Adds a team at the end. Errors: kUsage when the name is empty, taken, or has a ':' or ',' in it, and
  /// when the entry makes no team.
  Result<void> add(TeamInfo info);
  const std::vector<std::shared_ptr<const TeamInfo>>& teams() const& { return teams_; }
  /// Of a temporary: moved out, so that a loop over `builtIn().teams()` is safe.
  std::vector<std::shared_ptr<const TeamInfo>> teams() && { return std::move(teams_); }

  /// Takes a specification such as `libero:navigator=bezier,aggression=0.7` apart and checks it. A
  /// navigator's own parameters follow with `+`: `classic:navigator=bezier:clearance=0.03+follower=classic`.
  /// Errors: kUsage naming the unknown team, parameter or navigator, with a suggestion, or the allowed range.
  Result<TeamChoice> parse(const std::string& specification) const;

 private:
  std::vector<std::shared_ptr<const TeamInfo>> teams_;
};

/// `TeamCatalogue::parse` of the built-in teams.
Result<TeamChoice> parseTeam(const std::string& specification);

/// A fresh team for the choice. Errors: kUsage.
Result<std::unique_ptr<Strategy>> makeTeam(const TeamChoice& choice);

}  // namespace fulbito
