#include <algorithm>
#include <csignal>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

/// A sandbox with a recorded match of 20 s, g.fbr.
struct Recorded : Sandbox {
  Recorded() { REQUIRE(run("match classic chaser --half-seconds 10 --seed 3 --record g.fbr").code == 0); }
  Output make(const std::string& arguments) const { return run("replay export g.fbr " + arguments); }
  std::string bytes(const std::string& name) const { return contentOf(path / name); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }
};

bool has(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

std::string shell(const Sandbox& box, const std::string& command) {
  (void)std::system(("cd '" + box.path.string() + "' && { " + command + "; } >shell.txt 2>&1").c_str());
  const std::string text = contentOf(box.path / "shell.txt");
  fs::remove(box.path / "shell.txt");
  return text;
}

constexpr const char* kPng = "\x89PNG\r\n\x1a\n";

}  // namespace

TEST_CASE("pictures of a moment, an event and a range", "[cli]") {
  const Recorded box;
  const Output one = box.make("--png shot.png --at 8.2 --size 400 --theme light");
  CHECK(one.code == 0);
  CHECK(one.out.empty());
  CHECK(box.bytes("shot.png").starts_with(kPng));
  CHECK(box.bytes("shot.png").substr(16, 8) == std::string("\0\0\x01\x90\0\0\x01\x64", 8));  // 400 x 356
  const std::string first = box.bytes("shot.png");
  CHECK(box.make("--png shot.png --at 8.2 --size 400 --theme light").code == 2);
  CHECK(box.bytes("shot.png") == first);
  CHECK(box.make("--png shot.png --at 8.2 --size 400 --theme light --force").code == 0);
  CHECK(box.bytes("shot.png") == first);

  CHECK(box.make("--png some.png --at 1 2.5 3 --size 300").code == 0);
  for (const char* name : {"some-0001.png", "some-0002.png", "some-0003.png"})
    CHECK(fs::exists(box.path / name));
  CHECK_FALSE(fs::exists(box.path / "some.png"));

  CHECK(box.make("--png seq/f.png --from 1 --to 2").code == 5);  // no such folder
  CHECK(box.make("--png f.png --from 1 --to 2 --fps 4 --size 300 --jobs 3").code == 0);
  CHECK(fs::exists(box.path / "f-0005.png"));
  CHECK_FALSE(fs::exists(box.path / "f-0006.png"));

  const Output out = box.make("--png - --size 200x160");
  CHECK(out.code == 0);
  CHECK(out.out.starts_with(kPng));
  CHECK(out.err.empty());
}

TEST_CASE("every product is named after the recording unless it has a name", "[cli]") {
  const Recorded box;
  const Output made = box.make(
      "--size 800 --png --contact-sheet --trails --heatmap ball --svg --gif --csv --jsonl --from 2 --to 4 "
      "--fps 5");
  INFO(made.err);
  CHECK(made.code == 0);
  for (const char* name : {"g-0001.png", "g-sheet.png", "g-trails.png", "g-heatmap-ball.png", "g.svg",
                           "g.gif", "g.csv", "g.jsonl"}) {
    INFO(name);
    CHECK(fs::exists(box.path / name));
    CHECK(contains(made.err, name));
  }
  CHECK(box.bytes("g.gif").starts_with("GIF89a"));
  CHECK(box.bytes("g.csv").starts_with("tick,time_s,"));
  CHECK(Json::parse(box.bytes("g.jsonl").substr(0, box.bytes("g.jsonl").find('\n')))["teams"][0] ==
        "classic");
  if (has("xmllint")) CHECK(shell(box, "xmllint --noout g.svg").empty());
  CHECK(box.make("--heatmap yellow:1 heat.png --size 300").code == 0);
  CHECK(fs::exists(box.path / "heat.png"));
}

TEST_CASE("tables go to stdout and keep to their range", "[cli]") {
  const Recorded box;
  const Output csv = box.make("--csv - --from 5 --to 6");
  CHECK(csv.code == 0);
  CHECK(std::count(csv.out.begin(), csv.out.end(), '\n') >= 32);
  CHECK(std::count(csv.out.begin(), csv.out.end(), '\n') <= 34);
  CHECK(csv.err.empty());
}

TEST_CASE("what is not possible names the flag and what is", "[cli]") {
  const Recorded box;
  const std::size_t before = box.files();
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    const Output output = box.make(arguments);
    INFO(arguments << ": " << output.err);
    CHECK(output.code == 2);
    CHECK(output.out.empty());
    CHECK(contains(output.err, part));
  };
  refused("", "needs a product");
  refused("--png --at 31", "--at 31: the recording lasts from 0 to ");
  refused("--png --at -1", "--at -1");
  refused("--png --at nan", "'nan' is not a number");
  refused("--gif --from 30", "--from 30");
  refused("--gif --from 5 --to 4", "--from 5 is after --to 4");
  refused("--png --around shoot-out", "Recorded events: ");
  refused("--gif --highlights --to 0.1", "--highlights");
  refused("--png --size 10", "--size '10'");
  refused("--png --size 400x", "160 to 16384");
  refused("--png --theme pink", "--theme 'pink': must be dark or light");
  refused("--gif --fps 0", "--fps 0: must be 0.01 to 240");
  refused("--gif --speed -1", "--speed -1");
  refused("--heatmap referee", "--heatmap 'referee'");
  refused("--heatmap blue:9", "--heatmap 'blue:9'");
  refused("--mp4 --size 401x300", "--size 401x300: width and height of a video must be even");
  refused("--png - --csv -", "both write to stdout");
  refused("--png - --at 1 2", "2 pictures cannot be written to stdout");
  refused("--quality 99 --mp4", "--quality 99");
  CHECK(box.run("replay export none.fbr --png").code == 5);
  CHECK(box.make("--png /proc/none/x.png").code == 5);
  CHECK(box.make("--csv /dev/full --force").code == 5);
  CHECK(fs::is_character_file("/dev/full"));  // not renamed over
  CHECK(box.files() == before);
}

TEST_CASE("videos", "[cli]") {
  const Recorded box;
  if (!has("ffmpeg") || !has("ffprobe")) return;
  CHECK(box.make("--mp4 --size 320 --to 8 --fps 10 --speed 2").code == 0);
  const std::string probed =
      shell(box,
            "ffprobe -v error -count_frames -select_streams v -show_entries "
            "stream=codec_name,width,height,nb_read_frames,r_frame_rate -of csv=p=0 g.mp4");
  INFO(probed);
  CHECK(contains(probed, "h264,320,"));
  CHECK(contains(probed, "10/1"));
  CHECK(contains(probed, ",41"));
  const Output piped = box.make("--mp4 - --size 200x160 --to 1");
  CHECK(piped.code == 0);
  CHECK(piped.out.substr(4, 4) == "ftyp");
  const Output nowhere = box.make("--mp4 /nonexistent-folder/x.mp4 --size 200x160 --to 1");
  CHECK(nowhere.code == 5);
  CHECK(contains(nowhere.err, "/nonexistent-folder/x.mp4"));
}

TEST_CASE("several times make several SVG files", "[cli]") {
  const Recorded box;
  CHECK(box.make("--svg s.svg --at 1 2").code == 0);
  CHECK(contentOf(box.path / "s-0001.svg") != contentOf(box.path / "s-0002.svg"));
  CHECK(contentOf(box.path / "s-0001.svg").starts_with("<svg"));
  CHECK_FALSE(fs::exists(box.path / "s.svg"));
}

TEST_CASE("without ffmpeg a video says what to do", "[cli]") {
  const Recorded box;
  const std::string said =
      shell(box, "PATH=/nonexistent '" FULBITO_PROGRAM "' replay export g.fbr --mp4; echo code $?");
  CHECK(contains(said, "apt-get install ffmpeg"));
  CHECK(contains(said, "code 5"));
  CHECK(box.files() == 1);
}

TEST_CASE("an interrupted film leaves nothing behind", "[cli]") {
  const Recorded box;
  for (const char* what : {"--gif", "--mp4", "--png x.png --fps 200 --from 0"}) {
    if (std::string(what) == "--mp4" && !has("ffmpeg")) continue;
    // In the foreground `timeout` sends one signal; otherwise two, and a second one ends the program at once.
    const std::string said =
        shell(box, "timeout --foreground -s INT 0.5 '" FULBITO_PROGRAM "' replay export g.fbr " +
                       std::string(what) + " --speed 0.01 --size 800; echo code $?");
    INFO(said);
    CHECK(contains(said, "code 124"));
    for (const auto& entry : fs::directory_iterator(box.path)) {
      const std::string name = entry.path().filename();
      CHECK((name == "g.fbr" || (name.starts_with("x-") && name.ends_with(".png"))));
    }
  }
}

TEST_CASE("short films run in real time, long ones four times as fast", "[cli]") {
  const Recorded box;
  box.works("match idle idle --half-seconds 20 --record long.fbr");
  const auto frames = [&](const std::string& arguments) {
    box.works("replay export " + arguments + " --gif f.gif --size 200x160 --fps 5 --force");
    const std::string gif = box.bytes("f.gif");
    int count = 0;
    for (std::size_t at = gif.find("\x21\xf9\x04"); at != std::string::npos;
         at = gif.find("\x21\xf9\x04", at + 1)) {
      ++count;
    }
    return count;
  };
  CHECK(frames("g.fbr --from 2 --to 4") >= 10);
  CHECK(frames("g.fbr --from 2 --to 4 --speed 4") <= 4);
  CHECK(frames("long.fbr --to 30") >= 150);
  const int all = frames("long.fbr");
  CHECK(all >= 50);
  CHECK(all <= 54);  // the time before the signals is on the film too
}

TEST_CASE("one of several events can be named by its number", "[cli]") {
  const Recorded box;
  const auto pictures = [&](const std::string& around) {
    REQUIRE(box.make("--png e.png --size 200x160 --around " + around).code == 0);
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(box.path)) {
      if (entry.path().extension() == ".png") ++count;
    }
    for (const auto& entry : std::vector<fs::path>{fs::directory_iterator(box.path), {}}) {
      if (entry.extension() == ".png") fs::remove(entry);
    }
    return count;
  };
  CHECK(pictures("kick-off") >= 2);
  CHECK(pictures("kick-off:2") == 1);
  for (const char* wrong : {"kick-off:0", "kick-off:x", "kick-off:", "kick-off:99", "kick-off:1:1"}) {
    INFO(wrong);
    const Output refused = box.make(std::string("--png e.png --around ") + wrong);
    CHECK(refused.code == 2);
    CHECK(contains(refused.err, "--around kick-off:"));
  }
}
