// Recordings (`.fbr`): reading, writing, and moments for viewers. Component `recording`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fulbito/detail/build_info.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

// The content of a recording (`.fbr`, docs/recordings.md) as plain values. It holds the start of each play
// and all commands, so a reader can simulate it again and verify the states. At level full it also holds
// sampled states, so a viewer needs no physics.

/// The file format that this library writes and reads.
inline constexpr std::uint32_t kRecordingVersion = 2;

/// The kind of a recording. Names in files: match, trial.
enum class RecordingKind : std::uint8_t { kMatch, kTrial };
/// The amount of stored data. Names in files: recipe, full.
enum class RecordingLevel : std::uint8_t {
  kRecipe,  ///< starts, commands, hashes and events: enough to simulate it again
  kFull     ///< also sampled states and drawings: enough to show it
};

/// A body that is on the field at some time of the recording.
struct RecordedBody {
  BodyKind kind = BodyKind::kRobot;  ///< never kWall
  std::optional<RobotId> id;         ///< team and number of a match's robot
};

/// The complete configuration of the recorded match or trial as resolved values: readers need no presets.
/// Texts are TOML files unless stated otherwise.
struct RecordingRecipe {
  std::string rules;                ///< rules of a match
  std::string physics;              ///< physics profile
  std::string robot;                ///< robot and ball
  std::string field;                ///< the field itself, not a preset's name
  std::vector<std::string> teams;   ///< for a match: specifications of blue and yellow
  std::string navigator;            ///< for a trial: specification
  std::string layout;               ///< layout of a trial
  std::vector<SensorModel> vision;  ///< sensors of blue and yellow; for a trial: of the robot
  std::uint64_t seed = 0;           ///< seed of all random numbers
  std::uint64_t index = 0;          ///< index of a trial in its suite
  /// Everything else that affects the result, by name.
  std::vector<std::pair<std::string, std::string>> more;
};

/// The header of a recording.
struct RecordingHeader {
  RecordingKind kind = RecordingKind::kMatch;    ///< match or trial
  RecordingLevel level = RecordingLevel::kFull;  ///< amount of stored data
  /// The motion was heard from another program and cannot be simulated again: samples of every tick, without
  /// commands; states count as at rest.
  bool heard = false;
  int control_rate = 60;             ///< [Hz] ticks per second, 1 ... 1000
  double command_step = 0.01;        ///< [rad/s] commands are multiples of it; 0: any value
  int sample_every = 2;              ///< ticks between sampled states
  double sample_step = 5e-4;         ///< [m] sampled positions are multiples of it
  int sample_turn = 1024;            ///< steps per turn; sampled headings are whole steps
  int chunk_ticks = 360;             ///< ticks per chunk: most ticks that a cut-off file loses
  std::vector<RecordedBody> bodies;  ///< robots, then balls, then obstacles
  RecordingRecipe recipe;            ///< configuration of the match or trial
  BuildInfo build;                   ///< build of the recording program
};

/// The number of bodies of one kind.
int countOf(const RecordingHeader& header, BodyKind kind);

/// The exact state of a body at the start of a play.
struct RecordedStart {
  bool present = false;           ///< false: not on the field in this play
  Pose2 pose;                     ///< a ball has no heading
  Vec2 velocity;                  ///< [m/s]
  double angular_velocity = 0.0;  ///< [rad/s] of a robot
  Vec2 spin;                      ///< [m/s] of a ball, as BallState::spin
};

/// The start of a play, with a new world. A trial is one play.
struct RecordedPlay {
  Tick tick = 0;                           ///< tick of the recording before the play's first step
  RestartKind kind = RestartKind::kGiven;  ///< kind of the restart
  TeamId team = TeamId::kBlue;             ///< the team that takes the restart
  Vec2 ball;                               ///< [m] position of the ball at the restart
  Tick delay = 0;                          ///< ticks from the placement to the signal
  bool defenders_back = false;             ///< see RestartCall
  int period = 1;                          ///< as `GameEvent::period`
  Tick play_ticks = 0;                     ///< play time so far in this period
  PerTeam<int> score{};                    ///< goals of blue and yellow when it begins
  Side blue_side = Side::kLeft;            ///< the goal that blue defends
  std::uint64_t hash = 0;                  ///< running hash before the play's first tick
  std::vector<RecordedStart> starts;       ///< one per body of the header
};

/// A referee's call, see GameEvent.
struct RecordedEvent {
  Tick tick = 0;                      ///< tick of the recording
  double play_time = 0.0;             ///< [s] play time in the period
  std::uint8_t period = 1;            ///< as `GameEvent::period`
  std::string clause;                 ///< name of the rule
  std::string law;                    ///< section of the rule book
  std::optional<TeamId> team;         ///< team that the call is against; for a goal, the scoring team
  std::optional<std::uint8_t> robot;  ///< the robot at fault or the scorer
  Vec2 place;                         ///< [m] the ball's position
  double value = 0.0, threshold = 0.0,
         margin = 0.0;  ///< measured value, limit of the rule, distance between the two
};

/// A drawing of a team or of a trial's navigator, in the world frame, rounded to 0.1 mm. A text is centred at
/// its position.
struct RecordedDrawing {
  /// The kinds of drawings.
  enum class Kind : std::uint8_t { kLine, kCircle, kText };
  Tick tick = 0;                ///< tick of the drawing
  TeamId team = TeamId::kBlue;  ///< the drawing team; for a trial: blue
  Kind kind = Kind::kLine;      ///< line, circle or text
  Vec2 from;                    ///< [m] start of a line; centre of a circle or text
  Vec2 to;                      ///< [m] end of a line
  double radius = 0.0;          ///< [m] of a circle
  std::string text;             ///< for kText
};

/// Hashes of a body's pose and of its motion.
struct BodyHash {
  std::uint32_t place = 0;   ///< hash of position and heading
  std::uint32_t motion = 0;  ///< hash of velocity, turning, spin and wheels
  friend bool operator==(BodyHash, BodyHash) = default;
};

/// Hashes of the bodies in one state, stored once per second.
struct RecordedCheck {
  Tick tick = 0;                 ///< tick of the recording
  std::vector<BodyHash> bodies;  ///< one per body of the header; 0 for an absent body
};

/// The poses of the bodies, rounded to the header's steps.
struct RecordedSample {
  Tick tick = 0;             ///< tick of the recording
  std::vector<Pose2> poses;  ///< one per body of the header; the origin for an absent body
};

/// A few seconds of a recording: the ticks first_tick + 1 ... first_tick + ticks.
struct RecordedChunk {
  Tick first_tick = 0;                     ///< the tick before its first one
  int ticks = 0;                           ///< number of its ticks
  std::int64_t plays_before = 0;           ///< plays that began in earlier chunks
  std::vector<std::uint8_t> present;       ///< per body: whether it is on the field in the continued play
  std::vector<RecordedPlay> plays;         ///< plays that begin in it
  std::vector<std::uint16_t> tick_hashes;  ///< low bits of the running hash, one per tick
  std::vector<std::uint8_t> playing;       ///< per tick: 0 while a restart waits for its signal
  std::vector<WheelSpeeds> commands;       ///< as applied: per tick, one per robot of the header
  std::vector<RecordedCheck> checks;       ///< one per second
  std::vector<RecordedEvent> events;       ///< in chronological order
  std::vector<RecordedDrawing> drawings;   ///< in chronological order
  std::vector<RecordedSample> samples;     ///< one per `RecordingHeader::sample_every` ticks
};

/// The result at the end of a finished recording.
struct RecordingResult {
  Tick ticks = 0;                ///< ticks of the whole recording
  bool complete = true;          ///< false: stopped before its end
  PerTeam<int> score{};          ///< for a match: goals of blue and yellow
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

/// The hashes of one body of a world. `body` counts its robots, then balls, then obstacles. Equal states give
/// equal hashes; -0 counts as +0.
BodyHash bodyHash(const WorldState& world, std::size_t body);

/// Options of a reader.
struct RecordingReadOptions {
  bool salvage = false;  ///< read a damaged file up to the damage, as a cut-off file
};

/// The stored bytes of one kind of content.
struct RecordingPart {
  std::string name;       ///< e.g. commands, samples
  std::size_t bytes = 0;  ///< compressed size
};

/// Reads a recording. Opening checks all checksums and the order of chunks. `chunk` unpacks one on request.
class RecordingReader {
 public:
  /// Opens a file. Errors: kIo; kBadInput naming the file, the block and its place, if the file is not a
  /// recording, has another format version, or is damaged. A cut-off file is not an error, see `finished`.
  static Result<RecordingReader> open(const std::string& file, RecordingReadOptions options = {});
  /// Opens bytes in memory; `origin` stands for the file's name in errors.
  static Result<RecordingReader> parse(std::string bytes, const std::string& origin,
                                       RecordingReadOptions options = {});
  /// A moved-from reader can only be destroyed or assigned to.
  RecordingReader(RecordingReader&&) noexcept;
  RecordingReader& operator=(RecordingReader&&) noexcept;
  ~RecordingReader();

  /// The header.
  const RecordingHeader& header() const;
  /// Whether the recording is finished; false: it is cut off, and its last seconds may be missing.
  bool finished() const;
  /// The result of a finished recording; otherwise empty.
  const std::optional<RecordingResult>& result() const;
  /// Ticks in all chunks.
  Tick ticks() const;
  /// Number of readable chunks.
  std::size_t chunkCount() const;
  /// Unpacks a chunk; `index` is below `chunkCount`. Errors: kBadInput.
  Result<RecordedChunk> chunk(std::size_t index) const;
  /// Size of the whole file.
  std::size_t sizeInBytes() const;
  /// Bytes per kind of content, and "frame" for the remaining structure.
  std::vector<RecordingPart> sizeByPart() const;
  /// The file's name, or its substitute in errors.
  const std::string& origin() const;
  /// The bytes of the whole file.
  std::string_view bytes() const;

 private:
  struct Impl;
  explicit RecordingReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The state of a recording at one moment.
struct ReplayMoment {
  double seconds = 0.0;          ///< time in the recording: ticks / control rate, including stoppages
  Tick tick = 0;                 ///< the last tick at or before it
  std::size_t play = 0;          ///< index in `ReplayTimeline::plays`
  int period = 1;                ///< as `GameEvent::period`
  double play_seconds = 0.0;     ///< [s] play time in the period, as the referee counts it
  bool playing = false;          ///< false: a restart waits for its signal, or the match has ended
  PerTeam<int> score{};          ///< goals of blue and yellow until then
  Side blue_side = Side::kLeft;  ///< the goal that blue defends
  std::vector<std::optional<Pose2>> bodies;  ///< per body of the header; empty: not on the field
};

/// A goal of a recorded match.
struct ReplayGoal {
  Tick tick = 0;                      ///< tick of the recording
  double seconds = 0.0;               ///< [s] time in the recording
  TeamId team = TeamId::kBlue;        ///< the scoring team
  std::optional<std::uint8_t> robot;  ///< the scoring robot, if one of that team touched the ball last
};

/// A recording of level full, unpacked for viewers, so that showing it needs no physics and no decoding.
class ReplayTimeline {
 public:
  /// Unpacks a recording. Errors: kBadInput for a recording without a play, or without samples (expand one of
  /// level recipe first: replays/verify/expand.hpp); as RecordingReader::chunk.
  static Result<ReplayTimeline> read(const RecordingReader& recording);

  /// The recording's header.
  const RecordingHeader& header() const { return header_; }
  /// The result of a finished recording; otherwise empty.
  const std::optional<RecordingResult>& result() const { return result_; }
  /// Ticks of the whole recording.
  Tick ticks() const { return ticks_; }
  /// [s] length of the whole recording.
  double seconds() const { return secondsAt(ticks_); }
  /// [s] time in the recording at a tick.
  double secondsAt(Tick tick) const { return static_cast<double>(tick) / header_.control_rate; }
  /// All plays in chronological order; at least one.
  std::span<const RecordedPlay> plays() const { return plays_; }
  /// All calls in chronological order.
  std::span<const RecordedEvent> events() const { return events_; }
  /// All samples in chronological order.
  std::span<const RecordedSample> samples() const { return samples_; }
  /// All drawings in chronological order.
  std::span<const RecordedDrawing> drawings() const { return drawings_; }

  /// The moment at a time [s], clamped to the recording. Poses are interpolated between samples (headings
  /// along the shorter arc), but not across the start of a play, where bodies jump.
  ReplayMoment at(double seconds) const;
  /// The moment at a time [s]; reuses the memory of `moment`.
  void at(double seconds, ReplayMoment& moment) const;
  /// The teams' drawings for a moment: the latest ones of its play, at most `drawingTicks` old.
  std::span<const RecordedDrawing> drawingsAt(const ReplayMoment& moment) const;
  /// All goals in chronological order.
  std::vector<ReplayGoal> goals() const;

 private:
  ReplayTimeline() = default;
  void append(RecordedChunk chunk);
  void countPlay();
  void countGoals();
  std::size_t playAt(Tick tick) const;
  /// The last tick of a play, at which the next play begins.
  Tick endOf(std::size_t play) const;
  void place(double ticks, ReplayMoment& moment) const;
  PerTeam<int> scoreAt(const ReplayMoment& moment) const;

  RecordingHeader header_;
  std::optional<RecordingResult> result_;
  Tick ticks_ = 0;
  std::vector<RecordedPlay> plays_;
  std::vector<RecordedEvent> events_;
  std::vector<RecordedSample> samples_;
  std::vector<RecordedDrawing> drawings_;
  std::vector<PerTeam<int>> goals_until_;  ///< goals in the first 0, 1, 2 ... events
  std::vector<std::uint8_t> playing_;      ///< `ReplayMoment::playing` after each tick, from tick 1 on
  std::vector<std::uint8_t> begun_;        ///< per play: whether it started without a signal
  std::vector<std::int32_t> clock_ticks_;  ///< ticks of play up to each tick, from tick 0 on
};

/// One tick of play, for the recording.
struct RecordingTick {
  const WorldState* world = nullptr;      ///< after the step; its bodies are those present in the play
  std::span<const WheelSpeeds> commands;  ///< applied commands, one per robot of the world
  std::uint64_t hash = 0;                 ///< running hash of all states, including this one
  bool playing = true;                    ///< false while a restart waits for its signal
};

/// Writes a recording during the match: one chunk per few seconds, so that a cut-off file is readable up to
/// its last complete chunk. Equal calls give equal bytes. `finish` reports the first failed write. The writer
/// drops later data, so a full disk does not stop a match.
class RecordingWriter {
 public:
  /// Receives the file's bytes in order.
  using Sink = std::function<Result<void>(std::string_view)>;

  /// Starts the file. The finished file replaces an existing one; without `replace`, an existing file is an
  /// error. On a full disk, the new file ends after its last complete chunk, or is removed if it has none.
  /// Errors: kIo; kUsage for a header outside its ranges and for the file "-".
  static Result<RecordingWriter> create(const std::string& file, const RecordingHeader& header,
                                        bool replace = true);
  /// Starts a recording into a sink. Errors: the sink's; kUsage.
  static Result<RecordingWriter> create(Sink sink, const RecordingHeader& header);
  /// A moved-from writer can only be destroyed or assigned to.
  RecordingWriter(RecordingWriter&&) noexcept;
  RecordingWriter& operator=(RecordingWriter&&) noexcept;
  /// Without `finish`, the file ends after its last complete chunk.
  ~RecordingWriter();

  /// The header given to `create`.
  const RecordingHeader& header() const;
  /// Ticks recorded so far.
  Tick tick() const;

  /// Starts a play at the present tick; required before the first tick. Sets `play.tick`.
  void beginPlay(const RecordedPlay& play);
  /// Adds a tick. Allocates nothing once warm, except at the end of a chunk.
  void add(const RecordingTick& tick);
  /// @{ Adds an event or drawing of a recent tick. Only level full stores drawings.
  void add(const RecordedEvent& event);
  void add(const RecordedDrawing& drawing);  ///< ignored at level recipe
  /// @}

  /// Writes the remaining data, the result and the index. Sets `result.ticks`. Errors: the first failed
  /// write. Later calls do nothing.
  Result<void> finish(const RecordingResult& result);

 private:
  struct Impl;
  explicit RecordingWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
