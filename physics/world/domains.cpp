// Cuts by rank, and who moves where.
#include "world/domains.h"

#include <algorithm>
#include <span>

#include "base/ample.h"
#include "world/contact_lists.h"
#include "world/contact_order.h"
#include "world/joint_lists.h"

namespace cairn::physics {
namespace {

// Steps from one division to the next: contacts of a heap that is stirred nearly all go to other lanes.
constexpr std::uint64_t kDivideInterval = 2 * kOrderInterval;

// For n domains there must be so many times n^2 contacts and joints. Each has last blocks of its own in every
// colour, which are half empty; and of a heap n domains cut n - 1 columns, which are as long as the root of
// all.
constexpr std::size_t kFewest = 512;

// Of the contacts and joints in lanes at most one in so many may be of the interface if bodies are divided by
// their slots.
constexpr std::size_t kInterfaceShare = 8;

double coordinate(const Stores& stores, DividedBy by, int body) {
    const Position p = stores.bodies.places[static_cast<std::size_t>(body)].center;
    switch (by) {
        case DividedBy::Slots:
            return body;
        case DividedBy::X:
            return p.x;
        case DividedBy::Y:
            return p.y;
    }
    return 0;
}

int domain_now(const Stores& stores, int body) {
    const Domains& domains = stores.domains;
    const double x = coordinate(stores, domains.by, body);
    int domain = 1;
    while (domain < domains.count && x > domains.cuts[static_cast<std::size_t>(domain - 1)]) ++domain;
    return domain;
}

int count_for(std::size_t constraints) {
    int count = 1;
    const auto is_worth = [&](int domains) {
        return constraints >= kFewest * static_cast<std::size_t>(domains * domains);
    };
    while (2 * count <= kMostDomains && is_worth(2 * count)) count *= 2;
    return count > 1 ? count : 0;
}

template <class Visit>
void for_each_contact(const ContactLanes& lanes, const Visit& visit) {
    for (const int block : lanes.blocks()) {
        const PairBlock& pairs = lanes.pairs(block);
        for (int lane = 0; lane < lanes.link(block).used; ++lane)
            visit(pairs.contact[static_cast<std::size_t>(lane)], lanes.link(block).bucket);
    }
}

std::size_t contacts_in(const ContactLanes& lanes) {
    std::size_t contacts = 0;
    for (const int block : lanes.blocks()) contacts += static_cast<std::size_t>(lanes.link(block).used);
    return contacts;
}

std::size_t joints_in(const JointStore& joints) {
    return static_cast<std::size_t>(joints.active.size() - joints.swept.size());
}

int home_of(const Stores& stores, const ContactRecord& contact, int bucket) {
    return domain_of(stores.domains, contact.body_a, contact.body_b, kind_of(bucket) == BlockKind::TwoBodies);
}

int home_of(const Stores& stores, int bucket, const AnchorBlock& joints, std::size_t lane) {
    return domain_of(stores.domains, joints.body_a[lane], joints.body_b[lane],
                     joint_block_kind(bucket) == JointBlockKind::TwoBodies);
}

double extent_of(const Stores& stores, std::span<const int> bodies, DividedBy by) {
    if (bodies.empty()) return 0;
    const auto x = [&](int body) { return coordinate(stores, by, body); };
    const auto [least, most] = std::ranges::minmax_element(bodies, {}, x);
    return x(*most) - x(*least);
}

// So that as many of the bodies are in each domain, and each is in the one that it is in now.
void cut(Stores& stores, std::span<int> bodies, DividedBy by) {
    Domains& domains = stores.domains;
    domains.by = by;
    const auto at = [&](int body) { return coordinate(stores, by, body); };
    const auto count = static_cast<std::size_t>(domains.count);
    const bool in_order = std::ranges::is_sorted(bodies, {}, at);
    auto first = bodies.begin();
    for (std::size_t i = 1; i < count; ++i) {
        const auto nth = bodies.begin() + static_cast<std::ptrdiff_t>(bodies.size() * i / count);
        if (!in_order) std::ranges::nth_element(first, nth, bodies.end(), {}, at);
        domains.cuts[i - 1] = at(*nth);
        first = nth;
    }
    for (const int body : bodies)
        domains.of_body[static_cast<std::size_t>(body)] = static_cast<std::uint8_t>(domain_now(stores, body));
}

std::size_t count_between(const Stores& stores) {
    std::size_t between = 0;
    for_each_contact(stores.contacts.lanes, [&](int contact, int bucket) {
        if (home_of(stores, stores.contacts.slots[contact], bucket) == kInterface) ++between;
    });
    stores.joints.lanes.for_each_joint([&](int bucket, const AnchorBlock& joints, std::size_t lane) {
        if (home_of(stores, bucket, joints, lane) == kInterface) ++between;
    });
    return between;
}

// By slots where these tell who touches whom, as where bodies lie as they were made. All that goes by slots
// or rows then goes by domain. What has been stirred is divided across its longer side.
void choose_cuts(Stores& stores, std::size_t constraints, std::vector<int>& bodies) {
    bodies.clear();
    reserve_amply(bodies, static_cast<std::size_t>(stores.bodies.rows(RowSet::Awake).size()));
    for (const int body : stores.bodies.rows(RowSet::Awake).body) {
        if (is_settled(stores, body)) bodies.push_back(body);
    }
    cut(stores, bodies, DividedBy::Slots);
    if (kInterfaceShare * count_between(stores) <= constraints) return;
    const bool is_wide = extent_of(stores, bodies, DividedBy::X) >= extent_of(stores, bodies, DividedBy::Y);
    cut(stores, bodies, is_wide ? DividedBy::X : DividedBy::Y);
}

void move_contacts(Stores& stores, std::vector<int>& moving) {
    ContactStore& contacts = stores.contacts;
    moving.clear();
    reserve_amply(moving, contacts_in(contacts.lanes));
    for_each_contact(contacts.lanes, [&](int contact, int bucket) {
        if (home_of(stores, contacts.slots[contact], bucket) != domain_of(bucket)) moving.push_back(contact);
    });
    const auto ask = [&](int contact) { ask_for_place(contacts, contact); };
    visit_contacts(contacts, moving, ask, [&](int contact) {
        ContactRecord& c = contacts.slots[contact];
        const int bucket = colored_bucket(color_of(c.bucket), kind_of(c.bucket), geometry_of(c.bucket),
                                          home_of(stores, c, c.bucket));
        const auto [lane, filler] = contacts.lanes.move(c.bucket, c.lane, bucket);
        if (filler != kNone) contacts.slots[filler].lane = c.lane;
        c.bucket = bucket;
        c.lane = lane;
    });
}

void move_joints(Stores& stores, std::vector<int>& moving) {
    moving.clear();
    reserve_amply(moving, joints_in(stores.joints));
    stores.joints.lanes.for_each_joint([&](int bucket, const AnchorBlock& joints, std::size_t lane) {
        if (home_of(stores, bucket, joints, lane) != joint_domain(bucket))
            moving.push_back(joints.joint[lane]);
    });
    for (const int joint : moving) {
        const JointRecord& record = stores.joints.slots[joint];
        const bool both = joint_block_kind(record.seat.bucket) == JointBlockKind::TwoBodies;
        move_to_domain(stores.joints, joint, domain_of(stores.domains, record.body_a, record.body_b, both));
    }
}

// Rows of a domain stand in the order of their bodies' slots, so that what goes by rows meets slots in order.
void order_rows(Stores& stores, DomainScratch& scratch) {
    const std::vector<int>& bodies = stores.bodies.rows(RowSet::Awake).body;
    const auto domain = [&](int body) {
        return is_settled(stores, body)
                   ? static_cast<int>(stores.domains.of_body[static_cast<std::size_t>(body)])
                   : domain_now(stores, body);
    };
    const auto is_before = [&](int a, int b) {
        const int domain_a = domain(a);
        const int domain_b = domain(b);
        return domain_a != domain_b ? domain_a < domain_b : a < b;
    };
    std::vector<int>& order = scratch.items;
    resize_amply(order, bodies.size());
    std::ranges::copy(bodies, order.begin());
    const bool in_order = std::ranges::is_sorted(order, is_before);
    if (!in_order) std::ranges::sort(order, is_before);
    // Motions have the row of the world before all others.
    scratch.first_row.assign(1, 0);
    for (int d = 2; d <= stores.domains.count; ++d) {
        const auto first = std::ranges::lower_bound(order, d, {}, domain);
        scratch.first_row.push_back(static_cast<int>(first - order.begin()) + 1);
    }
    if (in_order) return;
    for (int& item : order) item = stores.bodies.slots[item].row;
    stores.bodies.order_awake_rows(order);
}

}  // namespace

bool is_settled(const Stores& stores, int body) {
    const auto i = static_cast<std::size_t>(body);
    const auto has_color = [i](const std::vector<std::uint32_t>& colors) {
        return i < colors.size() && colors[i] != 0;
    };
    return has_color(stores.contacts.colors) || has_color(stores.joints.colors);
}

void settle_in_domain(Stores& stores, int body) {
    Domains& domains = stores.domains;
    if (domains.count == 0 || is_settled(stores, body)) return;
    cover_amply(domains.of_body, static_cast<std::size_t>(stores.bodies.slots.end_index()));
    domains.of_body[static_cast<std::size_t>(body)] = static_cast<std::uint8_t>(domain_now(stores, body));
}

int domain_of(const Domains& domains, int body_a, int body_b, bool both) {
    if (domains.count == 0) return kInterface;
    const int domain = domains.of_body[static_cast<std::size_t>(body_b)];
    const bool is_between = both && domains.of_body[static_cast<std::size_t>(body_a)] != domain;
    return is_between ? kInterface : domain;
}

void divide_into_domains(Stores& stores, std::uint64_t step_count, StepScratch& scratch) {
    if (step_count % kDivideInterval != 0) return;
    Domains& domains = stores.domains;
    ContactLanes& lanes = stores.contacts.lanes;
    lanes.arrange();
    stores.joints.lanes.arrange();
    const std::size_t all = contacts_in(lanes) + joints_in(stores.joints);
    const int before = domains.count;
    domains.count = count_for(all);
    if (domains.count == 0 && before == 0) return;
    if (!scratch.domains) scratch.domains = std::make_unique<DomainScratch>();
    DomainScratch& working = *scratch.domains;
    working.first_row.clear();
    cover_amply(domains.of_body, static_cast<std::size_t>(stores.bodies.slots.end_index()));
    if (domains.count > 0) {
        choose_cuts(stores, all, working.items);
        order_rows(stores, working);
    }
    move_contacts(stores, working.items);
    move_joints(stores, working.items);
    lanes.arrange();
    stores.joints.lanes.arrange();
    // They may have been listed before there were domains, with rows in the same order.
    if (scratch.batches) scratch.batches->forget();
}

}  // namespace cairn::physics
