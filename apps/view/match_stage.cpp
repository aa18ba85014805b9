#include "apps/view/match_stage.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "fulbito/recorder.hpp"
#include "match/record/recorded_values.hpp"
#include "replays/recording/recipe_words.hpp"

namespace fulbito {
namespace {

constexpr double kTrail = 1.0;   // [s] length of trails
constexpr double kBanner = 2.5;  // [s] time for which a banner is shown

Pose2 between(const Pose2& a, const Pose2& b, double share) {
  return {a.position + (b.position - a.position) * share,
          math::wrapAngle(a.heading + math::wrapAngle(b.heading - a.heading) * share)};
}

}  // namespace

MatchStage::MatchStage(Match& match, double pace)
    : match_(&match),
      pace_(pace),
      header_(recordingHeader(match.config(), RecordingLevel::kFull)),
      name_("live"),
      editor_(match),
      paths_(header_.bodies.size()) {
  const MatchConfig& config = match.config();
  look_.field = config.field;
  look_.robot = config.robot.robot;
  look_.ball = config.robot.ball;
  look_.bodies = header_.bodies;
  const std::vector<std::string> names = teamNames(header_.recipe);
  look_.names = {names[0], names[1]};
  match.watch(*this);
  match.makeReady();
  MatchStage::refresh();
  edited_ = false;
  play_.kind = match.referee().last.kind;
  play_.team = match.referee().last.team;
}

double MatchStage::seconds() const {
  return std::max(0.0, match_->seconds() - (1.0 - share_) * frameSeconds());
}

void MatchStage::play() {
  if (!match_->step()) over_ = true;
}

void MatchStage::forward(double seconds) {
  if (over_ || !(seconds > 0.0)) return;
  double ticks = seconds / frameSeconds();
  // Never so many that a picture waits long for them, and never none: the match would fall behind its time.
  if (pace_ > 0.0) ticks = std::clamp(std::round(ticks * pace_), 1.0, 2.0 * std::ceil(pace_));
  share_ += ticks;
  for (; share_ > 1.0 && !over_; share_ -= 1.0) play();
  if (over_) share_ = 1.0;
}

void MatchStage::stepOn() {
  if (!over_) play();
  share_ = 1.0;
}

void MatchStage::fill(const Placement& placement, Poses& poses) const {
  poses.resize(header_.bodies.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto& id = header_.bodies[i].id;
    poses[i] = id ? placement.robots[indexOf(id->team)][id->number] : Pose2{placement.ball, 0.0};
  }
}

void MatchStage::refresh() {
  fill(match_->placement(), now_);
  before_ = now_;
  share_ = 1.0;
  edited_ = true;
  called_ = false;
  drawings_.clear();
  for (auto& path : paths_) path.clear();
}

void MatchStage::onPlayStart(const PlayStart& start) {
  fill(start.placement, now_);
  before_ = now_;
  for (auto& path : paths_) path.clear();
  drawings_.clear();
  play_.tick = start.tick;
  play_.kind = start.call.kind;
  play_.team = start.call.team;
}

void MatchStage::onTick(const MatchTick& tick) {
  std::swap(before_, now_);
  fill(match_->placement(), now_);
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    if (before_[i]) paths_[i].push_back(before_[i]->position);
    if (static_cast<double>(paths_[i].size()) * frameSeconds() > kTrail) paths_[i].erase(paths_[i].begin());
  }
  for (const GameEvent& event : tick.events) {
    describe(event, event_);
    // If one tick has several calls, the goal is shown.
    const bool goal_stays = called_ && call_.tick == event.tick && call_.clause == "goal";
    if (goal_stays || bannerOf(event_, header_.recipe).title.empty()) continue;
    call_ = event_;
    called_ = true;
  }
  drawings_.clear();
  forEachDrawing(tick, [&](const DebugDrawing& drawing, TeamId team) {
    describe(drawing, tick.tick, team, tick.referee->sideOf(team), drawings_.emplace_back());
  });
}

MatchBanner MatchStage::banner() const {
  const bool waits = !match_->referee().playing && call_.tick >= play_.tick;
  const double age = match_->seconds() - static_cast<double>(call_.tick) * frameSeconds();
  if (called_ && (waits || age < kBanner)) return bannerOf(call_, header_.recipe);
  return match_->referee().playing || over_ ? MatchBanner{} : bannerOf(play_, header_.recipe);
}

void MatchStage::addTrails(const Poses& poses, MatchOverlays& overlays) const {
  overlays.trails.resize(paths_.size());
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    overlays.trails[i].body = i;
    overlays.trails[i].points = paths_[i];
    if (poses[i]) overlays.trails[i].points.push_back(poses[i]->position);
  }
}

void MatchStage::show(const OverlayChoice& choice, ReplayMoment& moment, MatchOverlays& overlays) {
  const RefereeState& referee = match_->referee();
  moment.seconds = seconds();
  moment.tick = match_->tick();
  moment.period = referee.period;
  moment.play_seconds = static_cast<double>(referee.play_ticks) * frameSeconds();
  moment.playing = referee.playing && !over_;
  moment.score = referee.score;
  moment.blue_side = referee.blue_side;
  moment.bodies = now_;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (before_[i] && now_[i] && share_ < 1.0) moment.bodies[i] = between(*before_[i], *now_[i], share_);
  }
  overlays.banner = choice.banner ? banner() : MatchBanner{};
  overlays.drawings = {};
  if (choice.drawings) overlays.drawings = drawings_;
  overlays.trails.clear();
  if (editor_.holding()) {
    fill(editor_.placement(), moment.bodies);
  } else if (choice.trail_seconds > 0.0) {
    addTrails(moment.bodies, overlays);
  }
}

}  // namespace fulbito
