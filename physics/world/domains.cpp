// Cuts by rank, and who moves where.
#include "world/domains.h"

#include <algorithm>
#include <span>

#include "base/ample.h"

namespace cairn::physics {
namespace {

// For n domains there must be so many times n^2 contacts. Each has last blocks of its own in every colour,
// which are half empty; and of a heap n domains cut n - 1 columns, which are as long as the root of all.
constexpr std::size_t kFewestContacts = 512;

// Of the contacts in lanes at most one in so many may be of the interface if bodies are divided by their
// slots.
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
    const Domains& domains = stores.contacts.domains;
    const double x = coordinate(stores, domains.by, body);
    int domain = 1;
    while (domain < domains.count && x > domains.cuts[static_cast<std::size_t>(domain - 1)]) ++domain;
    return domain;
}

int count_for(std::size_t contacts) {
    int count = 1;
    const auto is_worth = [&](int domains) {
        return contacts >= kFewestContacts * static_cast<std::size_t>(domains * domains);
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

bool is_touched(const ContactStore& contacts, int body) {
    const auto i = static_cast<std::size_t>(body);
    return i < contacts.colors.size() && contacts.colors[i] != 0;
}

double extent_of(const Stores& stores, std::span<const int> bodies, DividedBy by) {
    if (bodies.empty()) return 0;
    const auto x = [&](int body) { return coordinate(stores, by, body); };
    const auto [least, most] = std::ranges::minmax_element(bodies, {}, x);
    return x(*most) - x(*least);
}

// So that as many of the bodies are in each domain, and each is in the one that it is in now.
void cut(Stores& stores, std::span<int> bodies, DividedBy by) {
    Domains& domains = stores.contacts.domains;
    domains.by = by;
    const auto at = [&](int body) { return coordinate(stores, by, body); };
    const auto count = static_cast<std::size_t>(domains.count);
    for (std::size_t i = 1; i < count; ++i) {
        const auto nth = bodies.begin() + static_cast<std::ptrdiff_t>(bodies.size() * i / count);
        std::ranges::nth_element(bodies, nth, {}, at);
        domains.cuts[i - 1] = at(*nth);
    }
    for (const int body : bodies)
        domains.of_body[static_cast<std::size_t>(body)] = static_cast<std::uint8_t>(domain_now(stores, body));
}

std::size_t count_between(const ContactStore& contacts) {
    std::size_t between = 0;
    for_each_contact(contacts.lanes, [&](int contact, int bucket) {
        if (domain_of(contacts, contacts.slots[contact], kind_of(bucket)) == kInterface) ++between;
    });
    return between;
}

// By slots where these tell who touches whom, as where bodies lie as they were made. All that goes by slots
// or rows then goes by domain. What has been stirred is divided across its longer side.
void choose_cuts(Stores& stores, std::size_t contacts, std::vector<int>& bodies) {
    bodies.clear();
    reserve_amply(bodies, static_cast<std::size_t>(stores.bodies.rows(RowSet::Awake).size()));
    for (const int body : stores.bodies.rows(RowSet::Awake).body) {
        if (is_touched(stores.contacts, body)) bodies.push_back(body);
    }
    cut(stores, bodies, DividedBy::Slots);
    if (kInterfaceShare * count_between(stores.contacts) <= contacts) return;
    const bool is_wide = extent_of(stores, bodies, DividedBy::X) >= extent_of(stores, bodies, DividedBy::Y);
    cut(stores, bodies, is_wide ? DividedBy::X : DividedBy::Y);
}

void move_contacts(ContactStore& contacts, std::vector<int>& moving) {
    moving.clear();
    reserve_amply(moving, contacts_in(contacts.lanes));
    for_each_contact(contacts.lanes, [&](int contact, int bucket) {
        if (domain_of(contacts, contacts.slots[contact], kind_of(bucket)) != domain_of(bucket))
            moving.push_back(contact);
    });
    visit_contacts(contacts, moving, [&](int contact) {
        ContactRecord& c = contacts.slots[contact];
        const BlockKind kind = kind_of(c.bucket);
        const int bucket =
            colored_bucket(color_of(c.bucket), kind, geometry_of(c.bucket), domain_of(contacts, c, kind));
        const auto [lane, filler] = contacts.lanes.move(c.bucket, c.lane, bucket);
        if (filler != kNone) contacts.slots[filler].lane = c.lane;
        c.bucket = bucket;
        c.lane = lane;
    });
}

// Rows of a domain stand in the order of their bodies' slots, so that what goes by rows meets slots in order.
void order_rows(Stores& stores, DomainScratch& scratch) {
    const ContactStore& contacts = stores.contacts;
    const std::vector<int>& bodies = stores.bodies.rows(RowSet::Awake).body;
    const auto domain = [&](int body) {
        return is_touched(contacts, body)
                   ? static_cast<int>(contacts.domains.of_body[static_cast<std::size_t>(body)])
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
    for (int d = 2; d <= contacts.domains.count; ++d) {
        const auto first = std::ranges::lower_bound(order, d, {}, domain);
        scratch.first_row.push_back(static_cast<int>(first - order.begin()) + 1);
    }
    if (in_order) return;
    for (int& item : order) item = stores.bodies.slots[item].row;
    stores.bodies.order_awake_rows(order);
}

}  // namespace

void settle_in_domain(const Stores& stores, ContactStore& contacts, int body) {
    Domains& domains = contacts.domains;
    const auto i = static_cast<std::size_t>(body);
    if (domains.count == 0 || contacts.colors[i] != 0) return;
    cover_amply(domains.of_body, contacts.colors.size());
    domains.of_body[i] = static_cast<std::uint8_t>(domain_now(stores, body));
}

int domain_of(const ContactStore& contacts, const ContactRecord& contact, BlockKind kind) {
    if (contacts.domains.count == 0) return kInterface;
    const std::vector<std::uint8_t>& of_body = contacts.domains.of_body;
    const int domain = of_body[static_cast<std::size_t>(contact.body_b)];
    const bool is_between =
        kind == BlockKind::TwoBodies && of_body[static_cast<std::size_t>(contact.body_a)] != domain;
    return is_between ? kInterface : domain;
}

void divide_into_domains(Stores& stores, DomainScratch& scratch) {
    ContactStore& contacts = stores.contacts;
    contacts.lanes.arrange();
    const std::size_t all = contacts_in(contacts.lanes);
    const int before = contacts.domains.count;
    contacts.domains.count = count_for(all);
    scratch.first_row.clear();
    if (contacts.domains.count == 0 && before == 0) return;
    cover_amply(contacts.domains.of_body, contacts.colors.size());
    if (contacts.domains.count > 0) {
        choose_cuts(stores, all, scratch.items);
        order_rows(stores, scratch);
    }
    move_contacts(contacts, scratch.items);
    contacts.lanes.arrange();
}

}  // namespace cairn::physics
