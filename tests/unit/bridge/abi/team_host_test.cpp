// The program fulbito-team-host, through pipes.
#include <array>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include "bridge/abi/abi_codec.hpp"
#include "fulbito/match.hpp"
#include "tests/support/catch.hpp"

extern char** environ;

namespace fulbito {
namespace {

const std::string kLibraries = FULBITO_TEST_LIBRARIES;

/// The program with its three standard streams.
class HostProcess {
 public:
  explicit HostProcess(std::vector<std::string> arguments) {
    std::array<std::array<int, 2>, 3> pipes{};
    for (auto& ends : pipes) REQUIRE(pipe2(ends.data(), O_CLOEXEC) == 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipes[0][0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipes[1][1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipes[2][1], STDERR_FILENO);
    arguments.insert(arguments.begin(), FULBITO_TEAM_HOST);
    std::vector<char*> words;
    for (std::string& word : arguments) words.push_back(word.data());
    words.push_back(nullptr);
    REQUIRE(posix_spawn(&pid_, FULBITO_TEAM_HOST, &actions, nullptr, words.data(), environ) == 0);
    posix_spawn_file_actions_destroy(&actions);
    close(pipes[0][0]), close(pipes[1][1]), close(pipes[2][1]);
    in_ = pipes[0][1], out_ = pipes[1][0], errors_ = pipes[2][0];
  }
  HostProcess(const HostProcess&) = delete;
  HostProcess& operator=(const HostProcess&) = delete;
  ~HostProcess() {
    if (pid_ > 0) end();
    close(out_), close(errors_);
  }

  /// Sends a request in one piece and reads the whole reply.
  std::string ask(const std::string& request) {
    REQUIRE(write(in_, request.data(), request.size()) == static_cast<ssize_t>(request.size()));
    std::string reply;
    std::array<char, 65536> piece{};
    const AbiCodec codec;
    while (*codec.firstMessage(reply) == 0) {
      const ssize_t n = read(out_, piece.data(), piece.size());
      if (n <= 0) return reply;
      reply.append(piece.data(), static_cast<std::size_t>(n));
    }
    return reply;
  }
  /// Closes its input. @return its exit code; -1: a signal
  int end() {
    close(in_);
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// Its whole standard error; to call after `end`.
  std::string errors() {
    std::string text;
    std::array<char, 4096> piece{};
    for (ssize_t n = 0; (n = read(errors_, piece.data(), piece.size())) > 0;) {
      text.append(piece.data(), static_cast<std::size_t>(n));
    }
    return text;
  }

 private:
  pid_t pid_ = 0;
  int in_ = -1, out_ = -1, errors_ = -1;
};

}  // namespace

TEST_CASE("fulbito-team-host plays for a library; what the team prints goes to standard error", "[unit]") {
  HostProcess process({kLibraries + "/printing.so"});
  AbiCodec codec;
  TeamReply reply;
  std::string out;
  codec.hello(1, {}, out);
  REQUIRE(codec.read(process.ask(out), reply));
  CHECK(reply.welcome.name == "printing");
  out.clear();
  codec.begin(2, {}, out);
  REQUIRE(codec.read(process.ask(out), reply));
  for (std::uint64_t tick = 3; tick < 200; ++tick) {
    out.clear();
    if (tick % 50 == 0) codec.stopped({}, out);  // a notice and a request in one piece
    codec.decide(tick, {}, out);
    REQUIRE(codec.read(process.ask(out), reply));
    REQUIRE(reply.id == tick);
    REQUIRE(reply.command.robots[0].wheels.left == 4.0);
  }
  CHECK(process.end() == 0);
  const std::string errors = process.errors();
  CHECK(errors.find("printed 0\n") != std::string::npos);
  CHECK(errors.find("printing: logged\n") != std::string::npos);
  CHECK(errors.find("nothing to read\n") != std::string::npos);
}

TEST_CASE("fulbito-team-host says what is wrong and gives the program's exit codes", "[unit]") {
  // Before a conversation, it reports on standard error, then by a message.
  const auto run = [](std::vector<std::string> arguments, int code, const std::string& words, bool told) {
    CAPTURE(words);
    HostProcess process(std::move(arguments));
    AbiCodec codec;
    TeamReply reply;
    const auto read = codec.read(process.ask(""), reply);
    CHECK(process.end() == code);
    REQUIRE_FALSE(read);
    const std::string said = told ? read.error().message : process.errors();
    CAPTURE(said);
    CHECK(said.find(words) != std::string::npos);
  };
  run({}, 2, "usage: fulbito-team-host LIBRARY", false);
  run({kLibraries + "/plain_c.so", "gain"}, 2, "'gain' is not of the form name=value", false);
  run({kLibraries + "/none.so"}, 5, "cannot read the library", true);
  run({kLibraries + "/broken_version.so"}, 3, "version 77", true);
}

TEST_CASE("fulbito-team-host ends with the reason when its team fails or refuses", "[unit]") {
  AbiCodec codec;
  TeamReply reply;
  std::string hello, begin, decide;
  codec.hello(1, {}, hello);
  codec.begin(2, {}, begin);
  codec.decide(3, {}, decide);
  HostProcess failing({kLibraries + "/throwing.so", "where=decide"});
  REQUIRE(codec.read(failing.ask(hello), reply));
  REQUIRE(codec.read(failing.ask(begin), reply));
  const auto failed = codec.read(failing.ask(decide), reply);
  REQUIRE_FALSE(failed);
  CHECK(failed.error().message == "throwing: 'decide' fails with 1");
  CHECK(failing.end() == 3);
  HostProcess refusing({kLibraries + "/broken_refusal.so"});
  const auto refused = codec.read(refusing.ask(hello), reply);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("not today") != std::string::npos);
  CHECK(refusing.end() == 2);
}

TEST_CASE("a reason of a host is safe to print and never endless", "[unit]") {
  std::string message;
  beginFrame(static_cast<std::uint16_t>(FrameKind::kFailed), 0, message);
  message += "\x1b[2J\xff" + std::string(10'000, 'x');
  message += '\0';
  endFrame(0, message);
  AbiCodec codec;
  TeamReply reply;
  const auto read = codec.read(message, reply);
  REQUIRE_FALSE(read);
  CHECK(read.error().message.starts_with("\\x1b[2J\\xff"));
  CHECK(read.error().message.size() < 2100);
}

}  // namespace fulbito
