// Stages before and after the substeps: constraints are packed from the stores, impulses go back to them.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

struct StepTime {
    float dt_s = 0;
    float h_s = 0;  // of one substep
    int substeps = 0;
    float step_ratio = 1;  // of this step's substep to the last one's
    // The same, at most 1: impulses of which no estimate is known do not grow with the step.
    float impulse_ratio = 1;
    float most_swept_hz = 0;  // of springs that are not stiff
};

/// As many substeps as were asked for, or more where gravity would take a body from rest further than half
/// the slop in one: n = dt sqrt(2 g / slop), rounded up to a power of two, at most 32. What is put down would
/// be inside of what it stands on before a contact can tell. Of the least unit of contacts where that is not
/// 1 (world/tiny_contacts.h), half the slop counts: with the whole a stack of 6 mm falls.
int substeps_under(float gravity_m_s2, float dt_s, int least, float unit = 1);

StepTime make_step_time(float dt_s, int substeps, const LastSteps& last);

/// Once the step is over.
void note_step(const StepTime& time, LastSteps& last);

/// Stage: the motion of each awake body, and what acts on it in this step.
void prepare_motions(BodyStore& bodies, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch, TaskPool& tasks);
/// The same for bodies that woke since.
void extend_motions(BodyStore& bodies, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch, TaskPool& tasks);
/// Stage: who moves each body, now that all contacts are known.
void choose_movers(const Stores& stores, StepScratch& scratch);

/// Stage: what the lanes hold, for contacts that impact or are told about.
void collect_outcomes(const ContactStore& contacts, StepScratch& scratch, TaskPool& tasks);

/// Stage: impulses of contacts in plain form, to start the next step from.
void store_contact_impulses(ContactStore& contacts, const StepTime& time, const StepScratch& scratch);

}  // namespace cairn::physics
