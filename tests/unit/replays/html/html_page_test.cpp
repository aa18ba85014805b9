#include "replays/html/html_page.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "replays/coding/packing.hpp"
#include "replays/html/base64.hpp"
#include "replays/html/scene_columns.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/replays/html/inflate.hpp"
#include "tests/unit/replays/html/sample_scene.hpp"

namespace fulbito {
namespace {

std::string pageOf(PageKind kind, std::vector<PageScene> scenes) {
  const auto html = htmlPage({kind, "title", std::move(scenes)});
  REQUIRE(html);
  return *html;
}

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  REQUIRE(begin != std::string::npos);
  const std::size_t end = text.find(to, begin + from.size());
  REQUIRE(end != std::string::npos);
  return text.substr(begin + from.size(), end - begin - from.size());
}

}  // namespace

TEST_CASE("a page is whole: every part is in its place", "[unit]") {
  const std::string html = pageOf(PageKind::kReplay, {test::sampleScene()});
  CHECK(html.starts_with("<!doctype html>"));
  CHECK(html.ends_with("</html>\n"));
  CHECK(html.find("{{") == std::string::npos);
  // The name of a namespace, not an address.
  CHECK(html.find("http:") == html.find("http://www.w3.org/2000/svg"));
  CHECK(html.find("https:") == std::string::npos);
  const auto meta = nlohmann::json::parse(between(html, "id=\"meta\">", "</script>"));
  const std::string packed = test::bytesOfBase64(between(html, "id=\"data\">", "</script>"));
  CHECK(meta["payload"]["packed"] == packed.size());
  const std::string columns = test::inflated(packed, meta["payload"]["raw"]);
  CHECK(columns == packedColumns(test::sampleScene()));
  CHECK(meta["payload"]["crc"] == crc32Of(columns));
}

TEST_CASE("the page has the colours that pictures have", "[unit]") {
  const std::string html = pageOf(PageKind::kReplay, {test::sampleScene()});
  const std::string light = between(html, ":root {", "}");
  const std::string dark = between(html, ":root[data-theme=\"dark\"] {", "}");
  const auto has = [](const std::string& variables, std::string name, unsigned rgb) {
    std::replace(name.begin(), name.end(), '_', '-');
    return variables.find(fmt::format(" --{}: #{:06x};", name, rgb)) != std::string::npos;
  };
#define SHARED_COLOUR(name, light_rgb, dark_rgb) \
  CHECK(has(light, #name, light_rgb));           \
  CHECK(has(dark, #name, dark_rgb));
#define SERIES_COLOUR(number, rgb) CHECK(has(light, "series-" #number, rgb));
#include "replays/render/colours/shared_colours.def"
#undef SHARED_COLOUR
#undef SERIES_COLOUR
}

TEST_CASE("the security policy names digests of what the page runs", "[unit]") {
  const std::string html = pageOf(PageKind::kReplay, {test::sampleScene()});
  const std::string policy = between(html, "Content-Security-Policy\" content=\"", "\"");
  CHECK(policy.starts_with("default-src 'none'; script-src 'sha256-"));
  CHECK(policy.find("unsafe") == std::string::npos);
  // Digests of two scripts and a style sheet, of 32 bytes each.
  std::size_t digests = 0;
  for (std::size_t at = policy.find("'sha256-"); at != std::string::npos;
       at = policy.find("'sha256-", at + 1)) {
    CHECK(policy.find('\'', at + 1) - at == 8 + 44);
    ++digests;
  }
  CHECK(digests == 3);
}

TEST_CASE("the same page gives the same bytes", "[unit]") {
  CHECK(pageOf(PageKind::kReplay, {test::sampleScene()}) == pageOf(PageKind::kReplay, {test::sampleScene()}));
}

TEST_CASE("texts in the place of marks are not looked at again", "[unit]") {
  PageScene scene = test::sampleScene();
  scene.title = "{{data}}{{style}}";
  const std::string html = pageOf(PageKind::kReplay, {scene});
  CHECK(nlohmann::json::parse(between(html, "id=\"meta\">", "</script>"))["scenes"][0]["title"] ==
        scene.title);
}

TEST_CASE("a page needs a scene, and a ghost the same bodies", "[unit]") {
  CHECK(htmlPage({PageKind::kReplay, "", {}}).error().code == ErrorCode::kUsage);
  PageScene other = test::sampleScene();
  CHECK(htmlPage({PageKind::kGhost, "", {test::sampleScene(), other}}));
  other.bodies[1].id = RobotId{TeamId::kYellow, 1};
  const auto refused = htmlPage({PageKind::kGhost, "", {test::sampleScene(), other}});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("--ghost") != std::string::npos);
}

}  // namespace fulbito
