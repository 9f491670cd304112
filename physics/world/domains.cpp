// Cuts by rank, and who moves where.
#include "world/domains.h"

#include <algorithm>

#include "base/ample.h"

namespace cairn::physics {
namespace {

// For n domains there must be so many times n^2 contacts. Each has last blocks of its own in every colour,
// which are half empty; and of a heap n domains cut n - 1 columns, which are as long as the root of all.
constexpr std::size_t kFewestContacts = 512;

// Of the contacts in lanes at most one in so many may be of the interface if bodies are divided by their
// slots.
constexpr std::size_t kInterfaceShare = 8;

double coordinate(const Stores& stores, int body) {
    const Position p = stores.bodies.places[static_cast<std::size_t>(body)].center;
    switch (stores.contacts.domains.along) {
        case Along::Slots:
            return body;
        case Along::X:
            return p.x;
        case Along::Y:
            return p.y;
    }
    return 0;
}

int domain_now(const Stores& stores, int body) {
    const Domains& domains = stores.contacts.domains;
    const double x = coordinate(stores, body);
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

/// Of what touches, from the least coordinate to the most.
double collect(const Stores& stores, std::vector<DomainScratch::At>& bodies) {
    bodies.clear();
    for (int body = 0; body < static_cast<int>(stores.contacts.colors.size()); ++body) {
        if (is_touched(stores.contacts, body)) bodies.push_back({coordinate(stores, body), body});
    }
    if (bodies.empty()) return 0;
    const auto [least, most] = std::ranges::minmax_element(bodies, {}, &DomainScratch::At::x);
    return most->x - least->x;
}

// So that as many of the bodies are in each domain, and each is in the one that it is in now.
void cut(Stores& stores, std::vector<DomainScratch::At>& bodies) {
    Domains& domains = stores.contacts.domains;
    const auto count = static_cast<std::size_t>(domains.count);
    for (std::size_t i = 1; i < count; ++i) {
        const auto nth = bodies.begin() + static_cast<std::ptrdiff_t>(bodies.size() * i / count);
        std::ranges::nth_element(bodies, nth, {}, &DomainScratch::At::x);
        domains.cuts[i - 1] = nth->x;
    }
    for (const auto& [x, body] : bodies)
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
void choose_cuts(Stores& stores, std::size_t contacts, std::vector<DomainScratch::At>& bodies) {
    Domains& domains = stores.contacts.domains;
    domains.along = Along::Slots;
    collect(stores, bodies);
    cut(stores, bodies);
    if (kInterfaceShare * count_between(stores.contacts) <= contacts) return;
    domains.along = Along::Y;
    const double height = collect(stores, bodies);
    domains.along = Along::X;
    if (collect(stores, bodies) < height) {
        domains.along = Along::Y;
        collect(stores, bodies);
    }
    cut(stores, bodies);
}

void move_contacts(ContactStore& contacts, std::vector<int>& moving) {
    moving.clear();
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
    std::vector<DomainScratch::Member>& members = scratch.members;
    members.clear();
    for (const int body : stores.bodies.rows(RowSet::Awake).body) {
        const bool is_settled = is_touched(contacts, body);
        const int domain = is_settled
                               ? static_cast<int>(contacts.domains.of_body[static_cast<std::size_t>(body)])
                               : domain_now(stores, body);
        members.push_back({domain, body});
    }
    const bool in_order = std::ranges::is_sorted(members);
    if (!in_order) std::ranges::sort(members);
    scratch.rows.clear();
    // Motions have the row of the world before all others.
    scratch.first_row.assign(static_cast<std::size_t>(contacts.domains.count), 0);
    for (const auto& [domain, body] : members) {
        scratch.rows.push_back(stores.bodies.slots[body].row);
        for (auto later = static_cast<std::size_t>(domain); later < scratch.first_row.size(); ++later)
            scratch.first_row[later] = static_cast<int>(scratch.rows.size()) + 1;
    }
    if (!in_order) stores.bodies.order_awake_rows(scratch.rows);
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
        choose_cuts(stores, all, scratch.bodies);
        order_rows(stores, scratch);
    }
    move_contacts(contacts, scratch.moving);
    contacts.lanes.arrange();
}

}  // namespace cairn::physics
