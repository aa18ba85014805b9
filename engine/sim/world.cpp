#include "engine/sim/world.hpp"
namespace fulbito {
struct World::Impl {
  WorldConfig config;
  WorldState state;
};
World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;
Result<World> World::create(const WorldConfig&) { return fail(ErrorCode::kUsage, "not yet"); }
void World::step(std::span<const WheelSpeeds>) {}
const WorldState& World::state() const { return impl_->state; }
std::span<const ContactEvent> World::contacts() const { return {}; }
const WorldConfig& World::config() const { return impl_->config; }
float World::engineProfileMilliseconds() const { return 0; }
int World::touchingPairs() const { return 0; }
}  // namespace fulbito
