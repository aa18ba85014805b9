#include "navigation/library/plugin_host.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "engine/core/system/error_text.hpp"
#include "fulbito/detail/build_info.hpp"

namespace fulbito {
namespace {

PluginHost& hostOf(const fulbito_host* table) { return *static_cast<PluginHost*>(table->data); }

const char* simulatorName() {
  static const std::string name = "fulbito " + buildInfo().version;
  return name.c_str();
}

}  // namespace

PluginHost::PluginHost(std::string owner, PluginLog log) : owner_(std::move(owner)), log_(std::move(log)) {
  table_.abi_version = FULBITO_ABI;
  table_.struct_size = sizeof(fulbito_host);
  table_.data = this;
  table_.simulator = simulatorName();
  table_.log = [](const fulbito_host* table, const char* line) {
    PluginHost& host = hostOf(table);
    host.last_line_ = line == nullptr ? "" : line;
    host.log(host.last_line_);
  };
  table_.random = [](const fulbito_host* table) { return hostOf(table).rng_.bits64(); };
  table_.get_extension = [](const fulbito_host* table, const char* name) -> const void* {
    const std::string_view wanted = name == nullptr ? "" : name;
    if (wanted == FULBITO_EXT_RULES_TEXT) return hostOf(table).rules_text_.c_str();
    return wanted == FULBITO_EXT_CURVE_WIDENING ? &hostOf(table).widening_ : nullptr;
  };
}

void PluginHost::begin(std::uint64_t seed, std::string rules_text) {
  rng_ = Rng(seed, Stream::kLibraryTeam);
  rules_text_ = std::move(rules_text);
}

void PluginHost::log(std::string_view line) {
  const std::string text = fmt::format("{}: {}", owner_, terminalText(line));
  if (log_) {
    log_(text);
  } else {
    std::fprintf(stderr, "%s\n", text.c_str());
  }
}

}  // namespace fulbito
