#include "replays/html/html_page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/core/config/embedded_files.hpp"
#include "replays/html/base64.hpp"
#include "replays/html/deflate.hpp"
#include "replays/html/page_json.hpp"
#include "replays/html/scene_columns.hpp"

namespace fulbito {

std::span<const EmbeddedFile> embeddedPage();

namespace {

std::string_view fileOf(std::string_view name) {
  const auto files = embeddedPage();
  const auto found = std::find_if(files.begin(), files.end(), [&](const auto& f) { return f.name == name; });
  return found == files.end() ? std::string_view{} : found->text;
}

std::string sourceOf(std::string_view digest) {
  return fmt::format("'sha256-{}'", base64Of(bytesOfHex(digest)));
}

/// Replaces each mark `{{name}}` by its text; marks inside the texts are not replaced.
std::string filled(std::string_view form,
                   const std::vector<std::pair<std::string_view, std::string>>& texts) {
  std::string out;
  while (!form.empty()) {
    const std::size_t open = form.find("{{"), close = form.find("}}", open);
    out += form.substr(0, open);
    if (open == std::string_view::npos || close == std::string_view::npos) break;
    const std::string_view name = form.substr(open + 2, close - open - 2);
    for (const auto& [known, text] : texts) {
      if (known == name) out += text;
    }
    form.remove_prefix(close + 2);
  }
  return out;
}

bool sameBodies(const PageScene& a, const PageScene& b) {
  return std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(),
                    [](const PageBody& x, const PageBody& y) { return x.kind == y.kind && x.id == y.id; });
}

Result<void> check(const Page& page) {
  if (page.scenes.empty()) return fail(ErrorCode::kUsage, "a page needs at least one scene");
  if (page.kind == PageKind::kGhost &&
      (page.scenes.size() != 2 || !sameBodies(page.scenes[0], page.scenes[1]))) {
    return fail(ErrorCode::kUsage, "--ghost: the two recordings do not have the same robots and balls");
  }
  return {};
}

}  // namespace

Result<std::string> htmlPage(const Page& page) {
  if (auto checked = check(page); !checked) return tl::unexpected<Error>(checked.error());
  std::string columns;
  PagePayload payload;
  for (const PageScene& scene : page.scenes) {
    const std::string packed = packedColumns(scene);
    payload.sizes.push_back(packed.size());
    columns += packed;
  }
  const std::string packed = deflated(columns);
  payload.raw = columns.size();
  payload.packed = packed.size();
  payload.crc = crc32Of(columns);
  return filled(fileOf("page"),
                {{"script-digests", sourceOf(FULBITO_LOADER_DIGEST) + " " + sourceOf(FULBITO_VIEWER_DIGEST)},
                 {"style-digest", sourceOf(FULBITO_STYLE_DIGEST)},
                 {"style", std::string(fileOf("style"))},
                 {"loader", std::string(fileOf("loader"))},
                 {"viewer", base64Of(deflated(fileOf("viewer")))},
                 {"meta", pageJson(page, payload)},
                 {"data", base64Of(packed)}});
}

}  // namespace fulbito
