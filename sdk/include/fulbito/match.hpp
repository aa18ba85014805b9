// Matches between two teams: what one is made from, how it is played, who may watch it. Component `match`.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"
#include "fulbito/strategy.hpp"
#include "fulbito/values.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// What one team did that the match's policy had to answer (docs/matches.md). Nothing here ends a match.
struct TeamFaults {
  std::int64_t not_finite = 0;  ///< robots' commands with a NaN or infinity: that robot stopped for the tick
  std::int64_t no_navigator = 0;  ///< robots' commands by a navigator that the team lacks: stopped as well
  std::int64_t saturated = 0;     ///< robots' commands beyond motors or field, which were cut: no fault
  std::int64_t late = 0;          ///< decisions beyond `MatchConfig::decision_time`: the one before held

  /// All commands and decisions that were not carried out.
  std::int64_t rejected() const { return not_finite + no_navigator + late; }
};

/// The faults of a whole match.
struct MatchFaults {
  PerTeam<TeamFaults> teams;  ///< of blue and yellow
  /// Why the match could not go on: a restart's state was no possible world. It ended there, unfinished.
  std::optional<Error> abandoned;
};

/// Seed that is used where none is given.
inline constexpr std::uint64_t kDefaultMatchSeed = 1;

/// How well a team sees. Every seat (blue, yellow) has random numbers of its own. How noise makes velocities
/// uncertain, and what a drop-out does: docs/matches.md.
using VisionModel = SensorModel;

/// How exactly robots stand at a restart of the rules: uniform errors up to these, drawn from the match's
/// seed. Without them, teams that draw no numbers would play the same match whatever the seed.
struct PlacementError {
  double position = 0.002;  ///< [m] along x and y, 0 ... 0.01
  double heading = 0.02;    ///< [rad], 0 ... 0.2
};

/// Everything a match is made from. Equal configurations give equal matches, bit for bit, unless decisions
/// come too late (`decision_time`).
struct MatchConfig {
  PerTeam<TeamChoice> teams;               ///< blue defends the left goal at first
  Rules rules;                             ///< by which it is played
  FieldGeometry field;                     ///< usually the one that the rules name
  RobotPreset robot;                       ///< of both teams, and the ball
  PhysicsProfile physics;                  ///< how finely time is stepped
  PerTeam<VisionModel> vision;             ///< how the teams see
  PlacementError placement_error;          ///< how exactly robots are placed
  std::uint64_t seed = kDefaultMatchSeed;  ///< of all random numbers of the match
  /// How long the teams may think by the clock of `Match::create`; empty: as long as they like.
  std::optional<DecisionTime> decision_time;
  PerTeam<bool> present{true, true};  ///< false: the team did not come (law 7.3)
  std::optional<Placement> start;     ///< instead of the first kick-off; taken exactly, never repaired
  /// The first restart instead of the kick-off. With a `start`, only its kind and team count, and are told.
  std::optional<RestartCall> opening;
  Scoreboard scoreboard;  ///< how the match stands at its beginning

  /// A match that can be played as it is: teams by their specifications (`parseTeam`), rules by preset or
  /// file
  /// (`loadRules`), the field that these name, the robot preset `vsss`, the physics preset `standard`. What
  /// is special about a match is set in the result. Errors: as those functions and `loadField`.
  static Result<MatchConfig> standard(const std::string& blue, const std::string& yellow,
                                      const std::string& rules = "vsss-3v3");
};

/// A placement from which a match starts, with score and time.
struct StartState {
  Placement placement;    ///< where all stand
  Scoreboard scoreboard;  ///< score and clock
};

/// Reads a start state. Tables, all positions in the world's frame (blue defends the goal at -x):
/// [ball] position (required), velocity; any number of [[robot]] team = "blue" | "yellow", number,
/// position (all required), heading or heading_deg; [match] blue, yellow (score), period, play_seconds.
/// Robots that are not listed are not on the field. Errors: kIo; kBadInput as `file:line: table.key ...`.
Result<StartState> loadStartState(const std::string& file);

/// The same, checked against a match: its rules have all robots, all bodies are inside the field without
/// overlap, and the elapsed play time fits into a half. Ignores `match.start`.
Result<StartState> loadStartState(const std::string& file, const MatchConfig& match);

/// The same from text; `origin` stands for the file name in errors.
Result<StartState> parseStartState(std::string_view text, const std::string& origin);

/// A TOML file that `parseStartState` reads back to the same bits.
std::string toToml(const StartState& start);

/// One tick of play as it happened. Views stay valid during the call only.
struct MatchTick {
  Tick tick = 0;                            ///< of the match, after the step
  std::span<const RobotId> ids;             ///< of the robots on the field
  std::span<const WheelSpeeds> commands;    ///< that were applied, rounded, in the order of `ids`
  const WorldState* world = nullptr;        ///< after the step
  std::span<const ContactEvent> contacts;   ///< of this tick
  std::span<const GameEvent> events;        ///< of this tick
  const RefereeState* referee = nullptr;    ///< what the referee knows after the tick
  PerTeam<const TeamCommand*> decisions{};  ///< that were carried out, each in its team's frame
  /// What the teams' navigators wanted, as their decisions; empty unless somebody `wantsDrawings`.
  PerTeam<std::span<const DebugDrawing>> navigator_drawings{};
  std::uint64_t hash = 0;  ///< over the states of all ticks so far: `Match::hash`
};

/// The beginning of a play: a new world from a placed state.
struct PlayStart {
  Tick tick = 0;                          ///< of the match
  RestartCall call;                       ///< how play begins
  Placement placement;                    ///< where all stand after repairs
  std::span<const RobotId> ids;           ///< of the world's robots
  const WorldConfig* world = nullptr;     ///< what the new world is made from
  std::span<const GameEvent> events;      ///< of the restart itself, such as repaired placements
  const RefereeState* referee = nullptr;  ///< what the referee knows now
  bool edited = false;                    ///< placed by a user in the middle of the match: `Match::replace`
};

/// Something that watches a match: a recorder, statistics, an event stream. The match's result never depends
/// on who watches.
class MatchObserver {
 public:
  virtual ~MatchObserver() = default;
  /// Called once, before the first play.
  virtual void onMatchStart(const MatchConfig&) {}
  /// Called when a new world has been made: at the beginning and after every stoppage.
  virtual void onPlayStart(const PlayStart&) {}
  /// Called after every tick of the match, waiting for a signal included.
  virtual void onTick(const MatchTick&) {}
  /// The match cannot go on after this tick: the event says when, `Match::faults` why. `onMatchEnd` follows.
  virtual void onAbandoned(const GameEvent&, const RefereeState&) {}
  /// Called once, with the ticks played in all.
  virtual void onMatchEnd(const RefereeState&, Tick) {}
  /// Whether what the teams draw in the step that leads to `tick` will be looked at. Teams are asked to draw
  /// for no other.
  virtual bool wantsDrawings(Tick) const { return false; }
};

/// A source of monotonic time [ns]. Libraries read no clock of their own.
using MatchClock = std::function<std::int64_t()>;
/// Called before a tick that leads to the given one is played; returns when it may be.
using MatchPace = std::function<void(Tick)>;

/// Where a match stands, by what `Match::advance` does next.
enum class MatchPhase : std::uint8_t {
  kPlacing,  ///< play is stopped, or has not begun; next: the team of `Match::asked` says where it stands
  kPlaced,   ///< both have said it; next: the referee legalises it and the new world is built
  kReady,    ///< all stand in their new world; next: teams and observers are told
  kPlaying,  ///< next: one control tick
  kEnded,    ///< nothing follows
};

/// A team that is to say where it wants to stand, and what it is told.
struct AskedTeam {
  TeamId team = TeamId::kBlue;
  PlacementRequest request;
};

/// Where the wall time of a match went [ns].
struct MatchProfile {
  std::int64_t sense = 0;     ///< what the teams see
  std::int64_t decide = 0;    ///< the teams' strategies
  std::int64_t navigate = 0;  ///< their navigators, and the policy for commands
  std::int64_t step = 0;      ///< physics and the hash of its state
  std::int64_t referee = 0;   ///< calls, clock, periods
  std::int64_t restart = 0;   ///< placing, and building worlds
  std::int64_t record = 0;    ///< all who watch
  std::int64_t ticks = 0;     ///< how many were measured

  /// All of these times together.
  std::int64_t total() const { return sense + decide + navigate + step + referee + restart + record; }
};

/// What the referee of such a match goes by.
RefereeSetup refereeSetup(const MatchConfig& config);

/// One match: sense, decide, navigate, actuate, step, referee, record, tick by tick.
///
///     auto match = Match::create(config);
///     if (!match) return match.error();
///     match->watch(recorder);
///     while (match->step()) {}
///
/// Between plays a match goes through phases. Who must wait for a team outside the process does so between
/// two of them, with the same results:
///
///     while (match->phase() != MatchPhase::kEnded) {
///       if (const auto asked = match->asked()) wait(*asked);
///       match->advance();
///     }
class Match {
 public:
  /// Makes both teams and tells them of the match. Asks for no placement: that is the first thing that
  /// happens, so that whoever watches sees it.
  /// @param clock  measures decisions where `config.decision_time` limits them; read for nothing else
  /// Errors: kUsage or kBadInput of teams, rules, models, ranges, the start state, and a limit without a
  /// clock.
  static Result<Match> create(const MatchConfig& config, const MatchClock& clock = {});
  /// One that was moved from can only be destroyed or assigned to.
  Match(Match&&) noexcept;
  Match& operator=(Match&&) noexcept;
  ~Match();

  /// Watches from now on; must outlive the match. To be called before the first `step`, `advance` or
  /// `makeReady`.
  void watch(MatchObserver& observer);
  /// Measures where time goes; costs clock readings. `profile` must outlive the match. To be called before
  /// the first `step`.
  void measure(const MatchClock& now, MatchProfile& profile);
  /// Ties ticks to a clock outside: `wait` returns when the next tick may be played. What it takes counts
  /// neither as a team's time to think nor in a profile.
  void pace(MatchPace wait);

  MatchPhase phase() const;
  /// In phase kPlacing: who is asked next, and what.
  std::optional<AskedTeam> asked() const;
  /// Does the one thing that `phase` names and returns the phase that follows.
  MatchPhase advance();
  /// Goes on until nobody need be asked: the next thing is to begin a play, to play a tick, or nothing. For
  /// who wants to look at the world before the first step.
  MatchPhase makeReady();
  /// Plays one control tick and goes on up to the next; false when the match is over. Allocates nothing once
  /// warm, but at restarts.
  bool step();
  /// Ends the match as it stands: teams and all who watch are told. Also called by the last `step`.
  void finish();

  /// Where all stand now; nobody before the first placement.
  Placement placement() const;
  /// Between ticks: goes on from this placement, the robots at rest, in a play and world of its own (kind
  /// kGiven). Clock and score stay. Those who watch are told with the next tick, so that of several
  /// replacements between two ticks only the last counts. Errors, which change nothing: kUsage when the match
  /// is over or placements are asked for, or as `flawOfEdit` (match/play/edit.hpp) says; as `World::create`.
  Result<void> replace(const Placement& placement);
  /// How often play went on from a replacement.
  int edits() const;

  /// What it was made from.
  const MatchConfig& config() const;
  /// What the referee knows now: score, clock, who begins.
  const RefereeState& referee() const;
  /// Without bodies before the first placement.
  const WorldState& world() const;
  /// Of the world's robots.
  std::span<const RobotId> ids() const;
  /// Played so far; never reset.
  Tick tick() const;
  /// [s] simulated so far.
  double seconds() const;
  /// Hash over the states of all ticks so far.
  std::uint64_t hash() const;
  /// What the teams did that could not be carried out, so far.
  MatchFaults faults() const;

 private:
  struct Impl;
  explicit Match(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
