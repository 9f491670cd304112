// Particles. Invariant: they stand in order of birth, so that older ones are drawn below younger ones.
#include <algorithm>
#include <cassert>
#include <cmath>

#include <cairn/engine/particles.h>

namespace cairn::engine {

ParticleSystem::ParticleSystem(ParticleDef def, std::uint64_t seed) : def_(std::move(def)), random_(seed, 2) {
    assert(def_.max_count >= 1 && def_.lifetime_s.low > 0 && !def_.colors.empty());
}

void ParticleSystem::add(Vec2 position) {
    const float angle = def_.direction_rad + def_.spread_rad * static_cast<float>(random_.uniform(-0.5, 0.5));
    const float speed = draw_from(def_.speed);
    Particle p;
    p.position = position + Vec2{def_.area.x * static_cast<float>(random_.uniform(-0.5, 0.5)),
                                 def_.area.y * static_cast<float>(random_.uniform(-0.5, 0.5))};
    p.previous = p.position;
    p.velocity = Vec2{std::cos(angle), std::sin(angle)} * speed;
    p.age_s = 0;
    p.lifetime_s = draw_from(def_.lifetime_s);
    p.rotation_rad = draw_from(def_.rotation_rad);
    p.spin_rad_s = draw_from(def_.spin_rad_s);
    p.size_start = draw_from(def_.size_start);
    p.size_end = draw_from(def_.size_end);
    particles_.push_back(p);
}

void ParticleSystem::emit(int count, Vec2 position) {
    particles_.reserve(static_cast<std::size_t>(def_.max_count));
    const int room = def_.max_count - this->count();
    for (int i = 0; i < std::min(count, room); ++i) add(position);
}

void ParticleSystem::update(float dt_s) {
    if (!(dt_s > 0)) return;
    step_s_ = dt_s;
    const float kept = 1 / (1 + def_.damping_1_s * dt_s);
    for (Particle& p : particles_) {
        p.age_s += dt_s;
        p.previous = p.position;
        p.velocity = (p.velocity + def_.acceleration * dt_s) * kept;
        p.position = p.position + p.velocity * dt_s;
        p.rotation_rad += p.spin_rad_s * dt_s;
    }
    std::erase_if(particles_, [](const Particle& p) { return p.age_s >= p.lifetime_s; });
    if (!is_started_) return;
    unborn_ += def_.rate_1_s * dt_s;
    const float whole = std::floor(unborn_);
    unborn_ -= whole;
    emit(static_cast<int>(std::min(whole, static_cast<float>(def_.max_count))), position_);
}

ParticleSystem::Sprite ParticleSystem::sprite(int index, float alpha) const {
    const Particle& p = particles_[static_cast<std::size_t>(index)];
    const float back_s = (1 - alpha) * step_s_;
    const float age = std::clamp((p.age_s - back_s) / p.lifetime_s, 0.0f, 1.0f);
    const float place = age * static_cast<float>(def_.colors.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(place), def_.colors.size() - 1);
    const Color& a = def_.colors[before];
    const Color& b = def_.colors[std::min(before + 1, def_.colors.size() - 1)];
    const float share = place - static_cast<float>(before);
    const auto mix = [share](float from, float to) { return from + (to - from) * share; };
    return {p.previous + (p.position - p.previous) * alpha,
            p.rotation_rad - p.spin_rad_s * back_s,
            p.size_start + (p.size_end - p.size_start) * age,
            {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)}};
}

std::size_t ParticleSystem::most_bytes() const {
    constexpr std::size_t kEach = sizeof(Particle) + 4 * sizeof(MeshVertex) + 6 * sizeof(std::uint32_t);
    return kEach * static_cast<std::size_t>(def_.max_count);
}

void ParticleSystem::draw(Renderer& renderer, TextureId texture, const std::optional<Rect>& source,
                          Color tint, float alpha) {
    Rect uv = {0, 0, 1, 1};
    if (source) {
        const Size size = renderer.texture_size(texture);
        const auto width = static_cast<float>(std::max(size.width, 1));
        const auto height = static_cast<float>(std::max(size.height, 1));
        uv = {source->x / width, source->y / height, source->width / width, source->height / height};
    }
    // Where y points up, a square is put on its head, so that its picture stands upright.
    const float up = renderer.is_y_up() ? -1.0f : 1.0f;
    vertices_.clear();
    indices_.clear();
    for (int i = 0; i < count(); ++i) {
        const Sprite s = sprite(i, alpha);
        const Vec2 x = Vec2{std::cos(s.rotation_rad), std::sin(s.rotation_rad)} * (0.5f * s.size);
        const Vec2 y = Vec2{-x.y, x.x} * up;
        const Color color = {s.color.r * tint.r, s.color.g * tint.g, s.color.b * tint.b, s.color.a * tint.a};
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back({s.position - x - y, color, {uv.x, uv.y}});
        vertices_.push_back({s.position + x - y, color, {uv.x + uv.width, uv.y}});
        vertices_.push_back({s.position + x + y, color, {uv.x + uv.width, uv.y + uv.height}});
        vertices_.push_back({s.position - x + y, color, {uv.x, uv.y + uv.height}});
        indices_.insert(indices_.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
    if (!indices_.empty()) renderer.draw_mesh(vertices_, indices_, texture);
}

}  // namespace cairn::engine
