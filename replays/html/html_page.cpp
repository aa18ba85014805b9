#include "replays/html/html_page.hpp"

#include <algorithm>

#include "engine/core/config/embedded_files.hpp"
#include "replays/coding/packing.hpp"
#include "replays/html/base64.hpp"
#include "replays/html/page_form.hpp"
#include "replays/html/page_json.hpp"
#include "replays/html/scene_columns.hpp"

namespace fulbito {

std::span<const EmbeddedFile> embeddedPage();

namespace {

std::string_view fileOf(std::string_view name) { return textOfFile(embeddedPage(), name); }

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
  return filledForm(fileOf("page"), {{"script-digests", allowedDigest(FULBITO_LOADER_DIGEST) + " " +
                                                            allowedDigest(FULBITO_VIEWER_DIGEST)},
                                     {"style-digest", allowedDigest(FULBITO_STYLE_DIGEST)},
                                     {"style", std::string(fileOf("style"))},
                                     {"loader", std::string(fileOf("loader"))},
                                     {"viewer", base64Of(deflated(fileOf("viewer")))},
                                     {"meta", pageJson(page, payload)},
                                     {"data", base64Of(packed)}});
}

}  // namespace fulbito
