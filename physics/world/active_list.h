// A dense list of some records.
// Invariant: a record in the list knows its place there, in the member kPlace; every other record's place is
// kNone.
#pragma once

#include <vector>

#include "base/slot_map.h"

namespace cairn::physics {

template <auto kPlace>
class ActiveList {
  public:
    /// Does nothing when the record is in the list already.
    template <class Records>
    void add(Records& records, int record) {
        if (records[record].*kPlace != kNone) return;
        records[record].*kPlace = static_cast<int>(list_.size());
        list_.push_back(record);
    }

    /// Does nothing when the record is not in the list. The last one takes its place.
    template <class Records>
    void remove(Records& records, int record) {
        const int hole = records[record].*kPlace;
        if (hole == kNone) return;
        records[record].*kPlace = kNone;
        const int last = list_.back();
        list_.pop_back();
        if (last == record) return;
        list_[hole] = last;
        records[last].*kPlace = hole;
    }

    [[nodiscard]] int size() const { return static_cast<int>(list_.size()); }
    int operator[](int i) const { return list_[i]; }
    [[nodiscard]] auto begin() const { return list_.begin(); }
    [[nodiscard]] auto end() const { return list_.end(); }

  private:
    friend struct StateAccess;

    std::vector<int> list_;
};

}  // namespace cairn::physics
