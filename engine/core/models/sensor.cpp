#include "engine/core/models/sensor.hpp"

#include "fulbito/detail/math.hpp"

namespace fulbito {

bool Sensor::blur(Vec2& position) {
  if (!(model_.position_noise > 0.0)) return false;
  position.x += random_.normal(0.0, model_.position_noise);
  position.y += random_.normal(0.0, model_.position_noise);
  return true;
}

bool Sensor::blurHeading(double& heading) {
  if (!(model_.heading_noise > 0.0)) return false;
  heading = math::wrapAngle(heading + random_.normal(0.0, model_.heading_noise));
  return true;
}

}  // namespace fulbito
