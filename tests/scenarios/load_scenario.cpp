#include <array>

#include <fmt/format.h>

#include "engine/core/config/config_document.hpp"
#include "engine/core/system/text_file.hpp"
#include "tests/scenarios/scenario.hpp"

namespace fulbito::test {
namespace {

constexpr double kFar = 20.0, kFast = 100.0, kLong = 10000.0;

/// Turns texts of a file into values and remembers the first that is wrong.
class Words {
 public:
  explicit Words(std::string origin) : origin_(std::move(origin)) {}

  TeamId team(const std::string& text) {
    if (text == "yellow") return TeamId::kYellow;
    if (text != "blue") complain(text, "a team");
    return TeamId::kBlue;
  }
  RobotId robot(const std::string& text) {
    const bool blue = text.starts_with("blue"), yellow = text.starts_with("yellow");
    const std::string number = text.substr(blue ? 4 : std::min<std::size_t>(6, text.size()));
    if ((!blue && !yellow) || number.size() != 1 || number[0] < '0' || number[0] > '9') {
      complain(text, "a robot such as blue0");
      return {};
    }
    return {blue ? TeamId::kBlue : TeamId::kYellow, static_cast<std::uint8_t>(number[0] - '0')};
  }
  std::optional<RobotId> robotOrBall(const std::string& text) {
    if (text == "ball") return std::nullopt;
    return robot(text);
  }
  RestartKind restart(const std::string& text) {
    for (int i = 0; i <= static_cast<int>(RestartKind::kGiven); ++i) {
      if (text == nameOf(static_cast<RestartKind>(i))) return static_cast<RestartKind>(i);
    }
    complain(text, "a restart");
    return {};
  }
  const std::string& error() const { return error_; }

 private:
  void complain(const std::string& text, const std::string& what) {
    if (error_.empty()) error_ = fmt::format("{}: '{}' is not {}", origin_, text, what);
  }
  std::string origin_, error_;
};

/// One table of the file, read and turned into a value of the scenario.
struct Reader {
  const ConfigDocument& document;
  Words& words;
  Scenario& scenario;

  Result<void> each(const std::string& table, Result<void> (Reader::*read)(int)) {
    const auto count = document.count(table);
    if (!count) return tl::unexpected<Error>(count.error());
    for (int i = 0; i < *count; ++i) {
      if (auto done = (this->*read)(i); !done) return done;
    }
    return {};
  }

  Result<void> robot(int i) {
    ScenarioRobot r;
    std::string id;
    const Schema schema = {{"id", &id, 1, 10, "", "", true},
                           {"position", &r.pose.position, -kFar, kFar, "m", "", true},
                           {"heading", Heading{&r.pose.heading}, -360, 360, "", ""},
                           {"velocity", &r.velocity, -kFast, kFast, "m/s", ""}};
    if (auto done = document.readElement("robot", i, schema); !done) return done;
    r.id = words.robot(id);
    scenario.robots.push_back(r);
    return {};
  }

  Result<void> move(int i) {
    ScenarioMove m;
    std::string body;
    Vec2 wheels, position, velocity;
    double heading = 0.0;
    const Schema schema = {{"body", &body, 1, 10, "", "", true},
                           {"at", &m.at, 0, kLong, "s", ""},
                           {"wheels", &wheels, -kFast, kFast, "rad/s", ""},
                           {"position", &position, -kFar, kFar, "m", ""},
                           {"heading", Heading{&heading}, -360, 360, "", ""},
                           {"velocity", &velocity, -kFast, kFast, "m/s", ""}};
    if (auto done = document.readElement("move", i, schema); !done) return done;
    m.robot = words.robotOrBall(body);
    if (has("move", i, "wheels")) m.wheels = WheelSpeeds{wheels.x, wheels.y};
    if (has("move", i, "position")) m.position = position;
    if (has("move", i, "heading") || has("move", i, "heading_deg")) m.heading = heading;
    if (has("move", i, "velocity")) m.velocity = velocity;
    scenario.moves.push_back(m);
    return {};
  }

  Result<void> contact(int i) {
    ScenarioContact c;
    std::string a, b;
    const Schema schema = {{"a", &a, 1, 10, "", "", true},
                           {"b", &b, 1, 10, "", "", true},
                           {"from", &c.from, 0, kLong, "s", ""},
                           {"until", &c.until, 0, kLong, "s", "", true},
                           {"impulse", &c.impulse, 0, 10, "kg m/s", ""}};
    if (auto done = document.readElement("contact", i, schema); !done) return done;
    if (a != "wall" || b != "ball") c.a = words.robot(a);
    c.b = words.robotOrBall(b);
    scenario.contacts.push_back(c);
    return {};
  }

  Result<void> expect(int i) {
    ExpectedEvent e;
    std::string team, restart, restart_team;
    int robot_number = 0;
    const Schema schema = {
        {"clause", &e.clause, 1, 40, "", "", true},     {"team", &team, 1, 10, "", ""},
        {"robot", &robot_number, -1, 10, "", ""},       {"restart", &restart, 1, 20, "", ""},
        {"restart_team", &restart_team, 1, 10, "", ""}, {"from", &e.from, 0, kLong, "s", ""},
        {"until", &e.until, 0, kLong, "s", "", true}};
    if (auto done = document.readElement("expect", i, schema); !done) return done;
    if (has("expect", i, "team")) e.team = words.team(team);
    if (has("expect", i, "robot")) e.robot = robot_number;
    if (has("expect", i, "restart")) e.restart = words.restart(restart);
    if (has("expect", i, "restart_team")) e.restart_team = words.team(restart_team);
    scenario.expected.push_back(e);
    return {};
  }

  Result<void> stand(int i) {
    ExpectedPlace p;
    std::string id;
    const Schema schema = {{"id", &id, 1, 10, "", "", true},
                           {"position", &p.position, -kFar, kFar, "m", "", true}};
    if (auto done = document.readElement("stand", i, schema); !done) return done;
    p.id = words.robot(id);
    scenario.places.push_back(p);
    return {};
  }

  bool has(const std::string& table, int i, std::string_view key) const {
    return document.elementHas(table, i, key);
  }
};

Result<void> readHead(const ConfigDocument& document, Words& words, const std::string& folder, Scenario& s) {
  std::string rules = "vsss-3v3", absent;
  Vec2 score{-1.0, -1.0};
  bool delays = false;
  const Schema schema = {
      {"description", &s.description, 10, 400, "", "", true},
      {"rules", &rules, 1, 100, "", ""},
      {"mode", choice(s.mode, {"kinematic", "physics"}), 0, 0, "", ""},
      {"start", choice(s.start, {"given", "opening"}), 0, 0, "", ""},
      {"goes_on", &s.goes_on, 0, 0, "", ""},
      {"delays", &delays, 0, 0, "", ""},
      {"seconds", &s.seconds, 0.0, kLong, "s", "", true},
      {"forbid", &s.forbid, 1, 400, "", ""},
      {"absent", &absent, 0, 10, "", ""},
      {"score", &score, -100, 100, "goals", ""},
  };
  if (auto done = document.read("scenario", schema, true); !done) return done;
  if (absent == "both") {
    s.present = {false, false};
  } else if (!absent.empty()) {
    s.present[indexOf(words.team(absent))] = false;
  }
  if (score != Vec2{-1.0, -1.0}) s.score = score;
  auto loaded = loadRules(rules.ends_with(".toml") ? folder + "/" + rules : rules);
  if (!loaded) return tl::unexpected<Error>(loaded.error());
  s.rules = *loaded;
  if (!delays) s.rules.restart.delay = s.rules.restart.goal_delay = 0.0;
  return document.read(
      "ball",
      {{"position", &s.ball, -kFar, kFar, "m", ""}, {"velocity", &s.ball_velocity, -kFast, kFast, "m/s", ""}},
      false);
}

}  // namespace

Result<Scenario> loadScenario(const std::string& folder, const std::string& name) {
  const std::string path = folder + "/scenario.toml";
  const auto text = readTextFile(path, kMaxTomlBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  const std::array<std::string, 7> tables = {"scenario", "ball",   "robot", "move",
                                             "contact",  "expect", "stand"};
  const auto document = ConfigDocument::parse(*text, path, tables);
  if (!document) return tl::unexpected<Error>(document.error());
  Scenario scenario;
  scenario.name = name;
  Words words(path);
  if (auto done = readHead(*document, words, folder, scenario); !done)
    return tl::unexpected<Error>(done.error());
  Reader reader{*document, words, scenario};
  for (const auto& [table, read] :
       {std::pair{"robot", &Reader::robot}, std::pair{"move", &Reader::move},
        std::pair{"contact", &Reader::contact}, std::pair{"expect", &Reader::expect},
        std::pair{"stand", &Reader::stand}}) {
    if (auto done = reader.each(table, read); !done) return tl::unexpected<Error>(done.error());
  }
  if (!words.error().empty()) return fail(ErrorCode::kBadInput, words.error());
  return scenario;
}

}  // namespace fulbito::test
