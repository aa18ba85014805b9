#include <algorithm>
#include <utility>

#include "fulbito/picture.hpp"
#include "replays/recording/call_words.hpp"
#include "replays/recording/recipe_words.hpp"

namespace fulbito {
namespace {

constexpr double kShown = 2.5;  // [s] time for which a banner is shown

MatchBanner bannerOf(CallWords words) {
  // A banner without a title is not shown, so its details are dropped as well.
  if (words.title.empty()) return {};
  return {std::move(words.title), std::move(words.detail), words.favours};
}

}  // namespace

MatchBanner bannerOf(const RecordedEvent& event, const RecordingRecipe& recipe) {
  return bannerOf(wordsOf(event, teamNames(recipe)));
}

MatchBanner bannerOf(const RecordedPlay& play, const RecordingRecipe& recipe) {
  return bannerOf(wordsOf(play.kind, play.team, teamNames(recipe)));
}

MatchBanner bannerAt(const ReplayTimeline& timeline, const ReplayMoment& moment) {
  const RecordingRecipe& recipe = timeline.header().recipe;
  const RecordedPlay& play = timeline.plays()[moment.play];
  const auto events = timeline.events();
  const auto after =
      std::upper_bound(events.begin(), events.end(), moment.tick,
                       [](Tick tick, const RecordedEvent& event) { return tick < event.tick; });
  const RecordedEvent* latest = nullptr;
  for (auto event = after; event != events.begin();) {
    --event;
    const bool waits = !moment.playing && event->tick >= play.tick;
    if (!waits && moment.seconds - timeline.secondsAt(event->tick) >= kShown) break;
    if (wordsOf(*event, {}).title.empty()) continue;
    // A goal takes precedence over other calls at the same tick.
    if (latest == nullptr || (latest->tick == event->tick && event->clause == "goal")) latest = &*event;
  }
  if (latest != nullptr) return bannerOf(*latest, recipe);
  return moment.playing || moment.tick == timeline.ticks() ? MatchBanner{} : bannerOf(play, recipe);
}

}  // namespace fulbito
