#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fulbito/models.hpp"
#include "python/bindings/sources.hpp"
#include "python/environments/match/task.hpp"

namespace fulbito::python {

/// @{ Arguments that environments share. Errors: UsageError with the argument's
/// name. The quality of observations; empty if no argument asks for any.
inline std::optional<SensorModel> readSensors(const Arguments& from) {
  constexpr int kNone = std::numeric_limits<int>::min();
  const double none = std::numeric_limits<double>::quiet_NaN();
  const int latency = from.get<int>("latency_ticks", kNone, "whole number");
  SensorModel sensors;
  bool any = latency != kNone;
  if (any) sensors.latency_ticks = latency;
  for (const auto& [name, value] :
       {std::pair{"position_noise", &sensors.position_noise},
        std::pair{"heading_noise", &sensors.heading_noise}, std::pair{"dropout", &sensors.dropout}}) {
    const double given = from.get<double>(name, none, "number");
    if (std::isnan(given)) continue;
    any = true;
    *value = given;
  }
  return any ? std::optional(sensors) : std::nullopt;
}

inline std::vector<ModelRange> readRanges(const Arguments& from) {
  std::vector<ModelRange> ranges;
  using Ranges = std::map<std::string, std::pair<double, double>>;
  for (const auto& [key, range] : from.get<Ranges>("randomise", {}, "dict of pairs of numbers")) {
    ranges.push_back({key, range.first, range.second});
  }
  return ranges;
}

/// Replaces the weights that the argument `rewards` names.
template <std::size_t kCount>
void readWeights(const Arguments& from, const std::array<std::string_view, kCount>& terms,
                 std::array<double, kCount>& weights) {
  using Weights = std::map<std::string, double>;
  for (const auto& [name, value] : from.get<Weights>("rewards", {}, "dict of numbers")) {
    const auto found = std::find(terms.begin(), terms.end(), name);
    if (found == terms.end()) {
      std::string all;
      for (const std::string_view term : terms) all += (all.empty() ? "" : ", ") + std::string(term);
      raise(ErrorCode::kUsage, "rewards: '" + name + "' is none of " + all);
    }
    weights[static_cast<std::size_t>(found - terms.begin())] = value;
  }
}
/// @}

/// Entries of an observation as a list of (name, unit, meaning).
template <typename Entries>
nanobind::list tableOf(const Entries& entries) {
  nanobind::list rows;
  for (const auto& entry : entries) rows.append(nanobind::make_tuple(entry.name, entry.unit, entry.meaning));
  return rows;
}

}  // namespace fulbito::python
