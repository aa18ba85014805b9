#include "python/environments/vector_environment.hpp"

#include <numeric>

#include "tests/support/catch.hpp"
#include "tests/unit/python/environments/counting_source.hpp"

namespace fulbito {
namespace {

using test::CountingSource;

/// A vector of counting episodes with its arrays. Environment i ends after i + 2 steps.
struct Counters {
  Counters(std::size_t count, VectorSettings settings) : size(count) {
    std::vector<std::unique_ptr<EpisodeSource>> sources;
    for (std::size_t i = 0; i < count; ++i) {
      sources.push_back(std::make_unique<CountingSource>(static_cast<int>(i) + 2));
    }
    vector = std::move(*VectorEnvironment::create(std::move(sources), settings));
    VectorArrays all;
    for (std::size_t k = 0; k < 2; ++k) {
      all.all[k] = sets[k].rows(count);
      all.some[k] = sets[2 + k].rows(count);
    }
    last_seen.resize(2 * count);
    last_figures.resize(count);
    filled.resize(count);
    all.last = {last_seen.data(), last_figures.data(), filled.data()};
    vector->use(all);
    for (std::size_t i = 0; i < count; ++i) vector->seed(i, i);
  }

  struct Set {
    VectorRows rows(std::size_t count) {
      seen.resize(2 * count);
      rewards.resize(count);
      terms.resize(count);
      figures.resize(count);
      flags.resize(2 * count);
      return {seen.data(), rewards.data(), flags.data(), flags.data() + count, terms.data(), figures.data()};
    }
    std::vector<float> seen;
    std::vector<double> rewards, terms, figures;
    std::vector<std::uint8_t> flags;
  };

  const Set& step(float action) {
    const std::vector<float> actions(size, action);
    return sets[static_cast<std::size_t>(*vector->step(actions))];
  }

  std::size_t size;
  std::array<Set, 4> sets;
  std::vector<float> last_seen;
  std::vector<double> last_figures;
  std::vector<std::uint8_t> filled;
  std::unique_ptr<VectorEnvironment> vector;
};

}  // namespace

TEST_CASE("a vector resets in the next step", "[unit]") {
  for (const int threads : {1, 3}) {
    Counters counters(5, {threads, Autoreset::kNextStep, false});
    REQUIRE(counters.vector->reset({}));
    counters.step(1.0f);
    const auto& second = counters.step(1.0f);
    CHECK(second.flags[0] == 1);
    CHECK(second.seen[1] == 2.0f);
    const float seed = second.seen[0];
    const auto& third = counters.step(1.0f);
    CHECK(third.flags[0] == 0);
    CHECK(third.rewards[0] == 0.0);
    CHECK(third.seen[1] == 0.0f);
    CHECK(third.seen[0] != seed);
    CHECK(third.seen[3] == 3.0f);
    CHECK(third.flags[1] == 1);
  }
}

TEST_CASE("a vector resets in the same step, and keeps the last moment", "[unit]") {
  Counters counters(3, {2, Autoreset::kSameStep, false});
  REQUIRE(counters.vector->reset({}));
  counters.step(1.0f);
  const auto& second = counters.step(1.0f);
  CHECK(second.flags[0] == 1);
  CHECK(second.rewards[0] == 1.0);
  CHECK(second.seen[1] == 0.0f);
  CHECK(second.figures[0] == 0.0);
  CHECK(counters.filled == std::vector<std::uint8_t>{1, 0, 0});
  CHECK(counters.last_seen[1] == 2.0f);
  CHECK(counters.last_figures[0] == 2.0);
  counters.step(1.0f);
  CHECK(counters.filled == std::vector<std::uint8_t>{0, 1, 0});
}

TEST_CASE("without autoreset the caller resets some", "[unit]") {
  Counters counters(3, {2, Autoreset::kDisabled, false});
  CHECK(counters.vector->firstIdle({}) == 0);
  REQUIRE(counters.vector->reset({}));
  CHECK_FALSE(counters.vector->firstIdle({}));
  counters.step(1.0f);
  counters.step(1.0f);
  CHECK(counters.vector->firstIdle({}) == 0);
  const std::array<std::uint32_t, 2> others{1, 2};
  CHECK_FALSE(counters.vector->firstIdle(others));
  const std::array<bool, 3> mask{true, false, false};
  const auto set = counters.vector->reset(mask);
  REQUIRE(set);
  CHECK(counters.sets[static_cast<std::size_t>(*set)].seen[1] == 0.0f);
  CHECK(counters.sets[static_cast<std::size_t>(*set)].seen[3] == 2.0f);
}

TEST_CASE("a step of some environments has their rows in its order", "[unit]") {
  Counters counters(4, {3, Autoreset::kNextStep, false});
  REQUIRE(counters.vector->reset({}));
  const std::array<std::uint32_t, 2> ids{3, 1};
  const std::array<float, 2> actions{0.75f, 1.0f};
  counters.vector->send(actions, ids);
  CHECK(counters.vector->isUnderWay());
  const auto set = counters.vector->receive();
  REQUIRE(set);
  const auto& some = counters.sets[2 + static_cast<std::size_t>(*set)];
  CHECK(some.seen[1] == 0.75f);
  CHECK(some.seen[3] == 1.0f);
  CHECK(counters.step(0.0f).seen[7] == 0.75f);
}

TEST_CASE("an error is that of the first environment, whatever the number of threads", "[unit]") {
  for (const int threads : {1, 4}) {
    Counters counters(6, {threads, Autoreset::kNextStep, false});
    REQUIRE(counters.vector->reset({}));
    std::vector<float> actions(6, 1.0f);
    actions[2] = 0.5f;
    actions[4] = 0.25f;
    const auto failed = counters.vector->step(actions);
    REQUIRE_FALSE(failed);
    CHECK(failed.error().message == "no room");
    CHECK(counters.vector->firstIdle({}) == 2);
    REQUIRE(counters.vector->reset({}));
    actions[2] = 1.0f;
    CHECK_THROWS_WITH(counters.vector->step(actions), "thrown");
    CHECK_FALSE(counters.vector->reset({}, "nowhere"));
    REQUIRE(counters.vector->reset({}));
    CHECK(counters.step(1.0f).seen[1] == 1.0f);
  }
}

TEST_CASE("many rounds over many threads do every task once", "[unit]") {
  WorkerPool pool(4);
  std::vector<int> done(301, 0);
  for (int round = 0; round < 2000; ++round) {
    const std::size_t count = static_cast<std::size_t>(round % 301);
    pool.start(count, [](void* all, std::size_t i) { ++(*static_cast<std::vector<int>*>(all))[i]; }, &done);
    pool.finish();
  }
  std::vector<int> expected(301, 0);
  for (int round = 0; round < 2000; ++round) {
    for (int i = 0; i < round % 301; ++i) ++expected[static_cast<std::size_t>(i)];
  }
  CHECK(done == expected);
}

TEST_CASE("a vector needs environments of one shape", "[unit]") {
  CHECK_FALSE(VectorEnvironment::create({}, {}));
}

TEST_CASE("a runner plays a state again", "[unit]") {
  std::array<float, 2> seen{};
  std::array<double, 3> numbers{};
  const EpisodeView view{seen, {numbers.data(), 1}, {numbers.data() + 1, 1}, {numbers.data() + 2, 1}};
  EpisodeRunner runner(std::make_unique<CountingSource>(4), true);
  CHECK(runner.phase() == EpisodeRunner::Phase::kFresh);
  runner.seed(5);
  REQUIRE(runner.reset(view));
  REQUIRE(runner.reset(view, "somewhere"));
  const std::array<float, 1> action{0.75f};
  REQUIRE(runner.step(action, view));
  REQUIRE(runner.step(action, view));
  const EpisodeState state = runner.state();
  CHECK(state.episodes == 2);
  CHECK(state.start->text == "somewhere");
  const std::array<float, 2> then = seen;
  REQUIRE(runner.reset(view));
  EpisodeRunner other(std::make_unique<CountingSource>(4), true);
  REQUIRE(other.restore(state, view));
  CHECK(seen == then);
  CHECK(numbers[2] == 2.0);
  REQUIRE(other.restore(other.state(), view));
  CHECK(seen == then);
  EpisodeState wrong = state;
  wrong.actions.assign(9, 1.0f);
  CHECK_FALSE(other.restore(wrong, view));
  REQUIRE(other.restore({}, view));
  CHECK(other.phase() == EpisodeRunner::Phase::kFresh);
}

TEST_CASE("actions that are no actions are named", "[unit]") {
  EpisodeShape shape;
  const std::array<float, 2> none{0.0f, std::numeric_limits<float>::quiet_NaN()};
  CHECK(flawOfActions(shape, none) == "actions: number 1 is nan, not finite");
  shape.choices = 3;
  const std::array<float, 2> far{2.0f, 3.0f};
  CHECK(flawOfActions(shape, far) == "actions: 3 is no choice of 0 ... 2");
  CHECK(flawOfActions(shape, std::array{1.5f}));
  CHECK_FALSE(flawOfActions(shape, std::array{0.0f, 2.0f}));
}

}  // namespace fulbito
