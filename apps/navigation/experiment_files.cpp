#include "apps/navigation/experiment_files.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/core/system/output_file.hpp"
#include "experiments/paper_report/scene_picture.hpp"
#include "fulbito/report.hpp"
#include "replays/export/gif.hpp"
#include "replays/html/html_page.hpp"

namespace fulbito::app {
namespace {

constexpr double kPictureWidth = 1000;                                  // [px]
constexpr double kGifWidth = 460, kGifFps = 12.5, kLongestFilm = 12.0;  // [px], [Hz], [s]
constexpr std::size_t kLastFrames = 12;  // copies of the last frame, so that the end is shown for a second

/// The rows to show in a film: in real time if that takes at most `kLongestFilm`, else evenly spread over it.
std::vector<std::size_t> filmRows(const PageScene& page) {
  const double seconds = static_cast<double>(page.rows.back().tick) / page.rate;
  const double speed = std::max(1.0, seconds / kLongestFilm);
  const auto frames = static_cast<std::size_t>(std::floor(seconds / speed * kGifFps)) + 1;
  std::vector<std::size_t> rows;
  for (std::size_t f = 0, row = 0; f < frames; ++f) {
    const double tick = static_cast<double>(f) * speed / kGifFps * page.rate;
    while (row + 1 < page.rows.size() && static_cast<double>(page.rows[row + 1].tick) <= tick) ++row;
    rows.push_back(row);
  }
  rows.insert(rows.end(), kLastFrames, page.rows.size() - 1);
  return rows;
}

/// The scene as a looping GIF.
Result<std::string> sceneGif(const ReportScene& scene) {
  const ScenePicture picture(scene, kGifWidth);
  const auto whole = picture.drawWhole();
  if (!whole) return tl::unexpected<Error>(whole.error());
  const auto middle = picture.draw(scene.page.rows.size() / 2);
  if (!middle) return tl::unexpected<Error>(middle.error());
  const GifPalette palette({&*whole, &*middle});
  auto gif = GifWriter::create(whole->width(), whole->height(), palette, static_cast<int>(100 / kGifFps));
  if (!gif) return tl::unexpected<Error>(gif.error());
  GifIndexer indexer(palette);
  std::string indices;
  for (const std::size_t row : filmRows(scene.page)) {
    const auto frame = picture.draw(row);
    if (!frame) return tl::unexpected<Error>(frame.error());
    indices.clear();
    indexer.index(*frame, indices);
    if (auto added = gif->add(indices); !added) return tl::unexpected<Error>(added.error());
  }
  return gif->finish();
}

/// Writes files into a folder and keeps their names. If it may not replace a file of another kind, it still
/// writes the other files.
class Folder {
 public:
  explicit Folder(std::string path) : path_(std::move(path)) {}

  Result<void> write(const std::string& name, const Result<std::string>& content) {
    if (!content) return tl::unexpected<Error>(content.error());
    return noted(name, writeFile(path_ + "/" + name, *content, false));
  }
  Result<void> write(const std::string& name, const Result<Canvas>& canvas) {
    if (!canvas) return tl::unexpected<Error>(canvas.error());
    return noted(name, canvas->writePng(path_ + "/" + name));
  }
  std::vector<std::string> names;
  std::optional<Error> refused;  ///< error of the first file that it could not replace

 private:
  Result<void> noted(const std::string& name, Result<void> written) {
    if (written) names.push_back(name);
    if (written || written.error().code != ErrorCode::kUsage) return written;
    if (!refused) refused = written.error();
    return {};
  }

  std::string path_;
};

Result<void> writeTables(const ExperimentReport& report, Folder& folder) {
  for (const ReportTable& table : report.tables) {
    if (auto written = folder.write(table.name + ".csv", Result<std::string>(tableCsv(table))); !written) {
      return written;
    }
  }
  return {};
}

Result<void> writePictures(const ExperimentReport& report, Folder& folder) {
  for (const ReportChart& chart : report.charts) {
    if (auto written = folder.write(chart.name + ".png", drawLineChart(chart.chart)); !written)
      return written;
  }
  for (const ReportScene& scene : report.scenes) {
    const ScenePicture picture(scene, kPictureWidth);
    if (auto written = folder.write(scene.name + ".png", picture.drawWhole()); !written) return written;
    if (scene.isStill()) continue;
    if (auto written = folder.write(scene.name + ".gif", sceneGif(scene)); !written) return written;
  }
  return {};
}

Result<void> writePage(const ExperimentReport& report, Folder& folder) {
  Page page{PageKind::kRaces, report.title, {}};
  for (const ReportScene& scene : report.scenes) {
    if (!scene.isStill()) page.scenes.push_back(scene.page);
  }
  if (page.scenes.empty()) return {};
  return folder.write(report.name + ".html", htmlPage(page));
}

}  // namespace

Result<std::vector<std::string>> writeExperiment(const ExperimentReport& report,
                                                 const ExperimentRequest& request,
                                                 const std::string& folder) {
  Folder files(folder);
  auto done = files.write("results.json", Result<std::string>(experimentJson(report, request)));
  if (done) done = writeTables(report, files);
  if (done) done = writePictures(report, files);
  if (done) done = writePage(report, files);
  if (!done) return tl::unexpected<Error>(done.error());
  if (files.refused) return tl::unexpected<Error>(*files.refused);
  return files.names;
}

}  // namespace fulbito::app
