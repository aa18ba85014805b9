#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace fulbito {

/// The differences between two JSON values, for people: "plan.pairs: 2 -> 5". Members of arrays count from 1.
/// Texts in TOML are compared key by key.
std::vector<std::string> changesOf(const nlohmann::ordered_json& before, const nlohmann::ordered_json& after);

}  // namespace fulbito
