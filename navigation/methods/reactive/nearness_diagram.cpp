#include "navigation/methods/reactive/nearness_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {

NearnessDiagram::NearnessDiagram(Params params)
    : params_(params),
      circle_(params.sectors),
      seen_(static_cast<std::size_t>(params.sectors)),
      diagram_(seen_.size()) {}

Guidance NearnessDiagram::plan(const NavigationScene& scene) {
  scanScene(circle_, scene, seen_);
  constexpr SectorHit kEmpty{std::numeric_limits<double>::infinity(), {}};
  std::transform(seen_.begin(), seen_.end(), diagram_.begin(),
                 [&](const SectorHit& hit) { return hit.distance <= params_.range ? hit : kEmpty; });

  const Pose2& pose = scene.self.pose;
  NearnessView view;
  view.circle = &circle_;
  view.hits = diagram_;
  view.goal = intoFrame(math::unit(pose.heading), scene.goal.position - pose.position);
  view.radius = scene.robot->width / 2 + params_.gap_margin;
  view.security = params_.security;
  view.wide_rule = params_.wide_region;
  motion_ = decideNearness(view, {scene.robot->length, scene.robot->width, params_.margin});

  direction_ = math::wrapAngle(pose.heading + motion_.direction);
  Guidance guidance = guidanceBy(*this);
  guidance.speed_cap = std::min(motion_.speed_share * scene.robot->maxSpeed(), brakingSpeed(scene));
  return guidance;
}

double NearnessDiagram::brakingSpeed(const NavigationScene& scene) const {
  const double ahead = roomAhead(seen_, scene.robot->width / 2 + params_.gap_margin);
  const double room = std::max(0.0, ahead - scene.robot->length / 2);
  return stoppingSpeed(params_.braking * scene.robot->wheel_acceleration, room);
}

NavigatorInfo nearnessDiagramInfo() {
  using P = NearnessDiagramParams;
  return describeNavigator<P, NearnessDiagram>(
      "nearness-diagram", "reactive: names the situation from the nearest obstacle in each sector",
      "Minguez & Montano 2004; P.-G. Kim et al. 2006",
      {integer("sectors", &P::sectors, 36, kMaxSectors, "sectors of the full circle"),
       number("range", &P::range, 0.1, 5.0, "m", "d_max: farthest obstacle that the diagram shows"),
       number("security", &P::security, 0.01, 2.0, "m", "d_s: security zone around the hull"),
       number("gap_margin", &P::gap_margin, 0.0, 0.05, "m",
              "added to half the robot's width when a gap is tested"),
       number("margin", &P::margin, 0.0, 0.1, "m", "distance kept by the emergency rules"),
       number("braking", &P::braking, 0.1, 1.0, "", "share of the wheel acceleration for stopping"),
       choice("wide_region", &P::wide_region, {"corner", "sector"},
              "enter a wide region past its corner obstacle by R + d_s, or 45 degrees inside its border")});
}

}  // namespace fulbito
