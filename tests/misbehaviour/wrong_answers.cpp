#include <string>

#include "tests/misbehaviour/kinds.hpp"

namespace fulbito::test {
namespace {

std::string begun(long id, const std::string& type) {
  return "{\"type\":\"" + type + "\",\"id\":" + std::to_string(id);
}

std::string begun(const Scene& scene) { return begun(scene.id, scene.type); }

/// An answer to "decide" with these words for each of three robots.
std::string withRobots(const Scene& scene, const std::string& robot) {
  return begun(scene) + ",\"robots\":[" + robot + "," + robot + "," + robot + "]}\n";
}

std::string nested() {
  constexpr int kDepth = 100'000;
  return std::string(kDepth, '[') + std::string(kDepth, ']');
}

constexpr Kind kWrongAnswers[] = {
    {"not-json", "answers in plain words", [](const Scene&) { say("forward!\n"); }, false, true},
    {"gives-up", "says that it cannot play",
     [](const Scene& s) { say(begun(s) + ",\"error\":\"this team gives up\"}\n"); }, false, true},
    {"unasked-answer", "answers before it is asked",
     [](const Scene& s) { say(withRobots(s, "null") + begun(s.id + 1, s.type) + ",\"robots\":[]}\n"); },
     false, true},
    {"not-an-object", "answers with a number", [](const Scene&) { say("42\n"); }, false, true},
    {"no-id", "leaves the request's number out",
     [](const Scene& s) { say("{\"type\":\"" + s.type + "\",\"robots\":[]}\n"); }, false, true},
    {"wrong-id", "answers a request of the future",
     [](const Scene& s) { say(begun(s.id + 1000, s.type) + ",\"robots\":[]}\n"); }, false, true},
    {"old-id", "answers an earlier request",
     [](const Scene& s) { say(begun(s.id - 1, s.type) + ",\"robots\":[]}\n"); }, false, true},
    {"wrong-type", "answers another kind of request",
     [](const Scene& s) { say(begun(s.id, "hello") + ",\"robots\":[]}\n"); }, false, true},
    {"duplicate-answers", "answers twice",
     [](const Scene& s) {
       const std::string answer = withRobots(s, "null");
       say(answer + answer);
     },
     false, true},
    {"many-answers", "answers a thousand times",
     [](const Scene& s) {
       const std::string answer = withRobots(s, "null");
       for (int k = 0; k < 1000; ++k) say(answer);
     },
     false, true},
    {"nan", "commands what is not a number",
     [](const Scene& s) { say(withRobots(s, "{\"left\":NaN,\"right\":NaN}")); }, false, true},
    {"infinity", "commands infinite speeds",
     [](const Scene& s) { say(withRobots(s, "{\"left\":Infinity,\"right\":-Infinity}")); }, false, true},
    {"null-numbers", "commands null",
     [](const Scene& s) { say(withRobots(s, "{\"left\":null,\"right\":null}")); }, false, true},
    {"huge-numbers", "commands beyond all range",
     [](const Scene& s) { say(withRobots(s, "{\"left\":1e308,\"right\":-1e308}")); }, false, true},
    {"overflowing-numbers", "commands beyond what a number holds",
     [](const Scene& s) { say(withRobots(s, "{\"left\":1e999,\"right\":-1e999}")); }, false, true},
    {"words-for-numbers", "commands in words",
     [](const Scene& s) { say(withRobots(s, "{\"left\":\"fast\",\"right\":true}")); }, false, true},
    {"too-many-robots", "commands a hundred robots",
     [](const Scene& s) {
       std::string robots = "{\"left\":1,\"right\":1}";
       for (int k = 1; k < 100; ++k) robots += ",{\"left\":1,\"right\":1}";
       say(begun(s) + ",\"robots\":[" + robots + "]}\n");
     },
     false, true},
    {"deep-nesting", "nests 100000 lists",
     [](const Scene& s) { say(begun(s) + ",\"robots\":" + nested() + "}\n"); }, false, true},
    {"duplicate-keys", "says the same key twice",
     [](const Scene& s) { say(begun(s) + ",\"robots\":[],\"robots\":[null],\"id\":0}\n"); }, false, true},
    {"zero-bytes", "says zero bytes within its answer",
     [](const Scene& s) { say(begun(s) + std::string(",\"robots\":\0\0[]}\n", 15)); }, false, true},
    {"not-utf-8", "says bytes that are no text",
     [](const Scene& s) { say(begun(s) + ",\"robots\":[],\"note\":\"\xff\xfe\xc0\xaf\"}\n"); }, false, true},
};

}  // namespace

std::span<const Kind> wrongAnswers() { return kWrongAnswers; }

}  // namespace fulbito::test
