#include "referee/restarts/check_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "fulbito/models.hpp"
#include "referee/restarts/restart_call.hpp"
#include "referee/restarts/restart_placement.hpp"

namespace fulbito {
namespace {

constexpr double kLeastDepth = 0.15;  // [m] a keeper this close to its goal line is right on any field

/// The restart whose places have the keeper farthest from its goal line.
struct FarKeeper {
  RestartKind kind = RestartKind::kKickOff;
  double before_line = 0.0;  ///< [m]
};

FarKeeper farthestKeeper(const Rules& rules, const FieldGeometry& field) {
  FarKeeper farthest;
  for (const auto& [kind, places] : {std::pair{RestartKind::kKickOff, &rules.kick_off.places},
                                     {RestartKind::kFreeBall, &rules.free_ball.places},
                                     {RestartKind::kFreeKick, &rules.free_kick.places},
                                     {RestartKind::kPenalty, &rules.penalty.places},
                                     {RestartKind::kGoalKick, &rules.goal_kick.places}}) {
    for (const std::vector<Vec2>* team : {&places->taker, &places->other}) {
      if (team->empty()) continue;
      const double before = field.length / 2 - team->front().x;
      if (before > farthest.before_line) farthest = {kind, before};
    }
  }
  return farthest;
}

/// The rules preset whose field is closest in size.
std::string presetFor(const FieldGeometry& field) {
  std::string nearest;
  double least = 1e9;
  for (const std::string& name : rulesPresetNames()) {
    const auto rules = loadRules(name);
    const auto own = rules ? loadField(rules->field) : tl::unexpected<Error>(rules.error());
    if (!own) continue;
    double gap = std::abs(own->length - field.length) + std::abs(own->width - field.width);
    if (name != own->name)
      gap += 1e-6;  // among several on one field, prefer the one that has the field's name
    if (gap < least) least = gap, nearest = name;
  }
  return nearest;
}

}  // namespace

std::vector<std::string> findBadPlaces(const Rules& rules, const FieldGeometry& field,
                                       const RobotModel& robot) {
  RefereeSetup setup;
  setup.rules = rules;
  setup.field = field;
  setup.robot = robot;
  const RefereeState state;
  std::vector<std::string> bad;
  for (const RestartKind kind : {RestartKind::kKickOff, RestartKind::kFreeBall, RestartKind::kFreeKick,
                                 RestartKind::kPenalty, RestartKind::kGoalKick}) {
    // A ball at +x gives a free ball to blue, which defends -x.
    const RestartCall call = makeCall(setup, state, {kind, TeamId::kBlue, {1.0, 1.0}, nullptr});
    for (const PlacementFlaw& flaw : findPlacementFlaws(setup, state, call, call.defaults)) {
      bad.push_back(fmt::format("{}: robot {} of the {} team {}", nameOf(kind), flaw.robot,
                                flaw.team == call.team ? "taking" : "other", flaw.reason));
    }
  }
  return bad;
}

std::optional<std::string> findForeignPlaces(const Rules& rules, const FieldGeometry& field,
                                             const RobotModel& robot) {
  const FarKeeper keeper = farthestKeeper(rules, field);
  std::string reason;
  if (keeper.before_line > std::max(field.goal_area_depth, kLeastDepth)) {
    reason =
        fmt::format("{}: robot 0 is {:.2f} m from its goal line", nameOf(keeper.kind), keeper.before_line);
  } else {
    const std::vector<std::string> bad = findBadPlaces(rules, field, robot);
    const auto off = std::find_if(bad.begin(), bad.end(), [](const std::string& flaw) {
      return flaw.ends_with("is not on the field");
    });
    if (off != bad.end()) reason = *off;
  }
  if (reason.empty()) return std::nullopt;
  return fmt::format(
      "the places (in metres) of the rules '{}' seem to be meant for another field than "
      "'{}', "
      "{:g} x {:g} m ({}). Start from: fulbito rules show {}",
      rules.name, field.name, field.length, field.width, reason, presetFor(field));
}

}  // namespace fulbito
