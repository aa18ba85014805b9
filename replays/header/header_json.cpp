#include "replays/header/header_json.hpp"

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "replays/header/json_limit.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 2> kKinds{"match", "trial"};
constexpr std::array<std::string_view, 2> kLevels{"recipe", "full"};
constexpr std::array<std::string_view, 4> kBodies{"wall", "robot", "ball", "obstacle"};

/// Reads typed values from an object. After the first flaw, which it keeps, all values are defaults.
class Fields {
 public:
  Fields(const Json& object, std::string where, std::string& flaw)
      : object_(object), where_(std::move(where)), flaw_(flaw) {
    if (!object.is_object()) complain("", "is not an object");
  }

  const Json* find(const char* key) {
    if (!object_.is_object()) return nullptr;
    const auto found = object_.find(key);
    if (found != object_.end()) return &*found;
    complain(key, "is missing");
    return nullptr;
  }
  void text(const char* key, std::string& to) {
    if (const Json* value = find(key)) take(key, *value, to);
  }
  void number(const char* key, double& to) {
    const Json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_number()) return complain(key, "is not a number");
    to = value->get<double>();
  }
  void number(const char* key, bool& to) {
    const Json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_boolean()) return complain(key, "is not true or false");
    to = value->get<bool>();
  }
  /// A whole number from 0 to `most`.
  template <typename T>
  void whole(const char* key, std::uint64_t most, T& to) {
    const Json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_number_unsigned() || value->get<std::uint64_t>() > most) {
      return complain(key, fmt::format("is not a whole number from 0 to {}", most));
    }
    to = static_cast<T>(value->get<std::uint64_t>());
  }
  template <typename T, std::size_t N>
  void choice(const char* key, const std::array<std::string_view, N>& names, T& to) {
    std::string name;
    text(key, name);
    for (std::size_t i = 0; i < N; ++i) {
      if (name == names[i]) {
        to = static_cast<T>(i);
        return;
      }
    }
    complain(key, "is unknown");
  }
  template <typename Each>
  void list(const char* key, std::size_t most, const Each& each) {
    const Json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_array() || value->size() > most) {
      return complain(key, fmt::format("is not a list of at most {} items", most));
    }
    for (std::size_t i = 0; i < value->size(); ++i)
      each((*value)[i], fmt::format("{}{}[{}]", where_, key, i));
  }
  template <typename Each>
  void entries(const char* key, const Each& each) {
    const Json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_object()) return complain(key, "is not an object");
    for (const auto& [name, item] : value->items()) each(name, item);
  }
  void take(const std::string& key, const Json& value, std::string& to) {
    if (!value.is_string()) return complain(key, "is not a text");
    to = value.get<std::string>();
  }
  void complain(const std::string& key, const std::string& what) {
    if (!flaw_.empty()) return;
    const std::string name = where_ + key;
    flaw_ = fmt::format("{} {}", name.empty() ? "it" : name, what);
  }

 private:
  const Json& object_;
  std::string where_;
  std::string& flaw_;
};

constexpr std::uint64_t kAny = ~std::uint64_t{0};
constexpr int kMaxSampleTurn = 1'000'000;
constexpr std::uint64_t kMost = 1'000'000'000'000;
// Per team; a walk-over may make the score as negative as this.
constexpr std::int64_t kMostGoals = 1'100'000;

std::string hexOf(std::uint64_t value) { return fmt::format("{:016x}", value); }

Json bodyJson(const RecordedBody& body) {
  Json json{{"kind", kBodies[static_cast<std::size_t>(body.kind)]}};
  if (body.id) {
    json["team"] = nameOf(body.id->team);
    json["number"] = body.id->number;
  }
  return json;
}

Json sensorsJson(const SensorModel& sensors) {
  return {{"latency_ticks", sensors.latency_ticks},
          {"position_noise", sensors.position_noise},
          {"heading_noise", sensors.heading_noise},
          {"dropout", sensors.dropout}};
}

Json recipeJson(const RecordingRecipe& recipe) {
  Json more = Json::object();
  for (const auto& [name, text] : recipe.more) more[name] = text;
  Json vision = Json::array();
  for (const SensorModel& sensors : recipe.vision) vision.push_back(sensorsJson(sensors));
  return {{"seed", recipe.seed},           {"index", recipe.index}, {"teams", recipe.teams},
          {"navigator", recipe.navigator}, {"vision", vision},      {"rules", recipe.rules},
          {"physics", recipe.physics},     {"robot", recipe.robot}, {"field", recipe.field},
          {"layout", recipe.layout},       {"more", more}};
}

RecordedBody readBody(const Json& json, const std::string& where, std::string& flaw) {
  RecordedBody body;
  Fields fields(json, where + ".", flaw);
  fields.choice("kind", kBodies, body.kind);
  if (!json.is_object() || !json.contains("team")) return body;
  RobotId id;
  static constexpr std::array<std::string_view, 2> kTeamNames{nameOf(TeamId::kBlue), nameOf(TeamId::kYellow)};
  fields.choice("team", kTeamNames, id.team);
  fields.whole("number", kMaxTeamSize - 1, id.number);
  body.id = id;
  return body;
}

SensorModel readSensors(const Json& json, const std::string& where, std::string& flaw) {
  SensorModel sensors;
  Fields fields(json, where + ".", flaw);
  fields.whole("latency_ticks", kMaxLatencyTicks, sensors.latency_ticks);
  fields.number("position_noise", sensors.position_noise);
  fields.number("heading_noise", sensors.heading_noise);
  fields.number("dropout", sensors.dropout);
  return sensors;
}

void readRecipe(const Json& json, RecordingRecipe& recipe, std::string& flaw) {
  Fields fields(json, "recipe.", flaw);
  fields.whole("seed", kAny, recipe.seed);
  fields.whole("index", kAny, recipe.index);
  fields.list("teams", 2, [&](const Json& team, const std::string& where) {
    fields.take(where, team, recipe.teams.emplace_back());
  });
  fields.text("navigator", recipe.navigator);
  fields.text("rules", recipe.rules);
  fields.text("physics", recipe.physics);
  fields.text("robot", recipe.robot);
  fields.text("field", recipe.field);
  fields.text("layout", recipe.layout);
  fields.entries("more", [&](const std::string& name, const Json& item) {
    fields.take(name, item, recipe.more.emplace_back(name, "").second);
  });
  fields.list("vision", 2, [&](const Json& sensors, const std::string& where) {
    recipe.vision.push_back(readSensors(sensors, where, flaw));
  });
}

void readBuild(const Json& json, BuildInfo& build, std::string& flaw) {
  Fields fields(json, "build.", flaw);
  fields.text("version", build.version);
  fields.text("compiler", build.compiler);
  fields.text("type", build.type);
  fields.text("box2d", build.box2d);
}

/// Dumps JSON and replaces invalid UTF-8, because texts from outside may contain any bytes.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

tl::expected<Json, std::string> parseJson(BytesView text) {
  if (!isSmallJson(text)) {
    return tl::unexpected(fmt::format("it is not JSON of at most {} keys and values", kMaxJsonItems));
  }
  return Json::parse(text);
}

/// The number, or 0 for null: NaN and infinities are written as null, because JSON does not have them.
double figureOf(const Json& json) { return json.is_number() ? json.get<double>() : 0.0; }

}  // namespace

std::optional<std::string> flawOf(const RecordingHeader& header) {
  if (header.control_rate < 1 || header.control_rate > 1000) return "control_rate is outside 1 ... 1000 Hz";
  if (header.sample_every < 1 || header.sample_every > 1000)
    return "sample_every is outside 1 ... 1000 ticks";
  if (header.chunk_ticks < 1 || header.chunk_ticks > kMaxChunkTicks) {
    return fmt::format("chunk_ticks is outside 1 ... {} ticks", kMaxChunkTicks);
  }
  if (!(header.command_step >= 0.0 && header.command_step <= 10.0)) {
    return "command_step is outside 0 ... 10 rad/s";
  }
  if (!(header.sample_step >= 1e-6 && header.sample_step <= 1.0))
    return "sample_step is outside 1e-6 ... 1 m";
  if (header.sample_turn < 1 || header.sample_turn > kMaxSampleTurn) {
    return fmt::format("sample_turn is outside 1 ... {}", kMaxSampleTurn);
  }
  if (header.bodies.size() > kMaxRecordedBodies) {
    return fmt::format("there are more than {} bodies", kMaxRecordedBodies);
  }
  if (header.bodies.size() * static_cast<std::size_t>(header.chunk_ticks) > kMaxChunkRows) {
    return fmt::format("chunk_ticks times the number of bodies is more than {}", kMaxChunkRows);
  }
  if (header.heard && (header.level != RecordingLevel::kFull || header.sample_every != 1)) {
    return "it was heard, but has no samples of every tick";
  }
  BodyKind last = BodyKind::kRobot;
  for (const RecordedBody& body : header.bodies) {
    if (body.kind < last) return "bodies are not in the order of robots, balls, obstacles";
    if (body.id && body.kind != BodyKind::kRobot) return "a body that is no robot has a team";
    last = body.kind;
  }
  return std::nullopt;
}

std::string toJson(const RecordingHeader& header) {
  Json bodies = Json::array();
  for (const RecordedBody& body : header.bodies) bodies.push_back(bodyJson(body));
  Json json{{"kind", kKinds[static_cast<std::size_t>(header.kind)]},
            {"level", kLevels[static_cast<std::size_t>(header.level)]},
            {"control_rate", header.control_rate},
            {"command_step", header.command_step},
            {"sample_every", header.sample_every},
            {"sample_step", header.sample_step},
            {"sample_turn", header.sample_turn},
            {"chunk_ticks", header.chunk_ticks},
            {"bodies", bodies},
            {"recipe", recipeJson(header.recipe)},
            {"build",
             {{"version", header.build.version},
              {"compiler", header.build.compiler},
              {"type", header.build.type},
              {"box2d", header.build.box2d}}}};
  if (header.heard) json["heard"] = true;
  return dumped(json);
}

std::string toJson(const RecordingResult& result) {
  Json figures = Json::object();
  for (const auto& [name, value] : result.figures) figures[name] = value;
  return dumped({{"ticks", result.ticks},
                 {"complete", result.complete},
                 {"score", {result.score[0], result.score[1]}},
                 {"final_hash", hexOf(result.final_hash)},
                 {"outcome", result.outcome},
                 {"figures", figures}});
}

tl::expected<RecordingHeader, std::string> headerFromJson(BytesView text) {
  const auto parsed = parseJson(text);
  if (!parsed) return tl::unexpected(parsed.error());
  const Json& json = *parsed;
  RecordingHeader header;
  std::string flaw;
  Fields fields(json, "", flaw);
  fields.choice("kind", kKinds, header.kind);
  fields.choice("level", kLevels, header.level);
  if (json.is_object() && json.contains("heard")) fields.number("heard", header.heard);
  fields.whole("control_rate", 1000, header.control_rate);
  fields.number("command_step", header.command_step);
  fields.whole("sample_every", 1000, header.sample_every);
  fields.number("sample_step", header.sample_step);
  fields.whole("sample_turn", kMaxSampleTurn, header.sample_turn);
  fields.whole("chunk_ticks", kMaxChunkTicks, header.chunk_ticks);
  fields.list("bodies", kMaxRecordedBodies, [&](const Json& body, const std::string& where) {
    header.bodies.push_back(readBody(body, where, flaw));
  });
  if (const Json* recipe = fields.find("recipe")) readRecipe(*recipe, header.recipe, flaw);
  if (const Json* build = fields.find("build")) readBuild(*build, header.build, flaw);
  if (flaw.empty()) flaw = flawOf(header).value_or("");
  if (!flaw.empty()) return tl::unexpected(flaw);
  return header;
}

tl::expected<RecordingResult, std::string> resultFromJson(BytesView text) {
  const auto parsed = parseJson(text);
  if (!parsed) return tl::unexpected(parsed.error());
  const Json& json = *parsed;
  RecordingResult result;
  std::string flaw, hash;
  Fields fields(json, "", flaw);
  fields.whole("ticks", kMost, result.ticks);
  fields.number("complete", result.complete);
  fields.text("final_hash", hash);
  fields.text("outcome", result.outcome);
  std::size_t team = 0;
  fields.list("score", 2, [&](const Json& goals, const std::string& where) {
    const bool whole =
        goals.is_number_integer() && (!goals.is_number_unsigned() || goals.get<std::uint64_t>() <= kMost);
    const std::int64_t score = whole ? goals.get<std::int64_t>() : kMostGoals + 1;
    if (score < -kMostGoals || score > kMostGoals) {
      return fields.complain(where, fmt::format("is not a score of -{0} to {0}", kMostGoals));
    }
    result.score[team++] = static_cast<int>(score);
  });
  fields.entries("figures", [&](const std::string& name, const Json& value) {
    result.figures.emplace_back(name, figureOf(value));
  });
  if (hash.size() != 16 || hash.find_first_not_of("0123456789abcdef") != std::string::npos) {
    fields.complain("final_hash", "is not 16 hexadecimal digits");
  }
  if (!flaw.empty()) return tl::unexpected(flaw);
  result.final_hash = std::stoull(hash, nullptr, 16);
  return result;
}

}  // namespace fulbito
