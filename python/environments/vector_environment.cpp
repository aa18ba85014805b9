#include "python/environments/vector_environment.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/core/base/float_mode.hpp"
#include "engine/core/system/worker_threads.hpp"

namespace fulbito {
namespace {

bool sameShape(const EpisodeShape& a, const EpisodeShape& b) {
  return a.agents == b.agents && a.observation == b.observation && a.action == b.action &&
         a.choices == b.choices && a.terms == b.terms && a.figures == b.figures;
}

template <typename T>
void copy(const T* from, std::size_t from_row, T* to, std::size_t to_row, std::size_t width) {
  std::copy_n(from + from_row * width, width, to + to_row * width);
}

}  // namespace

Result<std::unique_ptr<VectorEnvironment>> VectorEnvironment::create(
    std::vector<std::unique_ptr<EpisodeSource>> sources, const VectorSettings& settings) {
  if (sources.empty() || sources.size() > WorkerPool::kMostTasks) {
    return fail(ErrorCode::kUsage, "num_envs: " + std::to_string(sources.size()) + " is outside 1 ... " +
                                       std::to_string(WorkerPool::kMostTasks));
  }
  for (const auto& source : sources) {
    if (!sameShape(source->shape(), sources.front()->shape())) {
      return fail(ErrorCode::kUsage, "the environments of a vector need the same observations and actions");
    }
  }
  return std::unique_ptr<VectorEnvironment>(new VectorEnvironment(std::move(sources), settings));
}

VectorEnvironment::VectorEnvironment(std::vector<std::unique_ptr<EpisodeSource>> sources,
                                     const VectorSettings& settings)
    : autoreset_(settings.autoreset),
      everyone_(sources.size()),
      errors_(sources.size()),
      pool_(threadsFor(settings.threads, sources.size())) {
  exceptions_.resize(sources.size());
  runners_.reserve(sources.size());
  for (auto& source : sources) runners_.emplace_back(std::move(source), settings.remembers);
  std::iota(everyone_.begin(), everyone_.end(), 0u);
  sent_.reserve(runners_.size());
  actions_.reserve(runners_.size() * shape().agents * shape().action);
}

VectorEnvironment::~VectorEnvironment() {
  if (under_way_ && !forked()) pool_.finish();
}

EpisodeView VectorEnvironment::viewOf(const VectorRows& rows, std::size_t row) const {
  const EpisodeShape& s = shape();
  const std::size_t seen = s.agents * s.observation, terms = s.agents * s.terms.size();
  return {{rows.observations + row * seen, seen},
          {rows.rewards + row * s.agents, s.agents},
          {rows.terms + row * terms, terms},
          {rows.figures + row * s.figures.size(), s.figures.size()}};
}

void VectorEnvironment::mark(const VectorRows& rows, std::size_t row, EpisodeEnd end) const {
  const std::size_t agents = shape().agents;
  std::fill_n(rows.terminated + row * agents, agents, static_cast<std::uint8_t>(end.terminated));
  std::fill_n(rows.truncated + row * agents, agents, static_cast<std::uint8_t>(end.truncated));
}

void VectorEnvironment::copyRow(const VectorRows& from, std::size_t row, const VectorRows& to,
                                std::size_t to_row) const {
  const EpisodeShape& s = shape();
  copy(from.observations, row, to.observations, to_row, s.agents * s.observation);
  copy(from.rewards, row, to.rewards, to_row, s.agents);
  copy(from.terminated, row, to.terminated, to_row, s.agents);
  copy(from.truncated, row, to.truncated, to_row, s.agents);
  copy(from.terms, row, to.terms, to_row, s.agents * s.terms.size());
  copy(from.figures, row, to.figures, to_row, s.figures.size());
}

void VectorEnvironment::keepLast(const EpisodeView& view, std::size_t i) const {
  std::copy(view.observations.begin(), view.observations.end(),
            arrays_.last.observations + i * view.observations.size());
  std::copy(view.figures.begin(), view.figures.end(), arrays_.last.figures + i * view.figures.size());
  arrays_.last.filled[i] = 1;
}

Result<void> VectorEnvironment::stepOne(std::size_t i, std::size_t task, const VectorRows& rows) {
  EpisodeRunner& runner = runners_[i];
  const EpisodeView view = viewOf(rows, i);
  const bool same_step = autoreset_ == Autoreset::kSameStep;
  if (same_step) arrays_.last.filled[i] = 0;
  if (resets_ || runner.phase() == EpisodeRunner::Phase::kOver) {
    mark(rows, i, {});
    return resets_ ? runner.reset(view, text_) : runner.reset(view);
  }
  const std::size_t width = shape().agents * shape().action;
  const auto end = runner.step(std::span(actions_).subspan(task * width, width), view);
  if (!end) return tl::unexpected<Error>(end.error());
  mark(rows, i, *end);
  if (!same_step || !end->any()) return {};
  keepLast(view, i);
  // Rewards and terms stay those of the step.
  return runner.reset({view.observations, {}, {}, view.figures});
}

void VectorEnvironment::run(std::size_t task) {
  const FloatMode floats;
  const std::size_t i = sent_[task];
  try {
    if (auto done = stepOne(i, task, newest()); !done) {
      errors_[task] = std::move(done.error());
    }
  } catch (...) {
    exceptions_[task] = std::current_exception();
  }
}

Result<void> VectorEnvironment::finish() {
  pool_.finish();
  under_way_ = false;
  for (std::size_t task = 0; task < sent_.size(); ++task) {
    if (exceptions_[task]) {
      const std::exception_ptr first = exceptions_[task];
      std::fill(exceptions_.begin(), exceptions_.end(), nullptr);
      std::fill(errors_.begin(), errors_.end(), std::nullopt);
      std::rethrow_exception(first);
    }
    if (errors_[task]) {
      Error first = std::move(*errors_[task]);
      std::fill(exceptions_.begin(), exceptions_.end(), nullptr);
      std::fill(errors_.begin(), errors_.end(), std::nullopt);
      return tl::unexpected<Error>(std::move(first));
    }
  }
  return {};
}

Result<int> VectorEnvironment::reset(std::span<const bool> mask, const std::string& text) {
  sent_.clear();
  for (const std::uint32_t i : everyone_) {
    if (mask.empty() || mask[i]) sent_.push_back(i);
  }
  if (sent_.size() == size()) all_ = 1 - all_;
  text_ = text;
  resets_ = true;
  begin();
  auto done = finish();
  resets_ = false;
  if (!done) return tl::unexpected<Error>(done.error());
  return all_;
}

std::optional<std::size_t> VectorEnvironment::firstIdle(std::span<const std::uint32_t> ids) const {
  for (const std::uint32_t i : ids.empty() ? std::span<const std::uint32_t>(everyone_) : ids) {
    const EpisodeRunner::Phase phase = runners_[i].phase();
    const bool waits = phase == EpisodeRunner::Phase::kOver && autoreset_ == Autoreset::kDisabled;
    if (waits || phase == EpisodeRunner::Phase::kFresh || phase == EpisodeRunner::Phase::kBroken) return i;
  }
  return std::nullopt;
}

void VectorEnvironment::begin() {
  under_way_ = true;
  pool_.start(
      sent_.size(), [](void* self, std::size_t task) { static_cast<VectorEnvironment*>(self)->run(task); },
      this);
}

void VectorEnvironment::send(std::span<const float> actions, std::span<const std::uint32_t> ids) {
  partly_ = !ids.empty();
  if (!partly_) {
    ids = everyone_;
    all_ = 1 - all_;
  }
  sent_.assign(ids.begin(), ids.end());
  actions_.assign(actions.begin(), actions.end());
  begin();
}

Result<int> VectorEnvironment::receive() {
  if (auto done = finish(); !done) return tl::unexpected<Error>(done.error());
  if (!partly_) return all_;
  some_ = 1 - some_;
  for (std::size_t row = 0; row < sent_.size(); ++row) {
    copyRow(newest(), sent_[row], arrays_.some[static_cast<std::size_t>(some_)], row);
  }
  return some_;
}

Result<void> VectorEnvironment::restore(std::size_t i, const EpisodeState& state) {
  const FloatMode floats;
  const auto end = runners_[i].restore(state, viewOf(newest(), i));
  if (!end) return tl::unexpected<Error>(end.error());
  mark(newest(), i, *end);
  return {};
}

}  // namespace fulbito
