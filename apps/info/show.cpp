#include <cstdio>

#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "engine/core/config/suggest.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"

namespace fulbito::app {
namespace {

int showCase(const std::string& name) {
  std::vector<std::string> names;
  for (const Layout& layout : namedCases()) {
    if (layout.name == name) {
      writeOut(toToml(layout));
      return kOk;
    }
    names.push_back(layout.name);
  }
  return report({ErrorCode::kUsage, fmt::format("there is no case '{}'.{}", name, suggestion(name, names))});
}

int showPreset(const std::string& kind, const std::string& name) {
  const auto text = presetText(kind, name);
  if (!text) return report(text.error());
  writeOut(*text);
  return kOk;
}

}  // namespace

int show(const ShowOptions& options) {
  static const std::vector<std::string> kinds = {"robot", "physics", "field", "rules", "case"};
  if (options.kind == "robot") return showPreset("robots", options.name);
  if (options.kind == "physics") return showPreset("physics", options.name);
  if (options.kind == "field") return showPreset("fields", options.name);
  if (options.kind == "rules") {
    const auto text = rulesPresetText(options.name);
    if (!text) return report(text.error());
    writeOut(*text);
    return kOk;
  }
  if (options.kind == "case") return showCase(options.name);
  return report(
      {ErrorCode::kUsage, fmt::format("show: there is no kind '{}'; it must be one of {}.{}", options.kind,
                                      fmt::join(kinds, ", "), suggestion(options.kind, kinds))});
}

}  // namespace fulbito::app
