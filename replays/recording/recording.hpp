#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/base/build_info.hpp"
#include "engine/core/base/contact.hpp"
#include "engine/core/base/restart_kind.hpp"
#include "engine/core/base/team.hpp"
#include "engine/core/base/values.hpp"

/// The content of a recording (`.fbr`, docs/recordings.md) as plain values. It holds the start of every play
/// and all commands, so that a reader can simulate it again and verify the states. At level full it also
/// holds sampled states, so that a viewer needs no physics.
namespace fulbito {

/// The file format that this library writes and reads.
inline constexpr std::uint32_t kRecordingVersion = 1;

/// The kind of a recording. Names in files: match, trial.
enum class RecordingKind : std::uint8_t { kMatch, kTrial };
/// The amount of stored data. Names in files: recipe, full.
enum class RecordingLevel : std::uint8_t {
  kRecipe,  ///< starts, commands, hashes and events: enough to simulate it again
  kFull     ///< also sampled states and debug drawings: enough to show it
};

/// A body that is on the field at some time of the recording.
struct RecordedBody {
  BodyKind kind = BodyKind::kRobot;  ///< never kWall
  std::optional<RobotId> id;         ///< of a match's robot
};

/// The complete configuration of the recorded match or trial as resolved values: reading the file needs no
/// presets. Texts are TOML files unless stated otherwise.
struct RecordingRecipe {
  std::string rules;    ///< of a match
  std::string physics;  ///< profile
  std::string robot;    ///< robot and ball
  std::string field;
  std::vector<std::string> teams;  ///< of a match: specifications of blue and yellow
  std::string navigator;           ///< of a trial: specification
  std::string layout;              ///< of a trial
  int latency_ticks = 0;           ///< age of observations
  double position_noise = 0.0;     ///< [m]
  double heading_noise = 0.0;      ///< [rad]
  double dropout = 0.0;            ///< probability per tick that a body is not seen
  std::uint64_t seed = 0;
  std::uint64_t index = 0;  ///< index of a trial in its suite
  /// Everything else that affects the result, by name.
  std::vector<std::pair<std::string, std::string>> more;
};

/// A prediction model of wheel commands, in steps of a command: robots accelerate by a limited amount per
/// tick and spin slower than ideal wheels. It only makes recordings smaller: commands that do not follow it
/// are recorded exactly, too.
struct CommandModel {
  int most_change = 0;    ///< largest change of right - left per tick, twice that of one wheel; 0: unknown
  int spin_from = 0;      ///< right - left up to which a robot turns by the slow ratio
  int spin_to = 0;        ///< right - left from which it turns by the fast ratio; linear between
  int spin_slow = 65536;  ///< actual over commanded turn, in 1/65536
  int spin_fast = 65536;
  friend bool operator==(const CommandModel&, const CommandModel&) = default;
};

/// The header of a recording.
struct RecordingHeader {
  RecordingKind kind = RecordingKind::kMatch;
  RecordingLevel level = RecordingLevel::kFull;
  int control_rate = 60;       ///< [Hz] ticks per second, 1 ... 1000
  double command_step = 0.01;  ///< [rad/s] commands are multiples of it; 0: any value
  CommandModel command_model;
  int sample_every = 2;              ///< ticks between sampled states
  double sample_step = 5e-4;         ///< [m] sampled places are multiples of it
  int sample_turn = 1024;            ///< steps of a turn; sampled headings are whole steps
  int chunk_ticks = 360;             ///< ticks that are lost at most when the file is cut
  std::vector<RecordedBody> bodies;  ///< robots, then balls, then obstacles
  RecordingRecipe recipe;
  BuildInfo build;
};

/// The number of bodies of one kind.
int countOf(const RecordingHeader& header, BodyKind kind);

/// The exact state of a body at the start of a play.
struct RecordedStart {
  bool present = false;  ///< false: not on the field in this play
  Pose2 pose;            ///< a ball has no heading
  Vec2 velocity;
  double angular_velocity = 0.0;  ///< of a robot
  Vec2 spin;                      ///< of a ball
};

/// The start of a play, with a new world. A trial is one play.
struct RecordedPlay {
  Tick tick = 0;  ///< of the recording, before the play's first step
  RestartKind kind = RestartKind::kGiven;
  TeamId team = TeamId::kBlue;  ///< the team that takes the restart
  Vec2 ball;                    ///< [m] position of the ball at the restart
  Tick delay = 0;               ///< ticks from the placement to the signal
  bool defenders_back = false;  ///< see RestartCall
  int period = 1;
  Tick play_ticks = 0;  ///< play time so far in this period
  PerTeam<int> score{};
  Side blue_side = Side::kLeft;
  std::uint64_t hash = 0;             ///< running hash before the play's first tick
  std::vector<RecordedStart> starts;  ///< one per body of the header
};

/// A referee's call, see GameEvent.
struct RecordedEvent {
  Tick tick = 0;
  double play_time = 0.0;  ///< [s]
  std::uint8_t period = 1;
  std::string clause;
  std::string law;
  std::optional<TeamId> team;
  std::optional<std::uint8_t> robot;
  Vec2 place;  ///< [m]
  double value = 0.0, threshold = 0.0, margin = 0.0;
};

/// A drawing of a team or of a trial's navigator, in the world frame, rounded to 0.1 mm. A text is centred at
/// its position.
struct RecordedDrawing {
  enum class Kind : std::uint8_t { kLine, kCircle, kText };
  Tick tick = 0;
  TeamId team = TeamId::kBlue;
  Kind kind = Kind::kLine;
  Vec2 from;
  Vec2 to;
  double radius = 0.0;
  std::string text;
};

/// Hashes of a body's pose and of its motion.
struct BodyHash {
  std::uint32_t place = 0;
  std::uint32_t motion = 0;
  friend bool operator==(BodyHash, BodyHash) = default;
};

/// Hashes of the bodies in one state, stored once per second.
struct RecordedCheck {
  Tick tick = 0;
  std::vector<BodyHash> bodies;  ///< one per body of the header; 0 of an absent one
};

/// The poses of the bodies, rounded to the header's steps.
struct RecordedSample {
  Tick tick = 0;
  std::vector<Pose2> poses;  ///< one per body of the header; at the origin if absent
};

/// A few seconds of a recording: the ticks first_tick + 1 ... first_tick + ticks.
struct RecordedChunk {
  Tick first_tick = 0;
  int ticks = 0;
  std::int64_t plays_before = 0;      ///< plays that began in earlier chunks
  std::vector<std::uint8_t> present;  ///< per body: whether it is on the field in the continued play
  std::vector<RecordedPlay> plays;
  std::vector<std::uint16_t> tick_hashes;  ///< low bits of the running hash, one per tick
  std::vector<std::uint8_t> playing;       ///< per tick: 0 while a restart waits for its signal
  std::vector<WheelSpeeds> commands;       ///< as applied: per tick, one per robot of the header
  std::vector<RecordedCheck> checks;
  std::vector<RecordedEvent> events;
  std::vector<RecordedDrawing> drawings;
  std::vector<RecordedSample> samples;
};

/// The result at the end of a finished recording.
struct RecordingResult {
  Tick ticks = 0;
  bool complete = true;  ///< false: stopped before its own end
  PerTeam<int> score{};
  std::uint64_t final_hash = 0;  ///< running hash after the last tick
  std::string outcome;           ///< trial: a TrialOutcome's name; match: blue, yellow or draw
  std::vector<std::pair<std::string, double>> figures;  ///< by name
};

/// Step of sampled headings [rad].
double sampleHeadingStep(const RecordingHeader& header);
/// Step of positions in drawings [m].
inline constexpr double kDrawingStep = 1e-4;

/// Ticks for which a drawing is shown unless a newer one of the same play replaces it: 0.2 s.
Tick drawingTicks(const RecordingHeader& header);

/// The hashes of one body of a world, counted through its robots, balls and obstacles. Equal states give
/// equal hashes; -0 counts as +0.
BodyHash bodyHash(const WorldState& world, std::size_t body);

}  // namespace fulbito
