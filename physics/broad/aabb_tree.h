// A bounding-volume hierarchy over boxes that come, go and move.
// Invariant: a binary tree; each inner node's box encloses its two children. Proxies are leaves and keep
// their index. Source: insertion by the surface-area heuristic, Goldsmith and Salmon 1987; rotations as in
// Kensler 2008.
#pragma once

#include <array>
#include <vector>

#include "base/aabb.h"
#include "base/assert.h"
#include "base/slot_map.h"

namespace cairn::physics {

class AabbTree {
  public:
    /// A leaf for `item`; the result is the proxy.
    int insert(const Aabb& box, int item);
    void remove(int proxy);
    void move(int proxy, const Aabb& box);

    [[nodiscard]] const Aabb& box(int proxy) const { return nodes_[proxy].box; }
    [[nodiscard]] int item(int proxy) const { return nodes_[proxy].item; }

    /// Calls visit(item) for each leaf whose box overlaps.
    template <class Visit>
    void query(const Aabb& box, Visit&& visit) const {
        Stack stack;
        if (root_ != kNone) stack.push(root_);
        while (!stack.empty()) {
            const Node& node = nodes_[stack.pop()];
            if (!overlap(node.box, box)) continue;
            if (node.is_leaf()) {
                visit(node.item);
            } else {
                stack.push(node.child[0]);
                stack.push(node.child[1]);
            }
        }
    }

    /// Calls visit(item) for each leaf that the segment meets; it returns the fraction up to which the rest
    /// of the segment is still of interest.
    template <class Visit>
    void cast_ray(Position origin, Vec2 translation, Visit&& visit) const {
        float fraction = 1;
        Stack stack;
        if (root_ != kNone) stack.push(root_);
        while (!stack.empty()) {
            const Node& node = nodes_[stack.pop()];
            if (!ray_overlaps(node.box, origin, translation, fraction)) continue;
            if (node.is_leaf()) {
                fraction = visit(node.item);
            } else {
                stack.push(node.child[0]);
                stack.push(node.child[1]);
            }
        }
    }

    [[nodiscard]] int height() const { return root_ == kNone ? 0 : nodes_[root_].height; }
    /// Checks the invariant of every node; for tests.
    [[nodiscard]] bool is_valid() const;

  private:
    struct Node {
        Aabb box;
        int parent = kNone;  // or the next free node
        std::array<int, 2> child{kNone, kNone};
        int height = 0;  // leaves 0
        int item = kNone;
        [[nodiscard]] bool is_leaf() const { return child[0] == kNone; }
    };

    // Walks hold at most one sibling per level and the rotations keep the tree shallow, so the fixed part
    // always serves in practice; a degenerate tree overflows into the vector instead of failing.
    class Stack {
      public:
        void push(int node) {
            if (size_ < kFixed) {
                fixed_[size_] = node;
            } else {
                overflow_.push_back(node);
            }
            ++size_;
        }
        int pop() {
            --size_;
            if (size_ < kFixed) return fixed_[size_];
            const int node = overflow_.back();
            overflow_.pop_back();
            return node;
        }
        [[nodiscard]] bool empty() const { return size_ == 0; }

      private:
        static constexpr int kFixed = 256;
        std::array<int, kFixed> fixed_;
        std::vector<int> overflow_;
        int size_ = 0;
    };

    int allocate_node();
    void free_node(int index);
    void insert_leaf(int leaf);
    void remove_leaf(int leaf);
    [[nodiscard]] int best_sibling(const Aabb& box) const;
    void refit_upward(int index);
    void rotate(int index);

    std::vector<Node> nodes_;
    int root_ = kNone;
    int free_head_ = kNone;
};

}  // namespace cairn::physics
