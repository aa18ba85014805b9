#include "bridge/wire/wire_settings.hpp"

#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "navigation/interface/parameters.hpp"

namespace fulbito::wire {
namespace {

constexpr const char* kName = "wire";
constexpr const char* kForm = "wire:blue, wire:yellow@10002, wire:yellow:speed=2 or wire:run=COMMAND";
constexpr const char* kInterface = "interface";

const std::vector<Parameter<WireSettings>>& parameters() {
  static const std::vector<Parameter<WireSettings>> kParameters{
      number<WireSettings>("speed", &WireSettings::speed, 0.1, 20.0, "", "pace of the frames over real time"),
      flag<WireSettings>("lockstep", &WireSettings::lockstep,
                         "the next frame follows as soon as the client has answered this one"),
      number<WireSettings>("answer", &WireSettings::answer, 0.001, 60.0, "s",
                           "with lockstep: longest wait for an answer"),
      number<WireSettings>("placing", &WireSettings::placing, 0.0, 60.0, "s",
                           "longest wait for a placement at a restart, over speed"),
      number<WireSettings>("wait", &WireSettings::wait, 0.0, 86400.0, "s",
                           "time without a client after which its team forfeits; 0: it never does"),
      flag<WireSettings>("lock", &WireSettings::lock, "commands of other senders than the first are ignored"),
      flag<WireSettings>("team_ports", &WireSettings::team_ports,
                         "commands also come at a port for each colour, as TraveSim has them"),
  };
  return kParameters;
}

tl::unexpected<Error> wrong(const std::string& whole, const std::string& what) {
  return fail(ErrorCode::kUsage, fmt::format("team '{}': {}; write {}", whole, what, kForm));
}

Result<TeamId> colourOf(std::string_view text, const std::string& whole) {
  for (const TeamId team : kTeams) {
    if (text == nameOf(team)) return team;
  }
  return wrong(whole, fmt::format("'{}' is neither blue nor yellow", text));
}

Result<int> portBaseOf(std::string_view text, const std::string& whole) {
  int port = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), port);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || port < 1 ||
      port > kLargestPortBase) {
    return wrong(whole, fmt::format("'{}' is no first port, 1 ... {}", text, kLargestPortBase));
  }
  return port;
}

/// Takes `run=COMMAND` from the end: a command may contain all that separates other parts.
Result<std::string> takeRun(std::string& text, const std::string& whole) {
  constexpr std::string_view kRun = "run=";
  for (std::size_t at = text.find(kRun); at != std::string::npos; at = text.find(kRun, at + 1)) {
    if (at > 0 && text[at - 1] != ':' && text[at - 1] != ',') continue;
    std::string command = text.substr(at + kRun.size());
    text.erase(at > 0 ? at - 1 : 0);
    if (command.find_first_not_of(' ') == std::string::npos) return wrong(whole, "run= has no command");
    return command;
  }
  return std::string();
}

Result<void> apply(std::vector<Setting> given, WireSettings& settings) {
  std::erase_if(given, [&](const Setting& setting) {
    if (setting.name != kInterface) return false;
    settings.interface = setting.value;
    return true;
  });
  return applySettings(parameters(), given, kName, settings, {kInterface});
}

}  // namespace

std::vector<ParameterSpec> wireParameters() { return specsOf(parameters()); }

bool isWire(const std::string& specification) {
  return specification == kName || specification.starts_with(std::string(kName) + ':');
}

Result<WireSeat> parseWire(const std::string& specification) {
  std::string rest = specification == kName ? "" : specification.substr(std::string_view(kName).size() + 1);
  auto run = takeRun(rest, specification);
  if (!run) return tl::unexpected<Error>(run.error());
  // A client that is started alone in its network may have any colour, so it need not be named.
  if (!run->empty() && (rest.empty() || rest.find('=') < rest.find(':'))) {
    rest.insert(0, rest.empty() ? "blue" : "blue:");
  }
  const std::size_t colon = rest.find(':');
  const std::string_view seat = std::string_view(rest).substr(0, colon);
  const std::size_t at = seat.find('@');
  const auto colour = colourOf(seat.substr(0, at), specification);
  if (!colour) return tl::unexpected<Error>(colour.error());
  WireSeat parsed{*colour, {}, std::move(*run)};
  if (at != std::string_view::npos) {
    const auto port = portBaseOf(seat.substr(at + 1), specification);
    if (!port) return tl::unexpected<Error>(port.error());
    parsed.settings.port_base = *port;
  }
  if (colon == std::string::npos) return parsed;
  auto given = parseSettings(rest.substr(colon + 1), specification);
  if (!given) return tl::unexpected<Error>(given.error());
  if (auto applied = apply(std::move(*given), parsed.settings); !applied) {
    return tl::unexpected<Error>(applied.error());
  }
  return parsed;
}

}  // namespace fulbito::wire
