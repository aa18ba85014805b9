// A team that misbehaves in one way, at once or in the midst of a conversation by fulbito-team/1.

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <unistd.h>

#include "tests/misbehaviour/kinds.hpp"

namespace fulbito::test {

void tell(std::string_view attempt, bool got_through) {
  const std::string why =
      got_through ? std::string("GOT THROUGH") : std::string("refused: ") + std::strerror(errno);
  const std::string line = std::string(attempt) + ": " + why + "\n";
  static_cast<void>(!::write(STDERR_FILENO, line.data(), line.size()));
}

void say(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t wrote = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (wrote <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(wrote));
  }
}

void waitForEver() {
  for (;;) ::pause();
}

namespace {

template <typename Visit>
void forKinds(Visit visit) {
  for (const auto kinds : {crashes(), silences(), floods(), bombs(), escapes(), attacks(), wrongAnswers()}) {
    for (const Kind& kind : kinds) visit(kind);
  }
}

const Kind* find(std::string_view name) {
  const Kind* found = nullptr;
  forKinds([&](const Kind& kind) {
    if (kind.name == name) found = &kind;
  });
  return found;
}

/// The text of the first member of that name. Enough for the simulator's own lines: they begin with both.
std::string memberOf(const std::string& line, const std::string& name) {
  const std::string key = "\"" + name + "\":";
  const std::size_t at = line.find(key);
  if (at == std::string::npos) return {};
  std::size_t first = at + key.size();
  const bool quoted = line[first] == '"';
  if (quoted) ++first;
  return line.substr(first, line.find_first_of(quoted ? "\"" : ",}", first) - first);
}

void answer(const std::string& type, const std::string& id) {
  std::string members;
  if (type == "hello") members = ",\"protocol\":\"fulbito-team/1\",\"name\":\"misbehaving\",\"version\":\"\"";
  if (type == "begin") members = ",\"navigators\":[]";
  if (type == "decide") members = ",\"robots\":[]";
  say("{\"type\":\"" + type + "\",\"id\":" + id + members + "}\n");
}

/// Answers like a good team, and misbehaves at the decision with this number, counted from 1.
void converse(const Kind& kind, Scene scene, long at) {
  std::string line;
  for (long decisions = 0; std::getline(std::cin, line);) {
    const std::string type = memberOf(line, "type"), id = memberOf(line, "id");
    if (id.empty()) continue;
    if (type == "decide" && ++decisions == at) {
      scene.type = type;
      scene.id = std::strtol(id.c_str(), nullptr, 10);
      kind.act(scene);
      if (kind.answers) continue;
    }
    answer(type, id);
  }
}

int usage() {
  std::fputs("usage: misbehaving_team KIND [--at DECISION] [--victim-in FOLDER] | --list\n", stderr);
  return 2;
}

int list() {
  forKinds([](const Kind& kind) {
    std::printf("%-22s %s\n", std::string(kind.name).c_str(), std::string(kind.what).c_str());
  });
  return 0;
}

int run(int argc, char** argv) {
  if (argc < 2) return usage();
  if (std::string_view(argv[1]) == "--list") return list();
  const Kind* kind = find(argv[1]);
  Scene scene;
  long at = 0;
  for (int k = 2; k + 1 < argc; k += 2) {
    const std::string_view option = argv[k];
    if (option == "--at") at = std::strtol(argv[k + 1], nullptr, 10);
    // A file that the command names whole would be the team's to read.
    if (option == "--victim-in") scene.victim = std::string(argv[k + 1]) + "/recording";
  }
  if (kind == nullptr || argc % 2 != 0) return usage();
  if (at > 0) {
    converse(*kind, scene, at);
    return 0;
  }
  if (kind->answers) return usage();
  kind->act(scene);
  return 0;
}

}  // namespace
}  // namespace fulbito::test

int main(int argc, char** argv) { return fulbito::test::run(argc, argv); }
