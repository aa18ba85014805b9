#include <algorithm>
#include <cmath>

#include "fulbito/models.hpp"
#include "fulbito/picture.hpp"
#include "replays/recording/recipe_words.hpp"

namespace fulbito {
namespace {

constexpr double kTrailStep = 1.0 / 30.0;  // [s]
constexpr double kFewPaths = 30.0;         // [s] length of play up to which single paths are distinguishable
constexpr double kPathStep = 0.002;        // [m] smaller movements count as standing still

bool moves(const RecordedBody& body) { return body.kind != BodyKind::kObstacle; }

std::string remarkOf(const std::optional<RecordingResult>& result) {
  return result ? result->outcome : std::string();
}

Result<void> addTrial(const ReplayTimeline& timeline, MatchPictureSpec& spec) {
  const RecordingRecipe& recipe = timeline.header().recipe;
  auto layout = parseLayout(recipe.layout, "the recording's layout");
  if (!layout) return tl::unexpected<Error>(layout.error());
  spec.layout = std::move(*layout);
  spec.names = {recipe.navigator, remarkOf(timeline.result())};
  return {};
}

}  // namespace

Result<MatchPictureSpec> pictureSpecOf(const ReplayTimeline& timeline) {
  const RecordingHeader& header = timeline.header();
  MatchPictureSpec spec;
  auto field = parseField(header.recipe.field, "the recording's field");
  if (!field) return fail(ErrorCode::kBadInput, field.error().message);
  auto robot = parseRobot(header.recipe.robot, "the recording's robot");
  if (!robot) return fail(ErrorCode::kBadInput, robot.error().message);
  spec.field = std::move(*field);
  spec.robot = robot->robot;
  spec.ball = robot->ball;
  spec.bodies = header.bodies;
  spec.seconds = timeline.seconds();
  spec.goals = timeline.goals();
  if (header.kind == RecordingKind::kTrial) {
    if (auto added = addTrial(timeline, spec); !added) {
      return fail(ErrorCode::kBadInput, added.error().message);
    }
  } else {
    const std::vector<std::string> names = teamNames(header.recipe);
    std::copy_n(names.begin(), std::min(names.size(), spec.names.size()), spec.names.begin());
  }
  return spec;
}

void ReplayDirector::direct(const ReplayMoment& moment, MatchOverlays& overlays) {
  overlays.banner = choice_.banner ? bannerAt(*timeline_, moment) : MatchBanner{};
  overlays.drawings = {};
  if (choice_.drawings) overlays.drawings = timeline_->drawingsAt(moment);
  if (choice_.trail_seconds > 0.0) {
    addTrails(moment, overlays);
  } else {
    overlays.trails.clear();
  }
}

/// Adds trails with points at the sampled times, so that they keep their shape over time; each ends at its
/// body.
void ReplayDirector::addTrails(const ReplayMoment& moment, MatchOverlays& overlays) {
  const auto& bodies = timeline_->header().bodies;
  overlays.trails.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    overlays.trails[i].body = i;
    overlays.trails[i].points.clear();
  }
  const auto add = [&](const ReplayMoment& at) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (moves(bodies[i]) && at.bodies[i]) overlays.trails[i].points.push_back(at.bodies[i]->position);
    }
  };
  const double start = timeline_->secondsAt(timeline_->plays()[moment.play].tick);
  const double from = std::max(start, moment.seconds - choice_.trail_seconds);
  for (double step = std::ceil(from / kTrailStep); step * kTrailStep < moment.seconds; step += 1.0) {
    timeline_->at(step * kTrailStep, scratch_);
    if (scratch_.play == moment.play) add(scratch_);
  }
  add(moment);
}

std::vector<BodyTrail> pathsBetween(const ReplayTimeline& timeline, double from, double to) {
  const auto& bodies = timeline.header().bodies;
  std::vector<BodyTrail> paths;
  std::vector<std::size_t> open(bodies.size());  // by body: index of its line in the present play plus one
  std::optional<std::size_t> play;
  // Many overlapping lines have to be faint.
  const double strength = std::clamp(kFewPaths / std::max(to - from, 1e-3), 0.25, 1.0);
  ReplayMoment moment;
  for (double step = std::ceil(from / kTrailStep - 1e-6); step * kTrailStep <= to + 1e-6; step += 1.0) {
    timeline.at(step * kTrailStep, moment);
    if (moment.play != play) open.assign(bodies.size(), 0);
    play = moment.play;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!moves(bodies[i]) || !moment.bodies[i]) continue;
      if (open[i] == 0) {
        paths.push_back({i, {}, false, strength});
        open[i] = paths.size();
      }
      std::vector<Vec2>& points = paths[open[i] - 1].points;
      const Vec2 place = moment.bodies[i]->position;
      if (points.empty() || distance(points.back(), place) > kPathStep) points.push_back(place);
    }
  }
  return paths;
}

}  // namespace fulbito
