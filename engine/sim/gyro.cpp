#include <cmath>

#include "fulbito/sensors.hpp"

namespace fulbito {

double Gyro::read(double turned, double dt) {
  bias_ += random_.normal(0.0, model_.drift * std::sqrt(dt));
  return model_.scale * turned / dt + bias_ + random_.normal(0.0, model_.noise);
}

}  // namespace fulbito
