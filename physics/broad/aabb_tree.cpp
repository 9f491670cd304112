// Insertion, removal and upkeep of the tree.
#include "broad/aabb_tree.h"

namespace cairn::physics {

int AabbTree::allocate_node() {
    if (free_head_ == kNone) {
        nodes_.emplace_back();
        return static_cast<int>(nodes_.size()) - 1;
    }
    const int index = free_head_;
    free_head_ = nodes_[index].parent;
    nodes_[index] = Node{};
    return index;
}

void AabbTree::free_node(int index) {
    nodes_[index] = Node{};
    nodes_[index].parent = free_head_;
    free_head_ = index;
}

int AabbTree::insert(const Aabb& box, int item) {
    const int leaf = allocate_node();
    nodes_[leaf].box = box;
    nodes_[leaf].item = item;
    insert_leaf(leaf);
    return leaf;
}

void AabbTree::remove(int proxy) {
    remove_leaf(proxy);
    free_node(proxy);
}

void AabbTree::move(int proxy, const Aabb& box) {
    remove_leaf(proxy);
    nodes_[proxy].box = box;
    insert_leaf(proxy);
}

// Walks down to where a new leaf costs least. At each node the cost of making it the sibling is its enlarged
// perimeter plus what its ancestors grew by; a child is entered while its lower bound beats the best found.
int AabbTree::best_sibling(const Aabb& box) const {
    int index = root_;
    const float own = half_perimeter(box);
    float inherited = 0;  // growth of the ancestors of index
    int best = root_;
    float best_cost = half_perimeter(merged(nodes_[root_].box, box));
    while (!nodes_[index].is_leaf()) {
        const Node& node = nodes_[index];
        inherited += half_perimeter(merged(node.box, box)) - half_perimeter(node.box);
        int next = kNone;
        float next_bound = best_cost;
        for (const int child : node.child) {
            const Aabb& child_box = nodes_[child].box;
            const float direct = half_perimeter(merged(child_box, box));
            const float cost = direct + inherited;
            if (cost < best_cost) {
                best_cost = cost;
                best = child;
            }
            const float bound = inherited + (direct - half_perimeter(child_box)) + own;
            if (!nodes_[child].is_leaf() && bound < next_bound) {
                next_bound = bound;
                next = child;
            }
        }
        if (next == kNone) break;
        index = next;
    }
    return best;
}

void AabbTree::insert_leaf(int leaf) {
    if (root_ == kNone) {
        root_ = leaf;
        nodes_[leaf].parent = kNone;
        return;
    }
    const int sibling = best_sibling(nodes_[leaf].box);
    const int parent = allocate_node();
    const int grandparent = nodes_[sibling].parent;
    nodes_[parent].parent = grandparent;
    nodes_[parent].child = {sibling, leaf};
    nodes_[sibling].parent = parent;
    nodes_[leaf].parent = parent;
    if (grandparent == kNone) {
        root_ = parent;
    } else {
        auto& children = nodes_[grandparent].child;
        (children[0] == sibling ? children[0] : children[1]) = parent;
    }
    refit_upward(parent);
}

void AabbTree::remove_leaf(int leaf) {
    if (leaf == root_) {
        root_ = kNone;
        return;
    }
    const int parent = nodes_[leaf].parent;
    const int grandparent = nodes_[parent].parent;
    const auto& children = nodes_[parent].child;
    const int sibling = children[0] == leaf ? children[1] : children[0];
    nodes_[sibling].parent = grandparent;
    if (grandparent == kNone) {
        root_ = sibling;
    } else {
        auto& slots = nodes_[grandparent].child;
        (slots[0] == parent ? slots[0] : slots[1]) = sibling;
    }
    free_node(parent);
    refit_upward(grandparent);
}

void AabbTree::refit_upward(int index) {
    while (index != kNone) {
        rotate(index);
        Node& node = nodes_[index];
        const Node& a = nodes_[node.child[0]];
        const Node& b = nodes_[node.child[1]];
        node.box = merged(a.box, b.box);
        node.height = 1 + std::max(a.height, b.height);
        index = node.parent;
    }
}

// Swaps a child with a grandchild on the other side when that shrinks the box of the node between them.
void AabbTree::rotate(int index) {
    Node& node = nodes_[index];
    int best_side = kNone;
    int best_slot = 0;
    float best_gain = 0;
    for (int side = 0; side < 2; ++side) {
        const Node& uncle = nodes_[node.child[side]];
        const Node& inner = nodes_[node.child[1 - side]];
        if (inner.is_leaf()) continue;
        for (int slot = 0; slot < 2; ++slot) {
            const Node& stays = nodes_[inner.child[1 - slot]];
            const float gain = half_perimeter(inner.box) - half_perimeter(merged(stays.box, uncle.box));
            if (gain > best_gain) {
                best_gain = gain;
                best_side = side;
                best_slot = slot;
            }
        }
    }
    if (best_side == kNone) return;

    const int uncle = node.child[best_side];
    const int inner = node.child[1 - best_side];
    Node& inner_node = nodes_[inner];
    const int rising = inner_node.child[best_slot];
    node.child[best_side] = rising;
    nodes_[rising].parent = index;
    inner_node.child[best_slot] = uncle;
    nodes_[uncle].parent = inner;
    const Node& a = nodes_[inner_node.child[0]];
    const Node& b = nodes_[inner_node.child[1]];
    inner_node.box = merged(a.box, b.box);
    inner_node.height = 1 + std::max(a.height, b.height);
}

bool AabbTree::is_valid() const {
    std::vector<int> stack;
    if (root_ != kNone) stack.push_back(root_);
    if (root_ != kNone && nodes_[root_].parent != kNone) return false;
    while (!stack.empty()) {
        const int index = stack.back();
        stack.pop_back();
        const Node& node = nodes_[index];
        if (node.is_leaf()) continue;
        for (const int child : node.child) {
            if (nodes_[child].parent != index || !contains(node.box, nodes_[child].box)) return false;
            stack.push_back(child);
        }
    }
    return true;
}

}  // namespace cairn::physics
