#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "replays/render/replay_scene.hpp"

namespace fulbito {
namespace {

constexpr double kShown = 2.5;  // [s]

/// What a clause reads as.
struct CallWords {
  std::string_view clause, title, detail;
};

constexpr std::array kWords{
    CallWords{"goal", "Goal!", ""},
    CallWords{"free-ball", "Free ball", "nobody gets on"},
    CallWords{"goal-kick.attackers", "Goal kick", "too many attackers in the area"},
    CallWords{"goal-kick.keeper-charged", "Goal kick", "keeper charged"},
    CallWords{"goal-kick.stuck", "Goal kick", "ball stuck in the area"},
    CallWords{"penalty.defenders", "Penalty", "too many defenders in the area"},
    CallWords{"penalty.keeper-holds", "Penalty", "keeper held the ball"},
    CallWords{"penalty.holding", "Penalty", "ball held"},
    CallWords{"penalty.stuck", "Penalty", "ball stuck in the area"},
    CallWords{"free-kick.push", "Free kick", "pushing"},
    CallWords{"free-kick.holding", "Free kick", "ball held"},
    CallWords{"half", "Half-time", ""},
    CallWords{"full-time", "Full time", ""},
    CallWords{"overtime", "Overtime", ""},
    CallWords{"shoot-out", "Shoot-out", ""},
    CallWords{"false-start", "False start", ""},
    CallWords{"mercy", "Full time", "the lead is too large"},
    CallWords{"walk-over", "Walk-over", "a team did not come"},
    CallWords{"match.abandoned", "Match abandoned", ""},
};

/// Calls that are no news: how a restart was put right, and that play goes on.
bool shown(const RecordedEvent& event) {
  return std::any_of(kWords.begin(), kWords.end(),
                     [&event](const CallWords& words) { return words.clause == event.clause; });
}

std::string nameOfTeam(TeamId team, const RecordingRecipe& recipe) {
  const std::size_t index = indexOf(team);
  return index < recipe.teams.size() ? recipe.teams[index] : std::string(nameOf(team));
}

std::string_view restartName(RestartKind kind) {
  switch (kind) {
    case RestartKind::kKickOff:
      return "Kick-off";
    case RestartKind::kFreeBall:
      return "Free ball";
    case RestartKind::kFreeKick:
      return "Free kick";
    case RestartKind::kPenalty:
      return "Penalty";
    case RestartKind::kGoalKick:
      return "Goal kick";
    case RestartKind::kGiven:
      return "";
  }
  return "";
}

MatchBanner restartBanner(const RecordedPlay& play, const RecordingRecipe& recipe) {
  MatchBanner banner;
  banner.title = restartName(play.kind);
  if (play.kind == RestartKind::kFreeBall || banner.title.empty()) return banner;
  banner.team = play.team;
  banner.detail = nameOfTeam(play.team, recipe);
  return banner;
}

/// Details that the table cannot hold.
void complete(const RecordedEvent& event, const RecordingRecipe& recipe, MatchBanner& banner) {
  const bool whose = event.clause == "goal" || event.clause == "false-start";
  if (whose && event.team) {
    banner.detail = nameOfTeam(*event.team, recipe);
  } else if (event.clause == "full-time") {
    banner.detail = event.team ? nameOfTeam(*event.team, recipe) + " wins" : std::string("draw");
  } else if (event.clause == "shoot-out" && event.team) {
    banner.detail = nameOfTeam(*event.team, recipe) + (event.value > 0.0 ? " scores" : " misses");
  }
}

}  // namespace

MatchBanner bannerOf(const RecordedEvent& event, const RecordedPlay& next, const RecordingRecipe& recipe) {
  MatchBanner banner;
  const auto words = std::find_if(kWords.begin(), kWords.end(),
                                  [&event](const CallWords& w) { return w.clause == event.clause; });
  if (words == kWords.end()) return banner;
  banner.title = words->title;
  banner.detail = words->detail;
  const bool against = event.clause.find('.') != std::string::npos;
  banner.team = against ? std::optional(next.team) : event.team;
  complete(event, recipe, banner);
  return banner;
}

MatchBanner bannerOf(const RecordedPlay& play, const RecordingRecipe& recipe) {
  return restartBanner(play, recipe);
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
    if (!shown(*event)) continue;
    // Of several calls at one tick a goal is the news.
    if (latest == nullptr || (latest->tick == event->tick && event->clause == "goal")) latest = &*event;
  }
  if (latest != nullptr) return bannerOf(*latest, play, recipe);
  return moment.playing || moment.tick == timeline.ticks() ? MatchBanner{} : restartBanner(play, recipe);
}

}  // namespace fulbito
