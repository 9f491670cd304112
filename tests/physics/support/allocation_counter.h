// Counts what the calling thread allocates while a counter lives.
#pragma once

namespace cairn::physics::test {

class AllocationCounter {
  public:
    AllocationCounter();
    ~AllocationCounter();
    AllocationCounter(const AllocationCounter&) = delete;
    AllocationCounter& operator=(const AllocationCounter&) = delete;
    /// Calls of operator new so far.
    [[nodiscard]] long count() const;
};

}  // namespace cairn::physics::test
