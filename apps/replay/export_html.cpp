#include "apps/replay/export_html.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/outputs.hpp"
#include "apps/replay/export_request.hpp"
#include "engine/core/system/error_text.hpp"
#include "engine/core/system/output_file.hpp"
#include "replays/html/html_page.hpp"
#include "replays/html/recorded_scene.hpp"
#include "replays/verify/expand.hpp"

namespace fulbito::app {
namespace {

constexpr const char* kStdout = "-";

Result<PageScene> sceneOf(const std::string& file) {
  const auto named = [&](const Error& error) { return inFile(file, error); };
  const auto opened = RecordingReader::open(file);
  if (!opened) return tl::unexpected<Error>(opened.error());
  const auto recording = expanded(*opened);
  if (!recording) return named(recording.error());
  const auto timeline = ReplayTimeline::read(*recording);
  if (!timeline) return named(timeline.error());
  auto scene = recordedScene(*recording, *timeline);
  if (!scene) return named(scene.error());
  return scene;
}

std::string titleOf(const PageScene& scene) {
  if (scene.teams.size() != 2) return scene.title.empty() ? "Trial" : scene.title;
  return fmt::format("{} – {}", scene.teams[0], scene.teams[1]);
}

Result<std::string> pageOf(const std::string& file, const std::string& ghost_file) {
  Page page;
  auto scene = sceneOf(file);
  if (!scene) return tl::unexpected<Error>(scene.error());
  page.title = titleOf(*scene);
  page.scenes.push_back(std::move(*scene));
  if (!ghost_file.empty()) {
    auto ghost = sceneOf(ghost_file);
    if (!ghost) return tl::unexpected<Error>(ghost.error());
    page.kind = PageKind::kGhost;
    page.scenes.push_back(std::move(*ghost));
  }
  return htmlPage(page);
}

Result<void> writePage(const std::string& file, const std::string& html) {
  if (file != kStdout) return writeFile(file, html);
  writeOut(html);  // `finishOutput` reports failures
  return {};
}

}  // namespace

void addHtmlOptions(CLI::App& command, HtmlExport& options) {
  markOutput(
      command
          .add_option("--html", options.html, "an HTML page with viewer and replay in one file; - for stdout")
          ->type_name("OUT"),
      {OutputKind::kPage, Dash::kStdout});
  command.add_option("--ghost", options.ghost, "with --html: a second recording, drawn over the first")
      ->type_name("FILE");
}

Result<std::string> replayPage(const std::string& file) { return pageOf(file, {}); }

int replayExportHtml(const std::string& file, const HtmlExport& options) {
  const auto html = pageOf(file, options.ghost);
  if (!html) return report(html.error());
  if (auto written = writePage(options.html, *html); !written) return report(written.error());
  announce(options.html, sizeText(html->size()));
  return kOk;
}

}  // namespace fulbito::app
