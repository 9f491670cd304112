// Contacts in plain form: those that no lane solves, and beside those in lanes the ones that are to be told,
// bounce one by one, or overlap deeply.
#pragma once

#include "resolve/contact_constraint.h"
#include "world/prepare.h"
#include "world/world_state.h"

namespace cairn::physics {

/// Bodies that are faster are not ones that were put somewhere.
bool is_calm(const Motions& motions, int row);

/// Fills StepScratch::contacts and the lists of what becomes of them.
class PlainContacts {
  public:
    PlainContacts(Stores& stores, StepScratch& scratch, const StepTime& time, const ContactRules& rules)
        : stores_(stores), scratch_(scratch), time_(time), rules_(rules) {}

    /// Of a step: none yet.
    void begin();
    /// Keeps in mind what overlaps deeply.
    void end();

    /// Of a contact in a lane, with the impulses of that. Several threads may ask at once.
    [[nodiscard]] ContactConstraint form_of(ContactInput input, const ContactBlock& block, int lane) const;
    /// Adds one beside its lane, or, where that is `loose`, in its place: the lane is left out then.
    void add_beside(const ContactConstraint& constraint, int lane, bool is_loose);
    /// Adds one that has no lane, with the impulses that it remembers by feature.
    void add(ContactInput input, const ContactMemory& memory);
    /// When direct groups have been chosen again: those that are part of one now are solved with it alone.
    void leave_to_groups();

  private:
    void mark_what_was_put_in();
    void solve_last();
    void note_deep();
    [[nodiscard]] bool is_pushed_apart(const ContactConstraint& c) const;
    [[nodiscard]] bool was_put_in(const ContactRecord& record) const;
    [[nodiscard]] bool is_direct(const ContactRecord& record) const;
    [[nodiscard]] bool sweeps(const ContactConstraint& c) const;
    [[nodiscard]] bool whirls(int body) const;
    [[nodiscard]] bool has_flag(const ContactRecord& record, std::uint32_t flag) const;

    Stores& stores_;
    StepScratch& scratch_;
    const StepTime& time_;
    const ContactRules& rules_;
};

}  // namespace cairn::physics
