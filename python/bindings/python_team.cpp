#include "python/bindings/python_team.hpp"

#include <chrono>
#include <cstdio>
#include <functional>
#include <nanobind/stl/string.h>

#include "bridge/abi/library_team.hpp"
#include "bridge/lines/line_codec.hpp"
#include "bridge/wire/wire_teams.hpp"
#include "fulbito/outside.hpp"
#include "python/bindings/errors.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;
using Kind = TeamReply::Kind;

/// A team in this process. It has the conversation of a program's team, but without pipes: a line in, a line
/// out.
class PythonTeam final : public Strategy {
 public:
  /// `team`: an object or a class. Needs no GIL.
  PythonTeam(std::shared_ptr<HeldObject> team, std::string name, SharedFailure failure)
      : team_(std::move(team)), name_(std::move(name)), failure_(std::move(failure)) {}

  void begin(const MatchInfo& info) override {
    start();
    if (!ask(Kind::kHello,
             [](TeamCodec& c, std::uint64_t id, std::string& out) { c.hello(id, {"fulbito", {}}, out); }))
      return;
    welcome_ = reply_.welcome;
    if (!ask(Kind::kBegin, [&](TeamCodec& c, std::uint64_t id, std::string& out) { c.begin(id, info, out); }))
      return;
    navigators_.clear();
    for (const std::string& name : reply_.navigators) {
      navigators_.push_back(navigatorFor(name, parseNavigator));
    }
  }
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  TeamCommand decide(const Observation& seen) override {
    const bool answered = ask(
        Kind::kDecide, [&](TeamCodec& c, std::uint64_t id, std::string& out) { c.decide(id, seen, out); });
    return answered ? std::move(reply_.command) : TeamCommand{};
  }
  std::optional<TeamProposal> place(const PlacementRequest& request) override {
    const bool answered = ask(
        Kind::kPlace, [&](TeamCodec& c, std::uint64_t id, std::string& out) { c.place(id, request, out); });
    return answered ? std::move(reply_.proposal) : std::nullopt;
  }
  std::optional<fulbito::ExerciseReply> exercise(const Observation& seen, const Exercise& task) override {
    const bool answered = ask(Kind::kExercise, [&](TeamCodec& c, std::uint64_t id, std::string& out) {
      c.exercise(id, seen, task, out);
    });
    return answered ? std::move(reply_.exercise) : std::nullopt;
  }
  void stopped(const PlayStop& stop) override {
    tell([&](TeamCodec& c, std::string& out) { c.stopped(stop, out); });
  }
  void ready(const Observation& now) override {
    tell([&](TeamCodec& c, std::string& out) { c.ready(now, out); });
  }
  void ended(const MatchEnd& end) override {
    tell([&](TeamCodec& c, std::string& out) { c.ended(end, out); });
  }
  const TeamCondition& condition() const override { return condition_; }
  std::vector<Setting> origin() const override {
    std::vector<Setting> origin{{"name", welcome_.name.empty() ? name_ : welcome_.name}};
    if (!welcome_.version.empty()) origin.push_back({"version", welcome_.version});
    return origin;
  }

 private:
  void start() {
    const nb::gil_scoped_acquire gil;
    guarded([&] {
      nb::object team = team_->get();
      if (PyType_Check(team.ptr())) team = team();
      const nb::object take = nb::module_::import_("fulbito._teams").attr("conversation")(team);
      take_ = std::make_shared<HeldObject>(take);
    });
  }
  /// Writes a request and reads its answer into `reply_`.
  template <typename Write>
  bool ask(Kind kind, const Write& write) {
    const std::uint64_t id = ++last_id_;
    line_.clear();
    write(codec_, id, line_);
    if (!exchange()) return false;
    const auto read = codec_.read(answer_, reply_);
    if (read && reply_.kind == kind && reply_.id == id) return true;
    broken(read ? "an answer to another request" : read.error().message);
    return false;
  }
  template <typename Write>
  void tell(const Write& write) {
    line_.clear();
    write(codec_, line_);
    exchange();
  }
  /// Gives the line to Python. False after a failure, then and from then on.
  bool exchange() {
    if (condition_.state == TeamCondition::State::kCut) return false;
    const nb::gil_scoped_acquire gil;
    guarded([&] {
      const nb::object answer = take_->get()(line_);
      answer_ = answer.is_none() ? "" : nb::cast<std::string>(answer);
    });
    return condition_.state != TeamCondition::State::kCut;
  }
  template <typename Call>
  void guarded(const Call& call) {
    try {
      call();
    } catch (nb::python_error& error) {
      cut(error.what());
      failure_->keep(std::move(error), "team '" + name_ + "'");
    }
  }
  void broken(const std::string& text) {
    const nb::gil_scoped_acquire gil;
    cut(text);
    failure_->keep("team '" + name_ + "'", text);
  }
  void cut(const std::string& reason) {
    condition_.state = TeamCondition::State::kCut;
    condition_.reason = reason;
  }

  std::shared_ptr<HeldObject> team_, take_;
  std::string name_;
  SharedFailure failure_;
  LineCodec codec_;
  TeamReply reply_;
  TeamWelcome welcome_;
  TeamCondition condition_;
  std::vector<NavigatorChoice> navigators_;
  std::string line_, answer_;
  std::uint64_t last_id_ = 0;
};

std::int64_t now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

void requireOneOf(const std::string& value, const char* name, const char* a, const char* b) {
  if (value == a || value == b) return;
  raise(ErrorCode::kUsage, std::string(name) + " = '" + value + "' is neither '" + a + "' nor '" + b + "'");
}

}  // namespace

TeamCatalogue catalogueOf(const Containment& containment) {
  requireOneOf(containment.isolate, "isolate", "process", "none");
  requireOneOf(containment.sandbox, "sandbox", "best", "require");
  if (!(containment.memory_mb >= 16.0 && containment.memory_mb <= 1048576.0))
    raise(ErrorCode::kUsage, "memory_mb is outside 16 ... 1048576 MiB");
  if (containment.processes < 1 || containment.processes > 10'000)
    raise(ErrorCode::kUsage, "processes is outside 1 ... 10000");
  OutsideOptions options;
  using Isolation = OutsideOptions::Isolation;
  options.isolation = containment.isolate == "none" ? Isolation::kNone : Isolation::kProcess;
  options.sandbox_required = containment.sandbox == "require";
  options.limits.memory = static_cast<std::size_t>(containment.memory_mb * 1048576.0);
  options.limits.processes = containment.processes;
  options.limits.network = containment.network;
  options.clock = now;
  options.log = [](const std::string& team, std::string_view line) {
    std::fprintf(stderr, "%s: %.*s\n", team.c_str(), static_cast<int>(line.size()), line.data());
  };
  const nb::object companions = nb::module_::import_("fulbito.program").attr("companions")();
  options.host = nb::cast<std::string>(companions[0]);
  options.python_folder = nb::cast<std::string>(companions[1]);
  TeamCatalogue catalogue = TeamCatalogue::builtIn();
  catalogue.addSource(outsideTeams(options));
  catalogue.addSource(wire::wireTeams(std::move(options), [](std::string_view line) {
    std::fprintf(stderr, "wire: %.*s\n", static_cast<int>(line.size()), line.data());
  }));
  return catalogue;
}

TeamChoice teamFrom(nb::handle team, const TeamCatalogue& catalogue, const SharedFailure& failure) {
  if (nb::isinstance<nb::str>(team)) {
    const auto text = nb::cast<std::string>(team);
    auto parsed = [&] {
      const nb::gil_scoped_release parsing_may_start_a_program;
      return catalogue.parse(text);
    }();
    return valueOf(std::move(parsed));
  }
  if (!PyCallable_Check(nb::getattr(team, "decide", nb::none()).ptr())) {
    raise(ErrorCode::kUsage,
          std::string("a team is a specification or has the functions of fulbito.team.Team, not ") +
              nb::repr(team).c_str());
  }
  const auto name = nb::cast<std::string>(nb::module_::import_("fulbito._teams").attr("name_of")(team));
  const auto held = std::make_shared<HeldObject>(nb::borrow(team));
  return TeamChoice::own(name,
                         [held, name, failure] { return std::make_unique<PythonTeam>(held, name, failure); });
}

}  // namespace fulbito::python
