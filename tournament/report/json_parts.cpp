#include "tournament/report/json_parts.hpp"

#include "engine/core/base/text_controls.hpp"

namespace fulbito {

Json intervalJson(const Interval& interval) {
  return {{"value", numberOrNull(interval.value)},
          {"low", numberOrNull(interval.low)},
          {"high", numberOrNull(interval.high)}};
}

Json sprtJson(const Sprt& sprt) {
  const SprtBounds& bounds = sprt.bounds();
  return {{"log_likelihood_ratio", sprt.ratio()},   {"pass_at", bounds.upper()}, {"fail_at", bounds.lower()},
          {"bounds", {bounds.weak, bounds.strong}}, {"alpha", bounds.alpha},     {"beta", bounds.beta}};
}

Json unplayedJson(const std::vector<UnplayedMatch>& unplayed) {
  Json json = Json::array();
  for (const UnplayedMatch& match : unplayed) {
    json.push_back({{"pair", match.fixture}, {"leg", match.leg + 1}, {"reason", match.reason}});
  }
  return json;
}

std::string indented(const Json& json, std::size_t spaces) {
  const std::string text = escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace));
  std::string out;
  for (const char c : text) {
    out += c;
    if (c == '\n') out.append(spaces, ' ');
  }
  return out;
}

}  // namespace fulbito
