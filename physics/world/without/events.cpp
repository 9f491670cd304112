// Stands for the events of contacts in a build without them: validate(ShapeDef) refuses shapes that report.
#include "world/contact_events.h"

namespace cairn::physics {

void report_parting(const Stores&, ContactRecord&, std::vector<ContactEnd>&) {}
void report_contacts(Stores&, const StepScratch&, float, Events&) {}

}  // namespace cairn::physics
