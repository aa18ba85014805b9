#pragma once

#include "navigation/interface/parameters.hpp"

namespace fulbito {

/// Drives straight toward the goal and avoids nothing. It is the reference in the tables of results.
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
