#include <algorithm>
#include <cmath>
#include <iterator>

#include "fulbito/detail/math.hpp"
#include "fulbito/recording.hpp"

namespace fulbito {
namespace {

/// Tolerance in ticks, so that a time computed from a tick leads back to this tick.
constexpr double kRounding = 1e-6;

template <typename T>
void moveTo(std::vector<T>& to, std::vector<T>& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

Pose2 between(const Pose2& a, const Pose2& b, double share) {
  return {a.position + (b.position - a.position) * share,
          math::wrapAngle(a.heading + math::wrapAngle(b.heading - a.heading) * share)};
}

}  // namespace

Result<ReplayTimeline> ReplayTimeline::read(const RecordingReader& recording) {
  if (recording.header().level != RecordingLevel::kFull) {
    return fail(ErrorCode::kBadInput, "a recording of level recipe has no samples to show");
  }
  ReplayTimeline timeline;
  timeline.header_ = recording.header();
  timeline.result_ = recording.result();
  for (std::size_t i = 0; i < recording.chunkCount(); ++i) {
    auto chunk = recording.chunk(i);
    if (!chunk) return tl::unexpected<Error>(chunk.error());
    timeline.append(std::move(*chunk));
  }
  if (timeline.plays_.empty()) return fail(ErrorCode::kBadInput, "the recording holds no play");
  timeline.countPlay();
  timeline.countGoals();
  return timeline;
}

void ReplayTimeline::append(RecordedChunk chunk) {
  ticks_ += chunk.ticks;
  moveTo(plays_, chunk.plays);
  moveTo(events_, chunk.events);
  moveTo(samples_, chunk.samples);
  moveTo(drawings_, chunk.drawings);
  moveTo(playing_, chunk.playing);
}

/// Counts the ticks of play as the referee does: those before which it was playing. So the tick of the signal
/// itself does not count, but the tick that ends the match does.
void ReplayTimeline::countPlay() {
  for (const RecordedPlay& play : plays_) {
    // A restart that was repeated too often needs no signal, whatever its delay. Then its first tick is
    // played; otherwise the first tick is only played after a delay of one tick.
    const bool first = play.tick < ticks_ && playing_[static_cast<std::size_t>(play.tick)] != 0;
    begun_.push_back(play.delay == 0 || (first && play.delay > 1) ? 1 : 0);
  }
  clock_ticks_.reserve(playing_.size() + 1);
  clock_ticks_.push_back(0);
  std::size_t next = 0;
  for (std::size_t tick = 0; tick < playing_.size(); ++tick) {
    bool playing = tick > 0 && playing_[tick - 1] != 0;
    for (; next < plays_.size() && plays_[next].tick == static_cast<Tick>(tick); ++next) {
      playing = begun_[next] != 0;
    }
    clock_ticks_.push_back(clock_ticks_.back() + (playing ? 1 : 0));
  }
}

void ReplayTimeline::countGoals() {
  goals_until_.reserve(events_.size() + 1);
  goals_until_.push_back({});
  for (const RecordedEvent& event : events_) {
    PerTeam<int>& goals = goals_until_.emplace_back(goals_until_.back());
    if (event.clause == "goal" && event.team) ++goals[indexOf(*event.team)];
  }
}

std::size_t ReplayTimeline::playAt(Tick tick) const {
  const auto after = std::upper_bound(plays_.begin(), plays_.end(), tick,
                                      [](Tick t, const RecordedPlay& play) { return t < play.tick; });
  return after == plays_.begin() ? 0 : static_cast<std::size_t>(after - plays_.begin()) - 1;
}

Tick ReplayTimeline::endOf(std::size_t play) const {
  return play + 1 < plays_.size() ? plays_[play + 1].tick : ticks_;
}

ReplayMoment ReplayTimeline::at(double seconds) const {
  ReplayMoment moment;
  at(seconds, moment);
  return moment;
}

void ReplayTimeline::at(double seconds, ReplayMoment& moment) const {
  const double last = static_cast<double>(ticks_);
  double ticks = seconds * header_.control_rate;
  ticks = ticks >= 0.0 ? std::min(ticks, last) : 0.0;  // NaN and negative times count as the beginning
  const double nearest = std::floor(ticks + 0.5);
  if (std::abs(ticks - nearest) < kRounding) ticks = nearest;
  moment.tick = static_cast<Tick>(std::floor(ticks));
  moment.seconds = ticks / header_.control_rate;
  moment.play = playAt(moment.tick);
  const RecordedPlay& play = plays_[moment.play];
  const bool start = moment.tick <= play.tick;
  moment.period = play.period;
  moment.blue_side = play.blue_side;
  moment.playing =
      start ? begun_[moment.play] != 0 : playing_[static_cast<std::size_t>(moment.tick) - 1] != 0;
  const auto counted = [this](Tick tick) { return clock_ticks_[static_cast<std::size_t>(tick)]; };
  const double part = ticks - static_cast<double>(moment.tick);
  const auto clock = play.play_ticks + counted(std::max(moment.tick, play.tick)) - counted(play.tick);
  moment.play_seconds = (static_cast<double>(clock) + (moment.playing ? part : 0.0)) / header_.control_rate;
  moment.score = scoreAt(moment);
  place(ticks, moment);
}

PerTeam<int> ReplayTimeline::scoreAt(const ReplayMoment& moment) const {
  // A walk-over changes the score after the last tick.
  if (moment.tick == ticks_ && result_ && result_->complete) return result_->score;
  const RecordedPlay& play = plays_[moment.play];
  const auto goals_until = [this](Tick tick) {
    const auto after = std::upper_bound(events_.begin(), events_.end(), tick,
                                        [](Tick t, const RecordedEvent& event) { return t < event.tick; });
    return goals_until_[static_cast<std::size_t>(after - events_.begin())];
  };
  const PerTeam<int> before = goals_until(play.tick), until = goals_until(std::max(play.tick, moment.tick));
  PerTeam<int> score = play.score;
  for (std::size_t team = 0; team < score.size(); ++team) score[team] += until[team] - before[team];
  return score;
}

void ReplayTimeline::place(double ticks, ReplayMoment& moment) const {
  const RecordedPlay& play = plays_[moment.play];
  const auto next = std::upper_bound(samples_.begin(), samples_.end(), moment.tick,
                                     [](Tick t, const RecordedSample& sample) { return t < sample.tick; });
  const bool first = next == samples_.begin() || std::prev(next)->tick <= play.tick;
  const bool last = next == samples_.end() || next->tick > endOf(moment.play);
  const Tick from = first ? play.tick : std::prev(next)->tick;
  const double share =
      last ? 0.0
           : std::clamp((ticks - static_cast<double>(from)) / static_cast<double>(next->tick - from), 0.0,
                        1.0);
  moment.bodies.resize(header_.bodies.size());
  for (std::size_t body = 0; body < moment.bodies.size(); ++body) {
    if (!play.starts[body].present) {
      moment.bodies[body].reset();
      continue;
    }
    const Pose2& before = first ? play.starts[body].pose : std::prev(next)->poses[body];
    moment.bodies[body] = share > 0.0 ? between(before, next->poses[body], share) : before;
  }
}

std::span<const RecordedDrawing> ReplayTimeline::drawingsAt(const ReplayMoment& moment) const {
  const auto end = std::upper_bound(drawings_.begin(), drawings_.end(), moment.tick,
                                    [](Tick tick, const RecordedDrawing& d) { return tick < d.tick; });
  if (end == drawings_.begin()) return {};
  const Tick tick = std::prev(end)->tick;
  if (tick <= plays_[moment.play].tick || moment.tick - tick >= drawingTicks(header_)) return {};
  const auto begin = std::lower_bound(drawings_.begin(), end, tick,
                                      [](const RecordedDrawing& d, Tick t) { return d.tick < t; });
  return {begin, end};
}

std::vector<ReplayGoal> ReplayTimeline::goals() const {
  std::vector<ReplayGoal> goals;
  for (const RecordedEvent& event : events_) {
    if (event.clause != "goal" || !event.team) continue;
    goals.push_back({event.tick, secondsAt(event.tick), *event.team, event.robot});
  }
  return goals;
}

}  // namespace fulbito
