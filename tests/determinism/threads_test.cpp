#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "bench/scenes.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

// A short run, so that many fit into a test.
Scene shortScene(std::size_t i) {
  std::vector<Scene> scenes = fixedScenes();
  Scene scene = scenes[i % scenes.size()];
  scene.ticks = 200;
  return scene;
}

std::vector<std::uint64_t> hashesOn(std::size_t threads, std::size_t worlds) {
  std::vector<std::uint64_t> hashes(worlds);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < worlds; i = next++) hashes[i] = hashOfRun(shortScene(i));
  };
  std::vector<std::thread> pool;
  for (std::size_t i = 1; i < threads; ++i) pool.emplace_back(work);
  work();
  for (std::thread& thread : pool) thread.join();
  return hashes;
}

}  // namespace

TEST_CASE("one to eight worlds on one to four threads give the same hashes", "[determinism]") {
  const std::vector<std::uint64_t> alone = hashesOn(1, 8);
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    for (std::size_t worlds = 1; worlds <= 8; ++worlds) {
      const std::vector<std::uint64_t> hashes = hashesOn(threads, worlds);
      CHECK(std::equal(hashes.begin(), hashes.end(), alone.begin()));
    }
  }
}

TEST_CASE("worlds stepped in turn do not influence each other", "[determinism]") {
  const Scene scene = shortScene(2);
  std::vector<World> worlds;
  std::vector<SceneDriver> drivers;
  for (int i = 0; i < 8; ++i) {
    worlds.push_back(std::move(*World::create(scene.config)));
    drivers.emplace_back(scene.load, scene.config.robots.size(), scene.config.physics.control_rate, 1);
  }
  for (int tick = 0; tick < scene.ticks; ++tick) {
    for (std::size_t i = 0; i < 8; ++i) worlds[i].step(drivers[i].drive(worlds[i].state()));
  }
  for (const World& world : worlds) {
    CHECK(world.state().balls[0].position == worlds[0].state().balls[0].position);
    CHECK(world.state().robots[5].pose.heading == worlds[0].state().robots[5].pose.heading);
  }
}

TEST_CASE("each fixed scene has a hash of its own", "[determinism]") {
  std::vector<std::uint64_t> hashes = hashesOn(1, fixedScenes().size());
  std::sort(hashes.begin(), hashes.end());
  CHECK(std::adjacent_find(hashes.begin(), hashes.end()) == hashes.end());
}
