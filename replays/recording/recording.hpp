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

/// What a recording (`.fbr`, docs/recordings.md) holds, as plain values. It says how everything began and
/// what drove every robot, so that a reader can play all of it again and prove that it gets the same states;
/// and, at the full level, where everything was, so that a viewer needs no physics.
namespace fulbito {

/// The file format that this library writes and reads.
inline constexpr std::uint32_t kRecordingVersion = 1;

/// What was recorded. The names stand in files: match, trial.
enum class RecordingKind : std::uint8_t { kMatch, kTrial };
/// How much is kept. The names stand in files: recipe, full.
enum class RecordingLevel : std::uint8_t {
  kRecipe,  ///< starts, commands, hashes and events: enough to play it again
  kFull     ///< also sampled states and debug drawings: enough to look at it
};

/// A body that may be on the field at any time of the recording.
struct RecordedBody {
  BodyKind kind = BodyKind::kRobot;  ///< never kWall
  std::optional<RobotId> id;         ///< of a match's robot
};

/// All that the recorded match or trial was made from, as resolved values: no preset needs to exist any more
/// when the file is read. Texts are TOML files unless said otherwise.
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
  double dropout = 0.0;            ///< chance that a body is not seen in a tick
  std::uint64_t seed = 0;
  std::uint64_t index = 0;  ///< of a trial in its suite
  /// Whatever else the result depends on, by name.
  std::vector<std::pair<std::string, std::string>> more;
};

/// What is known of how teams command wheels, in steps of a command: robots speed up by so much a tick, and
/// spin by a share of what the wheels ask for. It only makes recordings smaller; commands that know nothing
/// of it are recorded as exactly.
struct CommandModel {
  int most_change = 0;    ///< of right less left in a tick, twice what one wheel can gain; 0: unknown
  int spin_from = 0;      ///< right less left up to which a robot turns by the slow ratio
  int spin_to = 0;        ///< right less left from which on it turns by the fast ratio; linear between
  int spin_slow = 65536;  ///< ratio of the turn reached to the turn commanded, in 1/65536
  int spin_fast = 65536;
  friend bool operator==(const CommandModel&, const CommandModel&) = default;
};

/// What stands at the head of a recording.
struct RecordingHeader {
  RecordingKind kind = RecordingKind::kMatch;
  RecordingLevel level = RecordingLevel::kFull;
  int control_rate = 60;       ///< [Hz] ticks a second, 1 ... 1000
  double command_step = 0.01;  ///< [rad/s] commands are multiples of it; 0: any number
  CommandModel command_model;
  int sample_every = 2;              ///< ticks between sampled states
  double sample_step = 5e-4;         ///< [m] sampled places are multiples of it
  int sample_turn = 1024;            ///< steps of a turn; sampled headings are whole steps
  int chunk_ticks = 360;             ///< ticks that are lost at most when the file is cut
  std::vector<RecordedBody> bodies;  ///< robots, then balls, then obstacles
  RecordingRecipe recipe;
  BuildInfo build;
};

/// How many of the bodies are of one kind.
int countOf(const RecordingHeader& header, BodyKind kind);

/// Where a body is when a play begins, to the last bit.
struct RecordedStart {
  bool present = false;  ///< false: not on the field in this play
  Pose2 pose;            ///< a ball has no heading
  Vec2 velocity;
  double angular_velocity = 0.0;  ///< of a robot
  Vec2 spin;                      ///< of a ball
};

/// The beginning of a play: a new world. A trial is one play.
struct RecordedPlay {
  Tick tick = 0;  ///< of the recording; the play's first step leads to the next one
  RestartKind kind = RestartKind::kGiven;
  TeamId team = TeamId::kBlue;  ///< who takes the restart
  Vec2 ball;                    ///< [m] where the restart puts the ball
  Tick delay = 0;               ///< ticks from the placement to the signal
  bool defenders_back = false;  ///< see RestartCall
  int period = 1;
  Tick play_ticks = 0;  ///< of play so far in this period
  PerTeam<int> score{};
  Side blue_side = Side::kLeft;
  std::uint64_t hash = 0;             ///< running hash before the play's first tick
  std::vector<RecordedStart> starts;  ///< one a body of the header
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

/// Something that a team, or a trial's navigator, wanted to show, in the world's frame, rounded to 0.1 mm.
/// A text stands around its place.
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

/// Hash bits of where a body is and of how it moves.
struct BodyHash {
  std::uint32_t place = 0;
  std::uint32_t motion = 0;
  friend bool operator==(BodyHash, BodyHash) = default;
};

/// Hashes of one state, body by body, kept once a second.
struct RecordedCheck {
  Tick tick = 0;
  std::vector<BodyHash> bodies;  ///< one per body of the header; 0 of an absent one
};

/// Where the bodies were, rounded to the header's steps.
struct RecordedSample {
  Tick tick = 0;
  std::vector<Pose2> poses;  ///< one a body of the header; of an absent one at the origin
};

/// A few seconds of a recording: the ticks first_tick + 1 ... first_tick + ticks.
struct RecordedChunk {
  Tick first_tick = 0;
  int ticks = 0;
  std::int64_t plays_before = 0;      ///< plays that began in earlier chunks
  std::vector<std::uint8_t> present;  ///< one a body: on the field in the play that goes on from before
  std::vector<RecordedPlay> plays;
  std::vector<std::uint16_t> tick_hashes;  ///< low bits of the running hash, one a tick
  std::vector<std::uint8_t> playing;       ///< one a tick: 0 while a restart waited for its signal
  std::vector<WheelSpeeds> commands;       ///< as applied: for each tick one a robot of the header
  std::vector<RecordedCheck> checks;
  std::vector<RecordedEvent> events;
  std::vector<RecordedDrawing> drawings;
  std::vector<RecordedSample> samples;
};

/// What stands at the end of a finished recording.
struct RecordingResult {
  Tick ticks = 0;
  bool complete = true;  ///< false: stopped before its own end
  PerTeam<int> score{};
  std::uint64_t final_hash = 0;  ///< running hash after the last tick
  std::string outcome;           ///< of a trial: a TrialOutcome's name; of a match: blue, yellow or draw
  std::vector<std::pair<std::string, double>> figures;  ///< by name
};

/// [rad] What sampled headings are multiples of.
double sampleHeadingStep(const RecordingHeader& header);
/// [m] What places in drawings are multiples of.
inline constexpr double kDrawingStep = 1e-4;

/// Ticks for which a drawing is shown unless the same play has newer ones: a fifth of a second.
Tick drawingTicks(const RecordingHeader& header);

/// Of one body of a world, counted through its robots, balls and obstacles. Equal states give equal hashes,
/// -0 counts as +0.
BodyHash bodyHash(const WorldState& world, std::size_t body);

}  // namespace fulbito
