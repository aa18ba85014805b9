#pragma once

#include "navigation/interface/parameters.hpp"

namespace fulbito {

/// Drives straight at the goal and avoids nothing: the reference that every table starts from.
class Straight final : public Navigator, public HeadingField {
 public:
  struct Params {};
  explicit Straight(Params = {}) {}
  void reset() override {}
  Guidance plan(const NavigationScene& scene) override;
  double heading(Vec2 p) const override;

 private:
  Vec2 goal_;
};

}  // namespace fulbito
