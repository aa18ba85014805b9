#include "tests/support/piped_team.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace fulbito::test {
namespace {

[[noreturn]] void give(const std::string& what) { throw std::runtime_error(what); }

struct Pipe {
  Pipe() {
    if (::pipe2(ends, O_CLOEXEC) != 0) give("pipe2");
  }
  int ends[2] = {-1, -1};
};

}  // namespace

PipedProgram::PipedProgram(const std::vector<std::string>& command) {
  // Writing to a program that has ended is an error of that write, not the end of the tests.
  ::signal(SIGPIPE, SIG_IGN);
  const Pipe to, from;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, to.ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, from.ends[1], STDOUT_FILENO);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const int failed = ::posix_spawnp(&child_, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(to.ends[0]);
  ::close(from.ends[1]);
  in_ = to.ends[1];
  out_ = from.ends[0];
  if (failed != 0) child_ = -1;
  if (failed != 0) give("cannot run " + command[0] + ": " + std::strerror(failed));
}

PipedProgram::~PipedProgram() {
  finish();
  ::close(out_);
}

void PipedProgram::send(std::string_view text) const {
  while (!text.empty()) {
    const ssize_t count = ::write(in_, text.data(), text.size());
    if (count < 0 && errno != EINTR) give("the program reads no more");
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
}

bool PipedProgram::receive(std::string& into) const {
  char piece[65536];
  ssize_t count = 0;
  do count = ::read(out_, piece, sizeof piece);
  while (count < 0 && errno == EINTR);
  if (count > 0) into.append(piece, static_cast<std::size_t>(count));
  return count > 0;
}

int PipedProgram::finish() {
  if (in_ >= 0) ::close(in_);
  in_ = -1;
  if (child_ < 0) return 0;
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

const TeamReply& PipedTeam::ask(TeamReply::Kind kind) {
  program_.send(out_);
  received_.clear();
  for (;;) {
    const auto length = codec_->firstMessage(received_);
    if (!length) give(length.error().message);
    if (*length > 0) break;
    if (!program_.receive(received_)) give("the program has closed its output");
  }
  const auto length = *codec_->firstMessage(received_);
  if (length != received_.size()) give("more than one answer");
  if (const auto read = codec_->read(received_, reply_); !read) give(read.error().message);
  if (reply_.kind != kind || reply_.id != id_) give("the answer is not that of the request");
  return reply_;
}

void PipedTeam::tell() { program_.send(out_); }

TeamWelcome PipedTeam::hello(const TeamHello& hello) {
  out_.clear();
  codec_->hello(++id_, hello, out_);
  return ask(TeamReply::Kind::kHello).welcome;
}

void PipedTeam::begin(const MatchInfo& info) {
  out_.clear();
  codec_->begin(++id_, info, out_);
  navigators_.clear();
  for (const std::string& text : ask(TeamReply::Kind::kBegin).navigators) {
    const auto navigator = parseNavigator(text);
    if (!navigator) give(navigator.error().message);
    navigators_.push_back(*navigator);
  }
}

TeamCommand PipedTeam::decide(const Observation& seen) {
  out_.clear();
  codec_->decide(++id_, seen, out_);
  return ask(TeamReply::Kind::kDecide).command;
}

std::optional<TeamProposal> PipedTeam::place(const PlacementRequest& request) {
  out_.clear();
  codec_->place(++id_, request, out_);
  return ask(TeamReply::Kind::kPlace).proposal;
}

void PipedTeam::stopped(const PlayStop& stop) {
  out_.clear();
  codec_->stopped(stop, out_);
  tell();
}

void PipedTeam::ready(const Observation& seen) {
  out_.clear();
  codec_->ready(seen, out_);
  tell();
}

void PipedTeam::ended(const MatchEnd& end) {
  out_.clear();
  codec_->ended(end, out_);
  tell();
}

std::optional<ExerciseReply> PipedTeam::exercise(const Observation& seen, const Exercise& exercise) {
  out_.clear();
  codec_->exercise(++id_, seen, exercise, out_);
  return ask(TeamReply::Kind::kExercise).exercise;
}

}  // namespace fulbito::test
