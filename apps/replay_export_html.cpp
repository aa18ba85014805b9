#include "apps/replay_export_html.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "apps/commands.hpp"
#include "engine/core/output_file.hpp"
#include "replays/html/html_page.hpp"
#include "replays/html/recorded_scene.hpp"

namespace fulbito::app {
namespace {

Result<PageScene> sceneOf(const std::string& file) {
  const auto named = [&](const Error& error) {
    return fail(error.code, error.message.starts_with(file) ? error.message : file + ": " + error.message);
  };
  const auto recording = RecordingReader::open(file);
  if (!recording) return tl::unexpected<Error>(recording.error());
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

Result<std::string> pageOf(const HtmlExport& options) {
  Page page;
  auto scene = sceneOf(options.file);
  if (!scene) return tl::unexpected<Error>(scene.error());
  page.title = titleOf(*scene);
  page.scenes.push_back(std::move(*scene));
  if (!options.ghost.empty()) {
    auto ghost = sceneOf(options.ghost);
    if (!ghost) return tl::unexpected<Error>(ghost.error());
    page.kind = PageKind::kGhost;
    page.scenes.push_back(std::move(*ghost));
  }
  return htmlPage(page);
}

}  // namespace

int replayExportHtml(const HtmlExport& options) {
  const auto html = pageOf(options);
  if (!html) return report(html.error());
  if (options.html == "-") {
    std::fwrite(html->data(), 1, html->size(), stdout);
    return std::fflush(stdout) == 0 ? kOk : kIo;
  }
  if (auto written = writeFile(options.html, *html); !written) return report(written.error());
  return kOk;
}

}  // namespace fulbito::app
