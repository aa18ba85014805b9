#include "apps/replay/export_flags.hpp"

#include <algorithm>
#include <span>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace fulbito::app {
namespace {

/// A flag, and the products that it applies to.
struct Use {
  const char* flag;
  std::vector<std::string_view> products;
};

const std::vector<Use>& uses() {
  static const std::vector<std::string_view> kStills{"--png", "--contact-sheet", "--svg"};
  static const std::vector<std::string_view> kScenes{"--png", "--contact-sheet", "--svg",
                                                     "--gif", "--mp4",           "--webm"};
  static const std::vector<std::string_view> kCalls{"--png", "--contact-sheet", "--svg",   "--gif",
                                                    "--mp4", "--webm",          "--trails"};
  static const std::vector<std::string_view> kPictures{"--png", "--contact-sheet", "--svg",    "--gif",
                                                       "--mp4", "--webm",          "--trails", "--heatmap"};
  static const std::vector<std::string_view> kRanges{"--png",     "--contact-sheet", "--svg", "--gif",
                                                     "--mp4",     "--webm",          "--csv", "--trails",
                                                     "--heatmap", "--jsonl"};
  static const std::vector<std::string_view> kFilms{"--png", "--gif", "--mp4", "--webm"};
  static const std::vector<Use> kUses{{"--ghost", {"--html"}},   {"--at", kStills},
                                      {"--around", kCalls},      {"--highlights", kCalls},
                                      {"--from", kRanges},       {"--to", kRanges},
                                      {"--fps", kFilms},         {"--speed", kFilms},
                                      {"--size", kPictures},     {"--theme", kPictures},
                                      {"--trail", kScenes},      {"--no-banner", kCalls},
                                      {"--no-drawings", kCalls}, {"--quality", {"--mp4", "--webm"}},
                                      {"--jobs", kFilms}};
  return kUses;
}

}  // namespace

Result<void> checkExportFlags(const ReplayExportCommand& options) {
  const auto given = [&](std::string_view flag) { return options.command->count(std::string(flag)) > 0; };
  for (const Use& use : uses()) {
    if (!given(use.flag) || std::any_of(use.products.begin(), use.products.end(), given)) continue;
    return fail(ErrorCode::kUsage, fmt::format("{}: no requested product uses it; it applies to {}", use.flag,
                                               fmt::join(use.products, ", ")));
  }
  return {};
}

}  // namespace fulbito::app
