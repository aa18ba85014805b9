#include "match/drills/trial_run.hpp"

#include "match/drills/ideal.hpp"

namespace fulbito {

DrillTrialRun::DrillTrialRun(const DrillRun& run, const Drill& drill, const MatchConfig& base,
                             const DrillScene& scene)
    : drill_(drill),
      scene_(scene),
      start_(drill.starts[static_cast<std::size_t>(scene.start)]),
      config_(base),
      watch_(drill_, scene_, config_.field, run.robot, log_) {}

Result<std::unique_ptr<DrillTrialRun>> DrillTrialRun::create(const DrillRun& run, const Drill& drill,
                                                             const MatchConfig& base,
                                                             DrillTrialNumber number) {
  const auto scene = drawScene(drill, base, number.seed, number.index);
  if (!scene) return tl::unexpected<Error>(scene.error());
  std::unique_ptr<DrillTrialRun> trial(new DrillTrialRun(run, drill, base, *scene));
  MatchConfig& config = trial->config_;
  if (auto seated = trial->seatTeams(run); !seated) return tl::unexpected<Error>(seated.error());
  config.seed = number.seed + static_cast<std::uint64_t>(number.index);
  if (trial->start_.restart >= 0) config.opening = openingOf(trial->start_, *scene, base);
  if (!placedByReferee(trial->start_, *scene)) config.start = seated(scene->placement, scene->seat);
  auto match = Match::create(config);
  if (!match) return tl::unexpected<Error>(match.error());
  trial->match_.emplace(std::move(*match));
  trial->match_->watch(trial->watch_);
  trial->ideal_ = idealTime(drill, trial->scene_, config);
  return trial;
}

Result<void> DrillTrialRun::seatTeams(const DrillRun& run) {
  const DrillOptions& options = run.options;
  TeamChoice& opponents = config_.teams[indexOf(other(scene_.seat))];
  config_.teams[indexOf(scene_.seat)] =
      start_.task == DrillTask::kPlay ? options.team : exercisedTeam(options.team, scene_.exercise, log_);
  if (start_.opponents.empty()) {
    opponents = scriptedTeam(scene_.roles[indexOf(TeamId::kYellow)]);
  } else if (start_.opponents == "itself") {
    opponents = options.itself.value_or(options.team);
  } else {
    auto choice = options.catalogue.parse(start_.opponents);
    if (!choice) return tl::unexpected<Error>(choice.error());
    opponents = std::move(*choice);
  }
  return {};
}

bool DrillTrialRun::advance() {
  if (over()) return false;
  match_->advance();
  return !over();
}

Result<DrillTrial> DrillTrialRun::result() const {
  if (const auto abandoned = match_->faults().abandoned) return tl::unexpected<Error>(*abandoned);
  return watch_.trial(ideal_);
}

}  // namespace fulbito
