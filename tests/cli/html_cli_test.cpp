#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

constexpr const char* kMatch = "match chaser idle --half-seconds 3 --record ";

std::string partOf(const std::string& html, const std::string& mark) {
  const std::size_t begin = html.find(mark);
  REQUIRE(begin != std::string::npos);
  return html.substr(begin + mark.size(), html.find("</script>", begin) - begin - mark.size());
}

}  // namespace

TEST_CASE("replay export --html writes a page, to a file or stdout, and the same one twice", "[cli]") {
  const Sandbox box;
  REQUIRE(box.run(std::string(kMatch) + "a.fbr").code == 0);
  const Output made = box.run("replay export a.fbr --html a.html");
  REQUIRE(made.code == 0);
  const std::string html = contentOf(box.path / "a.html");
  CHECK(made.err.starts_with("a.html: "));
  CHECK(made.err.ends_with(" kB\n"));
  CHECK(html.starts_with("<!doctype html>"));
  CHECK(Json::parse(partOf(html, "id=\"meta\">"))["scenes"][0]["teams"] == Json{"chaser", "idle"});
  CHECK(box.run("replay export a.fbr --html -").out == html);
}

TEST_CASE("replay export --html replaces a file only with --force", "[cli]") {
  const Sandbox box;
  REQUIRE(box.run(std::string(kMatch) + "a.fbr").code == 0);
  box.write("a.html", "mine");
  const Output refused = box.run("replay export a.fbr --html a.html");
  CHECK(refused.code == 2);
  CHECK(refused.err.find("--force") != std::string::npos);
  CHECK(contentOf(box.path / "a.html") == "mine");
  CHECK(box.run("replay export a.fbr --html a.html --force").code == 0);
  CHECK(contentOf(box.path / "a.html") != "mine");
}

TEST_CASE("replay export --html says what is wrong", "[cli]") {
  const Sandbox box;
  REQUIRE(box.run(std::string(kMatch) + "a.fbr").code == 0);
  box.write("bad.fbr", "nothing");
  CHECK(box.run("replay export bad.fbr --html a.html").code == 3);
  CHECK(box.run("replay export none.fbr --html a.html").code == 5);
  const Output nowhere = box.run("replay export a.fbr --html no/folder.html");
  CHECK(nowhere.code == 5);
  CHECK(nowhere.err.find("no/folder.html': there is no folder 'no'") != std::string::npos);
  CHECK_FALSE(fs::exists(box.path / "no"));
  CHECK(box.run("replay export a.fbr --html a.html --ghost bad.fbr").code == 3);
  REQUIRE(box.run("match chaser idle --rules vsss-5v5 --half-seconds 2 --record b.fbr").code == 0);
  const Output other = box.run("replay export a.fbr --html a.html --ghost b.fbr");
  CHECK(other.code == 2);
  CHECK(other.err.find("same robots") != std::string::npos);
  CHECK_FALSE(fs::exists(box.path / "a.html"));
}

TEST_CASE("compare --html puts every drawn layout into one page", "[cli]") {
  const Sandbox box;
  const std::string compare =
      "compare --suite corner --speeds 1.0 --trials 3 --navigators bezier straight --out o ";
  REQUIRE(box.run(compare + "--pictures 2 --html races.html").code == 0);
  const Json page = Json::parse(partOf(contentOf(box.path / "races.html"), "id=\"meta\">"));
  CHECK(page["kind"] == "races");
  REQUIRE(page["scenes"].size() == 2);
  CHECK(page["scenes"][1]["title"] == "corner-1 at 1.0 m/s");
  CHECK(page["scenes"][0]["runs"][0]["label"] == "bezier");
  CHECK(box.run(compare + "--pictures 0 --html none.html").code == 2);
  CHECK_FALSE(fs::exists(box.path / "none.html"));
  const Output nowhere = box.run(compare + "--html no/races.html");
  CHECK(nowhere.code == 5);
  CHECK(nowhere.err.find("no/races.html': there is no folder 'no'") != std::string::npos);
  CHECK_FALSE(fs::exists(box.path / "no"));
  CHECK(box.run(compare + "--html o/races.html").code == 0);
}
