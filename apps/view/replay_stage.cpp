#include "apps/view/replay_stage.hpp"

#include <algorithm>

namespace fulbito {
namespace {

constexpr double kSameTime = 1e-6;  // [s]

std::vector<double> eventsOf(const ReplayTimeline& timeline) {
  std::vector<double> times;
  for (const RecordedEvent& event : timeline.events()) {
    // Events without a banner, such as a repaired placement, are skipped.
    if (bannerOf(event, timeline.header().recipe).title.empty()) continue;
    times.push_back(std::max(0.0, timeline.secondsAt(event.tick) - ReplayStage::kLead));
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Whether a user edited the match. An edit begins a play of its own, and the result counts the edits.
bool wasEdited(const ReplayTimeline& timeline) {
  // In a heard match, robots that come or go begin a play.
  if (timeline.header().kind != RecordingKind::kMatch || timeline.header().heard) return false;
  if (const auto& result = timeline.result()) {
    return std::any_of(result->figures.begin(), result->figures.end(),
                       [](const auto& figure) { return figure.first == "edits" && figure.second > 0.0; });
  }
  return std::any_of(timeline.plays().begin(), timeline.plays().end(), [](const RecordedPlay& play) {
    return play.kind == RestartKind::kGiven && play.tick > 0;
  });
}

}  // namespace

Result<std::unique_ptr<ReplayStage>> ReplayStage::create(ReplayTimeline timeline, std::string name) {
  auto look = pictureSpecOf(timeline);
  if (!look) return tl::unexpected<Error>(look.error());
  return std::unique_ptr<ReplayStage>(
      new ReplayStage(std::move(timeline), std::move(name), std::move(*look)));
}

ReplayStage::ReplayStage(ReplayTimeline timeline, std::string name, MatchPictureSpec look)
    : timeline_(std::move(timeline)),
      name_(std::move(name)),
      look_(std::move(look)),
      events_(eventsOf(timeline_)),
      edited_(wasEdited(timeline_)) {}

double ReplayStage::frameSeconds() const { return 1.0 / timeline_.header().control_rate; }

void ReplayStage::seek(double seconds) { seconds_ = std::clamp(seconds, 0.0, timeline_.seconds()); }

std::optional<double> ReplayStage::eventAfter(double seconds) const {
  const auto next = std::upper_bound(events_.begin(), events_.end(), seconds + kSameTime);
  return next == events_.end() ? std::nullopt : std::optional(*next);
}

std::optional<double> ReplayStage::eventBefore(double seconds) const {
  const auto next = std::lower_bound(events_.begin(), events_.end(), seconds - kSameTime);
  return next == events_.begin() ? std::nullopt : std::optional(*std::prev(next));
}

void ReplayStage::show(const OverlayChoice& choice, ReplayMoment& moment, MatchOverlays& overlays) {
  timeline_.at(seconds_, moment);
  ReplayDirector(timeline_, choice).direct(moment, overlays);
}

}  // namespace fulbito
