// Whether a query is asking a filter of the host just now: what that changed would be lost under the query's
// feet.
#pragma once

#include <atomic>

namespace cairn::physics {

/// Counts calls of filters, on any threads. A copy has its own, and none to begin with.
class FilterCalls {
  public:
    FilterCalls() = default;
    FilterCalls(const FilterCalls&) noexcept {}
    FilterCalls& operator=(const FilterCalls&) noexcept { return *this; }
    ~FilterCalls() = default;

    [[nodiscard]] bool any() const { return count_.load(std::memory_order_relaxed) > 0; }

    class Call {
      public:
        explicit Call(const FilterCalls& calls) : count_(calls.count_) {
            count_.fetch_add(1, std::memory_order_relaxed);
        }
        ~Call() { count_.fetch_sub(1, std::memory_order_relaxed); }
        Call(const Call&) = delete;
        Call& operator=(const Call&) = delete;

      private:
        std::atomic<int>& count_;
    };

  private:
    mutable std::atomic<int> count_{0};
};

}  // namespace cairn::physics
