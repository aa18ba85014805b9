#pragma once

#include <string_view>

#include "fulbito/detail/values.hpp"
#include "fulbito/referee.hpp"
#include "referee/geometry/placed_body.hpp"

/// The zones in which a robot may stand at a restart. All in the taker's frame: x is mirrored if needed so
/// that the team that takes the restart defends +x; y is unchanged.
namespace fulbito {

/// A robot's role at a restart.
enum class RestartRole { kKeeper, kKicker, kOther };

/// The facts that determine the zones of a restart.
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

/// The reason why the law forbids this place for the body; empty if it is legal. Static lifetime.
std::string_view zoneFlaw(const RestartScene& scene, RestartPart part, const PlacedBody& body);

/// The body's centre, moved along x, along y, or away from ball or circle to a near place that the law may
/// allow; check it with `zoneFlaw`.
Vec2 intoZone(const RestartScene& scene, RestartPart part, const PlacedBody& body);

}  // namespace fulbito
