#include "replays/verify/diff.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "replays/verify/resimulate.hpp"

namespace fulbito {
namespace {

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// Compares two recipes key by key.
class RecipeDiff {
 public:
  explicit RecipeDiff(std::vector<RecipeDifference>& out) : out_(out) {}

  void value(const std::string& name, const std::string& a, const std::string& b) {
    if (a != b) out_.push_back({name, a, b});
  }
  void number(const std::string& name, double a, double b) {
    value(name, fmt::format("{}", a), fmt::format("{}", b));
  }
  /// Compares two whole files: the lines that differ, if both have as many lines.
  void text(const std::string& name, const std::string& a, const std::string& b) {
    const auto lines_a = linesOf(a), lines_b = linesOf(b);
    if (lines_a.size() != lines_b.size())
      return value(name, "different text", a == b ? "different text" : "");
    for (std::size_t i = 0; i < lines_a.size(); ++i) {
      if (lines_a[i] != lines_b[i]) value(name, std::string(lines_a[i]), std::string(lines_b[i]));
    }
  }

 private:
  std::vector<RecipeDifference>& out_;
};

std::vector<RecipeDifference> recipeDifferences(const RecordingHeader& a, const RecordingHeader& b) {
  std::vector<RecipeDifference> found;
  RecipeDiff diff(found);
  const RecordingRecipe &ra = a.recipe, &rb = b.recipe;
  diff.value("kind", a.kind == RecordingKind::kTrial ? "trial" : "match",
             b.kind == RecordingKind::kTrial ? "trial" : "match");
  diff.value("heard", a.heard ? "true" : "", b.heard ? "true" : "");
  diff.number("control_rate", a.control_rate, b.control_rate);
  diff.number("bodies", static_cast<double>(a.bodies.size()), static_cast<double>(b.bodies.size()));
  for (std::size_t i = 0; i < std::max(ra.teams.size(), rb.teams.size()); ++i) {
    diff.value(i == 0 ? "blue" : "yellow", i < ra.teams.size() ? ra.teams[i] : "",
               i < rb.teams.size() ? rb.teams[i] : "");
  }
  diff.value("navigator", ra.navigator, rb.navigator);
  diff.value("seed", std::to_string(ra.seed), std::to_string(rb.seed));
  diff.value("index", std::to_string(ra.index), std::to_string(rb.index));
  for (std::size_t i = 0; i < std::max(ra.vision.size(), rb.vision.size()); ++i) {
    const SensorModel sa = i < ra.vision.size() ? ra.vision[i] : SensorModel{};
    const SensorModel sb = i < rb.vision.size() ? rb.vision[i] : SensorModel{};
    const std::string whose = a.kind == RecordingKind::kTrial ? "" : i == 0 ? "blue's " : "yellow's ";
    diff.number(whose + "latency_ticks", sa.latency_ticks, sb.latency_ticks);
    diff.number(whose + "position_noise", sa.position_noise, sb.position_noise);
    diff.number(whose + "heading_noise", sa.heading_noise, sb.heading_noise);
    diff.number(whose + "dropout", sa.dropout, sb.dropout);
  }
  diff.text("rules", ra.rules, rb.rules);
  diff.text("physics", ra.physics, rb.physics);
  diff.text("robot", ra.robot, rb.robot);
  diff.text("field", ra.field, rb.field);
  diff.text("layout", ra.layout, rb.layout);
  for (const auto& [name, value] : ra.more) {
    const auto other =
        std::find_if(rb.more.begin(), rb.more.end(), [&](const auto& e) { return e.first == name; });
    diff.value(name, value, other == rb.more.end() ? "" : other->second);
  }
  for (const auto& [name, value] : rb.more) {
    const bool known =
        std::any_of(ra.more.begin(), ra.more.end(), [&](const auto& e) { return e.first == name; });
    if (!known) diff.value(name, "", value);
  }
  return found;
}

/// The parts of a recording that are compared without simulating it.
struct Content {
  std::vector<std::uint16_t> hashes;
  std::vector<WheelSpeeds> commands;
  std::vector<RecordedPlay> plays;
  std::size_t robots = 0;
};

Result<Content> contentOf(const RecordingReader& recording) {
  Content content;
  content.robots = static_cast<std::size_t>(countOf(recording.header(), BodyKind::kRobot));
  for (std::size_t i = 0; i < recording.chunkCount(); ++i) {
    auto chunk = recording.chunk(i);
    if (!chunk) return tl::unexpected<Error>(chunk.error());
    content.hashes.insert(content.hashes.end(), chunk->tick_hashes.begin(), chunk->tick_hashes.end());
    content.commands.insert(content.commands.end(), chunk->commands.begin(), chunk->commands.end());
    std::move(chunk->plays.begin(), chunk->plays.end(), std::back_inserter(content.plays));
  }
  return content;
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool sameStart(const RecordedStart& a, const RecordedStart& b) {
  return a.present == b.present && sameBits(a.pose.position.x, b.pose.position.x) &&
         sameBits(a.pose.position.y, b.pose.position.y) && sameBits(a.pose.heading, b.pose.heading) &&
         sameBits(a.velocity.x, b.velocity.x) && sameBits(a.velocity.y, b.velocity.y) &&
         sameBits(a.angular_velocity, b.angular_velocity) && sameBits(a.spin.x, b.spin.x) &&
         sameBits(a.spin.y, b.spin.y);
}

/// The first play whose start differs.
std::optional<std::size_t> firstOtherPlay(const Content& a, const Content& b) {
  for (std::size_t i = 0; i < std::min(a.plays.size(), b.plays.size()); ++i) {
    const RecordedPlay &pa = a.plays[i], &pb = b.plays[i];
    const bool same =
        pa.tick == pb.tick && pa.kind == pb.kind && pa.team == pb.team &&
        std::equal(pa.starts.begin(), pa.starts.end(), pb.starts.begin(), pb.starts.end(), sameStart);
    if (!same) return i;
  }
  return std::nullopt;
}

/// The first tick whose commands or hash differ.
std::optional<Tick> firstOtherTick(const Content& a, const Content& b) {
  for (std::size_t row = 0; row < std::min(a.hashes.size(), b.hashes.size()); ++row) {
    bool same = a.hashes[row] == b.hashes[row];
    for (std::size_t i = row * a.robots; same && i < (row + 1) * a.robots; ++i) {
      same = a.commands[i].left == b.commands[i].left && a.commands[i].right == b.commands[i].right;
    }
    if (!same) return static_cast<Tick>(row) + 1;
  }
  return std::nullopt;
}

std::int64_t playAt(const Content& content, Tick tick) {
  std::int64_t play = -1;
  for (const RecordedPlay& p : content.plays) play += p.tick < tick ? 1 : 0;
  return std::max<std::int64_t>(play, 0);
}

/// Keeps a copy of the state after one tick.
class StateAt final : public ReplayVisitor {
 public:
  explicit StateAt(Tick tick) : tick_(tick) {}
  bool playBegins(const ReplayedPlay& play) override {
    bodies_.assign(play.bodies.begin(), play.bodies.end());
    return true;
  }
  bool ticked(const ReplayedTick& tick) override {
    if (tick.tick < tick_) return true;
    state_ = *tick.state;
    commands_.assign(tick.commands.begin(), tick.commands.end());
    return false;
  }

  const std::vector<std::size_t>& bodies() const { return bodies_; }
  const std::optional<WorldState>& state() const { return state_; }
  const std::vector<WheelSpeeds>& commands() const { return commands_; }

 private:
  Tick tick_;
  std::vector<std::size_t> bodies_;
  std::optional<WorldState> state_;
  std::vector<WheelSpeeds> commands_;
};

class BodyDiff {
 public:
  BodyDiff(const RecordingHeader& header, RecordingDifference& out) : header_(header), out_(out) {}

  void compare(std::size_t body, const char* field, double a, double b) {
    if (!sameBits(a, b)) out_.bodies.push_back({body, bodyName(header_, body), field, a, b});
  }
  void compare(std::size_t body, const char* x, const char* y, Vec2 a, Vec2 b) {
    compare(body, x, a.x, b.x);
    compare(body, y, a.y, b.y);
  }
  void starts(const RecordedPlay& a, const RecordedPlay& b) {
    for (std::size_t i = 0; i < std::min(a.starts.size(), b.starts.size()); ++i) {
      compare(i, "presence", a.starts[i].present ? 1.0 : 0.0, b.starts[i].present ? 1.0 : 0.0);
      compare(i, "x", "y", a.starts[i].pose.position, b.starts[i].pose.position);
      compare(i, "heading", a.starts[i].pose.heading, b.starts[i].pose.heading);
      compare(i, "velocity x", "velocity y", a.starts[i].velocity, b.starts[i].velocity);
    }
  }
  void states(const StateAt& a, const StateAt& b) {
    if (!a.state() || !b.state() || a.bodies() != b.bodies()) return;
    const WorldState &sa = *a.state(), &sb = *b.state();
    std::size_t next = 0;
    for (std::size_t i = 0; i < sa.robots.size(); ++i) {
      compare(a.bodies()[i], "command left", a.commands()[i].left, b.commands()[i].left);
      compare(a.bodies()[i], "command right", a.commands()[i].right, b.commands()[i].right);
    }
    for (std::size_t i = 0; i < sa.robots.size(); ++i) robot(a.bodies()[next++], sa.robots[i], sb.robots[i]);
    for (std::size_t i = 0; i < sa.balls.size(); ++i) ball(a.bodies()[next++], sa.balls[i], sb.balls[i]);
    for (std::size_t i = 0; i < sa.obstacles.size(); ++i) {
      const std::size_t body = a.bodies()[next++];
      compare(body, "x", "y", sa.obstacles[i].pose.position, sb.obstacles[i].pose.position);
      compare(body, "heading", sa.obstacles[i].pose.heading, sb.obstacles[i].pose.heading);
    }
  }

 private:
  void robot(std::size_t body, const RobotState& a, const RobotState& b) {
    compare(body, "x", "y", a.pose.position, b.pose.position);
    compare(body, "heading", a.pose.heading, b.pose.heading);
    compare(body, "velocity x", "velocity y", a.velocity, b.velocity);
    compare(body, "angular velocity", a.angular_velocity, b.angular_velocity);
  }
  void ball(std::size_t body, const BallState& a, const BallState& b) {
    compare(body, "x", "y", a.position, b.position);
    compare(body, "velocity x", "velocity y", a.velocity, b.velocity);
    compare(body, "spin x", "spin y", a.spin, b.spin);
  }

  const RecordingHeader& header_;
  RecordingDifference& out_;
};

/// Simulates both recordings up to the first difference, and compares all values of the states there.
Result<void> lookCloser(const RecordingReader& a, const RecordingReader& b, RecordingDifference& found) {
  StateAt state_a(*found.tick), state_b(*found.tick);
  const PlayRange play{found.play, found.play};
  if (auto played = resimulate(a, play, state_a); !played) return played;
  if (auto played = resimulate(b, play, state_b); !played) return played;
  BodyDiff(a.header(), found).states(state_a, state_b);
  return {};
}

}  // namespace

Result<RecordingDifference> diff(const RecordingReader& a, const RecordingReader& b) {
  RecordingDifference found;
  found.recipe = recipeDifferences(a.header(), b.header());
  found.ticks_a = a.ticks();
  found.ticks_b = b.ticks();
  const auto in_a = contentOf(a), in_b = contentOf(b);
  if (!in_a) return tl::unexpected<Error>(in_a.error());
  if (!in_b) return tl::unexpected<Error>(in_b.error());
  found.comparable = a.header().bodies.size() == b.header().bodies.size() && in_a->robots == in_b->robots &&
                     a.header().control_rate == b.header().control_rate;
  if (!found.comparable) return found;
  found.tick = firstOtherTick(*in_a, *in_b);
  const auto play = firstOtherPlay(*in_a, *in_b);
  const Tick begins = play ? std::min(in_a->plays[*play].tick, in_b->plays[*play].tick) : 0;
  if (play && (!found.tick || begins < *found.tick)) {
    found.tick = begins;
    found.play = static_cast<std::int64_t>(*play);
    found.start = true;
    BodyDiff(a.header(), found).starts(in_a->plays[*play], in_b->plays[*play]);
    return found;
  }
  if (!found.tick) return found;
  found.play = playAt(*in_a, *found.tick);
  if (auto looked = lookCloser(a, b, found); !looked) return tl::unexpected<Error>(looked.error());
  return found;
}

}  // namespace fulbito
