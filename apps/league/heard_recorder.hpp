#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/wire/messages.hpp"
#include "bridge/wire/seen_world.hpp"
#include "fulbito/detail/state_hash.hpp"
#include "fulbito/match.hpp"
#include "fulbito/recording.hpp"

namespace fulbito::app {

/// What a recorder has heard so far.
struct HeardCounts {
  std::int64_t frames = 0;     ///< recorded
  std::int64_t gaps = 0;       ///< between them
  std::int64_t lost = 0;       ///< frames that the gaps lack
  std::int64_t late = 0;       ///< frames that came twice or out of order: left out
  std::int64_t odd = 0;        ///< frames with impossible values: left out
  std::int64_t strangers = 0;  ///< frames of a second server: left out
  std::int64_t unknown = 0;    ///< robots that the rules do not have: left out
  std::int64_t commands = 0;   ///< of the referee, without repeats
};

/// Makes a recording of what a server of the league's protocol tells. A frame of vision is a tick. A play
/// begins with the first frame after the STOP or GAME_ON that follows a foul, and wherever robots come or go.
class HeardRecorder {
 public:
  /// Opens the recording; called at the first frame.
  using Open = std::function<Result<RecordingWriter>(const RecordingHeader&)>;
  /// @param config  field, rules and robots of the server; names of teams
  HeardRecorder(const MatchConfig& config, Open open);

  /// Takes a command of the referee. Repeats do nothing.
  void take(const wire::RefereeCommand& command);
  /// Takes a frame. False: the server has begun anew, and the recording is over. Errors: kUsage if the field
  /// is not that of the rules; those of `Open`.
  /// @param sender  only the first one counts
  /// @param now     [s] by a clock
  Result<bool> see(const wire::Vision& vision, std::uint64_t sender, double now);
  /// Ends the recording, which has at least one frame. Errors: the first failed write.
  Result<void> finish();

  /// Whether the referee has halted a match that was played.
  bool halted() const { return told_ && told_->foul == wire::Foul::kHalt && played_; }
  const HeardCounts& counts() const { return counts_; }
  PerTeam<int> score() const { return score_; }
  /// [s] of the recording.
  double seconds() const;

 private:
  using Poses = std::vector<std::optional<Pose2>>;  ///< per body of the header; empty: not on the field

  Result<void> begin(const wire::Vision& vision);
  Result<bool> passes(std::uint32_t step, Tick& passed);
  Poses posesOf(const wire::SeenWorld& seen) const;
  void beginHalf(wire::Half half);
  void record(const Poses& poses, const PerTeam<int>& goals, Tick lost);
  void fillGap(const Poses& next, Tick lost);
  void beginPlay(const Poses& poses);
  void addTick(const Poses& poses);
  void countGoals(const PerTeam<int>& goals);
  void mark(std::string_view clause, std::optional<TeamId> team, double value);

  RecordingHeader header_;
  FieldGeometry field_;
  std::string rules_;
  int team_size_;
  Open open_;
  std::optional<RecordingWriter> writer_;  ///< from the first frame on
  HeardCounts counts_;
  std::optional<std::uint64_t> sender_;
  double heard_at_ = 0.0;                        ///< [s] last frame of the sender
  std::uint32_t step_ = 0;                       ///< [ms] of the last frame
  std::optional<wire::RefereeCommand> told_;     ///< the last one
  std::optional<wire::RefereeCommand> restart_;  ///< a foul that no play has followed yet
  std::vector<RecordedEvent> early_;             ///< before the first frame
  bool due_ = false;                             ///< its play begins with the next frame
  bool playing_ = false, played_ = false;
  wire::Half half_ = wire::Half::kNone;
  Tick play_ticks_ = 0;  ///< of play in the period
  PerTeam<int> score_{};
  Poses poses_;                      ///< of the last tick
  std::vector<std::size_t> bodies_;  ///< header indices of those on the field
  WorldState state_;
  StateHash hash_;
  std::int64_t marks_ = 0;
};

}  // namespace fulbito::app
