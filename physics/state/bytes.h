// Values as bytes: little endian, each with a size of its own, one behind the other without gaps.
// Invariant: what is written follows from the values alone, never from padding, addresses or the machine; so
// equal states have equal bytes. Bodies are copied as they stand in memory only where that has no gaps.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <cairn/physics/state.h>

#include "base/aabb.h"
#include "base/check.h"
#include "state/fields.h"
#include "world/features.h"

namespace cairn::physics {

static_assert(std::endian::native == std::endian::little,
              "snapshots are little endian: another machine must turn their numbers round here");

/// Stored as in memory.
template <class T>
inline constexpr bool kIsPlain = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
template <>
inline constexpr bool kIsPlain<Vec2> = true;
template <>
inline constexpr bool kIsPlain<Rotation> = true;
template <>
inline constexpr bool kIsPlain<Position> = true;
template <>
inline constexpr bool kIsPlain<Aabb> = true;
template <class T, std::size_t N>
inline constexpr bool kIsPlain<std::array<T, N>> = kIsPlain<T>;
static_assert(sizeof(Vec2) == 8 && sizeof(Rotation) == 8 && sizeof(Position) == 16 && sizeof(Aabb) == 16);

/// What a plain type is made of, if that can be no number.
template <class T>
struct ScalarOf {
    using Type = T;
};
template <>
struct ScalarOf<Vec2> {
    using Type = float;
};
template <>
struct ScalarOf<Rotation> {
    using Type = float;
};
template <>
struct ScalarOf<Aabb> {
    using Type = float;
};
template <>
struct ScalarOf<Position> {
    using Type = double;
};
template <class T, std::size_t N>
struct ScalarOf<std::array<T, N>> : ScalarOf<T> {};

/// One past the last value of an enumeration.
template <class E>
inline constexpr int kEnd = 0;
template <>
inline constexpr int kEnd<BodyType> = static_cast<int>(BodyType::Dynamic) + 1;
template <>
inline constexpr int kEnd<ShapeKind> = static_cast<int>(ShapeKind::ChainSegment) + 1;
template <>
inline constexpr int kEnd<FracturePattern> = static_cast<int>(FracturePattern::Radial) + 1;
template <>
inline constexpr int kEnd<Mixing> = static_cast<int>(Mixing::Fixed) + 1;
template <>
inline constexpr int kEnd<JointKind> = static_cast<int>(JointKind::Filter) + 1;
template <>
inline constexpr int kEnd<JointSolver> = static_cast<int>(JointSolver::Direct) + 1;

/// Handles without the world's tag: they are of whichever world reads them.
inline constexpr std::uint64_t kHandleBits = 0xffffffffffffu;

// Sizes.

template <class T>
constexpr std::size_t packed_size();

namespace detail {
template <class T>
struct Packed {
    static constexpr std::size_t size() {
        if constexpr (kIsPlain<T>) {
            return sizeof(T);
        } else if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>) {
            return 1;
        } else {
            std::size_t sum = 0;
            T value{};
            fields(value, [&](const auto&... field) {
                sum = (packed_size<std::remove_cvref_t<decltype(field)>>() + ... + std::size_t{0});
            });
            return sum;
        }
    }
};
template <class Tag>
struct Packed<Handle<Tag>> {
    static constexpr std::size_t size() { return sizeof(std::uint64_t); }
};
template <class T>
struct Packed<std::optional<T>> {
    static constexpr std::size_t size() { return 1 + packed_size<T>(); }
};
template <class... T>
struct Packed<std::variant<T...>> {  // at most
    static constexpr std::size_t size() { return 1 + std::max({packed_size<T>()...}); }
};
}  // namespace detail

/// Of a value, or the most it can take.
template <class T>
constexpr std::size_t packed_size() {
    return detail::Packed<T>::size();
}

// Writing, to room that is known to suffice. The result is where the next value goes.

template <class T>
std::byte* put(std::byte* at, const T& value);

template <class Tag>
std::byte* put(std::byte* at, Handle<Tag> id) {
    return put(at, id.bits() & kHandleBits);
}

template <class T>
std::byte* put(std::byte* at, const std::optional<T>& value) {
    at = put(at, value.has_value());
    return put(at, value.value_or(T{}));
}

template <class... T>
std::byte* put(std::byte* at, const std::variant<T...>& value) {
    at = put(at, static_cast<std::uint8_t>(value.index()));
    return std::visit([at](const auto& held) { return put(at, held); }, value);
}

template <class T>
[[gnu::always_inline]] inline std::byte* put(std::byte* at, const T& value) {
    if constexpr (kIsPlain<T>) {
        std::memcpy(at, &value, sizeof value);
        return at + sizeof value;
    } else if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>) {
        *at = static_cast<std::byte>(value);
        return at + 1;
    } else {
        fields(
            value, [&](const auto&... field)
                       __attribute__((always_inline)) { ((at = put(at, field)), ...); });
        return at;
    }
}

template <class T>
std::byte* put_all(std::byte* at, std::span<const T> values) {
    static_assert(kIsPlain<T>);
    if (!values.empty()) std::memcpy(at, values.data(), values.size_bytes());
    return at + values.size_bytes();
}

/// Bytes that grow; room is asked for in advance, so that loops write without looking.
class Writer {
  public:
    explicit Writer(Snapshot& snapshot) : snapshot_(snapshot) { snapshot_.size_ = 0; }

    [[nodiscard]] std::size_t size() const { return snapshot_.size_; }
    [[nodiscard]] std::byte* data() { return snapshot_.bytes_.get(); }

    /// Where to write at most so many bytes; `end` tells how far it was.
    std::byte* room(std::size_t bytes) {
        if (snapshot_.size_ + bytes > snapshot_.capacity_) grow(snapshot_.size_ + bytes);
        return snapshot_.bytes_.get() + snapshot_.size_;
    }
    void end(const std::byte* at) { snapshot_.size_ = static_cast<std::size_t>(at - snapshot_.bytes_.get()); }

    template <class T>
    void value(const T& value) {
        end(put(room(packed_size<T>()), value));
    }
    void bytes(std::span<const std::byte> bytes) {
        std::byte* const at = room(bytes.size());
        if (!bytes.empty()) std::memcpy(at, bytes.data(), bytes.size());
        end(at + bytes.size());
    }
    void count(std::size_t n) { value(static_cast<std::uint32_t>(n)); }
    /// Their number, then they themselves.
    template <class T>
    void list(const std::vector<T>& values) {
        std::byte* at = room(sizeof(std::uint32_t) + values.size() * packed_size<T>());
        at = put(at, static_cast<std::uint32_t>(values.size()));
        if constexpr (kIsPlain<T>) {
            at = put_all(at, std::span<const T>(values));
        } else {
            for (const T& value : values) at = put(at, value);
        }
        end(at);
    }

  private:
    void grow(std::size_t bytes) {
        const std::size_t capacity = std::max(bytes, 2 * snapshot_.capacity_);
        auto wider = std::make_unique_for_overwrite<std::byte[]>(capacity);
        if (snapshot_.size_ > 0) std::memcpy(wider.get(), snapshot_.bytes_.get(), snapshot_.size_);
        snapshot_.bytes_ = std::move(wider);
        snapshot_.capacity_ = capacity;
    }

    Snapshot& snapshot_;
};

/// Not 0 when something that is written differs, in any bit.
template <class T>
std::uint32_t differing_bits(const T& a, const T& b) {
    if constexpr (kIsPlain<T>) {
        using Word = std::conditional_t<sizeof(T) % sizeof(std::uint32_t) == 0, std::uint32_t, std::uint8_t>;
        const auto words_a = std::bit_cast<std::array<Word, sizeof(T) / sizeof(Word)>>(a);
        const auto words_b = std::bit_cast<std::array<Word, sizeof(T) / sizeof(Word)>>(b);
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < words_a.size(); ++i)
            bits |= static_cast<std::uint32_t>(words_a[i] ^ words_b[i]);
        return bits;
    } else if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>) {
        return a != b ? 1 : 0;
    } else {
        std::uint32_t bits = 0;
        fields(a, [&](const auto&... of_a) {
            fields(b, [&](const auto&... of_b) { bits = (differing_bits(of_a, of_b) | ... | 0u); });
        });
        return bits;
    }
}

// Reading. What the bytes hold may be nonsense: what is found wrong is kept in a flag, so that loops need not
// branch, and told by name where a reader looks at the flag.

/// What reading needs to know, and what it found.
struct Reading {
    std::uint16_t world_tag = 0;
    bool bad = false;
};

/// Whether one of the numbers is no number. A sum with one is none either, so most need not be looked at one
/// by one; nor is the sum of two infinities, so then they are.
template <class Scalar>
bool has_nan(std::span<const Scalar> numbers) {
    constexpr std::size_t kSums = 4;  // that do not wait for each other
    std::array<Scalar, kSums> sums{};
    std::size_t i = 0;
    for (; i + kSums <= numbers.size(); i += kSums) {
        for (std::size_t lane = 0; lane < kSums; ++lane) sums[lane] += numbers[i + lane];
    }
    for (; i < numbers.size(); ++i) sums[0] += numbers[i];
    const Scalar sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    if (sum == sum) return false;
    return std::any_of(numbers.begin(), numbers.end(), [](Scalar x) { return !(x == x); });
}

template <class T>
const std::byte* get(const std::byte* at, T& value, Reading& reading);

template <class Tag>
const std::byte* get(const std::byte* at, Handle<Tag>& id, Reading& reading) {
    std::uint64_t bits = 0;
    at = get(at, bits, reading);
    reading.bad |= bits > kHandleBits;
    id = Handle<Tag>::make(bits, bits >> 24, (bits & 0xffffff) != 0 ? reading.world_tag : 0);
    return at;
}

template <class T>
const std::byte* get(const std::byte* at, std::optional<T>& value, Reading& reading) {
    bool has_value = false;
    T held{};
    at = get(get(at, has_value, reading), held, reading);
    if (has_value) {
        value = held;
    } else {
        value.reset();
    }
    return at;
}

template <class T>
[[gnu::always_inline]] inline const std::byte* get(const std::byte* at, T& value, Reading& reading) {
    if constexpr (kIsPlain<T>) {
        std::memcpy(&value, at, sizeof value);
        using Scalar = typename ScalarOf<T>::Type;
        if constexpr (std::is_floating_point_v<Scalar>) {
            std::array<Scalar, sizeof(T) / sizeof(Scalar)> numbers;
            std::memcpy(numbers.data(), at, sizeof numbers);
            if constexpr (numbers.size() > 4) {
                reading.bad |= has_nan(std::span<const Scalar>(numbers));
            } else {
                for (const Scalar x : numbers) reading.bad |= !(x == x);
            }
        }
        return at + sizeof value;
    } else if constexpr (std::is_same_v<T, bool>) {
        const auto byte = std::to_integer<int>(*at);
        reading.bad |= byte > 1;
        value = byte != 0;
        return at + 1;
    } else if constexpr (std::is_enum_v<T>) {
        static_assert(kEnd<T> > 0, "the last value of the enumeration is not known here");
        const auto byte = std::to_integer<int>(*at);
        reading.bad |= byte >= kEnd<T>;
        value = static_cast<T>(byte < kEnd<T> ? byte : 0);
        return at + 1;
    } else {
        fields(
            value, [&](auto&... field)
                       __attribute__((always_inline)) { ((at = get(at, field, reading)), ...); });
        return at;
    }
}

/// Without looking for NaN: for what the caller looks at itself.
template <class T>
const std::byte* get_unchecked(const std::byte* at, T& value) {
    static_assert(kIsPlain<T>);
    std::memcpy(&value, at, sizeof value);
    return at + sizeof value;
}

/// Walks over bytes that may be damaged. After a fault nothing is read any more, and counts are 0.
class Reader {
  public:
    /// `name` is what the bytes are, for errors.
    Reader(std::span<const std::byte> bytes, std::size_t at, std::uint16_t world_tag, const char* name)
        : bytes_(bytes), at_(at), name_(name) {
        reading.world_tag = world_tag;
    }

    Reading reading;

    [[nodiscard]] bool ok() const { return !fault_; }
    [[nodiscard]] const check::Fault& fault() const { return fault_; }
    [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

    /// What is read from here on, for errors: "bodies".
    void begin(const char* section) { section_ = section; }
    /// The first fault is kept.
    [[gnu::cold, gnu::noinline]] void fail(const std::string& what) {
        if (fault_) return;
        fault_ = Error{"the " + std::string(name_) + " is damaged: " + section_ + ", before byte " +
                       std::to_string(at_) + ": " + what};
        at_ = bytes_.size();
    }
    /// The rule holds, or the reader fails.
    bool require(bool holds, const char* what) {
        if (!holds) fail(what);
        return ok();
    }
    void require_built_in(Feature feature, bool used) {
        if (check::Fault fault = physics::require_built_in(feature, used); fault && ok())
            fault_ = std::move(fault);
    }
    /// Tells what values that were read since the last call were wrong in themselves.
    bool settle() {
        return require(!reading.bad, "a number is NaN, or a choice is none of those that there are");
    }

    /// So many bytes, or null.
    const std::byte* take(std::size_t bytes) {
        if (!ok()) return nullptr;
        if (bytes > bytes_.size() - at_) return fail_short(bytes);
        const std::byte* from = bytes_.data() + at_;
        at_ += bytes;
        return from;
    }
    /// The rest, of which `end` tells how much was used.
    [[nodiscard]] std::span<const std::byte> rest() const { return bytes_.subspan(at_); }
    void end(const std::byte* at) { at_ = static_cast<std::size_t>(at - bytes_.data()); }

    template <class T>
    void value(T& value) {
        if (const std::byte* from = take(packed_size<T>())) get(from, value, reading);
    }
    /// A number of things of which each takes at least so many bytes; 0 after a fault.
    std::size_t count(std::size_t bytes_each) {
        std::uint32_t n = 0;
        value(n);
        if (ok() && n * std::uint64_t{bytes_each} > bytes_.size() - at_) {
            fail("it says that " + std::to_string(n) + " things follow, but has no room for them");
        }
        return ok() ? n : 0;
    }
    /// As many as there is room for already.
    template <class T>
    void all(std::span<T> values) {
        static_assert(kIsPlain<T>);
        const std::byte* from = take(values.size_bytes());
        if (from == nullptr || values.empty()) return;
        std::memcpy(values.data(), from, values.size_bytes());
        using Scalar = typename ScalarOf<T>::Type;
        if constexpr (std::is_floating_point_v<Scalar>) {
            reading.bad |= has_nan(std::span<const Scalar>(reinterpret_cast<const Scalar*>(values.data()),
                                                           values.size_bytes() / sizeof(Scalar)));
        }
    }
    template <class T>
    void list(std::vector<T>& values) {
        values.resize(count(packed_size<T>()));
        if constexpr (kIsPlain<T>) {
            all(std::span<T>(values));
        } else {
            const std::byte* from = take(values.size() * packed_size<T>());
            if (from == nullptr) return;
            for (T& value : values) from = get(from, value, reading);
        }
    }

  private:
    [[gnu::cold, gnu::noinline]] const std::byte* fail_short(std::size_t bytes) {
        fail("it ends in the middle, " + std::to_string(bytes - (bytes_.size() - at_)) + " bytes short");
        return nullptr;
    }

    std::span<const std::byte> bytes_;
    std::size_t at_;
    const char* name_;
    const char* section_ = "";
    check::Fault fault_;
};

}  // namespace cairn::physics
