#include <fmt/format.h>

#include "engine/core/config/config_document.hpp"
#include "engine/core/config/embedded_files.hpp"
#include "engine/core/config/schemas.hpp"
#include "engine/core/system/text_file.hpp"
#include "fulbito/models.hpp"

namespace fulbito {
namespace {

struct LayoutFile {
  ConfigDocument document;
  Layout layout;
};

Result<void> readObstacles(const ConfigDocument& document, std::vector<ObstacleSpec>& obstacles) {
  const auto count = document.count("obstacle");
  if (!count) return tl::unexpected<Error>(count.error());
  for (int i = 0; i < *count; ++i) {
    ObstacleSpec obstacle;
    if (auto read = document.readElement("obstacle", i, schemaOf(obstacle)); !read) return read;
    if (!document.elementHas("obstacle", i, "position")) {
      if (obstacle.motion != ObstacleMotion::kPath) {
        return document.locate({"obstacle", i, "position", "is missing"});
      }
      if (!obstacle.path.empty()) obstacle.pose.position = obstacle.path.front();
    }
    obstacles.push_back(std::move(obstacle));
  }
  return {};
}

Result<LayoutFile> readLayout(std::string_view text, const std::string& origin) {
  // The last three tables hold what a paper's figure states about the layout. Only the comparison reads them.
  static const std::vector<std::string> kTables{"layout", "start", "goal", "obstacle",
                                                "figure", "run",   "sweep"};
  auto document = ConfigDocument::parse(text, origin, kTables);
  if (!document) return tl::unexpected<Error>(document.error());
  Layout layout;
  layout.name = document->fallbackName();
  if (auto r = document->read("layout", layoutSchema(layout), false); !r)
    return tl::unexpected<Error>(r.error());
  if (auto r = document->read("start", startSchema(layout), true); !r)
    return tl::unexpected<Error>(r.error());
  if (auto r = document->read("goal", goalSchema(layout), true); !r) return tl::unexpected<Error>(r.error());
  if (auto r = readObstacles(*document, layout.obstacles); !r) return tl::unexpected<Error>(r.error());
  if (const auto flaw = findFlaw(layout)) return document->locate(*flaw);
  return LayoutFile{std::move(*document), std::move(layout)};
}

// Whether the key affects the obstacle. Other keys are written only if they differ from the default.
bool matters(const std::string& key, const ObstacleSpec& o) {
  if (key == "radius") return o.shape == ObstacleShape::kDisc;
  if (key == "length" || key == "width") return o.shape == ObstacleShape::kBox;
  if (key == "path" || key == "speed" || key == "path_end") return o.motion == ObstacleMotion::kPath;
  if (key == "mass" || key == "floor_friction") return o.motion == ObstacleMotion::kPushable;
  return true;
}

std::string obstacleText(ObstacleSpec obstacle) {
  ObstacleSpec fresh;
  const Schema defaults = schemaOf(fresh);
  const Schema all = schemaOf(obstacle);
  Schema written;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool changed = valueText(all[i]) != valueText(defaults[i]);
    if (matters(all[i].key, obstacle) || changed) written.push_back(all[i]);
  }
  return tableText(written, false);
}

}  // namespace

Result<Layout> parseLayout(std::string_view text, const std::string& origin) {
  auto file = readLayout(text, origin);
  if (!file) return tl::unexpected<Error>(file.error());
  return std::move(file->layout);
}

Result<Layout> loadLayout(const std::string& path) {
  const auto text = readTextFile(path, kMaxTomlBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  auto file = readLayout(*text, path);
  if (!file) return tl::unexpected<Error>(file.error());
  Layout& layout = file->layout;
  if (isFileName(layout.field) && !layout.field.starts_with('/')) {
    const std::size_t slash = path.rfind('/');
    if (slash != std::string::npos) layout.field = path.substr(0, slash + 1) + layout.field;
  }
  const auto field = loadField(layout.field);
  if (!field) {
    // An unknown field in a layout is bad input; the error of an unreadable field file keeps its code.
    Error error =
        file->document.locate({"layout", -1, "field", "cannot be used: " + field.error().message}).value();
    if (const ErrorCode code = field.error().code; code == ErrorCode::kIo || code == ErrorCode::kMachine)
      error.code = code;
    return tl::unexpected<Error>(std::move(error));
  }
  if (const auto flaw = findFlaw(layout, *field)) return file->document.locate(*flaw);
  return layout;
}

std::string toToml(const Layout& layout) {
  Layout copy = layout;
  std::string text = fmt::format("[layout]\n{}\n[start]\n{}\n[goal]\n{}", tableText(layoutSchema(copy), true),
                                 tableText(startSchema(copy), true), tableText(goalSchema(copy), true));
  for (const ObstacleSpec& obstacle : layout.obstacles) {
    text += fmt::format("\n[[obstacle]]\n{}", obstacleText(obstacle));
  }
  return text;
}

}  // namespace fulbito
