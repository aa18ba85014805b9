#include <optional>

#include "python/bindings/bind.hpp"
#include "python/bindings/episode_values.hpp"
#include "python/bindings/exclusive.hpp"
#include "python/bindings/sources.hpp"
#include "python/environments/episode_runner.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

using Actions = nb::ndarray<const float, nb::c_contig, nb::device::cpu>;
using Floats = nb::ndarray<float, nb::c_contig, nb::device::cpu>;
using Doubles = nb::ndarray<double, nb::c_contig, nb::device::cpu>;
constexpr int kTerminated = 1, kTruncated = 2;

/// One environment that writes into arrays of Python.
class PyEnvironment {
  // The lock of the interpreter is free while the environment works.
  template <typename Work>
  auto use(const Work& work) {
    try {
      const nb::gil_scoped_release unlocked;
      const Exclusive::Use now(exclusive_, "this environment");
      if (!runner_) throw StateFailure("this environment is closed");
      return work(*runner_);
    } catch (const Failure&) {
      if (failure_) failure_->raise();  // what a team raised says more
      throw;
    }
  }

 public:
  PyEnvironment(Source& source, const Floats& observations, const Doubles& numbers)
      : runner_(std::in_place, source.take(), true),
        failure_(source.failure),
        observations_(observations),
        numbers_(numbers) {
    const EpisodeShape& shape = runner_->shape();
    const std::size_t agents = shape.agents, terms = agents * shape.terms.size();
    if (observations.size() != agents * shape.observation ||
        numbers.size() != agents + terms + shape.figures.size()) {
      raise(ErrorCode::kUsage, "the arrays have the wrong size");
    }
    double* number = numbers.data();
    view_ = {{observations.data(), observations.size()},
             {number, agents},
             {number + agents, terms},
             {number + agents + terms, shape.figures.size()}};
  }

  void seed(std::uint64_t seed) {
    use([&](EpisodeRunner& runner) { runner.seed(seed); });
  }
  void reset(const std::string& text) {
    use([&](EpisodeRunner& runner) { valueOf(runner.reset(view_, text)); });
  }
  int step(const Actions& actions) {
    return use([&](EpisodeRunner& runner) {
      const EpisodeShape& shape = runner.shape();
      if (actions.size() != shape.agents * shape.action) raise(ErrorCode::kUsage, "actions: wrong size");
      if (runner.phase() != EpisodeRunner::Phase::kRunning) {
        throw StateFailure(runner.phase() == EpisodeRunner::Phase::kFresh
                               ? "call reset before the first step"
                               : "the episode is over: call reset before the next step");
      }
      const std::span<const float> numbers(actions.data(), actions.size());
      if (const auto flaw = flawOfActions(shape, numbers)) raise(ErrorCode::kUsage, *flaw);
      return codeOf(valueOf(runner.step(numbers, view_)));
    });
  }
  StateTuple state() {
    return tupleOf(use([](EpisodeRunner& runner) { return runner.state(); }));
  }
  int restore(const StateTuple& state) {
    const EpisodeState wanted = stateOf(state);
    return use([&](EpisodeRunner& runner) { return codeOf(valueOf(runner.restore(wanted, view_))); });
  }
  void world(const Floats& out) {
    use([&](EpisodeRunner& runner) {
      if (out.size() != runner.shape().state) raise(ErrorCode::kUsage, "state: the array has the wrong size");
      if (runner.phase() == EpisodeRunner::Phase::kFresh) throw StateFailure("call reset before state");
      runner.source().state({out.data(), out.size()});
    });
  }
  void record(const std::string& file) {
    use([&](EpisodeRunner& runner) { valueOf(runner.source().record(file)); });
  }
  nb::ndarray<nb::numpy, std::uint8_t> picture(int width) {
    auto canvas = use([&](EpisodeRunner& runner) { return valueOf(runner.source().picture(width)); });
    return pixelsOf(canvas);
  }
  void close() {
    const Exclusive::Use now(exclusive_, "this environment");
    runner_.reset();
  }

 private:
  static int codeOf(EpisodeEnd end) {
    return (end.terminated ? kTerminated : 0) | (end.truncated ? kTruncated : 0);
  }

  std::optional<EpisodeRunner> runner_;
  SharedFailure failure_;
  Floats observations_;  // kept alive
  Doubles numbers_;
  EpisodeView view_;
  Exclusive exclusive_;
};

}  // namespace

void bindEnvironments(nb::module_& m) {
  nb::class_<Source>(m, "Source", "A source of episodes, which one environment takes.")
      .def_prop_ro(
          "shape",
          [](const Source& source) -> ShapeDict {
            if (!source.episodes) throw StateFailure("this source of episodes belongs to an environment");
            return dictOf(source.episodes->shape());
          },
          "Sizes and names as a dict; see python/environments/episodes.hpp.");
  nb::class_<PyEnvironment>(m, "Environment", "One environment that writes into arrays.")
      .def(nb::init<Source&, const Floats&, const Doubles&>(), nb::arg("source"),
           nb::arg("observations").noconvert(), nb::arg("numbers").noconvert(),
           "`observations`: float32, agents x observation. `numbers`: float64, the agents' rewards, their "
           "terms, "
           "then the figures.")
      .def("seed", &PyEnvironment::seed, nb::arg("seed"))
      .def("reset", &PyEnvironment::reset, nb::arg("start"))
      .def("step", &PyEnvironment::step, nb::arg("actions").noconvert(),
           "Plays one step. Returns 1 if it terminated the episode, 2 if it truncated it, else 0.")
      .def("state", &PyEnvironment::state)
      .def("restore", &PyEnvironment::restore, nb::arg("state"))
      .def("world", &PyEnvironment::world, nb::arg("out").noconvert())
      .def("record", &PyEnvironment::record, nb::arg("file"))
      .def("picture", &PyEnvironment::picture, nb::arg("width"))
      .def("close", &PyEnvironment::close);
}

}  // namespace fulbito::python
