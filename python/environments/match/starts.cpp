#include "python/environments/match/starts.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "engine/core/config/schemas.hpp"
#include "engine/core/config/suggest.hpp"
#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kGap = 0.01;     // [m] least distance between two bodies, and from a body to a wall
constexpr int kMostDraws = 1000;  // of a body before the field counts as full

/// The keys of robot files with their tables, bound to `models`.
std::vector<std::pair<std::string, SchemaKey>> keysOf(RobotPreset& models) {
  std::vector<std::pair<std::string, SchemaKey>> keys;
  for (const SchemaKey& key : schemaOf(models.robot)) keys.emplace_back("robot." + key.key, key);
  for (const SchemaKey& key : schemaOf(models.ball)) keys.emplace_back("ball." + key.key, key);
  std::erase_if(keys,
                [](const auto& entry) { return !std::holds_alternative<double*>(entry.second.target); });
  return keys;
}

/// The largest free distance that a random place may have from walls and other bodies.
class FreePlaces {
 public:
  FreePlaces(const FieldGeometry& field, Rng& random) : field_(field), random_(random) {}

  /// A place for a disc; empty if there is none.
  std::optional<Vec2> draw(double radius) {
    for (int i = 0; i < kMostDraws; ++i) {
      const double x = field_.length / 2, y = field_.width / 2;
      const Vec2 place{random_.uniform(-x, x), random_.uniform(-y, y)};
      if (wallClearance(field_, place) < radius + kGap || !isFree(place, radius)) continue;
      taken_.push_back({place, radius});
      return place;
    }
    return std::nullopt;
  }

 private:
  bool isFree(Vec2 place, double radius) const {
    return std::all_of(taken_.begin(), taken_.end(), [&](const auto& disc) {
      return distance(place, disc.first) >= radius + disc.second + kGap;
    });
  }

  const FieldGeometry& field_;
  Rng& random_;
  std::vector<std::pair<Vec2, double>> taken_;
};

}  // namespace

Result<Placement> randomPlacement(const MatchConfig& match, std::uint64_t seed) {
  Rng random(seed, Stream::kEpisodeStart);
  FreePlaces places(match.field, random);
  const Error full{ErrorCode::kUsage, "start: the field has no room for all bodies"};
  Placement placement;
  const auto ball = places.draw(match.robot.ball.radius);
  if (!ball) return tl::unexpected<Error>(full);
  placement.ball = *ball;
  for (const TeamId team : kTeams) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(match.rules.team_size); ++i) {
      const auto place = places.draw(match.robot.robot.circumradius());
      if (!place) return tl::unexpected<Error>(full);
      placement.robots[indexOf(team)][i] = Pose2{*place, random.uniform(-math::kPi, math::kPi)};
    }
  }
  return placement;
}

Result<void> checkRanges(const MatchTask& task) {
  RobotPreset models = task.match.robot;
  const auto keys = keysOf(models);
  for (const ModelRange& range : task.ranges) {
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.first == range.key; });
    if (found == keys.end()) {
      std::vector<std::string> names;
      names.reserve(keys.size());
      for (const auto& [name, key] : keys) names.push_back(name);
      return fail(ErrorCode::kUsage,
                  fmt::format("randomise: there is no '{}'.{}", range.key, suggestion(range.key, names)));
    }
    for (const double end : {range.low, range.high}) {
      const SchemaKey& key = found->second;
      if (const auto flaw = checkNumber(end, key.minimum, key.maximum, key.unit)) {
        return fail(ErrorCode::kUsage, "randomise: " + range.key + " " + *flaw);
      }
    }
    if (range.low > range.high) {
      return fail(ErrorCode::kUsage,
                  fmt::format("randomise: {}: {} ... {} is empty", range.key, range.low, range.high));
    }
  }
  return {};
}

void drawModels(const std::vector<ModelRange>& ranges, std::uint64_t seed, RobotPreset& models) {
  if (ranges.empty()) return;
  Rng random(seed, Stream::kEpisodeModels);
  const auto keys = keysOf(models);
  for (const ModelRange& range : ranges) {
    for (const auto& [name, key] : keys) {
      if (name == range.key) *std::get<double*>(key.target) = random.uniform(range.low, range.high);
    }
  }
}

}  // namespace fulbito
