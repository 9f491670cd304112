// Vectors of which the size is set anew in each step. `resize` and `assign` may take exactly the room that
// they need, and then again and again as sizes creep up; these take twice as much as before.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cairn::physics {

template <class T>
void reserve_amply(std::vector<T>& values, std::size_t count) {
    if (count > values.capacity()) values.reserve(std::max(count, 2 * values.capacity()));
}

template <class T>
void resize_amply(std::vector<T>& values, std::size_t count) {
    reserve_amply(values, count);
    values.resize(count);
}

template <class T>
void assign_amply(std::vector<T>& values, std::size_t count, const T& value) {
    reserve_amply(values, count);
    values.assign(count, value);
}

}  // namespace cairn::physics
