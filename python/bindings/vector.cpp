#include <exception>
#include <memory>
#include <vector>

#include "python/bindings/bind.hpp"
#include "python/bindings/episode_values.hpp"
#include "python/bindings/exclusive.hpp"
#include "python/bindings/sources.hpp"
#include "python/environments/vector_environment.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

constexpr const char* kWhat = "this vector of environments";

template <typename T>
using Array = nb::ndarray<T, nb::c_contig, nb::device::cpu>;

/// Environments over threads that write into arrays of Python.
class PyVector {
  // The lock of the interpreter is free while environments work.
  template <typename Work>
  auto unlocked(const Work& work) {
    try {
      const nb::gil_scoped_release released;
      const Exclusive::Use now(exclusive_, kWhat);
      return work();
    } catch (const Failure&) {
      raiseKept();  // what a team raised says more
      throw;
    }
  }

 public:
  PyVector(const nb::typed<nb::list, Source>& sources, int threads, int autoreset, bool remembers) {
    std::vector<std::unique_ptr<EpisodeSource>> taken;
    for (const nb::handle source : sources) {
      taken.push_back(nb::cast<Source&>(source).take());
      failures_.push_back(nb::cast<Source&>(source).failure);
    }
    const VectorSettings settings{threads, static_cast<Autoreset>(autoreset), remembers};
    vector_ = valueOf(VectorEnvironment::create(std::move(taken), settings));
  }

  /// `arrays`: for each of all 0, all 1, some 0, some 1: observations, rewards, terminated, truncated, terms,
  /// figures; then observations, figures and marks of last moments.
  void useArrays(const nb::typed<nb::list, nb::any>& arrays) {
    const Exclusive::Use now(exclusive_, kWhat);
    VectorEnvironment& vector = open();
    const EpisodeShape& shape = vector.shape();
    const std::size_t rows = vector.size(), agents = rows * shape.agents;
    std::size_t next = 0;
    std::vector<nb::object> kept;
    const auto take = [&]<typename T>(T*& to, std::size_t size) {
      const nb::object given = arrays[next++];
      Array<T> array;
      if (!nb::try_cast(given, array, false) || array.size() != size) {
        raise(ErrorCode::kUsage,
              "array " + std::to_string(next - 1) + " is not a writable array of its dtype and size");
      }
      to = array.data();
      kept.push_back(given);
    };
    const auto takeFlags = [&](std::uint8_t*& to, std::size_t size) {
      bool* flags = nullptr;
      take(flags, size);
      to = reinterpret_cast<std::uint8_t*>(flags);
    };
    VectorArrays all;
    for (auto* pair : {&all.all, &all.some}) {
      for (VectorRows& to : *pair) {
        take(to.observations, agents * shape.observation);
        take(to.rewards, agents);
        takeFlags(to.terminated, agents);
        takeFlags(to.truncated, agents);
        take(to.terms, agents * shape.terms.size());
        take(to.figures, rows * shape.figures.size());
      }
    }
    take(all.last.observations, agents * shape.observation);
    take(all.last.figures, rows * shape.figures.size());
    takeFlags(all.last.filled, rows);
    vector.use(all);
    arrays_ = std::move(kept);
  }

  void seed(std::size_t i, std::uint64_t seed) {
    const Exclusive::Use now(exclusive_, kWhat);
    rested().seed(indexed(i), seed);
  }
  int reset(const Array<const bool>& mask, const std::string& text) {
    return unlocked([&] {
      VectorEnvironment& vector = rested();
      if (mask.size() != 0 && mask.size() != vector.size()) {
        raise(ErrorCode::kUsage, "reset_mask: its shape is not (" + std::to_string(vector.size()) + ",)");
      }
      return valueOf(vector.reset({mask.data(), mask.size()}, text));
    });
  }
  void send(const Array<const float>& actions, const Array<const std::uint32_t>& ids) {
    unlocked([&] { start(actions, ids); });
  }
  int receive() {
    return unlocked([&] {
      if (!open().isUnderWay()) throw StateFailure("nothing was sent: call send before recv");
      return valueOf(vector_->receive());
    });
  }
  int step(const Array<const float>& actions) {
    return unlocked([&] {
      start(actions, {});
      return valueOf(vector_->receive());
    });
  }
  std::vector<StateTuple> states() {
    std::vector<EpisodeState> all = unlocked([&] {
      VectorEnvironment& vector = rested();
      std::vector<EpisodeState> found;
      for (std::size_t i = 0; i < vector.size(); ++i) found.push_back(vector[i].state());
      return found;
    });
    std::vector<StateTuple> told;
    for (const EpisodeState& state : all) told.push_back(tupleOf(state));
    return told;
  }
  void restore(std::size_t i, const StateTuple& state) {
    const EpisodeState wanted = stateOf(state);
    unlocked([&] {
      VectorEnvironment& vector = rested();
      valueOf(vector.restore(indexed(i), wanted));
    });
  }
  nb::ndarray<nb::numpy, std::uint8_t> picture(std::size_t i, int width) {
    return pixelsOf(unlocked([&] { return valueOf(rested()[indexed(i)].source().picture(width)); }));
  }
  void record(std::size_t i, const std::string& file) {
    unlocked([&] { valueOf(rested()[indexed(i)].source().record(file)); });
  }
  void close() {
    const Exclusive::Use now(exclusive_, kWhat);
    const nb::gil_scoped_release unlocked;
    vector_.reset();
  }
  ShapeDict shape() {
    const Exclusive::Use now(exclusive_, kWhat);
    return dictOf(open().shape());
  }
  int threads() {
    const Exclusive::Use now(exclusive_, kWhat);
    return open().threads();
  }

 private:
  /// Raises the first exception of a team, and drops the others: they would keep alive who holds this object.
  void raiseKept() {
    std::exception_ptr first;
    for (const SharedFailure& failure : failures_) {
      try {
        if (failure) failure->raise();
      } catch (const nb::python_error&) {
        if (!first) first = std::current_exception();
      }
    }
    if (first) std::rethrow_exception(first);
  }
  VectorEnvironment& open() {
    if (!vector_) throw StateFailure("this environment is closed");
    if (vector_->forked() && vector_->threads() > 1) {
      throw StateFailure(
          "this process is a fork of the one that made this vector, and has none of its threads");
    }
    return *vector_;
  }
  VectorEnvironment& rested() {
    VectorEnvironment& vector = open();
    if (vector.isUnderWay()) throw StateFailure("a step is under way: call recv first");
    return vector;
  }
  std::size_t indexed(std::size_t i) const {
    if (i < vector_->size()) return i;
    raise(ErrorCode::kUsage,
          "there is no environment " + std::to_string(i) + " of " + std::to_string(vector_->size()));
  }
  void checkIds(std::span<const std::uint32_t> ids) {
    marked_.assign(vector_->size(), false);
    for (const std::uint32_t id : ids) {
      if (marked_[indexed(id)])
        raise(ErrorCode::kUsage, "env_ids: " + std::to_string(id) + " is twice in it");
      marked_[id] = true;
    }
  }
  void start(const Array<const float>& actions, const Array<const std::uint32_t>& given) {
    VectorEnvironment& vector = rested();
    const std::span<const std::uint32_t> ids(given.data(), given.size());
    if (!ids.empty()) checkIds(ids);
    const EpisodeShape& shape = vector.shape();
    const std::size_t rows = ids.empty() ? vector.size() : ids.size();
    if (actions.size() != rows * shape.agents * shape.action) raise(ErrorCode::kUsage, "actions: wrong size");
    const std::span<const float> numbers(actions.data(), actions.size());
    if (const auto flaw = flawOfActions(shape, numbers)) raise(ErrorCode::kUsage, *flaw);
    if (const auto idle = vector.firstIdle(ids)) {
      throw StateFailure("environment " + std::to_string(*idle) +
                         " has no episode: call reset before the next step");
    }
    vector.send(numbers, ids);
  }

  std::unique_ptr<VectorEnvironment> vector_;
  std::vector<nb::object> arrays_;  // kept alive
  std::vector<SharedFailure> failures_;
  std::vector<bool> marked_;
  Exclusive exclusive_;
};

}  // namespace

void bindVector(nb::module_& m) {
  nb::class_<PyVector>(m, "Vector", "Environments over threads that write into arrays.")
      .def(nb::init<const nb::typed<nb::list, Source>&, int, int, bool>(), nb::arg("sources"),
           nb::arg("threads"), nb::arg("autoreset"), nb::arg("remembers"))
      .def("use", &PyVector::useArrays, nb::arg("arrays"))
      .def("seed", &PyVector::seed, nb::arg("i"), nb::arg("seed"))
      .def("reset", &PyVector::reset, nb::arg("mask").noconvert(), nb::arg("start"))
      .def("send", &PyVector::send, nb::arg("actions").noconvert(), nb::arg("ids").noconvert())
      .def("receive", &PyVector::receive)
      .def("step", &PyVector::step, nb::arg("actions").noconvert())
      .def("states", &PyVector::states)
      .def("restore", &PyVector::restore, nb::arg("i"), nb::arg("state"))
      .def("picture", &PyVector::picture, nb::arg("i"), nb::arg("width"))
      .def("record", &PyVector::record, nb::arg("i"), nb::arg("file"))
      .def("close", &PyVector::close)
      .def_prop_ro("shape", &PyVector::shape)
      .def_prop_ro("threads", &PyVector::threads);
}

}  // namespace fulbito::python
