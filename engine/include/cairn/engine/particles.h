// Sparks, smoke, rain: many small pictures that are born, fly, change and go.
// Invariant: what happens depends on the definition, the seed and the calls only; no more than max_count
// particles live, and after the first of them nothing is allocated.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <cairn/engine/geometry.h>
#include <cairn/engine/handle.h>
#include <cairn/engine/random.h>
#include <cairn/engine/renderer.h>

namespace cairn::engine {

/// From low to high, both equally likely.
struct Range {
    float low = 0;
    float high = 0;
};

/// Lengths are in whatever units it is drawn in: pixels, or metres under a camera.
struct ParticleDef {
    int max_count = 1000;
    float rate_1_s = 0;              ///< born per second while it is started
    Range lifetime_s = {1, 1};       ///< above 0
    Vec2 area = {};                  ///< born in a rectangle of this size around the emitter
    Range speed = {0, 0};            ///< per second
    float direction_rad = 0;         ///< from x towards y
    float spread_rad = 6.28318531f;  ///< whole angle around the direction
    Vec2 acceleration = {};          ///< per second squared
    float damping_1_s = 0;           ///< c in v e^(-c t), to first order
    Range size_start = {8, 8};
    Range size_end = {8, 8};
    Range rotation_rad = {0, 0};  ///< at birth
    Range spin_rad_s = {0, 0};
    std::vector<Color> colors = {Color{}};  ///< over the lifetime, evenly; at least one
};

class ParticleSystem {
  public:
    ParticleSystem(ParticleDef def, std::uint64_t seed);

    const ParticleDef& def() const { return def_; }
    Vec2 position() const { return position_; }
    void set_position(Vec2 position) { position_ = position; }
    /// Of those that are born from now on.
    void set_direction(float direction_rad) { def_.direction_rad = direction_rad; }
    void set_rate(float rate_1_s) { def_.rate_1_s = rate_1_s; }
    /// Whether `rate_1_s` particles are born per second; begins stopped.
    void set_started(bool started) { is_started_ = started; }
    bool is_started() const { return is_started_; }
    /// That many at once, as far as max_count allows.
    void emit(int count, Vec2 position);
    void update(float dt_s);
    void clear() { particles_.clear(); }

    int count() const { return static_cast<int>(particles_.size()); }
    /// What it takes in memory with max_count particles, once they were drawn.
    std::size_t most_bytes() const;

    /// What a picture shows of each particle, in order of birth. `alpha` lies between the last two updates.
    struct Sprite {
        Vec2 position;
        float rotation_rad;
        float size;
        Color color;
    };
    Sprite sprite(int index, float alpha) const;

    /// All with one draw call, each a square of the texture's part; a null texture draws plain squares.
    void draw(Renderer& renderer, TextureId texture, const std::optional<Rect>& source, Color tint,
              float alpha);

  private:
    struct Particle {
        Vec2 position;
        Vec2 previous;
        Vec2 velocity;
        float age_s;
        float lifetime_s;
        float rotation_rad;
        float spin_rad_s;
        float size_start;
        float size_end;
    };

    float draw_from(const Range& range) { return static_cast<float>(random_.uniform(range.low, range.high)); }
    void add(Vec2 position);

    ParticleDef def_;
    Random random_;
    Vec2 position_;
    bool is_started_ = false;
    float unborn_ = 0;  ///< parts of a particle that the rate owes
    float step_s_ = 0;
    std::vector<Particle> particles_;
    std::vector<MeshVertex> vertices_;
    std::vector<std::uint32_t> indices_;
};

}  // namespace cairn::engine
