#include "tournament/plan/plan.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "tournament/statistics/elo.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kMostEntrants = 1000;
constexpr std::size_t kLongestName = 200;  // [bytes]

Result<void> checkNames(const TournamentPlan& plan) {
  std::unordered_set<std::string_view> names;
  for (const Entrant& entrant : plan.entrants) {
    if (entrant.name.empty() || entrant.name.size() > kLongestName) {
      return fail(ErrorCode::kUsage,
                  fmt::format("the name of an entrant must have 1 ... {} bytes", kLongestName));
    }
    if (!names.insert(entrant.name).second) {
      return fail(ErrorCode::kUsage,
                  fmt::format("two entrants are named '{}'; give one another name", entrant.name));
    }
  }
  return {};
}

}  // namespace

std::string_view nameOf(TournamentFormat format) { return kFormatNames[static_cast<std::size_t>(format)]; }

std::optional<TournamentFormat> formatOf(std::string_view name) {
  const auto* const found = std::find(kFormatNames.begin(), kFormatNames.end(), name);
  if (found == kFormatNames.end()) return std::nullopt;
  return static_cast<TournamentFormat>(found - kFormatNames.begin());
}

std::uint64_t seedOfStart(std::uint64_t seed, std::size_t start) {
  if (start == 0) return seed;
  // 53 bits, so that JSON readers can hold it as a double.
  return Rng(seed, Stream::kSeries, start).bits64() >> 11;
}

Result<void> validate(const SprtBounds& bounds) {
  const double most = std::floor(kMostStrength * kEloPerStrength);
  if (!(bounds.weak < bounds.strong) || std::abs(bounds.weak) > most || std::abs(bounds.strong) > most) {
    return fail(ErrorCode::kUsage,
                fmt::format("bounds: want two rising values within -{0:.0f} ... {0:.0f} normalized Elo, not "
                            "{1:g} and {2:g}",
                            most, bounds.weak, bounds.strong));
  }
  for (const auto& [name, rate] : {std::pair{"alpha", bounds.alpha}, std::pair{"beta", bounds.beta}}) {
    if (!(rate >= 1e-6 && rate <= 0.25)) {
      return fail(ErrorCode::kUsage, fmt::format("{}: {:g} is outside 0.000001 ... 0.25", name, rate));
    }
  }
  return {};
}

Result<void> validate(const TournamentPlan& plan) {
  if (plan.entrants.size() > kMostEntrants) {
    return fail(ErrorCode::kUsage, fmt::format("a tournament has at most {} entrants", kMostEntrants));
  }
  if (auto checked = checkNames(plan); !checked) return checked;
  if (plan.sprt) {
    if (auto checked = validate(*plan.sprt); !checked) return checked;
  }
  return {};
}

}  // namespace fulbito
