// Vectors that grow with the world. `resize`, `assign` and `push_back` take exactly the room that they need,
// and then again and again as sizes creep up, or twice as much as before, of which half may stay empty for
// good. These take twice as much while there are few, and a quarter more from then on: at most a fifth stays
// empty, and each item is moved four times on the average.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace cairn::physics {

/// The room to take where `capacity` is not enough for `count`.
constexpr std::size_t ample_capacity(std::size_t capacity, std::size_t count) {
    constexpr std::size_t kFew = 256;
    return std::max(count, capacity + std::max(capacity / 4, std::min(capacity, kFew)));
}

/// Rare, so it stands apart from what asks for it.
template <class T>
[[gnu::noinline]] void grow_amply(std::vector<T>& values, std::size_t count) {
    values.reserve(ample_capacity(values.capacity(), count));
}

template <class T>
void reserve_amply(std::vector<T>& values, std::size_t count) {
    if (count > values.capacity()) grow_amply(values, count);
}

template <class T>
void resize_amply(std::vector<T>& values, std::size_t count) {
    reserve_amply(values, count);
    values.resize(count);
}

/// At least so many; those that are new are like `value`.
template <class T>
void cover_amply(std::vector<T>& values, std::size_t count, const T& value = {}) {
    if (count <= values.size()) return;
    reserve_amply(values, count);
    values.resize(count, value);
}

template <class T>
void assign_amply(std::vector<T>& values, std::size_t count, const T& value) {
    reserve_amply(values, count);
    values.assign(count, value);
}

template <class T>
[[gnu::always_inline]] inline void push_amply(std::vector<T>& values, T value) {
    reserve_amply(values, values.size() + 1);
    values.push_back(std::move(value));
}

}  // namespace cairn::physics
