// Matches between two teams: the configuration, the match itself, and its observers. Component `match`.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"
#include "fulbito/strategy.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// Counts of one team's commands and decisions that the match's policy corrects or rejects (docs/matches.md).
/// None of them ends a match.
struct TeamFaults {
  std::int64_t not_finite = 0;    ///< robot commands with a NaN or infinity; the robot stops for the tick
  std::int64_t no_navigator = 0;  ///< robot commands for a navigator that the team lacks; the robot stops too
  std::int64_t saturated = 0;     ///< robot commands beyond motors or field, which are clamped; no fault
  std::int64_t late = 0;          ///< decisions beyond their time; the previous one stays in force
  std::int64_t stale = 0;         ///< replies of a team outside the program to requests that no longer wait
  std::int64_t failures = 0;      ///< failures of a team outside the program: see `DecisionTime::failures`
  std::string failure;            ///< the reason of the last failure
  bool forfeited = false;         ///< the team failed too often and lost by walk-over

  /// All rejected commands and decisions.
  std::int64_t rejected() const { return not_finite + no_navigator + late; }
};

/// The faults of a whole match.
struct MatchFaults {
  PerTeam<TeamFaults> teams;  ///< faults of blue and yellow
  /// The error that ended the match early, which then has no result. kMachine: the machine lacked resources
  /// for a team outside the program, so the match may be played again; kBadInput: a restart was not a valid
  /// world.
  std::optional<Error> abandoned;
};

/// The default seed of a match.
inline constexpr std::uint64_t kDefaultMatchSeed = 1;

/// The quality of a team's vision. Each seat (blue, yellow) has its own random numbers. docs/matches.md
/// explains noisy velocities and drop-outs.
using VisionModel = SensorModel;

/// Largest errors of the robots' poses at a restart of the rules. Errors are uniform and come from the
/// match's seed. Without them, deterministic teams play the same match for every seed.
struct PlacementError {
  double position = 0.002;  ///< [m] along x and y, 0 ... 0.01
  double heading = 0.02;    ///< [rad], 0 ... 0.2
};

/// The complete configuration of a match. Equal configurations give equal matches, bit for bit, unless
/// decisions are late (`decision_time`).
struct MatchConfig {
  PerTeam<TeamChoice> teams;               ///< blue defends the left goal at first
  Rules rules;                             ///< rules of the referee
  FieldGeometry field;                     ///< usually the field that the rules name
  RobotPreset robot;                       ///< robots of both teams, and the ball
  PhysicsProfile physics;                  ///< time steps and accuracy of the physics
  PerTeam<VisionModel> vision;             ///< vision of blue and yellow
  PlacementError placement_error;          ///< largest errors of placed robots
  std::uint64_t seed = kDefaultMatchSeed;  ///< seed of all random numbers of the match
  /// Limit of both teams' time, by the clock of `Match::create`. Empty: unlimited, but the rules limit teams
  /// outside the program (`Rules::decision_time`).
  std::optional<DecisionTime> decision_time;
  PerTeam<bool> present{true, true};  ///< false: the team is absent (law 7.3)
  std::optional<Placement> start;     ///< replaces the first kick-off; applied exactly, never repaired
  /// The first restart instead of the kick-off. With a `start`, only its kind and team count; the teams
  /// receive both.
  std::optional<RestartCall> opening;
  Scoreboard scoreboard;  ///< score and time at the start

  /// A match that is ready to play. Teams come from their specifications (`parseTeam`), rules from a preset
  /// or file (`loadRules`). The field is the one that the rules name, the robot preset is `vsss`, the physics
  /// preset is `standard`. Change the result for a special match. Errors: as `parseTeam`, `loadRules` and
  /// `loadField`.
  static Result<MatchConfig> standard(const std::string& blue, const std::string& yellow,
                                      const std::string& rules = "vsss-3v3");
};

/// A placement from which a match starts, with score and time.
struct StartState {
  Placement placement;                        ///< poses of all robots, and the ball
  Scoreboard scoreboard;                      ///< score and clock
  RestartKind restart = RestartKind::kGiven;  ///< what the teams and the referee take the start for
  TeamId team = TeamId::kBlue;                ///< takes that restart
};

/// Reads a start state. Positions are in the world frame; blue defends the goal at -x. Tables:
/// [ball] position (required), velocity; any number of [[robot]] team = "blue" | "yellow", number,
/// position (all required), heading or heading_deg; [match] blue, yellow (score), period, play_seconds,
/// restart (a name of `nameOf(RestartKind)`), team (that takes it).
/// Unlisted robots are not on the field. Errors: kIo; kBadInput as `file:line: table.key ...`.
Result<StartState> loadStartState(const std::string& file);

/// Reads a start state and checks it against a match. The rules allow all robots, all bodies are inside the
/// field without overlap, and the elapsed play time fits into a half. Ignores `match.start`.
Result<StartState> loadStartState(const std::string& file, const MatchConfig& match);

/// Parses a start state from text; `origin` stands for the file name in errors.
Result<StartState> parseStartState(std::string_view text, const std::string& origin);

/// A TOML file that `parseStartState` reads back to the same bits.
std::string toToml(const StartState& start);

/// Lets the match begin from that state: sets its `start`, `opening` and `scoreboard`.
void setStart(MatchConfig& match, const StartState& start);

/// One completed tick of a match, for observers. Views are valid during the call only.
struct MatchTick {
  Tick tick = 0;                            ///< tick of the match, after the step
  std::span<const RobotId> ids;             ///< robots on the field
  std::span<const WheelSpeeds> commands;    ///< applied commands, rounded, in the order of `ids`
  const WorldState* world = nullptr;        ///< state after the step
  std::span<const ContactEvent> contacts;   ///< contacts of this tick
  std::span<const GameEvent> events;        ///< calls of this tick
  const RefereeState* referee = nullptr;    ///< the referee's state after the tick
  PerTeam<const TeamCommand*> decisions{};  ///< decisions in force, each in its team's frame
  /// Drawings of the teams' navigators, each in its team's frame; empty unless an observer `wantsDrawings`.
  PerTeam<std::span<const DebugDrawing>> navigator_drawings{};
  std::uint64_t hash = 0;  ///< running hash of the states of all ticks: `Match::hash`
};

/// The beginning of a play: a new world from a placed state.
struct PlayStart {
  Tick tick = 0;                          ///< tick of the match
  RestartCall call;                       ///< the restart
  Placement placement;                    ///< the placement after repairs
  std::span<const RobotId> ids;           ///< robots of the new world
  const WorldConfig* world = nullptr;     ///< configuration of the new world
  std::span<const GameEvent> events;      ///< events of the restart itself, such as repaired placements
  const RefereeState* referee = nullptr;  ///< the referee's state now
  bool edited = false;                    ///< a user's placement during the match: `Match::replace`
};

/// An observer of a match: a recorder, statistics, an event stream. Observers never affect the result of a
/// match.
class MatchObserver {
 public:
  virtual ~MatchObserver() = default;
  /// Called once, before the first play.
  virtual void onMatchStart(const MatchConfig&) {}
  /// Called for each new world: at the start of the match and after each stoppage.
  virtual void onPlayStart(const PlayStart&) {}
  /// Called after each tick of the match, also while a restart waits for its signal.
  virtual void onTick(const MatchTick&) {}
  /// Called when the match cannot continue after this tick. The event has the time, `Match::faults` the
  /// reason. `onMatchEnd` follows.
  virtual void onAbandoned(const GameEvent&, const RefereeState&) {}
  /// Called once, with the total number of ticks.
  virtual void onMatchEnd(const RefereeState&, Tick) {}
  /// Whether the observer needs the teams' drawings for the step that leads to `tick`. Teams draw only in
  /// such steps.
  virtual bool wantsDrawings(Tick) const { return false; }
};

/// A source of monotonic time [ns]. Libraries read no clock themselves.
using MatchClock = std::function<std::int64_t()>;
/// Called before the step that leads to the given tick; returns when the step may run.
using MatchPace = std::function<void(Tick)>;

/// The phases of a match. Each names the next action of `Match::advance`.
enum class MatchPhase : std::uint8_t {
  kPlacing,  ///< play is stopped or has not begun; next: the team of `Match::asked` proposes its placement
  kPlaced,  ///< both teams have proposed; next: the referee repairs the placement, and the new world is built
  kReady,   ///< the new world exists; next: teams and observers receive the start of the play
  kPlaying,   ///< next: the teams observe the next control tick (`Strategy::ask`)
  kDeciding,  ///< next: the teams decide, and the tick is played
  kEnded,     ///< the match is over; no action follows
};

/// The team that proposes its placement next, and its request.
struct AskedTeam {
  TeamId team = TeamId::kBlue;  ///< the team
  PlacementRequest request;     ///< as the team receives it, in the team's frame
};

/// The wall time of a match, by stage [ns].
struct MatchProfile {
  std::int64_t sense = 0;     ///< the teams' observations
  std::int64_t decide = 0;    ///< the teams' strategies
  std::int64_t navigate = 0;  ///< the teams' navigators, and the policy for commands
  std::int64_t step = 0;      ///< physics and the hash of its state
  std::int64_t referee = 0;   ///< calls, clock, periods
  std::int64_t restart = 0;   ///< placements, and building worlds
  std::int64_t record = 0;    ///< the observers
  std::int64_t ticks = 0;     ///< number of measured ticks

  /// Sum of the times of all stages [ns].
  std::int64_t total() const { return sense + decide + navigate + step + referee + restart + record; }
};

/// The referee's constants for a match of this configuration.
RefereeSetup refereeSetup(const MatchConfig& config);

/// One match: sense, decide, navigate, actuate, step, referee, record, tick by tick.
///
///     auto match = Match::create(config);
///     if (!match) return match.error();
///     match->watch(recorder);
///     while (match->step()) {}
///
/// Between plays a match goes through phases, and a tick has two. A caller that waits for a team in another
/// process, or that chooses a robot's command itself, can do so between two phases. The results are the same:
///
///     while (match->phase() != MatchPhase::kEnded) {
///       if (const auto asked = match->asked()) wait(*asked);
///       match->advance();
///     }
class Match {
 public:
  /// Creates both teams and sends them the `MatchInfo`. Placements follow with the first `step` or `advance`,
  /// so that observers see them.
  /// @param clock  measures decisions if `config.decision_time` limits them; not read otherwise
  /// Errors: kUsage or kBadInput of teams, rules, models, ranges or the start state, or for a limit without a
  /// clock; kMachine if the machine cannot start a team outside the program; kInterrupted.
  static Result<Match> create(const MatchConfig& config, const MatchClock& clock = {});
  /// A moved-from match can only be destroyed or assigned to.
  Match(Match&&) noexcept;
  Match& operator=(Match&&) noexcept;
  ~Match();

  /// Adds an observer, which must outlive the match. Call before the first `step`, `advance` or `makeReady`.
  void watch(MatchObserver& observer);
  /// Measures the time of each stage with extra clock readings. `profile` must outlive the match. Call before
  /// the first `step`.
  void measure(const MatchClock& now, MatchProfile& profile);
  /// Ties ticks to an outside clock: `wait` returns when the next tick may be played. The wait counts neither
  /// as decision time nor in a profile.
  void pace(MatchPace wait);

  /// The present phase: the next action of `advance`.
  MatchPhase phase() const;
  /// In phase kPlacing: the team that is asked next, and its request; otherwise empty.
  std::optional<AskedTeam> asked() const;
  /// Performs the one action that `phase` names and returns the next phase.
  MatchPhase advance();
  /// Advances past all placements: the next phase is kReady, kPlaying or kEnded. Call it to look at the world
  /// before the first step.
  MatchPhase makeReady();
  /// Plays one control tick and advances to the next; false when the match is over. Allocates nothing once
  /// warm, except at restarts.
  bool step();
  /// Ends the match as it stands and informs teams and observers. The last `step` also calls it.
  void finish();

  /// The present poses of all robots, and the ball; no robots before the first placement.
  Placement placement() const;
  /// Between ticks, not in phase kDeciding: play continues from this placement in a new world, as a play of
  /// kind kGiven. Robots are at rest; clock and score stay. Observers receive the new play with the next
  /// tick, so only the last of several replacements between two ticks counts. Errors, which change nothing:
  /// kUsage if the match is over or amid a tick, a placement request is open, or `flawOfEdit`
  /// (match/play/edit.hpp) names a flaw; as `World::create`.
  Result<void> replace(const Placement& placement);
  /// Number of plays that began from a replacement.
  int edits() const;

  /// The configuration given to `create`.
  const MatchConfig& config() const;
  /// The referee's state now: score, clock, the last restart.
  const RefereeState& referee() const;
  /// The state of the world now; without bodies before the first placement.
  const WorldState& world() const;
  /// The robots of the world, in its order.
  std::span<const RobotId> ids() const;
  /// Ticks played so far; never reset.
  Tick tick() const;
  /// [s] simulated so far.
  double seconds() const;
  /// Running hash of the states of all ticks so far.
  std::uint64_t hash() const;
  /// The teams' faults so far.
  MatchFaults faults() const;

 private:
  struct Impl;
  explicit Match(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
