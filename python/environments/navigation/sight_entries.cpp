#include <fmt/format.h>

#include "python/environments/navigation/sight.hpp"

namespace fulbito {
namespace {

using namespace navigation_sight;

std::vector<SightEntry> entriesOfAll() {
  std::vector<SightEntry> entries = {
      {"goal-x", "m", "the goal ahead of the robot"},
      {"goal-y", "m", "the goal to its left"},
      {"goal-distance", "m", "distance of the goal"},
      {"goal-cos", "", "cosine of the goal's bearing"},
      {"goal-sin", "", "sine of the same"},
      {"arrive-cos", "", "cosine of the wanted heading, seen from the robot's; 0: any heading"},
      {"arrive-sin", "", "sine of the same"},
      {"forward", "", "its speed along its heading, over the top speed"},
      {"sideways", "", "its speed to its left, over the top speed"},
      {"yaw", "", "its yaw rate, over that of a spin at top speed"},
      {"wheel-left", "", "speed of the left wheel, over its top speed"},
      {"wheel-right", "", "the same of the right wheel"},
      {"top-speed", "m/s", "the robot's top speed"}};
  for (std::size_t i = 0; i < kRays; ++i) {
    entries.push_back(
        {fmt::format("ray-{}", i), "m",
         fmt::format("from the robot's centre to the nearest obstacle or wall {} degrees to its left, "
                     "at most {} m",
                     static_cast<double>(i) * 360.0 / kRays, kFarthest)});
  }
  for (std::size_t i = 1; i <= kDiscs; ++i) {
    const std::string name = fmt::format("obstacle-{}-", i);
    entries.push_back({name + "present", "", "1: there is such an obstacle; else its numbers are 0"});
    entries.push_back({name + "x", "m", "ahead of the robot; the nearest obstacle comes first"});
    entries.push_back({name + "y", "m", "to its left"});
    entries.push_back({name + "radius", "m", "its radius"});
    entries.push_back({name + "vx", "", "its velocity along the robot's heading, over the top speed"});
    entries.push_back({name + "vy", "", "to the robot's left, over the top speed"});
  }
  for (std::size_t i = 0; i < kSonars; ++i) {
    entries.push_back({fmt::format("sonar-{}", i), "m", "reading of that sonar; 0: the robot has none"});
  }
  return entries;
}

}  // namespace

const std::vector<SightEntry>& navigationSight() {
  static const std::vector<SightEntry> kEntries = entriesOfAll();
  return kEntries;
}

}  // namespace fulbito
