#pragma once

#include <optional>

#include "navigation/methods/hybrid/body_room.hpp"
#include "navigation/methods/hybrid/free_strip.hpp"
#include "navigation/methods/hybrid/way_search.hpp"

namespace fulbito {

/// Takes a robot through a narrow place on its way:
///  1. from anywhere to the stage, 8 cm before the place and square to it;
///  2. along its axis up to the entry. A robot that is off the axis there backs out, nearer to the axis, and
///     comes again; one that leans turns;
///  3. on along the axis until its rear corners are out. The axis follows the map. The front corners' sonars
///  turn the robot away from a side that is too near.
class StripGuide {
 public:
  /// What a tick knows.
  struct View {
    const NavigationScene& scene;
    const ProvenMap& map;
    const WaySearch& way;
    const BodyRoom& room;
    double size = 1.0;                  ///< see `bodySize`
    std::optional<double> left, right;  ///< [m] what the front corners' sonars hear
  };

  void reset();
  /// The twist through the narrow place; empty where there is none. Lengths and speeds in m and m/s.
  std::optional<Twist> drive(const View& view);
  bool isActive() const { return strip_.has_value(); }

 private:
  /// Beside the front corners.
  struct FrontRoom {
    std::optional<double> left, right;  ///< [m]
  };
  FrontRoom frontRoom(const View& view) const;
  double frontOffset(const View& view) const;
  void keepOff(const View& view, Twist& twist) const;
  void follow(const View& view);
  void begin(const View& view);
  std::optional<Twist> toStage(const View& view);
  std::optional<Twist> backOut(const View& view, double aside);
  std::optional<Twist> through(const View& view);
  Twist alongAxis(const View& view, double front, double aside);

  StripFinder finder_;
  std::optional<FreeStrip> strip_;
  std::optional<Pose2> stage_;
  Tick stage_until_ = 0;
  int lost_ = 0;  ///< ticks without a strip at the place
  bool backs_out_ = false;
  Vec2 backs_from_;
};

}  // namespace fulbito
