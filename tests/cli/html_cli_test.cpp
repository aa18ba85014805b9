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
  box.works(std::string(kMatch) + "a.fbr");
  const Output made = box.run("replay export a.fbr --html a.html");
  REQUIRE(made.code == 0);
  const std::string html = contentOf(box.path / "a.html");
  CHECK(made.err.starts_with("a.html: "));
  CHECK(made.err.ends_with(" kB\n"));
  CHECK(html.starts_with("<!doctype html>"));
  CHECK(Json::parse(partOf(html, "id=\"meta\">"))["scenes"][0]["teams"] == Json{"chaser", "idle"});
  CHECK(box.run("replay export a.fbr --html -").out == html);
}

TEST_CASE("replay export --html says what is wrong", "[cli]") {
  const Sandbox box;
  box.works(std::string(kMatch) + "a.fbr");
  box.write("bad.fbr", "nothing");
  CHECK(box.run("replay export bad.fbr --html a.html").code == 3);
  CHECK(box.run("replay export none.fbr --html a.html").code == 5);
  box.fails("replay export a.fbr --html no/folder.html", 5, "no/folder.html': there is no folder 'no'");
  CHECK_FALSE(fs::exists(box.path / "no"));
  CHECK(box.run("replay export a.fbr --html a.html --ghost bad.fbr").code == 3);
  box.works("match chaser idle --rules vsss-5v5 --half-seconds 2 --record b.fbr");
  box.fails("replay export a.fbr --html a.html --ghost b.fbr", 2, "same robots");
  CHECK_FALSE(fs::exists(box.path / "a.html"));
}

TEST_CASE("compare --html puts every drawn layout into one page", "[cli]") {
  const Sandbox box;
  const std::string compare =
      "compare --suite corner --speeds 1.0 --trials 3 --navigators bezier straight --out o ";
  box.works(compare + "--pictures 2 --html races.html");
  const Json page = Json::parse(partOf(contentOf(box.path / "races.html"), "id=\"meta\">"));
  CHECK(page["kind"] == "races");
  REQUIRE(page["scenes"].size() == 2);
  CHECK(page["scenes"][1]["title"] == "corner-1 at 1.0 m/s");
  CHECK(page["scenes"][0]["runs"][0]["label"] == "bezier");
  CHECK(box.run(compare + "--pictures 0 --html none.html").code == 2);
  CHECK_FALSE(fs::exists(box.path / "none.html"));
  box.fails(compare + "--html no/races.html", 5, "no/races.html': there is no folder 'no'");
  CHECK_FALSE(fs::exists(box.path / "no"));
  CHECK(box.run(compare + "--html o/races.html").code == 0);
}
