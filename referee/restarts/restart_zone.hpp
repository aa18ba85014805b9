// Private header of referee: not installed.
#pragma once

#include <string_view>

#include "engine/core/base/restart_kind.hpp"
#include "referee/geometry/placed_body.hpp"
#include "referee/rules/rules.hpp"

/// Where the laws let a robot stand at a restart. All in the taker's frame: x is mirrored where needed so
/// that the team which takes the restart defends +x (y is never changed).
namespace fulbito {

/// What a robot is at a restart.
enum class RestartRole { kKeeper, kKicker, kOther };

/// What the zones of one restart are made from.
struct RestartScene {
  const Rules* rules = nullptr;
  const FieldGeometry* field = nullptr;
  RestartKind kind = RestartKind::kKickOff;
  bool defenders_back = false;
  Vec2 ball;  ///< taker's frame
};

/// One robot's part in the restart.
struct RestartPart {
  bool takes = false;  ///< its team takes the restart
  RestartRole role = RestartRole::kOther;
};

/// The goal area without its arc, at +x or at -x by the sign.
PlacedBody goalAreaBox(const FieldGeometry& field, double sign);

/// Why the law does not let the body stand there; empty when it does. Static lifetime.
std::string_view zoneFault(const RestartScene& scene, RestartPart part, const PlacedBody& body);

/// The body's centre moved to a near place that the law allows, as far as moving along x, along y or away
/// from the ball or the circle can do; to be checked by `zoneFault`.
Vec2 intoZone(const RestartScene& scene, RestartPart part, const PlacedBody& body);

}  // namespace fulbito
