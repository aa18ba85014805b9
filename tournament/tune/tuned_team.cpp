#include "tournament/tune/tuned_team.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "bridge/outside/team_command.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {
namespace {

constexpr double kGrid = 1e-5;  // coarsest step of values, as share of the range
constexpr int kMostDecimals = 17;
constexpr std::string_view kProgram = "cmd:";

bool isNumeric(const ParameterSpec& spec) {
  return spec.type == ParameterSpec::Type::kNumber || spec.type == ParameterSpec::Type::kInteger;
}

/// The number in a text, if the whole text is a number.
std::optional<double> numberIn(std::string_view text) {
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

int decimalsOf(double range) {
  int decimals = 0;
  for (double grid = 1.0; grid > kGrid * range && decimals < kMostDecimals; grid /= 10.0) ++decimals;
  return decimals;
}

std::string withoutZeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

const Setting* findSetting(const std::vector<Setting>& settings, const std::string& name) {
  const Setting* found = nullptr;  // the last of several settings with the same name counts
  for (const Setting& setting : settings) {
    if (setting.name == name) found = &setting;
  }
  return found;
}

/// Parses one word of `--parameters`.
class WordReader {
 public:
  WordReader(const TeamChoice& team, const TunedTeam& parts, double perturbation, double step)
      : team_(team), parts_(parts), perturbation_(perturbation), step_(step) {}

  Result<TunedParameter> declared(const ParameterSpec& spec) const {
    TunedParameter p{spec.name,
                     spec.type == ParameterSpec::Type::kInteger,
                     spec.default_value,
                     spec.minimum,
                     spec.maximum,
                     perturbation_,
                     step_};
    if (const Setting* setting = findSetting(parts_.settings, spec.name)) {
      const auto value = parseParameter(spec, setting->value);
      if (!value) return tl::unexpected<Error>(value.error());
      p.start = *value;
    }
    return p;
  }

  Result<TunedParameter> read(const std::string& word) const {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    auto begun = begin(name, equals != std::string::npos);
    if (!begun || equals == std::string::npos) return begun;
    return withFields(std::move(*begun), std::string_view(word).substr(equals + 1));
  }

 private:
  Result<TunedParameter> begin(const std::string& name, bool fields) const {
    const auto& specs = team_.info->parameters;
    if (specs.empty() && fields) {
      TunedParameter p{name, false, NAN, NAN, NAN, perturbation_, step_};
      if (const Setting* setting = findSetting(parts_.settings, name)) {
        p.start = numberIn(setting->value).value_or(NAN);
      }
      return p;
    }
    if (specs.empty()) {
      return fail(
          ErrorCode::kUsage,
          fmt::format("team '{}' declares no parameters; give limits: {}=START:LOW:HIGH", team_.text, name));
    }
    const auto index = findParameter(specs, name, team_.text);
    if (!index) return tl::unexpected<Error>(index.error());
    if (isNumeric(specs[*index])) return declared(specs[*index]);
    return fail(ErrorCode::kUsage, fmt::format("parameter '{}' is no number: it cannot be tuned", name));
  }

  static Result<TunedParameter> withFields(TunedParameter p, std::string_view text) {
    const double low = p.low, high = p.high;
    double unit_perturbation = NAN;
    double* const fields[] = {&p.start, &p.low, &p.high, &unit_perturbation, &p.step};
    std::size_t field = 0;
    for (std::size_t at = 0; at <= text.size(); ++field) {
      const std::size_t end = std::min(text.find(':', at), text.size());
      const std::string_view part = text.substr(at, end - at);
      const auto value = numberIn(part);
      if (field >= std::size(fields) || (!part.empty() && !value)) {
        return fail(ErrorCode::kUsage,
                    fmt::format("parameter '{}': '{}' is not START:LOW:HIGH[:C_END[:R_END]]", p.name, text));
      }
      if (value) *fields[field] = *value;
      at = end + 1;
    }
    if (p.low < low || p.high > high) {
      return fail(ErrorCode::kUsage,
                  fmt::format("parameter '{}': the team allows {:g} ... {:g}", p.name, low, high));
    }
    if (!std::isnan(unit_perturbation)) p.perturbation = unit_perturbation / (p.high - p.low);
    return p;
  }

  const TeamChoice& team_;
  const TunedTeam& parts_;
  double perturbation_, step_;
};

Result<ParameterChoice> allOf(const TeamChoice& team, const WordReader& reader) {
  ParameterChoice choice;
  for (const ParameterSpec& spec : team.info->parameters) {
    if (!isNumeric(spec)) {
      choice.skipped.push_back(spec.name);
      continue;
    }
    auto parameter = reader.declared(spec);
    if (!parameter) return tl::unexpected<Error>(parameter.error());
    choice.parameters.push_back(std::move(*parameter));
  }
  if (choice.parameters.empty()) {
    return fail(ErrorCode::kUsage, fmt::format("team '{}' declares no numeric parameters; name them: "
                                               "--parameters NAME=START:LOW:HIGH",
                                               team.text));
  }
  return choice;
}

/// Position of the settings in a command line: the colon that begins its last word.
Result<std::size_t> settingsOfProgram(const std::string& text, const std::vector<Setting>& settings) {
  const std::size_t space = text.rfind(" :");
  if (space != std::string::npos) {
    const auto read = parseSettings(text.substr(space + 2), text);
    if (read && read->size() == settings.size()) return space;
  }
  return fail(ErrorCode::kUsage, fmt::format("team '{}': write its settings without quotes", text));
}

}  // namespace

Result<TunedTeam> TunedTeam::of(const TeamChoice& team) {
  const std::string& text = team.text;
  if (!isOutside(text)) return TunedTeam{text.substr(0, text.find(':')), false, team.settings};
  auto line = parseTeamCommand(text);
  if (!line) return tl::unexpected<Error>(line.error());
  if (!text.starts_with(kProgram)) return TunedTeam{text.substr(0, text.find(':')), false, line->settings};
  if (line->settings.empty()) return TunedTeam{text, true, {}};
  const auto end = settingsOfProgram(text, line->settings);
  if (!end) return tl::unexpected<Error>(end.error());
  return TunedTeam{text.substr(0, *end), true, std::move(line->settings)};
}

std::string TunedTeam::at(const std::vector<TunedParameter>& parameters, const TunePoint& point) const {
  std::vector<Setting> all = settings;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string& name = parameters[i].name;
    const std::string value = valueText(parameters[i], point[i]);
    bool there = false;
    for (Setting& setting : all) {
      if (setting.name == name) setting.value = value, there = true;
    }
    if (!there) all.push_back({name, value});
  }
  std::string text = stem;
  const char* separator = program ? " :" : ":";
  for (const Setting& setting : all) {
    text += fmt::format("{}{}={}", separator, setting.name, setting.value);
    separator = ",";
  }
  return text;
}

std::string valueText(const TunedParameter& parameter, double share) {
  const double range = parameter.high - parameter.low, value = parameter.low + share * range;
  if (parameter.whole) return fmt::format("{:.0f}", std::floor(value + 0.5));
  const std::string text = withoutZeros(fmt::format("{:.{}f}", value, decimalsOf(range)));
  const double read = numberIn(text).value_or(value);
  const double held = std::clamp(read, parameter.low, parameter.high);
  return held == read ? text : fmt::format("{}", held);
}

Result<ParameterChoice> parametersOf(const TeamChoice& team, const TunedTeam& parts,
                                     const std::vector<std::string>& words, double perturbation,
                                     double step) {
  const WordReader reader(team, parts, perturbation, step);
  ParameterChoice choice;
  if (words.empty()) {
    auto all = allOf(team, reader);
    if (!all) return all;
    choice = std::move(*all);
  }
  for (const std::string& word : words) {
    auto parameter = reader.read(word);
    if (!parameter) return tl::unexpected<Error>(parameter.error());
    choice.parameters.push_back(std::move(*parameter));
  }
  for (TunedParameter& p : choice.parameters) {
    if (p.whole) p.perturbation = std::max(p.perturbation, 0.5 / (p.high - p.low));
  }
  return choice;
}

}  // namespace fulbito
