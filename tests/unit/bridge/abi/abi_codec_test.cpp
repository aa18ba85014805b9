#include "bridge/abi/abi_codec.hpp"

#include "bridge/abi/library_team.hpp"
#include "bridge/abi/team_host.hpp"
#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

const std::string kPlainC = FULBITO_TEST_LIBRARIES "/plain_c.so";

PluginLog silent() {
  return [](std::string_view) {};
}

/// A codec and the host at its other end.
class Conversation {
 public:
  explicit Conversation(std::vector<Setting> settings = {})
      : host_(*TeamLibrary::open(kPlainC), std::move(settings), silent()) {}

  AbiCodec codec;
  std::string out;
  TeamReply reply;

  /// Passes what the codec has written to the host.
  Result<void> send() {
    answer_.clear();
    const auto done = host_.answer(out, answer_);
    out.clear();
    return done;
  }
  /// The same, and reads the reply.
  void ask() {
    const auto sent = send();
    if (!sent) FAIL(sent.error().message);
    const auto length = codec.firstMessage(answer_);
    REQUIRE(length);
    REQUIRE(*length == answer_.size());
    const auto read = codec.read(answer_, reply);
    if (!read) FAIL(read.error().message);
  }
  void greet() {
    codec.hello(1, {"fulbito 0", {{"gain", "0.75"}}}, out);
    ask();
    codec.begin(2, {}, out);
    ask();
  }
  const std::string& answer() const { return answer_; }

 private:
  TeamHost host_;
  std::string answer_;
};

Observation someObservation() {
  Observation seen;
  for (std::size_t i = 0; i < 3; ++i) seen.own[i].present = true;
  seen.own[2].state.pose.position = {0.25, 0.5};
  seen.ball.position = {0.125, 0.0};
  seen.ball.velocity = {0.5, 0.0};
  return seen;
}

/// All replies of a conversation, with drawings.
std::vector<std::string> someReplies() {
  Conversation talk;
  std::vector<std::string> replies;
  const auto keep = [&] {
    talk.ask();
    replies.push_back(talk.answer());
  };
  talk.codec.hello(1, {}, talk.out);
  keep();
  talk.codec.begin(2, {}, talk.out);
  keep();
  Observation seen = someObservation();
  seen.wants_drawings = true;
  talk.codec.decide(3, seen, talk.out);
  keep();
  talk.codec.place(4, {}, talk.out);
  keep();
  talk.codec.exercise(5, seen, {}, talk.out);
  keep();
  return replies;
}

}  // namespace

TEST_CASE("the slip in curves reaches a team behind the codec", "[unit]") {
  Conversation talk;
  talk.greet();
  MatchInfo info;
  info.robot.curve_widening = 0.25;
  info.robot.curve_widening_rise = 0.5;
  talk.codec.begin(3, info, talk.out);
  talk.ask();
  talk.codec.decide(4, someObservation(), talk.out);
  talk.ask();
  CHECK(talk.reply.command.robots[2].go_to.tolerance == 5.25);
}

TEST_CASE("a hosted team gives the replies of the same team in this process", "[unit]") {
  Conversation talk({{"gain", "0.5"}, {"offset", "3"}});
  talk.codec.hello(7, {"fulbito 0", {{"gain", "0.75"}, {"navigator", "univector"}}}, talk.out);
  talk.ask();
  CHECK(talk.reply.kind == TeamReply::Kind::kHello);
  CHECK(talk.reply.id == 7);
  CHECK(talk.reply.welcome.name == "plain-c");
  CHECK(talk.reply.welcome.version == "3.1");

  const auto local = *loadTeamLibrary(kPlainC, silent())
                          ->make({{"gain", "0.75"}, {"offset", "3"}, {"navigator", "univector"}});
  MatchInfo info;
  info.seed = 5;
  local->begin(info);
  talk.codec.begin(8, info, talk.out);
  talk.ask();
  CHECK(talk.reply.id == 8);
  CHECK(talk.reply.navigators == std::vector<std::string>{"univector"});

  Observation seen = someObservation();
  seen.wants_drawings = true;
  const TeamCommand expected = local->decide(seen);
  talk.codec.decide(9, seen, talk.out);
  talk.ask();
  CHECK(talk.reply.kind == TeamReply::Kind::kDecide);
  CHECK(talk.reply.id == 9);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(talk.reply.command.robots[i].kind == expected.robots[i].kind);
    CHECK(talk.reply.command.robots[i].wheels.left == expected.robots[i].wheels.left);
    CHECK(talk.reply.command.robots[i].twist.angular == expected.robots[i].twist.angular);
    CHECK(talk.reply.command.robots[i].go_to.position == expected.robots[i].go_to.position);
  }
  CHECK(talk.reply.command.robots[0].wheels.left == 0.75);
  CHECK(talk.reply.command.roles == expected.roles);
  REQUIRE(talk.reply.command.drawings.size() == 1);
  CHECK(talk.reply.command.drawings[0].text == "here");
}

TEST_CASE("a hosted team places and does exercises", "[unit]") {
  Conversation talk;
  talk.greet();
  PlacementRequest request;
  request.kind = RestartKind::kGoalKick;
  request.delay = 0.75;
  talk.codec.place(10, request, talk.out);
  talk.ask();
  REQUIRE(talk.reply.proposal);
  CHECK(talk.reply.proposal->robots[1]->heading == 0.5);
  CHECK(talk.reply.proposal->ball->y == 0.75);

  const Observation seen = someObservation();
  talk.codec.exercise(11, seen, {Exercise::Kind::kPredictBall, {}, 0.25, 0.0, 2.0}, talk.out);
  talk.ask();
  REQUIRE(talk.reply.exercise);
  CHECK(talk.reply.exercise->answer.x == Approx(1.125));
  CHECK(talk.reply.exercise->command.robots[0].wheels.left == MatchInfo{}.dt());
  talk.codec.exercise(12, seen, {Exercise::Kind::kTurn, {}, 0.0, 0.0, 0.0}, talk.out);
  talk.ask();
  CHECK_FALSE(talk.reply.exercise);
}

TEST_CASE("notices get no reply", "[unit]") {
  Conversation talk;
  talk.greet();
  talk.codec.stopped({}, talk.out);
  CHECK(talk.send());
  CHECK(talk.answer().empty());
  talk.codec.ready({}, talk.out);
  CHECK(talk.send());
  CHECK(talk.answer().empty());
  talk.codec.ended({}, talk.out);
  CHECK(talk.send());
  CHECK(talk.answer().empty());
}

TEST_CASE("the host refuses wrong settings, a wrong order and foreign messages", "[unit]") {
  Conversation talk;
  talk.codec.decide(1, {}, talk.out);
  CHECK(talk.send().error().message == "a request before the first message");
  talk.codec.hello(1, {"", {{"gain", "99"}}}, talk.out);
  CHECK(talk.send().error().code == ErrorCode::kUsage);
  talk.greet();
  beginFrame(99, 1, talk.out);
  endFrame(0, talk.out);
  CHECK(talk.send().error().message.find("kind 99") != std::string::npos);
  talk.codec.decide(1, {}, talk.out);
  talk.out.pop_back();
  CHECK_FALSE(talk.send());
  talk.out.clear();
  talk.codec.ended({}, talk.out);
  CHECK(talk.send());
  talk.codec.ended({}, talk.out);  // this team fails then
  CHECK(talk.send().error().message == "plain-c: 'ended' fails with 7");
}

TEST_CASE("the first message of a stream is found by its size", "[unit]") {
  const AbiCodec codec;
  const auto replies = someReplies();
  const std::string stream = replies[2] + replies[3];
  for (std::size_t n = 0; n < stream.size(); n += 7) {
    const auto length = codec.firstMessage(std::string_view(stream).substr(0, n));
    REQUIRE(length);
    CHECK(*length == (n < replies[2].size() ? 0 : replies[2].size()));
  }
  std::string wrong = replies[2];
  wrong[3] = '\x7f';  // a size of gigabytes
  CHECK(codec.firstMessage(wrong).error().message.find("bytes; 16 to 262144 are allowed") !=
        std::string::npos);
  wrong = replies[2];
  wrong[6] = 9;
  CHECK(codec.firstMessage(wrong).error().message == "a message has version 9 of the interface instead of 1");
}

TEST_CASE("no prefix of a reply and no changed byte is taken for another length", "[unit]") {
  AbiCodec codec;
  TeamReply reply;
  Rng rng(1, test::kTestStream);
  for (const std::string& whole : someReplies()) {
    for (std::size_t n = 0; n < whole.size(); ++n) {
      if (codec.read(std::string_view(whole).substr(0, n), reply)) FAIL("a prefix was read");
    }
    for (int i = 0; i < 2000; ++i) {
      std::string changed = whole;
      for (int k = 0; k < 4; ++k) {
        changed[rng.below(static_cast<std::uint32_t>(changed.size()))] = static_cast<char>(rng.below(256));
      }
      if (codec.firstMessage(changed)) codec.read(changed, reply);
      CHECK(reply.command.drawings.size() <= 512);
      CHECK(reply.navigators.size() <= 256);
    }
    CHECK(codec.read(whole, reply));
    CHECK_FALSE(codec.read(whole + "x", reply));
  }
}

TEST_CASE("a reply that counts more than it holds is refused", "[unit]") {
  AbiCodec codec;
  TeamReply reply;
  std::string message;
  beginFrame(static_cast<std::uint16_t>(FrameKind::kDecide) + kReplyOffset, 1, message);
  CommandBody body{};
  body.drawings = 0xffffffffu;
  appendBytes(body, message);
  endFrame(0, message);
  CHECK(codec.read(message, reply).error().message == "a reply of kind 131 has a wrong length of 992 bytes");
  message.clear();
  beginFrame(static_cast<std::uint16_t>(FrameKind::kBegin) + kReplyOffset, 1, message);
  appendBytes(NamesBody{3, 0}, message);
  message.append("bezier\0dwa\0", 11);
  endFrame(0, message);
  CHECK_FALSE(codec.read(message, reply));
}

}  // namespace fulbito
