#pragma once

#include "fulbito/detail/math.hpp"
#include "fulbito/detail/page_scene.hpp"

namespace fulbito::test {

/// A scene with two robots, a ball and a box. In the second of two plays the second robot is absent, and all
/// bodies are far from their places in the first.
inline PageScene sampleScene() {
  PageScene scene;
  scene.title = "sample";
  scene.teams = {"one", "two"};
  scene.ticks = 40;
  scene.seed = 0xfedcba9876543210u;
  scene.bodies = {{BodyKind::kRobot, RobotId{TeamId::kBlue, 0}, true, 0.08, 0.07, 0.0},
                  {BodyKind::kRobot, RobotId{TeamId::kYellow, 0}, true, 0.08, 0.07, 0.0},
                  {BodyKind::kBall, {}, false, 0.0, 0.0, 0.0215},
                  {BodyKind::kObstacle, {}, true, 0.1, 0.2, 0.0}};
  for (const Tick begin : {Tick{0}, Tick{20}}) {
    PagePlay play;
    play.row = scene.rows.size();
    play.tick = begin;
    play.signal = begin + 4;
    play.kind = "free-ball";
    play.team = TeamId::kYellow;
    play.present = {1, static_cast<std::uint8_t>(begin == 0 ? 1 : 0), 1, 1};
    scene.plays.push_back(play);
    for (Tick tick = begin; tick <= begin + 20; tick += 2) {
      const double t = 0.31 * static_cast<double>(tick), side = begin == 0 ? 1.0 : -1.0;
      PageRow row{tick, {}};
      row.poses = {{{side * 0.5, 0.001 * t * t}, math::wrapAngle(1.1 * t)},
                   {math::unit(t) * 0.4, math::wrapAngle(-2.3 * t)},
                   {math::unit(-t) * (0.02 * t), 0.0},
                   {{0.3, -0.3}, 0.7}};
      scene.rows.push_back(row);
    }
  }
  scene.commands.every = 10;
  for (int i = 0; i < 4; ++i) {
    scene.commands.values.push_back({10.4 * i, -3.6 * i});
    scene.commands.values.push_back({-46.0, 46.0});
  }
  return scene;
}

}  // namespace fulbito::test
